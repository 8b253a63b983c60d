// SPDX-License-Identifier: Apache-2.0
// What timeline, layers, runs and bookmarks take from a session.
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "tests/core/session/session_fixture.h"
#include "widgets/panels/bookmarks_panel.h"
#include "widgets/panels/layers_panel.h"
#include "widgets/panels/runs_panel.h"
#include "widgets/panels/timeline.h"

namespace nadir {
namespace {

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

TEST_F(SideModelsTest, BookmarksAreThoseOfTheActiveRun) {
  open_run();
  act("seek 1");
  act("bookmark here");
  const BookmarksModel model = bookmarks_model(*session_);
  EXPECT_THAT(model.bookmarks, ElementsAre(Bookmark{1.0, "here", {}}));
  EXPECT_THAT(timeline_model(*session_).bookmarks, ElementsAre(Bookmark{1.0, "here", {}}));
  EXPECT_EQ(model.time_s, 1.0);
}

}  // namespace
}  // namespace nadir
