// SPDX-License-Identifier: Apache-2.0
#include "core/sim/label_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/require.h"

namespace nadir {
namespace {

// Lengths in pixels are those of an image 640 pixels wide and grow with it.
constexpr double kReferenceWidthPx = 640.0;
constexpr double kWobblePx = 2.0;       ///< Standard deviation of the displacement along each axis.
constexpr double kWobbleLengthPx = 16;  ///< Lattice spacing of the displacement field.
constexpr double kBlobPx = 36.0;        ///< Lattice spacing of the image half of the error field.
constexpr double kBlobM = 2.0;          ///< Lattice spacing of its world half.
constexpr double kChoicePx = 60.0;

// In the order of the class ids.
constexpr std::array<ClassErrors, kClassCount> kClassErrors = {{
    {0.95, 0.012, {{{kSidewalk, 0.5}, {kTerrain, 0.3}, {kLaneMarking, 0.2}}}},
    {0.70, 0.09, {{{kRoad, 0.5}, {kTerrain, 0.3}, {kCurb, 0.2}}}},
    {0.86, 0.04, {{{kVegetation, 0.5}, {kFence, 0.3}, {kRailing, 0.2}}}},
    {0.35, 0.08, {{{kBuilding, 0.4}, {kVegetation, 0.4}, {kRailing, 0.2}}}},
    {0.33, 0.3, {{{kBuilding, 0.4}, {kVegetation, 0.4}, {kSky, 0.2}}}},
    {0.15, 0.35, {{{kBuilding, 0.4}, {kVegetation, 0.4}, {kPole, 0.2}}}},
    {0.25, 0.25, {{{kBuilding, 0.4}, {kVegetation, 0.4}, {kPole, 0.2}}}},
    {0.86, 0.055, {{{kTerrain, 0.4}, {kBuilding, 0.4}, {kSky, 0.2}}}},
    {0.60, 0.1, {{{kVegetation, 0.4}, {kSidewalk, 0.35}, {kRoad, 0.25}}}},
    {0.96, 0.01, {{{kVegetation, 0.5}, {kBuilding, 0.4}, {kPole, 0.1}}}},
    {0.45, 0.17, {{{kBuilding, 0.4}, {kCar, 0.3}, {kVegetation, 0.3}}}},
    {0.82, 0.035, {{{kRoad, 0.5}, {kBuilding, 0.35}, {kVegetation, 0.15}}}},
    {0.30, 0.12, {{{kFence, 0.5}, {kBuilding, 0.25}, {kVegetation, 0.25}}}},
    {0.50, 0.15, {{{kSidewalk, 0.5}, {kRoad, 0.35}, {kLaneMarking, 0.15}}}},
    {0.50, 0.15, {{{kRoad, 0.9}, {kSidewalk, 0.05}, {kCurb, 0.05}}}},
    {0.10, 0.38, {{{kPole, 0.4}, {kSky, 0.4}, {kVegetation, 0.2}}}},
}};

/// Where a field of one purpose lies on the shared lattice: far from all others, elsewhere in every
/// frame.
struct FieldOrigin {
  double x, y;
};

FieldOrigin field_origin(std::uint64_t seed, std::uint32_t frame_number, std::uint32_t purpose) {
  const auto [x, y] = uniforms({seed, kLabelNoise, frame_number, purpose, 0});
  return {256.0 * x, 256.0 * y};
}

/// All fields of one frame.
struct FrameFields {
  const SmoothNoise& noise;
  double px;  ///< Pixels of this image in a pixel of the reference width.
  FieldOrigin right, down, image, image_instead_of_world, choice;

  [[nodiscard]] double at(const FieldOrigin& origin, double length_px, int column, int row) const {
    return noise.at(origin.x + column / (length_px * px), origin.y + row / (length_px * px));
  }
};

/// The world half of the error field. Height is folded into the plane, so that walls are not
/// striped from top to bottom.
double world_field(const SmoothNoise& noise, const Eigen::Vector3d& point_in_enu_m) {
  return noise.at((point_in_enu_m.x() + 0.6 * point_in_enu_m.z()) / kBlobM,
                  (point_in_enu_m.y() + 0.8 * point_in_enu_m.z()) / kBlobM);
}

ClassId confused(const ClassErrors& errors, double share) {
  for (const auto& confusion : errors.confusions) {
    share -= confusion.share;
    if (share < 0.0) return confusion.taken_for;
  }
  return errors.confusions.front().taken_for;
}

}  // namespace

const ClassErrors& class_errors(ClassId id) {
  NADIR_REQUIRE(id < kClassCount);
  return kClassErrors[id];
}

LabelNoise::LabelNoise(std::uint64_t seed) : seed_(seed), noise_(seed, kLabelNoise) {
  for (std::size_t id = 0; id < kClassErrors.size(); ++id) {
    const ClassErrors& errors = kClassErrors[id];
    const double confused_share = 1.0 - errors.accuracy / (1.0 - errors.border_loss);
    threshold_[id] = normal_quantile(std::clamp(confused_share, 1e-6, 1.0 - 1e-6));
  }
}

Raster<ClassId> LabelNoise::apply(const SemanticFrame& frame,
                                  const CameraModel& camera,
                                  const Rigid3& enu_from_camera,
                                  std::uint32_t frame_number) const {
  const int width = frame.labels.width();
  const int height = frame.labels.height();
  NADIR_REQUIRE(width == camera.width && height == camera.height);
  NADIR_REQUIRE(frame.depth_m.width() == width && frame.depth_m.height() == height);
  const auto origin = [&](std::uint32_t purpose) {
    return field_origin(seed_, frame_number, purpose);
  };
  const FrameFields fields{
      noise_, width / kReferenceWidthPx, origin(0), origin(1), origin(2), origin(3), origin(4)};
  const double wobble_px = kWobblePx * fields.px;
  const Eigen::Matrix3d rotation = enu_from_camera.rotation.toRotationMatrix();
  Raster<ClassId> seen(width, height, kUnclassified);
  const auto label_rows = [&](std::size_t begin, std::size_t end) {
    for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
      for (int column = 0; column < width; ++column) {
        const double right_px = wobble_px * fields.at(fields.right, kWobbleLengthPx, column, row);
        const double down_px = wobble_px * fields.at(fields.down, kWobbleLengthPx, column, row);
        const int x = std::clamp(column + static_cast<int>(std::lround(right_px)), 0, width - 1);
        const int y = std::clamp(row + static_cast<int>(std::lround(down_px)), 0, height - 1);
        ClassId label = frame.labels.at(x, y);
        if (label < kClassCount) {
          const double depth_m = static_cast<double>(frame.depth_m.at(x, y));
          const double world =
              depth_m > 0.0
                  ? world_field(noise_, rotation * (depth_m * camera.ray({x + 0.5, y + 0.5})) +
                                            enu_from_camera.translation_m)
                  : fields.at(fields.image_instead_of_world, 2.0 * kBlobPx, column, row);
          const double image = fields.at(fields.image, kBlobPx, column, row);
          if (world + image < std::numbers::sqrt2 * threshold_[label]) {
            const double choice = fields.at(fields.choice, kChoicePx, column, row);
            label = confused(kClassErrors[label], normal_share_below(choice));
          }
        }
        seen.at(column, row) = label;
      }
    }
  };
  parallel_for(static_cast<std::size_t>(height), 16, label_rows);
  return seen;
}

}  // namespace nadir
