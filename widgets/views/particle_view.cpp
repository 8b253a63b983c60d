// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/particle_view.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "widgets/views/theme.h"

namespace nadir {
namespace {

/// A square as large as this is what a particle needs for itself: the length of a heading tick.
constexpr double kRoomPt = 6.0;
/// So many particles share a square before ticks would hide each other ...
constexpr double kMostWithTicks = 3.0;
/// ... and before dots would hide the ground.
constexpr double kMostOpaque = 8.0;
constexpr double kLeastOpacity = 0.12;
/// The casing of a dense cloud is fainter still than its dots, which lie on it.
constexpr double kCasingShare = 0.7;

/// Points, cells and their colours of a shape that is being made.
struct Shape {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;

  Shape() { colours->SetNumberOfComponents(4); }
  void add(Rgba colour) {
    const std::array<unsigned char, 4> tuple = {colour.red, colour.green, colour.blue,
                                                colour.alpha};
    colours->InsertNextTypedTuple(tuple.data());
  }
};

/// Counts particles by squares of ground; mean() is how many share one with it, as a particle sees it. Copies of one, as
/// resampling makes them, lie on each other and count once.
class Crowd {
 public:
  explicit Crowd(double side_m) : side_m_(side_m) {}
  void add(const Eigen::Vector2f& point) {
    const std::uint64_t place = std::uint64_t{std::bit_cast<std::uint32_t>(point.x())} << 32U |
                                std::bit_cast<std::uint32_t>(point.y());
    if (!places_.insert(place).second) return;
    static constexpr double kFarthest = 1e12;  // so that the number below is one
    const auto index = [this](float at) {
      return static_cast<std::int64_t>(
          std::clamp(std::floor(static_cast<double>(at) / side_m_), -kFarthest, kFarthest));
    };
    ++counts_[index(point.x()) * 1'000'003 + index(point.y())];
  }
  [[nodiscard]] double mean() const {
    double squares = 0.0;
    for (const auto& [square, count] : counts_) squares += static_cast<double>(count) * count;
    return places_.empty() ? 0.0 : squares / static_cast<double>(places_.size());
  }

 private:
  double side_m_;
  std::unordered_map<std::int64_t, int> counts_;
  std::unordered_set<std::uint64_t> places_;
};

}  // namespace

ParticleView::ParticleView(MapScene& scene) : scene_(scene) {
  const auto prepare = [this](Part& part) {
    part.mapper->SetInputData(part.shape);
    part.mapper->SetScalarModeToUseCellData();
    part.actor->SetMapper(part.mapper);
    part.actor->GetProperty()->LightingOff();
    part.actor->ForceTranslucentOn();
    scene_.add(*part.actor, MapLayer::kParticles);
  };
  for (Part& part : dot_casings_) prepare(part);
  prepare(tick_casings_);
  prepare(ticks_);
  for (Part& part : dots_) prepare(part);
  scene_.attach(*this);
}

ParticleView::~ParticleView() {
  scene_.detach(*this);
  for (Part& part : dot_casings_) scene_.remove(*part.actor);
  scene_.remove(*tick_casings_.actor);
  scene_.remove(*ticks_.actor);
  for (Part& part : dots_) scene_.remove(*part.actor);
}

void ParticleView::show(const ParticleSet& particles, const ParticleLook& look) {
  look_ = look;
  particles_.clear();
  particles_.reserve(particles.size());
  double heaviest = 0.0;
  double lightest = std::numeric_limits<double>::infinity();
  for (const double weight : particles.weight) {
    if (!std::isfinite(weight)) continue;
    heaviest = std::max(heaviest, weight);
    lightest = std::min(lightest, weight);
  }
  const bool are_alike = lightest >= heaviest;
  const double share_of_equals =
      look.weight == ParticleLook::Weight::kColour ? ParticleLook::kEqualShare : 1.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Eigen::Vector2d point(particles.x_in_enu_m[i], particles.y_in_enu_m[i]);
    const double yaw_rad = particles.yaw_rad[i];
    const double weight = particles.weight[i];
    if (!point.allFinite() || !std::isfinite(yaw_rad) || !std::isfinite(weight)) continue;
    const double share = are_alike ? share_of_equals : std::max(0.0, weight / heaviest);
    particles_.push_back(
        {scene_.scene_from_enu(point, MapLayer::kParticles).head<2>().cast<float>(),
         static_cast<float>(yaw_rad), static_cast<float>(share)});
  }
  if (sight_) rebuild(*sight_);
  ticks_.actor->Modified();
}

