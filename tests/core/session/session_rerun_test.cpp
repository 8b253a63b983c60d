// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include "core/base/settings.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_rerun_test {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::SizeIs;

/// A run that takes so long that it can be watched.
void ask_for_a_slow_run(Session& session) {
  for (const char* words : {"option particles 200000", "option global-particles 200000",
                            "option min-particles 200000", "option adapt-particles false"}) {
    const auto done = session.apply(*parse_action(words));
    ASSERT_TRUE(done) << words << ": " << error_text(done);
  }
}

class SessionRerunTest : public SessionTest {
 protected:
  void ask_for_a_quick_run() {
    act("option particles 300");
    act("option min-particles 300");
    act("option max-cells 50");
  }
  [[nodiscard]] const RunDraft& draft() const { return session_->view().draft; }
};

TEST_F(SessionRerunTest, SetsOptionsByTheirNamesAndForgetsThoseThatAreThePresets) {
  act("option particles 500");
  act("option match class");
  EXPECT_THAT(draft().changed, ElementsAre(Pair("match", "class"), Pair("particles", "500")));
  EXPECT_EQ(session_->draft_options()->localiser.particle_count, 500);
  EXPECT_EQ(session_->draft_options()->localiser.match, MatchKind::kClass);
  act("option particles 10000");
  EXPECT_THAT(draft().changed, ElementsAre(Pair("match", "class"))) << "as the preset has it";
  act("option match");
  EXPECT_THAT(draft().changed, IsEmpty());
}

TEST_F(SessionRerunTest, RefusesOptionsInWordsWithoutDashes) {
  EXPECT_EQ(refused("option particles 0"), "particles: 0 is not in [1, 1000000]");
  EXPECT_THAT(refused("option particles many"), HasSubstr("particles: "));
  EXPECT_EQ(refused("option particels 5"), "particels: no such option (did you mean particles?)");
  EXPECT_EQ(refused("option particels"), "particels: no such option (did you mean particles?)");
}

TEST_F(SessionRerunTest, TakesPresetsByNameFileOrRun) {
  act("option particles 500");
  act("preset thesis");
  EXPECT_EQ(draft(), (RunDraft{"thesis", {}}));
  EXPECT_THAT(refused("preset thesi"), HasSubstr("did you mean thesis?"));
  EXPECT_THAT(refused("preset /no/such.toml"), HasSubstr("/no/such.toml: does not exist"));
  EXPECT_THAT(refused("preset run"), HasSubstr("no run is open"));
  open_run();
  EXPECT_EQ(session_->draft_options()->localiser.particle_count,
            run_preset("thesis")->localiser.particle_count);
  act("preset run");
  EXPECT_EQ(draft(), RunDraft());
  EXPECT_EQ(session_->draft_options()->localiser.particle_count, 300);
  EXPECT_EQ(session_->draft_options()->localiser.max_cells_per_class, 50);
}

TEST_F(SessionRerunTest, TakesTheActiveRunsOwnOptionsUnlessToldOtherwise) {
  const auto text_of = [](const RunOptions& options) {
    std::string text;
    for (const OptionText& option : option_texts(options))
      text += option.name + option.value + "\n";
    return text;
  };
  EXPECT_EQ(text_of(*session_->draft_options()), text_of(RunOptions())) << "without a run";
  open_run();
  EXPECT_EQ(text_of(*session_->draft_options()), text_of(few_particles()));
  EXPECT_EQ(text_of(*session_->draft_base()), text_of(few_particles()));
  act("option particles 500");
  act("option seed 7");
  EXPECT_EQ(session_->draft_base()->localiser.particle_count, 300);
  act("option particles 300");
  EXPECT_THAT(draft().changed, ElementsAre(Pair("seed", "7"))) << "300 is the run's own";
  act("rerun start");
  EXPECT_EQ(session_->draft_base()->localiser.seed, 7U) << "of the run that has just begun";
  settle();
  EXPECT_EQ(document().header.seed, 7U);
  EXPECT_EQ(document().header.options.at("particles"), "300");
  EXPECT_EQ(document().header.options.at("max-cells"), "50");
  const fs::path file = scratch_.path() / "as-the-run.toml";
  act("save-preset " + file.string());
  const auto recipe = read_run_recipe(file);
  ASSERT_TRUE(recipe) << error_text(recipe);
  EXPECT_EQ(text_of(recipe->options), text_of(*session_->draft_options()));
}

