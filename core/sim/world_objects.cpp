// SPDX-License-Identifier: Apache-2.0
#include "core/sim/world_objects.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/random.h"
#include "core/sim/object_kind.h"

namespace nadir {
namespace {

/// Numbers of one square of the ground, for one kind of thing.
struct PlaceDraws {
  std::uint64_t seed;
  std::uint32_t kind;
  std::uint32_t square;

  [[nodiscard]] std::array<double, 2> at(std::uint32_t draw) const {
    return uniforms({seed, kWorldObjects, kind, square, draw});
  }
};

constexpr std::uint32_t kShareDraw = 1000;  ///< Draws below it are attempts at a place.
constexpr std::uint32_t kShapeDraw = 1001;
constexpr std::uint32_t kMotionDraw = 1002;

/// Cuts the map into squares; in the share of them that is to have one, calls `add` at the first
/// suitable random place.
template <typename Suitable, typename Add>
void furnish(const Ground& ground,
             double square_m,
             double share,
             std::uint64_t seed,
             ObjectKind kind,
             std::uint32_t attempts,
             Suitable is_suitable,
             Add add) {
  const OverheadMap& map = ground.map();
  const int columns = static_cast<int>(std::ceil(map.width_m() / square_m));
  const int rows = static_cast<int>(std::ceil(map.height_m() / square_m));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const PlaceDraws draws{seed, kind, static_cast<std::uint32_t>(row * columns + column)};
      if (draws.at(kShareDraw)[0] >= share) continue;
      for (std::uint32_t attempt = 0; attempt < attempts; ++attempt) {
        const auto [right, down] = draws.at(attempt);
        const Eigen::Vector2d place_in_enu_m =
            map.top_left_in_enu_m +
            square_m * Eigen::Vector2d(column + right, -(static_cast<double>(row) + down));
        if (!is_suitable(place_in_enu_m)) continue;
        add(place_in_enu_m, draws);
        break;
      }
    }
  }
}

Solid upright(Solid::Shape shape,
              ClassId label,
              const Eigen::Vector2d& place_in_enu_m,
              double bottom_m,
              double top_m,
              double radius_m) {
  return {.shape = shape,
          .label = label,
          .centre_in_enu_m = {place_in_enu_m.x(), place_in_enu_m.y(), 0.5 * (bottom_m + top_m)},
          .half_size_m = {radius_m, radius_m, 0.5 * (top_m - bottom_m)}};
}

/// A car at the origin on z = 0, heading east: body and cabin.
std::vector<Solid> car_parts(double size) {
  return {{.shape = Solid::Shape::kBox,
           .label = kCar,
           .centre_in_enu_m = {0.0, 0.0, 0.55 * size},
           .half_size_m = {2.1 * size, 0.86 * size, 0.35 * size}},
          {.shape = Solid::Shape::kBox,
           .label = kCar,
           .centre_in_enu_m = {-0.2 * size, 0.0, 1.15 * size},
           .half_size_m = {1.2 * size, 0.76 * size, 0.3 * size}}};
}

double between(double low, double high, double share) { return low + (high - low) * share; }

}  // namespace

void add_trees(const Ground& ground, double share, std::uint64_t seed, std::vector<Solid>& solids) {
  const auto is_suitable = [&](const Eigen::Vector2d& place) {
    const double road_m = ground.to_road_m(place);
    return road_m >= 1.0 && road_m <= 6.0 && ground.inside_open_m(place) >= 0.5;
  };
  furnish(ground, 8.0, share, seed, kTrees, 4, is_suitable,
          [&](const auto& place, const auto& draws) {
            const auto [height, width] = draws.at(kShapeDraw);
            const double ground_m = ground.height_m(place);
            const double crown_bottom_m = ground_m + between(2.3, 3.0, height);
            const double crown_radius_m = between(0.9, 1.8, width);
            solids.push_back(upright(Solid::Shape::kCylinder, kVegetation, place, ground_m,
                                     crown_bottom_m + 0.3, between(0.1, 0.2, width)));
            solids.push_back(upright(Solid::Shape::kEllipsoid, kVegetation, place, crown_bottom_m,
                                     crown_bottom_m + between(2.5, 4.5, height), crown_radius_m));
          });
}

