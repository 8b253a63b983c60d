// SPDX-License-Identifier: Apache-2.0
#include "core/insight/localisability.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/parallel.h"
#include "core/insight/label_ground.h"
#include "core/label/label_raster.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace localisability_test {

constexpr double kPi = std::numbers::pi;
constexpr std::int64_t kAll = std::numeric_limits<std::int64_t>::max();

/// A square map, so far to every side of (0, 0), by what is at a place.
template <typename ClassAt>
OverheadMap painted_map(const ClassAt& class_at, double half_side_m = 30.0) {
  constexpr double kCellM = 0.1;
  const int side = static_cast<int>(std::lround(2.0 * half_side_m / kCellM));
  OverheadMap map = patchwork_map(2, 2, kCellM);
  map.top_left_in_enu_m = {-half_side_m, half_side_m};
  map.labels = Raster<ClassId>(side, side);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const Eigen::Vector2d place = map.enu_from_overhead({column + 0.5, row + 0.5});
      map.labels.at(column, row) = class_at(place.x(), place.y());
    }
  }
  return map;
}

ClassId road_east_west(double, double y_m) { return std::abs(y_m) < 3.0 ? kRoad : kTerrain; }

ClassId crossing(double x_m, double y_m) {
  return std::min(std::abs(x_m), std::abs(y_m)) < 3.0 ? kRoad : kTerrain;
}

ViewInformation view_from(OverheadMap map,
                          const Rigid2& pose,
                          const LocaliserOptions& localiser = {}) {
  return LocalisabilityMap::create(std::move(map), localiser).value().look_from(pose);
}

TEST(Localisability, OfAnEndlessRoadIsAcrossItAndNotAlong) {
  for (const char* preset : {"default", "thesis"}) {
    const auto localiser = localiser_preset(preset).value();
    for (const double turn_rad : {0.0, 0.6}) {
      const auto turned = [turn_rad](double x_m, double y_m) {
        return road_east_west(0.0, -std::sin(turn_rad) * x_m + std::cos(turn_rad) * y_m);
      };
      const auto seen = view_from(painted_map(turned, 60.0), {0.0, 0.0, turn_rad}, localiser);
      EXPECT_GT(seen.std_major_m, 2.5F) << preset << ": nothing is known along it";
      EXPECT_LT(seen.std_minor_m, 1.0F)
          << preset << ": what a turn ahead does looks much like a shift";
      EXPECT_NEAR(std::remainder(static_cast<double>(seen.major_axis_rad) - turn_rad, kPi), 0.0,
                  0.05);
      EXPECT_LT(seen.std_heading_rad, 0.1F);
      EXPECT_GT(seen.ambiguity, 0.5F) << "every place of the road looks the same";
      const double across_m = -std::sin(turn_rad) * static_cast<double>(seen.competitor_east_m) +
                              std::cos(turn_rad) * static_cast<double>(seen.competitor_north_m);
      EXPECT_NEAR(across_m, 0.0, 0.4) << "and the one taken for it lies on it";
    }
  }
}

TEST(Localisability, OfBlankGroundIsNone) {
  const auto seen =
      view_from(painted_map([](double x_m, double) { return x_m < -25.0 ? kRoad : kTerrain; }),
                {5.0, 0.0, 0.0});
  EXPECT_FLOAT_EQ(seen.std_major_m, 3.0F) << "the prior";
  EXPECT_FLOAT_EQ(seen.std_minor_m, 3.0F);
  EXPECT_FLOAT_EQ(seen.ambiguity, 1.0F);
  const auto unlabelled =
      view_from(painted_map([](double, double) { return kUnclassified; }), {5.0, 0.0, 0.0});
  EXPECT_FLOAT_EQ(unlabelled.std_minor_m, 3.0F);
  EXPECT_FLOAT_EQ(unlabelled.std_heading_rad, static_cast<float>(kPi / 18.0));
}

TEST(Localisability, OfACrossingIsBothWays) {
  const auto seen = view_from(painted_map(crossing), {-8.0, 0.0, 0.0});
  EXPECT_LT(seen.std_major_m, 1.0F);
  EXPECT_LT(seen.std_heading_rad, 0.1F);
  EXPECT_LT(seen.ambiguity, 0.05F);
}

