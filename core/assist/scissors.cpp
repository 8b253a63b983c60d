// SPDX-License-Identifier: Apache-2.0
#include "core/assist/scissors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/segmentation.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/require.h"

namespace nadir {
namespace {

/// How fast colours change, per pixel in 255ths, and the way across the edge.
struct EdgeField {
  cv::Mat strength;   ///< CV_32F.
  cv::Mat direction;  ///< CV_32FC2, of length 1, or 0 where nothing changes.
};

cv::Mat colours_of(const ImageRaster& pixels) {
  cv::Mat colours(pixels.height(), pixels.width(), CV_8UC3);
  for (int row = 0; row < pixels.height(); ++row) {
    for (int column = 0; column < pixels.width(); ++column) {
      const ImagePixel& pixel = pixels.at(column, row);
      colours.at<cv::Vec3b>(row, column) = {pixel.blue, pixel.green, pixel.red};
    }
  }
  return colours;
}

/// Of the channel that changes most, after a blur by a pixel, which makes one rounded peak of an edge.
EdgeField edges_of(const cv::Mat& colours) {
  cv::Mat blurred, across, down;
  colours.convertTo(blurred, CV_32F);
  cv::GaussianBlur(blurred, blurred, {}, 1.0, 1.0, cv::BORDER_REPLICATE);
  cv::Sobel(blurred, across, CV_32F, 1, 0, 3, 0.125, 0.0, cv::BORDER_REPLICATE);
  cv::Sobel(blurred, down, CV_32F, 0, 1, 3, 0.125, 0.0, cv::BORDER_REPLICATE);
  EdgeField edges{cv::Mat(colours.size(), CV_32F), cv::Mat(colours.size(), CV_32FC2)};
  for (int row = 0; row < colours.rows; ++row) {
    for (int column = 0; column < colours.cols; ++column) {
      cv::Vec2f most(0.0F, 0.0F);
      float length = 0.0F;
      for (int channel = 0; channel < 3; ++channel) {
        const cv::Vec2f gradient(across.at<cv::Vec3f>(row, column)[channel],
                                 down.at<cv::Vec3f>(row, column)[channel]);
        const float norm = std::sqrt(gradient.dot(gradient));
        if (norm <= length) continue;
        most = gradient;
        length = norm;
      }
      edges.strength.at<float>(row, column) = length;
      edges.direction.at<cv::Vec2f>(row, column) = length > 0.0F ? most / length : most;
    }
  }
  return edges;
}

/// Between the centres of pixels; beyond the outermost as there. @param at  From the corner of the image.
double strength_at(const cv::Mat& strength, const Eigen::Vector2d& at) {
  const double x = std::clamp(at.x() - 0.5, 0.0, strength.cols - 1.0);
  const double y = std::clamp(at.y() - 0.5, 0.0, strength.rows - 1.0);
  const int column = std::min(static_cast<int>(x), std::max(0, strength.cols - 2));
  const int row = std::min(static_cast<int>(y), std::max(0, strength.rows - 2));
  const int right = std::min(column + 1, strength.cols - 1);
  const int below = std::min(row + 1, strength.rows - 1);
  const double u = x - column;
  const double v = y - row;
  const auto value = [&](int r, int c) { return static_cast<double>(strength.at<float>(r, c)); };
  return (1.0 - v) * ((1.0 - u) * value(row, column) + u * value(row, right)) +
         v * ((1.0 - u) * value(below, column) + u * value(below, right));
}

/// The place on the edge nearest to the centre of a pixel: where across the edge the change is fastest. A blurred step changes
/// as a Gaussian, whose logarithm is the parabola that goes through three samples.
Eigen::Vector2d on_edge(const EdgeField& edges, const cv::Point& pixel) {
  Eigen::Vector2d centre(pixel.x + 0.5, pixel.y + 0.5);
  const auto& across = edges.direction.at<cv::Vec2f>(pixel);
  const Eigen::Vector2d way(across[0], across[1]);
  constexpr int kReach = 2;
  std::array<double, 2 * kReach + 1> found{};
  for (int i = -kReach; i <= kReach; ++i) {
    found.at(static_cast<std::size_t>(std::ptrdiff_t{i} + kReach)) =
        std::log(std::max(1e-6, strength_at(edges.strength, centre + way * i)));
  }
  const auto best = std::max_element(found.begin(), found.end());
  // A peak at the end belongs to another edge.
  if (best == found.begin() || best == found.end() - 1) return centre;
  const double before = *(best - 1);
  const double after = *(best + 1);
  const double bend = before - 2.0 * *best + after;
  const double beside = bend < 0.0 ? 0.5 * (before - after) / bend : 0.0;
  return centre + way * (static_cast<double>(best - found.begin()) - kReach + beside);
}

}  // namespace

struct Scissors::Parts {
  ScissorsOptions options;
  Affine2 enu_from_pixels, pixels_from_enu;
  EdgeField edges;
  cv::segmentation::IntelligentScissorsMB ways;
  std::optional<Eigen::Vector2d> start_in_enu_m;

