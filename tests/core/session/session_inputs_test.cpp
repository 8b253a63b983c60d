// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <set>
#include <string_view>

#include "core/base/staged_output.h"
#include "core/session/commands.h"
#include "tests/core/run/recorded_run.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_inputs_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class SessionInputsTest : public SessionTest {
 protected:
  /// A run on a map and a flight that are nowhere.
  fs::path lonely_run() {
    fs::path path = scratch_.path() / "lonely.nadir";
    RunHeader header = example_header();
    header.map_path = "/nowhere/town";
    header.flight_path = "/nowhere/loop";
    auto writer = RunWriter::create(path, header).value();
    for (int i = 0; i < 30; ++i) EXPECT_TRUE(writer.write(example_step(i, 20)));
    EXPECT_TRUE(writer.finish());
    return path;
  }
  /// Why a command cannot be done now; empty: it can.
  [[nodiscard]] std::string reason(std::string_view text) const {
    for (const Command& command : session_commands()) {
      if (command.text == text) return why_not(command, *session_);
    }
    return "no such command";
  }
};

TEST_F(SessionInputsTest, ShowsARunWhoseFlightAndMapAreGone) {
  act(open(lonely_run()));
  settle();
  ASSERT_NE(session_->active_run(), nullptr);
  EXPECT_EQ(document().steps.size(), 30U);
  EXPECT_EQ(session_->flight(), nullptr);
  EXPECT_EQ(session_->map(), nullptr);
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("its flight /nowhere/loop is not there")));
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("its map /nowhere/town is not there")));
  EXPECT_NE(session_->step(), nullptr);
  EXPECT_EQ(refused("rerun start"), "lonely: its flight is not there, so it cannot be run again");
}

TEST_F(SessionInputsTest, OffersTheRerunThatWouldBeMadeAndNoOther) {
  act(open(lonely_run()));
  settle();
  const std::string gone = "lonely: its flight is not there, so it cannot be run again";
  for (const char* rerun : {"rerun start", "rerun cursor"}) EXPECT_EQ(reason(rerun), gone) << rerun;
  EXPECT_EQ(reason("rerun flight"), "open a flight first");
  act(open(SmallWorld::get().flight));
  EXPECT_EQ(reason("rerun flight"), "the flight is still being read");
  EXPECT_EQ(reason("rerun start"), gone);
  act(open(SmallWorld::get().map));
  settle();
  EXPECT_EQ(reason("rerun start"), gone) << "another flight is no reason";
  EXPECT_EQ(reason("rerun flight"), "");
  // Of a run that is begun and not seen yet the next one takes the flight.
  ask_for_a_slow_run(*session_);
  act("rerun flight");
  ASSERT_EQ(session_->active_run()->name, "lonely");
  EXPECT_EQ(session_->run_to_rerun(RerunFrom::kStart)->name, "flight");
  EXPECT_EQ(reason("rerun start"), "");
  EXPECT_EQ(reason("rerun cursor"), gone) << "that is of the moment that is seen";
  act("rerun start");
  EXPECT_EQ(session_->jobs().front().title.find("localising"), 0U);
  act("cancel");
  act("cancel");
  for (const JobStatus& job : session_->jobs()) EXPECT_TRUE(job.is_stopping) << job.title;
  settle();
}

TEST_F(SessionInputsTest, SaysThatTheFlightOfARunIsBeingRead) {
  act(open(run_));
  std::set<std::string> reasons;
  poll_until(*session_, [&] { return reasons.insert(reason("rerun start")).first->empty(); });
  for (const std::string& reason : reasons) {
    EXPECT_TRUE(reason.empty() || reason.ends_with("still being read")) << reason;
  }
}

TEST_F(SessionInputsTest, TakesTheBundledMapWhereARunNamesIt) {
  SessionPlaces with_map = places();
  with_map.bundled_map = scratch_.path() / "brought" / "town";
  fs::create_directories(with_map.bundled_map.parent_path());
  fs::copy(SmallWorld::get().map, with_map.bundled_map, fs::copy_options::recursive);
  session_ = std::make_unique<Session>(with_map);
  act(open(lonely_run()));
  settle();
  ASSERT_NE(session_->map(), nullptr);
  EXPECT_EQ(session_->map()->path, with_map.bundled_map);
}

TEST_F(SessionInputsTest, FindsMapAndFlightThatWereMovedWithTheRun) {
  RunHeader header;
  {
    auto reader = RunReader::open(run_).value();
    header = reader.header();
    header.map_path = "/somewhere/else/street";
    header.flight_path = "/somewhere/else/flight/";
    const auto steps = reader.steps().value();
    fs::create_directory(scratch_.path() / "moved");
    auto writer = RunWriter::create(scratch_.path() / "moved" / "loop.nadir", header).value();
    for (const RunStep& step : steps) ASSERT_TRUE(writer.write(step));
    ASSERT_TRUE(writer.finish());
  }
  fs::copy(SmallWorld::get().map, scratch_.path() / "moved" / "street",
           fs::copy_options::recursive);
  fs::copy(SmallWorld::get().flight, scratch_.path() / "moved" / "flight",
           fs::copy_options::recursive);
  act(open(scratch_.path() / "moved" / "loop.nadir"));
  settle();
  ASSERT_NE(session_->flight(), nullptr);
  EXPECT_EQ(session_->flight()->description().path, scratch_.path() / "moved" / "flight");
  EXPECT_EQ(session_->map()->path, scratch_.path() / "moved" / "street");
  EXPECT_THAT(session_->notices(), IsEmpty());
}

