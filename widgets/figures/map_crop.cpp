// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/map_crop.h"

#include <charconv>
#include <cmath>

namespace nadir {
namespace {

constexpr std::string_view kAll = "all";

std::optional<double> metres(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || error != std::errc() || rest != end || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::optional<Eigen::Vector2d> point(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto east = metres(text.substr(0, comma));
  const auto north = metres(text.substr(comma + 1));
  if (!east || !north) return std::nullopt;
  return Eigen::Vector2d(*east, *north);
}

}  // namespace

Result<MapCrop> MapCrop::from_text(std::string_view text) {
  MapCrop crop;
  if (text == kAll) return crop;
  const std::size_t sign = text.find('@');
  const auto width = metres(text.substr(0, sign));
  if (sign != std::string_view::npos) crop.centre_in_enu_m = point(text.substr(sign + 1));
  const bool has_point = sign == std::string_view::npos || crop.centre_in_enu_m;
  if (!width || !has_point) {
    return fail(ErrorCode::kInvalidOptions,
                "'{}' is neither all, WIDTH nor WIDTH@EAST,NORTH in metres", text);
  }
  if (*width == 0.0) {  // which would mean all
    return fail(ErrorCode::kInvalidOptions, "a width of 0 m shows nothing");
  }
  crop.width_m = *width;
  return crop;
}

std::string MapCrop::text() const {
  if (is_all()) return std::string(kAll);
  if (!centre_in_enu_m) return fmt::format("{}", width_m);
  return fmt::format("{}@{},{}", width_m, centre_in_enu_m->x(), centre_in_enu_m->y());
}

Result<void> MapCrop::check() const {
  if (!is_all() && !(width_m >= kLeastWidthM && width_m <= kMostM)) {
    return fail(ErrorCode::kInvalidOptions, "a width of {:g} m is not in [{:g}, {:g}]", width_m,
                double{kLeastWidthM}, double{kMostM});
  }
  if (centre_in_enu_m && !(centre_in_enu_m->cwiseAbs().maxCoeff() <= kMostM)) {
    return fail(ErrorCode::kInvalidOptions, "{:g},{:g} is more than {:g} m from the map's origin",
                centre_in_enu_m->x(), centre_in_enu_m->y(), double{kMostM});
  }
  return {};
}

}  // namespace nadir