  [[nodiscard]] std::optional<cv::Point> pixel_at(const Eigen::Vector2d& point_in_enu_m) const {
    const Eigen::Vector2d at = pixels_from_enu * point_in_enu_m;
    // Written so that NaN is outside.
    if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < edges.strength.cols &&
          at.y() < edges.strength.rows)) {
      return std::nullopt;
    }
    return cv::Point(static_cast<int>(at.x()), static_cast<int>(at.y()));
  }
};

Scissors::Scissors(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Scissors::Scissors(Scissors&&) noexcept = default;
Scissors& Scissors::operator=(Scissors&&) noexcept = default;
Scissors::~Scissors() = default;

Result<Scissors> Scissors::create(const AssistWindow& window, const ScissorsOptions& options) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  auto parts = std::make_unique<Parts>();
  parts->options = options;
  parts->enu_from_pixels = window.enu_from_pixels();
  parts->pixels_from_enu = window.pixels_from_enu();
  const cv::Mat colours = colours_of(window.pixels());
  EdgeField& edges = parts->edges;
  edges = edges_of(colours);
  double most = 0.0;
  cv::minMaxLoc(edges.strength, nullptr, &most);
  cv::Mat weakness;
  edges.strength.convertTo(weakness, CV_32F, most > 0.0 ? -1.0 / most : 0.0, 1.0);
  // Rounding below 0 would be a way that pays, on which OpenCV walks in circles; and what is free has no shortest way.
  weakness = cv::max(weakness, 0.01F);
  // Canny's gradients are four times a step, half of which may continue an edge.
  parts->ways.setEdgeFeatureCannyParameters(2.0 * options.least_edge, 4.0 * options.least_edge);
  parts->ways.applyImageFeatures(cv::noArray(), edges.direction, weakness, colours);
  return Scissors(std::move(parts));
}

Eigen::Vector2d Scissors::snapped(const Eigen::Vector2d& point_in_enu_m) const {
  const auto middle = parts_->pixel_at(point_in_enu_m);
  if (!middle) return point_in_enu_m;
  const cv::Mat& strength = parts_->edges.strength;
  const double reach = parts_->options.snap_px;
  const int side = static_cast<int>(reach);
  // A blurred step of height 1 changes by 0.4 a pixel at most.
  auto most = static_cast<float>(0.35 * parts_->options.least_edge);
  std::optional<cv::Point> best;
  for (int y = std::max(0, middle->y - side); y <= std::min(strength.rows - 1, middle->y + side);
       ++y) {
    for (int x = std::max(0, middle->x - side); x <= std::min(strength.cols - 1, middle->x + side);
         ++x) {
      const bool is_near = std::hypot(x - middle->x, y - middle->y) <= reach;
      if (!is_near || !(strength.at<float>(y, x) > most)) continue;
      most = strength.at<float>(y, x);
      best = cv::Point(x, y);
    }
  }
  if (!best || reach == 0.0) return point_in_enu_m;
  return parts_->enu_from_pixels * on_edge(parts_->edges, *best);
}

Result<void> Scissors::begin_at(const Eigen::Vector2d& point_in_enu_m) {
  const auto pixel = parts_->pixel_at(point_in_enu_m);
  if (!pixel) {
    return fail(ErrorCode::kInvalidOptions, "the place is outside of what is looked at");
  }
  parts_->ways.buildMap(*pixel);
  parts_->start_in_enu_m = point_in_enu_m;
  return {};
}

Result<Ring> Scissors::line_to(const Eigen::Vector2d& point_in_enu_m) const {
  NADIR_REQUIRE(parts_->start_in_enu_m.has_value());
  const auto pixel = parts_->pixel_at(point_in_enu_m);
  if (!pixel) {
    return fail(ErrorCode::kInvalidOptions, "the place is outside of what is looked at");
  }
  std::vector<cv::Point> way;
  parts_->ways.getContour(*pixel, way);
  const Eigen::Vector2d start = parts_->pixels_from_enu * *parts_->start_in_enu_m;
  const Eigen::Vector2d end = parts_->pixels_from_enu * point_in_enu_m;
  const auto in_float = [](const Eigen::Vector2d& place) {
    return cv::Point2f(static_cast<float>(place.x()), static_cast<float>(place.y()));
  };
  // Both ends are where they were asked for, not in the middle of their pixels.
  std::vector<cv::Point2f> places{in_float(start)};
  places.reserve(way.size() + 2);
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    places.push_back(in_float(on_edge(parts_->edges, way[i])));
  }
  places.push_back(in_float(end));
  std::vector<cv::Point2f> kept;
  cv::approxPolyDP(places, kept, parts_->options.simplify_px, false);
  Ring line{*parts_->start_in_enu_m};
  line.reserve(kept.size() + 1);
  for (std::size_t i = 1; i + 1 < kept.size(); ++i) {
    const Eigen::Vector2d place(kept[i].x, kept[i].y);
    line.push_back(parts_->enu_from_pixels * place);
  }
  line.push_back(point_in_enu_m);
  return line;
}

}  // namespace nadir
