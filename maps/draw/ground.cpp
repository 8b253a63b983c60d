// SPDX-License-Identifier: Apache-2.0
#include "maps/draw/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "maps/draw/markings.h"

namespace nadir::town {
namespace {

constexpr double kCurbM = 0.2;
constexpr double kWallM = 0.3;

bool is_road(Surface surface) { return class_of(surface) == kRoad; }

void fill(Ground& ground, Raster<Surface>& raster, const Polygon& polygon, Surface surface) {
  for_cells(ground.grid, bounds(polygon.corners), [&](int column, int row, const Point& p) {
    if (contains(polygon, p)) raster.at(column, row) = surface;
  });
}

/// Sidewalk width and verge on the side of a street where a point lies.
double sidewalk_m(const Street& street, double lateral_m) {
  return lateral_m > 0.0 ? street.sidewalk_left_m : street.sidewalk_right_m;
}

void draw_streets(Ground& ground, const TownLayout& town) {
  const auto rows = static_cast<std::size_t>(ground.grid.rows);
  parallel_for(rows, 16, [&](std::size_t begin, std::size_t end) {
    for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
      for (int column = 0; column < ground.grid.columns; ++column) {
        const Point p = ground.grid.centre(column, row);
        const StreetPlace place = street_place(town, p);
        ground.road_distance_m.at(column, row) = static_cast<float>(place.distance_m);
        Surface& surface = ground.bare.at(column, row);
        const Street& street = town.streets[static_cast<std::size_t>(place.street)];
        const double beyond_m = place.distance_m - (street.curbs ? kCurbM : 0.0) - street.verge_m;
        if (place.distance_m <= 0.0) {
          surface = street.surface;
        } else if (street.curbs && place.distance_m <= kCurbM) {
          surface = Surface::kCurb;
        } else if (beyond_m > 0.0 && beyond_m <= sidewalk_m(street, place.foot.lateral_m)) {
          surface = Surface::kSidewalk;
        }
      }
    }
  });
}

void draw_circle_sidewalks(Ground& ground, const Circle& circle) {
  const double outer_m = circle.radius_m + kCurbM + circle.sidewalk_m;
  const Point reach = Point::Constant(outer_m + 1.0);
  for_cells(ground.grid, {circle.centre - reach, circle.centre + reach},
            [&](int column, int row, const Point& p) {
              const double from_centre_m = (p - circle.centre).norm();
              Surface& surface = ground.bare.at(column, row);
              if (circle.island_m > 0.0 && from_centre_m < circle.island_m) {
                // The island: curb outside, a concrete apron for lorries, grass and shrubs within.
                if (from_centre_m >= circle.island_m - kCurbM)
                  surface = Surface::kCurb;
                else if (from_centre_m >= circle.island_m - 1.4)
                  surface = Surface::kSidewalk;
                else if (from_centre_m >= 2.6)
                  surface = Surface::kGrass;
                else
                  surface = Surface::kShrubs;
              } else if (ground.road_distance_m.at(column, row) > static_cast<float>(kCurbM) &&
                         from_centre_m <= outer_m) {
                surface = Surface::kSidewalk;
              }
            });
}

void draw_island(Ground& ground, const Pad& island) {
  for_cells(ground.grid, bounds(island.outline.corners), [&](int column, int row, const Point& p) {
    const double distance_m = signed_distance(island.outline, p);
    if (distance_m > 0.0) return;
    // The middle of the island is for people on foot, not for cars.
    ground.bare.at(column, row) = distance_m > -kCurbM ? Surface::kCurb : Surface::kSidewalk;
  });
}

void draw_wall(Ground& ground, Raster<Surface>& raster, const Wall& wall, Surface surface) {
  for_cells(ground.grid, bounds(wall.line.points).grown(wall.width_m),
            [&](int column, int row, const Point& p) {
              if (nearest(wall.line, p).distance_m <= wall.width_m / 2.0) {
                raster.at(column, row) = surface;
              }
            });
}

}  // namespace

ClassId class_of(Surface surface) {
  switch (surface) {
    case Surface::kGrass:
    case Surface::kDirt:
    case Surface::kGravel:
      return kTerrain;
    case Surface::kWoods:
    case Surface::kShrubs:
      return kVegetation;
    case Surface::kAsphalt:
    case Surface::kNewAsphalt:
    case Surface::kOldAsphalt:
    case Surface::kConcrete:
      return kRoad;
    case Surface::kSidewalk:
      return kSidewalk;
    case Surface::kCurb:
      return kCurb;
    case Surface::kWhitePaint:
    case Surface::kYellowPaint:
      return kLaneMarking;
    case Surface::kFence:
      return kFence;
    case Surface::kWall:
      return kBuilding;
    case Surface::kIndoors:
      return kUnclassified;
  }
  return kUnclassified;
}

Grid grid_of(const TownLayout& town) {
  return {static_cast<int>(std::lround(town.width_m / town.metres_per_cell)),
          static_cast<int>(std::lround(town.height_m / town.metres_per_cell)),
          town.metres_per_cell};
}

