// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/timeline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/timeline_parts.h"

namespace nadir {
namespace {

// Of the design.
constexpr double kGutter = 192.0;      ///< Names and values, left of the plots.
constexpr double kRightMargin = 16.0;  ///< Where a bar to scroll by may come.
constexpr double kRulerHeight = 32.0;
constexpr double kHandle = 4.0;  ///< Between two strips: sizes the upper one.
constexpr double kLeastStrip = 20.0, kMostStrip = 400.0;

/// Follows the cursor when it leaves the part of the axis that shows.
void turn_page(const TimelineModel& model,
               const TimelineModel::Extent& extent,
               TimelineState& state) {
  if (!state.zoomed_to) return;
  TimeSpan& shown = *state.zoomed_to;
  const double span_s = shown.to_s - shown.from_s;
  const bool has_moved = model.time_s != state.last_time_s;
  const bool is_outside = model.time_s < shown.from_s || model.time_s > shown.to_s;
  constexpr double kCursorShare = 0.1;
  double from_s = shown.from_s;
  if (has_moved && is_outside && !state.is_scrubbing) from_s = model.time_s - kCursorShare * span_s;
  from_s = std::max(extent.from_s, std::min(from_s, extent.to_s - span_s));
  shown = {from_s, std::min(from_s + span_s, extent.to_s)};
  if (!(shown.to_s > shown.from_s)) state.zoomed_to.reset();
}

TimeAxis axis_of(const kit::Ui& ui,
                 const kit::Rect& room,
                 const TimelineModel& model,
                 TimelineState& state) {
  const TimelineModel::Extent extent = model.extent();
  turn_page(model, extent, state);
  TimeAxis axis;
  axis.from_s = state.zoomed_to ? state.zoomed_to->from_s : extent.from_s;
  axis.to_s = state.zoomed_to ? state.zoomed_to->to_s : extent.to_s;
  axis.first_s = 0.0;
  axis.last_s = extent.last_s;
  axis.left_px = std::floor(room.left + ui.px(kGutter));
  axis.width_px = std::max(1.0, std::floor(room.right() - ui.px(kRightMargin)) - axis.left_px);
  return axis;
}

/// Drops what was thinned for other runs, or for another width.
void refresh(const TimelineModel& model, const TimeAxis& axis, TimelineState& state) {
  std::vector<TimelineState::ShownRun> shown;
  for (const TimelineRun& run : model.runs)
    shown.push_back({run.document, run.offset_s, run.colour});
  const bool is_same_runs = shown == state.shown_runs && model.flight == state.shown_flight;
  if (is_same_runs && axis.px_per_s() == state.shown_px_per_s) return;
  for (auto& plot : state.plots) plot.reset();
  if (!is_same_runs) state.streams.reset();
  state.shown_runs = std::move(shown);
  state.shown_flight = model.flight;
  state.shown_px_per_s = axis.px_per_s();
}

void draw_strips(detail::TimelineFrame& frame) {
  kit::Ui& ui = frame.ui;
  TimelineState& state = frame.state;
  state.hovered_s.reset();
  bool is_any_visible = false;
  const auto area = ui.scroll_area("Strips area");
  for (const StripLook& look : frame.model.strips) {
    if (!look.is_visible) {
      state.places.at(static_cast<std::size_t>(look.strip)).reset();
      continue;
    }
    is_any_visible = true;
    auto& plot = state.plots.at(static_cast<std::size_t>(look.strip));
    if (!plot) plot = strip_plot(look.strip, frame.model.runs, frame.axis.px_per_s());
    if (look.strip == Strip::kStreams && !state.streams) state.streams = stream_bars(frame.model);
    detail::draw_strip(frame, look);
    const auto height = ui.splitter(std::string(enum_name(look.strip)) + " height",
                                    ui.px(look.height_pt), ui.px(kLeastStrip), ui.px(kMostStrip));
    if (height.is_changed || height.was_committed) {
      frame.actions.push_back(
          actions::SetStripHeight{look.strip, std::round(height.value / ui.scale())});
    }
  }
  if (!is_any_visible)
    ui.text("No strips are chosen: the + button above shows them", kit::TextLook::kMuted);
}

}  // namespace

Actions draw_timeline(kit::Ui& ui, const TimelineModel& model, TimelineState& state) {
  Actions asked;
  const auto scope = ui.scope("Timeline");
  if (model.active() == nullptr) {
    if (!model.reading.empty()) return draw_empty_state(ui, reading_state(model.reading));
    if (!model.coming.empty()) return draw_empty_state(ui, coming_state(model.coming));
    return draw_empty_state(ui, no_run_state("its errors over time"));
  }
  detail::TimelineFrame frame{ui, model, state, axis_of(ui, ui.room(), model, state), asked};
  refresh(model, frame.axis, state);
  detail::draw_transport(frame);
  const auto ruler = ui.area("Ruler", {0.0, ui.px(kRulerHeight)});
  detail::draw_ruler(frame, ruler);
  ui.space(ui.px(kHandle));
  draw_strips(frame);
  state.last_time_s = model.time_s;
  return asked;
}

}  // namespace nadir
