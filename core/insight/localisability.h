// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/field.h"
#include "core/base/progress.h"
#include "core/insight/match_ground.h"
#include "core/insight/pose_spread.h"
#include "core/insight/view_footprint.h"

namespace nadir {

/// How a localisability map is made. Camera and topview are those that vehicles are expected to have.
struct LocalisabilityOptions {
  double spacing_m = 2.0;
  int headings = 8;
  double search_radius_m = 6.0;
  double apart_m = 2.0;
  int cells_per_class = 32;
  double prior_sigma_m = 3.0;
  double prior_yaw_sigma_deg = 10.0;
  double weight_tolerance = 0.05;
  double camera_height_m = 2.0;
  CameraModel camera = CameraModel::from_horizontal_view(640, 480, Angle::degrees(59.95).radians());
  TopviewOptions topview{.min_votes = 3};
};

template <typename Options, typename Visitor>
requires std::same_as<std::remove_const_t<Options>, LocalisabilityOptions>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.spacing_m, Field{"spacing", "m", "Distance between places", 0.1, 1000});
  visit(options.headings, Field{"headings", "", "Headings of a place, evenly around", 1, 64});
  visit(options.search_radius_m,
        Field{"search-radius", "m", "Other places that could be taken for this one", 0.5, 16});
  visit(options.apart_m, Field{"apart", "m", "A place that is nearer is no other place", 0.1, 16});
  visit(options.cells_per_class,
        Field{"cells", "", "Cells of a class that are matched at most", 1, 4000});
  visit(options.prior_sigma_m,
        Field{"prior-sigma", "m", "Deviation where the labels say nothing", 0.1, 100});
  visit(options.prior_yaw_sigma_deg,
        Field{"prior-yaw-sigma", "deg", "The same of the heading", 0.1, 180});
  visit(
      options.weight_tolerance,
      Field{"weight-tolerance", "",
            "All is made anew once the weight of a class is off by a larger part of itself", 0, 1});
  visit(options.camera_height_m, Field{"camera-height", "m", "Camera above ground", 0.2, 6});
  visit_fields(options.topview, std::forward<Visitor>(visit));
}

/// What one view from a place says of the pose: as sure as the filter would be after this one topview, had it known as much as the
/// prior before.
struct ViewInformation {
  float std_major_m = 0.0F;  ///< Along the axis of the plane that is known worst.
  float std_minor_m = 0.0F;  ///< Square to it.
  float major_axis_rad =
      0.0F;  ///< Direction of that axis, counter-clockwise from east, in [0, pi).
  float std_heading_rad = 0.0F;
  /// Weight of the best other pose of the same heading, farther than `apart` and within the search radius, over that of the
  /// true one; 1: they look the same.
  float ambiguity = 1.0F;
  float competitor_east_m = 0.0F, competitor_north_m = 0.0F;  ///< From the place to that pose.
  friend bool operator==(const ViewInformation&, const ViewInformation&) = default;
};

/// What a layer shows of a place: the mean over its headings.
enum class LocalisabilityMeasure { kStdMajor, kStdMinor, kStdHeading, kAmbiguity };

/// Where on a map a vehicle will know its pose, and where not: for a grid of places and several headings, what a vehicle there
/// would see of the labels (ViewFootprint), and how sharply the filter's own error tells that pose from those around it
/// (pose_spread) and from others (ambiguity). core/insight/README.md has the mathematics.
///
/// A map without labels gives the prior everywhere. Values depend on labels and options alone: not on threads, nor on the order
/// in which places were computed, nor on what the map was before its last edit as long as the weights are the same.
/// One thread at a time; inside, compute_more() uses as many as parallel_for may.
class LocalisabilityMap {
 public:
  /// Nothing is computed yet. @errors kInvalidOptions, kUnsupported: those of MatchGround and ViewFootprint; more than
  /// 10,000,000 views.
  [[nodiscard]] static Result<LocalisabilityMap> create(OverheadMap map,
                                                        const LocaliserOptions& localiser,
                                                        const LocalisabilityOptions& options = {});

  /// Takes over what was drawn in a part of the plane, and forgets the views that it may have changed; where the weights of
  /// the classes have gone too far from those in use, all.
  void redraw(const LabelDocument& document, const PlaneBounds& changed);
  /// The same from cells of the map's own grid.
  void redraw(const CellRect& cells, const Raster<ClassId>& labels);
  /// Forgets the views that depend on labels inside `bounds`.
  void forget(const PlaneBounds& bounds);

  /// Computes the views that are missing, in tiles of 8 x 8 places, nearest to `near_in_enu_m` first.
  /// @param most_views  Begins no further round of tiles (as many as there are threads) after so many.
  /// @returns whether all views are there. @errors kCancelled: what was computed stays.
  [[nodiscard]] Result<bool> compute_more(std::int64_t most_views,
                                          const Eigen::Vector2d& near_in_enu_m,
                                          const WorkContext& context = {});

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double spacing_m() const { return options_.spacing_m; }
  /// Places are the centres of squares of that side; (0, 0) touches the map's north-western corner.
  [[nodiscard]] Eigen::Vector2d place_in_enu_m(int column, int row) const;
  /// Yaw of a heading, counter-clockwise from east; heading 0 looks east.
  [[nodiscard]] double heading_rad(int heading) const;
  [[nodiscard]] std::int64_t missing_views() const { return missing_; }
  /// Nothing where it is not computed.
  [[nodiscard]] std::optional<ViewInformation> view(int column, int row, int heading) const;
  /// What a vehicle at any pose would know; milliseconds. The same numbers as view() has.
  [[nodiscard]] ViewInformation look_from(const Rigid2& enu_from_body) const;
  /// A value a place: metres, radians, or a share; NaN where a heading is missing. Row 0 is the northernmost.
  [[nodiscard]] Raster<float> layer(LocalisabilityMeasure measure) const;
  [[nodiscard]] const MatchGround& ground() const { return ground_; }
  [[nodiscard]] const LocalisabilityOptions& options() const { return options_; }

 private:
  LocalisabilityMap(MatchGround ground, ViewFootprint footprint, LocalisabilityOptions options);
  [[nodiscard]] std::size_t index_of(int column, int row, int heading) const;
  [[nodiscard]] bool is_known(std::size_t view) const { return seen_reach_m_[view] >= 0.0F; }
  void forget_all();
  /// @param has_tall  Whether something that stands was or is inside the bounds.
  void forget(const PlaneBounds& bounds, bool has_tall);
  [[nodiscard]] std::vector<int> missing_tiles(const Eigen::Vector2d& near_in_enu_m) const;
  std::int64_t compute_tile(int tile);

  MatchGround ground_;
  ViewFootprint footprint_;
  LocalisabilityOptions options_;
  int columns_ = 0, rows_ = 0;
  std::vector<ViewInformation> views_;
  /// What each view was made of, as detail::MadeView has it; the reach is below 0 where it is not known.
  std::vector<float> seen_reach_m_, margin_m_;
  std::int64_t missing_ = 0;
};

}  // namespace nadir
