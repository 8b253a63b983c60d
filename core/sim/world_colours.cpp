// SPDX-License-Identifier: Apache-2.0
#include "core/sim/world_colours.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/require.h"
#include "core/sim/surface_paint.h"

namespace nadir {
namespace {

constexpr std::size_t kLevels = 4;
constexpr Colour kHorizon{208, 218, 226}, kZenith{98, 144, 202}, kBareGround{150, 146, 132};

std::uint8_t channel(float value) {
  return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

Colour colour_of(const Paint& p) { return {channel(p.x()), channel(p.y()), channel(p.z())}; }

/// Every pixel the mean of four; the last row and column stand in for missing ones.
ColourRaster halved(const ColourRaster& picture) {
  ColourRaster small((picture.width() + 1) / 2, (picture.height() + 1) / 2);
  for (int row = 0; row < small.height(); ++row) {
    const auto upper = picture.row(2 * row);
    const auto lower = picture.row(std::min(2 * row + 1, picture.height() - 1));
    for (int column = 0; column < small.width(); ++column) {
      const std::size_t left = 2 * static_cast<std::size_t>(column);
      const auto right = std::min(left + 1, upper.size() - 1);
      const auto mean = [&](std::uint8_t Colour::*part) {
        const int sum =
            upper[left].*part + upper[right].*part + lower[left].*part + lower[right].*part;
        return static_cast<std::uint8_t>((sum + 2) / 4);
      };
      small.at(column, row) = {mean(&Colour::red), mean(&Colour::green), mean(&Colour::blue)};
    }
  }
  return small;
}

/// Bilinear between pixel centres; beyond the border the border's colour. `x` and `y` in pixels
/// from the upper left corner.
Paint bilinear(const ColourRaster& picture, double x, double y) {
  const double right = std::clamp(x - 0.5, 0.0, picture.width() - 1.0);
  const double down = std::clamp(y - 0.5, 0.0, picture.height() - 1.0);
  const int column = static_cast<int>(right);
  const int row = static_cast<int>(down);
  const auto u = static_cast<float>(right - column);
  const auto v = static_cast<float>(down - row);
  const int next_column = std::min(column + 1, picture.width() - 1);
  const int next_row = std::min(row + 1, picture.height() - 1);
  const Paint upper =
      (1.0F - u) * paint_of(picture.at(column, row)) + u * paint_of(picture.at(next_column, row));
  const Paint lower = (1.0F - u) * paint_of(picture.at(column, next_row)) +
                      u * paint_of(picture.at(next_column, next_row));
  return (1.0F - v) * upper + v * lower;
}

/// In the direction of a ray, from the horizon up; all below is haze.
Paint sky(const Eigen::Vector3d& along) {
  const double rise = std::clamp(along.z() / along.norm() / 0.55, 0.0, 1.0);
  const auto share = static_cast<float>(std::sqrt(rise) * (0.35 + 0.65 * rise));
  return (1.0F - share) * paint_of(kHorizon) + share * paint_of(kZenith);
}

float haze(float depth_m) {
  const float share = depth_m / static_cast<float>(kFarthestLabelM);
  return 0.93F * share * share * (0.35F + 0.65F * share);
}

}  // namespace

/// Colours pixels of one row after the other; remembers the last wall.
class WorldColours::Brush {
 public:
  Brush(const WorldColours& colours, const CameraModel& camera, const Eigen::Vector3d& centre)
      : colours_(colours), map_(colours.world_.map), camera_(camera), centre_in_enu_m_(centre) {}

  [[nodiscard]] Paint solid(const Solid& solid,
                            const Eigen::Vector3d& point,
                            double depth_m) const {
    Paint paint = paint_of_solid(solid, point);
    const bool is_crown = solid.label == kVegetation && solid.shape == Solid::Shape::kEllipsoid;
    if (is_crown) {
      if (colours_.picture_ != nullptr && map_.class_at(point.head<2>()) == kVegetation) {
        paint = picture(point, depth_m);
      }
      paint *= texture(point, 0.3, 0.16F);
    }
    return paint * light(outward_normal(solid, point));
  }

  /// Columns and ground.
  [[nodiscard]] Paint column(ClassId label, const Eigen::Vector3d& point, double depth_m) {
    const Eigen::Vector2d cell = map_.overhead_from_enu(point.head<2>());
    const int x = static_cast<int>(std::floor(cell.x()));
    const int y = static_cast<int>(std::floor(cell.y()));
    if (!map_.labels.contains(x, y)) return paint_of(kBareGround);
    constexpr double kRoundingM = 1e-3;
    const Relief& relief = colours_.world_.relief;
    const float height_m = relief.height_m.at(x, y);
    const bool is_side = point.z() < static_cast<double>(height_m) - kRoundingM;
    if (height_m > relief.low_m) {
      Paint paint = paint_of_class(label, static_cast<double>(height_m));
      if (!is_side) return paint;
      // A wall gets darker towards its foot.
      const auto foot = static_cast<float>(std::min(1.0, 0.8 + 0.2 * point.z()));
      return paint * (foot * texture(point, 0.7, 0.03F) * light(wall_normal(x, y)));
    }
    const Paint paint =
        colours_.picture_ != nullptr ? picture(point, depth_m) : paint_of(class_info(label).colour);
    return is_side ? Paint(0.75F * paint) : paint;
  }

