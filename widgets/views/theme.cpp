// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/theme.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <string>

#include "core/base/require.h"
#include "widgets/views/theme_table.h"

namespace nadir {
namespace {

Rgba hex_colour(const std::string& text) {
  std::uint32_t value = 0;
  NADIR_REQUIRE(text.size() == 7 && text[0] == '#');
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
  NADIR_REQUIRE(error == std::errc() && end == text.data() + 7);
  return {static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U),
          static_cast<std::uint8_t>(value)};
}

/// Colour of a role. A role that is missing is a mistake in our own table.
Rgba table_colour(std::string_view role, ThemeName name) {
  std::istringstream lines{std::string(kThemeTable)};
  for (std::string line; std::getline(lines, line);) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    std::string word;
    std::array<std::string, 2> colours;
    if (words >> word >> colours[0] >> colours[1] && word == role) {
      return hex_colour(colours.at(static_cast<std::size_t>(name)));
    }
  }
  NADIR_REQUIRE(false);
  return {};
}

Theme read_theme(ThemeName name) {
  const auto colour = [name](std::string_view role) { return table_colour(role, name); };
  Theme made;
  made.window = colour("window");
  made.page = colour("page");
  made.line = colour("line");
  made.text = colour("text");
  made.muted = colour("muted");
  made.accent = colour("accent");
  made.good = colour("good");
  made.warning = colour("warning");
  made.bad = colour("bad");
  made.truth = colour("truth");
  made.truth_on_imagery = colour("truth_on_imagery");
  made.odometry = colour("odometry");
  made.odometry_on_imagery = colour("odometry_on_imagery");
  made.estimate = colour("estimate");
  made.estimate_on_imagery = colour("estimate_on_imagery");
  made.second_run = colour("second_run");
  made.third_run = colour("third_run");
  made.fourth_run = colour("fourth_run");
  made.agreement = colour("agreement");
  made.disagreement = colour("disagreement");
  made.casing_on_imagery = colour("casing_on_imagery");
  return made;
}

using ColourRamp = std::array<Rgba, 256>;

ColourRamp ramp(int colour_map) {
  cv::Mat values(1, 256, CV_8UC1);
  for (int i = 0; i < 256; ++i) values.at<unsigned char>(0, i) = static_cast<unsigned char>(i);
  cv::Mat colours;
  cv::applyColorMap(values, colours, colour_map);
  ColourRamp made;
  for (int i = 0; i < 256; ++i) {
    const auto& colour = colours.at<cv::Vec3b>(0, i);
    made.at(static_cast<std::size_t>(i)) = {colour[2], colour[1], colour[0]};
  }
  return made;
}

}  // namespace

const Theme& theme(ThemeName name) {
  static const std::array<Theme, 2> themes = {read_theme(ThemeName::kLight),
                                              read_theme(ThemeName::kDark)};
  return themes.at(static_cast<std::size_t>(name));
}

namespace {

constexpr std::size_t kRunColours = 4;

Rgba run_colour_after(const Theme& theme, std::size_t run, Rgba first) {
  const std::array<Rgba, kRunColours> colours = {first, theme.second_run, theme.third_run,
                                                 theme.fourth_run};
  return colours.at(run % kRunColours);
}

}  // namespace

Rgba run_colour(const Theme& theme, std::size_t run) {
  return run_colour_after(theme, run, theme.estimate);
}

Rgba run_colour_on_imagery(const Theme& theme, std::size_t run) {
  return run_colour_after(theme, run, theme.estimate_on_imagery);
}

bool is_run_dashed(std::size_t run) { return run / kRunColours % 2 == 1; }

Rgba with_opacity(Rgba colour, double opacity) {
  colour.alpha = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0)));
  return colour;
}

Rgba class_colour(ClassId id) {
  if (id >= kClassCount) return {0, 0, 0, 0};
  const Colour& colour = class_info(id).colour;
  return {colour.red, colour.green, colour.blue};
}

Rgba value_colour(ValueColours colours, double share) {
  static const ColourRamp viridis = ramp(cv::COLORMAP_VIRIDIS);
  static const ColourRamp cividis = ramp(cv::COLORMAP_CIVIDIS);
  if (std::isnan(share)) return {0, 0, 0, 0};
  const auto index = static_cast<std::size_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
  return (colours == ValueColours::kViridis ? viridis : cividis).at(index);
}

}  // namespace nadir
