// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/session/map_sight.h"
#include "widgets/panels/shortcut_hint.h"

namespace nadir {
namespace {

constexpr double kArrowLength = 20.0, kArrowHalf = 8.0, kArrowNotch = 6.0;  // of the design
constexpr double kArrowReach = 26.0;  ///< From its tip the words begin, whichever way it points.
constexpr double kPlateHeight = 28.0;
constexpr double kSearchStep = 4.0;  ///< From one place for the arrow to the next one.

/// How far it is from the middle of a box to its border, in a direction of length 1.
double reach_of(const PageRect& box, const Eigen::Vector2d& along) {
  return std::min(std::abs(along.x()) > 1e-9 ? box.width / 2.0 / std::abs(along.x()) : box.height,
                  std::abs(along.y()) > 1e-9 ? box.height / 2.0 / std::abs(along.y()) : box.width);
}

bool is_free(const PageRect& place, const ArrowRoom& room) {
  return std::none_of(room.taken.begin(), room.taken.end(),
                      [&place](const PageRect& taken) { return overlap(place, taken); });
}

PageRect box_around_arrow(const Eigen::Vector2d& tip, const Eigen::Vector2d& along, double px) {
  const Eigen::Vector2d back = tip - kArrowLength * px * along;
  const Eigen::Vector2d side = kArrowHalf * px * Eigen::Vector2d(-along.y(), along.x()).cwiseAbs();
  const Eigen::Vector2d low = tip.cwiseMin(back - side), high = tip.cwiseMax(back + side);
  return {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

/// Places for words around an arrow, the best first: behind it as it leaves the room at the left or right, or above or below,
/// moved along the border where that ends.
std::array<PageRect, 2> plates_for(const Eigen::Vector2d& tip,
                                   const Eigen::Vector2d& along,
                                   const PageRect& inside,
                                   const Eigen::Vector2d& size,
                                   double px) {
  const auto plate_at = [&](const Eigen::Vector2d& centre) {
    const double left = std::clamp(centre.x() - size.x() / 2.0, inside.left,
                                   std::max(inside.left, inside.right() - size.x()));
    const double bottom = std::clamp(centre.y() - size.y() / 2.0, inside.bottom,
                                     std::max(inside.bottom, inside.top() - size.y()));
    return PageRect{left, bottom, size.x(), size.y()};
  };
  const double aside = std::copysign(kArrowReach * px + size.x() / 2.0, -along.x());
  const double below = std::copysign(kArrowReach * px + size.y() / 2.0, -along.y());
  const PageRect beside = plate_at(tip + Eigen::Vector2d(aside, 0.0));
  const PageRect behind = plate_at(tip + Eigen::Vector2d(0.0, below));
  const bool is_beside = std::abs(along.x()) * inside.height > std::abs(along.y()) * inside.width;
  return is_beside ? std::array{beside, behind} : std::array{behind, beside};
}

/// From the border of the room to its middle, the first place where arrow and words lie on nothing; else where the arrow does.
VehicleAway placed_arrow(const ArrowRoom& room,
                         const Eigen::Vector2d& along,
                         const Eigen::Vector2d& plate_size,
                         double px) {
  const PageRect& inside = room.inside;
  const Eigen::Vector2d middle = inside.centre();
  const double reach = reach_of(inside, along);
  const bool has_words_room = plate_size.x() <= inside.width && plate_size.y() <= inside.height;
  std::optional<VehicleAway> without_words;
  for (double far = reach; far > 0.0; far -= kSearchStep * px) {
    VehicleAway away{middle + far * along, along, {}};
    const PageRect arrow = box_around_arrow(away.tip, along, px);
    if (!is_free(arrow, room)) continue;
    for (const PageRect& plate : plates_for(away.tip, along, inside, plate_size, px)) {
      if (!has_words_room || overlap(plate, arrow) || !is_free(plate, room)) continue;
      away.plate = plate;
      return away;
    }
    if (!without_words) without_words = away;
  }
  return without_words.value_or(VehicleAway{middle + reach * along, along, {}});
}

double plate_width(const kit::Ui& ui, const std::string& words) {
  return std::ceil(ui.text_width(words)) + ui.px(24.0) + 1.0;
}

}  // namespace

bool overlap(const PageRect& one, const PageRect& other) {
  return one.left < other.right() && other.left < one.right() && one.bottom < other.top() &&
         other.bottom < one.top();
}

std::optional<VehicleAway> vehicle_away(const kit::Ui& ui,
                                        const MapViewModel& model,
                                        const MapFrame& frame,
                                        const ArrowRoom& room) {
  if (model.look.is_following || model.runs.empty()) return std::nullopt;
  const MapRun& run = model.runs.back();
  if (!run.is_active || !run.document || !run.step) return std::nullopt;
  const Rigid2& mean = run.document->steps[*run.step].estimate.moments.mean;
  if (!mean.translation_m().allFinite()) return std::nullopt;
  const MapCamera& camera = frame.camera;
  const MapPage page{camera.centre_in_enu_m, camera.metres_per_px * frame.where.width,
                     camera.up_rad, frame.where.width / frame.where.height};
  if (page.shows(mean.translation_m())) return std::nullopt;
  const Eigen::Vector2d way = frame.page(mean.translation_m()) - room.inside.centre();
  if (!(way.norm() > 0.0) || !way.allFinite()) return std::nullopt;
  const double distance_m = (mean.translation_m() - camera.centre_in_enu_m).norm();
  const Eigen::Vector2d plate(plate_width(ui, away_words(distance_m)), ui.px(kPlateHeight));
  VehicleAway away = placed_arrow(room, way.normalized(), plate, ui.px(1.0));
  away.distance_m = distance_m;
  return away;
}

std::string away_words(double distance_m) {
  if (distance_m >= 999.5) return fmt::format("vehicle {:.1f} km", distance_m / 1000.0);
  return fmt::format("vehicle {:.{}f} m", distance_m, distance_m < 9.95 ? 1 : 0);
}

void draw_vehicle_arrow(kit::Ui& ui, const VehicleAway& away) {
  const Theme& theme = ui.theme();
  const Eigen::Vector2d across(-away.along.y(), away.along.x());
  const Eigen::Vector2d back = away.tip - ui.px(kArrowLength) * away.along;
  // With a notch, so that it is seen which of its corners is the tip.
  const std::array<Eigen::Vector2d, 4> arrow = {away.tip, back + ui.px(kArrowHalf) * across,
                                                back + ui.px(kArrowNotch) * away.along,
                                                back - ui.px(kArrowHalf) * across};
  const std::array<Eigen::Vector2d, 5> rim = {arrow[0], arrow[1], arrow[2], arrow[3], arrow[0]};
  ui.canvas().stroke(rim, {with_opacity(theme.page, 0.85), ui.px(3.0), {}});
  ui.canvas().fill(arrow, theme.accent);
}

Actions draw_vehicle_plate(kit::Ui& ui, const VehicleAway& away, const kit::Rect& page) {
  if (!away.plate) return {};
  const auto scope = ui.scope("Vehicle");
  const kit::Rect place{std::floor(page.left + away.plate->left),
                        std::floor(page.bottom() - away.plate->top()), away.plate->width,
                        away.plate->height};
  const auto region = ui.region(
      "Plate", place, {.surface = kit::Surface::kPlate, .padding = 0.0, .is_above = true});
  ui.next_width(away.plate->width);
  const kit::Hint hint =
      hint_for("The vehicle is out of sight: follow it", actions::Follow{Switch::kToggle});
  // One button, whatever the distance has become between press and release.
  if (!ui.button(away_words(away.distance_m) + "###Follow", kit::ButtonLook::kQuiet, hint)) {
    return {};
  }
  return {actions::Follow{Switch::kOn}};
}

}  // namespace nadir