TEST_F(SessionRerunTest, TakesOptionsWhileTheRunIsStillBeingRead) {
  act("open " + run_.string());
  act("option particles 400");
  EXPECT_THAT(session_->draft_options().error().message, HasSubstr("is still being read"));
  EXPECT_EQ(refused("option particles 0"), "particles: 0 is not in [1, 1000000]");
  settle();
  EXPECT_EQ(session_->draft_options()->localiser.particle_count, 400);
  EXPECT_EQ(session_->draft_options()->localiser.max_cells_per_class, 50);
}

TEST_F(SessionRerunTest, StartsAsTheRunWasStarted) {
  RerunTask task = SmallWorld::get().task(scratch_.path() / "lost.nadir");
  task.prior = GlobalPrior{};
  task.options.localiser.global_particle_count = 400;
  ASSERT_TRUE(rerun(task, {}, [](RerunProgress) {}));
  act("open " + task.run.string());
  settle();
  act("rerun start");
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(2));
  EXPECT_EQ(document().header.options.at("prior"), "global");
  const auto& first = session_->runs()[0].document->steps;
  ASSERT_EQ(document().steps.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(document().steps[i].estimate.moments.mean, first[i].estimate.moments.mean);
  }
  // What goes on from such a run began as it did.
  act("seek 2");
  act("rerun cursor");
  settle();
  act("rerun start");
  settle();
  EXPECT_EQ(document().header.parent_run, "");
  EXPECT_EQ(document().header.options.at("prior"), "global");
}

TEST_F(SessionRerunTest, RefusesToGuessHowARunWasStarted) {
  open_run();
  act("seek 2");
  act("rerun cursor");
  settle();
  act("close-run 1");
  fs::remove(run_);
  EXPECT_THAT(
      refused("rerun start"),
      HasSubstr("goes on from loop.nadir, which is not there, so how its flight began is not "
                "known"));
  EXPECT_THAT(session_->runs(), SizeIs(1));
}

TEST_F(SessionRerunTest, CountsOnlyTheNumbersThatItHasGiven) {
  fs::copy_file(run_, scratch_.path() / "kitti-00.nadir");
  fs::copy_file(run_, scratch_.path() / "drive-12.nadir");
  for (const auto& [run, made] :
       {std::pair("kitti-00", "kitti-00-2"), std::pair("drive-12", "drive-12-2")}) {
    act("open " + (scratch_.path() / (std::string(run) + ".nadir")).string());
    settle();
    act("rerun start");
    settle();
    EXPECT_EQ(session_->active_run()->name, made);
  }
  act("rerun start");
  settle();
  EXPECT_EQ(session_->active_run()->name, "drive-12-3") << "that one was ours";
}

TEST_F(SessionRerunTest, LocalisesTheRunsFlightWhateverElseWasOpened) {
  const fs::path other = scratch_.path() / "other";
  fs::copy(SmallWorld::get().flight, other, fs::copy_options::recursive);
  open_run();
  EXPECT_EQ(refused("rerun flight"), "no flight is open: open one first");
  act("open " + other.string());
  settle();
  EXPECT_EQ(session_->flight()->description().path, SmallWorld::get().flight);
  EXPECT_EQ(session_->opened_flight()->description().path, other);
  ASSERT_TRUE(session_->notices().back().remedy);
  EXPECT_EQ(action_text(*session_->notices().back().remedy), "rerun flight") << "that is offered";
  act("rerun start");
  settle();
  EXPECT_EQ(document().header.flight_path, SmallWorld::get().flight.string());
  act("rerun flight");
  settle();
  EXPECT_EQ(document().header.flight_path, other.string());
  EXPECT_EQ(session_->active_run()->path, scratch_.path() / "other.nadir") << "of its own name";
  EXPECT_EQ(document().header.options.at("prior"), "truth of the first frame");
}

