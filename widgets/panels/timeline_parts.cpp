// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/timeline_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nadir::detail {
namespace {

constexpr double kAxisZoomPerNotch = 1.25;
constexpr double kLeastSpanS = 0.5;  ///< Shorter parts of the axis than that show nothing more.

/// The page's x of a pixel of the window, in the middle of a pixel so that thin lines are sharp.
double sharp_x(const kit::AreaInput& area, double window_x) {
  return std::floor(window_x - area.rect.left) + 0.5;
}

}  // namespace

Rgba TimelineFrame::colour_of(int run_colour_index) const {
  return run_colour(ui.theme(), static_cast<std::size_t>(std::max(0, run_colour_index)));
}

void draw_vertical(
    Canvas& canvas, const kit::AreaInput& area, double window_x, Rgba colour, double width_px) {
  const double x = sharp_x(area, window_x);
  const std::array<Eigen::Vector2d, 2> line = {Eigen::Vector2d{x, 0.0}, {x, area.rect.height}};
  canvas.stroke(line, {colour, width_px, {}});
}

void fill_between(Canvas& canvas,
                  const kit::AreaInput& area,
                  const TimeAxis& axis,
                  double from_px,
                  double to_px,
                  Rgba colour) {
  const double left = std::max(from_px, axis.left_px) - area.rect.left;
  const double right = std::min(to_px, axis.right_px()) - area.rect.left;
  if (!(left < right)) return;
  const double top = area.rect.height;
  const std::array<Eigen::Vector2d, 4> outline = {
      Eigen::Vector2d{left, 0.0}, {right, 0.0}, {right, top}, {left, top}};
  canvas.fill(outline, colour);
}

void draw_ground(const TimelineFrame& frame, Canvas& canvas, const kit::AreaInput& area) {
  const TimeAxis& axis = frame.axis;
  const Theme& theme = frame.ui.theme();
  const double first_px = axis.x_px(axis.first_s), last_px = axis.x_px(axis.last_s);
  fill_between(canvas, area, axis, first_px, last_px, theme.window);
  // Where only other runs are, the ground is paler: the cursor does not go there.
  const Rgba beyond = with_opacity(theme.window, 0.4);
  fill_between(canvas, area, axis, axis.left_px, first_px, beyond);
  fill_between(canvas, area, axis, last_px, axis.right_px(), beyond);
  if (frame.model.loop_from_s && frame.model.loop_to_s) {
    fill_between(canvas, area, axis, axis.x_px(*frame.model.loop_from_s),
                 axis.x_px(*frame.model.loop_to_s), with_opacity(theme.accent, 0.14));
  }
}

void draw_ends(const TimelineFrame& frame, Canvas& canvas, const kit::AreaInput& area) {
  const TimeAxis& axis = frame.axis;
  const double dash = frame.ui.px(3.0);
  for (const TimelineRun& run : frame.model.runs) {
    if (!run.is_incomplete) continue;
    const double end_s = run.offset_s + run.document->duration_s();
    const double end_px = axis.x_px(end_s);
    if (run.is_active) {
      const double flight_px = axis.x_px(run.offset_s + frame.model.flight_end_s(run));
      const double first = std::max(end_px, axis.left_px) - area.rect.left;
      const double last = std::min(flight_px, axis.right_px()) - area.rect.left;
      const double step = frame.ui.px(8.0), height = area.rect.height;
      const Rgba colour = with_opacity(frame.ui.theme().warning, 0.3);
      if (first < last) {
        canvas.push_clip({first, 0.0, last - first, height});
        for (double x = first - height; x < last; x += step) {
          const std::array<Eigen::Vector2d, 2> line = {Eigen::Vector2d{x, 0.0},
                                                       {x + height, height}};
          canvas.stroke(line, {colour, 1.0, {}});
        }
        canvas.pop_clip();
      }
    }
    if (end_s < axis.from_s || end_s > axis.to_s) continue;
    const double x = sharp_x(area, end_px);
    const std::array<Eigen::Vector2d, 2> end = {Eigen::Vector2d{x, 0.0}, {x, area.rect.height}};
    canvas.stroke(end, {frame.colour_of(run.colour), frame.ui.px(2.0), {dash, dash}});
  }
}

void draw_moments(const TimelineFrame& frame, Canvas& canvas, const kit::AreaInput& area) {
  const TimeAxis& axis = frame.axis;
  const Theme& theme = frame.ui.theme();
  const auto line_at = [&](double moment_s, Rgba colour, double width_px) {
    if (moment_s < axis.from_s || moment_s > axis.to_s) return;
    draw_vertical(canvas, area, axis.x_px(moment_s), colour, width_px);
  };
  for (const Bookmark& bookmark : frame.model.bookmarks) {
    line_at(bookmark.time_s, with_opacity(theme.accent, 0.35), 1.0);
  }
  if (frame.state.hovered_s && !frame.state.is_scrubbing) {
    line_at(*frame.state.hovered_s, with_opacity(theme.muted, 0.6), 1.0);
  }
  line_at(frame.model.time_s, theme.text, std::max(1.0, std::floor(frame.ui.px(1.0))));
}

std::optional<double> plot_mouse_px(const TimelineFrame& frame, const kit::AreaInput& area) {
  const double x = area.rect.left + area.mouse.x();
  const bool is_over = area.is_hovered && x >= frame.axis.left_px && x <= frame.axis.right_px();
  return is_over ? std::optional(x) : std::nullopt;
}

bool scrub(TimelineFrame& frame, const kit::AreaInput& area) {
  TimelineState& state = frame.state;
  const double mouse_px = area.rect.left + area.mouse.x();
  const auto seek = [&] { frame.actions.push_back(actions::Seek{frame.axis.seek_s(mouse_px)}); };
  if (area.pressed == kit::MouseButton::kLeft && plot_mouse_px(frame, area)) {
    state.is_scrubbing = true;
    seek();
    return true;
  }
  if (area.drag && area.drag->button == kit::MouseButton::kLeft && state.is_scrubbing) {
    if (area.drag->delta.x() != 0.0) seek();
    if (area.drag->was_released) state.is_scrubbing = false;
    return true;
  }
  if (area.clicked == kit::MouseButton::kLeft) state.is_scrubbing = false;
  return false;
}

void zoom(TimelineFrame& frame, const kit::AreaInput& area, bool is_wheel_enough) {
  const TimeAxis& axis = frame.axis;
  const auto mouse_px = plot_mouse_px(frame, area);
  if (!mouse_px || (!is_wheel_enough && !area.modifiers.ctrl)) return;
  const TimelineModel::Extent extent = frame.model.extent();
  const double all_s = extent.to_s - extent.from_s;
  double span_s = axis.to_s - axis.from_s;
  double from_s = axis.from_s;
  if (area.wheel.y() != 0.0) {
    const double wanted_s = span_s * std::pow(kAxisZoomPerNotch, -area.wheel.y());
    const double share = (*mouse_px - axis.left_px) / axis.width_px;
    span_s = std::clamp(wanted_s, std::min(kLeastSpanS, all_s), all_s);
    from_s = axis.time_s(*mouse_px) - share * span_s;  // the moment under the mouse stays there
  } else if (area.wheel.x() != 0.0) {
    constexpr double kPanShare = 0.1;
    from_s += kPanShare * span_s * area.wheel.x();
  } else {
    return;
  }
  if (span_s >= all_s) {
    frame.state.zoomed_to.reset();
    return;
  }
  from_s = std::clamp(from_s, extent.from_s, extent.to_s - span_s);
  frame.state.zoomed_to = TimeSpan{from_s, from_s + span_s};
}

}  // namespace nadir::detail
