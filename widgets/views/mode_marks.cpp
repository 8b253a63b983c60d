// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/mode_marks.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace nadir {
namespace {

bool is_drawn(const PoseMode& mode) {
  const Rigid2& mean = mode.moments.mean;
  return mean.translation_m().allFinite() && std::isfinite(mean.yaw_rad) &&
         std::isfinite(mode.mass);
}

/// The heaviest first; of equal ones the first.
std::vector<std::size_t> by_falling_mass(std::span<const PoseMode> modes) {
  std::vector<std::size_t> order(modes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return !is_drawn(modes[i]); });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return modes[a].mass > modes[b].mass; });
  return order;
}

TextStyle words_style(const MapFrame& frame, const ModeLook& look) {
  TextStyle style = look.words;
  style.size_px = look.words_pt * frame.px_per_pt;
  return style;
}

Eigen::AlignedBox2d box_of(const PageRect& rect) {
  return {Eigen::Vector2d(rect.left, rect.bottom), Eigen::Vector2d(rect.right(), rect.top())};
}

}  // namespace

std::string mass_text(double mass) {
  const double percent = 100.0 * mass;
  if (percent > 0.0 && percent < 0.5) return "<1 %";
  if (percent < 100.0 && percent >= 99.5) return ">99 %";
  return fmt::format("{:.0f} %", percent);
}

std::vector<std::optional<PageRect>> mode_plates(const MapFrame& frame,
                                                 std::span<const PoseMode> modes,
                                                 const ModeLook& look) {
  const double reach = 0.65 * look.arrow_pt * frame.px_per_pt;
  const double gap = 2.0 * frame.px_per_pt;
  const TextStyle style = words_style(frame, look);
  const std::vector<std::size_t> order = by_falling_mass(modes);
  std::vector<Eigen::AlignedBox2d> taken;
  for (const std::size_t i : order) {
    const Eigen::Vector2d at = frame.page(modes[i].moments.mean.translation_m());
    taken.emplace_back(at - Eigen::Vector2d::Constant(reach),
                       at + Eigen::Vector2d::Constant(reach));
  }
  const Eigen::AlignedBox2d inside = box_of(frame.where);
  std::vector<std::optional<PageRect>> plates(modes.size());
  for (const std::size_t i : order) {
    const Eigen::Vector2d at = frame.page(modes[i].moments.mean.translation_m());
    const PageRect plate = plate_at(at, mass_text(modes[i].mass), style, frame.px_per_pt);
    const Eigen::Vector2d away(reach + gap + plate.width / 2.0, reach + gap + plate.height / 2.0);
    // Above, below, right, left, then the corners.
    constexpr std::array<std::array<int, 2>, 8> kSides = {
        {{0, 1}, {0, -1}, {1, 0}, {-1, 0}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    for (const auto& [right, up] : kSides) {
      const PageRect moved{plate.left + right * away.x(), plate.bottom + up * away.y(), plate.width,
                           plate.height};
      const Eigen::AlignedBox2d box = box_of(moved);
      const bool is_free = std::none_of(taken.begin(), taken.end(), [&](const auto& other) {
        return !other.intersection(box).isEmpty();
      });
      if (!is_free || !inside.contains(box)) continue;
      taken.push_back(box);
      plates[i] = moved;
      break;
    }
  }
  return plates;
}

void draw_modes(Canvas& canvas,
                const MapFrame& frame,
                std::span<const PoseMode> modes,
                const ModeLook& look) {
  const std::vector<std::optional<PageRect>> plates = mode_plates(frame, modes, look);
  std::vector<std::size_t> order = by_falling_mass(modes);
  std::reverse(order.begin(), order.end());
  canvas.push_clip(frame.where);
  for (const std::size_t i : order) {
    draw_pose(canvas, frame, modes[i].moments.mean, look.arrow_pt, look.arrow);
  }
  canvas.pop_clip();
  for (const std::size_t i : order) {
    if (!plates[i]) continue;
    draw_plate(canvas, plates[i]->centre(), mass_text(modes[i].mass), words_style(frame, look),
               look.plate, frame.px_per_pt);
  }
}

}  // namespace nadir
