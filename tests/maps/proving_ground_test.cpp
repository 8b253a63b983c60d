// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "core/map/overhead_map_file.h"
#include "core/sim/flight_path.h"
#include "core/sim/route.h"
#include "maps/draw/ground.h"

namespace nadir::town {
namespace proving_ground_test {

using ::testing::ElementsAre;

std::filesystem::path package() { return std::filesystem::path(NADIR_MAPS) / "proving-ground"; }

class ProvingGround : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_map = new Result<OverheadMap>(read_overhead_map(package()));
    shared_ground = new Ground(draw_ground(proving_ground_layout()));
  }
  static void TearDownTestSuite() {
    delete shared_map;
    delete shared_ground;
  }
  void SetUp() override { ASSERT_TRUE(shared_map->has_value()) << shared_map->error().message; }

  [[nodiscard]] static const OverheadMap& map() { return **shared_map; }
  [[nodiscard]] static const Ground& ground() { return *shared_ground; }

 private:
  static inline Result<OverheadMap>* shared_map = nullptr;
  static inline Ground* shared_ground = nullptr;
};

struct RouteOnMap {
  Route route;
  double lap_m = 0.0;
  std::vector<ClassId> classes;  ///< Every 0.1 m.
};

RouteOnMap follow(const OverheadMap& map, const std::string& name) {
  auto route = read_route(package() / "routes" / name);
  EXPECT_TRUE(route) << route.error().message;
  if (!route) return {};
  RouteOnMap result{*route, 0.0, {}};
  const auto path = build_flight_path(*route);
  EXPECT_TRUE(path) << path.error().message;
  if (!path) return result;
  result.lap_m = path->length_m / route->laps;
  for (double along_m = 0.0; along_m < path->length_m; along_m += 0.1) {
    const auto station = path->at(along_m);
    const Eigen::Vector2d p = station.piece->place_in_enu_m(station.along_m);
    EXPECT_TRUE(map.contains(p)) << name << " leaves the map at " << p.transpose();
    result.classes.push_back(map.class_at(p));
  }
  return result;
}

double share_of(const RouteOnMap& followed, std::initializer_list<ClassId> ids) {
  const auto on = std::count_if(followed.classes.begin(), followed.classes.end(), [&](ClassId id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  });
  return static_cast<double>(on) / static_cast<double>(followed.classes.size());
}

std::vector<std::string> named_waypoints(const Route& route) {
  std::vector<std::string> names;
  std::copy_if(route.waypoint_names.begin(), route.waypoint_names.end(), std::back_inserter(names),
               [](const std::string& name) { return !name.empty(); });
  return names;
}

TEST_F(ProvingGround, RedrawingGivesTheCommittedLabels) {
  EXPECT_EQ(draw_labels(ground()), map().labels);
}