TEST(Localisability, OfAPatternThatRepeatsIsAmbiguousAtItsPeriod) {
  const auto stripes = [](double x_m, double y_m) {
    if (std::abs(y_m) > 3.0) return kTerrain;
    return std::fmod(x_m + 40.0, 5.0) < 1.0 ? kSidewalk : kRoad;
  };
  const auto seen = view_from(painted_map(stripes), {0.0, 0.0, 0.0});
  EXPECT_LT(seen.std_major_m, 0.5F) << "sharp, but";
  EXPECT_GT(seen.ambiguity, 0.9F);
  EXPECT_NEAR(std::abs(seen.competitor_east_m), 5.0F, 0.11F);
  EXPECT_NEAR(seen.competitor_north_m, 0.0F, 0.11F);
}

TEST(Localisability, IsLessWhereTheFilterTrustsLess) {
  LocaliserOptions trusting;
  LocaliserOptions doubting;
  doubting.temperature = 10.0 * trusting.temperature;
  const Rigid2 pose{-8.0, 0.5, 0.1};
  const auto sure = view_from(painted_map(crossing), pose, trusting);
  const auto unsure = view_from(painted_map(crossing), pose, doubting);
  EXPECT_GT(unsure.std_major_m, 1.5F * sure.std_major_m);
  EXPECT_GT(unsure.std_heading_rad, 1.5F * sure.std_heading_rad);
  EXPECT_GT(unsure.ambiguity, sure.ambiguity);
}

LocalisabilityMap small_map(double weight_tolerance = 0.05) {
  LocalisabilityOptions options;
  options.spacing_m = 3.0;
  options.headings = 4;
  options.cells_per_class = 24;
  options.weight_tolerance = weight_tolerance;
  return LocalisabilityMap::create(patchwork_map(300, 260, 0.2), {}, options).value();
}

/// Every view that a map has.
std::vector<std::optional<ViewInformation>> views_of(const LocalisabilityMap& map) {
  std::vector<std::optional<ViewInformation>> views;
  for (int row = 0; row < map.rows(); ++row) {
    for (int column = 0; column < map.columns(); ++column) {
      for (int heading = 0; heading < map.options().headings; ++heading) {
        views.push_back(map.view(column, row, heading));
      }
    }
  }
  return views;
}

TEST(LocalisabilityMap, IsTheSameOnAnyNumberOfThreadsInAnyOrderAndInPieces) {
  auto whole = small_map();
  ASSERT_EQ(whole.missing_views(), 20 * 18 * 4);
  {
    const ThreadLimit one(1);
    EXPECT_TRUE(whole.compute_more(kAll, {0.0, 0.0}).value());
  }
  EXPECT_EQ(whole.missing_views(), 0);
  auto pieces = small_map();
  int calls = 1;
  while (!pieces.compute_more(100, {50.0, 3.0 * calls}).value()) ++calls;
  EXPECT_GT(calls, 2);
  EXPECT_EQ(views_of(pieces), views_of(whole));
  const auto place = whole.place_in_enu_m(7, 5);
  EXPECT_EQ(whole.look_from({place.x(), place.y(), whole.heading_rad(3)}), *whole.view(7, 5, 3));
}

TEST(LocalisabilityMap, BeginsWhereItIsLookedAt) {
  auto map = small_map();
  EXPECT_FALSE(map.compute_more(1, map.place_in_enu_m(13, 11)).value());
  EXPECT_TRUE(map.view(13, 11, 0).has_value());
  EXPECT_FALSE(map.view(0, 0, 0).has_value());
  const auto layer = map.layer(LocalisabilityMeasure::kStdMajor);
  EXPECT_TRUE(std::isnan(layer.at(0, 0)));
  float sum = 0.0F;
  for (int heading = 0; heading < 4; ++heading) sum += map.view(13, 11, heading)->std_major_m;
  EXPECT_FLOAT_EQ(layer.at(13, 11), sum / 4.0F);
}

