// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "maps/draw/painting.h"

namespace nadir::town {
namespace {

/// The noises that the surfaces are made of, from the size of a field to that of a tuft.
struct Textures {
  explicit Textures(const Grid& grid)
      : field(grid, 38.0, 1),
        lawn(grid, 9.0, 2),
        patch(grid, 2.6, 3),
        tuft(grid, 0.7, 4),
        grain(grid, 0.25, 5),
        wear(grid, 1.1, 6),
        stain(grid, 5.0, 7),
        chip(grid, 0.2, 8) {}

  Noise field, lawn, patch, tuft, grain, wear, stain, chip;
};

float square(float x) { return x * x; }

Paint grass(const Textures& t, const Point& p) {
  const Paint lush{86, 104, 58}, olive{118, 121, 76}, dry{156, 143, 100}, bare{158, 124, 92};
  const float dryness = 0.42F + 0.34F * t.field(p) + 0.3F * t.lawn(p) + 0.16F * t.patch(p);
  Paint colour = dryness < 0.5F ? blend(lush, olive, std::clamp(2.0F * dryness, 0.0F, 1.0F))
                                : blend(olive, dry, std::clamp(2.0F * dryness - 1.0F, 0.0F, 1.0F));
  const float baldness = 1.2F * t.patch(p) + 0.8F * t.lawn(p) + 0.5F * t.tuft(p) - 1.15F;
  colour = blend(colour, bare, std::clamp(1.6F * baldness, 0.0F, 0.7F));
  return colour * (1.0F + 0.10F * t.tuft(p) + 0.07F * t.grain(p));
}

Paint dirt(const Textures& t, const Point& p) {
  const Paint clay{172, 122, 88}, sand{190, 158, 122};
  const Paint colour = blend(clay, sand, 0.5F + 0.35F * t.stain(p) + 0.3F * t.patch(p));
  return colour * (1.0F + 0.06F * t.tuft(p) + 0.05F * t.grain(p));
}

Paint gravel(const Textures& t, const Point& p) {
  const Paint pale{176, 170, 158}, dusty{158, 140, 118};
  const Paint colour = blend(pale, dusty, 0.45F + 0.4F * t.lawn(p) + 0.25F * t.patch(p));
  return colour * (1.0F + 0.05F * t.wear(p) + 0.11F * t.chip(p));
}

Paint asphalt(const Textures& t, const Point& p, Surface surface) {
  const Paint base = surface == Surface::kNewAsphalt   ? Paint{79, 80, 83}
                     : surface == Surface::kOldAsphalt ? Paint{131, 128, 122}
                                                       : Paint{107, 107, 108};
  const float tone = 1.0F + 0.045F * t.stain(p) + 0.035F * t.patch(p) + 0.02F * t.lawn(p) +
                     0.04F * t.grain(p) + 0.04F * t.chip(p);
  return base * tone;
}

/// Concrete in slabs: joints every `slab_m` both ways.
Paint slabs(
    const Textures& t, const Point& along_across, const Point& p, double slab_m, Paint base) {
  base *= 1.0F + 0.05F * t.stain(p) + 0.04F * t.patch(p) + 0.025F * t.grain(p);
  const double x = along_across.x() / slab_m, y = along_across.y() / slab_m;
  const auto slab = [](double value) {
    return static_cast<std::uint32_t>(std::floor(value) + 4096);
  };
  base *= 0.965F + 0.06F * chance(9, slab(x), slab(y));
  const double joint_m =
      std::min(std::abs(x - std::round(x)), std::abs(y - std::round(y))) * slab_m;
  return joint_m < 0.055 ? Paint(base * 0.84F) : base;
}

/// Tyres darken and polish two tracks in each lane, oil drips between them, dust gathers at the
/// edges.
float traffic(const Street& street, const StreetPlace& place, const Textures& t, const Point& p) {
  const auto from_centre_m = static_cast<float>(std::abs(place.foot.lateral_m));
  const auto lane_m = static_cast<float>(street.half_width_m) / 2.0F;
  const auto track = [&](float at_m, float wide_m) {
    return std::exp(-square((from_centre_m - at_m) / wide_m));
  };
  const float busy = 0.8F + 0.4F * t.stain(p);
  float tone = 1.0F - 0.075F * busy * (track(lane_m - 0.85F, 0.36F) + track(lane_m + 0.85F, 0.36F));
  tone -= 0.06F * busy * track(lane_m, 0.22F);
  const auto to_edge_m = static_cast<float>(-place.distance_m);
  return tone + 0.10F * std::exp(-square(to_edge_m / 0.45F)) * (1.0F + 0.6F * t.wear(p));
}

/// How much paint is left, 0 to 1: worn in the tyre tracks and in whole stretches, chipped
/// everywhere.
float paint_left(const Textures& t, const Point& p, float traffic_tone) {
  const float stretch = 0.80F + 0.42F * t.lawn(p) + 0.22F * t.field(p);
  const float chipped = stretch + 0.5F * t.wear(p) * (1.0F - 0.5F * stretch) + 0.32F * t.chip(p);
  return std::clamp(1.25F * chipped - 4.0F * std::max(0.0F, 0.97F - traffic_tone), 0.06F, 0.92F);
}

Paint bare_ground(const TownLayout& town, const Textures& t, Surface surface, const Point& p) {
  switch (surface) {
    case Surface::kDirt:
      return dirt(t, p);
    case Surface::kGravel:
      return gravel(t, p);
    case Surface::kWoods:
      return blend(grass(t, p), {74, 70, 48}, 0.7F);
    case Surface::kShrubs:
      return blend(grass(t, p), {92, 84, 60}, 0.6F);
    case Surface::kAsphalt:
    case Surface::kNewAsphalt:
    case Surface::kOldAsphalt:
      return asphalt(t, p, surface);
    case Surface::kConcrete:
      return slabs(t, p, p, 4.0, {184, 179, 168});
    case Surface::kSidewalk: {
      const StreetPlace place = street_place(town, p);
      return slabs(t, {place.foot.along_m, place.distance_m}, p, 1.5, {190, 185, 174});
    }
    case Surface::kCurb:
      return Paint{204, 200, 190} * (1.0F + 0.06F * t.wear(p));
    default:
      return grass(t, p);
  }
}

/// Grass does not end at a ruled line: it creeps over edges, and soil shows beside pavements.
Paint soften_edge(const Textures& t, const Point& p, const Paint& colour, float from_road_m) {
  const float nearness = std::exp(-square(from_road_m / 0.5F)) * (0.5F + 0.5F * t.wear(p));
  return blend(colour, {150, 130, 102}, std::clamp(0.6F * nearness, 0.0F, 0.6F));
}

void paint_cell(Canvas& canvas,
                const TownLayout& town,
                const Ground& ground,
                const Textures& t,
                int column,
                int row) {
  const Point p = canvas.grid.centre(column, row);
  const Surface bare = ground.bare.at(column, row), surface = ground.surface.at(column, row);
  Paint colour = bare_ground(town, t, bare, p);
  float tone = 1.0F;
  const float road_m = ground.road_distance_m.at(column, row);
  if (road_m <= 0.0F && class_of(bare) == kRoad) {
    const StreetPlace place = street_place(town, p);
    tone = traffic(town.streets[static_cast<std::size_t>(place.street)], place, t, p);
    colour *= tone;
  } else if (bare == Surface::kGrass) {
    colour = soften_edge(t, p, colour, road_m);
  }
  if (surface == Surface::kWhitePaint) {
    colour = blend(colour, {226, 225, 218}, paint_left(t, p, tone));
  } else if (surface == Surface::kYellowPaint) {
    colour = blend(colour, {214, 172, 66}, paint_left(t, p, tone));
  } else if (surface == Surface::kFence) {
    colour = {150, 138, 118};
    canvas.height_m.at(column, row) = 1.5F;
  }
  canvas.colour.at(column, row) = colour;
}

}  // namespace

Canvas paint_ground(const TownLayout& town, const Ground& ground) {
  Canvas canvas{ground.grid, Raster<Paint>(ground.grid.columns, ground.grid.rows, Paint::Zero()),
                Raster<float>(ground.grid.columns, ground.grid.rows)};
  const Textures textures(ground.grid);
  parallel_for(static_cast<std::size_t>(ground.grid.rows), 16,
               [&](std::size_t begin, std::size_t end) {
                 for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
                   for (int column = 0; column < ground.grid.columns; ++column) {
                     paint_cell(canvas, town, ground, textures, column, row);
                   }
                 }
               });
  return canvas;
}

}  // namespace nadir::town
