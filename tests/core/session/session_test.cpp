// SPDX-License-Identifier: Apache-2.0
#include "core/session/session.h"

#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST_F(SessionTest, BeginsWithNothingAndSaysSo) {
  EXPECT_EQ(session_->view(), default_view_state());
  EXPECT_THAT(session_->runs(), IsEmpty());
  EXPECT_EQ(session_->active_run(), nullptr);
  EXPECT_EQ(session_->map(), nullptr);
  EXPECT_EQ(session_->flight(), nullptr);
  EXPECT_FALSE(session_->step_index());
  EXPECT_EQ(session_->step(), nullptr);
  EXPECT_FALSE(session_->undo_title());
  EXPECT_FALSE(session_->redo_title());
  EXPECT_FALSE(session_->is_busy());
  EXPECT_GT(session_->resolved_map_look().width_m, 0.0);
  EXPECT_EQ(refused("seek 1"), "no run is open: open one first");
}

TEST_F(SessionTest, OpensARunWithItsMapItsFlightAndItsParticles) {
  act("open " + run_.string());
  ASSERT_THAT(session_->runs(), SizeIs(1)) << "at once, still to be filled";
  EXPECT_EQ(session_->runs().front().name, "loop");
  EXPECT_TRUE(session_->is_busy());
  EXPECT_THAT(session_->jobs(), Not(IsEmpty()));
  settle();
  ASSERT_NE(session_->active_run(), nullptr);
  const RunDocument& run = document();
  EXPECT_EQ(run.steps.size(), SmallWorld::get().recording->description().frames.size());
  ASSERT_NE(session_->map(), nullptr);
  EXPECT_EQ(session_->map()->path, SmallWorld::get().map);
  EXPECT_EQ(session_->map()->provenance.name, "street");
  ASSERT_NE(session_->flight(), nullptr);
  EXPECT_EQ(session_->flight()->description().name, "short");
  ASSERT_EQ(session_->step_index(), 0U);
  ASSERT_NE(session_->step(), nullptr);
  EXPECT_EQ(session_->step()->particles->size(), 300U);
  EXPECT_GT(session_->memory_used_bytes(), 0U);
  EXPECT_THAT(session_->recents(), ElementsAre(SmallWorld::get().map.string(), run_.string()));
  EXPECT_THAT(session_->notices(), IsEmpty());
  EXPECT_FALSE(session_->is_busy());
}

TEST_F(SessionTest, TakesBackAndDoesAgainEveryChangeOfTheView) {
  open_run();
  copy_run("other.nadir");
  const std::vector<std::string> changes = {"look 20 30 40",
                                            "zoom 2 22 31",
                                            "rotate 30",
                                            "fit map",
                                            "follow on",
                                            "up heading",
                                            "place \"30 28\"",
                                            "lay-at truth",
                                            "select-particle 7",
                                            "measure 20 30",
                                            "measure 25 30",
                                            "tool measure",
                                            "measure",
                                            "layer particles off",
                                            "layer-opacity topview 0.25",
                                            "layer-colour estimate #112233",
                                            "layer-move picture 3",
                                            "panel camera on",
                                            "panel layers off",
                                            "splitter left 333",
                                            "splitter timeline 222",
                                            "map-only on",
                                            "layout default",
                                            "theme light",
                                            "scale 1.5",
                                            "reduced-motion on",
                                            "memory 64",
                                            "strip nees off",
                                            "strip-move nees 2",
                                            "strip-height sigma 66",
                                            "option particles 500",
                                            "preset thesis",
                                            "save-layout mine",
                                            "bookmark \"a turn\"",
                                            "bookmark-note 1 \"a sharp turn\"",
                                            "bookmark-remove 1",
                                            "open " + (scratch_.path() / "other.nadir").string(),
                                            "run 1",
                                            "show-run 2 off",
                                            "split-view on",
                                            "close-run 2"};
  struct Moment {
    ViewState view;
    std::vector<Bookmark> bookmarks;
    int memory;
    std::vector<std::string> layouts;
    bool operator==(const Moment&) const = default;
  };
  const auto now = [&] {
    return Moment{session_->view(), session_->runs().front().bookmarks,
                  session_->memory_budget_megabytes(), session_->layout_names()};
  };
  std::vector<Moment> moments = {now()};
  for (const std::string& words : changes) {
    act(words);
    settle();
    session_->seal_history();
    ASSERT_FALSE(now() == moments.back()) << words << " changes nothing";
    moments.push_back(now());
  }
  for (std::size_t i = changes.size(); i-- > 0;) {
    ASSERT_TRUE(session_->undo_title()) << changes[i];
    act("undo");
    settle();
    EXPECT_EQ(now().view, moments[i].view) << changes[i];
    EXPECT_TRUE(now() == moments[i]) << changes[i];
  }
  EXPECT_EQ(session_->undo_title(), "Open loop.nadir");
  for (std::size_t i = 0; i < changes.size(); ++i) {
    act("redo");
    settle();
    EXPECT_TRUE(now() == moments[i + 1]) << changes[i];
  }
  EXPECT_FALSE(session_->redo_title());
  EXPECT_EQ(refused("redo"), "there is nothing to do again");
}

