// SPDX-License-Identifier: Apache-2.0
#include "core/topview/semantic_topview.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr auto kClasses = static_cast<std::size_t>(kClassCount);

/// Square cells around the body; `first` is the smallest index that occurs and `count` how many
/// follow.
struct CellRange {
  int first = std::numeric_limits<int>::max();
  int last = std::numeric_limits<int>::min();

  void include(int index) {
    first = std::min(first, index);
    last = std::max(last, index);
  }
  [[nodiscard]] std::size_t count() const {
    return last < first ? 0 : static_cast<std::size_t>(last - first) + 1;
  }
  [[nodiscard]] std::size_t offset(int index) const {
    return static_cast<std::size_t>(index - first);
  }
};

struct Vote {
  std::int16_t forward, left;
  ClassId label;
};

/// Votes per class of every cell that has any. A cell of the rectangle that the points span costs
/// four bytes, an occupied one a counter a class, so that a wide range with few points stays small.
class Ballot {
 public:
  explicit Ballot(const std::vector<Vote>& votes) {
    for (const Vote& vote : votes) {
      forward_.include(vote.forward);
      left_.include(vote.left);
    }
    box_of_cell_.assign(forward_.count() * left_.count(), kNoBox);
    for (const Vote& vote : votes) {
      std::uint32_t& box =
          box_of_cell_[forward_.offset(vote.forward) * left_.count() + left_.offset(vote.left)];
      if (box == kNoBox) {
        box = static_cast<std::uint32_t>(boxes_.size());
        boxes_.emplace_back();
      }
      ++boxes_[box][vote.label];
    }
  }

  /// Winning class of each occupied cell, grouped by class.
  [[nodiscard]] SemanticTopview decide(const std::array<double, kClasses>& vote_of_class,
                                       double min_votes) const {
    std::array<std::vector<TopviewCell>, kClasses> cells;
    for (std::size_t i = 0; i < box_of_cell_.size(); ++i) {
      if (box_of_cell_[i] == kNoBox) continue;
      const Box& box = boxes_[box_of_cell_[i]];
      std::size_t winner = 0;
      double most = 0.0;
      for (std::size_t k = 0; k < kClasses; ++k) {
        const double votes = box[k] * vote_of_class[k];
        if (votes > most) {
          most = votes;
          winner = k;
        }
      }
      if (most <= 0.0 || most < min_votes) continue;
      cells[winner].push_back(
          {static_cast<std::int16_t>(forward_.first + static_cast<int>(i / left_.count())),
           static_cast<std::int16_t>(left_.first + static_cast<int>(i % left_.count()))});
    }
    SemanticTopview topview;
    for (std::size_t k = 0; k < kClasses; ++k) {
      topview.class_begin[k] = static_cast<std::uint32_t>(topview.cells.size());
      topview.cells.insert(topview.cells.end(), cells[k].begin(), cells[k].end());
    }
    topview.class_begin[kClasses] = static_cast<std::uint32_t>(topview.cells.size());
    return topview;
  }

 private:
  using Box = std::array<std::uint32_t, kClasses>;
  static constexpr std::uint32_t kNoBox = std::numeric_limits<std::uint32_t>::max();
  CellRange forward_, left_;
  std::vector<std::uint32_t> box_of_cell_;
  std::vector<Box> boxes_;
};

std::array<double, kClasses> votes_of_classes(const TopviewOptions& options) {
  std::array<double, kClasses> votes;
  votes.fill(1.0);
  votes[kLaneMarking] = options.lane_marking_vote;
  votes[kCurb] = options.curb_vote;
  return votes;
}

}  // namespace

Result<SemanticTopview> build_semantic_topview(const SemanticCloud& cloud,
                                               double metres_per_cell,
                                               const TopviewOptions& options) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  NADIR_REQUIRE(cloud.points_in_level_m.size() == cloud.labels.size());
  if (!(metres_per_cell > 0.0) || options.max_range_m / metres_per_cell > kMaxTopviewReachCells) {
    return fail(ErrorCode::kInvalidOptions, "topview: {} m per cell does not fit a range of {} m",
                metres_per_cell, options.max_range_m);
  }
  const auto cells_per_metre = static_cast<float>(1.0 / metres_per_cell);
  const auto squared_range = static_cast<float>(options.max_range_m * options.max_range_m);
  std::vector<Vote> votes;
  votes.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& point = cloud.points_in_level_m[i];
    const float squared_distance = point.x() * point.x() + point.y() * point.y();
    if (!(squared_distance <= squared_range) || !can_lie_in_overhead(cloud.labels[i])) continue;
    votes.push_back({static_cast<std::int16_t>(std::floor(point.x() * cells_per_metre)),
                     static_cast<std::int16_t>(std::floor(point.y() * cells_per_metre)),
                     cloud.labels[i]});
  }
  SemanticTopview topview = Ballot(votes).decide(votes_of_classes(options), options.min_votes);
  topview.metres_per_cell = metres_per_cell;
  return topview;
}

TopviewRaster topview_raster(const SemanticTopview& topview) {
  CellRange forward;
  CellRange left;
  for (const TopviewCell& cell : topview.cells) {
    forward.include(cell.forward);
    left.include(cell.left);
  }
  if (topview.cells.empty()) return {};
  TopviewRaster raster;
  raster.labels = Raster<ClassId>(static_cast<int>(left.count()), static_cast<int>(forward.count()),
                                  kUnclassified);
  raster.body_column = left.last + 1;
  raster.body_row = forward.last + 1;
  for (ClassId id = 0; id < kClassCount; ++id) {
    for (const TopviewCell& cell : topview.of_class(id)) {
      raster.labels.at(raster.body_column - 1 - cell.left, raster.body_row - 1 - cell.forward) = id;
    }
  }
  return raster;
}

SemanticTopview topview_from_raster(const TopviewRaster& raster, double metres_per_cell) {
  std::vector<Vote> votes;
  for (int row = 0; row < raster.labels.height(); ++row) {
    for (int column = 0; column < raster.labels.width(); ++column) {
      const ClassId id = raster.labels.at(column, row);
      if (id >= kClassCount) continue;
      votes.push_back({static_cast<std::int16_t>(raster.body_row - 1 - row),
                       static_cast<std::int16_t>(raster.body_column - 1 - column), id});
    }
  }
  std::array<double, kClasses> equal;
  equal.fill(1.0);
  SemanticTopview topview = Ballot(votes).decide(equal, 1.0);
  topview.metres_per_cell = metres_per_cell;
  return topview;
}

}  // namespace nadir
