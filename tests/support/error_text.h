// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/result.h"

namespace nadir {

/// Message of a failed result, for matchers; says so where there is none.
template <typename T>
[[nodiscard]] std::string error_text(const Result<T>& result) {
  return result ? "(no error)" : result.error().message;
}

/// A failed result's kind of error; only asked after it has failed.
template <typename T>
[[nodiscard]] ErrorCode error_code(const Result<T>& result) {
  return result.error().code;
}

}  // namespace nadir
