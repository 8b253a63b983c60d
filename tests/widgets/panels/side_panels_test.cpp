// SPDX-License-Identifier: Apache-2.0
// The small ones: rail, empty states, welcome.
#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/shown.h"
#include "widgets/panels/empty_state.h"
#include "widgets/panels/left_rail.h"
#include "widgets/panels/welcome_panel.h"

namespace nadir {
namespace side_panels_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct NewSession {
  ScratchFolder folder;
  Session session{SessionPlaces{folder.path() / "config", folder.path() / "data", {}}};
};

TEST(LeftRail, HasThreeWorkspacesOfWhichReplayIsChosen) {
  const NewSession made;
  const LeftRailModel model = left_rail_model(made.session);
  kit::HeadlessUi screen;
  screen.wait(2, [&](kit::Ui& ui) { return draw_left_rail(ui, model); });
  EXPECT_TRUE(screen.at("Workspaces/Replay").is_selected);
  EXPECT_TRUE(screen.at("Workspaces/Replay").is_enabled);
  EXPECT_FALSE(screen.at("Workspaces/Label").is_enabled);
  EXPECT_THAT(screen.at("Workspaces/Label").tooltip, HasSubstr("open a map or an overhead image"));
  EXPECT_FALSE(screen.at("Workspaces/Study").is_enabled);
  EXPECT_THAT(screen.at("Workspaces/Study").tooltip, HasSubstr("later version"));
}

TEST(LeftRail, OpensPreferencesAndShortcuts) {
  const LeftRailModel model;
  kit::HeadlessUi screen;
  const auto draw = [&](kit::Ui& ui) { return draw_left_rail(ui, model); };
  EXPECT_THAT(texts(screen.click("Workspaces/Preferences", draw)), ElementsAre("show preferences"));
  EXPECT_THAT(texts(screen.click("Workspaces/Shortcuts", draw)), ElementsAre("show shortcuts"));
}

TEST(EmptyState, SaysWhatWouldFillThePanelAndOffersTheOneButton) {
  kit::HeadlessUi screen;
  const auto draw = [](kit::Ui& ui) {
    return draw_empty_state(ui, no_run_state("its error over time"));
  };
  EXPECT_THAT(texts(screen.click("Open the demo", draw)), ElementsAre("open-demo"));
  EXPECT_TRUE(screen.shows("No run is open"));
  EXPECT_TRUE(screen.shows("Open a recorded run to see its error over time."));
}

TEST(EmptyState, HasNoButtonWhereNothingIsToBeDone) {
  kit::HeadlessUi screen;
  screen.wait(
      2, [](kit::Ui& ui) { return draw_empty_state(ui, reading_state(std::string(500, 'x'))); });
  for (const kit::Control& control : screen.controls()) {
    EXPECT_NE(control.kind, kit::ControlKind::kButton);
    EXPECT_LE(control.rect.right(), 1280.0);
  }
}

Actions draw_welcome_alone(kit::Ui& ui, const WelcomeModel& model, int& /*state*/) {
  return draw_welcome(ui, model);
}
using Welcome = Shown<WelcomeModel, int, draw_welcome_alone>;

TEST(Welcome, OffersTheDemoFilesAndDropping) {
  Welcome welcome;
  EXPECT_THAT(welcome.click("Welcome/Open the demo"), ElementsAre("open-demo"));
  EXPECT_THAT(welcome.click("Welcome/Open files…"), ElementsAre("show open"));
  EXPECT_TRUE(welcome.screen.shows("drop files here"));
}

TEST(Welcome, SaysThatTheDemoIsBeingMade) {
  Welcome welcome;
  welcome.model.busy = "making the demo";
  welcome.wait(2);
  EXPECT_FALSE(welcome.screen.at("Welcome/Open the demo").is_enabled);
  EXPECT_THAT(welcome.screen.at("Welcome/Open the demo").tooltip, HasSubstr("making the demo"));
}

TEST(Welcome, ListsWhatWasOpenedWithItsFolder) {
  Welcome welcome;
  welcome.model.home = "/home/ada";
  welcome.model.recents = {"/home/ada/flights/loop.nadir", "/maps/town"};
  EXPECT_THAT(welcome.click("Welcome/Recent/loop##/home/ada/flights/loop.nadir"),
              ElementsAre("open /home/ada/flights/loop.nadir"));
  EXPECT_EQ(welcome.screen.at("Welcome/Recent/loop##/home/ada/flights/loop.nadir").value,
            "~/flights");
}

TEST(Welcome, SaysWhereRecentFilesWillBe) {
  Welcome welcome;
  welcome.wait(2);
  EXPECT_TRUE(welcome.screen.shows("What you open is listed here."));
}

TEST(Welcome, Of500RecentFilesDrawsOnlyThoseInSight) {
  Welcome welcome;
  for (int i = 0; i < 500; ++i) {
    welcome.model.recents.push_back("/flights/" + std::string(100, 'f') + "/" +
                                    std::string(100, 'n') + std::to_string(i) + ".nadir");
  }
  welcome.wait(3);
  std::size_t rows = 0;
  for (const kit::Control& control : welcome.screen.controls()) {
    if (control.kind == kit::ControlKind::kRow) ++rows;
    EXPECT_LE(control.rect.right(), 1280.0) << control.path;
  }
  EXPECT_GT(rows, 4U);
  EXPECT_LT(rows, 40U);
}

TEST(Welcome, OffersToGoOnWithWhatWasCutShort) {
  Welcome welcome;
  welcome.model.offer =
      WelcomeModel::Offer{"loop was being localised when Nadir was killed.", "Open what there is",
                          actions::OpenFile{"/a/loop.nadir"}, 7};
  EXPECT_THAT(welcome.click("Welcome/Open what there is"),
              ElementsAre("open /a/loop.nadir", "dismiss 7"));
}

TEST(Welcome, FitsIntoTheSmallestWindow) {
  Welcome welcome(Eigen::Vector2d(640.0, 480.0));
  welcome.wait(3);
  for (const char* const path : {"Welcome/Open the demo", "Welcome/Open files…"}) {
    EXPECT_TRUE(welcome.screen.at(path).is_visible) << path;
    EXPECT_LE(welcome.screen.at(path).rect.right(), 640.0);
  }
}

TEST(Welcome, OffersTheMapsOfAFlightThatWasOpenedByItself) {
  Welcome welcome;
  welcome.model.flight = WelcomeModel::LoneFlight{
      "loop", "nadir flight, 100 pictures in 25 s", "", {"/day/town", "/maps/country"}};
  EXPECT_THAT(welcome.click("Welcome/Flight/Open map town##/day/town"),
              ElementsAre("open /day/town"));
  EXPECT_THAT(welcome.click("Welcome/Flight/Open map country##/maps/country"),
              ElementsAre("open /maps/country"));
  EXPECT_THAT(welcome.click("Welcome/Flight/Another map…"), ElementsAre("show open"));
  EXPECT_TRUE(welcome.screen.shows("100 pictures in 25 s"));
  EXPECT_TRUE(welcome.fits());
}

TEST(Welcome, AsksForTheMapOfAFlightBesideWhichThereIsNone) {
  Welcome welcome;
  welcome.model.flight = WelcomeModel::LoneFlight{
      "drive", "KITTI raw drive, 10 pictures in 1 s", "It has no labels.", {}};
  EXPECT_THAT(welcome.click("Welcome/Flight/Open a map…"), ElementsAre("show open"));
  EXPECT_TRUE(welcome.screen.shows("It has no labels."));
  EXPECT_TRUE(welcome.screen.shows("but not localised"));
  welcome.model.flight->facts.clear();
  welcome.wait(2);
  EXPECT_TRUE(welcome.screen.shows("The flight is being read."));
}

TEST(WelcomeModel, OfANewSessionOffersNothing) {
  const NewSession made;
  const WelcomeModel model = welcome_model(made.session);
  EXPECT_THAT(model.recents, IsEmpty());
  EXPECT_FALSE(model.offer);
  EXPECT_EQ(model.busy, "");
}

}  // namespace side_panels_test
}  // namespace nadir