TEST_F(SessionRerunTest, SaysThatTheMapIsNotTheOneOfTheRun) {
  open_run();
  OverheadMap changed = SmallWorld::get().index->map();
  changed.labels.at(3, 3) = changed.labels.at(3, 3) == kRoad ? kCurb : kRoad;
  const fs::path map = scratch_.path() / "street";
  ASSERT_TRUE(
      write_overhead_map(changed, {"street", "made for a test", "CC0-1.0", ""}, std::nullopt, map));
  act("rerun start");
  settle();
  EXPECT_THAT(notice_texts(), testing::Each(Not(HasSubstr("whose cells are not those")))) << "yet";
  act("open " + map.string());
  settle();
  act("rerun start");
  EXPECT_THAT(notice_texts(),
              Contains(HasSubstr("whose cells are not those of the map that is open")));
  settle();
}

TEST_F(SessionRerunTest, KeepsTheStepsOfARunThatFailsOnItsWay) {
  const fs::path flight = scratch_.path() / "torn";
  fs::copy(SmallWorld::get().flight, flight, fs::copy_options::recursive);
  std::vector<fs::path> images;
  for (const auto& entry : fs::directory_iterator(flight / "depth")) images.push_back(entry.path());
  std::sort(images.begin(), images.end());
  fs::resize_file(images.at(images.size() / 2), 20);
  act("open " + flight.string());
  act("open " + SmallWorld::get().map.string());
  settle();
  ask_for_a_quick_run();
  act("rerun flight");
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(1));
  EXPECT_GT(document().steps.size(), 3U);
  EXPECT_FALSE(document().is_complete);
  EXPECT_THAT(notice_texts(), Contains(testing::AllOf(
                                  HasSubstr("torn failed after "), HasSubstr("they are kept: "),
                                  HasSubstr(images.at(images.size() / 2).filename().string()))));
}

TEST_F(SessionRerunTest, WritesRecipesThatLocaliseTakes) {
  act("preset thesis");
  act("option particles 500");
  act("option match distance");
  act("option adapt-particles true");
  const RunOptions expected = *session_->draft_options();
  const fs::path file = scratch_.path() / "mine.toml";
  act("save-preset " + file.string());
  const auto recipe = read_run_recipe(file);
  ASSERT_TRUE(recipe) << error_text(recipe);
  EXPECT_EQ(recipe->preset, "thesis");
  const auto text_of = [](const RunOptions& options) {
    std::string text;
    for (const OptionText& option : option_texts(options))
      text += option.name + option.value + "\n";
    return text;
  };
  EXPECT_EQ(text_of(recipe->options), text_of(expected));
  act("preset default");
  act("preset " + file.string());
  EXPECT_EQ(text_of(*session_->draft_options()), text_of(expected));
  EXPECT_THAT(refused("save-preset /no/such/folder/x.toml"), HasSubstr("/no/such/folder"));
}

TEST_F(SessionRerunTest, MakesARunBesideTheActiveOneAndOpensIt) {
  open_run();
  const std::size_t steps = document().steps.size();
  ask_for_a_quick_run();
  act("rerun start");
  const fs::path made = scratch_.path() / "loop-2.nadir";
  ASSERT_THAT(session_->runs(), SizeIs(2));
  EXPECT_EQ(session_->runs()[1].path, made);
  EXPECT_TRUE(session_->runs()[1].is_live);
  EXPECT_EQ(session_->view().active_run, 2);
  EXPECT_THAT(session_->jobs()[0].title, HasSubstr("localising loop-2"));
  EXPECT_EQ(session_->undo_title(), "Rerun");
  settle();
  EXPECT_FALSE(session_->runs()[1].is_live);
  ASSERT_NE(session_->runs()[1].document, nullptr);
  EXPECT_EQ(document().steps.size(), steps);
  EXPECT_TRUE(document().is_complete);
  EXPECT_EQ(session_->playback().time_s, document().duration_s()) << "the cursor went with it";
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("loop-2 is done")));
  EXPECT_EQ(document().header.map_path, SmallWorld::get().map.string());
  for (std::size_t i = 0; i < steps; ++i) {  // the same options give the same bits
    EXPECT_EQ(document().steps[i].estimate.moments.mean,
              session_->runs()[0].document->steps[i].estimate.moments.mean);
  }
  act("undo");
  EXPECT_THAT(session_->runs(), SizeIs(1));
  EXPECT_TRUE(fs::exists(made)) << "its file stays";
  act("redo");
  settle();
  EXPECT_EQ(session_->runs()[1].document->steps.size(), steps);
}

