// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include "core/base/staged_output.h"
#include "tests/core/run/recorded_run.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_files_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class SessionFilesTest : public SessionTest {
 protected:
  [[nodiscard]] std::vector<std::string> run_names() const {
    std::vector<std::string> names;
    for (const OpenRun& run : session_->runs()) names.push_back(run.name);
    return names;
  }
  std::string open(const fs::path& path) { return "open \"" + path.string() + "\""; }
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
};

TEST_F(SessionFilesTest, RefusesWhatIsMissingOrForeignAtOnce) {
  const std::string folder = scratch_.path().string();
  EXPECT_EQ(refused("open " + folder + "/none.nadir"), folder + "/none.nadir: does not exist");
  EXPECT_EQ(refused("open \"\""), "no file is named");
  EXPECT_EQ(refused(open(scratch_.file("text.nadir", "this is no run"))),
            folder + "/text.nadir: is not a run file");
  EXPECT_THAT(refused(open(scratch_.file("film.mp4", "x"))),
              HasSubstr("only PNG and SVG figures carry what they show"));
  EXPECT_THAT(refused(open(scratch_.file("other.toml", "a = 1\n"))), HasSubstr("is no recipe"));
  EXPECT_THAT(refused(open(scratch_.file("broken.toml", "a = \n"))),
              HasSubstr("broken.toml: line 1"));
  EXPECT_THAT(refused(open(scratch_.file("figure.png", "x"))), HasSubstr("cannot be opened here"));
  fs::create_directory(scratch_.path() / "bad-map");
  scratch_.file("bad-map/map.toml", "name = 3\n");
  EXPECT_THAT(refused(open(scratch_.path() / "bad-map")), HasSubstr("map.toml"));
  EXPECT_FALSE(session_->undo_title());
}

TEST_F(SessionFilesTest, TakesADamagedRunAwayAgainAndSaysWhy) {
  std::string bytes = read_text_file(run_).value();
  bytes.resize(bytes.size() / 3);
  const fs::path damaged = scratch_.file("damaged.nadir", bytes);
  act("theme light");
  act(open(damaged));
  EXPECT_THAT(session_->runs(), SizeIs(1));
  settle();
  EXPECT_THAT(session_->runs(), IsEmpty());
  ASSERT_THAT(session_->notices(), SizeIs(1));
  EXPECT_EQ(session_->notices()[0].kind, Notice::Kind::kError);
  EXPECT_THAT(session_->notices()[0].text, HasSubstr("damaged.nadir"));
  EXPECT_EQ(session_->undo_title(), "Light theme") << "as if it had never been opened";
  EXPECT_THAT(session_->recents(), IsEmpty());
}

TEST_F(SessionFilesTest, TakesARunWithoutStepsAwayAgain) {
  record_run(scratch_.path() / "empty.nadir", 0);
  open_run();
  act(open(scratch_.path() / "empty.nadir"));
  settle();
  EXPECT_THAT(run_names(), ElementsAre("loop"));
  EXPECT_EQ(session_->view().active_run, 1);
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("empty.nadir: holds no steps")));
}