TEST_F(SessionInputsTest, OpensMapsAndFlightsByFolderOrFile) {
  act(open(SmallWorld::get().map / "map.toml"));
  act(open(SmallWorld::get().flight / "flight.toml"));
  settle();
  ASSERT_NE(session_->map(), nullptr);
  EXPECT_EQ(session_->map()->provenance.licence, "CC0-1.0");
  ASSERT_NE(session_->flight(), nullptr);
  EXPECT_EQ(session_->flight()->description().path, SmallWorld::get().flight);
  EXPECT_THAT(session_->recents(), SizeIs(2));
  act("undo");
  EXPECT_EQ(session_->flight(), nullptr);
  act("undo");
  EXPECT_EQ(session_->map(), nullptr);
}

TEST_F(SessionInputsTest, KeepsTheMapThatItHasWhenAnotherCannotBeRead) {
  act(open(SmallWorld::get().map));
  settle();
  fs::copy(SmallWorld::get().map, scratch_.path() / "torn", fs::copy_options::recursive);
  fs::resize_file(scratch_.path() / "torn" / "labels.tif", 100);
  act(open(scratch_.path() / "torn"));
  settle();
  ASSERT_NE(session_->map(), nullptr);
  EXPECT_EQ(session_->map()->path, SmallWorld::get().map);
  EXPECT_NE(session_->map()->index, nullptr);
  EXPECT_EQ(session_->notices().back().kind, Notice::Kind::kError);
  EXPECT_EQ(session_->undo_title(), "Open street");
}

TEST_F(SessionInputsTest, ForgetsAFolderThatIsNoFlight) {
  fs::create_directory(scratch_.path() / "holiday");
  EXPECT_THAT(refused(open(scratch_.path() / "holiday")),
              HasSubstr("holiday: is a folder that holds neither a map nor a flight"));
  scratch_.file("drive/flight.toml", "[flight\n");  // what is wrong is found when it is read
  act(open(scratch_.path() / "drive"));
  settle();
  EXPECT_EQ(session_->view().flight_path, "");
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("flight.toml: line 1")));
  EXPECT_FALSE(session_->undo_title());
  EXPECT_THAT(refused("rerun start"), HasSubstr("no flight is open"));
}

TEST_F(SessionInputsTest, LeavesTheMapThatWasOpenedToARunThatComesBack) {
  const fs::path other = scratch_.path() / "other";
  fs::copy(SmallWorld::get().map, other, fs::copy_options::recursive);
  open_run();
  act(open(other));
  act("look 20 28 33");
  settle();
  start();
  session_->restore();
  settle();
  ASSERT_NE(session_->map(), nullptr);
  EXPECT_EQ(session_->map()->path, other);
  EXPECT_EQ(session_->view().map.width_m, 33.0);
  act("close-run 1");
  act("undo");
  settle();
  EXPECT_EQ(session_->map()->path, other) << "undone as well";
}

TEST_F(SessionInputsTest, LeavesTheMapThatIsOpenedWhileARunIsBeingRead) {
  const fs::path other = scratch_.path() / "other";
  fs::copy(SmallWorld::get().map, other, fs::copy_options::recursive);
  act(open(run_));
  act(open(other));
  settle();
  EXPECT_EQ(session_->map()->path, other);
}

TEST_F(SessionInputsTest, DoesNotChangeWhatWasBeforeARunWasOpened) {
  const fs::path other = scratch_.path() / "other";
  fs::copy(SmallWorld::get().map, other, fs::copy_options::recursive);
  open_run();
  act(open(other));
  settle();
  act("close-run 1");
  act(open(other));
  settle();
  act(open(run_));
  act("theme light");
  settle();
  EXPECT_EQ(session_->map()->path, SmallWorld::get().map) << "the run's own";
  act("undo");
  EXPECT_EQ(session_->view().map_path, SmallWorld::get().map.string()) << "since its opening";
  act("undo");
  EXPECT_EQ(session_->view().map_path, other.string());
  while (session_->undo_title() && !session_->undo_title()->starts_with("Close")) act("undo");
  act("undo");
  EXPECT_THAT(session_->runs(), SizeIs(1));
  EXPECT_EQ(session_->view().map_path, other.string()) << "as somebody had it then";
}

