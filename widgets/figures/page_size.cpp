// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/page_size.h"

#include <charconv>
#include <optional>

namespace nadir {
namespace {

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || error != std::errc() || rest != end) return std::nullopt;
  return value;
}

/// Of a height that is written; one that is left out is the figure's own.
tl::unexpected<Error> bad_height(int height) {
  return fail(ErrorCode::kInvalidOptions, "a height of {} is not in [{}, {}]", height,
              int{PageSize::kLeastHeight}, int{PageSize::kMost});
}

}  // namespace

Result<PageSize> PageSize::from_text(std::string_view text) {
  const std::size_t cross = text.find('x');
  const auto width = whole_number(text.substr(0, cross));
  const auto height =
      cross == std::string_view::npos ? std::optional(0) : whole_number(text.substr(cross + 1));
  if (!width || !height) {
    return fail(ErrorCode::kInvalidOptions, "'{}' is neither WIDTH nor WIDTHxHEIGHT in pixels",
                text);
  }
  const PageSize size{*width, *height};
  if (cross != std::string_view::npos && size.height == 0) return bad_height(0);
  return size;
}

std::string PageSize::text() const {
  return height == 0 ? fmt::format("{}", width) : fmt::format("{}x{}", width, height);
}

Result<void> PageSize::check() const {
  if (width < kLeastWidth || width > kMost) {
    return fail(ErrorCode::kInvalidOptions, "a width of {} is not in [{}, {}]", width,
                int{kLeastWidth}, int{kMost});
  }
  if (height != 0 && (height < kLeastHeight || height > kMost)) {
    return bad_height(height);
  }
  return {};
}

}  // namespace nadir
