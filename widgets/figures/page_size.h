// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace nadir {

/// How large a page is, pixels: an option whose text is "1600" or "1600x1000".
struct PageSize {
  int width = 1600;
  int height = 0;  ///< 0: the figure's own shape.

  static constexpr int kLeastWidth = 200, kLeastHeight = 100, kMost = 16'000;
  static constexpr std::string_view kForm = "WIDTH[xHEIGHT]";

  /// @errors kInvalidOptions: "'1600*1000' is neither WIDTH nor WIDTHxHEIGHT in pixels".
  [[nodiscard]] static Result<PageSize> from_text(std::string_view text);
  [[nodiscard]] std::string text() const;
  /// @errors kInvalidOptions: "a width of 0 is not in [200, 16000]".
  [[nodiscard]] Result<void> check() const;
  friend bool operator==(const PageSize&, const PageSize&) = default;
};

}  // namespace nadir
