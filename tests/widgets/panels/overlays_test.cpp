// SPDX-License-Identifier: Apache-2.0
// Preferences, places, notes of bookmarks and about: what lies over the window.
#include <gmock/gmock.h>

#include "tests/widgets/panels/shown.h"
#include "widgets/panels/about_overlay.h"
#include "widgets/panels/bookmark_overlay.h"
#include "widgets/panels/place_overlay.h"
#include "widgets/panels/preferences_panel.h"

namespace nadir {
namespace overlays_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Preferences : Shown<PreferencesModel, PreferencesState, draw_preferences> {
  explicit Preferences(const Eigen::Vector2d& size_px = {1280.0, 800.0}) : Shown(size_px) {
    model.is_open = true;
    model.layout_names = {"default", "wide"};
    model.memory_used_bytes = 212'000'000;
  }
};

TEST(Preferences, ChangeTheThemeAndMotion) {
  Preferences preferences;
  EXPECT_THAT(preferences.click("Preferences/Look/Theme/Light"), ElementsAre("theme light"));
  EXPECT_THAT(preferences.click("Preferences/Look/Reduced motion"),
              ElementsAre("reduced-motion on"));
  preferences.model.appearance.is_motion_reduced = true;
  EXPECT_THAT(preferences.click("Preferences/Look/Reduced motion"),
              ElementsAre("reduced-motion off"));
}

TEST(Preferences, LeaveTheSizeToTheScreenUntilThatIsSwitchedOff) {
  Preferences preferences;
  preferences.wait(3);
  EXPECT_FALSE(preferences.screen.at("Preferences/Look/Size").is_enabled);
  EXPECT_THAT(preferences.screen.at("Preferences/Look/Size").tooltip,
              HasSubstr("the screen decides"));
  EXPECT_THAT(preferences.click("Preferences/Look/Size as the screen asks for"),
              ElementsAre("scale 1"));
  preferences.model.appearance.scale = 1.5;
  EXPECT_THAT(preferences.click("Preferences/Look/Size as the screen asks for"),
              ElementsAre("scale 0"));
}

TEST(Preferences, ChangeTheSizeOnceItIsTyped) {
  Preferences preferences;
  preferences.model.appearance.scale = 1.0;
  EXPECT_THAT(preferences.type("Preferences/Look/Size/value", "1.25"), ElementsAre("scale 1.25"));
}

TEST(Preferences, ChangeTheSizeOnlyWhenTheSliderIsLetGo) {
  Preferences preferences;
  preferences.model.appearance.scale = 1.0;
  const Actions asked = preferences.screen.drag("Preferences/Look/Size", 20.0, 0.0, preferences);
  EXPECT_EQ(asked.size(), 1U);
}

TEST(Preferences, BoundTheMemoryAndShowWhatIsUsed) {
  Preferences preferences;
  EXPECT_THAT(preferences.type("Preferences/Memory/At most/value", "512"),
              ElementsAre("memory 512"));
  EXPECT_EQ(preferences.screen.at("Preferences/Memory/Used now").value, "212 MB");
}

TEST(Preferences, RefuseANumberOutOfRangeAtItsControlAndKeepWhatWasTyped) {
  Preferences preferences;
  EXPECT_THAT(preferences.type("Preferences/Memory/At most/value", "5"), IsEmpty());
  preferences.wait();
  EXPECT_TRUE(preferences.screen.shows("5 is not in [64, 8192] MB")) << preferences.screen.words();
  EXPECT_EQ(preferences.screen.at("Preferences/Memory/At most/value").value, "5");
  EXPECT_THAT(preferences.type("Preferences/Memory/At most/value", "512"),
              ElementsAre("memory 512"));
  preferences.wait();
  EXPECT_FALSE(preferences.screen.shows("is not in"));
}

TEST(Preferences, UseALayout) {
  Preferences preferences;
  EXPECT_THAT(preferences.click("Preferences/Layouts/wide##wide"), ElementsAre("layout wide"));
}

TEST(Preferences, KeepALayoutUnderAName) {
  Preferences preferences;
  preferences.wait(3);
  EXPECT_FALSE(preferences.screen.at("Preferences/Layouts/Keep").is_enabled);
  EXPECT_THAT(preferences.screen.at("Preferences/Layouts/Keep").tooltip,
              HasSubstr("give it a name first"));
  preferences.type("Preferences/Layouts/##Name", "my own", false);
  EXPECT_THAT(preferences.click("Preferences/Layouts/Keep"), ElementsAre("save-layout \"my own\""));
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
  preferences.wait(4);
  EXPECT_LE(preferences.screen.at("Preferences").rect.bottom(), 600.0);
  EXPECT_TRUE(preferences.screen.at("Preferences/Done").is_visible);
}

TEST(Preferences, CloseByDoneAndByEscape) {
  Preferences preferences;
  EXPECT_THAT(preferences.click("Preferences/Done"), ElementsAre("show none"));
  EXPECT_THAT(preferences.press("Escape"), Contains("show none"));
}

struct Place : Shown<PlaceModel, PlaceState, draw_place_overlay> {
  Place() {
    model.is_open = true;
    model.plane = ProjectPlane::create({33.45, -83.9}).value();
    model.here_in_enu_m = {12.0, -34.0};
  }
};

TEST(PlaceOverlay, ShowsHowPlacesAreWrittenByTheMiddleOfTheView) {
  Place place;
  place.wait(3);
  EXPECT_EQ(place.screen.at("Go to a place/Metres east and north").value, "12.0 -34.0");
  EXPECT_THAT(place.screen.at("Go to a place/MGRS").value, HasSubstr("17S"));
}

TEST(PlaceOverlay, GoesToWhatIsTyped) {
  Place place;
  EXPECT_THAT(place.type("Go to a place/##Coordinates", "100 200"),
              ElementsAre("show none", "place \"100 200\""));
}

TEST(PlaceOverlay, ShowsThePlaceInTheOtherWaysWhileItIsTyped) {
  Place place;
  place.type("Go to a place/##Coordinates", "100 200", false);
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
  EXPECT_THAT(place.click("Go to a place/Open the demo"), ElementsAre("show none", "open-demo"));
}

TEST(PlaceOverlay, ClosesByEscapeAndForgets) {
  Place place;
  place.type("Go to a place/##Coordinates", "1 2", false);
  EXPECT_THAT(place.press("Escape"), Contains("show none"));
  place.model.is_open = false;
  place.screen.frame(place);
  EXPECT_EQ(place.state.typed, "");
}

struct Note : Shown<BookmarkNoteModel, BookmarkNoteState, draw_bookmark_note> {
  Note() {
    model.is_open = true;
    model.run = "loop medium 7";
    model.time_s = 42.34;
  }
};

TEST(BookmarkNote, SaysWhichMomentItMarks) {
  Note note;
  note.wait(3);
  EXPECT_TRUE(note.screen.shows("00:42.3"));
  EXPECT_TRUE(note.screen.shows("of loop medium 7"));
}

TEST(BookmarkNote, MarksWithWhatWasTyped) {
  Note note;
  note.wait(3);
  note.type_here("left the road");
  EXPECT_THAT(note.press("Enter"), ElementsAre("show none", "bookmark \"left the road\""));
}

TEST(BookmarkNote, MarksWithoutANoteToo) {
  Note note;
  EXPECT_THAT(note.click("Bookmark/Mark"), ElementsAre("show none", "bookmark"));
}

TEST(BookmarkNote, WithoutARunOffersTheDemo) {
  Note note;
  note.model.run.clear();
  EXPECT_THAT(note.click("Bookmark/Open the demo"), ElementsAre("show none", "open-demo"));
}

TEST(BookmarkNote, OfARunWithALongNameStaysInItsFrame) {
  Note note;
  note.model.run = std::string(300, 'r');
  note.wait(3);
  const double right = note.screen.at("Bookmark").rect.right();
  for (const kit::Control& control : note.screen.controls())
    EXPECT_LE(control.rect.right(), right) << control.path;
}

Actions draw_about_alone(kit::Ui& ui, const AboutModel& model, int& /*state*/) {
  return draw_about(ui, model);
}
using About = Shown<AboutModel, int, draw_about_alone>;

TEST(AboutOverlay, SaysTheVersionCopiesItAndCloses) {
  About about;
  about.model = {true, "1.2.3"};
  EXPECT_THAT(about.click("About Nadir/Copy version"), ElementsAre("copy \"Nadir 1.2.3\""));
  EXPECT_THAT(about.click("About Nadir/Close"), ElementsAre("show none"));
  EXPECT_EQ(about.screen.at("About Nadir/Version").value, "1.2.3");
}

TEST(AboutOverlay, OfAClosedOneDrawsNothing) {
  About about;
  EXPECT_THAT(about.wait(2), IsEmpty());
  EXPECT_FALSE(about.screen.has("About Nadir"));
}

}  // namespace overlays_test
}  // namespace nadir
