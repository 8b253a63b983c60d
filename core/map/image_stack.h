// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/geo/control_points.h"
#include "core/map/image_look.h"
#include "core/map/overhead_image.h"

namespace nadir {

/// A distance on the ground that somebody knows, in an image without reference.
struct KnownDistance {
  Eigen::Vector2d from_in_pixels = Eigen::Vector2d::Zero();  ///< As ControlPoint::in_pixels.
  Eigen::Vector2d to_in_pixels = Eigen::Vector2d::Zero();
  double distance_m = 0.0;
  Eigen::Vector2d origin_in_enu_m = Eigen::Vector2d::Zero();  ///< Of the image's upper-left corner.
};

/// An image beneath the labels: which, where, and how it is shown.
struct StackedImage {
  std::string name;            ///< For people: "2019", "infrared".
  std::filesystem::path path;  ///< Absolute, or from where the program runs.
  std::string crs;             ///< As ImageOptions::crs.
  /// What places it in place of its own reference: points, or else a distance, or else nothing.
  std::vector<ControlPoint> control_points;
  ControlModel control_model = ControlModel::kSimilarity;
  std::optional<KnownDistance> known_distance;
  /// How far the imagery is off, east and north, whatever places it: its own reference stays as it is.
  Eigen::Vector2d offset_in_enu_m = Eigen::Vector2d::Zero();
  ImageLook look;
};

/// Several images of one place, to switch between or to blend: dates, infrared. A plain value, kept beside the labels.
struct ImageStack {
  std::vector<StackedImage> images;  ///< The lowest first.
};

/// How an image is to be opened on a plane. @errors those of control points and distances, within the image's name.
[[nodiscard]] Result<ImageOptions> options_of(const StackedImage& image,
                                              const ProjectPlane& plane,
                                              const std::filesystem::path& cache);

/// TOML. Paths are written as seen from `folder`, the map's, so that both can be moved together.
[[nodiscard]] std::string image_stack_text(const ImageStack& stack,
                                           const std::filesystem::path& folder);
/// @param name  Stands for the text in messages. @errors kMalformed.
[[nodiscard]] Result<ImageStack> parse_image_stack(std::string_view text,
                                                   const std::filesystem::path& folder,
                                                   const std::string& name);

}  // namespace nadir
