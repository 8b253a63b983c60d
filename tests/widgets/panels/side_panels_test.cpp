// SPDX-License-Identifier: Apache-2.0
// The small ones: rail, empty states, welcome, about.
#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/asked.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/about_overlay.h"
#include "widgets/panels/empty_state.h"
#include "widgets/panels/left_rail.h"
#include "widgets/panels/welcome_panel.h"

namespace nadir {
namespace {

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
  for (const char* const later : {"Workspaces/Label", "Workspaces/Study"}) {
    EXPECT_FALSE(screen.at(later).is_enabled);
    EXPECT_THAT(screen.at(later).tooltip, HasSubstr("later version"));
  }
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

struct Welcome {
  explicit Welcome(const Eigen::Vector2d& size_px = {1280.0, 800.0})
      : screen(ThemeName::kLight, 1.0, size_px) {}
  kit::HeadlessUi screen;
  WelcomeModel model;
  PaletteState palette;
  Actions operator()(kit::Ui& ui) { return draw_welcome(ui, model, palette); }
};

TEST(Welcome, OffersTheDemoFilesAndDropping) {
  Welcome welcome;
  EXPECT_THAT(texts(welcome.screen.click("Welcome/Open the demo", welcome)),
              ElementsAre("open-demo"));
  EXPECT_THAT(texts(welcome.screen.click("Welcome/Open files…", welcome)),
              ElementsAre("show palette"));
  EXPECT_EQ(welcome.palette.begun, "open");
  EXPECT_TRUE(welcome.screen.shows("drop files here"));
}

TEST(Welcome, SaysThatTheDemoIsBeingMade) {
  Welcome welcome;
  welcome.model.busy = "making the demo";
  welcome.screen.wait(2, welcome);
  EXPECT_FALSE(welcome.screen.at("Welcome/Open the demo").is_enabled);
  EXPECT_THAT(welcome.screen.at("Welcome/Open the demo").tooltip, HasSubstr("making the demo"));
}

TEST(Welcome, ListsWhatWasOpenedWithItsFolder) {
  Welcome welcome;
  welcome.model.home = "/home/ada";
  welcome.model.recents = {"/home/ada/flights/loop.nadir", "/maps/town"};
  EXPECT_THAT(
      texts(welcome.screen.click("Welcome/Recent/loop##/home/ada/flights/loop.nadir", welcome)),
      ElementsAre("open /home/ada/flights/loop.nadir"));
  EXPECT_EQ(welcome.screen.at("Welcome/Recent/loop##/home/ada/flights/loop.nadir").value,
            "~/flights");
}

TEST(Welcome, SaysWhereRecentFilesWillBe) {
  Welcome welcome;
  welcome.screen.wait(2, welcome);
  EXPECT_TRUE(welcome.screen.shows("What you open is listed here."));
}

TEST(Welcome, Of500RecentFilesDrawsOnlyThoseInSight) {
  Welcome welcome;
  for (int i = 0; i < 500; ++i) {
    welcome.model.recents.push_back("/flights/" + std::string(100, 'f') + "/" +
                                    std::string(100, 'n') + std::to_string(i) + ".nadir");
  }
  welcome.screen.wait(3, welcome);
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
  EXPECT_THAT(texts(welcome.screen.click("Welcome/Open what there is", welcome)),
              ElementsAre("open /a/loop.nadir", "dismiss 7"));
}

TEST(Welcome, FitsIntoTheSmallestWindow) {
  Welcome welcome({640.0, 480.0});
  welcome.screen.wait(3, welcome);
  for (const char* const path : {"Welcome/Open the demo", "Welcome/Open files…"}) {
    EXPECT_TRUE(welcome.screen.at(path).is_visible) << path;
    EXPECT_LE(welcome.screen.at(path).rect.right(), 640.0);
  }
}

TEST(WelcomeModel, OfANewSessionOffersNothing) {
  const NewSession made;
  const WelcomeModel model = welcome_model(made.session);
  EXPECT_THAT(model.recents, IsEmpty());
  EXPECT_FALSE(model.offer);
  EXPECT_EQ(model.busy, "");
}

TEST(About, SaysTheVersionCopiesItAndCloses) {
  const AboutModel model{true, "1.2.3"};
  kit::HeadlessUi screen;
  const auto draw = [&](kit::Ui& ui) { return draw_about(ui, model); };
  EXPECT_THAT(texts(screen.click("About Nadir/Copy version", draw)),
              ElementsAre("copy \"Nadir 1.2.3\""));
  EXPECT_THAT(texts(screen.click("About Nadir/Close", draw)), ElementsAre("show none"));
  EXPECT_EQ(screen.at("About Nadir/Version").value, "1.2.3");
}

TEST(About, OfAClosedOneDrawsNothing) {
  kit::HeadlessUi screen;
  EXPECT_THAT(screen.wait(2, [](kit::Ui& ui) { return draw_about(ui, {}); }), IsEmpty());
  EXPECT_FALSE(screen.has("About Nadir"));
}

}  // namespace
}  // namespace nadir
