// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/flight_moments.h"

namespace nadir {
namespace scene_figure_test {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class SceneFigure : public testing::Test {
 protected:
  SceneFigure() { write_street(map()); }

  [[nodiscard]] fs::path map() const { return scratch_.path() / "map"; }
  [[nodiscard]] fs::path flight() const { return scratch_.path() / "flight"; }
  FigureRecipe recipe(int steps = 30, const RunFaults& faults = {}) {
    const fs::path run = scratch_.path() / "drive.nadir";
    write_drive(run, map(), steps, faults);
    FigureRecipe made;
    made.figure = "scene";
    made.runs = {run.string()};
    made.map = map().string();
    made.options.size.width = 400;
    made.options.time_s = 7.5;
    return made;
  }
  static Result<Raster<Rgba>> draw(const FigureRecipe& recipe) {
    const auto figure = make_figure(recipe);
    if (!figure) return forward_error(figure);
    FigureContext context(page_format(recipe.options, 1.5));
    return draw_pixels(**figure, context);
  }
  static FigureRun run_of(const FigureRecipe& recipe) {
    return open_figure_run(recipe.runs.front(), recipe.options).value();
  }

  ScratchFolder scratch_;
};

TEST_F(SceneFigure, LaysEachPointOnTheGroundOfItsClass) {
  const FigureRecipe asked = recipe();
  const auto flight = FlightMoments::open(run_of(asked));
  ASSERT_TRUE(flight) << error_text(flight);
  const auto moment = flight->at(107.5, 30.0, 1);
  ASSERT_TRUE(moment) << error_text(moment);
  ASSERT_GT(moment->cloud.size(), 1000U);
  EXPECT_DOUBLE_EQ(moment->level_height_m, kStreetCameraHeightM);
  const OverheadMap street = read_overhead_map(map()).value();
  const Rigid2 truth{25.0, 20.0, 0.0};
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < moment->cloud.size(); ++i) {
    const Eigen::Vector3d point = moment->cloud.points_in_level_m[i].cast<double>();
    EXPECT_NEAR(point.z(), -kStreetCameraHeightM, 0.01);
    const Eigen::Vector2d place = truth * Eigen::Vector2d(point.head<2>());
    wrong += street.class_at(place) == moment->cloud.labels[i] ? 0 : 1;
  }
  EXPECT_LT(wrong, moment->cloud.size() / 100);  // depth is kept in millimetres
}

TEST_F(SceneFigure, LeavesOutWhatIsFarAndAllButEveryNthPixel) {
  const auto flight = FlightMoments::open(run_of(recipe()));
  ASSERT_TRUE(flight);
  const auto all = flight->at(107.5, 30.0, 1);
  const auto near = flight->at(107.5, 6.0, 1);
  const auto few = flight->at(107.5, 30.0, 2);
  ASSERT_TRUE(all && near && few);
  EXPECT_LT(near->cloud.size(), all->cloud.size());
  EXPECT_NEAR(static_cast<double>(few->cloud.size()), static_cast<double>(all->cloud.size()) / 4.0,
              100.0);
  // Without camera images the classes are the picture.
  EXPECT_EQ(all->picture.width(), street_camera().width);
}

TEST_F(SceneFigure, ShowsTheRoadAsASpotOfItsColourAheadOfTheVehicle) {
  FigureRecipe asked = recipe();
  asked.options.layers.set(FigureLayer::kPicture, false);
  const auto drawn = draw(asked);
  ASSERT_TRUE(drawn) << error_text(drawn);
  const auto count = [&drawn](Rgba colour) {
    return std::count(drawn->values().begin(), drawn->values().end(), colour);
  };
  EXPECT_GT(count(class_colour(kRoad)), 1000);
  EXPECT_GT(count(class_colour(kTerrain)), 1000);
}

TEST_F(SceneFigure, IsLaidAtTheEstimateOrWhereItIsAskedFor) {
  FigureRecipe asked = recipe();
  const auto at_estimate = draw(asked);
  asked.options.laid_at = LaidAt::kTruth;
  const auto at_truth = draw(asked);
  asked.options.laid_at = LaidAt::kOdometry;
  const auto at_odometry = draw(asked);
  ASSERT_TRUE(at_estimate && at_truth && at_odometry);
  EXPECT_NE(*at_estimate, *at_truth);
  EXPECT_NE(*at_odometry, *at_truth);
}

TEST_F(SceneFigure, SaysWhatItHasNot) {
  FigureRecipe asked = recipe(30, {.has_truth = false});
  EXPECT_TRUE(draw(asked));
  asked.options.laid_at = LaidAt::kTruth;
  EXPECT_THAT(error_text(draw(asked)),
              HasSubstr("drive.nadir: has no truth at 7.500 s, where the figure"));
  FigureRecipe late = recipe(60);  // the flight has 40 frames
  late.options.time_s = 29.0;
  EXPECT_THAT(error_text(draw(late)), HasSubstr("flight: has no labels and depth at 129.000 s"));
  fs::remove_all(flight());
  const auto lost = make_figure(late);
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(error_text(lost),
              HasSubstr("drive.nadir: its flight no/such/flight is not there, and the figure "
                        "shows what its camera saw"));
}

TEST_F(SceneFigure, RefusesAFlightWithoutClouds) {
  const FigureRecipe asked = recipe();
  fs::remove(flight() / "depth.txt");
  EXPECT_THAT(error_text(make_figure(asked)), HasSubstr("flight"));
}

TEST_F(SceneFigure, ShowsAMomentOfAFilmAsAStillOfThatTime) {
  FigureRecipe asked = recipe();
  const auto film = make_figure(asked);
  ASSERT_TRUE(film);
  FigureContext context(page_format(asked.options, 1.5));
  (void)draw_pixels(**film, context);
  for (const double time_s : {2.0, 11.0, 2.0}) {
    (*film)->show_at(time_s);
    asked.options.time_s = time_s;
    const auto frame = draw_pixels(**film, context);
    const auto still = draw(asked);
    ASSERT_TRUE(frame && still);
    EXPECT_EQ(*frame, *still) << time_s;
  }
}

TEST(HeightAboveGround, IsTheMedianOfWhatLiesOnTheGround) {
  SemanticCloud cloud;
  const auto add = [&cloud](float z, ClassId id) {
    cloud.points_in_level_m.emplace_back(1.0F, 0.0F, z);
    cloud.labels.push_back(id);
  };
  EXPECT_EQ(height_above_ground(cloud), 0.0);
  add(3.0F, kBuilding);
  add(std::nanf(""), kRoad);
  EXPECT_EQ(height_above_ground(cloud), 0.0);
  add(-1.6F, kRoad);
  add(-1.5F, kTerrain);
  add(9.0F, kSidewalk);
  EXPECT_NEAR(height_above_ground(cloud), 1.5, 1e-6);
}

}  // namespace scene_figure_test
}  // namespace nadir
