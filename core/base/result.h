// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/core.h>

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace nadir {

enum class ErrorCode { kNotFound, kMalformed, kUnsupported, kInvalidOptions, kCancelled, kIo };

/// Why something that came from outside (a file, an option, a flight) could not be used.
struct Error {
  ErrorCode code = ErrorCode::kIo;
  std::string message;  ///< One sentence without full stop that starts with the thing that failed.

  /// The same error seen from further out: "context: message".
  [[nodiscard]] Error within(const std::string& context) const {
    return {code, context + ": " + message};
  }
};

/// A value, or the reason why there is none. Programmer errors use NADIR_REQUIRE instead.
template <typename T>
using Result = tl::expected<T, Error>;

/// Makes the failing side of a Result: `return fail(ErrorCode::kIo, "{}: cannot be opened", path)`.
template <typename... Arguments>
[[nodiscard]] tl::unexpected<Error> fail(ErrorCode code,
                                         fmt::format_string<Arguments...> format,
                                         Arguments&&... arguments) {
  return tl::unexpected<Error>(
      Error{code, fmt::format(format, std::forward<Arguments>(arguments)...)});
}

/// Passes an error on: `if (!map) return forward_error(map);`
template <typename T>
[[nodiscard]] tl::unexpected<Error> forward_error(const Result<T>& failed) {
  return tl::unexpected<Error>(failed.error());
}

/// Passes an error on with context in front: "context: message".
template <typename T>
[[nodiscard]] tl::unexpected<Error> forward_error(const Result<T>& failed,
                                                  const std::string& context) {
  return tl::unexpected<Error>(failed.error().within(context));
}

}  // namespace nadir
