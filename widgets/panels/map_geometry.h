// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geo/project_plane.h"
#include "core/map/overhead_map.h"
#include "core/mcl/particle_set.h"
#include "core/session/view_state.h"
#include "widgets/views/map_camera.h"

namespace nadir {

/// What the map view computes: where things are, without drawing any of them.

/// A rectangle of the plane, metres in enu; grows by what it is to hold.
struct GroundBounds {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  void include(const Eigen::Vector2d& point);  ///< What is not finite is passed over.
  [[nodiscard]] bool empty() const { return !(low.x() <= high.x()); }
};

/// The camera of a look on a page. @param look  Resolved: centre and up are those of now. Where its width is 0, everything
/// within the bounds is shown with a margin, turned as the look is.
[[nodiscard]] MapCamera map_camera(const MapLook& look,
                                   const PageRect& where,
                                   const GroundBounds& all);

/// The same camera moved, so that a place of the ground lies at a point of the page: panning.
[[nodiscard]] MapCamera with_ground_at(MapCamera camera,
                                       const Eigen::Vector2d& point_in_enu_m,
                                       const Eigen::Vector2d& on_page,
                                       const PageRect& where);
/// The same camera that shows things `factor` times larger, where the ground at a point of the page stays: zooming.
[[nodiscard]] MapCamera zoomed_at(const MapCamera& camera,
                                  double factor,
                                  const Eigen::Vector2d& on_page,
                                  const PageRect& where);
/// Angle counter-clockwise, degrees in (-180, 180], by which a mouse that went from one point to another turned about the
/// page's middle; 0 within 2 pixels of it.
[[nodiscard]] double turned_deg(const Eigen::Vector2d& from,
                                const Eigen::Vector2d& to,
                                const PageRect& where);

/// What a line of places measures.
struct Measured {
  double length_m = 0.0;             ///< Of all legs.
  std::optional<double> last_leg_m;  ///< With two places or more.
  std::optional<double>
      bearing_deg;  ///< Compass course of the last leg, from grid north; nothing without a length.
  std::optional<double> area_m2;  ///< Inside of the closed line; with three places or more.
};
[[nodiscard]] Measured measure(std::span<const Eigen::Vector2d> points_in_enu_m);
/// "12.34 m", "1.234 km"; "56.7 m²", "1.23 ha", "4.56 km²".
[[nodiscard]] std::string distance_text(double length_m);
[[nodiscard]] std::string area_text(double area_m2);
/// "045.0°"; what rounds up to a whole turn is none.
[[nodiscard]] std::string bearing_text(double bearing_deg);
/// "E 123.45  N 67.89" is written by parts: metres with a fixed number of decimals, no negative zero.
[[nodiscard]] std::string metres_text(double metres, int decimals = 2);

/// The particle nearest to a point of the page, if it is not farther than that. O(n).
[[nodiscard]] std::optional<int> nearest_particle(const ParticleSet& particles,
                                                  const MapCamera& camera,
                                                  const PageRect& where,
                                                  const Eigen::Vector2d& on_page,
                                                  double most_px);

/// What there is to say of a place: for the status line and for the clipboard.
struct MapReadout {
  Eigen::Vector2d in_enu_m = Eigen::Vector2d::Zero();
  std::string class_name;  ///< "road", "unclassified", "off the map"; empty without a map.
  std::optional<ClassId> class_id;
  std::string geodetic, utm, mgrs;  ///< Empty where the plane is not known.
};
/// @param map, plane  May be null.
[[nodiscard]] MapReadout map_readout(const Eigen::Vector2d& point_in_enu_m,
                                     const OverheadMap* map,
                                     const ProjectPlane* plane);

}  // namespace nadir
