// SPDX-License-Identifier: Apache-2.0
#include "app/gui/window_arrangement.h"

#include <algorithm>
#include <cmath>

#include "widgets/panels/left_rail.h"
#include "widgets/panels/menu_bar.h"
#include "widgets/panels/status_bar.h"

namespace nadir {
namespace {

// Lengths of the design. Below what is useful, panels show less than they are for.
constexpr double kUsefulLeft = 200.0, kUsefulRight = 244.0;
constexpr double kUsefulMapWidth = 400.0, kLeastMapWidth = 300.0, kSmallestMapWidth = 160.0;
constexpr double kUsefulMapHeight = 280.0, kLeastMapHeight = 120.0;
constexpr double kUsefulTimeline = 148.0, kTransport = 56.0;
constexpr double kMostOfWidth = 0.4, kMostOfHeight = 0.6;

/// A column's width; 0: there is none.
struct Columns {
  double left = 0.0, right = 0.0;
  bool is_left_strip = false, is_right_strip = false;
};

/// @param room  Beside the rail.
Columns columns_for(const WindowWishes& wishes, double room) {
  Columns columns;
  const double most = kMostOfWidth * room;
  if (wishes.has_left) columns.left = std::min(wishes.left_pt, std::max(most, kUsefulLeft));
  if (wishes.has_right) columns.right = std::min(wishes.right_pt, std::max(most, kUsefulRight));
  const double least_left = std::min(columns.left, kUsefulLeft);
  const double least_right = std::min(columns.right, kUsefulRight);
  // What is more than useful goes first, from both alike.
  const double spare = columns.left - least_left + columns.right - least_right;
  const double lack = columns.left + columns.right + kUsefulMapWidth - room;
  if (lack > 0.0 && spare > 0.0) {
    const double kept = 1.0 - std::min(1.0, lack / spare);
    columns.left = least_left + kept * (columns.left - least_left);
    columns.right = least_right + kept * (columns.right - least_right);
  }
  const auto map = [&] { return room - columns.left - columns.right; };
  if (columns.left > 0.0 && columns.right > 0.0 && map() < kLeastMapWidth) {
    const bool keeps_right = wishes.front == WindowSide::kRight;
    (keeps_right ? columns.is_left_strip : columns.is_right_strip) = true;
    (keeps_right ? columns.left : columns.right) = kColumnStrip;
  }
  if (map() < kSmallestMapWidth) {
    columns.is_left_strip = columns.left > 0.0;
    columns.is_right_strip = columns.right > 0.0;
    columns.left = std::min(columns.left, kColumnStrip);
    columns.right = std::min(columns.right, kColumnStrip);
  }
  if (map() < 2.0 * kColumnStrip) return {};
  return columns;
}

/// @param room  Between menu and status.
double timeline_for(const WindowWishes& wishes, double room) {
  if (!wishes.has_timeline) return 0.0;
  const double wanted = std::min(wishes.timeline_pt, kMostOfHeight * room);
  const double useful = std::min(wishes.timeline_pt, kUsefulTimeline);
  const double given = std::clamp(room - kUsefulMapHeight, useful, std::max(useful, wanted));
  if (room - given >= kLeastMapHeight) return given;
  return room - kTransport >= kLeastMapHeight ? kTransport : 0.0;
}

}  // namespace

WindowPlaces arrange_window(const WindowWishes& wishes) {
  const double scale = std::max(wishes.scale, 1e-3);
  const auto px = [scale](double length) { return std::floor(length * scale + 0.5); };
  const double width = wishes.width_px, height = wishes.height_px;
  WindowPlaces places;
  const double menu = wishes.has_frame ? std::min(px(kMenuBarHeight), height) : 0.0;
  const double status = wishes.has_status ? std::min(px(kStatusBarHeight), height - menu) : 0.0;
  const double rail = wishes.has_frame ? std::min(px(kLeftRailWidth), width) : 0.0;
  const Columns columns = columns_for(wishes, (width - rail) / scale);
  const double left = px(columns.left), right = px(columns.right);
  const double timeline = px(timeline_for(wishes, (height - menu - status) / scale));
  const double bottom = height - status - timeline;
  places.menu = {0.0, 0.0, width, menu};
  places.rail = {0.0, menu, rail, height - menu - status};
  const kit::Rect left_place{rail, menu, left, bottom - menu};
  const kit::Rect right_place{width - right, menu, right, bottom - menu};
  (columns.is_left_strip ? places.left_strip : places.left) = left_place;
  (columns.is_right_strip ? places.right_strip : places.right) = right_place;
  places.map = {rail + left, menu, std::max(0.0, width - rail - left - right), bottom - menu};
  places.timeline = {rail, bottom, width - rail, timeline};
  places.status = {0.0, height - status, width, status};
  const auto most = [&](double shown, double other) {
    const double free = width - rail - other - px(kUsefulMapWidth);
    return std::max(shown, std::min(kMostOfWidth * (width - rail), free));
  };
  places.most_left_px = most(left, right);
  places.most_right_px = most(right, left);
  const double between = height - menu - status;
  places.most_timeline_px =
      std::max(timeline, std::min(kMostOfHeight * between, between - px(kUsefulMapHeight)));
  return places;
}

}  // namespace nadir
