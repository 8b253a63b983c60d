// SPDX-License-Identifier: Apache-2.0
#include "core/session/figure_request.h"

#include <gmock/gmock.h>

#include "core/base/settings.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace figure_request_test {

using testing::HasSubstr;
using testing::Not;

FigureRequest moment_request() {
  FigureRequest request;
  request.figure = "moment";
  request.runs = {"/runs/a \"b\".nadir"};
  request.map = "/maps/town";
  request.time_s = 12.25;
  request.look = default_map_look();
  request.look.centre_in_enu_m = {10.5, -3.0};
  request.look.width_m = 80.0;
  request.theme = LightOrDark::kDark;
  return request;
}

TEST(FigureRequest, IsARecipeOfWhatIsShown) {
  const std::string text = figure_recipe_text(moment_request());
  const auto recipe = Settings::parse(text, "recipe");
  ASSERT_TRUE(recipe) << error_text(recipe);
  EXPECT_EQ(recipe->text("figure").value(), "moment");
  EXPECT_EQ(recipe->texts("runs").value(), std::vector<std::string>{"/runs/a \"b\".nadir"});
  EXPECT_EQ(recipe->text("map").value(), "/maps/town");
  EXPECT_EQ(recipe->text("options.theme").value(), "dark");
  EXPECT_EQ(recipe->number("options.time").value(), 12.25);
  EXPECT_EQ(recipe->text("options.crop").value(), "80@10.5,-3");
  EXPECT_EQ(recipe->text("options.stack").value(),
            "picture,topview:0.8,particles,odometry,truth,estimate,ellipses,modes");
  EXPECT_EQ(recipe->text("options.laid-at").value(), "estimate");
  EXPECT_THAT(text, Not(HasSubstr("layers"))) << "the stack says it";
  EXPECT_THAT(text, Not(HasSubstr("up ="))) << "north is";
  EXPECT_THAT(text, Not(HasSubstr("speed")));
}

TEST(FigureRequest, HasAWidthOnlyWhereOneIsAskedFor) {
  FigureRequest request = moment_request();
  EXPECT_THAT(figure_recipe_text(request), Not(HasSubstr("size")));
  request.width_px = 2400;
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("size = \"2400\"\n"));
}

TEST(FigureRequest, OfAMomentHasTheLayersAsTheyLie) {
  FigureRequest request = moment_request();
  request.look.layer(Layer::kParticles).is_visible = false;
  request.look.layer(Layer::kLabels) = {true, 0.4, std::nullopt};
  request.look.layer(Layer::kTruth).colour = "#FF8800";
  std::swap(request.look.order[0], request.look.order[1]);  // the labels below the picture
  EXPECT_THAT(figure_recipe_text(request),
              HasSubstr("stack = \"labels:0.4,picture,topview:0.8,odometry,truth#FF8800,estimate,"
                        "ellipses,modes\"\n"));
  for (LayerLook& look : request.look.layers) look.is_visible = false;
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("stack = \"none\"\n"));
}

TEST(FigureRequest, OfAMomentIsTurnedAsTheMapIs) {
  FigureRequest request = moment_request();
  request.look.up = MapUp::kFree;
  request.look.up_rad = 0.0;
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("up = \"90\"\n"));
  request.look.up = MapUp::kHeading;
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("up = \"heading\"\n"));
}

TEST(FigureRequest, OfAMomentHasTheColourThatTheWindowGaveTheRun) {
  FigureRequest request = moment_request();
  EXPECT_THAT(figure_recipe_text(request), Not(HasSubstr("run-colour"))) << "the first is usual";
  request.run_colour = 2;
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("run-colour = 3\n")) << "counted from 1";
}

TEST(FigureRequest, OfAMomentGoesWithTheVehicleWhereTheMapDoes) {
  FigureRequest request = moment_request();
  request.look.is_following = true;
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("crop = \"80\"\n"));
  request.figure = "trajectories";
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("crop = \"80@10.5,-3\"\n"))
      << "it has no moment to be around";
}

TEST(FigureRequest, OfOtherFiguresLeavesOutTheLayersThatAreHidden) {
  FigureRequest request = moment_request();
  request.figure = "trajectories";
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("layers = \"all\"\n"));
  request.look.layer(Layer::kParticles).is_visible = false;
  request.look.layer(Layer::kOdometry).is_visible = false;
  EXPECT_THAT(figure_recipe_text(request),
              HasSubstr("layers = \"picture,truth,estimate,ellipses,modes,topview\"\n"));
  request.look.layer(Layer::kLabels) = {true, 0.4, std::nullopt};
  request.look.layer(Layer::kGraticule).is_visible = true;
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("label-opacity = 0.4\n"));
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("graticule-lines = true\n"));
  for (LayerLook& look : request.look.layers) look.is_visible = false;
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("layers = \"none\"\n"));
}

TEST(FigureRequest, OfAFilmHasItsRangeAndItsSpeed) {
  FigureRequest request = moment_request();
  request.is_film = true;
  request.speed = 2.5;
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("speed = 2.5\n"));
  request.from_s = 3.0;
  request.to_s = 7.5;
  EXPECT_THAT(figure_recipe_text(request), HasSubstr("from = 3\nto = 7.5\n"));
}

TEST(FigureRequest, KnowsHowManyRunsAFigureIsOf) {
  EXPECT_EQ(runs_of_figure("moment"), RunsOfFigure::kOne);
  EXPECT_EQ(runs_of_figure("compare"), RunsOfFigure::kAll);
  EXPECT_EQ(runs_of_figure("labels"), RunsOfFigure::kNone);
  EXPECT_EQ(runs_of_figure("no such figure"), RunsOfFigure::kOne);
}

}  // namespace figure_request_test
}  // namespace nadir
