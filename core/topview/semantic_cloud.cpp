// SPDX-License-Identifier: Apache-2.0
#include "core/topview/semantic_cloud.h"

#include <cmath>

#include "core/base/require.h"

namespace nadir {
namespace {

template <typename T>
Result<void> check_size(const char* what, const Raster<T>& raster, const CameraModel& camera) {
  if (raster.width() == camera.width && raster.height() == camera.height) return {};
  return fail(ErrorCode::kMalformed, "{}: {} x {} pixels, but the camera has {} x {}", what,
              raster.width(), raster.height(), camera.width, camera.height);
}

}  // namespace

Result<SemanticCloud> build_semantic_cloud(const Raster<ClassId>& labels,
                                           const Raster<float>& depth_m,
                                           const CameraModel& camera,
                                           const Eigen::Isometry3d& level_from_camera,
                                           double max_depth_m,
                                           int every_nth_pixel) {
  NADIR_REQUIRE(every_nth_pixel >= 1);
  if (const auto size = check_size("labels", labels, camera); !size) return forward_error(size);
  if (const auto size = check_size("depth", depth_m, camera); !size) return forward_error(size);

  const Eigen::Matrix3f rotation = level_from_camera.linear().cast<float>();
  const Eigen::Vector3f translation_m = level_from_camera.translation().cast<float>();
  const auto farthest_m = static_cast<float>(max_depth_m);

  SemanticCloud cloud;
  const std::size_t expected =
      labels.size() / static_cast<std::size_t>(every_nth_pixel * every_nth_pixel);
  cloud.points_in_level_m.reserve(expected);
  cloud.labels.reserve(expected);
  for (int row = 0; row < labels.height(); row += every_nth_pixel) {
    const auto row_labels = labels.row(row);
    const auto row_depth_m = depth_m.row(row);
    for (int column = 0; column < labels.width(); column += every_nth_pixel) {
      const float depth = row_depth_m[static_cast<std::size_t>(column)];
      if (!(depth > 0.0F && depth <= farthest_m)) continue;  // refuses NaN and infinity too
      const Eigen::Vector3f ray = camera.ray({column + 0.5, row + 0.5}).cast<float>();
      cloud.points_in_level_m.emplace_back(rotation * (depth * ray) + translation_m);
      cloud.labels.push_back(row_labels[static_cast<std::size_t>(column)]);
    }
  }
  return cloud;
}

}  // namespace nadir
