// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geo/affine2.h"

/// Where an image without a reference lies, from points that somebody knows in both.
namespace nadir {

/// The same thing on the ground and in the image.
struct ControlPoint {
  Eigen::Vector2d in_pixels =
      Eigen::Vector2d::Zero();  ///< (column, row) from the upper-left corner; a click is at + 0.5.
  Eigen::Vector2d in_enu_m = Eigen::Vector2d::Zero();  ///< On the project plane, east and north.
  std::string name;                                    ///< For messages; may be empty.
};

/// What an image may have done to the ground. The thesis's overheads are similarities; an affine one also takes up a tilted
/// camera over flat ground, or pixels that are not square.
enum class ControlModel {
  kSimilarity,  ///< Shift, rotation, one scale: two points and more. Never mirrored.
  kAffine,      ///< Also shear and two scales: three points and more, not on a line.
};
[[nodiscard]] int least_control_points(ControlModel model);

/// How far one point is from where the others and itself have put it.
struct ControlResidual {
  Eigen::Vector2d in_m =
      Eigen::Vector2d::Zero();  ///< East and north: where it was put minus where it is.
  Eigen::Vector2d in_pixels = Eigen::Vector2d::
      Zero();  ///< Columns and rows: where it is seen from where it should be seen.
  /// Distance to where the *others* alone would have put it. Nothing where they do not determine a place.
  std::optional<double> left_out_m;
};

struct ControlFit {
  Affine2 enu_from_pixels;
  std::vector<ControlResidual> residuals;  ///< As many as points, in their order.
  double rms_m = 0.0, rms_pixels = 0.0;    ///< Root mean square distance of the residuals.
  /// Of left_out_m: what a new point may expect. Nothing where there are no more points than the model needs: then the
  /// residuals are zero whatever was clicked, and prove nothing.
  std::optional<double> left_out_rms_m;
};

/// The least-squares fit of the model, errors taken on the ground. O(points^2) for the left-out errors.
/// @errors kMalformed, one sentence: too few points for the model, points that are not finite, all at one place or (affine)
/// on a line in the image or on the ground, a mirrored image where the fit comes out as one.
[[nodiscard]] Result<ControlFit> fit_control_points(std::span<const ControlPoint> points,
                                                    ControlModel model);

/// The scale of an image in which a known distance was clicked, north up and square pixels.
/// @param from_in_pixels, to_in_pixels  Ends of it.
/// @param origin_in_enu_m               Where the image's upper-left corner is put.
/// @errors kInvalidOptions: the ends are less than a pixel apart; a distance that is not positive and finite.
[[nodiscard]] Result<Affine2> scale_by_distance(const Eigen::Vector2d& from_in_pixels,
                                                const Eigen::Vector2d& to_in_pixels,
                                                double distance_m,
                                                const Eigen::Vector2d& origin_in_enu_m);

}  // namespace nadir
