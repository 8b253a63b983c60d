// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/panels/run_labels.h"
#include "widgets/panels/timeline_parts.h"

namespace nadir::detail {
namespace {

std::vector<std::string> hover_words(const TimelineFrame& frame,
                                     const kit::AreaInput& area,
                                     Strip strip,
                                     double moment_s) {
  std::vector<std::string> words = {clock_text(moment_s)};
  const StripInfo& info = strip_info(strip);
  if (strip == Strip::kStreams) {
    const auto& streams = *frame.state.streams;
    const double from_top = area.rect.height - area.mouse.y() - frame.ui.px(kStripPadding);
    const double share = from_top / (area.rect.height - 2.0 * frame.ui.px(kStripPadding));
    const auto row =
        static_cast<std::ptrdiff_t>(std::floor(share * static_cast<double>(streams.size())));
    if (row >= 0 && row < static_cast<std::ptrdiff_t>(streams.size()))
      words.push_back(stream_words(streams[static_cast<std::size_t>(row)]));
    return words;
  }
  const std::string unit = info.unit.empty() ? "" : " " + std::string(info.unit);
  for (auto run = frame.model.runs.rbegin(); run != frame.model.runs.rend(); ++run) {
    const std::string name = frame.model.runs.size() > 1 ? run->name : std::string(info.name);
    const std::string value = strip_value(strip, *run, moment_s);
    const double after_s = moment_s - run->offset_s - run->document->duration_s();
    words.push_back(run->is_incomplete && after_s > 0.0 && value == "–"
                        ? fmt::format("{}  {}", name, incomplete_words(*run->document))
                        : fmt::format("{}  {}{}", name, value, unit));
  }
  return words;
}

/// Of what stands left of a strip: all that may have been cut there.
std::vector<std::string> gutter_words(const TimelineFrame& frame, Strip strip) {
  const StripInfo& info = strip_info(strip);
  std::vector<std::string> words = {
      std::string(info.name) + (info.unit.empty() ? "" : fmt::format(" [{}]", info.unit)),
      std::string(info.help)};
  if (strip == Strip::kStreams || frame.model.runs.size() < 2) return words;
  for (auto run = frame.model.runs.rbegin(); run != frame.model.runs.rend(); ++run) {
    words.push_back(fmt::format("{}  {}", run->name, strip_value(strip, *run, frame.model.time_s)));
  }
  return words;
}

std::ptrdiff_t place_of(const std::vector<StripLook>& strips, Strip which) {
  return std::find_if(strips.begin(), strips.end(),
                      [which](const StripLook& look) { return look.strip == which; }) -
         strips.begin();
}

/// How many places a strip moves to pass the next one in sight; 0 where there is none. @param way  -1 up, 1 down.
int places_past_next(const std::vector<StripLook>& strips, Strip strip, int way) {
  const std::ptrdiff_t from = place_of(strips, strip);
  const auto count = static_cast<std::ptrdiff_t>(strips.size());
  for (std::ptrdiff_t to = from + way; to >= 0 && to < count; to += way) {
    if (strips[static_cast<std::size_t>(to)].is_visible) return static_cast<int>(to - from);
  }
  return 0;
}

void draw_move_item(TimelineFrame& frame, Strip strip, const std::string& title, int way) {
  const int places = places_past_next(frame.model.strips, strip, way);
  kit::MenuItem item;
  if (places == 0) item.disabled_because = way < 0 ? "It is the first" : "It is the last";
  if (frame.ui.menu_item(title, item)) frame.actions.push_back(actions::MoveStrip{strip, places});
}

void draw_strip_menu(TimelineFrame& frame, Strip strip) {
  const auto menu = frame.ui.context_menu(std::string(enum_name(strip)) + " menu");
  if (!menu) return;
  if (frame.ui.menu_item("Hide")) frame.actions.push_back(actions::ShowStrip{strip, Switch::kOff});
  draw_move_item(frame, strip, "Move up", -1);
  draw_move_item(frame, strip, "Move down", 1);
  frame.ui.menu_line();
  draw_strip_items(frame);
}

/// Where a strip that is dragged would go.
void mark_target(const TimelineFrame& frame, const kit::AreaInput& area, Strip strip) {
  const auto& moved = frame.state.moved_strip;
  const bool is_over = area.mouse.y() >= 0.0 && area.mouse.y() < area.rect.height;
  if (!moved || *moved == strip || !is_over) return;
  const double right = frame.axis.left_px - area.rect.left;
  const std::array<Eigen::Vector2d, 4> names = {
      Eigen::Vector2d{0.0, 0.0}, {right, 0.0}, {right, area.rect.height}, {0.0, area.rect.height}};
  frame.ui.canvas().fill(names, with_opacity(frame.ui.theme().accent, 0.2));
}

/// A strip is taken by its name and let go where it belongs.
void move_strip(TimelineFrame& frame, Strip strip, const kit::AreaInput& area) {
  TimelineState& state = frame.state;
  if (!area.drag || area.drag->button != kit::MouseButton::kLeft) return;
  const double start_px = area.rect.left + area.drag->start.x();
  if (area.drag->was_started && start_px < frame.axis.left_px) state.moved_strip = strip;
  if (state.moved_strip != strip || !area.drag->was_released) return;
  state.moved_strip.reset();
  const double mouse_y = area.rect.bottom() - area.mouse.y();
  const auto& strips = frame.model.strips;
  for (const StripLook& look : strips) {
    const auto& rect = state.places.at(static_cast<std::size_t>(look.strip));
    const bool is_there = rect && mouse_y >= rect->top && mouse_y < rect->bottom();
    if (!is_there || look.strip == strip) continue;
    const auto places = static_cast<int>(place_of(strips, look.strip) - place_of(strips, strip));
    frame.actions.push_back(actions::MoveStrip{strip, places});
  }
}

}  // namespace

void draw_strip(TimelineFrame& frame, const StripLook& look) {
  kit::Ui& ui = frame.ui;
  const Strip strip = look.strip;
  const auto& stored = frame.state.plots.at(static_cast<std::size_t>(strip));
  const StripPlot& plot = *stored;
  // With Ctrl the wheel zooms the axis, else it scrolls the strips.
  const auto area = ui.area(std::string(enum_name(strip)), {0.0, ui.px(look.height_pt)},
                            ui.modifiers().ctrl ? kit::Wheel::kOwn : kit::Wheel::kScrolls);
  draw_strip_picture(frame, ui.canvas(), area, strip, plot);
  mark_target(frame, area, strip);
  draw_strip_menu(frame, strip);
  move_strip(frame, strip, area);
  if (!frame.state.moved_strip) scrub(frame, area);
  zoom(frame, area, false);
  if (const auto mouse_px = plot_mouse_px(frame, area)) {
    frame.state.hovered_s = frame.axis.time_s(*mouse_px);
    ui.mouse_tooltip(hover_words(frame, area, strip, frame.axis.time_s(*mouse_px)));
  } else if (area.is_hovered && !frame.state.moved_strip) {
    ui.mouse_tooltip(gutter_words(frame, strip));
  }
  frame.state.places.at(static_cast<std::size_t>(strip)) = area.rect;
}

}  // namespace nadir::detail
