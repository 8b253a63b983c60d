// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <span>

#include "core/geo/project_plane.h"
#include "widgets/figures/figure_options.h"
#include "widgets/figures/page.h"
#include "widgets/views/map_overlays.h"
#include "widgets/views/overhead_view.h"

namespace nadir {

/// An overhead on a page with coordinates at its border, scale bar and north arrow; figures put their views into its scene
/// and draw their lines over it.
class MapPanel {
 public:
  /// What lies at the bottom: the picture (labels where the package has none), or the labels.
  enum class Ground { kPicture, kLabels };

  /// @errors as OverheadTiles::open.
  [[nodiscard]] static Result<std::unique_ptr<MapPanel>> create(
      const std::filesystem::path& package, Ground ground, const FigureOptions& options);

  [[nodiscard]] MapScene& scene() { return scene_; }
  [[nodiscard]] const ProjectPlane& plane() const { return plane_; }
  [[nodiscard]] const Eigen::AlignedBox2d& map_bounds_in_enu_m() const { return bounds_; }
  /// Whether the ground is labels: then lines need other colours than over a picture.
  [[nodiscard]] bool shows_picture() const { return shows_picture_; }

  /// What the panel has to show, enu metres; the crop of the options wins over it. Points that are not finite do not count.
  void include(std::span<const Eigen::Vector2d> points_in_enu_m);
  void include_map();
  /// Forgets what was included before: a map that goes with the vehicle shows only what is around it.
  void show_square(const Eigen::Vector2d& centre_in_enu_m, double side_m);

  /// Draws ground and border into a rectangle, and nothing over them.
  /// @returns the frame that lines are drawn with; the caller clips them by it.
  /// @errors as OverheadView::update and OffscreenRenderer::render.
  [[nodiscard]] Result<MapFrame> draw_ground(Canvas& canvas,
                                             FigureContext& context,
                                             const PageRect& where);
  /// Scale bar and north arrow, after everything else.
  void draw_furniture(Canvas& canvas, const PageFormat& format, const MapFrame& frame) const;

  /// Width of the ground that include() asked for, by its height.
  [[nodiscard]] double aspect() const;

 private:
  MapPanel(const ProjectPlane& plane,
           const Eigen::AlignedBox2d& bounds,
           const FigureOptions& options);
  [[nodiscard]] bool shows_whole_map() const;
  [[nodiscard]] MapCamera camera_for(const PageRect& where) const;

  ProjectPlane plane_;
  Eigen::AlignedBox2d bounds_;
  FigureOptions options_;
  bool shows_picture_ = false;
  Eigen::AlignedBox2d shown_;
  MapScene scene_;
  std::vector<std::unique_ptr<OverheadView>> layers_;
};

/// Line colours that fit the ground: with a casing over imagery.
[[nodiscard]] PathLook truth_look(const Theme& theme);
[[nodiscard]] PathLook odometry_look(const Theme& theme);
/// @param run  0 for the first run of a figure, 1 for the second ...
[[nodiscard]] PathLook estimate_look(const Theme& theme, std::size_t run = 0);

}  // namespace nadir