void ParticleView::set_look(const ParticleLook& look) {
  if (look_ == look) return;
  look_ = look;
  if (sight_) rebuild(*sight_);
}

void ParticleView::adapt_to(const MapSight& sight) {
  if (sight_ == sight) return;
  sight_ = sight;
  rebuild(sight);
}

std::vector<std::size_t> ParticleView::chosen(const MapSight& sight) const {
  // The page in metres, turned so that it lies upright, with room for the ticks of particles just outside.
  const Eigen::Vector2f centre =
      scene_.scene_from_enu(sight.camera.centre_in_enu_m, MapLayer::kParticles)
          .head<2>()
          .cast<float>();
  const Eigen::Vector2f up(static_cast<float>(std::cos(sight.camera.up_rad)),
                           static_cast<float>(std::sin(sight.camera.up_rad)));
  const Eigen::Vector2f right(up.y(), -up.x());
  const Eigen::Vector2d half_px =
      0.5 * Eigen::Vector2d(sight.width_px, sight.height_px) +
      Eigen::Vector2d::Constant(
          (look_.heading_pt + 2.5 * look_.size_pt + (has_casing() ? look_.casing_pt : 0.0)) *
          sight.px_per_pt);
  const Eigen::Vector2f half = (half_px * sight.camera.metres_per_px).cast<float>();
  std::vector<std::size_t> seen;
  std::size_t heaviest = 0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const Eigen::Vector2f offset = particles_[i].in_scene_m - centre;
    if (!(std::abs(offset.dot(right)) <= half.x()) || !(std::abs(offset.dot(up)) <= half.y())) {
      continue;
    }
    if (seen.empty() || particles_[i].share > particles_[heaviest].share) heaviest = i;
    seen.push_back(i);
  }
  // Powers of two, and by the number in the whole set, so that the same are drawn while the map is moved.
  for (std::size_t step = 2; seen.size() > std::max<std::size_t>(1, look_.most_drawn); step *= 2) {
    std::erase_if(seen, [&](std::size_t i) { return i % step != 0 && i != heaviest; });
    if (step > particles_.size()) break;
  }
  std::stable_sort(seen.begin(), seen.end(), [this](std::size_t a, std::size_t b) {
    return particles_[a].share < particles_[b].share;
  });
  return seen;
}

void ParticleView::rebuild(const MapSight& sight) {
  const std::vector<std::size_t> seen = chosen(sight);
  Crowd crowd(kRoomPt * sight.px_per_pt * sight.camera.metres_per_px);
  for (const std::size_t i : seen) crowd.add(particles_[i].in_scene_m);
  const double neighbours = crowd.mean();
  drawn_ = seen.size();
  has_ticks_ = look_.heading_pt > 0.0 && !seen.empty() && neighbours <= kMostWithTicks;
  draw_ticks(has_ticks_ ? seen : std::vector<std::size_t>(), sight);
  const double opacity =
      std::clamp(std::sqrt(kMostOpaque / std::max(1.0, neighbours)), kLeastOpacity, 1.0);
  draw_dots(seen, opacity, sight.px_per_pt);
}

namespace {

/// Colour of a particle whose weight is shown by it.
Rgba weight_colour(float share) { return value_colour(ValueColours::kViridis, share); }

void add_dot(Shape& shape, const Eigen::Vector2f& at, double z, Rgba colour) {
  const vtkIdType id = shape.points->InsertNextPoint(at.x(), at.y(), z);
  shape.cells->InsertNextCell(1, &id);
  shape.add(colour);
}

void add_tick(
    Shape& shape, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double z, Rgba colour) {
  const std::array<vtkIdType, 2> ends = {shape.points->InsertNextPoint(from.x(), from.y(), z),
                                         shape.points->InsertNextPoint(to.x(), to.y(), z)};
  shape.cells->InsertNextCell(2, ends.data());
  shape.add(colour);
}

void take(vtkPolyData& shape, const Shape& made, bool is_lines) {
  shape.Initialize();
  shape.SetPoints(made.points);
  if (is_lines) {
    shape.SetLines(made.cells);
  } else {
    shape.SetVerts(made.cells);
  }
  shape.GetCellData()->SetScalars(made.colours);
}

}  // namespace

