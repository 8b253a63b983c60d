// SPDX-License-Identifier: Apache-2.0
#include "core/geo/project_plane.h"

#include <gmock/gmock.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "core/base/random.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace project_plane_test {

using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ProjectPlane plane_at(double latitude_deg, double longitude_deg) {
  auto plane = ProjectPlane::create({latitude_deg, longitude_deg});
  if (!plane) throw std::runtime_error(error_text(plane));
  return *plane;
}

TEST(ProjectPlane, TheOriginIsZero) {
  for (const double latitude_deg : {-88.9, -33.0, 0.0, 48.98, 89.0}) {
    const Eigen::Vector2d at_m =
        plane_at(latitude_deg, 8.39).enu_from_geodetic({latitude_deg, 8.39});
    EXPECT_EQ(at_m, Eigen::Vector2d(0.0, 0.0)) << latitude_deg;
  }
}

TEST(ProjectPlane, EastIsXAndNorthIsY) {
  const ProjectPlane plane = plane_at(48.0, 8.0);
  EXPECT_GT(plane.enu_from_geodetic({48.0, 8.001}).x(), 70.0);
  EXPECT_GT(plane.enu_from_geodetic({48.001, 8.0}).y(), 110.0);
}

TEST(ProjectPlane, TheMeridianHasItsTrueLength) {
  // From the equator to the pole along WGS 84: 10,001,965.729 m (published in every table of the
  // ellipsoid).
  EXPECT_NEAR(plane_at(0.0, 8.0).enu_from_geodetic({90.0, 8.0}).y(), 10'001'965.729, 5e-4);
}

TEST(ProjectPlane, NearTheOriginMetresAreTrueInBothDirections) {
  // Radii of curvature of the ellipsoid: M along the meridian, N across it.
  const double latitude_deg = 48.98;
  const double degree_rad = std::numbers::pi / 180.0;
  const double a_m = 6'378'137.0;
  const double e2 = 0.00669437999014;
  const double sine = std::sin(latitude_deg * degree_rad);
  const double n_m = a_m / std::sqrt(1.0 - e2 * sine * sine);
  const double m_m = n_m * (1.0 - e2) / (1.0 - e2 * sine * sine);
  const ProjectPlane plane = plane_at(latitude_deg, 8.39);
  const double step_deg = 0.001;
  EXPECT_NEAR(plane.enu_from_geodetic({latitude_deg, 8.39 + step_deg}).x(),
              n_m * std::cos(latitude_deg * degree_rad) * step_deg * degree_rad, 1e-6);
  const double north_m = plane.enu_from_geodetic({latitude_deg + step_deg, 8.39}).y();
  const double south_m = -plane.enu_from_geodetic({latitude_deg - step_deg, 8.39}).y();
  EXPECT_NEAR(0.5 * (north_m + south_m), m_m * step_deg * degree_rad, 1e-6);
}

