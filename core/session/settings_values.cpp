// SPDX-License-Identifier: Apache-2.0
#include "core/session/settings_values.h"

#include <algorithm>
#include <limits>

namespace nadir::detail {

void SettingsValues::take(std::string_view key, int& into) {
  std::int64_t value = into;
  take_by(key, value, &Settings::integer);
  if (!outcome_) return;
  if (!std::in_range<int>(value)) {
    say(fail(ErrorCode::kMalformed, "{}: {} is {}, which is out of range", settings_.name(), key,
             value));
    return;
  }
  into = static_cast<int>(value);
}

void SettingsValues::take(std::string_view key, std::optional<int>& into) {
  if (!outcome_ || !settings_.has(key)) return;
  int value = 0;
  take(key, value);
  if (outcome_) into = value;
}

void SettingsValues::take(std::string_view key, std::optional<double>& into) {
  if (!outcome_ || !settings_.has(key)) return;
  double value = 0.0;
  take(key, value);
  if (outcome_) into = value;
}

void SettingsValues::take(std::string_view key, std::optional<std::string>& into) {
  if (!outcome_ || !settings_.has(key)) return;
  std::string value;
  take(key, value);
  if (outcome_) into = std::move(value);
}

void SettingsValues::take(std::string_view key, Eigen::Vector2d& into) {
  std::vector<double> values;
  take_by(key, values, &Settings::numbers);
  if (!outcome_ || !settings_.has(key)) return;
  if (values.size() != 2) {
    say(fail(ErrorCode::kMalformed, "{}: {} is not two numbers", settings_.name(), key));
    return;
  }
  into = {values[0], values[1]};
}

std::string toml_line(std::string_view key, double value) {
  return fmt::format("{} = {}\n", key, value);
}
std::string toml_line(std::string_view key, bool value) {
  return fmt::format("{} = {}\n", key, value);
}
std::string toml_line(std::string_view key, int value) {
  return fmt::format("{} = {}\n", key, value);
}
std::string toml_line(std::string_view key, std::string_view value) {
  return fmt::format("{} = {}\n", key, toml_quoted(value));
}
std::string toml_line(std::string_view key, const char* value) {
  return toml_line(key, std::string_view(value));
}
std::string toml_line(std::string_view key, const std::vector<std::string>& values) {
  std::string list;
  for (const std::string& value : values) list += (list.empty() ? "" : ", ") + toml_quoted(value);
  return fmt::format("{} = [{}]\n", key, list);
}
std::string toml_line(std::string_view key, const Eigen::Vector2d& value) {
  return fmt::format("{} = [{}, {}]\n", key, value.x(), value.y());
}

std::string layout_lines(const std::string& table, const WindowLayout& layout) {
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < kPanelCount; ++i) {
    if (layout.is_shown.at(i)) shown.emplace_back(EnumNames<Panel>::kNames.at(i));
  }
  std::string text = "\n[" + table + "]\n" + toml_line("left_pt", layout.left_pt) +
                     toml_line("right_pt", layout.right_pt) +
                     toml_line("timeline_pt", layout.timeline_pt) +
                     toml_line("map_only", layout.is_map_only) + toml_line("panels", shown) +
                     toml_line("left_tab", enum_name(layout.left_tab)) +
                     toml_line("right_tab", enum_name(layout.right_tab));
  for (const StripLook& strip : layout.strips) {
    text += "\n[[" + table + ".strip]]\n" + toml_line("name", enum_name(strip.strip)) +
            toml_line("visible", strip.is_visible) + toml_line("height_pt", strip.height_pt);
  }
  return text;
}

void take_layout(SettingsValues& values, WindowLayout& into) {
  values.take("left_pt", into.left_pt);
  values.take("right_pt", into.right_pt);
  values.take("timeline_pt", into.timeline_pt);
  values.take("map_only", into.is_map_only);
  values.take("left_tab", into.left_tab);
  values.take("right_tab", into.right_tab);
  if (values.settings().has("panels")) {
    std::vector<Panel> shown;
    values.take("panels", shown);
    into.is_shown.fill(false);
    for (const Panel panel : shown) into.is_shown.at(static_cast<std::size_t>(panel)) = true;
  }
  std::vector<StripLook> strips;
  const auto taken = each_table(values.settings(), "strip", [&strips](SettingsValues& strip) {
    StripLook look;
    const bool is_known = strip.take("name", look.strip);
    strip.take("visible", look.is_visible);
    strip.take("height_pt", look.height_pt);
    if (is_known) strips.push_back(look);
  });
  if (!taken) values.say(forward_error(taken));
  if (!strips.empty()) into.strips = std::move(strips);
}

std::string appearance_lines(const Appearance& appearance) {
  return "\n[appearance]\n" + toml_line("theme", enum_name(appearance.theme)) +
         toml_line("scale", appearance.scale) +
         toml_line("reduced_motion", appearance.is_motion_reduced);
}

void take_appearance(SettingsValues& values, Appearance& into) {
  values.take("theme", into.theme);
  values.take("scale", into.scale);
  values.take("reduced_motion", into.is_motion_reduced);
}

Result<void> check_version(const Settings& settings) {
  const auto version = settings.integer("version");
  if (!version) return forward_error(version);
  if (*version > kTextVersion) {
    return fail(ErrorCode::kUnsupported, "{}: was written by a newer version of Nadir",
                settings.name());
  }
  return {};
}

}  // namespace nadir::detail
