// SPDX-License-Identifier: Apache-2.0
#include "core/session/place_hold.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/angle.h"
#include "tests/support/drawn_map.h"
#include "tests/support/made_topview.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace place_hold_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double kStepM = 0.2;
constexpr int kCount = 63;

/// A surface of 12.6 m across, its costs by the place, metres east and north of the estimate.
MomentSurface surface_of(const std::function<double(double east_m, double north_m)>& cost) {
  MomentSurface surface;
  surface.volume.grid = {
      .count_x = kCount, .count_y = kCount, .count_yaw = 1, .step_m = kStepM, .step_rad = 0.1};
  for (int y = 0; y < kCount; ++y) {
    for (int x = 0; x < kCount; ++x) {
      surface.plane.push_back(
          static_cast<float>(cost((x - kCount / 2) * kStepM, (y - kCount / 2) * kStepM)));
    }
  }
  return surface;
}

/// A bowl that rises by 0.005 within so many metres along a bearing, and across it.
std::function<double(double, double)> bowl(double along_m, double across_m, double bearing_deg) {
  const double angle = Angle::degrees(bearing_deg).radians();
  return [=](double east_m, double north_m) {
    const double along = east_m * std::sin(angle) + north_m * std::cos(angle);
    const double across = east_m * std::cos(angle) - north_m * std::sin(angle);
    return 0.1 + 0.005 * (std::pow(along / along_m, 2) + std::pow(across / across_m, 2));
  };
}

TEST(PlaceHold, FindsTheLongAxisOfABowlAndItsSize) {
  for (const double bearing_deg : {0.0, 20.0, 60.0, 90.0, 135.0, 170.0}) {
    const PlaceHold hold = place_hold(surface_of(bowl(4.0, 0.8, bearing_deg)));
    EXPECT_NEAR(std::remainder(hold.bearing_deg - bearing_deg, 180.0), 0.0, 3.0) << bearing_deg;
    EXPECT_GE(hold.bearing_deg, 0.0);
    EXPECT_LT(hold.bearing_deg, 180.0);
    EXPECT_NEAR(hold.along_m, 8.0, 2.0 * kStepM) << bearing_deg;
    EXPECT_NEAR(hold.across_m, 1.6, 2.0 * kStepM) << bearing_deg;
    EXPECT_FALSE(hold.is_along_open || hold.is_across_open);
  }
}

TEST(PlaceHold, OfOneSampleIsThatSample) {
  const PlaceHold hold = place_hold(surface_of(bowl(0.05, 0.05, 0.0)));
  EXPECT_DOUBLE_EQ(hold.along_m, kStepM);
  EXPECT_DOUBLE_EQ(hold.across_m, kStepM);
  EXPECT_EQ(
      in_words(hold, 0.0),
      "The place is held well in every direction: the cost rises by at most 0.005 over 0.2 m.");
}

TEST(PlaceHold, TakesNoPlaceThatIsCutOffByWorseOnes) {
  const auto here = bowl(1.0, 1.0, 0.0);
  const PlaceHold alone = place_hold(surface_of(here));
  const PlaceHold with_another = place_hold(surface_of([&](double east_m, double north_m) {
    return std::min(here(east_m, north_m), here(east_m - 4.0, north_m));
  }));
  EXPECT_DOUBLE_EQ(with_another.along_m, alone.along_m);
  EXPECT_DOUBLE_EQ(with_another.across_m, alone.across_m);
}

TEST(PlaceHold, SaysWhereTheSurfaceEndsBeforeTheValleyDoes) {
  const PlaceHold hold = place_hold(surface_of(bowl(100.0, 0.8, 90.0)));
  EXPECT_TRUE(hold.is_along_open);
  EXPECT_FALSE(hold.is_across_open);
  EXPECT_NEAR(hold.along_m, kCount * kStepM, 1e-9);
  EXPECT_THAT(in_words(hold, 0.0), HasSubstr("over more than 13 m that way, 1.8 m across it."));
  const PlaceHold nothing_seen = place_hold(surface_of([](double, double) { return 0.5; }));
  EXPECT_TRUE(nothing_seen.is_along_open && nothing_seen.is_across_open);
  EXPECT_THAT(in_words(nothing_seen, 0.0),
              StartsWith("The place is held poorly in every direction: "));
}

