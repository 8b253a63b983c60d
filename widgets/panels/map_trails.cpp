// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_trails.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nadir {
namespace {

constexpr double kTrailTolerancePx = 1.0 / 3.0;
constexpr double kBesidePagePx = 24.0;  ///< Farther out no line's width, casing or corner is seen.

double cross_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Takes points one by one and keeps those that a line needs: as long as one direction from the last kept point passes all
/// others within the tolerance, and they go away from it, they are on one straight line.
class Straightener {
 public:
  explicit Straightener(std::vector<ScreenPath>& made) : made_(made) {}

  void add(const Eigen::Vector2d& point) {
    if (piece_.empty()) {
      begin(point);
    } else if (!reaches(point)) {
      piece_.push_back(last_);
      begin_from_last();
      (void)reaches(point);
    }
  }
  void finish() {
    if (!piece_.empty() && (last_ != piece_.back() || piece_.size() == 1)) piece_.push_back(last_);
    if (piece_.size() > 1 && !(piece_.size() == 2 && piece_[0] == piece_[1])) {
      made_.push_back(std::move(piece_));
    }
    piece_.clear();
  }

 private:
  void begin(const Eigen::Vector2d& point) {
    piece_.push_back(point);
    last_ = point;
    begin_from_last();
  }
  void begin_from_last() {
    anchor_ = last_;
    has_wedge_ = false;
    reach_ = 0.0;
  }
  /// Whether the line from the anchor to this point passes all in between; then it is the last one.
  bool reaches(const Eigen::Vector2d& point) {
    const Eigen::Vector2d way = point - anchor_;
    const double distance = way.norm();
    if (distance + kTrailTolerancePx < reach_) return false;  // turned back
    if (distance > kTrailTolerancePx) {
      if (has_wedge_ && (cross_of(right_, way) < 0.0 || cross_of(way, left_) < 0.0)) return false;
      narrow(way / distance, kTrailTolerancePx / distance);
    }
    reach_ = std::max(reach_, distance);
    last_ = point;
    return true;
  }
  void narrow(const Eigen::Vector2d& direction, double sine) {
    const double cosine = std::sqrt(1.0 - sine * sine);
    const Eigen::Vector2d across(-direction.y(), direction.x());
    const Eigen::Vector2d left = cosine * direction + sine * across;
    const Eigen::Vector2d right = cosine * direction - sine * across;
    if (!has_wedge_ || cross_of(left, left_) > 0.0) left_ = left;
    if (!has_wedge_ || cross_of(right_, right) > 0.0) right_ = right;
    has_wedge_ = true;
  }

  std::vector<ScreenPath>& made_;
  ScreenPath piece_;
  Eigen::Vector2d anchor_ = Eigen::Vector2d::Zero(), last_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d left_ = Eigen::Vector2d::Zero(), right_ = Eigen::Vector2d::Zero();
  bool has_wedge_ = false;
  double reach_ = 0.0;
};

/// Sides of a rectangle that a point lies beyond, as bits.
unsigned sides_beyond(const Eigen::Vector2d& point, const PageRect& page) {
  return (point.x() < page.left ? 1U : 0U) | (point.x() > page.right() ? 2U : 0U) |
         (point.y() < page.bottom ? 4U : 0U) | (point.y() > page.top() ? 8U : 0U);
}

}  // namespace

RunPaths RunPaths::of(const std::shared_ptr<const RunDocument>& document) {
  const Eigen::Vector2d unknown =
      Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  RunPaths made;
  made.document = document;
  for (const RunStep& step : document->steps) {
    made.truth.push_back(step.truth_in_enu ? step.truth_in_enu->translation_m() : unknown);
    made.odometry.push_back(step.odometry_in_enu ? step.odometry_in_enu->translation_m() : unknown);
    made.estimate.push_back(step.estimate.moments.mean.translation_m());
  }
  return made;
}

const RunPaths& RunPathsCache::of(const std::shared_ptr<const RunDocument>& document) {
  for (const auto& paths : paths_) {
    if (paths->document == document) return *paths;
  }
  paths_.push_back(std::make_unique<RunPaths>(RunPaths::of(document)));
  return *paths_.back();
}

void RunPathsCache::keep_only(std::span<const std::shared_ptr<const RunDocument>> documents) {
  std::erase_if(paths_, [&](const auto& paths) {
    return std::find(documents.begin(), documents.end(), paths->document) == documents.end();
  });
}

std::vector<ScreenPath> screen_paths(std::span<const Eigen::Vector2d> points_in_enu_m,
                                     const MapCamera& camera,
                                     const PageRect& where) {
  // What MapCamera::page_from_enu does, with sine and cosine taken once.
  const double angle = std::numbers::pi / 2.0 - camera.up_rad;
  const double c = std::cos(angle) / camera.metres_per_px;
  const double s = std::sin(angle) / camera.metres_per_px;
  const Eigen::Vector2d middle = where.centre();
  const PageRect seen{where.left - kBesidePagePx, where.bottom - kBesidePagePx,
                      where.width + 2.0 * kBesidePagePx, where.height + 2.0 * kBesidePagePx};
  std::vector<ScreenPath> made;
  Straightener straightener(made);
  Eigen::Vector2d before = Eigen::Vector2d::Zero();
  unsigned before_beyond = 0;
  bool has_before = false;
  bool is_before_in = false;
  for (const Eigen::Vector2d& point : points_in_enu_m) {
    if (!point.allFinite()) {
      straightener.finish();
      has_before = is_before_in = false;
      continue;
    }
    const double east = point.x() - camera.centre_in_enu_m.x();
    const double north = point.y() - camera.centre_in_enu_m.y();
    const Eigen::Vector2d at(middle.x() + c * east - s * north, middle.y() + s * east + c * north);
    const unsigned beyond = sides_beyond(at, seen);
    if (has_before) {
      if ((beyond & before_beyond) != 0) {  // this stretch cannot be seen
        straightener.finish();
        is_before_in = false;
      } else {
        if (!is_before_in) straightener.add(before);
        straightener.add(at);
        is_before_in = true;
      }
    }
    before = at;
    has_before = true;
    before_beyond = beyond;
  }
  straightener.finish();
  return made;
}

void stroke_paths(Canvas& canvas,
                  std::span<const ScreenPath> paths,
                  const PathLook& look,
                  double px_per_pt) {
  if (look.casing.alpha > 0) {
    const StrokeStyle casing{look.casing, (look.width_pt + 2.0 * look.casing_pt) * px_per_pt};
    for (const ScreenPath& path : paths) canvas.stroke(path, casing);
  }
  StrokeStyle line{look.colour, look.width_pt * px_per_pt};
  if (look.is_dashed) line.dashes_px = {4.0 * line.width_px, 2.5 * line.width_px};
  for (const ScreenPath& path : paths) canvas.stroke(path, line);
}

}  // namespace nadir
