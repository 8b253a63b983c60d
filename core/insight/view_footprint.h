// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "core/label/label_grid.h"
#include "core/mcl/cost_kernel.h"
#include "core/topview/camera_model.h"
#include "core/topview/semantic_topview.h"

namespace nadir {

/// How high above the ground things of a class reach, for what hides behind them: walls more than any camera that flies low,
/// fences and railings 1.1 m, single posts 4 m, all else 0. Heights are those of core/sim.
[[nodiscard]] double class_height_m(ClassId id);

/// Cells of the map that a level camera sees from a pose, by class; inside a class by forward, then left, as in a topview.
using SeenCells = std::array<std::vector<HalfCell>, kClassCount>;

/// What a vehicle sees of a labelled map without errors of its own: a topview made from the labels instead of from an image.
///
/// A cell counts as seen where the camera has it in the image, nothing nearer hides it, it lies within the range of topviews,
/// and so many pixels fall on it that the topview's vote takes it: of the ground, f_x f_y h a^2 / d^3 of them for a cell of
/// side a at depth d and a camera h above it; of what stands, its width times its visible height. Far ground has too few
/// votes, so that the range of a real topview is found here as well.
/// Hiding is decided in fans of four image columns, near cells first, by the greatest elevation so far.
class ViewFootprint {
 public:
  /// The camera looks ahead from the body, level. @param height_m  Of the camera above the ground, > 0.
  /// @errors kInvalidOptions: those of camera and topview, a height that is not positive, a range of too many cells.
  [[nodiscard]] static Result<ViewFootprint> create(const CameraModel& camera,
                                                    double height_m,
                                                    const TopviewOptions& topview,
                                                    double metres_per_cell);

  /// Fills `seen`, whose memory is used again. Ground that is unclassified or off the map is not seen, but what stands hides
  /// it. O(cells in the fan). @param map  Of the footprint's resolution.
  void see(const OverheadMap& map, const Rigid2& enu_from_body, SeenCells& seen) const;
  /// The same as a topview.
  [[nodiscard]] SemanticTopview topview(const OverheadMap& map, const Rigid2& enu_from_body) const;

  /// Nothing that stands is seen farther from the body, and no ground beyond ground_reach_m().
  [[nodiscard]] double reach_m() const { return reach_m_; }
  [[nodiscard]] double ground_reach_m() const { return ground_reach_m_; }
  /// Whether the fan from a pose, cut off at `range_m`, comes within `margin_m` of a rectangle: false only where it does not.
  [[nodiscard]] bool may_reach(const PlaneBounds& bounds,
                               const Rigid2& enu_from_body,
                               double range_m,
                               double margin_m) const;

 private:
  /// Columns of the image, four a fan, that a cell covers.
  struct CellFans {
    std::uint16_t first, middle, last;
  };
  /// Cells of the fan that lie equally far ahead, from right to left. Elevations are heights over depths, seen from the camera.
  struct FanRow {
    HalfCell rightmost;
    std::size_t first = 0, count = 0;  ///< In `fans_of_cell_`.
    bool is_ground_seen = false;       ///< Where nothing hides it.
    float depth_m = 0.0F;
    float ground_elevation = 0.0F;
  };

  ViewFootprint() = default;
  /// Whether something that stands is seen; hides what is behind it.
  [[nodiscard]] bool raise(const FanRow& row,
                           const CellFans& fans,
                           float height_m,
                           std::vector<float>& horizon) const;

  std::vector<FanRow> rows_;  ///< Nearest first.
  std::vector<CellFans> fans_of_cell_;
  int fans_ = 0;
  double metres_per_cell_ = 0.1;
  double reach_m_ = 0.0, ground_reach_m_ = 0.0;
  double half_view_rad_ = 0.0;            ///< Of the image's wider half, from straight ahead.
  float lowest_ = 0.0F, highest_ = 0.0F;  ///< Elevations at the image's lower and upper border.
  float pixels_of_width_ = 0.0F;          ///< Of a cell at a depth of 1 m.
  float pixels_of_elevation_ = 0.0F;
  float least_votes_ = 1.0F;
  float camera_height_m_ = 0.0F;
};

}  // namespace nadir
