// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "core/base/field.h"

namespace nadir {

/// What choosing does to what was chosen before.
enum class SelectHow { kInstead, kAdd, kRemove, kToggle };
template <>
struct EnumNames<SelectHow> {
  static constexpr std::array<std::string_view, 4> kNames = {"instead", "add", "remove", "toggle"};
};

}  // namespace nadir