TEST(PlaceHold, OfAnEstimateOnASlopeSaysWhereTheCostFalls) {
  const auto bottom_at = [](double east_m, double north_m) {
    return surface_of([=](double east, double north) {
      return 0.01 * (std::pow(east - east_m, 2) + std::pow(north - north_m, 2));
    });
  };
  const PlaceHold south = place_hold(bottom_at(0.0, -3.0));
  EXPECT_NEAR(south.falls_by, 0.09, 1e-6);
  EXPECT_NEAR(south.best_m, 3.0, 1e-9);
  EXPECT_NEAR(south.best_bearing_deg, 180.0, 1e-9);
  EXPECT_EQ(in_words(south, 0.0),
            "The place is not held: the cost falls by 0.090 towards a place 3.0 m south of it.");
  const PlaceHold north_west = place_hold(bottom_at(-3.0, 3.0));
  EXPECT_THAT(in_words(north_west, 0.0),
              HasSubstr("falls by 0.18 towards a place 4.2 m north-west"));
  EXPECT_THAT(in_words(place_hold(bottom_at(0.0, -1.0)), 0.0), StartsWith("The place is held"))
      << "0.01 lower is no slope";
  EXPECT_DOUBLE_EQ(place_hold(bottom_at(0.0, 0.0)).best_m, 0.0);
}

TEST(PlaceHold, GoesByTheCostThatCountsAsAlike) {
  const MomentSurface surface = surface_of(bowl(1.0, 1.0, 0.0));
  EXPECT_NEAR(place_hold(surface, 0.02).along_m, 2.0 * place_hold(surface, 0.005).along_m,
              2.0 * kStepM);
  EXPECT_THAT(in_words(place_hold(surface, 0.02), 0.0), HasSubstr("rises by at most 0.02 over"));
}

TEST(PlaceHold, NamesTheDirectionOnTheCompassAndAgainstTheHeading) {
  const auto words = [](double bearing_deg, double yaw_deg) {
    PlaceHold hold;
    hold.more_cost = 0.005;
    hold.along_m = 7.4;
    hold.across_m = 0.8;
    hold.bearing_deg = bearing_deg;
    return in_words(hold, Angle::degrees(yaw_deg).radians());
  };
  EXPECT_EQ(words(48.0, 135.0),
            "The place is held poorly north-east to south-west, across the heading: the cost rises "
            "by at most 0.005 over 7.4 m that way, 0.8 m across it.");
  // A yaw counts from east and to the left, a bearing from north and to the right.
  EXPECT_THAT(words(90.0, 0.0), HasSubstr("poorly east to west, along the heading:"));
  EXPECT_THAT(words(90.0, -90.0), HasSubstr("poorly east to west, across the heading:"));
  EXPECT_THAT(words(179.0, 90.0), HasSubstr("poorly north to south, along the heading:"));
  EXPECT_THAT(words(2.0, -91.0), HasSubstr("poorly north to south, along the heading:"));
  EXPECT_THAT(words(135.0, 0.0), HasSubstr("poorly south-east to north-west:"));
  EXPECT_THAT(words(44.0, 45.0), AllOf(HasSubstr("north-east"), HasSubstr("along the heading")));
}

TEST(PlaceHold, IsPoorAlongAStraightStreet) {
  // 61 m of street, 5 m wide; a body in its middle sees 6 m of it and the verges.
  std::vector<std::string> rows(21, std::string(61, 'T'));
  for (std::size_t row = 8; row < 13; ++row) rows[row] = std::string(61, 'R');
  const auto index = index_of(drawn_map(1.0, rows));
  const auto matcher = MapMatcher::create(index, {}).value();
  RunStep step;
  step.estimate.moments.mean = {30.5, 10.5, 0.0};
  std::vector<std::pair<TopviewCell, ClassId>> cells;
  for (std::int16_t forward = 0; forward < 6; ++forward) {
    for (std::int16_t left = -4; left < 4; ++left) {
      const double north_m = 10.5 + left + 0.5;
      cells.push_back({{forward, left}, index->map().class_at({30.5 + forward, north_m})});
    }
  }
  step.topview = topview_of(std::move(cells), 1.0);
  const auto surface = moment_surface(step, matcher, {15, 15, 3, 1.0, 0.1}).value();
  const PlaceHold hold = place_hold(surface);
  EXPECT_NEAR(std::remainder(hold.bearing_deg - 90.0, 180.0), 0.0, 1e-6);
  EXPECT_TRUE(hold.is_along_open);
  EXPECT_LE(hold.across_m, 2.0);
  EXPECT_THAT(in_words(hold, 0.0),
              StartsWith("The place is held poorly east to west, along the heading: "));
}

}  // namespace place_hold_test
}  // namespace nadir