TEST_F(SessionFilesTest, ShowsARunWhoseFlightAndMapAreGone) {
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

TEST_F(SessionFilesTest, TakesTheBundledMapWhereARunNamesIt) {
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

TEST_F(SessionFilesTest, FindsMapAndFlightThatWereMovedWithTheRun) {
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

TEST_F(SessionFilesTest, TellsRunsOfOneNameApart) {
  fs::create_directory(scratch_.path() / "two");
  fs::copy_file(run_, scratch_.path() / "two" / "loop.nadir");
  open_run();
  act(open(scratch_.path() / "two" / "loop.nadir"));
  settle();
  EXPECT_THAT(run_names(), ElementsAre("loop", "loop (two)"));
  EXPECT_EQ(session_->view().runs[0].colour, 0);
  EXPECT_EQ(session_->view().runs[1].colour, 1);
  act("close-run 1");
  EXPECT_EQ(session_->view().runs[0].colour, 1) << "a run keeps its colour";
  EXPECT_EQ(session_->view().active_run, 1);
  act(open(run_));
  EXPECT_EQ(session_->view().runs[1].colour, 0) << "the first that is free";
  settle();
}

TEST_F(SessionFilesTest, GoesToARunThatIsOpenAlready) {
  open_run();
  act(open(copy_run("second.nadir")));
  settle();
  act("show-run 1 off");
  act(open(run_));
  EXPECT_THAT(session_->runs(), SizeIs(2));
  EXPECT_EQ(session_->view().active_run, 1);
  EXPECT_TRUE(session_->view().runs[0].is_shown);
  EXPECT_EQ(refused("show-run 1 off"), "loop is the active run, which is always shown");
  EXPECT_EQ(refused("run 3"), "there is no run 3: 2 are open");
  EXPECT_EQ(refused("close-run 0"), "there is no run 0: 2 are open");
}

TEST_F(SessionFilesTest, ReopensAClosedRunByUndo) {
  open_run();
  act("seek 2");
  act("bookmark here");
  act("close-run 1");
  EXPECT_THAT(session_->runs(), IsEmpty());
  EXPECT_EQ(session_->active_run(), nullptr);
  EXPECT_FALSE(session_->is_busy() && session_->playback().is_playing);
  act("undo");
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(1));
  EXPECT_EQ(session_->runs()[0].bookmarks.size(), 1U);
  EXPECT_EQ(session_->playback().time_s, 2.0);
  act("redo");
  EXPECT_THAT(session_->runs(), IsEmpty());
}

TEST_F(SessionFilesTest, SaysSoWhenARunToReopenHasGone) {
  open_run();
  act("close-run 1");
  fs::remove(run_);
  act("undo");
  settle();
  EXPECT_THAT(session_->runs(), IsEmpty());
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("loop.nadir")));
}

TEST_F(SessionFilesTest, OpensMapsAndFlightsByFolderOrFile) {
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

TEST_F(SessionFilesTest, KeepsTheMapThatItHasWhenAnotherCannotBeRead) {
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

TEST_F(SessionFilesTest, ForgetsAFolderThatIsNoFlight) {
  fs::create_directory(scratch_.path() / "holiday");
  act(open(scratch_.path() / "holiday"));
  settle();
  EXPECT_EQ(session_->view().flight_path, "");
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("is not a flight")));
  EXPECT_FALSE(session_->undo_title());
  EXPECT_THAT(refused("rerun start"), HasSubstr("no flight is open"));
}

TEST_F(SessionFilesTest, TakesOptionsFromARecipeOfTheLocaliser) {
  act(open(scratch_.file("mine.toml", "preset = \"thesis\"\n[options]\nparticles = 123\n")));
  EXPECT_EQ(session_->view().draft.preset, "thesis");
  EXPECT_THAT(session_->view().draft.changed,
              ElementsAre(std::pair<const std::string, std::string>("particles", "123")));
}

