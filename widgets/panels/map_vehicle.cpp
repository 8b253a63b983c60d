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
constexpr double kLeastFree = 120.0;  ///< A map that is smaller has no room for it.

/// How far it is from the middle of a box to its border, in a direction of length 1.
double reach_of(double width, double height, const Eigen::Vector2d& along) {
  return std::min(std::abs(along.x()) > 1e-9 ? width / 2.0 / std::abs(along.x()) : height,
                  std::abs(along.y()) > 1e-9 ? height / 2.0 / std::abs(along.y()) : width);
}

}  // namespace

std::optional<VehicleAway> vehicle_away(const MapViewModel& model,
                                        const MapFrame& frame,
                                        const PageRect& free) {
  if (model.look.is_following || model.runs.empty()) return std::nullopt;
  const MapRun& run = model.runs.back();
  if (!run.is_active || !run.document || !run.step) return std::nullopt;
  const Rigid2& mean = run.document->steps[*run.step].estimate.moments.mean;
  if (!mean.translation_m().allFinite()) return std::nullopt;
  const MapCamera& camera = frame.camera;
  const MapPage page{camera.centre_in_enu_m, camera.metres_per_px * frame.where.width,
                     camera.up_rad, frame.where.width / frame.where.height};
  if (page.shows(mean.translation_m())) return std::nullopt;
  const Eigen::Vector2d at = frame.page(mean.translation_m());
  const Eigen::Vector2d way = at - free.centre();
  if (!(way.norm() > 0.0) || !way.allFinite()) return std::nullopt;
  const Eigen::Vector2d along = way.normalized();
  return VehicleAway{free, free.centre() + reach_of(free.width, free.height, along) * along, along,
                     (mean.translation_m() - frame.camera.centre_in_enu_m).norm()};
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
  const PageRect& free = away.free;
  if (std::min(free.width, free.height) < ui.px(kLeastFree)) return {};
  const auto scope = ui.scope("Vehicle");
  const std::string words = away_words(away.distance_m);
  const double width = std::ceil(ui.text_width(words)) + ui.px(24.0) + 1.0, height = ui.px(28.0);
  // Beside the arrow at a border left or right, below or above it at the others; moved along the border where that ends.
  const bool is_beside = std::min(away.tip.x() - free.left, free.right() - away.tip.x()) < 1.0;
  const double apart = ui.px(kArrowReach);
  const double aside =
      (is_beside ? apart + width / 2.0 : 0.0) * (away.along.x() > 0.0 ? -1.0 : 1.0);
  const double below =
      (is_beside ? 0.0 : apart + height / 2.0) * (away.along.y() > 0.0 ? -1.0 : 1.0);
  const double left = std::clamp(away.tip.x() + aside - width / 2.0, free.left,
                                 std::max(free.left, free.right() - width));
  const double bottom = std::clamp(away.tip.y() + below - height / 2.0, free.bottom,
                                   std::max(free.bottom, free.top() - height));
  const kit::Rect place{std::floor(page.left + left), std::floor(page.bottom() - bottom - height),
                        width, height};
  const auto region = ui.region(
      "Plate", place, {.surface = kit::Surface::kPlate, .padding = 0.0, .is_above = true});
  ui.next_width(width);
  const kit::Hint hint =
      hint_for("The vehicle is out of sight: follow it", actions::Follow{Switch::kToggle});
  // One button, whatever the distance has become between press and release.
  if (!ui.button(words + "###Follow", kit::ButtonLook::kQuiet, hint)) return {};
  return {actions::Follow{Switch::kOn}};
}

}  // namespace nadir