void add_poles(const Ground& ground, double share, std::uint64_t seed, std::vector<Solid>& solids) {
  // Coarse cells leave no room between 0.4 and 1.2 m, hence one cell of slack.
  const double slack_m = ground.map().metres_per_cell;
  const auto is_suitable = [&](const Eigen::Vector2d& place) {
    const double road_m = ground.to_road_m(place);
    return ground.is_open(place) && road_m >= 0.4 && road_m <= 1.2 + slack_m;
  };
  furnish(ground, 12.0, share, seed, kPoles, 16, is_suitable,
          [&](const auto& place, const auto& draws) {
            const auto [kind, width] = draws.at(kShapeDraw);
            const double ground_m = ground.height_m(place);
            const bool is_light = kind < 0.4;
            const double top_m = ground_m + (is_light ? 5.0 : between(2.5, 6.0, kind));
            solids.push_back(upright(Solid::Shape::kCylinder, kPole, place, ground_m, top_m,
                                     between(0.05, 0.1, width)));
            if (!is_light) return;
            Solid lamp =
                upright(Solid::Shape::kEllipsoid, kStreetLight, place, top_m, top_m + 0.35, 0.25);
            solids.push_back(lamp);
          });
}

void add_parked_cars(const Ground& ground,
                     double share,
                     std::uint64_t seed,
                     std::vector<Solid>& solids) {
  constexpr double kToEdgeM = 1.1;
  const double slack_m = std::max(0.15, 0.6 * ground.map().metres_per_cell);
  const auto is_suitable = [&](const Eigen::Vector2d& place) {
    if (std::abs(ground.inside_road_m(place) - kToEdgeM) > slack_m) return false;
    const auto along = ground.edge_direction(place);
    if (!along) return false;
    const Eigen::Vector2d across(-along->y(), along->x());
    const std::array<Eigen::Vector2d, 4> corners = {
        place + 2.1 * *along + 0.86 * across, place + 2.1 * *along - 0.86 * across,
        place - 2.1 * *along + 0.86 * across, place - 2.1 * *along - 0.86 * across};
    return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector2d& corner) {
      return ground.inside_road_m(corner) > 0.0;
    });
  };
  furnish(ground, 7.0, share, seed, kParkedCars, 32, is_suitable,
          [&](const auto& place, const auto& draws) {
            const auto [size, facing] = draws.at(kShapeDraw);
            const Eigen::Vector2d along = ground.edge_direction(place).value();
            Mover car{.parts = car_parts(between(0.9, 1.0, size)),
                      .from_in_enu_m = place,
                      .to_in_enu_m = place + (facing < 0.5 ? 1.0 : -1.0) * along,
                      .speed_mps = 0.0};
            car.place(0.0, solids);
          });
}

void add_moving_cars(const Ground& ground,
                     double share,
                     std::uint64_t seed,
                     std::vector<Mover>& movers) {
  const auto is_lane = [&](const Eigen::Vector2d& place) {
    return ground.inside_road_m(place) >= 1.2;
  };
  furnish(ground, 40.0, share, seed, kMovingCars, 16, is_lane,
          [&](const auto& place, const auto& draws) {
            const auto run = longest_run(place, is_lane, 25.0, 120.0);
            if (!run) return;
            const auto [speed, phase] = draws.at(kMotionDraw);
            movers.push_back({.parts = car_parts(between(0.9, 1.0, draws.at(kShapeDraw)[0])),
                              .from_in_enu_m = run->from_in_enu_m,
                              .to_in_enu_m = run->to_in_enu_m,
                              .ground_m = 0.0,
                              .speed_mps = between(3.0, 9.0, speed),
                              .phase_m = 240.0 * phase});
          });
}

void add_pedestrians(const Ground& ground,
                     double share,
                     std::uint64_t seed,
                     std::vector<Mover>& movers) {
  const double clearance_m = std::max(0.3, ground.map().metres_per_cell);
  const auto is_way = [&](const Eigen::Vector2d& place) {
    return ground.inside_open_m(place) >= clearance_m && ground.to_road_m(place) <= 8.0;
  };
  furnish(ground, 20.0, share, seed, kPedestrians, 16, is_way,
          [&](const auto& place, const auto& draws) {
            const auto run = longest_run(place, is_way, 5.0, 40.0);
            if (!run) return;
            const auto [speed, phase] = draws.at(kMotionDraw);
            const double height_m = between(1.5, 1.9, draws.at(kShapeDraw)[0]);
            movers.push_back({.parts = {upright(Solid::Shape::kCapsule, kPedestrian,
                                                Eigen::Vector2d::Zero(), 0.0, height_m, 0.25)},
                              .from_in_enu_m = run->from_in_enu_m,
                              .to_in_enu_m = run->to_in_enu_m,
                              .ground_m = ground.height_m(place),
                              .speed_mps = between(0.8, 1.6, speed),
                              .phase_m = 80.0 * phase});
          });
}

}  // namespace nadir
