// SPDX-License-Identifier: Apache-2.0
#include "core/session/view_text.h"

#include <algorithm>
#include <limits>

#include "core/session/settings_values.h"

namespace nadir {
namespace {

using detail::each_table;
using detail::one_table;
using detail::SettingsValues;
using detail::toml_line;

std::string map_lines(const MapLook& map) {
  std::string text = "\n[map_view]\n" + toml_line("centre", map.centre_in_enu_m) +
                     toml_line("width_m", map.width_m) + toml_line("up", enum_name(map.up)) +
                     toml_line("up_rad", map.up_rad) + toml_line("following", map.is_following) +
                     toml_line("topview_at", enum_name(map.topview_at)) +
                     toml_line("tool", enum_name(map.tool)) + toml_line("split", map.is_split);
  std::string points;
  for (const Eigen::Vector2d& point : map.measured_in_enu_m) {
    points += fmt::format("{}{}, {}", points.empty() ? "" : ", ", point.x(), point.y());
  }
  text += "measured = [" + points + "]\n";
  for (const Layer layer : map.order) {
    const LayerLook& look = map.layer(layer);
    text += "\n[[layer]]\n" + toml_line("name", enum_name(layer)) +
            toml_line("visible", look.is_visible) + toml_line("opacity", look.opacity);
    if (look.colour) text += toml_line("colour", std::string_view(*look.colour));
  }
  return text;
}

void take_map(SettingsValues& values, MapLook& into) {
  values.take("centre", into.centre_in_enu_m);
  values.take("width_m", into.width_m);
  values.take("up", into.up);
  values.take("up_rad", into.up_rad);
  values.take("following", into.is_following);
  values.take("topview_at", into.topview_at);
  values.take("tool", into.tool);
  values.take("split", into.is_split);
  if (!values.outcome() || !values.settings().has("measured")) return;
  const auto numbers = values.settings().numbers("measured");
  if (!numbers || numbers->size() % 2 != 0) {
    values.say(fail(ErrorCode::kMalformed, "{}: measured is not pairs of numbers",
                    values.settings().name()));
    return;
  }
  for (std::size_t i = 0; i + 1 < numbers->size(); i += 2) {
    into.measured_in_enu_m.emplace_back((*numbers)[i], (*numbers)[i + 1]);
  }
}

void take_draft(SettingsValues& values, RunDraft& into) {
  values.take("preset", into.preset);
  const Settings& draft = values.settings();
  if (!values.outcome() || !draft.has("changed")) return;
  const auto changed = draft.table("changed");
  if (!changed) return values.say(forward_error(changed));
  for (const std::string& name : changed->keys()) {
    const auto value = changed->scalar_as_text(name);
    if (!value) return values.say(forward_error(value));
    into.changed[name] = *value;
  }
}

Result<void> take_layers(const Settings& settings, MapLook& map) {
  std::vector<Layer> order;
  auto taken = each_table(settings, "layer", [&](SettingsValues& values) {
    Layer layer = Layer::kPicture;
    if (!values.take("name", layer)) return;
    LayerLook& look = map.layer(layer);
    values.take("visible", look.is_visible);
    values.take("opacity", look.opacity);
    look.colour.reset();
    values.take("colour", look.colour);
    order.push_back(layer);
  });
  if (taken && !order.empty()) map.order = std::move(order);
  return taken;
}

std::string label_lines(const LabelView& label) {
  if (label == LabelView{}) return {};
  std::string text = "\n[label]\n" + toml_line("path", std::string_view(label.path)) +
                     toml_line("workspace", enum_name(label.workspace)) +
                     toml_line("tab", enum_name(label.tab)) +
                     toml_line("borders", label.shows_borders) +
                     toml_line("labels_opacity", label.labels_opacity) +
                     toml_line("picture_opacity", label.picture_opacity) +
                     toml_line("centre", label.elsewhere.centre_in_enu_m) +
                     toml_line("width_m", label.elsewhere.width_m) + "\n[label.tool]\n";
  for (const OptionText& option : option_texts(label.tool)) {
    text += toml_line(option.name, std::string_view(option.value));
  }
  return text;
}

void take_label(SettingsValues& values, LabelView& into) {
  values.take("path", into.path);
  values.take("workspace", into.workspace);
  values.take("tab", into.tab);
  values.take("borders", into.shows_borders);
  values.take("labels_opacity", into.labels_opacity);
  values.take("picture_opacity", into.picture_opacity);
  into.labels_opacity = std::clamp(into.labels_opacity, 0.0, 1.0);
  into.picture_opacity = std::clamp(into.picture_opacity, 0.0, 1.0);
  values.take("centre", into.elsewhere.centre_in_enu_m);
  values.take("width_m", into.elsewhere.width_m);
  if (into.path.empty()) into.workspace = Workspace::kReplay;
  const Settings& label = values.settings();
  if (!values.outcome() || !label.has("tool")) return;
  const auto tool = label.table("tool");
  if (!tool) return values.say(forward_error(tool));
  for (const std::string& name : tool->keys()) {
    const auto value = tool->scalar_as_text(name);
    if (!value) return values.say(forward_error(value));
    LabelTool changed = into.tool;  // what this version does not know stays as it begins
    if (set_option(changed, name, *value) && validate(changed)) into.tool = changed;
  }
}

}  // namespace

std::string view_text(const SavedView& saved) {
  const ViewState& view = saved.view;
  const Playback& playback = saved.playback;
  std::string text = "# A view of Nadir's window.\n" + toml_line("version", detail::kTextVersion) +
                     toml_line("map", std::string_view(view.map_path)) +
                     toml_line("flight", std::string_view(view.flight_path)) +
                     toml_line("active_run", view.active_run) +
                     toml_line("time_s", playback.time_s) + toml_line("speed", playback.speed);
  if (playback.loop_from_s && playback.loop_to_s) {
    text += toml_line("loop_from_s", *playback.loop_from_s) +
            toml_line("loop_to_s", *playback.loop_to_s);
  }
  if (view.selected_particle) text += toml_line("selected_particle", *view.selected_particle);
  for (const RunLook& run : view.runs) {
    text += "\n[[run]]\n" + toml_line("path", std::string_view(run.path)) +
            toml_line("shown", run.is_shown) + toml_line("colour", run.colour);
  }
  text += map_lines(view.map);
  text += detail::layout_lines("layout", view.layout);
  text += detail::appearance_lines(view.appearance);
  text += label_lines(saved.label);
  text += "\n[draft]\n" + toml_line("preset", std::string_view(view.draft.preset));
  if (!view.draft.changed.empty()) text += "\n[draft.changed]\n";
  for (const auto& [name, value] : view.draft.changed) {
    text += toml_line(toml_quoted(name), std::string_view(value));
  }
  return text;
}

Result<SavedView> parse_view_text(std::string_view text, const std::string& name) {
  const auto settings = Settings::parse(text, name);
  if (!settings) return forward_error(settings);
  if (const auto version = detail::check_version(*settings); !version)
    return forward_error(version);
  SavedView saved;
  ViewState& view = saved.view;
  Playback& playback = saved.playback;
  SettingsValues values(*settings);
  values.take("map", view.map_path);
  values.take("flight", view.flight_path);
  values.take("active_run", view.active_run);
  values.take("time_s", playback.time_s);
  values.take("speed", playback.speed);
  values.take("loop_from_s", playback.loop_from_s);
  values.take("loop_to_s", playback.loop_to_s);
  values.take("selected_particle", view.selected_particle);
  const auto taken =
      Result<void>(values.outcome())
          .and_then([&] {
            return each_table(*settings, "run", [&](SettingsValues& run) {
              RunLook look;
              run.take("path", look.path);
              run.take("shown", look.is_shown);
              run.take("colour", look.colour);
              view.runs.push_back(std::move(look));
            });
          })
          .and_then([&] {
            return one_table(*settings, "map_view",
                             [&](SettingsValues& map) { take_map(map, view.map); });
          })
          .and_then([&] { return take_layers(*settings, view.map); })
          .and_then([&] {
            return one_table(*settings, "layout", [&](SettingsValues& layout) {
              detail::take_layout(layout, view.layout);
            });
          })
          .and_then([&] {
            return one_table(*settings, "appearance", [&](SettingsValues& appearance) {
              detail::take_appearance(appearance, view.appearance);
            });
          })
          .and_then([&] {
            return one_table(*settings, "label",
                             [&](SettingsValues& label) { take_label(label, saved.label); });
          })
          .and_then([&] {
            return one_table(*settings, "draft",
                             [&](SettingsValues& draft) { take_draft(draft, view.draft); });
          });
  if (!taken) return forward_error(taken);
  view = repaired(std::move(view));
  playback.time_s = std::max(0.0, playback.time_s);
  playback.speed = std::clamp(playback.speed, kLeastSpeed, kMostSpeed);
  const bool is_range =
      playback.loop_from_s && playback.loop_to_s && *playback.loop_from_s < *playback.loop_to_s;
  if (!is_range) {
    playback.loop_from_s.reset();
    playback.loop_to_s.reset();
  }
  return saved;
}

std::string preferences_text(const Preferences& preferences) {
  std::string text = "# Preferences of Nadir's window.\n" +
                     toml_line("version", detail::kTextVersion) +
                     toml_line("memory_megabytes", preferences.memory_megabytes) +
                     toml_line("recents", preferences.recents) +
                     toml_line("recent_commands", preferences.recent_commands) +
                     toml_line("turned_sections", preferences.turned_sections) +
                     detail::appearance_lines(preferences.appearance);
  for (const auto& [name, layout] : preferences.layouts) {
    text += "\n[[kept_layout]]\n" + toml_line("name", std::string_view(name));
    text += detail::layout_lines("kept_layout.layout", layout);
  }
  return text;
}

Result<Preferences> parse_preferences(std::string_view text, const std::string& name) {
  const auto settings = Settings::parse(text, name);
  if (!settings) return forward_error(settings);
  if (const auto version = detail::check_version(*settings); !version)
    return forward_error(version);
  Preferences preferences;
  SettingsValues values(*settings);
  values.take("memory_megabytes", preferences.memory_megabytes);
  values.take("recents", preferences.recents);
  values.take("recent_commands", preferences.recent_commands);
  values.take("turned_sections", preferences.turned_sections);
  const auto taken =
      Result<void>(values.outcome())
          .and_then([&] {
            return one_table(*settings, "appearance", [&](SettingsValues& appearance) {
              detail::take_appearance(appearance, preferences.appearance);
            });
          })
          .and_then([&] {
            return each_table(*settings, "kept_layout", [&](SettingsValues& kept) {
              std::string layout_name;
              kept.take("name", layout_name);
              WindowLayout layout = default_layout();
              const auto read = one_table(kept.settings(), "layout", [&](SettingsValues& table) {
                detail::take_layout(table, layout);
              });
              if (!read) kept.say(forward_error(read));
              if (!layout_name.empty()) preferences.layouts[layout_name] = repaired(layout);
            });
          });
  if (!taken) return forward_error(taken);
  ViewState holder = default_view_state();
  holder.appearance = preferences.appearance;
  preferences.appearance = repaired(std::move(holder)).appearance;
  preferences.memory_megabytes =
      std::clamp(preferences.memory_megabytes, kLeastMemoryMegabytes, kMostMemoryMegabytes);
  return preferences;
}

}  // namespace nadir