TEST_F(SessionRerunTest, NeverOverwritesARun) {
  open_run();
  ask_for_a_quick_run();
  scratch_.file("loop-2.nadir", "somebody's");
  act("rerun start");
  EXPECT_EQ(session_->runs()[1].name, "loop-3");
  act("rerun start");
  ASSERT_THAT(session_->runs(), SizeIs(3));
  EXPECT_EQ(session_->runs()[2].name, "loop-4") << "another one while the first is made";
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(3));
  act("rerun start");
  ASSERT_THAT(session_->runs(), SizeIs(4));
  EXPECT_EQ(session_->runs()[3].name, "loop-5") << "of loop-4, which is not called loop-4-2";
  settle();
}

TEST_F(SessionRerunTest, GoesOnFromTheCursorWithTheRecordedParticles) {
  open_run();
  ask_for_a_quick_run();
  act("seek 2");
  act("option seed 7");
  act("rerun cursor");
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(2));
  const RunDocument& before = *session_->runs()[0].document;
  const RunDocument& after = document();
  ASSERT_EQ(after.steps.size(), before.steps.size());
  EXPECT_EQ(after.header.parent_run, "loop.nadir");
  for (std::size_t i = 0; i <= 8; ++i) {
    EXPECT_EQ(after.steps[i].estimate.moments.mean, before.steps[i].estimate.moments.mean);
  }
  EXPECT_NE(after.steps.back().estimate.moments.mean, before.steps.back().estimate.moments.mean);
  act("go end");
  EXPECT_EQ(refused("rerun cursor"), "nothing of the flight comes after this moment");
}

TEST_F(SessionRerunTest, LocalisesAFlightThatWasOpenedByItself) {
  fs::copy(SmallWorld::get().flight, scratch_.path() / "flight", fs::copy_options::recursive);
  act("open " + (scratch_.path() / "flight").string());
  settle();
  EXPECT_EQ(refused("rerun start"), "no map is open: open one first");
  act("open " + SmallWorld::get().map.string());
  settle();
  ask_for_a_quick_run();
  act("rerun start");
  EXPECT_EQ(session_->runs()[0].path, scratch_.path() / "flight.nadir") << "beside the flight";
  settle();
  EXPECT_GT(document().steps.size(), 10U);
  EXPECT_EQ(refused("rerun cursor"), "nothing of the flight comes after this moment");
}

TEST_F(SessionRerunTest, CanBeWatchedAndStoppedAndKeepsItsSteps) {
  open_run();
  ask_for_a_slow_run(*session_);
  act("rerun start");
  poll_until(*session_, [&] { return session_->runs()[1].document != nullptr; });
  EXPECT_TRUE(session_->runs()[1].is_live);
  const std::size_t seen = document().steps.size();
  poll_until(*session_, [&] { return document().steps.size() > seen; });
  EXPECT_EQ(session_->playback().time_s, document().duration_s()) << "the cursor stays at the end";
  act("seek 0");
  const std::size_t later = document().steps.size();
  poll_until(*session_, [&] { return document().steps.size() > later; });
  EXPECT_EQ(session_->playback().time_s, 0.0) << "until somebody moves it";
  act("cancel");
  settle();
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("loop-2 was stopped; its")));
  EXPECT_THAT(session_->jobs(), IsEmpty());
  ASSERT_THAT(session_->runs(), SizeIs(2));
  EXPECT_FALSE(document().is_complete);
  EXPECT_EQ(static_cast<std::size_t>(RunReader::open(session_->runs()[1].path)->step_count()),
            document().steps.size());
}

TEST_F(SessionRerunTest, ThatIsClosedGoesOnAndIsOfferedWhenItIsDone) {
  open_run();
  ask_for_a_quick_run();
  act("rerun start");
  act("close-run 2");
  EXPECT_THAT(session_->jobs(), Not(IsEmpty()));
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(1));
  ASSERT_FALSE(session_->notices().empty());
  const Notice done = session_->notices().back();
  EXPECT_THAT(done.text, HasSubstr("loop-2 is done"));
  ASSERT_TRUE(done.remedy);
  ASSERT_TRUE(session_->apply(*done.remedy));
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(2));
}

TEST_F(SessionRerunTest, ThatFailsLeavesNothingButTheReason) {
  open_run();
  act("option min-votes 1000");
  act("rerun start");
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(1));
  EXPECT_EQ(session_->view().active_run, 1);
  EXPECT_FALSE(fs::exists(scratch_.path() / "loop-2.nadir"));
  EXPECT_THAT(session_->notices().back().text, HasSubstr("loop-2 was not made: "));
  EXPECT_EQ(session_->undo_title(), "Set min-votes");
}

