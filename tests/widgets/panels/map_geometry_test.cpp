// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_geometry.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "tests/support/drawn_map.h"

namespace nadir {
namespace map_geometry_test {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kPi = std::numbers::pi;
constexpr PageRect kPage{0.0, 0.0, 800.0, 600.0};

MapCamera turned_camera() { return {{120.0, -35.0}, 0.25, 2.2}; }

TEST(MapGeometry, PanningPutsAPlaceUnderAPointWhicheverWayTheMapIsTurned) {
  for (const double up_rad : {kPi / 2.0, 0.3, 2.2, -1.9}) {
    MapCamera camera = turned_camera();
    camera.up_rad = up_rad;
    const Eigen::Vector2d place(90.0, -50.0);
    const Eigen::Vector2d point(123.0, 456.0);
    const MapCamera moved = with_ground_at(camera, place, point, kPage);
    EXPECT_LT((moved.page_from_enu(place, kPage) - point).norm(), 1e-9);
    EXPECT_EQ(moved.metres_per_px, camera.metres_per_px);
    EXPECT_EQ(moved.up_rad, camera.up_rad);
  }
}

TEST(MapGeometry, ZoomingLeavesWhatIsUnderThePointAndScalesTheRest) {
  const MapCamera camera = turned_camera();
  const Eigen::Vector2d point(700.0, 80.0);
  const Eigen::Vector2d stays = camera.enu_from_page(point, kPage);
  const MapCamera nearer = zoomed_at(camera, 4.0, point, kPage);
  EXPECT_LT((nearer.enu_from_page(point, kPage) - stays).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(nearer.metres_per_px, camera.metres_per_px / 4.0);
  const Eigen::Vector2d ten_px_on = nearer.enu_from_page(point + Eigen::Vector2d(10.0, 0.0), kPage);
  EXPECT_NEAR((ten_px_on - stays).norm(), 10.0 * camera.metres_per_px / 4.0, 1e-9);
}

TEST(MapGeometry, TurningIsTheAngleOfTheMouseAboutTheMiddle) {
  const Eigen::Vector2d middle = kPage.centre();
  EXPECT_NEAR(turned_deg(middle + Eigen::Vector2d(100, 0), middle + Eigen::Vector2d(0, 50), kPage),
              90.0, 1e-9);
  EXPECT_NEAR(turned_deg(middle + Eigen::Vector2d(0, 50), middle + Eigen::Vector2d(100, 0), kPage),
              -90.0, 1e-9);
  EXPECT_EQ(turned_deg(middle, middle + Eigen::Vector2d(100, 0), kPage), 0.0);
}

TEST(MapGeometry, CameraOfAnUnchosenWidthShowsEverythingWhicheverWayIsUp) {
  GroundBounds all;
  all.include({-40.0, 10.0});
  all.include({260.0, 90.0});
  all.include({std::nan(""), 1.0});
  for (const double up_rad : {kPi / 2.0, 0.0, 0.9}) {
    MapLook look;
    look.up_rad = up_rad;
    const MapCamera camera = map_camera(look, kPage, all);
    for (const Eigen::Vector2d& corner :
         {Eigen::Vector2d(-40.0, 10.0), {260.0, 10.0}, {260.0, 90.0}, {-40.0, 90.0}}) {
      const Eigen::Vector2d at = camera.page_from_enu(corner, kPage);
      EXPECT_TRUE(at.x() > 0.0 && at.x() < 800.0 && at.y() > 0.0 && at.y() < 600.0)
          << at.transpose();
    }
  }
}

TEST(MapGeometry, CameraOfALookShowsItsWidthAroundItsCentre) {
  MapLook look;
  look.centre_in_enu_m = {5.0, 6.0};
  look.width_m = 400.0;
  const MapCamera camera = map_camera(look, kPage, {});
  EXPECT_DOUBLE_EQ(camera.metres_per_px, 0.5);
  EXPECT_LT((camera.enu_from_page({800.0, 300.0}, kPage) - Eigen::Vector2d(205.0, 6.0)).norm(),
            1e-9);
}

TEST(Measure, AddsLegsAndGivesTheCompassCourseOfTheLast) {
  const std::vector<Eigen::Vector2d> points = {{0.0, 0.0}, {3.0, 4.0}, {3.0, 16.0}};
  const Measured measured = measure(points);
  EXPECT_DOUBLE_EQ(measured.length_m, 17.0);
  EXPECT_DOUBLE_EQ(*measured.last_leg_m, 12.0);
  EXPECT_DOUBLE_EQ(*measured.bearing_deg, 0.0);
  EXPECT_DOUBLE_EQ(*measured.area_m2, 18.0);  // base 12, height 3
}

TEST(Measure, KnowsTheEightCourses) {
  struct Course {
    Eigen::Vector2d way;
    double compass_deg;
  };
  for (const auto& [way, compass_deg] : {Course{{0, 1}, 0.0},
                                         {{1, 1}, 45.0},
                                         {{1, 0}, 90.0},
                                         {{1, -1}, 135.0},
                                         {{0, -1}, 180.0},
                                         {{-1, -1}, 225.0},
                                         {{-1, 0}, 270.0},
                                         {{-1, 1}, 315.0}}) {
    const std::vector<Eigen::Vector2d> points = {{7.0, 8.0}, Eigen::Vector2d(7.0, 8.0) + way};
    EXPECT_NEAR(*measure(points).bearing_deg, compass_deg, 1e-9);
  }
}

TEST(Measure, AreaDoesNotDependOnDirectionStartOrPlaceOnThePlane) {
  const Eigen::Vector2d far(412'345.25, -873'210.5);
  // An L of 4 x 4 m without its corner of 2 x 2 m.
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(0, 0), {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}) {
    points.push_back(far + corner);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(*measure(points).area_m2, 12.0, 1e-6);
    std::rotate(points.begin(), points.begin() + 1, points.end());
  }
  std::reverse(points.begin(), points.end());
  EXPECT_NEAR(*measure(points).area_m2, 12.0, 1e-6);
}

TEST(Measure, SaysNothingOfWhatThereIsNotYet) {
  EXPECT_EQ(measure({}).length_m, 0.0);
  const std::vector<Eigen::Vector2d> one = {{1.0, 2.0}};
  EXPECT_FALSE(measure(one).last_leg_m || measure(one).bearing_deg || measure(one).area_m2);
  const std::vector<Eigen::Vector2d> twice = {{1.0, 2.0}, {1.0, 2.0}};
  EXPECT_EQ(*measure(twice).last_leg_m, 0.0);
  EXPECT_FALSE(measure(twice).bearing_deg);
}

TEST(MapTexts, ChangeTheUnitWhereNumbersGrowLong) {
  EXPECT_EQ(distance_text(12.344), "12.34 m");
  EXPECT_EQ(distance_text(999.99), "999.99 m");
  EXPECT_EQ(distance_text(999.996), "1.000 km");
  EXPECT_EQ(distance_text(1234.5), "1.234 km");
  EXPECT_EQ(area_text(56.74), "56.7 m²");
  EXPECT_EQ(area_text(12'345.0), "1.23 ha");
  EXPECT_EQ(area_text(2'500'000.0), "2.50 km²");
  EXPECT_EQ(metres_text(-0.001), "0.00");
  EXPECT_EQ(metres_text(-0.01), "-0.01");
}

TEST(NearestParticle, IsTheOneThatAFullSearchFinds) {
  ParticleSet particles;
  particles.resize(500);
  for (std::size_t i = 0; i < 500; ++i) {
    const auto [u, v] = uniforms({.seed = 3, .particle = static_cast<std::uint32_t>(i)});
    particles.set_pose(i, {120.0 + 60.0 * (u - 0.5), -35.0 + 60.0 * (v - 0.5), 0.0});
    particles.weight[i] = 1.0 / 500.0;
  }
  const MapCamera camera = turned_camera();
  for (int k = 0; k < 30; ++k) {
    const Eigen::Vector2d point(330.0 + 5.0 * k, 400.0 - 7.0 * k);
    double least = 1e9;
    int expected = -1;
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector2d at =
          camera.page_from_enu(particles.pose(static_cast<std::size_t>(i)).translation_m(), kPage);
      if ((at - point).norm() < least) {
        least = (at - point).norm();
        expected = i;
      }
    }
    const auto found = nearest_particle(particles, camera, kPage, point, 14.0);
    if (least < 13.999) {
      EXPECT_EQ(found, expected);
    } else if (least > 14.001) {
      EXPECT_EQ(found, std::nullopt);
    }
  }
}

TEST(MapReadout, KnowsTheCellOnBothSidesOfItsBorder) {
  const OverheadMap map = drawn_map(2.0, {"RS",    //
                                          "B."});  // cell (0, 0) spans x 0 to 2, y 2 to 4
  const auto name = [&](double x, double y) {
    return map_readout({x, y}, &map, nullptr).class_name;
  };
  EXPECT_EQ(name(1.999, 2.001), "road");
  EXPECT_EQ(name(2.001, 2.001), "sidewalk");
  EXPECT_EQ(name(1.999, 1.999), "building");
  EXPECT_EQ(name(2.001, 1.999), "unclassified");
  EXPECT_EQ(name(-0.001, 1.0), "off the map");
  EXPECT_EQ(name(1.0, 4.001), "off the map");
}

TEST(MapReadout, GivesTheCoordinatesThatThePlaneHasThere) {
  const auto plane = ProjectPlane::create({33.45, -83.9}).value();
  const MapReadout at_origin = map_readout({0.0, 0.0}, nullptr, &plane);
  EXPECT_EQ(at_origin.geodetic, geodetic_text({33.45, -83.9}));
  EXPECT_EQ(at_origin.utm, utm_text({33.45, -83.9}));
  EXPECT_EQ(at_origin.mgrs, mgrs_text({33.45, -83.9}));
  EXPECT_THAT(at_origin.class_name, IsEmpty());
  const MapReadout unknown = map_readout({5.0, 6.0}, nullptr, nullptr);
  EXPECT_TRUE(unknown.geodetic.empty() && unknown.utm.empty() && unknown.mgrs.empty());
  EXPECT_THAT(map_readout({1e9, 0.0}, nullptr, &plane).geodetic, IsEmpty());
}

}  // namespace map_geometry_test
}  // namespace nadir
