// SPDX-License-Identifier: Apache-2.0
#include "core/session/place_hold.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/angle.h"

namespace nadir {
namespace {

constexpr double kEven = 1.5;  ///< Longer than wide by less has no direction.
constexpr std::array<const char*, 4> kAxes = {"north to south", "north-east to south-west",
                                              "east to west", "south-east to north-west"};

constexpr std::array<const char*, 8> kCompass = {"north", "north-east", "east", "south-east",
                                                 "south", "south-west", "west", "north-west"};
/// So many times what is alike is a slope: the place is not held at all.
constexpr double kSlope = 4.0;

struct Sample {
  int x, y;
};

/// Of a direction, clockwise from north, in [0, 360).
double bearing_of(double east, double north) {
  return std::fmod(Angle::radians(std::atan2(east, north)).degrees() + 360.0, 360.0);
}

/// The samples that hang together with the middle one and cost no more than that.
std::vector<Sample> samples_like_middle(const MomentSurface& surface, double more_cost) {
  const ErrorSurfaceGrid& grid = surface.volume.grid;
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.count_x) +
           static_cast<std::size_t>(x);
  };
  const Sample middle{grid.count_x / 2, grid.count_y / 2};
  const double most = surface.plane[index(middle.x, middle.y)] + more_cost;
  std::vector<bool> is_taken(surface.plane.size(), false);
  std::vector<Sample> found = {middle};
  is_taken[index(middle.x, middle.y)] = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Sample at = found[i];
    for (const Sample next : {Sample{at.x + 1, at.y}, Sample{at.x - 1, at.y},
                              Sample{at.x, at.y + 1}, Sample{at.x, at.y - 1}}) {
      const bool is_inside =
          next.x >= 0 && next.y >= 0 && next.x < grid.count_x && next.y < grid.count_y;
      if (!is_inside || is_taken[index(next.x, next.y)]) continue;
      if (surface.plane[index(next.x, next.y)] > most) continue;
      is_taken[index(next.x, next.y)] = true;
      found.push_back(next);
    }
  }
  return found;
}

/// The cheapest place among samples, of which the middle is the first, and how much cheaper than the middle it is.
void find_best(const std::vector<Sample>& samples, const MomentSurface& surface, PlaceHold& hold) {
  const ErrorSurfaceGrid& grid = surface.volume.grid;
  const auto cost_at = [&](const Sample& at) {
    return surface.plane[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(grid.count_x) +
                         static_cast<std::size_t>(at.x)];
  };
  const Sample middle = samples.front();
  const auto squared_way = [&](const Sample& at) {
    const int dx = at.x - middle.x, dy = at.y - middle.y;
    return dx * dx + dy * dy;
  };
  const Sample best =
      *std::min_element(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
        return std::pair(cost_at(a), squared_way(a)) < std::pair(cost_at(b), squared_way(b));
      });
  hold.falls_by = static_cast<double>(cost_at(middle) - cost_at(best));
  hold.best_m = std::sqrt(squared_way(best)) * grid.step_m;
  hold.best_bearing_deg = bearing_of(best.x - middle.x, best.y - middle.y);
}

struct Reach {
  double length_m = 0.0;
  bool is_open = false;
};

/// How far samples reach along an axis, and whether the outermost ones lie on the border.
Reach reach_along(const std::vector<Sample>& samples,
                  const ErrorSurfaceGrid& grid,
                  const Eigen::Vector2d& axis) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  bool is_least_open = false, is_most_open = false;
  for (const Sample& one : samples) {
    const double at = axis.dot(Eigen::Vector2d(one.x, one.y));
    const bool is_border =
        one.x == 0 || one.y == 0 || one.x == grid.count_x - 1 || one.y == grid.count_y - 1;
    if (at < least) is_least_open = is_border;
    if (at > most) is_most_open = is_border;
    least = std::min(least, at);
    most = std::max(most, at);
  }
  return {(most - least + 1.0) * grid.step_m, is_least_open || is_most_open};
}

std::string reach_text(double length_m, bool is_open) {
  return fmt::format("{}{:.{}f} m", is_open ? "more than " : "", length_m, length_m < 10.0 ? 1 : 0);
}

/// ", across the heading", where so.
std::string against_heading(double bearing_deg, double yaw_rad) {
  constexpr double kNear = 22.5;
  const double heading_deg = 90.0 - Angle::radians(yaw_rad).degrees();
  const double apart = std::abs(std::remainder(bearing_deg - heading_deg, 180.0));
  if (apart <= kNear) return ", along the heading";
  return apart >= 90.0 - kNear ? ", across the heading" : "";
}

}  // namespace

PlaceHold place_hold(const MomentSurface& surface, double more_cost) {
  const std::vector<Sample> samples = samples_like_middle(surface, more_cost);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Sample& one : samples) mean += Eigen::Vector2d(one.x, one.y);
  mean /= static_cast<double>(samples.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Sample& one : samples) {
    const Eigen::Vector2d from_mean = Eigen::Vector2d(one.x, one.y) - mean;
    spread += from_mean * from_mean.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(spread);
  Eigen::Vector2d long_axis = axes.eigenvectors().col(1);
  Eigen::Vector2d short_axis = axes.eigenvectors().col(0);
  const ErrorSurfaceGrid& grid = surface.volume.grid;
  Reach along = reach_along(samples, grid, long_axis);
  Reach across = reach_along(samples, grid, short_axis);
  if (across.length_m > along.length_m) {  // a crooked valley
    std::swap(along, across);
    std::swap(long_axis, short_axis);
  }
  PlaceHold hold;
  hold.more_cost = more_cost;
  hold.along_m = along.length_m;
  hold.across_m = across.length_m;
  hold.is_along_open = along.is_open;
  hold.is_across_open = across.is_open;
  hold.bearing_deg = std::fmod(bearing_of(long_axis.x(), long_axis.y()), 180.0);
  find_best(samples, surface, hold);
  return hold;
}

std::string in_words(const PlaceHold& hold, double yaw_rad) {
  const std::string rises = fmt::format("the cost rises by at most {:g} over", hold.more_cost);
  if (hold.falls_by > kSlope * hold.more_cost) {
    const auto towards = static_cast<std::size_t>(std::lround(hold.best_bearing_deg / 45.0));
    return fmt::format(
        "The place is not held: the cost falls by {:.{}f} towards a place {} {} of it.",
        hold.falls_by, hold.falls_by < 0.095 ? 3 : 2, reach_text(hold.best_m, false),
        kCompass.at(towards % kCompass.size()));
  }
  const std::string along = reach_text(hold.along_m, hold.is_along_open);
  const bool is_poor = hold.is_along_open || hold.along_m >= ExplanationRules{}.near_m;
  if (hold.along_m < kEven * hold.across_m) {
    return fmt::format("The place is held {} in every direction: {} {}.",
                       is_poor ? "poorly" : "well", rises, along);
  }
  const auto axis = static_cast<std::size_t>(std::lround(hold.bearing_deg / 45.0)) % kAxes.size();
  const std::string across = reach_text(hold.across_m, hold.is_across_open);
  if (!is_poor) {
    return fmt::format("The place is held well: {} {} {} and {} across that.", rises, along,
                       kAxes.at(axis), across);
  }
  return fmt::format("The place is held poorly {}{}: {} {} that way, {} across it.", kAxes.at(axis),
                     against_heading(hold.bearing_deg, yaw_rad), rises, along, across);
}

}  // namespace nadir
