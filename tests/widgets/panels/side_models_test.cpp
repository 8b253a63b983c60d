// SPDX-License-Identifier: Apache-2.0
// What timeline, layers, runs and bookmarks take from a session.
#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <stop_token>

#include "tests/core/session/session_fixture.h"
#include "widgets/panels/bookmarks_panel.h"
#include "widgets/panels/layers_panel.h"
#include "widgets/panels/place_overlay.h"
#include "widgets/panels/runs_panel.h"
#include "widgets/panels/status_bar.h"
#include "widgets/panels/timeline.h"

namespace nadir {
namespace side_models_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class SideModelsTest : public SessionTest {
 protected:
  [[nodiscard]] std::string why_empty(Layer layer) const {
    const LayersModel model = layers_model(*session_);
    return std::find_if(model.rows.begin(), model.rows.end(),
                        [layer](const LayersModel::Row& row) { return row.layer == layer; })
        ->why_empty;
  }
};

TEST_F(SideModelsTest, WithoutARunAreEmptyAndSayWhy) {
  EXPECT_EQ(timeline_model(*session_).active(), nullptr);
  EXPECT_THAT(runs_model(*session_).rows, IsEmpty());
  EXPECT_FALSE(bookmarks_model(*session_).has_run);
  EXPECT_EQ(why_empty(Layer::kParticles), "no run");
  EXPECT_EQ(why_empty(Layer::kLabels), "no map");
  EXPECT_THAT(layers_model(*session_).classes, IsEmpty());
  EXPECT_THAT(layers_model(*session_).rows, SizeIs(kLayerCount));
}

TEST_F(SideModelsTest, TheTimelineHasTheActiveRunLastAndAllOnOneClock) {
  open_run();
  act("open " + copy_run("second.nadir").string());
  settle();
  act("run 1");
  act("seek 1.5");
  act("loop 0.5 2");
  const TimelineModel model = timeline_model(*session_);
  ASSERT_THAT(model.runs, SizeIs(2));
  EXPECT_EQ(model.runs.back().number, 1);
  EXPECT_TRUE(model.runs.back().is_active);
  EXPECT_EQ(model.runs.front().offset_s, 0.0) << "of the same flight, begun at the same moment";
  EXPECT_EQ(model.time_s, 1.5);
  EXPECT_EQ(model.loop_from_s, 0.5);
  EXPECT_EQ(model.loop_to_s, 2.0);
  EXPECT_THAT(model.strips, SizeIs(kStripCount));
  act("show-run 2 off");
  EXPECT_THAT(timeline_model(*session_).runs, SizeIs(1));
}

TEST_F(SideModelsTest, LayersHaveTheirLookFromTheTopAndTheClassesOfTheMap) {
  open_run();
  act("layer particles off");
  act("layer-opacity topview 0.25");
  const LayersModel model = layers_model(*session_);
  EXPECT_EQ(model.rows.front().layer, session_->view().map.order.back());
  const auto look_of = [&model](Layer layer) {
    return std::find_if(model.rows.begin(), model.rows.end(),
                        [layer](const LayersModel::Row& row) { return row.layer == layer; })
        ->look;
  };
  EXPECT_FALSE(look_of(Layer::kParticles).is_visible);
  EXPECT_EQ(look_of(Layer::kTopview).opacity, 0.25);
  double all = 0.0;
  for (const LayersModel::ClassShare& one : model.classes) all += one.share;
  EXPECT_NEAR(all, 1.0, 1e-9);
  EXPECT_TRUE(std::is_sorted(model.classes.begin(), model.classes.end(),
                             [](const auto& a, const auto& b) { return a.share > b.share; }));
}

TEST_F(SideModelsTest, LayersThatTheRunHasDataForAreNotEmpty) {
  open_run();
  session_->poll(0.0);
  settle();
  for (const Layer layer : {Layer::kLabels, Layer::kEstimate, Layer::kTruth, Layer::kEllipses}) {
    EXPECT_EQ(why_empty(layer), "") << layer_title(layer);
  }
}

TEST_F(SideModelsTest, AReconstructionNeedsTopviewsOfTheRunAndNoFlight) {
  namespace fs = std::filesystem;
  const fs::path flight = scratch_.path() / "gone";
  fs::copy(SmallWorld::get().flight, flight, fs::copy_options::recursive);
  RerunTask task = SmallWorld::get().task(scratch_.path() / "alone.nadir");
  task.flight = open_flight(flight).value();
  ASSERT_TRUE(rerun(task, {}, [](RerunProgress) {}));
  task.flight.reset();
  fs::remove_all(flight);
  act("open " + task.run.string());
  settle();
  EXPECT_EQ(session_->flight(), nullptr);
  EXPECT_EQ(why_empty(Layer::kReconstruction), "");
  EXPECT_EQ(why_empty(Layer::kErrorSurface), "");
  act("play on");
  EXPECT_EQ(why_empty(Layer::kErrorSurface), "when paused");
}

TEST_F(SideModelsTest, PlacesOfARunWithoutItsMapAreThoseOfItsPlane) {
  RerunTask task = SmallWorld::get().task(scratch_.path() / "mapless.nadir");
  task.map_path = (scratch_.path() / "nowhere").string();
  ASSERT_TRUE(rerun(task, {}, [](RerunProgress) {}));
  Session alone({scratch_.path() / "own config", scratch_.path() / "own data", {}, {}});
  ASSERT_TRUE(alone.apply(actions::OpenFile{task.run.string()}));
  poll_until(alone, [&alone] {
    return alone.active_run() != nullptr && alone.active_run()->document && !alone.is_busy();
  });
  ASSERT_EQ(alone.map(), nullptr);
  ASSERT_TRUE(alone.apply(actions::ShowOverlay{Overlay::kPlace}));
  const PlaceModel model = place_model(alone);
  ASSERT_TRUE(model.plane);
  const Geodetic expected = SmallWorld::get().index->map().plane.geodetic_from_enu({3.0, 4.0});
  const Geodetic found = model.plane->geodetic_from_enu({3.0, 4.0});
  EXPECT_NEAR(found.latitude_deg, expected.latitude_deg, 1e-9);
  EXPECT_NEAR(found.longitude_deg, expected.longitude_deg, 1e-9);
}

TEST_F(SideModelsTest, LayersHaveTheColoursThatTheMapDrawsThemIn) {
  open_run();
  const Theme& dark = theme(ThemeName::kDark);
  const LayersModel over = layers_model(*session_);
  EXPECT_TRUE(over.is_on_picture);
  EXPECT_EQ(usual_line_colour(Layer::kTruth, over, dark), dark.truth_on_imagery);
  EXPECT_EQ(usual_line_colour(Layer::kEstimate, over, dark),
            run_colour_on_imagery(dark, over.run_colour));
  act("layer picture off");
  act("layer labels off");
  const LayersModel plain = layers_model(*session_);
  EXPECT_FALSE(plain.is_on_picture);
  EXPECT_EQ(usual_line_colour(Layer::kTruth, plain, dark), dark.truth);
  EXPECT_EQ(usual_line_colour(Layer::kGraticule, plain, dark), dark.line);
  act("open " + copy_run("second.nadir").string());
  settle();
  const LayersModel second = layers_model(*session_);
  EXPECT_NE(second.run_colour, plain.run_colour);
  EXPECT_EQ(usual_line_colour(Layer::kEllipses, second, dark), run_colour(dark, second.run_colour));
}

TEST_F(SideModelsTest, RunsAreListedInTheirOrder) {
  open_run();
  act("open " + copy_run("second.nadir").string());
  settle();
  const RunsModel model = runs_model(*session_);
  ASSERT_THAT(model.rows, SizeIs(2));
  EXPECT_EQ(model.rows[0].number, 1);
  EXPECT_EQ(model.rows[1].number, 2);
  EXPECT_NE(model.rows[0].colour, model.rows[1].colour);
  EXPECT_EQ(model.rows[0].is_active + model.rows[1].is_active, 1);
  EXPECT_NE(model.rows[1].document, nullptr);
  act("close-run 1");
  EXPECT_THAT(runs_model(*session_).rows, SizeIs(1));
}

TEST_F(SideModelsTest, ARunThatWasStoppedIsIncompleteEverywhere) {
  const RerunTask task = SmallWorld::get().task(scratch_.path() / "stopped.nadir");
  std::stop_source source;
  WorkContext context;
  context.stop = source.get_token();
  ASSERT_TRUE(rerun(task, context, [&source](RerunProgress progress) {
    if (progress.steps == 5) source.request_stop();
  }));
  act("open " + task.run.string());
  settle();
  const TimelineModel timeline = timeline_model(*session_);
  ASSERT_NE(timeline.active(), nullptr);
  EXPECT_TRUE(timeline.active()->is_incomplete);
  const double flight_s = timeline.flight_end_s(*timeline.active());
  EXPECT_GT(flight_s, timeline.active()->document->duration_s());
  EXPECT_EQ(timeline.extent().to_s, flight_s) << "what is missing shows";
  EXPECT_EQ(timeline.extent().last_s, timeline.active()->document->duration_s());
  EXPECT_EQ(runs_model(*session_).rows[0].flight_end_s, flight_s);
  EXPECT_EQ(status_bar_model(*session_, {}).incomplete.find("stopped is incomplete: stopped at "),
            0U);
  act("open " + copy_run("whole.nadir").string());
  settle();
  EXPECT_FALSE(timeline_model(*session_).active()->is_incomplete);
  EXPECT_EQ(status_bar_model(*session_, {}).incomplete, "");
}

TEST_F(SideModelsTest, EachWorstMomentHasItsNumber) {
  open_run();
  const BookmarksModel model = bookmarks_model(*session_);
  ASSERT_FALSE(model.moments.empty());
  ASSERT_EQ(model.values.size(), model.moments.size());
  for (const MomentValue& value : model.values) EXPECT_FALSE(value.digits.empty());
}

TEST_F(SideModelsTest, BookmarksAreThoseOfTheActiveRun) {
  open_run();
  act("seek 1");
  act("bookmark here");
  const BookmarksModel model = bookmarks_model(*session_);
  EXPECT_THAT(model.bookmarks, ElementsAre(Bookmark{1.0, "here", {}}));
  EXPECT_THAT(timeline_model(*session_).bookmarks, ElementsAre(Bookmark{1.0, "here", {}}));
  EXPECT_EQ(model.time_s, 1.0);
}

}  // namespace side_models_test
}  // namespace nadir
