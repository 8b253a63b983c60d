// SPDX-License-Identifier: Apache-2.0
#include "core/base/staged_output.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_keeping_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class SessionKeepingTest : public SessionTest {};

TEST_F(SessionKeepingTest, KeepsWhichSectionsWereFolded) {
  session_->keep_turned_sections({"Right/Why/Heading", "Right/Why/Modes"});
  restart();
  EXPECT_THAT(session_->turned_sections(), ElementsAre("Right/Why/Heading", "Right/Why/Modes"));
}

TEST_F(SessionKeepingTest, FindsEverythingAsItWasLeft) {
  open_run();
  act("open " + copy_run("second.nadir").string());
  settle();
  for (const char* words : {"run 1", "seek 2.25", "speed 2", "loop 1 3", "look 20 28 33",
                            "follow on", "layer labels on", "panel why on", "splitter left 321",
                            "theme light", "scale 1.25", "option particles 500", "strip nees off",
                            "select-particle 5", "measure 1 2", "memory 99", "save-layout mine"}) {
    act(words);
  }
  settle();
  const ViewState view = session_->view();
  const Playback playback = session_->playback();
  std::vector<std::string> recents(session_->recents().begin(), session_->recents().end());
  restart();
  EXPECT_EQ(session_->view(), view);
  EXPECT_EQ(session_->playback(), playback);
  std::vector<std::string> now(session_->recents().begin(), session_->recents().end());
  std::sort(recents.begin(), recents.end());
  std::sort(now.begin(), now.end());
  EXPECT_EQ(now, recents);
  EXPECT_EQ(session_->memory_budget_megabytes(), 99);
  EXPECT_THAT(session_->layout_names(), ElementsAre("default", "mine"));
  EXPECT_THAT(session_->runs(), SizeIs(2));
  EXPECT_NE(session_->flight(), nullptr);
  EXPECT_THAT(session_->notices(), IsEmpty());
  EXPECT_FALSE(session_->undo_title()) << "another session's changes are not undone";
}

TEST_F(SessionKeepingTest, DoesNotPlayOnByItself) {
  open_run();
  act("play on");
  restart();
  EXPECT_FALSE(session_->playback().is_playing);
}

TEST_F(SessionKeepingTest, KeepsPreferencesForASessionThatRestoresNothing) {
  act("theme light");
  act("scale 2");
  act("splitter left 333");
  act("save-layout mine");
  start();
  EXPECT_EQ(session_->view().appearance, (Appearance{LightOrDark::kLight, 2.0, false}));
  EXPECT_EQ(session_->view().layout, default_layout());
  act("layout mine");
  EXPECT_EQ(session_->view().layout.left_pt, 333.0);
}

TEST_F(SessionKeepingTest, LeavesTheLastSessionWhereNothingWasDone) {
  open_run();
  session_.reset();
  const std::string before = read_text_file(session_file()).value();
  session_ = std::make_unique<Session>(places());  // as with --fresh
  session_->poll(1.5);
  settle();
  session_.reset();
  EXPECT_EQ(read_text_file(session_file()).value(), before);
}

TEST_F(SessionKeepingTest, LeavesTheLastSessionWhateverIsDoneInOneThatIsNotKept) {
  open_run();
  act("look 20 28 33");
  const ViewState view = session_->view();
  session_.reset();
  const std::string before = read_text_file(session_file()).value();
  const fs::path other = copy_run("other.nadir");
  for (int i = 0; i < 2; ++i) {  // as with --fresh, as often as somebody likes
    SessionPlaces fresh = places();
    fresh.keeps_session = false;
    session_ = std::make_unique<Session>(fresh);
    act(open(other));
    settle();
    act("look 1 2 44");
    act("save-layout mine");
    act("save");
    EXPECT_THAT(notice_texts(), Contains(HasSubstr("the next start shows what was open before")));
    session_->poll(1.5);
    poll_until(*session_, [&] {
      const auto text = read_text_file(preferences_file());
      return text && text->find("mine") != std::string::npos;
    });
    EXPECT_EQ(read_text_file(session_file()).value(), before) << "a kill leaves it too";
    session_.reset();
    EXPECT_EQ(read_text_file(session_file()).value(), before);
  }
  restart();
  EXPECT_EQ(session_->view(), view);
  EXPECT_THAT(run_names(), ElementsAre("loop"));
  EXPECT_THAT(session_->layout_names(), ElementsAre("default", "mine")) << "preferences are kept";
  EXPECT_THAT(session_->recents(), Contains(other.string()));
}

TEST_F(SessionKeepingTest, KeepsWhatTwoWindowsHaveChanged) {
  Session other(places());
  act("theme light");
  act("save-layout mine");
  session_->remember_command("speed 2");
  open_run();
  session_.reset();
  ASSERT_TRUE(other.apply(actions::SetMemory{77}));
  ASSERT_TRUE(other.apply(actions::SaveLayout{"theirs"}));
  other.remember_command("speed 5");
  ASSERT_TRUE(other.apply(actions::OpenFile{SmallWorld::get().map.string()}));
  poll_until(other, [&] { return other.map() && other.map()->index; });
  ASSERT_TRUE(other.apply(actions::SaveNow{}));
  poll_until(other, [&] {
    const auto text = read_text_file(preferences_file());
    return text && text->find("theirs") != std::string::npos;
  });
  session_ = std::make_unique<Session>(places());
  EXPECT_EQ(session_->view().appearance.theme, LightOrDark::kLight);
  EXPECT_EQ(session_->memory_budget_megabytes(), 77);
  EXPECT_THAT(session_->layout_names(), ElementsAre("default", "mine", "theirs"));
  EXPECT_THAT(session_->recent_commands(), ElementsAre("speed 5", "speed 2"));
  EXPECT_THAT(session_->recents(), Contains(run_.string()));
}

TEST_F(SessionKeepingTest, LeavesOutWhatIsNotThereAnyMore) {
  open_run();
  const fs::path second = copy_run("second.nadir");
  act("open " + second.string());
  settle();
  session_.reset();
  fs::remove(second);
  restart();
  EXPECT_THAT(notice_texts(), ElementsAre(second.string() + ": is not there any more"));
  ASSERT_THAT(session_->runs(), SizeIs(1));
  EXPECT_EQ(session_->view().active_run, 1);
}

TEST_F(SessionKeepingTest, KeepsTheCommandsThatWereChosenLately) {
  for (int i = 0; i < 12; ++i) session_->remember_command("speed " + std::to_string(i));
  session_->remember_command("speed 7");
  ASSERT_THAT(session_->recent_commands(), SizeIs(8));
  EXPECT_EQ(session_->recent_commands()[0], "speed 7");
  EXPECT_EQ(session_->recent_commands()[1], "speed 11") << "each once";
  start();
  ASSERT_THAT(session_->recent_commands(), SizeIs(8));
  EXPECT_EQ(session_->recent_commands()[0], "speed 7");
}

}  // namespace session_keeping_test
}  // namespace nadir
