// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include "core/base/log.h"
#include "core/base/staged_output.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_saving_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// How and when the files are written, and what becomes of those that cannot be read.
class SessionSavingTest : public SessionTest {};

/// Run by the next test in a process of its own.
TEST(DISABLED_KilledSession, ChangesItsLookAndIsKilled) {
  const fs::path folder = folder_of_this_process();
  ASSERT_FALSE(folder.empty()) << "only as part of another test";
  Session session(places_in(folder));
  ASSERT_TRUE(session.apply(actions::SetTheme{LightOrDark::kLight}));
  ASSERT_TRUE(session.apply(actions::LookAt{1.0, 2.0, 30.0}));
  session.poll(1.5);
  poll_until(session, [&] { return fs::exists(folder / "config" / "preferences.toml"); });
  ::raise(SIGKILL);
}

TEST_F(SessionSavingTest, SavesWithinASecondSoThatAKillLosesLittle) {
  session_.reset();
  fs::remove_all(scratch_.path() / "config");
  ASSERT_EQ(killed_by_running("DISABLED_KilledSession.ChangesItsLookAndIsKilled", scratch_.path()),
            SIGKILL);
  session_ = std::make_unique<Session>(places());
  session_->restore();
  EXPECT_EQ(session_->view().appearance.theme, LightOrDark::kLight);
  EXPECT_EQ(session_->view().map.centre_in_enu_m, Eigen::Vector2d(1.0, 2.0));
}

TEST_F(SessionSavingTest, WritesOnlyWhatHasChanged) {
  act("theme light");
  session_->poll(1.5);
  poll_until(*session_, [&] { return fs::exists(session_file()); });
  session_->poll(0.0);
  fs::remove(session_file());
  for (int i = 0; i < 5; ++i) session_->poll(1.5);
  EXPECT_FALSE(fs::exists(session_file())) << "nothing has changed since";
}

TEST_F(SessionSavingTest, SetsADamagedSessionAsideWithOneNotice) {
  act("theme light");
  start();
  session_.reset();
  std::ofstream(session_file()) << "version = 1\n[map_view]\nup = 3\n";
  session_ = std::make_unique<Session>(places());
  session_->restore();
  EXPECT_THAT(notice_texts(), ElementsAre(HasSubstr("up is not a text in quotes")));
  EXPECT_THAT(session_->notices()[0].text, HasSubstr("session.toml.damaged"));
  EXPECT_TRUE(fs::exists(session_file().string() + ".damaged"));
  EXPECT_EQ(session_->view().map, default_map_look());
  EXPECT_EQ(session_->view().appearance.theme, LightOrDark::kLight)
      << "preferences are another file";
  act("theme dark");
  restart();
  EXPECT_THAT(session_->notices(), IsEmpty());
}

TEST_F(SessionSavingTest, SetsDamagedPreferencesAside) {
  session_.reset();
  fs::create_directories(preferences_file().parent_path());
  std::ofstream(preferences_file()) << "\x01\x02";
  session_ = std::make_unique<Session>(places());
  EXPECT_THAT(session_->notices(), SizeIs(1));
  EXPECT_TRUE(fs::exists(preferences_file().string() + ".damaged"));
  EXPECT_EQ(session_->view(), default_view_state());
}

TEST_F(SessionSavingTest, NeverLosesAnEarlierDamagedFile) {
  session_.reset();
  fs::create_directories(preferences_file().parent_path());
  for (const char* text : {"first = ", "second = ", "third = "}) {
    std::ofstream(preferences_file()) << text;
    session_ = std::make_unique<Session>(places());
    session_.reset();
  }
  const std::string file = preferences_file().string();
  EXPECT_EQ(read_text_file(file + ".damaged").value(), "first = ");
  EXPECT_EQ(read_text_file(file + ".damaged-2").value(), "second = ");
  EXPECT_EQ(read_text_file(file + ".damaged-3").value(), "third = ");
}

TEST_F(SessionSavingTest, LeavesWhatANewerVersionWroteAsItIs) {
  session_.reset();
  fs::create_directories(session_file().parent_path());
  std::ofstream(session_file()) << "version = 99\n";
  std::ofstream(preferences_file()) << "version = 98\n";
  session_ = std::make_unique<Session>(places());
  session_->restore();
  EXPECT_THAT(notice_texts(),
              testing::Each(HasSubstr("newer version of Nadir; it stays as it is")));
  EXPECT_THAT(session_->notices(), SizeIs(2));
  act("theme light");
  session_->poll(1.5);
  act("save");
  settle();
  EXPECT_EQ(session_->saving_fault(), "");
  session_.reset();
  EXPECT_EQ(read_text_file(session_file()).value(), "version = 99\n");
  EXPECT_EQ(read_text_file(preferences_file()).value(), "version = 98\n");
  EXPECT_FALSE(fs::exists(session_file().string() + ".damaged"));
}

