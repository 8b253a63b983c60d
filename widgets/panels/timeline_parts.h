// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/panels/time_axis.h"
#include "widgets/panels/timeline.h"

/// The timeline's parts share this; nobody else includes it.
namespace nadir::detail {

/// One frame of a timeline.
struct TimelineFrame {
  kit::Ui& ui;
  const TimelineModel& model;
  TimelineState& state;
  TimeAxis axis;     ///< In the window's pixels.
  Actions& actions;  ///< What the user has asked for so far.

  /// Colour of a run's lines.
  [[nodiscard]] Rgba colour_of(int run_colour_index) const;
};

/// A vertical line over the whole height of an area at a pixel of the window.
void draw_vertical(
    Canvas& canvas, const kit::AreaInput& area, double window_x, Rgba colour, double width_px);
/// An area filled between two pixels of the window, cut at the axis's ends.
void fill_between(Canvas& canvas,
                  const kit::AreaInput& area,
                  const TimeAxis& axis,
                  double from_px,
                  double to_px,
                  Rgba colour);
/// The loop's range, what lies beyond the active run, and below everything the plot's ground.
void draw_ground(const TimelineFrame& frame, Canvas& canvas, const kit::AreaInput& area);
/// Where runs that were stopped before their end have stopped: a line in the run's colour, and after the active run's hatching
/// up to the end of the flight.
void draw_ends(const TimelineFrame& frame, Canvas& canvas, const kit::AreaInput& area);
/// Lines at bookmarks, at the moment under the mouse, and the cursor.
void draw_moments(const TimelineFrame& frame, Canvas& canvas, const kit::AreaInput& area);
/// Seeks while the left button is held; true where the mouse did anything with time in this frame.
bool scrub(TimelineFrame& frame, const kit::AreaInput& area);
/// Zooms by the wheel around the mouse.
void zoom(TimelineFrame& frame, const kit::AreaInput& area, bool is_wheel_enough);
/// X of the mouse in the window, where it lies over the plot; nothing beside it.
[[nodiscard]] std::optional<double> plot_mouse_px(const TimelineFrame& frame,
                                                  const kit::AreaInput& area);

/// Room above and below the lines of a strip, of the design.
inline constexpr double kStripPadding = 3.0;
/// Name and values at the left of a strip, as much as fits.
void draw_gutter(const TimelineFrame& frame,
                 Canvas& canvas,
                 const kit::AreaInput& area,
                 Strip strip,
                 const StripPlot& plot);
/// All that a strip shows, in its area: name and values at the left, lines or streams, the cursor.
void draw_strip_picture(const TimelineFrame& frame,
                        Canvas& canvas,
                        const kit::AreaInput& area,
                        Strip strip,
                        const StripPlot& plot);

void draw_transport(TimelineFrame& frame);
void draw_ruler(TimelineFrame& frame, const kit::AreaInput& area);
void draw_strip(TimelineFrame& frame, const StripLook& look);
/// Items for every strip, checked where it shows.
void draw_strip_items(TimelineFrame& frame);

}  // namespace nadir::detail