 private:
  /// The picture at a place, averaged over about what a pixel shows of level ground there.
  [[nodiscard]] Paint picture(const Eigen::Vector3d& point, double depth_m) const {
    const Eigen::Vector3d way = point - centre_in_enu_m_;
    const double slant = way.norm() / std::max(0.1, std::abs(way.z()));
    const double pixel_m = depth_m / camera_.focal_x_px * std::sqrt(slant);
    const double level = std::clamp(std::log2(std::max(pixel_m / map_.metres_per_cell, 1e-9)), 0.0,
                                    static_cast<double>(colours_.halved_.size()));
    const auto finer = static_cast<std::size_t>(level);
    const auto share = static_cast<float>(level - static_cast<double>(finer));
    const Eigen::Vector2d cell = map_.overhead_from_enu(point.head<2>());
    Paint fine = at_level(finer, cell);
    if (share == 0.0F) return fine;
    return (1.0F - share) * fine + share * at_level(finer + 1, cell);
  }

  [[nodiscard]] Paint at_level(std::size_t level, const Eigen::Vector2d& cell) const {
    const double scale = 1.0 / static_cast<double>(1U << level);
    return bilinear(level == 0 ? *colours_.picture_ : colours_.halved_[level - 1], scale * cell.x(),
                    scale * cell.y());
  }

  [[nodiscard]] float texture(const Eigen::Vector3d& point, double length_m, float depth) const {
    const double value = colours_.texture_.at((point.x() + 0.6 * point.z()) / length_m,
                                              (point.y() + 0.8 * point.z()) / length_m);
    return 1.0F + depth * static_cast<float>(std::clamp(value, -2.0, 2.0));
  }

  /// Towards the free cells around a cell, so that a slanting wall is no staircase; towards the
  /// camera where a wall is so thin that both sides are alike.
  [[nodiscard]] const Eigen::Vector3d& wall_normal(int x, int y) {
    if (x == last_x_ && y == last_y_) return last_normal_;
    constexpr int kReach = 3;
    const Raster<std::uint8_t>& cells_to_tall = colours_.world_.relief.cells_to_tall;
    Eigen::Vector2d away = Eigen::Vector2d::Zero();
    for (int dy = -kReach; dy <= kReach; ++dy) {
      for (int dx = -kReach; dx <= kReach; ++dx) {
        if (!map_.labels.contains(x + dx, y + dy) || cells_to_tall.at(x + dx, y + dy) == 0)
          continue;
        away += Eigen::Vector2d(dx, -dy);
      }
    }
    const Eigen::Vector2d to_camera =
        centre_in_enu_m_.head<2>() - map_.enu_from_overhead({x + 0.5, y + 0.5});
    if (away.squaredNorm() < 9.0) away = to_camera;
    last_x_ = x;
    last_y_ = y;
    last_normal_ << away.normalized(), 0.0;
    return last_normal_;
  }

  const WorldColours& colours_;
  const OverheadMap& map_;
  const CameraModel& camera_;
  Eigen::Vector3d centre_in_enu_m_;
  int last_x_ = -1, last_y_ = -1;
  Eigen::Vector3d last_normal_ = Eigen::Vector3d::UnitZ();
};

WorldColours::WorldColours(const World& world, const ColourRaster* picture, std::uint64_t seed)
    : world_(world), picture_(picture), texture_(seed, kWorldObjects) {
  if (picture == nullptr) return;
  NADIR_REQUIRE(picture->width() == world.map.labels.width() &&
                picture->height() == world.map.labels.height());
  halved_.reserve(kLevels);
  for (std::size_t level = 0; level < kLevels; ++level) {
    halved_.push_back(halved(level == 0 ? *picture : halved_.back()));
  }
}

ColourRaster WorldColours::paint(const SurfaceView& view,
                                 const CameraModel& camera,
                                 const Rigid3& enu_from_camera) const {
  NADIR_REQUIRE(view.solid.width() == camera.width && view.solid.height() == camera.height);
  const Eigen::Matrix3d rotation = enu_from_camera.rotation.toRotationMatrix();
  const Eigen::Vector3d& centre_in_enu_m = enu_from_camera.translation_m;
  const Paint far = paint_of(kHorizon);
  ColourRaster seen(camera.width, camera.height);
  parallel_for(
      static_cast<std::size_t>(camera.height), 16, [&](std::size_t begin, std::size_t end) {
        Brush brush(*this, camera, centre_in_enu_m);
        for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
          for (int column = 0; column < camera.width; ++column) {
            const Eigen::Vector3d along = rotation * camera.ray({column + 0.5, row + 0.5});
            const float depth_m = view.frame.depth_m.at(column, row);
            if (!(depth_m > 0.0F)) {
              seen.at(column, row) = colour_of(sky(along));
              continue;
            }
            const auto depth = static_cast<double>(depth_m);
            const Eigen::Vector3d point = centre_in_enu_m + depth * along;
            const std::int32_t solid = view.solid.at(column, row);
            const Paint near =
                solid != SurfaceView::kNoSolid
                    ? brush.solid(view.solids[static_cast<std::size_t>(solid)], point, depth)
                    : brush.column(view.frame.labels.at(column, row), point, depth);
            const float share = haze(depth_m);
            seen.at(column, row) = colour_of((1.0F - share) * near + share * far);
          }
        }
      });
  return seen;
}

}  // namespace nadir