TEST_F(ProvingGround, MeasuresTwoHundredAndFiftyByTwoHundredMetresAboutItsAnchor) {
  EXPECT_EQ(map().labels.width(), 2500);
  EXPECT_EQ(map().labels.height(), 2000);
  EXPECT_NEAR(map().metres_per_cell, 0.1, 1e-12);
  EXPECT_NEAR((map().top_left_in_enu_m - Eigen::Vector2d(-125.0, 100.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(map().plane.origin().latitude_deg, 32.4, 0.1);
  EXPECT_NEAR(map().plane.origin().longitude_deg, -83.7, 0.1);
}

TEST_F(ProvingGround, UsesTheEightClassesOfTheThesisAndNothingThatMoves) {
  std::array<int, 256> counts{};
  for (const ClassId id : map().labels.values()) ++counts[id];
  const std::set<int> expected = {kRoad,    kSidewalk, kBuilding,    kFence,       kVegetation,
                                  kTerrain, kCurb,     kLaneMarking, kUnclassified};
  for (int id = 0; id < 256; ++id) {
    if (expected.contains(id)) {
      EXPECT_GT(counts[static_cast<std::size_t>(id)], 5000)
          << class_info(static_cast<ClassId>(id)).name;
    } else {
      EXPECT_EQ(counts[static_cast<std::size_t>(id)], 0) << id;
    }
  }
}

TEST_F(ProvingGround, IsUnderSixMegabytes) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(package())) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  EXPECT_LT(bytes, 6'000'000U);
  EXPECT_LT(std::filesystem::file_size(package() / "overview.png"), 200'000U);
}

TEST_F(ProvingGround, SaysThatTheTownIsMadeUpAndFree) {
  const auto provenance = read_map_provenance(package());
  ASSERT_TRUE(provenance) << provenance.error().message;
  EXPECT_EQ(provenance->licence, "CC0-1.0");
  EXPECT_THAT(provenance->source, ::testing::HasSubstr("no such place exists"));
}

TEST_F(ProvingGround, HasTwentyFiveToFiftyBuildingsThatStandOnNoRoadAndNotInEachOther) {
  const TownLayout town = proving_ground_layout();
  EXPECT_GE(town.buildings.size(), 25U);
  EXPECT_LE(town.buildings.size(), 50U);
  Raster<int> owner(ground().grid.columns, ground().grid.rows, -1);
  for (int i = 0; i < static_cast<int>(town.buildings.size()); ++i) {
    const Polygon& footprint = town.buildings[static_cast<std::size_t>(i)].footprint;
    int shared = 0, on_street = 0;
    for_cells(ground().grid, bounds(footprint.corners), [&](int column, int row, const Point& p) {
      if (!contains(footprint, p)) return;
      if (owner.at(column, row) >= 0) ++shared;
      owner.at(column, row) = i;
      if (ground().road_distance_m.at(column, row) < 0.3F) ++on_street;
    });
    EXPECT_EQ(shared, 0) << "building " << i;
    EXPECT_EQ(on_street, 0) << "building " << i;
  }
}

TEST_F(ProvingGround, FencesHedgesCarsAndTreesKeepOffTheStreets) {
  const TownLayout town = proving_ground_layout();
  for (std::size_t i = 0; i < ground().surface.size(); ++i) {
    if (ground().surface.values()[i] != Surface::kFence) continue;
    ASSERT_GT(ground().road_distance_m.values()[i], 0.2F);
    ASSERT_NE(ground().bare.values()[i], Surface::kSidewalk);
  }
  for (const Tree& tree : town.trees) {
    const double distance_m = street_place(town, tree.centre).distance_m;
    EXPECT_GT(distance_m, 0.2) << tree.centre.transpose();
  }
}

TEST_F(ProvingGround, LoopIsFourHundredMetresOfRoad) {
  const RouteOnMap loop = follow(map(), "loop.toml");
  EXPECT_NEAR(loop.lap_m, 400.0, 20.0);
  EXPECT_THAT(named_waypoints(loop.route), ElementsAre("S", "1", "2", "3"));
  EXPECT_EQ(share_of(loop, {kBuilding, kUnclassified}), 0.0);
  EXPECT_EQ(share_of(loop, {kRoad, kLaneMarking}), 1.0);
}

TEST_F(ProvingGround, FigureEightIsTwoLapsOfRoadThroughTheWaypointsOfTheThesis) {
  const RouteOnMap eight = follow(map(), "figure-eight.toml");
  EXPECT_EQ(eight.route.laps, 2);
  EXPECT_THAT(named_waypoints(eight.route), ElementsAre("S", "1", "2", "3", "4", "1", "2", "5"));
  EXPECT_EQ(share_of(eight, {kBuilding, kUnclassified}), 0.0);
  EXPECT_EQ(share_of(eight, {kRoad, kLaneMarking}), 1.0);
}

TEST_F(ProvingGround, PictureLiesOnItsLabels) {
  const auto picture = read_overhead_image(package());
  ASSERT_TRUE(picture && picture->has_value());
  ASSERT_EQ((*picture)->width(), map().labels.width());
  ASSERT_EQ((*picture)->height(), map().labels.height());
  // Paint is brighter than the road, and nowhere more so than when the two are not moved against
  // each other.
  const auto paint_brightness = [&](int right, int down) {
    double sum = 0.0;
    int count = 0;
    for (int row = 10; row < 1990; ++row) {
      for (int column = 10; column < 2490; ++column) {
        if (map().labels.at(column, row) != kLaneMarking) continue;
        const Colour& colour = (*picture)->at(column + right, row + down);
        sum += colour.red + colour.green;
        ++count;
      }
    }
    return sum / count;
  };
  const double in_place = paint_brightness(0, 0);
  for (const auto& [right, down] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {3, 3}}) {
    EXPECT_GT(in_place, paint_brightness(right, down) + 2.0) << right << ", " << down;
  }
}

}  // namespace proving_ground_test
}  // namespace nadir::town
