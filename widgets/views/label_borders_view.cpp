// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/label_borders_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "widgets/views/label_objects_view.h"
#include "widgets/views/theme.h"

namespace nadir {
namespace {

constexpr double kMarginShare = 0.25;  ///< Of the page's sides, drawn beyond each of them.
constexpr double kMostSidePx = 8192.0;
constexpr double kBorderPt = 0.75;
constexpr double kBorderCasingPt = 0.6;  ///< On each side.

using BorderMask = Raster<std::uint8_t>;

/// Marks the pixels that a line passes: one a column, or a row where it is steeper. Points are in pixels, y *down*.
void mark_leg(BorderMask& mask, Eigen::Vector2d from, Eigen::Vector2d to) {
  // The part inside, after Liang and Barsky (1984); the margin keeps rounding inside too.
  const std::array<double, 2> last = {mask.width() - 1.001, mask.height() - 1.001};
  double begin = 0.0, end = 1.0;
  const Eigen::Vector2d way = to - from;
  for (int axis = 0; axis < 2; ++axis) {
    const double most = last.at(static_cast<std::size_t>(axis));
    if (way[axis] == 0.0) {
      if (from[axis] < 0.0 || from[axis] > most) return;
      continue;
    }
    const double a = -from[axis] / way[axis], b = (most - from[axis]) / way[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  if (!(begin <= end)) return;
  to = from + end * way;
  from += begin * way;
  const Eigen::Vector2d inside = to - from;
  const int steps = static_cast<int>(std::ceil(inside.cwiseAbs().maxCoeff()));
  const Eigen::Vector2d step = steps > 0 ? Eigen::Vector2d(inside / steps) : inside;
  for (int i = 0; i <= steps; ++i, from += step) {
    const int column = std::clamp(static_cast<int>(from.x()), 0, mask.width() - 1);
    const int row = std::clamp(static_cast<int>(from.y()), 0, mask.height() - 1);
    mask.at(column, row) = 1;
  }
}

/// What is marked, or within so many pixels of it in columns and rows.
BorderMask widened(const BorderMask& mask, int by) {
  BorderMask wide = mask;
  for (int shift = 1; shift <= by; ++shift) {  // along rows
    for (int row = 0; row < mask.height(); ++row) {
      const std::uint8_t* const from = mask.row(row).data();
      std::uint8_t* const to = wide.row(row).data();
      for (int column = shift; column < mask.width(); ++column) {
        to[column - shift] |= from[column];
        to[column] |= from[column - shift];
      }
    }
  }
  const BorderMask across = wide;
  for (int shift = 1; shift <= by; ++shift) {
    for (int row = shift; row < mask.height(); ++row) {
      const std::uint8_t* const low = across.row(row).data();
      const std::uint8_t* const high = across.row(row - shift).data();
      std::uint8_t* const to_high = wide.row(row - shift).data();
      std::uint8_t* const to_low = wide.row(row).data();
      for (int column = 0; column < mask.width(); ++column) {
        to_high[column] |= low[column];
        to_low[column] |= high[column];
      }
    }
  }
  return wide;
}

PageRect page_of(const MapSight& sight) { return {0.0, 0.0, sight.width_px, sight.height_px}; }

/// The same ground and more on all sides, by whole pixels, so that those of the page stay what they are.
MapSight with_margin(MapSight sight) {
  const auto wider = [](double side_px) {
    const double margin = std::min(kMarginShare * side_px, (kMostSidePx - side_px) / 2.0);
    return side_px + 2.0 * std::max(0.0, std::floor(margin));
  };
  sight.width_px = wider(sight.width_px);
  sight.height_px = wider(sight.height_px);
  return sight;
}

bool shows_all_of(const MapSight& drawn, const MapSight& page) {
  if (drawn.camera.metres_per_px != page.camera.metres_per_px ||
      drawn.camera.up_rad != page.camera.up_rad || drawn.px_per_pt != page.px_per_pt) {
    return false;
  }
  const Eigen::Vector2d middle =
      drawn.camera.page_from_enu(page.camera.centre_in_enu_m, page_of(drawn)) -
      page_of(drawn).centre();
  return std::abs(middle.x()) <= (drawn.width_px - page.width_px) / 2.0 &&
         std::abs(middle.y()) <= (drawn.height_px - page.height_px) / 2.0;
}

PlaneBounds ground_of(const MapSight& sight) {
  PlaneBounds bounds;
  for (const double x : {0.0, sight.width_px}) {
    for (const double y : {0.0, sight.height_px}) {
      bounds.include(sight.camera.enu_from_page({x, y}, page_of(sight)));
    }
  }
  return bounds;
}

BorderMask marked_borders(const LabelDocument& document, const MapSight& sight) {
  BorderMask mask(static_cast<int>(sight.width_px), static_cast<int>(sight.height_px), 0);
  const PlaneBounds ground = ground_of(sight);
  const double metres_per_px = sight.camera.metres_per_px;
  // From the plane to pixels, y down, by one product a place.
  const PageRect page = page_of(sight);
  const Eigen::Vector2d zero = sight.camera.page_from_enu({0.0, 0.0}, page);
  Eigen::Matrix2d turn;
  turn.col(0) = sight.camera.page_from_enu({1.0, 0.0}, page) - zero;
  turn.col(1) = sight.camera.page_from_enu({0.0, 1.0}, page) - zero;
  turn.row(1) *= -1.0;
  const Eigen::Vector2d middle(page.centre());
  const auto in_mask = [&](const Eigen::Vector2d& place) -> Eigen::Vector2d {
    return turn * (place - sight.camera.centre_in_enu_m) + middle;
  };
  for (const auto& [id, placed] : document.objects()) {
    const PlaneBounds& bounds = placed.bounds;
    if ((bounds.high - bounds.low).maxCoeff() < kLeastObjectPx * metres_per_px ||
        (bounds.low.array() > ground.high.array()).any() ||
        (bounds.high.array() < ground.low.array()).any()) {
      continue;
    }
    for (const Ring& line : border_of(*placed.object, metres_per_px)) {
      Eigen::Vector2d last = in_mask(line.front());
      for (std::size_t i = 1; i < line.size(); ++i) {
        const Eigen::Vector2d next = in_mask(line[i]);
        mark_leg(mask, last, next);
        last = next;
      }
    }
  }
  return mask;
}

}  // namespace

Raster<Rgba> border_picture(const LabelDocument& document, const MapSight& sight) {
  const Theme& colours = theme(ThemeName::kDark);
  const int half = static_cast<int>(kBorderPt * sight.px_per_pt / 2.0);
  const int casing = std::max(1, static_cast<int>(std::lround(kBorderCasingPt * sight.px_per_pt)));
  BorderMask lines = marked_borders(document, sight);
  if (half > 0) lines = widened(lines, half);
  const BorderMask cased = widened(lines, casing);
  const std::array<Rgba, 3> of_mask = {
      Rgba{0, 0, 0, 0}, with_opacity(colours.casing_on_imagery, 0.6), colours.truth_on_imagery};
  Raster<Rgba> picture(lines.width(), lines.height());
  for (std::size_t i = 0; i < picture.size(); ++i) {
    picture.values()[i] =
        of_mask.at(static_cast<std::size_t>(cased.values()[i] + lines.values()[i]));
  }
  return picture;
}

LabelBordersView::LabelBordersView(MapScene& scene)
    : scene_(scene), picture_(scene, MapLayer::kLabelBorders) {
  scene_.attach(*this);
}

LabelBordersView::~LabelBordersView() { scene_.detach(*this); }

void LabelBordersView::show(std::shared_ptr<const LabelDocument> document) {
  document_ = std::move(document);
  drawn_for_.reset();
  picture_.set_visible(is_visible_ && document_ != nullptr);
}

void LabelBordersView::set_visible(bool visible) {
  is_visible_ = visible;
  picture_.set_visible(visible && document_ != nullptr);
}

void LabelBordersView::adapt_to(const MapSight& sight) {
  if (document_ == nullptr || !is_visible_) return;
  if (drawn_for_ && shows_all_of(*drawn_for_, sight)) return;
  const MapSight wide = with_margin(sight);
  const Eigen::Vector2d corner = wide.camera.enu_from_page({0.0, wide.height_px}, page_of(wide));
  picture_.show(border_picture(*document_, wide),
                {corner.x(), corner.y(), wide.camera.up_rad - std::numbers::pi / 2.0},
                Eigen::Vector2d::Constant(wide.camera.metres_per_px), false);
  drawn_for_ = wide;
  ++times_drawn_;
}

}  // namespace nadir
