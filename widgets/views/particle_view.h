// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <array>
#include <optional>

#include "core/mcl/particle_set.h"
#include "widgets/views/map_scene.h"
#include "widgets/views/theme.h"

namespace nadir {

/// How a cloud of particles is drawn. Sizes are points of 1/72 inch, so that a small and a large page look alike.
struct ParticleLook {
  /// What a weight, as a share of the heaviest, is shown by: viridis from dark to light, or the area of the dot. Where all
  /// weigh the same their colour is that of kEqualShare.
  enum class Weight { kColour, kSize };
  /// Neither heavy nor light: where nothing is to be told apart, and the dot of a legend.
  static constexpr double kEqualShare = kEqualWeightShare;
  Weight weight = Weight::kColour;
  double size_pt =
      0.9;  ///< Side of a dot; where weight is size, of a heaviest one 2.5 times as much.
  Rgba colour{0x56, 0xB4, 0xE9};  ///< Of all dots where weight is size.
  double heading_pt = 6.0;        ///< Length of the tick along each heading; 0: none at any scale.
  double tick_width_pt = 0.45;
  /// Below dots and ticks, around each of them, so that they are seen on any ground; transparent: none.
  Rgba casing{0, 0, 0, 0};
  Rgba casing_of_dark{
      0, 0, 0, 0};  ///< The same around those whose colour is dark; transparent: none of its own.
  double casing_pt = 0.5;           ///< On each side.
  double opacity = 1.0;             ///< Of all of it.
  std::size_t most_drawn = 20'000;  ///< Of more in sight every second, fourth, eighth ... is left.
  friend bool operator==(const ParticleLook&, const ParticleLook&) = default;
};

/// Shows a particle set on the map, by level of detail: a million draws as fast as twenty thousand, for only those in sight
/// are drawn, and of too many every k-th with the heaviest one; k and with it the choice does not change while the map is
/// moved. Heavy ones lie on top. Where they lie apart they are opaque and have ticks along their headings; a dense cloud
/// lets the ground through and has none. Owns its VTK pipeline and a copy of the particles.
class ParticleView : public SightedView {
 public:
  explicit ParticleView(MapScene& scene);
  ~ParticleView() override;  ///< Takes its props out of the scene.
  ParticleView(const ParticleView&) = delete;
  ParticleView& operator=(const ParticleView&) = delete;

  /// Copies; call only when the particles changed. Particles whose pose or weight is not finite are left out. Nothing is
  /// drawn before the scene has been looked at.
  void show(const ParticleSet& particles, const ParticleLook& look = {});
  /// The same particles in another way; what shows their weight stays.
  void set_look(const ParticleLook& look);
  void set_visible(bool visible);
  void adapt_to(const MapSight& sight) override;

  /// Of the last sight.
  [[nodiscard]] std::size_t drawn_count() const { return drawn_; }
  [[nodiscard]] bool has_heading_ticks() const { return has_ticks_; }

 private:
  /// Lines, or dots of one size.
  struct Part {
    vtkNew<vtkPolyData> shape;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  struct Particle {
    Eigen::Vector2f in_scene_m;  ///< Less the scene's origin: floats are fine enough there.
    float yaw_rad = 0.0F;
    float share = 0.0F;  ///< Of the heaviest one's weight; finite.
  };
  static constexpr std::size_t kSizes = 5;

  [[nodiscard]] std::vector<std::size_t> chosen(const MapSight& sight) const;
  void rebuild(const MapSight& sight);
  void draw_dots(const std::vector<std::size_t>& particles, double opacity, double px_per_pt);
  void draw_ticks(const std::vector<std::size_t>& particles, const MapSight& sight);
  [[nodiscard]] bool has_casing() const { return look_.casing.alpha > 0; }
  [[nodiscard]] Rgba casing_of(const Particle& particle, double opacity) const;

  MapScene& scene_;
  ParticleLook look_;
  std::vector<Particle> particles_;
  std::optional<MapSight> sight_;  ///< That the shapes are made for.
  std::size_t drawn_ = 0;
  bool has_ticks_ = false;
  // From below.
  std::array<Part, kSizes> dot_casings_;
  Part tick_casings_, ticks_;
  std::array<Part, kSizes> dots_;
};

}  // namespace nadir