Rgba ParticleView::casing_of(const Particle& particle, double opacity) const {
  constexpr float kDarkShare = 0.45F;  // of viridis: darker than asphalt is light
  const bool is_dark = look_.weight == ParticleLook::Weight::kColour &&
                       particle.share < kDarkShare && look_.casing_of_dark.alpha > 0;
  const Rgba casing = is_dark ? look_.casing_of_dark : look_.casing;
  return with_opacity(casing, look_.opacity * opacity * casing.alpha / 255.0);
}

void ParticleView::draw_dots(const std::vector<std::size_t>& particles,
                             double opacity,
                             double px_per_pt) {
  const double z = scene_.scene_from_enu({0.0, 0.0}, MapLayer::kParticles).z();
  const bool is_by_size = look_.weight == ParticleLook::Weight::kSize;
  const double casing_opacity = opacity * (opacity < 1.0 ? kCasingShare : 1.0);
  std::array<Shape, kSizes> made;
  std::array<Shape, kSizes> casings;
  for (const std::size_t i : particles) {
    const Particle& particle = particles_[i];
    // The side of a dot grows as the root of the weight, so its area as the weight.
    const double side = std::sqrt(std::clamp(static_cast<double>(particle.share), 0.0, 1.0));
    const std::size_t size =
        is_by_size ? std::min(kSizes - 1, static_cast<std::size_t>(side * kSizes)) : 0;
    const Rgba colour = is_by_size ? look_.colour : weight_colour(particle.share);
    add_dot(made.at(size), particle.in_scene_m, z, with_opacity(colour, look_.opacity * opacity));
    if (has_casing()) {
      add_dot(casings.at(size), particle.in_scene_m, z, casing_of(particle, casing_opacity));
    }
  }
  for (std::size_t size = 0; size < kSizes; ++size) {
    take(*dots_.at(size).shape, made.at(size), false);
    take(*dot_casings_.at(size).shape, casings.at(size), false);
    const double factor = is_by_size ? 2.5 * (static_cast<double>(size) + 1.0) / kSizes : 1.0;
    const double side = std::max(1.0, factor * look_.size_pt * px_per_pt);
    dots_.at(size).actor->GetProperty()->SetPointSize(static_cast<float>(side));
    dot_casings_.at(size).actor->GetProperty()->SetPointSize(
        static_cast<float>(side + 2.0 * look_.casing_pt * px_per_pt));
  }
}

void ParticleView::draw_ticks(const std::vector<std::size_t>& particles, const MapSight& sight) {
  const double z = scene_.scene_from_enu({0.0, 0.0}, MapLayer::kParticles).z();
  const double length_m = look_.heading_pt * sight.px_per_pt * sight.camera.metres_per_px;
  const double beyond_m = look_.casing_pt * sight.px_per_pt * sight.camera.metres_per_px;
  Shape made;
  Shape casings;
  for (const std::size_t i : particles) {
    const Particle& particle = particles_[i];
    const Eigen::Vector2d from = particle.in_scene_m.cast<double>();
    const double yaw_rad = particle.yaw_rad;
    const Eigen::Vector2d along(std::cos(yaw_rad), std::sin(yaw_rad));
    const Rgba colour =
        look_.weight == ParticleLook::Weight::kSize ? look_.colour : weight_colour(particle.share);
    add_tick(made, from, from + length_m * along, z,
             with_opacity(colour, look_.opacity * colour.alpha / 255.0));
    if (has_casing()) {
      add_tick(casings, from, from + (length_m + beyond_m) * along, z, casing_of(particle, 1.0));
    }
  }
  take(*ticks_.shape, made, true);
  take(*tick_casings_.shape, casings, true);
  const double width = std::max(1.0, look_.tick_width_pt * sight.px_per_pt);
  ticks_.actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  tick_casings_.actor->GetProperty()->SetLineWidth(
      static_cast<float>(width + 2.0 * look_.casing_pt * sight.px_per_pt));
}

void ParticleView::set_visible(bool visible) {
  for (Part& part : dot_casings_) part.actor->SetVisibility(visible ? 1 : 0);
  tick_casings_.actor->SetVisibility(visible ? 1 : 0);
  ticks_.actor->SetVisibility(visible ? 1 : 0);
  for (Part& part : dots_) part.actor->SetVisibility(visible ? 1 : 0);
}

}  // namespace nadir
