// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "widgets/panels/moment_kinds.h"
#include "widgets/panels/run_labels.h"
#include "widgets/panels/timeline_parts.h"

namespace nadir::detail {
namespace {

constexpr double kMarkReach = 6.0;  ///< So near to a mark the mouse means it; of the design.
constexpr double kMarkLane =
    16.0;  ///< Height of the lane of marks and flags; above it are the times.

void draw_ticks(const TimelineFrame& frame, Canvas& canvas, const kit::AreaInput& area) {
  kit::Ui& ui = frame.ui;
  const Theme& theme = ui.theme();
  const double height = area.rect.height;
  TextStyle style;
  style.face = FontFace::kNumbers;
  style.size_px = ui.px(11.0);
  style.colour = theme.muted;
  for (const TimeTick& tick : time_ticks(frame.axis, ui.px(84.0))) {
    const double window_x = frame.axis.x_px(tick.time_s);
    const double x = std::floor(window_x - area.rect.left) + 0.5;
    const double length = ui.px(tick.label.empty() ? 3.0 : 14.0);
    const std::array<Eigen::Vector2d, 2> mark = {Eigen::Vector2d{x, height}, {x, height - length}};
    canvas.stroke(mark, {theme.line, 1.0, {}});
    const bool has_room = window_x + ui.px(44.0) < area.rect.right();
    if (!tick.label.empty() && has_room) {
      canvas.text({std::floor(x + ui.px(4.0)), std::floor(height - ui.px(12.0))}, tick.label,
                  style);
    }
  }
}

/// Diamonds and discs on the lane of marks; what is most severe lies on top.
void draw_worst(const TimelineFrame& frame, Canvas& canvas, const kit::AreaInput& area) {
  const std::vector<std::size_t> order = by_severity(frame.model.moments);
  for (auto index = order.rbegin(); index != order.rend(); ++index) {
    const WorstMoment& moment = frame.model.moments[*index];
    if (moment.time_s < frame.axis.from_s || moment.time_s > frame.axis.to_s) continue;
    const double x = frame.axis.x_px(moment.time_s) - area.rect.left;
    draw_moment_mark(canvas, {x, frame.ui.px(6.0)}, frame.ui.px(4.0), moment_mark(moment),
                     frame.ui.theme());
  }
}

/// Left of the ruler: what the marks mean, in as few words as fit; the tooltip has all.
void draw_key(const TimelineFrame& frame, Canvas& canvas, const kit::AreaInput& area) {
  kit::Ui& ui = frame.ui;
  const Theme& theme = ui.theme();
  TextStyle style;
  style.size_px = ui.px(11.0);
  style.colour = theme.muted;
  const double right = frame.axis.left_px - area.rect.left - ui.px(8.0);
  double x = ui.px(8.0);
  const double y = ui.px(8.0);
  const auto has_mark = [&frame](MomentMark mark) {
    const auto& moments = frame.model.moments;
    return std::any_of(moments.begin(), moments.end(),
                       [mark](const WorstMoment& moment) { return moment_mark(moment) == mark; });
  };
  struct Entry {
    MomentMark mark;
    const char* words;
  };
  constexpr std::array<Entry, 3> kEntries = {{{MomentMark::kFilledDiamond, "wrong"},
                                              {MomentMark::kHollowDiamond, "doubtful"},
                                              {MomentMark::kDisc, "found"}}};
  for (const Entry& entry : kEntries) {
    if (!has_mark(entry.mark)) continue;
    const double width = ui.px(8.0) + measure_text(entry.words, style).width;
    if (x + width > right) return;
    draw_moment_mark(canvas, {x, y + ui.px(4.0)}, ui.px(4.0), entry.mark, theme);
    canvas.text({std::floor(x + ui.px(8.0)), y}, entry.words, style);
    x += width + ui.px(14.0);
  }
}

/// A flag that hangs from its moment; of a span also the span.
void draw_bookmarks(const TimelineFrame& frame, Canvas& canvas, const kit::AreaInput& area) {
  const Theme& theme = frame.ui.theme();
  for (const Bookmark& bookmark : frame.model.bookmarks) {
    if (bookmark.until_s) {
      const double y = frame.ui.px(1.0);
      const double from =
          std::max(frame.axis.x_px(bookmark.time_s), frame.axis.left_px) - area.rect.left;
      const double to =
          std::min(frame.axis.x_px(*bookmark.until_s), frame.axis.right_px()) - area.rect.left;
      const std::array<Eigen::Vector2d, 2> span = {Eigen::Vector2d{from, y}, {to, y}};
      if (from < to) canvas.stroke(span, {theme.accent, frame.ui.px(2.0), {}});
    }
    if (bookmark.time_s < frame.axis.from_s || bookmark.time_s > frame.axis.to_s) continue;
    const double x = std::floor(frame.axis.x_px(bookmark.time_s) - area.rect.left);
    const double top = frame.ui.px(16.0), width = frame.ui.px(8.0), height = frame.ui.px(8.0);
    const std::array<Eigen::Vector2d, 5> flag = {Eigen::Vector2d{x, top},
                                                 {x + width, top},
                                                 {x + width * 0.6, top - height / 2.0},
                                                 {x + width, top - height},
                                                 {x, top - height}};
    canvas.fill(flag, theme.accent);
    draw_vertical(canvas, area, frame.axis.x_px(bookmark.time_s), theme.accent, 1.0);
  }
}

/// What lies under the mouse: moment and words.
struct RulerMark {
  double time_s = 0.0;
  std::vector<std::string> words;
};
std::optional<RulerMark> mark_at(const TimelineFrame& frame, double mouse_px) {
  std::optional<RulerMark> nearest;
  double least_px = frame.ui.px(kMarkReach);
  const auto offer = [&](double time_s, std::vector<std::string> words) {
    const double away_px = std::abs(frame.axis.x_px(time_s) - mouse_px);
    if (away_px > least_px) return;
    least_px = away_px;
    nearest = RulerMark{time_s, std::move(words)};
  };
  for (const WorstMoment& moment : frame.model.moments) {
    std::vector<std::string> words = {clock_text(moment.time_s), moment_words(moment)};
    if (std::string severity = severity_words(moment); !severity.empty()) {
      words.push_back(std::move(severity));
    }
    offer(moment.time_s, std::move(words));
  }
  for (const Bookmark& bookmark : frame.model.bookmarks) {
    const std::string time = clock_text(bookmark.time_s) +
                             (bookmark.until_s ? " – " + clock_text(*bookmark.until_s) : "");
    offer(bookmark.time_s,
          {time, bookmark.note.empty() ? "bookmark without a note" : bookmark.note});
  }
  for (const TimelineRun& run : frame.model.runs) {
    if (!run.is_incomplete) continue;
    const double end_s = run.offset_s + run.document->duration_s();
    offer(end_s, {clock_text(end_s), run.name + " is incomplete",
                  incomplete_words(*run.document, frame.model.flight_end_s(run))});
  }
  return nearest;
}

/// A drag of the right button, or with Shift, marks what is played again and again.
bool mark_loop(TimelineFrame& frame, const kit::AreaInput& area) {
  TimelineState& state = frame.state;
  const double mouse_px = area.rect.left + area.mouse.x();
  const bool is_shifted = area.pressed == kit::MouseButton::kLeft && area.modifiers.shift;
  if ((area.pressed == kit::MouseButton::kRight || is_shifted) && plot_mouse_px(frame, area)) {
    state.loop_start_s = frame.axis.seek_s(mouse_px);
    return true;
  }
  if (!state.loop_start_s) return false;
  if (area.drag) {
    const double end_s = frame.axis.seek_s(mouse_px);
    const auto [from_s, to_s] = std::minmax(*state.loop_start_s, end_s);
    if (area.drag->delta.x() != 0.0 && from_s < to_s)
      frame.actions.push_back(actions::SetLoop{from_s, to_s});
    if (area.drag->was_released) state.loop_start_s.reset();
    return true;
  }
  if (area.clicked) state.loop_start_s.reset();
  return true;
}

void draw_ruler_menu(TimelineFrame& frame) {
  const auto menu = frame.ui.context_menu("Ruler menu");
  if (!menu) return;
  const TimelineModel& model = frame.model;
  const double here_s = frame.state.menu_s.value_or(model.time_s);
  if (frame.ui.menu_item("Play from here again and again")) {
    const double to_s =
        model.loop_to_s && *model.loop_to_s > here_s ? *model.loop_to_s : frame.axis.last_s;
    if (here_s < to_s) frame.actions.push_back(actions::SetLoop{here_s, to_s});
  }
  if (frame.ui.menu_item("Play up to here again and again")) {
    const double from_s =
        model.loop_from_s && *model.loop_from_s < here_s ? *model.loop_from_s : frame.axis.first_s;
    if (from_s < here_s) frame.actions.push_back(actions::SetLoop{from_s, here_s});
  }
  kit::MenuItem all;
  if (!model.loop_from_s) all.disabled_because = "All is played already";
  if (frame.ui.menu_item("Play all", all)) frame.actions.push_back(actions::SetLoop{});
  frame.ui.menu_line();
  kit::MenuItem whole;
  if (!frame.state.zoomed_to) whole.disabled_because = "The whole axis shows already";
  if (frame.ui.menu_item("Show the whole axis", whole)) frame.state.zoomed_to.reset();
}

}  // namespace

void draw_ruler(TimelineFrame& frame, const kit::AreaInput& area) {
  Canvas& canvas = frame.ui.canvas();
  draw_ground(frame, canvas, area);
  draw_ticks(frame, canvas, area);
  draw_ends(frame, canvas, area);
  draw_key(frame, canvas, area);
  draw_worst(frame, canvas, area);
  draw_bookmarks(frame, canvas, area);
  draw_moments(frame, canvas, area);
  // The cursor's handle.
  if (frame.model.time_s >= frame.axis.from_s && frame.model.time_s <= frame.axis.to_s) {
    const double x = std::floor(frame.axis.x_px(frame.model.time_s) - area.rect.left) + 0.5;
    const double top = area.rect.height, half = frame.ui.px(5.0);
    const std::array<Eigen::Vector2d, 3> handle = {
        Eigen::Vector2d{x - half, top}, {x + half, top}, {x, top - 1.4 * half}};
    canvas.fill(handle, frame.ui.theme().text);
  }

  if (area.clicked == kit::MouseButton::kRight) {
    frame.state.menu_s = frame.axis.seek_s(area.rect.left + area.mouse.x());
  }
  draw_ruler_menu(frame);
  const auto mouse_px = plot_mouse_px(frame, area);
  const bool is_in_lane = area.mouse.y() <= frame.ui.px(kMarkLane);
  const auto mark = mouse_px && is_in_lane ? mark_at(frame, *mouse_px) : std::nullopt;
  if (mark && area.pressed == kit::MouseButton::kLeft && !area.modifiers.shift) {
    frame.actions.push_back(actions::GoToMoment{mark->time_s});
    frame.state.is_scrubbing = true;  // a drag goes on from there
    return;
  }
  if (!mark_loop(frame, area)) scrub(frame, area);
  if (area.double_clicked == kit::MouseButton::kLeft) frame.state.zoomed_to.reset();
  zoom(frame, area, true);
  if (mark && !frame.state.is_scrubbing) {
    frame.ui.mouse_tooltip(mark->words);
  } else if (mouse_px) {
    const std::array<std::string, 1> words = {clock_text(frame.axis.time_s(*mouse_px))};
    frame.ui.mouse_tooltip(words);
  } else if (area.is_hovered && area.rect.left + area.mouse.x() < frame.axis.left_px) {
    frame.ui.mouse_tooltip(mark_key_lines());
  }
}

}  // namespace nadir::detail