void for_cells(const Grid& grid,
               const Box& box,
               const std::function<void(int column, int row, const Point& p)>& visit) {
  const double cell_m = grid.metres_per_cell;
  const auto index = [cell_m](double metres, int cells) {
    return static_cast<int>(std::floor(metres / cell_m + cells / 2.0));
  };
  const int first_column = std::max(0, index(box.low.x(), grid.columns) - 1);
  const int last_column = std::min(grid.columns - 1, index(box.high.x(), grid.columns) + 1);
  const int first_row = std::max(0, index(-box.high.y(), grid.rows) - 1);
  const int last_row = std::min(grid.rows - 1, index(-box.low.y(), grid.rows) + 1);
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const Point p = grid.centre(column, row);
      if (box.contains(p)) visit(column, row, p);
    }
  }
}

StreetPlace street_place(const TownLayout& town, const Point& p) {
  StreetPlace place;
  place.distance_m = std::numeric_limits<double>::infinity();
  std::vector<double> edge_m(town.streets.size());
  std::vector<bool> beyond_end(
      town.streets.size());  // a street that ends at a T rounds nothing there
  for (std::size_t i = 0; i < town.streets.size(); ++i) {
    const Foot foot = nearest(town.streets[i].centre, p);
    edge_m[i] = foot.distance_m - town.streets[i].half_width_m;
    beyond_end[i] = foot.at_end;
    if (edge_m[i] < place.distance_m) {
      place = {edge_m[i], static_cast<int>(i), foot};
    }
  }
  // On a crossing the street that comes first in the list runs through.
  for (std::size_t i = 0; i < town.streets.size() && place.distance_m <= 0.0; ++i) {
    if (edge_m[i] > 0.0) continue;
    place = {place.distance_m, static_cast<int>(i), nearest(town.streets[i].centre, p)};
    break;
  }
  for (const Junction& junction : town.junctions) {
    const auto first = static_cast<std::size_t>(junction.first);
    const auto second = static_cast<std::size_t>(junction.second);
    if ((p - junction.centre).norm() > 25.0 || beyond_end[first] || beyond_end[second]) continue;
    place.distance_m =
        std::min(place.distance_m, rounded_union(edge_m[first], edge_m[second], junction.radius_m));
  }
  for (const Pad& lay_by : town.lay_bys) {
    if (!bounds(lay_by.outline.corners).grown(5.0).contains(p)) continue;
    place.distance_m = std::min(place.distance_m, signed_distance(lay_by.outline, p));
  }
  for (const Circle& circle : town.circles) {
    const double from_centre_m = (p - circle.centre).norm();
    const double circle_m = from_centre_m - circle.radius_m;
    if (circle_m > 15.0) continue;
    place.distance_m = std::min(place.distance_m, circle_m);
    for (const int street : circle.streets) {
      place.distance_m = std::min(
          place.distance_m,
          rounded_union(circle_m, edge_m[static_cast<std::size_t>(street)], circle.fillet_m));
    }
    place.distance_m = std::max(place.distance_m, circle.island_m - from_centre_m);
  }
  return place;
}

Ground draw_ground(const TownLayout& town) {
  Ground ground;
  ground.grid = grid_of(town);
  ground.bare = Raster<Surface>(ground.grid.columns, ground.grid.rows, Surface::kGrass);
  ground.road_distance_m = Raster<float>(ground.grid.columns, ground.grid.rows);
  for (const Pad& area : town.areas) fill(ground, ground.bare, area.outline, area.surface);
  draw_streets(ground, town);
  for (const Circle& circle : town.circles) draw_circle_sidewalks(ground, circle);
  for (const Pad& island : town.islands) draw_island(ground, island);
  for (const Pad& way : town.driveways) {
    for_cells(ground.grid, bounds(way.outline.corners), [&](int column, int row, const Point& p) {
      // A driveway begins at the road's edge; it never paves the road anew.
      if (ground.road_distance_m.at(column, row) <= 0.0F || !contains(way.outline, p)) return;
      ground.bare.at(column, row) = way.surface;
    });
  }
  for (const Wall& hedge : town.hedges) draw_wall(ground, ground.bare, hedge, Surface::kShrubs);

  ground.surface = ground.bare;
  for (const Painted& shape : painted_shapes(town)) {
    const Surface paint = shape.yellow ? Surface::kYellowPaint : Surface::kWhitePaint;
    for_cells(ground.grid, bounds(shape.outline.corners), [&](int column, int row, const Point& p) {
      if (is_road(ground.bare.at(column, row)) && contains(shape.outline, p)) {
        ground.surface.at(column, row) = paint;
      }
    });
  }
  for (const Wall& fence : town.fences) draw_wall(ground, ground.surface, fence, Surface::kFence);
  for (const Building& building : town.buildings) {
    for_cells(ground.grid, bounds(building.footprint.corners),
              [&](int column, int row, const Point& p) {
                const double distance_m = signed_distance(building.footprint, p);
                if (distance_m > 0.0) return;
                ground.surface.at(column, row) =
                    distance_m > -kWallM ? Surface::kWall : Surface::kIndoors;
              });
  }
  return ground;
}

Raster<ClassId> draw_labels(const Ground& ground) {
  Raster<ClassId> labels(ground.grid.columns, ground.grid.rows);
  std::transform(ground.surface.values().begin(), ground.surface.values().end(),
                 labels.values().begin(), class_of);
  return labels;
}

}  // namespace nadir::town