TEST_F(SessionTest, TakesADragBackInOneStep) {
  for (const double north_m : {1.0, 2.0, 3.0}) {
    ASSERT_TRUE(session_->apply(actions::LookAt{5.0, north_m, 50.0}));
  }
  session_->seal_history();
  act("look 5 4 50");
  EXPECT_EQ(session_->view().map.centre_in_enu_m.y(), 4.0);
  act("undo");
  EXPECT_EQ(session_->view().map.centre_in_enu_m.y(), 3.0) << "a drag of its own";
  act("undo");
  EXPECT_EQ(session_->view(), default_view_state()) << "all of the first drag";
  EXPECT_FALSE(session_->undo_title());
}

TEST_F(SessionTest, KeepsDragsOfDifferentThingsApart) {
  act("layer-opacity picture 0.5");
  act("layer-opacity labels 0.6");
  act("layer-opacity picture 0.7");
  act("undo");
  EXPECT_EQ(session_->view().map.layer(Layer::kPicture).opacity, 0.5);
  EXPECT_EQ(session_->view().map.layer(Layer::kLabels).opacity, 0.6);
  EXPECT_EQ(session_->undo_title(), "Opacity of labels");
}

TEST_F(SessionTest, DoesNotKeepWhatChangedNothing) {
  act("layer picture on");
  act("theme dark");
  act("show palette");
  EXPECT_EQ(session_->overlay(), Overlay::kPalette);
  EXPECT_FALSE(session_->undo_title());
  act("show none");
  EXPECT_EQ(session_->overlay(), Overlay::kNone);
}

TEST_F(SessionTest, SaysWhatUndoTakesBack) {
  act("layer particles toggle");
  EXPECT_EQ(session_->undo_title(), "Hide particles");
  act("layer particles toggle");
  EXPECT_EQ(session_->undo_title(), "Show particles");
  act("theme light");
  EXPECT_EQ(session_->undo_title(), "Light theme");
  act("undo");
  EXPECT_EQ(session_->redo_title(), "Light theme");
}

TEST_F(SessionTest, ForgetsWhatCouldBeDoneAgainOnceSomethingElseIsDone) {
  act("theme light");
  act("undo");
  act("layer truth off");
  EXPECT_FALSE(session_->redo_title());
}

TEST_F(SessionTest, LogsWhatWasDoneInWordsThatDoItAgain) {
  act("layer particles off");
  act("look 1 2 3");
  act("look 4 5 6");
  session_->seal_history();
  act("look 7 8 9");
  EXPECT_NE(refused("layer-opacity picture 2"), "");
  const std::vector<std::string> log(session_->log().begin(), session_->log().end());
  EXPECT_THAT(log, ElementsAre("layer particles off", "look 4 5 6", "look 7 8 9",
                               "# layer-opacity picture 2: an opacity of 2 is not in [0, 1]"));
}

TEST_F(SessionTest, SaysTheSameThingOnceUntilSomethingElseIsSaid) {
  EXPECT_NE(refused("seek 1"), "");
  EXPECT_NE(refused("seek 2"), "");
  EXPECT_THAT(session_->notices(), SizeIs(1));
  session_->notify(Notice::Kind::kWarning, "a file could not be dropped", "details");
  EXPECT_NE(refused("seek 2"), "");
  ASSERT_THAT(session_->notices(), SizeIs(3));
  EXPECT_EQ(session_->notices()[1].details, "details");
  act("dismiss " + std::to_string(session_->notices()[1].number));
  EXPECT_THAT(session_->notices(), SizeIs(2));
  EXPECT_THAT(refused("dismiss 4711"), HasSubstr("there is no notice 4711"));
  act("dismiss");
  EXPECT_THAT(session_->notices(), IsEmpty());
}

TEST_F(SessionTest, SharesItsMemoryAmongTheOpenRuns) {
  open_run();
  EXPECT_EQ(session_->runs()[0].cache->budget_bytes(), 256U << 20U);
  act("memory 32");
  EXPECT_EQ(session_->runs()[0].cache->budget_bytes(), 32U << 20U);
  act("open " + copy_run("second.nadir").string());
  settle();
  EXPECT_EQ(session_->runs()[0].cache->budget_bytes(), 16U << 20U);
  EXPECT_EQ(session_->runs()[1].cache->budget_bytes(), 16U << 20U);
  EXPECT_THAT(refused("memory 1"), HasSubstr("a memory of 1 MB is not in [16, 65536]"));
}

TEST_F(SessionTest, AsksTheShellToQuit) {
  act("quit");
  const auto effects = session_->take_effects();
  ASSERT_THAT(effects, SizeIs(1));
  EXPECT_TRUE(std::holds_alternative<QuitEffect>(effects.front()));
  EXPECT_THAT(session_->take_effects(), IsEmpty()) << "once";
}

TEST_F(SessionTest, PutsAwayWhatWentWellByItselfAndFaultsOnlyWhenTold) {
  session_->notify(Notice::Kind::kInfo, "a.svg was written");
  session_->notify(Notice::Kind::kError, "b.svg could not be written");
  session_->poll(6.0);
  EXPECT_EQ(session_->notices().size(), 2U);
  session_->poll(6.0);
  ASSERT_EQ(session_->notices().size(), 1U);
  EXPECT_EQ(session_->notices().front().text, "b.svg could not be written");
  session_->poll(1000.0);
  EXPECT_EQ(session_->notices().size(), 1U);
}

}  // namespace session_test
}  // namespace nadir
