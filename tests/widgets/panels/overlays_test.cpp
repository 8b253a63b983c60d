// SPDX-License-Identifier: Apache-2.0
// Preferences, places and notes of bookmarks.
#include <gmock/gmock.h>

#include "tests/widgets/panels/asked.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/bookmark_overlay.h"
#include "widgets/panels/place_overlay.h"
#include "widgets/panels/preferences_panel.h"

namespace nadir {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Preferences {
  explicit Preferences(const Eigen::Vector2d& size_px = {1280.0, 800.0})
      : screen(ThemeName::kDark, 1.0, size_px) {
    model.is_open = true;
    model.layout_names = {"default", "wide"};
    model.memory_used_bytes = 212'000'000;
  }
  kit::HeadlessUi screen;
  PreferencesModel model;
  PreferencesState state;
  Actions operator()(kit::Ui& ui) { return draw_preferences(ui, model, state); }
};

TEST(Preferences, ChangeTheThemeAndMotion) {
  Preferences preferences;
  EXPECT_THAT(texts(preferences.screen.click("Preferences/Look/Theme/Light", preferences)),
              ElementsAre("theme light"));
  EXPECT_THAT(texts(preferences.screen.click("Preferences/Look/Reduced motion", preferences)),
              ElementsAre("reduced-motion on"));
  preferences.model.appearance.is_motion_reduced = true;
  EXPECT_THAT(texts(preferences.screen.click("Preferences/Look/Reduced motion", preferences)),
              ElementsAre("reduced-motion off"));
}

TEST(Preferences, LeaveTheSizeToTheScreenUntilThatIsSwitchedOff) {
  Preferences preferences;
  preferences.screen.wait(3, preferences);
  EXPECT_FALSE(preferences.screen.at("Preferences/Look/Size").is_enabled);
  EXPECT_THAT(preferences.screen.at("Preferences/Look/Size").tooltip,
              HasSubstr("the screen decides"));
  EXPECT_THAT(
      texts(preferences.screen.click("Preferences/Look/Size as the screen asks for", preferences)),
      ElementsAre("scale 1"));
  preferences.model.appearance.scale = 1.5;
  EXPECT_THAT(
      texts(preferences.screen.click("Preferences/Look/Size as the screen asks for", preferences)),
      ElementsAre("scale 0"));
}

TEST(Preferences, ChangeTheSizeOnceItIsTyped) {
  Preferences preferences;
  preferences.model.appearance.scale = 1.0;
  EXPECT_THAT(texts(preferences.screen.type("Preferences/Look/Size/value", "1.25", preferences)),
              ElementsAre("scale 1.25"));
}

TEST(Preferences, ChangeTheSizeOnlyWhenTheSliderIsLetGo) {
  Preferences preferences;
  preferences.model.appearance.scale = 1.0;
  const Actions asked = preferences.screen.drag("Preferences/Look/Size", 20.0, 0.0, preferences);
  EXPECT_EQ(asked.size(), 1U);
}

TEST(Preferences, BoundTheMemoryAndShowWhatIsUsed) {
  Preferences preferences;
  EXPECT_THAT(
      texts(preferences.screen.type("Preferences/Memory/At most/value", "512", preferences)),
      ElementsAre("memory 512"));
  EXPECT_EQ(preferences.screen.at("Preferences/Memory/Used now").value, "212 MB");
}

TEST(Preferences, UseALayout) {
  Preferences preferences;
  EXPECT_THAT(texts(preferences.screen.click("Preferences/Layouts/wide##wide", preferences)),
              ElementsAre("layout wide"));
}

TEST(Preferences, KeepALayoutUnderAName) {
  Preferences preferences;
  preferences.screen.wait(3, preferences);
  EXPECT_FALSE(preferences.screen.at("Preferences/Layouts/Keep").is_enabled);
  EXPECT_THAT(preferences.screen.at("Preferences/Layouts/Keep").tooltip,
              HasSubstr("give it a name first"));
  preferences.screen.type("Preferences/Layouts/##Name", "my own", preferences, false);
  EXPECT_THAT(texts(preferences.screen.click("Preferences/Layouts/Keep", preferences)),
              ElementsAre("save-layout \"my own\""));
  EXPECT_EQ(preferences.state.layout_name, "");
}

TEST(Preferences, DoNotKeepALayoutOverTheDefault) {
  Preferences preferences;
  EXPECT_THAT(preferences.screen.type("Preferences/Layouts/##Name", "default", preferences),
              IsEmpty());
}

TEST(Preferences, With100LayoutsStillFitIntoASmallWindow) {
  Preferences preferences({960.0, 600.0});
  for (int i = 0; i < 100; ++i)
    preferences.model.layout_names.push_back("layout " + std::string(80, 'x') + std::to_string(i));
  preferences.screen.wait(4, preferences);
  EXPECT_LE(preferences.screen.at("Preferences").rect.bottom(), 600.0);
  EXPECT_TRUE(preferences.screen.at("Preferences/Done").is_visible);
}

TEST(Preferences, CloseByDoneAndByEscape) {
  Preferences preferences;
  EXPECT_THAT(texts(preferences.screen.click("Preferences/Done", preferences)),
              ElementsAre("show none"));
  EXPECT_THAT(texts(preferences.screen.press("Escape", preferences)), Contains("show none"));
}

struct Place {
  Place() {
    model.is_open = true;
    model.plane = ProjectPlane::create({33.45, -83.9}).value();
    model.here_in_enu_m = {12.0, -34.0};
  }
  kit::HeadlessUi screen;
  PlaceModel model;
  PlaceState state;
  Actions operator()(kit::Ui& ui) { return draw_place_overlay(ui, model, state); }
};

TEST(PlaceOverlay, ShowsHowPlacesAreWrittenByTheMiddleOfTheView) {
  Place place;
  place.screen.wait(3, place);
  EXPECT_EQ(place.screen.at("Go to a place/Metres east and north").value, "12.0 -34.0");
  EXPECT_THAT(place.screen.at("Go to a place/MGRS").value, HasSubstr("17S"));
}

TEST(PlaceOverlay, GoesToWhatIsTyped) {
  Place place;
  EXPECT_THAT(texts(place.screen.type("Go to a place/##Coordinates", "100 200", place)),
              ElementsAre("show none", "place \"100 200\""));
}

TEST(PlaceOverlay, ShowsThePlaceInTheOtherWaysWhileItIsTyped) {
  Place place;
  place.screen.type("Go to a place/##Coordinates", "100 200", place, false);
  EXPECT_EQ(place.screen.at("Go to a place/Metres east and north").value, "100.0 200.0");
  EXPECT_TRUE(place.screen.shows("This place"));
}

TEST(PlaceOverlay, SaysWhatIsNoPlaceAndStays) {
  Place place;
  EXPECT_THAT(place.screen.type("Go to a place/##Coordinates", "somewhere", place), IsEmpty());
  EXPECT_FALSE(place.screen.at("Go to a place/Go").is_enabled);
  EXPECT_TRUE(place.screen.shows("somewhere")) << place.screen.words();
}

TEST(PlaceOverlay, WithoutAMapOffersTheDemo) {
  Place place;
  place.model.plane.reset();
  EXPECT_THAT(texts(place.screen.click("Go to a place/Open the demo", place)),
              ElementsAre("show none", "open-demo"));
}

TEST(PlaceOverlay, ClosesByEscapeAndForgets) {
  Place place;
  place.screen.type("Go to a place/##Coordinates", "1 2", place, false);
  EXPECT_THAT(texts(place.screen.press("Escape", place)), Contains("show none"));
  place.model.is_open = false;
  place.screen.frame(place);
  EXPECT_EQ(place.state.typed, "");
}

struct Note {
  Note() {
    model.is_open = true;
    model.run = "loop medium 7";
    model.time_s = 42.34;
  }
  kit::HeadlessUi screen;
  BookmarkNoteModel model;
  BookmarkNoteState state;
  Actions operator()(kit::Ui& ui) { return draw_bookmark_note(ui, model, state); }
};

TEST(BookmarkNote, SaysWhichMomentItMarks) {
  Note note;
  note.screen.wait(3, note);
  EXPECT_TRUE(note.screen.shows("00:42.3"));
  EXPECT_TRUE(note.screen.shows("of loop medium 7"));
}

TEST(BookmarkNote, MarksWithWhatWasTyped) {
  Note note;
  note.screen.wait(3, note);
  note.screen.type_here("left the road", note);
  EXPECT_THAT(texts(note.screen.press("Enter", note)),
              ElementsAre("show none", "bookmark \"left the road\""));
}

TEST(BookmarkNote, MarksWithoutANoteToo) {
  Note note;
  EXPECT_THAT(texts(note.screen.click("Bookmark/Mark", note)),
              ElementsAre("show none", "bookmark"));
}

TEST(BookmarkNote, WithoutARunOffersTheDemo) {
  Note note;
  note.model.run.clear();
  EXPECT_THAT(texts(note.screen.click("Bookmark/Open the demo", note)),
              ElementsAre("show none", "open-demo"));
}

TEST(BookmarkNote, OfARunWithALongNameStaysInItsFrame) {
  Note note;
  note.model.run = std::string(300, 'r');
  note.screen.wait(3, note);
  const double right = note.screen.at("Bookmark").rect.right();
  for (const kit::Control& control : note.screen.controls())
    EXPECT_LE(control.rect.right(), right) << control.path;
}

}  // namespace
}  // namespace nadir