TEST_F(SessionRerunTest, IsStoppedInGoodOrderWhenTheSessionEnds) {
  open_run();
  ask_for_a_slow_run(*session_);
  act("rerun start");
  poll_until(*session_, [&] { return session_->runs()[1].document != nullptr; });
  start();
  const auto reader = RunReader::open(scratch_.path() / "loop-2.nadir");
  ASSERT_TRUE(reader) << error_text(reader);
  EXPECT_GE(reader->step_count(), 1);
  session_->restore();
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(2)) << "it is open as before";
  EXPECT_THAT(session_->notices(), IsEmpty());
}

/// Run by the next test in a process of its own.
TEST(DISABLED_KilledSession, IsKilledWhileItMakesARun) {
  const fs::path folder = folder_of_this_process();
  ASSERT_FALSE(folder.empty()) << "only as part of another test";
  Session session(places_in(folder));
  ASSERT_TRUE(session.apply(actions::OpenFile{(folder / "loop.nadir").string()}));
  poll_until(session, [&] { return session.flight() && session.map() && session.map()->index; });
  ask_for_a_slow_run(session);
  const auto begun = session.apply(actions::Rerun{});
  ASSERT_TRUE(begun) << error_text(begun);
  poll_until(session, [&] {
    return session.runs()[1].document && session.runs()[1].document->steps.size() > 2;
  });
  ::raise(SIGKILL);
}

TEST_F(SessionRerunTest, ThatWasKilledIsOfferedByTheNextStartUpToItsLastStep) {
  session_.reset();
  ASSERT_EQ(killed_by_running("DISABLED_KilledSession.IsKilledWhileItMakesARun", scratch_.path()),
            SIGKILL);
  for (int i = 0; i < 2; ++i) {  // as often as somebody starts it otherwise: nadir gui other.nadir
    session_ = std::make_unique<Session>(places());
    EXPECT_THAT(notice_texts(), Contains(HasSubstr("loop-2.nadir was being made when")));
    act("open " + copy_run("other-" + std::to_string(i) + ".nadir").string());
    settle();
    act("rerun start");  // lists its own run beside it
    settle();
    session_->apply(actions::CloseRun{2});
    session_->apply(actions::CloseRun{1});
    session_.reset();
  }
  {
    Session session(places());  // as it was when the program was killed
    EXPECT_TRUE(session.apply(actions::OpenFile{run_.string()}));
    poll_until(session, [&] { return session.map() && session.map()->index; });
  }
  session_ = std::make_unique<Session>(places());
  session_->restore();
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(1)) << "what was open before";
  ASSERT_THAT(session_->notices(), SizeIs(1));
  const Notice offer = session_->notices()[0];
  EXPECT_THAT(offer.text, HasSubstr("loop-2.nadir was being made when Nadir was ended"));
  EXPECT_EQ(offer.remedy_title, "Open it");
  ASSERT_TRUE(offer.remedy);
  ASSERT_TRUE(session_->apply(*offer.remedy));
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(2));
  EXPECT_GT(document().steps.size(), 2U);
  EXPECT_FALSE(document().is_complete);
  ask_for_a_quick_run();
  act("option adapt-particles");
  act("option global-particles");
  act("go end");
  act("rerun cursor");
  settle();
  EXPECT_EQ(document().steps.size(), session_->runs()[0].document->steps.size())
      << "and can be brought to its end";
  start();
  EXPECT_THAT(notice_texts(), IsEmpty()) << "who has opened it is not asked again";
}

TEST_F(SessionRerunTest, ThatWasKilledIsNotOfferedAgainOnceThatIsDismissed) {
  session_.reset();
  ASSERT_EQ(killed_by_running("DISABLED_KilledSession.IsKilledWhileItMakesARun", scratch_.path()),
            SIGKILL);
  start();
  ASSERT_THAT(session_->notices(), SizeIs(1));
  act("dismiss");
  start();
  EXPECT_THAT(session_->notices(), IsEmpty());
  EXPECT_TRUE(fs::exists(scratch_.path() / "loop-2.nadir")) << "it is there for all that";
}

}  // namespace session_rerun_test
}  // namespace nadir
