// SPDX-License-Identifier: Apache-2.0
// Status bar and log.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/support/drawn_map.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/asked.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/log_panel.h"
#include "widgets/panels/status_bar.h"

namespace nadir {
namespace status_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Status {
  explicit Status(double width = 1280.0) : screen(ThemeName::kDark, 1.0, {width, 60.0}) {}
  kit::HeadlessUi screen;
  StatusBarModel model;
  Actions operator()(kit::Ui& ui) { return draw_status_bar(ui, model); }
};

PlaceReadOut somewhere() { return place_read_out(drawn_map(2.0, {"RB", "T."}), {1.0, 1.0}); }

TEST(PlaceReadOut, SaysClassAndCoordinatesInEveryWay) {
  const PlaceReadOut place = somewhere();
  EXPECT_EQ(place.class_name, "terrain");
  EXPECT_TRUE(place.class_colour);
  EXPECT_DOUBLE_EQ(place.east_m, 1.0);
  EXPECT_THAT(place.geodetic, HasSubstr("N"));
  EXPECT_NE(place.utm, "");
  EXPECT_NE(place.mgrs, "");
}

TEST(PlaceReadOut, HasNoColourForNoClassAndSaysWhatIsOutside) {
  const OverheadMap map = drawn_map(2.0, {"RB", "T."});
  EXPECT_EQ(place_read_out(map, {3.0, 1.0}).class_name, "unclassified");
  EXPECT_FALSE(place_read_out(map, {3.0, 1.0}).class_colour);
  EXPECT_EQ(place_read_out(map, {-30.0, 1.0}).class_name, "outside of the map");
}

TEST(StatusBar, ShowsThePlaceUnderThePointer) {
  Status status;
  status.model.place = somewhere();
  status.screen.wait(2, status);
  EXPECT_TRUE(status.screen.shows("terrain"));
  EXPECT_TRUE(status.screen.shows("E 1.00  N 1.00"));
  EXPECT_TRUE(status.screen.shows(status.model.place->geodetic));
  EXPECT_TRUE(status.screen.shows(status.model.place->mgrs));
  EXPECT_TRUE(status.screen.shows(status.model.place->utm));
}

TEST(StatusBar, LeavesOutReadOutsRatherThanCutThem) {
  Status status(560.0);
  status.model.place = somewhere();
  status.screen.wait(2, status);
  EXPECT_TRUE(status.screen.shows("terrain"));
  EXPECT_FALSE(status.screen.shows(status.model.place->utm));
  for (const kit::Control& control : status.screen.controls())
    EXPECT_LE(control.rect.right(), 560.0) << control.path;
}

TEST(StatusBar, SaysWhatToDoWhereThePointerIsNotOnTheMap) {
  Status status;
  status.model.hint = "Point at the map to read class and coordinates";
  status.screen.wait(2, status);
  EXPECT_TRUE(status.screen.shows("Point at the map"));
}

TEST(StatusBar, ShowsMemoryAndThatAllIsSaved) {
  Status status;
  status.model.memory_used_bytes = 212'000'000;
  status.screen.wait(2, status);
  EXPECT_TRUE(status.screen.shows("212 MB"));
  EXPECT_TRUE(status.screen.shows("saved"));
  status.model.is_recording = true;
  status.screen.wait(2, status);
  EXPECT_TRUE(status.screen.shows("recording"));
}

TEST(StatusBar, CountsWhatIsDrawnWithWhatIsDecoded) {
  Status status;
  status.model.memory_used_bytes = 212'000'000;
  status.model.drawn_bytes = 88'000'000;
  status.model.memory_megabytes = 512;
  status.screen.wait(2, status);
  EXPECT_TRUE(status.screen.shows("300 MB"));
  const auto& controls = status.screen.controls();
  const auto memory = std::find_if(controls.begin(), controls.end(), [](const auto& control) {
    return control.tooltip.find("Memory") != std::string::npos;
  });
  ASSERT_NE(memory, controls.end());
  EXPECT_THAT(memory->tooltip, HasSubstr("212 MB for what is decoded"));
  EXPECT_THAT(memory->tooltip, HasSubstr("at most 512 MB"));
  EXPECT_THAT(memory->tooltip, HasSubstr("88 MB for the map's tiles"));
}

TEST(StatusBar, SaysThatWhatIsOpenIsNotSavedAndTriesAgain) {
  Status status;
  status.model.saving_fault = "/config: Permission denied";
  status.model.is_recording = true;
  EXPECT_THAT(texts(status.screen.click("Status/not saved: try again", status)),
              ElementsAre("save"));
  EXPECT_THAT(status.screen.at("Status/not saved: try again").tooltip,
              HasSubstr("/config: Permission denied"));
  EXPECT_FALSE(status.screen.shows("recording"));
}

TEST(StatusBar, OfAFreshWindowSaysThatWhatIsOpenIsNotKept) {
  Status status;
  status.model.keeps_session = false;
  status.screen.wait(2, status);
  EXPECT_FALSE(status.screen.has("Status/saved")) << "it is not";
  EXPECT_THAT(status.screen.at("Status/not kept").tooltip,
              HasSubstr("the next start shows what was open before this window"));
  status.model.saving_fault = "/config: Permission denied";
  status.screen.wait(2, status);
  EXPECT_THAT(status.screen.at("Status/not saved: try again").tooltip,
              HasSubstr("Preferences cannot be kept: /config"));
}

TEST(StatusBarModel, KnowsWhetherTheSessionIsKept) {
  const ScratchFolder folder;
  SessionPlaces places{folder.path() / "config", folder.path() / "data", {}};
  EXPECT_TRUE(status_bar_model(Session(places), std::nullopt).keeps_session);
  places.keeps_session = false;
  EXPECT_FALSE(status_bar_model(Session(places), std::nullopt).keeps_session);
}

TEST(StatusBar, ShowsTheNewestJobAndStopsIt) {
  Status status;
  status.model.jobs = {{1, "writing report", 0.1, "", {}},
                       {2, "localising loop", 0.439, "step 43 of 100", 12.0}};
  EXPECT_THAT(texts(status.screen.click("Status/Cancel", status)), ElementsAre("cancel 2"));
  EXPECT_TRUE(status.screen.shows("localising loop · 12 s left · 1 more")) << status.screen.words();
  EXPECT_TRUE(status.screen.shows(" 43 %"));
}

TEST(StatusBar, OfALongJobStaysInTheWindow) {
  Status status(960.0);
  status.model.place = somewhere();
  status.model.jobs = {{1, "localising " + std::string(200, 'x'), 0.5, "", 3.0e3}};
  status.screen.wait(2, status);
  for (const kit::Control& control : status.screen.controls())
    EXPECT_LE(control.rect.right(), 960.0) << control.path;
  EXPECT_TRUE(status.screen.at("Status/Cancel").is_visible);
}

TEST(StatusBar, SaysThatTheRunIsIncompleteInPlaceOfSaved) {
  Status status(1280.0);
  status.model.incomplete = "loop is incomplete: stopped at 00:43.0, after 430 steps";
  status.screen.wait(2, status);
  EXPECT_EQ(status.screen.at("Status/incomplete run").tooltip, status.model.incomplete);
  EXPECT_FALSE(status.screen.has("Status/saved"));
  status.model.is_recording = true;
  status.screen.wait(2, status);
  EXPECT_TRUE(status.screen.has("Status/recording"));
}

TEST(StatusBarModel, OfANewSessionSaysThatNothingIsOpen) {
  const ScratchFolder folder;
  const Session session({folder.path() / "config", folder.path() / "data", {}});
  const StatusBarModel model = status_bar_model(session, Eigen::Vector2d(1.0, 2.0));
  EXPECT_FALSE(model.place);
  EXPECT_EQ(model.hint, "Nothing is open");
  EXPECT_EQ(model.memory_megabytes, session.memory_budget_megabytes());
}

struct Log {
  std::vector<std::string> lines = {"open loop.nadir", "seek 12.5",
                                    "loop.nadir: step 7 is damaged"};
  kit::HeadlessUi screen;
  LogState state;
  Actions operator()(kit::Ui& ui) { return draw_log(ui, {lines}, state); }
  std::string copied(const Actions& asked) {
    return asked.size() == 1 ? std::get<actions::Copy>(asked[0]).text : "not one action";
  }
};

TEST(Log, HasTheNewestOnTop) {
  Log log;
  log.screen.wait(3, log);
  EXPECT_LT(log.screen.at("Log/seek 12.5##1").rect.top,
            log.screen.at("Log/open loop.nadir##0").rect.top);
}

TEST(Log, CopiesAllInTheirOrder) {
  Log log;
  EXPECT_EQ(log.copied(log.screen.click("Log/Copy", log)),
            "open loop.nadir\nseek 12.5\nloop.nadir: step 7 is damaged\n");
}

TEST(Log, CopiesWhatIsFound) {
  Log log;
  log.screen.type("Log/Search", "LOOP", log, false);
  EXPECT_FALSE(log.screen.has("Log/seek 12.5##1"));
  EXPECT_EQ(log.copied(log.screen.click("Log/Copy", log)),
            "open loop.nadir\nloop.nadir: step 7 is damaged\n");
}

TEST(Log, CopiesWhatIsSelected) {
  Log log;
  log.screen.click("Log/seek 12.5##1", log);
  EXPECT_EQ(log.copied(log.screen.click("Log/Copy", log)), "seek 12.5\n");
  log.screen.click("Log/open loop.nadir##0", log, {.ctrl = true});
  EXPECT_THAT(log.state.selected, ElementsAre(0U, 1U));
  log.screen.click("Log/seek 12.5##1", log);
  log.screen.click("Log/seek 12.5##1", log);
  EXPECT_THAT(log.state.selected, IsEmpty());
}

TEST(Log, SelectsARangeWithShift) {
  Log log;
  log.screen.click("Log/open loop.nadir##0", log);
  log.screen.click("Log/loop.nadir: step 7 is damaged##2", log, {.shift = true});
  EXPECT_THAT(log.state.selected, ElementsAre(0U, 1U, 2U));
}

TEST(Log, SaysWhatItIsForWhileItIsEmptyAndThatNothingIsFound) {
  Log log;
  log.lines.clear();
  log.screen.wait(2, log);
  EXPECT_TRUE(log.screen.shows("Nothing done yet"));
  log.lines = {"quit"};
  log.screen.wait(2, log);
  log.screen.type("Log/Search", "zzz", log, false);
  EXPECT_TRUE(log.screen.shows("Nothing found"));
  EXPECT_FALSE(log.screen.at("Log/Copy").is_enabled);
}

TEST(Log, ForgetsASelectionOfLinesThatAreGone) {
  Log log;
  log.screen.click("Log/loop.nadir: step 7 is damaged##2", log);
  log.lines.resize(1);
  log.screen.wait(1, log);
  EXPECT_THAT(log.state.selected, IsEmpty());
}

TEST(Log, Of100000LinesDrawsThoseInSight) {
  Log log;
  log.lines.assign(100'000, "step 1 and " + std::string(400, 'x'));
  log.screen.wait(3, log);
  EXPECT_LT(log.screen.controls().size(), 100U);
}

}  // namespace status_test
}  // namespace nadir
