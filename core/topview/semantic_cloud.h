// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/map/semantic_classes.h"
#include "core/topview/camera_model.h"

namespace nadir {

/// Labelled points in `level` (x forward, y left, z up from the body), metres. Element i of every
/// array is point i.
struct SemanticCloud {
  std::vector<Eigen::Vector3f> points_in_level_m;
  std::vector<ClassId> labels;

  [[nodiscard]] std::size_t size() const { return labels.size(); }
  friend bool operator==(const SemanticCloud&, const SemanticCloud&) = default;
};

/// Back-projects every pixel with depth (thesis equation 3.2) and levels the points.
///
/// @param labels            Class ids, of the camera's size.
/// @param depth_m           Along the optical axis, of the camera's size; 0, negative, NaN and
/// infinite mean "none" and are
///                          left out pixel by pixel, as are depths beyond `max_depth_m`.
/// @param level_from_camera Camera to body, then roll and pitch taken out: the thesis assumes a
/// level camera, a real one tilts.
/// @param every_nth_pixel   1 takes every pixel, 2 every second of every second row.
/// @errors kMalformed: labels, depth and camera differ in size.
[[nodiscard]] Result<SemanticCloud> build_semantic_cloud(const Raster<ClassId>& labels,
                                                         const Raster<float>& depth_m,
                                                         const CameraModel& camera,
                                                         const Eigen::Isometry3d& level_from_camera,
                                                         double max_depth_m,
                                                         int every_nth_pixel = 1);

}  // namespace nadir