TEST(LocalisabilityMap, StopsWhenItIsToldAndKeepsWhatItHas) {
  auto map = small_map();
  std::stop_source stop;
  const WorkContext context{.stop = stop.get_token(),
                            .progress = [&](double, const std::string&) { stop.request_stop(); }};
  const auto stopped = map.compute_more(kAll, {0.0, 0.0}, context);
  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().code, ErrorCode::kCancelled);
  EXPECT_LT(map.missing_views(), 20 * 18 * 4);
  EXPECT_TRUE(map.compute_more(kAll, {0.0, 0.0}).value());
}

/// Two pieces of the map changed for one another: the classes cover what they covered, so the weights are those of before.
TEST(LocalisabilityMap, AfterAnEditIsWhatAFreshOneIs) {
  auto edited = small_map();
  ASSERT_TRUE(edited.compute_more(kAll, {0.0, 0.0}).value());
  const auto before = views_of(edited);
  const Raster<ClassId> old_labels = edited.ground().map().labels;
  const CellRect first{40, 60, 70, 80};
  const CellRect second{45, 90, 75, 110};
  const auto piece = [&](const CellRect& cells) {
    Raster<ClassId> labels(30, 20);
    for (int row = 0; row < 20; ++row) {
      for (int column = 0; column < 30; ++column) {
        labels.at(column, row) =
            old_labels.at(static_cast<int>(cells.left) + column, static_cast<int>(cells.top) + row);
      }
    }
    return labels;
  };
  edited.redraw(first, piece(second));
  edited.redraw(second, piece(first));
  EXPECT_GT(edited.missing_views(), 0);
  EXPECT_LT(edited.missing_views(), 20 * 18 * 4) << "the rest stays";
  ASSERT_TRUE(edited.compute_more(kAll, {0.0, 0.0}).value());
  auto fresh = LocalisabilityMap::create(edited.ground().map(), {}, edited.options()).value();
  ASSERT_TRUE(fresh.compute_more(kAll, {0.0, 0.0}).value());
  EXPECT_EQ(views_of(edited), views_of(fresh));
  EXPECT_NE(views_of(edited), before);
}

TEST(LocalisabilityMap, FollowsADocument) {
  const LabelGrid grid = test_grid(120, 100, 0.5);
  LabelDocument document(test_plane(), grid);
  OverheadMap blank = patchwork_map(2, 2, 0.5);
  blank.plane = test_plane();
  blank.top_left_in_enu_m = {0.0, 0.0};
  blank.labels = rasterise(document);
  auto map = LocalisabilityMap::create(blank, {}).value();
  const auto draw = [&](LabelObject object) {
    LabelEdit edit;
    edit.objects.push_back({nullptr, std::make_shared<LabelObject>(object)});
    ASSERT_TRUE(document.check(edit)) << error_text(document.check(edit));
    document.apply(edit);
    map.redraw(document, document.objects().at(object.id).bounds);
    EXPECT_EQ(map.ground().map().labels, rasterise(document));
  };
  draw(area(kTerrain, {box(0, 0, 60, 50)}, 1));
  EXPECT_FLOAT_EQ(map.look_from({25.0, -20.0, 0.0}).std_minor_m, 3.0F);
  draw(area(kRoad, {box(20, 15, 45, 20)}, 2));
  EXPECT_LT(map.look_from({25.0, -20.0, 0.0}).std_minor_m, 1.0F) << "drawing it pays";
}

TEST(LocalisabilityMap, RefusesWhatCannotBeMade) {
  const auto fault = [](const LocalisabilityOptions& options) {
    return error_text(LocalisabilityMap::create(patchwork_map(100, 100, 0.2), {}, options));
  };
  EXPECT_THAT(fault({.spacing_m = 0.0}), testing::HasSubstr("spacing"));
  EXPECT_THAT(fault({.headings = 0}), testing::HasSubstr("headings"));
  LocaliserOptions broken;
  broken.temperature = -1.0;
  EXPECT_THAT(error_text(LocalisabilityMap::create(patchwork_map(100, 100, 0.2), broken)),
              testing::HasSubstr("temperature"));
}

}  // namespace localisability_test
}  // namespace nadir
