// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include "core/base/settings.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace {

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
  act("preset run");
  EXPECT_EQ(draft().preset, "default");
  EXPECT_EQ(session_->draft_options()->localiser.particle_count, 300);
  EXPECT_EQ(session_->draft_options()->localiser.max_cells_per_class, 50);
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
}

}  // namespace
}  // namespace nadir