TEST_F(SessionFilesTest, ReopensTheMomentOfARecipe) {
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

TEST_F(SessionFilesTest, RefusesARecipeWhoseRunIsGone) {
  EXPECT_THAT(refused(open(scratch_.file("m.toml", "figure = \"moment\"\nruns = [\"x.nadir\"]\n"))),
              HasSubstr("m.toml: its run x.nadir is not there"));
  EXPECT_THAT(refused(open(scratch_.file("n.toml", "figure = \"labels\"\nmap = \"nowhere\"\n"))),
              HasSubstr("nowhere"));
  EXPECT_THAT(refused(open(scratch_.file("o.toml", "figure = 3\n"))), HasSubstr("figure is not"));
}

TEST_F(SessionFilesTest, ReopensTheMomentThatAFigureCarries) {
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

TEST_F(SessionFilesTest, MakesTheDemoOnceAndOpensIt) {
  act("open-demo");
  EXPECT_EQ(refused("open-demo"), "the demo is being made already");
  const auto effects = session_->take_effects();
  ASSERT_THAT(effects, SizeIs(1));
  const auto* demo = std::get_if<MakeDemoEffect>(&effects[0]);
  ASSERT_NE(demo, nullptr);
  EXPECT_EQ(demo->folder, (scratch_.path() / "data" / "demo").string());
  fs::create_directories(demo->folder);
  const fs::path made = fs::path(demo->folder) / "run.nadir";
  fs::copy_file(run_, made);
  session_->finish_effect(demo->job, "", made.string());
  settle();
  EXPECT_THAT(run_names(), ElementsAre("run"));
  act("close-run 1");
  act("open-demo");
  EXPECT_THAT(session_->take_effects(), IsEmpty()) << "it is there already";
  settle();
  EXPECT_THAT(run_names(), ElementsAre("run"));
}

TEST_F(SessionFilesTest, MakesADemoAgainThatIsNotWhole) {
  const fs::path made = scratch_.path() / "data" / "demo" / "run.nadir";
  fs::create_directories(made.parent_path());
  record_run(made, 5, 0, false);
  act("open-demo");
  ASSERT_THAT(session_->take_effects(), SizeIs(1));
  EXPECT_THAT(session_->runs(), IsEmpty());
  EXPECT_EQ(refused("open-demo"), "the demo is being made already");
}

TEST_F(SessionFilesTest, ReadsARunAgainThatIsOpenedAgainAfterItWasReplaced) {
  const fs::path path = scratch_.path() / "again.nadir";
  record_run(path, 10);
  act(open(path));
  settle();
  EXPECT_EQ(document().steps.size(), 10U);
  const auto before = session_->active_run()->document;
  act(open(path));
  settle();
  EXPECT_EQ(session_->active_run()->document, before) << "it is the same";
  record_run(path, 25);
  act(open(path));
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(1));
  EXPECT_EQ(document().steps.size(), 25U);
}

TEST_F(SessionFilesTest, ShowsTheNewStepsOfARunThatAnotherProgramWrites) {
  const fs::path path = scratch_.path() / "growing.nadir";
  auto writer = RunWriter::create(path, example_header()).value();
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(writer.write(example_step(i)));
  act(open(path));
  settle();
  EXPECT_EQ(document().steps.size(), 5U);
  for (int i = 5; i < 9; ++i) ASSERT_TRUE(writer.write(example_step(i)));
  session_->poll(1.5);
  settle();
  EXPECT_EQ(document().steps.size(), 9U);
  EXPECT_FALSE(document().is_complete);
  ASSERT_TRUE(writer.finish());
  session_->poll(1.5);
  settle();
  EXPECT_TRUE(document().is_complete);
}

TEST_F(SessionFilesTest, LeavesTheMapThatWasOpenedToARunThatComesBack) {
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

TEST_F(SessionFilesTest, LeavesTheMapThatIsOpenedWhileARunIsBeingRead) {
  const fs::path other = scratch_.path() / "other";
  fs::copy(SmallWorld::get().map, other, fs::copy_options::recursive);
  act(open(run_));
  act(open(other));
  settle();
  EXPECT_EQ(session_->map()->path, other);
}

TEST_F(SessionFilesTest, DoesNotChangeWhatWasBeforeARunWasOpened) {
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

TEST_F(SessionFilesTest, ShowsTheRunsMapAndTheCropOfARecipe) {
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

TEST_F(SessionFilesTest, NeverShowsOneRunsCameraUnderAnothersName) {
  act(open(lonely_run()));
  settle();
  act(open(SmallWorld::get().flight));
  settle();
  EXPECT_EQ(session_->flight(), nullptr) << "of another flight than the run";
  ASSERT_NE(session_->opened_flight(), nullptr);
  EXPECT_EQ(refused("rerun start"), "lonely: its flight is not there, so it cannot be run again");
}

TEST_F(SessionFilesTest, FindsTheFlightOfARunWhereItIsOpened) {
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

TEST_F(SessionFilesTest, TriesAFlightAgainThatIsOpenedAgain) {
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

TEST_F(SessionFilesTest, OffersTheMapsBesideAFlightThatIsOpenedByItself) {
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

TEST_F(SessionFilesTest, OffersToLocaliseOnceFlightAndMapAreThere) {
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

TEST_F(SessionFilesTest, TakesTheOfferToLocaliseBackWhenARunIsOpen) {
  act(open(SmallWorld::get().flight));
  act(open(SmallWorld::get().map));
  settle();
  ASSERT_THAT(session_->notices(), SizeIs(1));
  act(open(run_));
  settle();
  EXPECT_THAT(session_->notices(), IsEmpty());
}

TEST_F(SessionFilesTest, ReadsTheBundledMapOfTheProvingGround) {
  act("open \"" NADIR_PROVING_GROUND "\"");
  settle();
  ASSERT_NE(session_->map(), nullptr);
  ASSERT_NE(session_->map()->index, nullptr);
  EXPECT_EQ(session_->map()->provenance.name, "proving ground");
  act("fit map");
  EXPECT_GT(session_->view().map.width_m, 100.0);
}

}  // namespace session_files_test
}  // namespace nadir