TEST(ProjectPlane, FiveKilometresAwayTheScaleIsWithinAThirdOfAPartPerMillion) {
  const ProjectPlane plane = plane_at(48.98, 8.39);
  // A short step north, five kilometres east: its length against the same step on the meridian.
  const Geodetic east = plane.geodetic_from_enu({5'000.0, 0.0});
  const Eigen::Vector2d step_m =
      plane.enu_from_geodetic({east.latitude_deg + 0.01, east.longitude_deg}) -
      plane.enu_from_geodetic(east);
  const double true_m = plane.enu_from_geodetic({east.latitude_deg + 0.01, 8.39}).y() -
                        plane.enu_from_geodetic({east.latitude_deg, 8.39}).y();
  EXPECT_NEAR(step_m.norm() / true_m - 1.0, 0.31e-6, 0.01e-6);
}

TEST(ProjectPlane, ThereAndBackLosesNothing) {
  const ProjectPlane plane = plane_at(33.450112, -83.901223);
  for (std::uint32_t i = 0; i < 200; ++i) {
    const auto [a, b] = uniforms({1, 99, i, 0, 0});
    const Eigen::Vector2d at_m(2e5 * (a - 0.5), 2e5 * (b - 0.5));
    ASSERT_TRUE(plane.enu_from_geodetic(plane.geodetic_from_enu(at_m)).isApprox(at_m, 1e-12));
  }
}

TEST(ProjectPlane, PointsOnBothSidesOfAUtmZoneEdgeShareOneFrame) {
  const ProjectPlane plane = plane_at(48.0, 12.0);
  const Eigen::Vector2d west_m = plane.enu_from_geodetic({48.0, 11.9999});
  const Eigen::Vector2d east_m = plane.enu_from_geodetic({48.0, 12.0001});
  EXPECT_NEAR((east_m - west_m).norm(), 14.92, 0.01);
  EXPECT_THAT(utm_text({48.0, 11.9999}), HasSubstr("32U 723"));
  EXPECT_THAT(utm_text({48.0, 12.0001}), HasSubstr("33U 276"));
}

TEST(ProjectPlane, TheDateLineDoesNotCutAMap) {
  const ProjectPlane plane = plane_at(-17.0, 180.0);
  EXPECT_NEAR(plane.enu_from_geodetic({-17.0, -179.999}).x(), 106.5, 0.1);
  EXPECT_NEAR(plane.enu_from_geodetic({-17.0, 179.999}).x(), -106.5, 0.1);
}

TEST(ProjectPlane, NorthOfTheGridTurnsWestAsOneGoesEast) {
  // On the northern half meridians lean towards the central one: grid north is clockwise of true
  // north in the east.
  const ProjectPlane plane = plane_at(48.0, 8.0);
  EXPECT_NEAR(plane.convergence_deg({0.0, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(plane.convergence_deg({5'000.0, 0.0}), -0.0498, 2e-4);
  EXPECT_NEAR(plane.convergence_deg({-5'000.0, 0.0}), 0.0498, 2e-4);
  EXPECT_GT(plane_at(-48.0, 8.0).convergence_deg({5'000.0, 0.0}), 0.0);
}

TEST(ProjectPlane, ConvergenceIsTheAngleBetweenAStepNorthAndTheYAxis) {
  const ProjectPlane plane = plane_at(60.0, 20.0);
  const Eigen::Vector2d at_m(40'000.0, -30'000.0);
  Geodetic north = plane.geodetic_from_enu(at_m);
  north.latitude_deg += 1e-5;
  const Eigen::Vector2d true_north = plane.enu_from_geodetic(north) - at_m;
  // True north lies at this angle counter-clockwise from grid north; the convergence goes the other
  // way.
  const double angle_deg = std::atan2(-true_north.x(), true_north.y()) * 180.0 / std::numbers::pi;
  EXPECT_NEAR(plane.convergence_deg(at_m), -angle_deg, 1e-6);
}

TEST(ProjectPlane, RefusesOriginsWithoutAnEast) {
  EXPECT_EQ(error_code(ProjectPlane::create({kNan, 0.0})), ErrorCode::kInvalidOptions);
  EXPECT_FALSE(ProjectPlane::create({0.0, kNan}));
  EXPECT_FALSE(ProjectPlane::create({90.0, 0.0}));
  EXPECT_FALSE(ProjectPlane::create({0.0, std::numeric_limits<double>::infinity()}));
  EXPECT_THAT(error_text(ProjectPlane::create({93.0, 8.0})),
              HasSubstr("latitude 93 is not in [-89, 89]"));
  // Metres where degrees belong.
  EXPECT_THAT(error_text(ProjectPlane::create({48.0, 458'074.6})), HasSubstr("longitude 458074.6"));
}

TEST(ProjectPlane, APlaceThatIsNotOnTheEarthHasNoCoordinates) {
  const ProjectPlane plane = plane_at(48.0, 8.0);
  EXPECT_TRUE(plane.enu_from_geodetic({kNan, 8.0}).hasNaN());
  EXPECT_TRUE(plane.enu_from_geodetic({93.0, 8.0}).hasNaN());
}

/// PROJ through GDAL: another implementation of the same projection.
Eigen::Vector2d proj_enu(const std::string& wkt, const Geodetic& position) {
  OGRSpatialReference wgs84;
  wgs84.importFromEPSG(4326);
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);  // else latitude would come first
  OGRSpatialReference plane;
  EXPECT_EQ(plane.importFromWkt(wkt.c_str()), OGRERR_NONE);
  plane.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&wgs84, &plane));
  double x = position.longitude_deg;
  double y = position.latitude_deg;
  EXPECT_TRUE(transformation != nullptr && transformation->Transform(1, &x, &y) != 0);
  return {x, y};
}

TEST(ProjectPlane, ItsWktMeansTheSamePlaneToGdal) {
  for (const Geodetic& origin :
       {Geodetic{33.450112345678, -83.901223456789}, Geodetic{-17.0, 179.9}, Geodetic{1e-7, -1e-7},
        Geodetic{69.7, 18.9}}) {
    const ProjectPlane plane = plane_at(origin.latitude_deg, origin.longitude_deg);
    for (const double step_deg : {0.0, 0.05, -0.3}) {
      const Geodetic position{origin.latitude_deg + step_deg,
                              origin.longitude_deg - 2.0 * step_deg};
      const Eigen::Vector2d difference_m =
          proj_enu(plane.wkt(), position) - plane.enu_from_geodetic(position);
      EXPECT_LT(difference_m.norm(), 1e-6) << origin.latitude_deg << " step " << step_deg;
    }
  }
}

TEST(ProjectPlane, ItsWktKeepsEveryDigitOfTheOrigin) {
  const ProjectPlane plane = plane_at(33.450112345678, -83.901223456789);
  OGRSpatialReference read;
  ASSERT_EQ(read.importFromWkt(plane.wkt().c_str()), OGRERR_NONE);
  EXPECT_EQ(read.GetNormProjParm("latitude_of_origin"), 33.450112345678);
  EXPECT_EQ(read.GetNormProjParm("central_meridian"), -83.901223456789);
  EXPECT_EQ(read.GetNormProjParm("scale_factor"), 1.0);
}

TEST(ProjectPlane, EqualsAnotherWithTheSameOriginOnly) {
  EXPECT_EQ(plane_at(48.0, 8.0), plane_at(48.0, 8.0));
  EXPECT_FALSE(plane_at(48.0, 8.0) == plane_at(48.0, 8.000000000001));
}

TEST(UtmText, AgreesWithThePublishedExampleOfThePythonPackage) {
  // README of the package `utm`: from_latlon(51.2, 7.5) is (395201.3103811303, 5673135.241182375,
  // 32, 'U').
  EXPECT_EQ(utm_text({51.2, 7.5}), "32U 395201.3 E 5673135.2 N");
  EXPECT_EQ(mgrs_text({51.2, 7.5}), "32U LB 95201 73135");
}

TEST(MgrsText, AgreesWithThePublishedPlaceOfTheWashingtonMonument) {
  // National Geodetic Survey: N38 53 22.08377 W77 02 06.86378; United States National Grid:
  // 18SUJ2348306479.
  const Geodetic monument{38.0 + 53.0 / 60.0 + 22.08377 / 3600.0,
                          -(77.0 + 2.0 / 60.0 + 6.86378 / 3600.0)};
  EXPECT_EQ(mgrs_text(monument), "18S UJ 23483 06479");
  EXPECT_EQ(mgrs_text(monument, 3), "18S UJ 234 064");
  EXPECT_EQ(mgrs_text(monument, 0), "18S UJ");
}

TEST(MgrsText, CutsDigitsOffAndDoesNotRound) {
  EXPECT_EQ(mgrs_text({51.2, 7.5}, 4), "32U LB 9520 7313");  // 73135 would round to 7314
}

TEST(UtmText, KnowsTheExceptionsOfNorwayAndSvalbard) {
  EXPECT_THAT(utm_text({60.39, 5.32}), HasSubstr("32V "));   // Bergen, by longitude in zone 31
  EXPECT_THAT(utm_text({78.22, 15.65}), HasSubstr("33X "));  // Longyearbyen
}

TEST(UtmText, HasAnAnswerAtThePolesAndOnTheSouthernHalf) {
  EXPECT_EQ(utm_text({90.0, 0.0}), "Z 2000000.0 E 2000000.0 N");
  EXPECT_EQ(mgrs_text({90.0, 0.0}), "Z AH 00000 00000");
  EXPECT_THAT(utm_text({-33.8568, 151.2153}), HasSubstr("56H 334"));  // Sydney Opera House
}

TEST(GeodeticText, ReadsAsPeopleWriteIt) {
  EXPECT_EQ(geodetic_text({33.450112, -83.901223}), "33.450112 N 83.901223 W");
  EXPECT_EQ(geodetic_text({-33.8568, 151.2153}), "33.856800 S 151.215300 E");
  EXPECT_EQ(geodetic_text({-1e-9, -1e-9}), "0.000000 N 0.000000 E");
  EXPECT_EQ(geodetic_text({10.0, 190.0}), "10.000000 N 170.000000 W");
}

TEST(GeodeticText, APlaceThatIsNotOnTheEarthSaysSo) {
  for (const Geodetic& nowhere : {Geodetic{kNan, 0.0}, Geodetic{0.0, kNan}, Geodetic{90.1, 0.0},
                                  Geodetic{0.0, std::numeric_limits<double>::infinity()}}) {
    EXPECT_EQ(geodetic_text(nowhere), "no place");
    EXPECT_EQ(utm_text(nowhere), "no place");
    EXPECT_EQ(mgrs_text(nowhere), "no place");
  }
}

}  // namespace project_plane_test
}  // namespace nadir