TEST_F(SessionInputsTest, NeverShowsOneRunsCameraUnderAnothersName) {
  act(open(lonely_run()));
  settle();
  act(open(SmallWorld::get().flight));
  settle();
  EXPECT_EQ(session_->flight(), nullptr) << "of another flight than the run";
  ASSERT_TRUE(session_->flight_to_rerun(RerunFrom::kFlight));
  EXPECT_EQ(refused("rerun start"), "lonely: its flight is not there, so it cannot be run again");
}

TEST_F(SessionInputsTest, FindsTheFlightOfARunWhereItIsOpened) {
  const fs::path moved = scratch_.path() / "far" / "away";
  fs::create_directories(moved.parent_path());
  fs::copy(SmallWorld::get().flight, moved, fs::copy_options::recursive);
  RunHeader header;
  {
    auto reader = RunReader::open(run_).value();
    header = reader.header();
    header.flight_path = "/somewhere/else/day";
    auto writer = RunWriter::create(scratch_.path() / "moved.nadir", header).value();
    const auto steps = reader.steps().value();
    for (const RunStep& step : steps) ASSERT_TRUE(writer.write(step));
    ASSERT_TRUE(writer.finish());
  }
  act(open(scratch_.path() / "moved.nadir"));
  settle();
  EXPECT_EQ(session_->flight(), nullptr);
  act(open(moved));
  settle();
  ASSERT_NE(session_->flight(), nullptr) << "it is the very same";
  EXPECT_EQ(session_->flight()->description().path, moved);
}

TEST_F(SessionInputsTest, TriesAFlightAgainThatIsOpenedAgain) {
  const fs::path flight = scratch_.path() / "flight";
  fs::copy(SmallWorld::get().flight, flight, fs::copy_options::recursive);
  RerunTask task = SmallWorld::get().task(scratch_.path() / "made.nadir");
  task.flight = open_flight(flight).value();
  ASSERT_TRUE(rerun(task, {}, [](RerunProgress) {}));
  const std::string good = read_text_file(flight / "flight.toml").value();
  std::ofstream(flight / "flight.toml") << "name = \n";
  act(open(task.run));
  settle();
  EXPECT_EQ(session_->flight(), nullptr);
  std::ofstream(flight / "flight.toml") << good;
  act(open(task.run));
  settle();
  EXPECT_NE(session_->flight(), nullptr);
}

TEST_F(SessionInputsTest, OffersTheMapsBesideAFlightThatIsOpenedByItself) {
  const fs::path flight = scratch_.path() / "day" / "flight";
  fs::create_directories(flight.parent_path());
  fs::copy(SmallWorld::get().flight, flight, fs::copy_options::recursive);
  const fs::path beside = flight.parent_path() / "town";
  fs::copy(SmallWorld::get().map, beside, fs::copy_options::recursive);
  act(open(flight));
  settle();
  ASSERT_NE(session_->flight(), nullptr);
  EXPECT_EQ(session_->map(), nullptr);
  ASSERT_THAT(session_->maps_for_flight(), SizeIs(2));
  EXPECT_EQ(session_->maps_for_flight()[0], beside.string());
  EXPECT_EQ(session_->maps_for_flight()[1], SmallWorld::get().map.string())
      << "the one that came with the program";
  EXPECT_THAT(notice_texts(), IsEmpty());
}

TEST_F(SessionInputsTest, OffersToLocaliseOnceFlightAndMapAreThere) {
  act(open(SmallWorld::get().flight));
  settle();
  act(open(SmallWorld::get().map));
  settle();
  ASSERT_THAT(session_->notices(), SizeIs(1));
  EXPECT_THAT(session_->notices()[0].text, HasSubstr("can be localised on street now"));
  EXPECT_EQ(session_->notices()[0].remedy_title, "Localise now");
  ASSERT_TRUE(session_->notices()[0].remedy);
  EXPECT_EQ(action_text(*session_->notices()[0].remedy), "rerun flight");
  EXPECT_EQ(session_->view().layout.right_tab, Panel::kSettings) << "where its settings are";
  EXPECT_EQ(session_->undo_title(), "Open street") << "an offer is no change";
  act("dismiss");
  settle();
  EXPECT_THAT(session_->notices(), IsEmpty()) << "it is not made again";
}

TEST_F(SessionInputsTest, TakesTheOfferToLocaliseBackWhenARunIsOpen) {
  act(open(SmallWorld::get().flight));
  act(open(SmallWorld::get().map));
  settle();
  ASSERT_THAT(session_->notices(), SizeIs(1));
  act(open(run_));
  settle();
  EXPECT_THAT(session_->notices(), IsEmpty());
}

TEST_F(SessionInputsTest, ReadsTheBundledMapOfTheProvingGround) {
  act("open \"" NADIR_PROVING_GROUND "\"");
  settle();
  ASSERT_NE(session_->map(), nullptr);
  ASSERT_NE(session_->map()->index, nullptr);
  EXPECT_EQ(session_->map()->provenance.name, "proving ground");
  act("fit map");
  EXPECT_GT(session_->view().map.width_m, 100.0);
}

}  // namespace session_inputs_test
}  // namespace nadir
