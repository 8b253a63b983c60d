// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "maps/draw/painting.h"

namespace nadir::town {
namespace {

Paint cover_colour(RoofCover cover) {
  switch (cover) {
    case RoofCover::kDarkShingle:
      return {104, 100, 98};
    case RoofCover::kBrownShingle:
      return {138, 118, 100};
    case RoofCover::kRedTile:
      return {156, 104, 84};
    case RoofCover::kWhiteMetal:
      return {206, 208, 206};
    case RoofCover::kGreenMetal:
      return {108, 128, 118};
    case RoofCover::kRustMetal:
      return {158, 124, 100};
    case RoofCover::kGravelFlat:
      return {172, 166, 154};
    case RoofCover::kWhiteFlat:
      return {216, 214, 208};
    case RoofCover::kTarFlat:
      return {112, 110, 110};
  }
  return {128, 128, 128};
}

bool is_metal(RoofCover cover) {
  return cover == RoofCover::kWhiteMetal || cover == RoofCover::kGreenMetal ||
         cover == RoofCover::kRustMetal;
}

/// Where a point lies on a roof, in the building's own frame.
struct RoofPlace {
  double inside_m = 0.0;  ///< From the nearest wall, measured square to the walls.
  double along_m = 0.0,
         across_m = 0.0;  ///< Along the ridge and across it, from the middle of the footprint.
};

/// Distance inwards from the walls. Where all walls run east or north it is the larger of the two
/// coordinate differences, so that the valleys of an angled hip roof are sharp.
double inside_m(const Polygon& footprint, const Point& p) {
  double least_m = 1e9;
  const auto& corners = footprint.corners;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Point low = corners[i].cwiseMin(corners[j]), high = corners[i].cwiseMax(corners[j]);
    if ((high - low).minCoeff() > 0.0) return -signed_distance(footprint, p);
    least_m = std::min(least_m, (low - p).cwiseMax(p - high).cwiseMax(0.0).maxCoeff());
  }
  return least_m;
}

float roof_height_m(const Building& building, const RoofPlace& place, double half_span_m) {
  switch (building.roof) {
    case Roof::kHip:
      return static_cast<float>(building.eave_m + building.pitch * place.inside_m);
    case Roof::kGable:
      return static_cast<float>(building.eave_m +
                                building.pitch * (half_span_m - std::abs(place.across_m)));
    case Roof::kFlat:
      break;
  }
  return static_cast<float>(building.eave_m + (place.inside_m < 0.35 ? 0.5 : 0.0));
}

Paint roof_colour(const Building& building,
                  const RoofPlace& place,
                  const Noise& stain,
                  const Noise& grain,
                  const Point& p,
                  double half_span_m,
                  float tone) {
  Paint colour = cover_colour(building.cover) * tone;
  colour *= 1.0F + 0.05F * stain(p) + 0.03F * grain(p);
  if (is_metal(building.cover)) {
    // Standing seams run down the slope, with rust streaks here and there.
    if (place.along_m - 0.9 * std::floor(place.along_m / 0.9) < 0.1) colour *= 0.88F;
    return blend(colour, {148, 104, 76}, std::clamp(0.7F * stain(p) - 0.35F, 0.0F, 0.4F));
  }
  if (building.roof == Roof::kFlat) {
    if (place.inside_m < 0.35) return blend(colour, {200, 196, 188}, 0.6F);
    const float puddle = std::clamp(1.4F * stain(p) - 0.5F, 0.0F, 0.5F);
    if (place.along_m - 3.0 * std::floor(place.along_m / 3.0) < 0.1) colour *= 0.95F;  // seams
    return blend(colour, {112, 106, 98}, 0.5F * puddle);
  }
  // Rows of shingles, and a paler cap on the ridge.
  const double down_m =
      building.roof == Roof::kGable ? half_span_m - std::abs(place.across_m) : place.inside_m;
  if (down_m - 0.4 * std::floor(down_m / 0.4) < 0.1) colour *= 0.94F;
  const bool ridge = building.roof == Roof::kGable && std::abs(place.across_m) < 0.15;
  return ridge ? Paint(colour * 1.12F) : colour;
}

/// Air conditioners, vents and skylights on flat roofs; chimneys and vents on the others.
void paint_boxes(Canvas& canvas, const Building& building, std::uint32_t index) {
  const Box box = bounds(building.footprint.corners);
  const bool flat = building.roof == Roof::kFlat;
  const auto count =
      static_cast<std::uint32_t>(flat ? 3.0 + (box.high - box.low).prod() / 45.0 : 3.0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Point share{static_cast<double>(chance(60, index, i)),
                      static_cast<double>(chance(61, index, i))};
    const Point at = box.low + share.cwiseProduct(box.high - box.low);
    const bool large = flat && chance(62, index, i) < 0.5F;
    const double size_m = large  ? 1.4 + 1.2 * static_cast<double>(chance(63, index, i))
                          : flat ? 0.7
                                 : 0.45;
    if (signed_distance(building.footprint, at) > (flat ? -1.0 - size_m : -1.2)) continue;
    const Polygon outline = rectangle(at, size_m, 0.75 * size_m, building.ridge_heading_deg);
    const Paint colour = large  ? Paint{196, 198, 196}
                         : flat ? Paint{168, 182, 190}
                                : Paint{120, 110, 104};
    const float fan_m = 0.32F * static_cast<float>(size_m);
    for_cells(canvas.grid, bounds(outline.corners), [&](int column, int row, const Point& p) {
      if (!contains(outline, p)) return;
      const bool fan =
          large && std::abs(static_cast<float>((p - at).norm()) - fan_m * 0.6F) < fan_m * 0.4F;
      canvas.colour.at(column, row) = fan ? Paint{120, 122, 122} : colour;
      canvas.height_m.at(column, row) += large ? 1.2F : flat ? 0.4F : 0.8F;
    });
  }
}

}  // namespace

void paint_roofs(Canvas& canvas, const TownLayout& town) {
  const Noise stain(canvas.grid, 3.0, 65), grain(canvas.grid, 0.3, 66);
  for (std::uint32_t index = 0; index < town.buildings.size(); ++index) {
    const Building& building = town.buildings[index];
    const Box box = bounds(building.footprint.corners);
    const Point middle = (box.low + box.high) / 2.0;
    const double heading_rad = building.ridge_heading_deg * std::numbers::pi / 180.0;
    const Point forward{std::cos(heading_rad), std::sin(heading_rad)},
        left{-forward.y(), forward.x()};
    double half_span_m = 0.0;
    for (const Point& corner : building.footprint.corners) {
      half_span_m = std::max(half_span_m, std::abs((corner - middle).dot(left)));
    }
    const float tone = 0.93F + 0.14F * chance(64, index);
    for_cells(canvas.grid, box, [&](int column, int row, const Point& p) {
      if (!contains(building.footprint, p)) return;
      const RoofPlace place{inside_m(building.footprint, p), (p - middle).dot(forward),
                            (p - middle).dot(left)};
      canvas.height_m.at(column, row) = roof_height_m(building, place, half_span_m);
      canvas.colour.at(column, row) =
          roof_colour(building, place, stain, grain, p, half_span_m, tone);
    });
    paint_boxes(canvas, building, index);
  }
}

}  // namespace nadir::town
