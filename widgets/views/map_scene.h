// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <Eigen/Core>
#include <span>
#include <vector>

#include "widgets/views/map_camera.h"
#include "widgets/views/prop_order.h"

namespace nadir {

/// What lies on the ground, from below as long as set_order() does not say otherwise.
enum class MapLayer {
  kPicture,
  kLabels,
  kReconstruction,
  kSurface,
  kTopview,
  kAgreement,
  kParticles,
  kLabelBorders  ///< Of an editor.
};

/// How a map is looked at: the rectangle of pixels that the camera fills, and how large a point of 1/72 inch is on it.
/// A page that is drawn larger and averaged is looked at in the larger pixels.
struct MapSight {
  MapCamera camera;
  double width_px = 0.0, height_px = 0.0;
  double px_per_pt = 1.0;
  friend bool operator==(const MapSight&, const MapSight&) = default;
};

/// A view whose props depend on how closely the map is looked at.
class SightedView {
 public:
  virtual ~SightedView() = default;
  /// Called by MapScene::look() before anything is drawn with that sight.
  virtual void adapt_to(const MapSight& sight) = 0;
};

/// VTK's side of a map: views put their props into its renderer. Its frame `scene` is enu less an origin near the data,
/// because the graphics card's floats lose millimetres far from zero; z tells only what lies on top of what.
class MapScene {
 public:
  explicit MapScene(const Eigen::Vector2d& scene_origin_in_enu_m);

  [[nodiscard]] vtkRenderer& renderer() { return *renderer_; }
  /// Puts a prop above what lies in lower layers and in its own, below the higher ones, whenever those were added.
  void add(vtkProp& prop, MapLayer layer);
  void remove(vtkProp& prop);
  /// From now on layers lie in this order; those that it does not name lie below.
  void set_order(std::span<const MapLayer> from_below);
  /// Hides what is visible of other layers, until show_all(): a part of the map is drawn by itself. Views are not made,
  /// changed or taken away in between.
  void show_only(std::span<const MapLayer> layers);
  void show_all() { order_.show_all(); }
  /// What lies in some layers, from below, with when it was changed last; being hidden and shown is a change. @param layers
  /// Empty: all.
  [[nodiscard]] std::vector<PropStamp> stamps(std::span<const MapLayer> layers) const;
  [[nodiscard]] bool holds_above(MapLayer layer) const {
    return order_.holds_above(static_cast<int>(layer));
  }
  /// From now on the view hears of every look(), until it is detached.
  void attach(SightedView& view);
  void detach(SightedView& view);
  [[nodiscard]] Eigen::Vector3d scene_from_enu(const Eigen::Vector2d& point_in_enu_m,
                                               MapLayer layer) const;
  /// What shows where nothing lies; a transparent one leaves the pixels clear, whatever its colour.
  void set_background(Rgba colour, bool is_transparent);
  /// Points the renderer's camera, and lets views choose what is worth drawing.
  void look(const MapSight& sight);

 private:
  Eigen::Vector2d scene_origin_in_enu_m_;
  std::vector<SightedView*> sighted_;
  PropOrder order_;
  vtkNew<vtkRenderer> renderer_;
};

}  // namespace nadir