TEST_F(SessionSavingTest, SaysInTheLogThatTheEndWasNotKept) {
  SessionPlaces nowhere = places();
  nowhere.config = scratch_.file("a-file", "x") / "config";
  session_ = std::make_unique<Session>(nowhere);
  act("theme light");
  std::vector<std::string> said;
  const LogSink before =
      set_log_sink([&said](LogLevel /*level*/, const std::string& line) { said.push_back(line); });
  session_.reset();
  set_log_sink(before);
  EXPECT_THAT(said, ElementsAre(HasSubstr("what was open is not kept for the next start: ")));
}

TEST_F(SessionSavingTest, SaysOfAWindowThatKeepsNoSessionThatPreferencesAreLost) {
  SessionPlaces blocked = places();
  blocked.config = scratch_.file("a-file", "x") / "config";
  blocked.keeps_session = false;
  session_ = std::make_unique<Session>(blocked);
  act("theme light");
  session_->poll(1.5);
  poll_until(*session_, [&] { return !session_->saving_fault().empty(); });
  EXPECT_THAT(notice_texts(), ElementsAre(HasSubstr("preferences cannot be kept: ")));
  std::vector<std::string> said;
  const LogSink before =
      set_log_sink([&said](LogLevel /*level*/, const std::string& line) { said.push_back(line); });
  session_.reset();
  set_log_sink(before);
  EXPECT_THAT(said, ElementsAre(HasSubstr("preferences are not kept: ")));
}

TEST_F(SessionSavingTest, SaysThatItCouldNotBeWrittenUntilTryingAgainWorks) {
  SessionPlaces blocked = places();
  const fs::path file = scratch_.file("a-file", "x");
  blocked.config = file / "config";
  session_ = std::make_unique<Session>(blocked);
  EXPECT_EQ(session_->saving_fault(), "");
  act("theme light");
  session_->poll(1.5);
  poll_until(*session_, [&] { return !session_->saving_fault().empty(); });
  EXPECT_THAT(session_->saving_fault(), HasSubstr("a-file"));
  ASSERT_THAT(session_->notices(), SizeIs(1));
  EXPECT_EQ(session_->notices()[0].remedy_title, "Try again");
  ASSERT_TRUE(session_->notices()[0].remedy);
  ASSERT_TRUE(session_->apply(*session_->notices()[0].remedy));
  settle();
  EXPECT_NE(session_->saving_fault(), "") << "nothing is better yet";
  fs::remove(file);
  act("save");
  poll_until(*session_, [&] { return session_->saving_fault().empty(); });
  EXPECT_TRUE(fs::exists(file / "config" / "session.toml"));
  EXPECT_TRUE(fs::exists(file / "config" / "preferences.toml"));
  EXPECT_THAT(session_->notices(), IsEmpty()) << "it is remedied";
}

TEST_F(SessionSavingTest, TriesAgainByItselfThoughNothingHasChanged) {
  SessionPlaces blocked = places();
  const fs::path file = scratch_.file("a-file", "x");
  blocked.config = file / "config";
  session_ = std::make_unique<Session>(blocked);
  act("theme light");
  session_->poll(1.5);
  poll_until(*session_, [&] { return !session_->saving_fault().empty(); });
  fs::remove(file);
  session_->poll(11.0);
  poll_until(*session_, [&] { return session_->saving_fault().empty(); });
  EXPECT_TRUE(fs::exists(file / "config" / "session.toml"));
}

TEST_F(SessionSavingTest, WritesAtOnceWhenItIsAsked) {
  act("theme light");
  act("save");
  session_->poll(0.0);
  poll_until(*session_, [&] { return fs::exists(session_file()); });
  SessionPlaces nowhere = places();
  nowhere.config.clear();
  session_ = std::make_unique<Session>(nowhere);
  EXPECT_THAT(refused("save"), HasSubstr("there is no folder"));
}

TEST_F(SessionSavingTest, WorksWithoutAFolderAndSaysSoOnceWhereItCannotBeWritten) {
  SessionPlaces nowhere = places();
  nowhere.config = scratch_.file("a-file", "x") / "config";
  session_ = std::make_unique<Session>(nowhere);
  act("theme light");
  session_->poll(1.5);
  poll_until(*session_, [&] { return !session_->notices().empty(); });
  act("theme dark");
  for (int i = 0; i < 5; ++i) session_->poll(1.5);
  EXPECT_THAT(notice_texts(), ElementsAre(HasSubstr("cannot be kept for the next start")));
  nowhere.config.clear();
  session_ = std::make_unique<Session>(nowhere);
  session_->restore();
  act("theme light");
  session_->poll(5.0);
  EXPECT_THAT(session_->notices(), IsEmpty());
}

}  // namespace session_saving_test
}  // namespace nadir
