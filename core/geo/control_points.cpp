// SPDX-License-Identifier: Apache-2.0
#include "core/geo/control_points.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <numeric>

#include "core/geo/similarity2.h"

namespace nadir {
namespace {

using Points = std::vector<ControlPoint>;

std::string label_of(std::span<const ControlPoint> points, std::size_t index) {
  const std::string& name = points[index].name;
  return name.empty() ? std::to_string(index + 1) : "'" + name + "'";
}

/// Rows of an image go down and north goes up: a similarity of the ground is one of the image mirrored once.
Result<Affine2> fit_similarity(std::span<const ControlPoint> points) {
  std::vector<Eigen::Vector2d> from, to;
  for (const ControlPoint& point : points) {
    from.emplace_back(point.in_pixels.x(), -point.in_pixels.y());
    to.push_back(point.in_enu_m);
  }
  const auto found = align_similarity2(from, to);
  if (!found) return fail(ErrorCode::kMalformed, "control points: all of them lie at one place");
  const double cosine = found->scale * std::cos(found->rigid.yaw_rad);
  const double sine = found->scale * std::sin(found->rigid.yaw_rad);
  Affine2 fit;
  fit.linear << cosine, sine, sine, -cosine;
  fit.offset = found->rigid.translation_m();
  return fit;
}

/// Points about their mean, so that coordinates of hundreds of kilometres cost no digits.
struct Centred {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> points;
};

Centred centred(std::span<const ControlPoint> points, Eigen::Vector2d ControlPoint::*which) {
  Centred result;
  for (const ControlPoint& point : points) result.mean += point.*which;
  result.mean /= static_cast<double>(points.size());
  for (const ControlPoint& point : points) result.points.emplace_back(point.*which - result.mean);
  return result;
}

/// Sum of the outer products of points that belong together.
Eigen::Matrix2d products(const Centred& a, const Centred& b) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < a.points.size(); ++i) sum += a.points[i] * b.points[i].transpose();
  return sum;
}

/// Whether clicks, which are some pixels off, do not tell how far points are from one line.
bool are_on_a_line(const Eigen::Matrix2d& squares) {
  constexpr double kThinnest = 0.01;  // of their length
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(squares, Eigen::EigenvaluesOnly);
  return !(axes.eigenvalues()(0) > kThinnest * kThinnest * axes.eigenvalues()(1));
}

Result<Affine2> fit_affine(std::span<const ControlPoint> points) {
  const Centred from = centred(points, &ControlPoint::in_pixels);
  const Centred to = centred(points, &ControlPoint::in_enu_m);
  const Eigen::Matrix2d squares = products(from, from);
  if (are_on_a_line(squares) || are_on_a_line(products(to, to))) {
    return fail(
        ErrorCode::kMalformed,
        "control points: they lie on a line, which leaves an affine fit open across it; add "
        "one beside it or fit a similarity");
  }
  // Normal equations, which points that are on no line leave well conditioned.
  Affine2 fit;
  fit.linear = products(to, from) * squares.inverse();
  fit.offset = to.mean - fit.linear * from.mean;
  return fit;
}

Result<Affine2> fit_model(std::span<const ControlPoint> points, ControlModel model) {
  return model == ControlModel::kSimilarity ? fit_similarity(points) : fit_affine(points);
}

Result<void> check(std::span<const ControlPoint> points, ControlModel model) {
  const int least = least_control_points(model);
  if (points.size() < static_cast<std::size_t>(least)) {
    return fail(ErrorCode::kMalformed, "control points: {} {} needs {} of them, there {} {}",
                model == ControlModel::kSimilarity ? "a" : "an",
                model == ControlModel::kSimilarity ? "similarity" : "affine fit", least,
                points.size() == 1 ? "is" : "are", points.size());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].in_pixels.allFinite() || !points[i].in_enu_m.allFinite()) {
      return fail(ErrorCode::kMalformed, "control point {}: has a coordinate that is no number",
                  label_of(points, i));
    }
  }
  return {};
}

/// Distance of a point to where the others alone put it.
std::optional<double> left_out_error_m(std::span<const ControlPoint> points,
                                       std::size_t index,
                                       ControlModel model) {
  if (points.size() <= static_cast<std::size_t>(least_control_points(model))) return std::nullopt;
  Points others(points.begin(), points.end());
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(index));
  const auto fit = fit_model(others, model);
  if (!fit) return std::nullopt;
  return (*fit * points[index].in_pixels - points[index].in_enu_m).norm();
}

double root_mean_square(const std::vector<double>& values) {
  const double sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

int least_control_points(ControlModel model) { return model == ControlModel::kSimilarity ? 2 : 3; }

Result<ControlFit> fit_control_points(std::span<const ControlPoint> points, ControlModel model) {
  if (auto checked = check(points, model); !checked) return forward_error(checked);
  auto found = fit_model(points, model);
  if (!found) return forward_error(found);
  if (found->linear.determinant() > 0.0) {
    return fail(ErrorCode::kMalformed,
                "control points: the image would have to be mirrored; are two of them swapped, or "
                "their rows counted from below?");
  }
  const auto pixels_from_enu = found->inverse();
  if (!pixels_from_enu) {
    return fail(ErrorCode::kMalformed, "control points: all of them lie at one place");
  }
  ControlFit fit{*found, {}, 0.0, 0.0, std::nullopt};
  std::vector<double> distances_m, distances_pixels, left_out_m;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ControlResidual residual;
    residual.in_m = *found * points[i].in_pixels - points[i].in_enu_m;
    residual.in_pixels = points[i].in_pixels - *pixels_from_enu * points[i].in_enu_m;
    residual.left_out_m = left_out_error_m(points, i, model);
    distances_m.push_back(residual.in_m.norm());
    distances_pixels.push_back(residual.in_pixels.norm());
    if (residual.left_out_m) left_out_m.push_back(*residual.left_out_m);
    fit.residuals.push_back(residual);
  }
  fit.rms_m = root_mean_square(distances_m);
  fit.rms_pixels = root_mean_square(distances_pixels);
  if (!left_out_m.empty()) fit.left_out_rms_m = root_mean_square(left_out_m);
  return fit;
}

Result<Affine2> scale_by_distance(const Eigen::Vector2d& from_in_pixels,
                                  const Eigen::Vector2d& to_in_pixels,
                                  double distance_m,
                                  const Eigen::Vector2d& origin_in_enu_m) {
  const double length_pixels = (to_in_pixels - from_in_pixels).norm();
  if (!(length_pixels >= 1.0) || !std::isfinite(length_pixels)) {
    return fail(ErrorCode::kInvalidOptions,
                "known distance: its ends are less than a pixel apart in the image");
  }
  if (!(distance_m > 0.0) || !std::isfinite(distance_m)) {
    return fail(ErrorCode::kInvalidOptions, "known distance: {} m is no distance", distance_m);
  }
  const double metres_per_pixel = distance_m / length_pixels;
  Affine2 fit;
  fit.linear << metres_per_pixel, 0.0, 0.0, -metres_per_pixel;
  fit.offset = origin_in_enu_m;
  return fit;
}

}  // namespace nadir
