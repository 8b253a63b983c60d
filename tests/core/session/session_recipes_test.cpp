// SPDX-License-Identifier: Apache-2.0
#include "core/session/map_stack.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_recipes_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SessionRecipesTest : public SessionTest {};

TEST_F(SessionRecipesTest, TakesOptionsFromARecipeOfTheLocaliser) {
  act(open(scratch_.file("mine.toml", "preset = \"thesis\"\n[options]\nparticles = 123\n")));
  EXPECT_EQ(session_->view().draft.preset, "thesis");
  EXPECT_THAT(session_->view().draft.changed,
              ElementsAre(std::pair<const std::string, std::string>("particles", "123")));
}

TEST_F(SessionRecipesTest, ReopensTheMomentOfARecipe) {
  const fs::path recipe =
      scratch_.file("moment.toml",
                    "figure = \"moment\"\nruns = [\"loop.nadir\"]\n[options]\ntime = 2.5\ncrop = "
                    "\"40@12.5,-3\"\n");
  act(open(recipe));
  settle();
  ASSERT_THAT(run_names(), ElementsAre("loop"));
  EXPECT_EQ(session_->playback().time_s, 2.5);
  EXPECT_EQ(session_->view().map.width_m, 40.0);
  EXPECT_EQ(session_->view().map.centre_in_enu_m, Eigen::Vector2d(12.5, -3.0));
  EXPECT_FALSE(session_->view().map.is_following);
  act(open(scratch_.file("close.toml",
                         "figure = \"moment\"\nruns = [\"loop.nadir\"]\n[options]\n"
                         "time = 1\ncrop = 25\n")));
  settle();
  EXPECT_EQ(session_->playback().time_s, 1.0) << "of the run that is open already";
  EXPECT_EQ(session_->view().map.width_m, 25.0);
  EXPECT_TRUE(session_->view().map.is_following) << "around the vehicle";
}

TEST_F(SessionRecipesTest, ReopensTheMapOfAMomentAsItLayAndWasTurned) {
  open_run();
  act("rotate 30");
  act(open(scratch_.file("moment.toml",
                         "figure = \"moment\"\nruns = [\"loop.nadir\"]\n[options]\n"
                         "stack = \"labels:0.5,picture,truth#FF8800\"\nup = \"90\"\n"
                         "laid-at = \"truth\"\n")));
  settle();
  const MapLook& map = session_->view().map;
  EXPECT_EQ(MapStack::of(map).text(), "labels:0.5,picture,truth#FF8800");
  EXPECT_EQ(map.up, MapUp::kFree);
  EXPECT_NEAR(map.up_rad, 0.0, 1e-12);
  EXPECT_EQ(map.topview_at, PoseSource::kTruth);
  act(open(scratch_.file("north.toml",
                         "figure = \"moment\"\nruns = [\"loop.nadir\"]\n[options]\n"
                         "stack = \"picture\"\n")));
  settle();
  EXPECT_EQ(session_->view().map.up, MapUp::kNorth);
  EXPECT_EQ(session_->view().map.topview_at, PoseSource::kEstimate);
  EXPECT_THAT(refused(open(scratch_.file("p.toml",
                                         "figure = \"moment\"\nruns = [\"loop.nadir\"]\n"
                                         "[options]\nstack = \"pictures\"\n"))),
              HasSubstr("p.toml: 'pictures' is no layer of a map"));
}

TEST_F(SessionRecipesTest, TakesOfAMomentsMapWhatTheRecipeSaysAndNoMore) {
  open_run();
  act("layer particles off");
  const std::string stack = MapStack::of(session_->view().map).text();
  const auto recipe = [this](const std::string& options) {
    return open(scratch_.file("moment.toml",
                              "figure = \"moment\"\nruns = [\"loop.nadir\"]\n"
                              "[options]\n" +
                                  options));
  };
  act(recipe("up = \"90\"\n"));
  settle();
  EXPECT_EQ(session_->view().map.up, MapUp::kFree) << "a figure that was drawn with --up alone";
  EXPECT_NEAR(session_->view().map.up_rad, 0.0, 1e-12);
  EXPECT_EQ(MapStack::of(session_->view().map).text(), stack);
  act(recipe("laid-at = \"odometry\"\n"));
  settle();
  EXPECT_EQ(session_->view().map.topview_at, PoseSource::kOdometry);
  EXPECT_EQ(session_->view().map.up, MapUp::kFree) << "it says nothing of it";
  EXPECT_THAT(refused(recipe("laid-at = \"trth\"\n")),
              HasSubstr("moment.toml: laid-at is 'trth': write estimate, truth or odometry"));
}

TEST_F(SessionRecipesTest, LeavesTheMapToOtherFiguresAsItIs) {
  open_run();
  act("rotate 30");
  const MapLook before = session_->view().map;
  act(open(scratch_.file("ways.toml",
                         "figure = \"trajectories\"\nruns = [\"loop.nadir\"]\n[options]\n"
                         "stack = \"picture\"\nup = \"90\"\nlaid-at = \"truth\"\n")));
  settle();
  EXPECT_EQ(session_->view().map, before);
}

TEST_F(SessionRecipesTest, RefusesARecipeWhoseRunIsGone) {
  EXPECT_THAT(refused(open(scratch_.file("m.toml", "figure = \"moment\"\nruns = [\"x.nadir\"]\n"))),
              HasSubstr("m.toml: its run x.nadir is not there"));
  EXPECT_THAT(refused(open(scratch_.file("n.toml", "figure = \"labels\"\nmap = \"nowhere\"\n"))),
              HasSubstr("nowhere"));
  EXPECT_THAT(refused(open(scratch_.file("o.toml", "figure = 3\n"))), HasSubstr("figure is not"));
}

TEST_F(SessionRecipesTest, ReopensTheMomentThatAFigureCarries) {
  SessionPlaces with_figures = places();
  with_figures.recipe_in_figure = [this](const fs::path& figure) -> Result<std::string> {
    if (figure.filename() == "plain.png") {
      return fail(ErrorCode::kMalformed, "{}: carries no recipe of a figure", figure.string());
    }
    return "figure = \"moment\"\nruns = [\"" + run_.string() + "\"]\n[options]\ntime = 3\n";
  };
  session_ = std::make_unique<Session>(with_figures);
  act(open(scratch_.file("plain.png", "x")));
  settle();
  EXPECT_THAT(notice_texts(), ElementsAre(HasSubstr("plain.png: carries no recipe")));
  act(open(scratch_.file("moment.svg", "x")));
  settle();
  EXPECT_THAT(run_names(), ElementsAre("loop"));
  EXPECT_EQ(session_->playback().time_s, 3.0);
  EXPECT_EQ(session_->undo_title(), "Open moment.svg");
  act("undo");
  EXPECT_THAT(session_->runs(), IsEmpty());
}

TEST_F(SessionRecipesTest, ShowsTheRunsMapAndTheCropOfARecipe) {
  const fs::path other = scratch_.path() / "other";
  fs::copy(SmallWorld::get().map, other, fs::copy_options::recursive);
  act(open(other));
  act(open(scratch_.file("moment.toml",
                         "figure = \"moment\"\nruns = [\"loop.nadir\"]\n[options]\ntime = 2.5\n"
                         "crop = \"40@12.5,-3\"\n")));
  settle();
  EXPECT_EQ(session_->map()->path, SmallWorld::get().map);
  EXPECT_EQ(session_->view().map.width_m, 40.0);
}

}  // namespace session_recipes_test
}  // namespace nadir
