// SPDX-License-Identifier: Apache-2.0
#include "core/session/view_text.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace nadir {
namespace view_text_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A view in which nothing is as it begins.
SavedView unusual_view() {
  SavedView saved;
  ViewState& view = saved.view;
  view.map_path = "/maps/a \"quoted\" town";
  view.flight_path = "/flights/ümlaut";
  view.runs = {{"/runs/a.nadir", true, 0}, {"/runs/b \\ c.nadir", false, 3}};
  view.active_run = 2;
  view.map.centre_in_enu_m = {1.0 / 3.0, -1e-9};
  view.map.width_m = 123.456;
  view.map.up = MapUp::kFree;
  view.map.up_rad = -2.5;
  view.map.is_following = true;
  view.map.topview_at = PoseSource::kTruth;
  view.map.tool = MapTool::kMeasure;
  view.map.measured_in_enu_m = {{1.0, 2.0}, {-3.5, 4.25}};
  view.map.is_split = true;
  std::swap(view.map.order[0], view.map.order[5]);
  view.map.layer(Layer::kTruth) = {false, 0.25, "#010203"};
  view.layout.left_pt = 301.5;
  view.layout.is_map_only = true;
  view.layout.is_shown[static_cast<std::size_t>(Panel::kScene)] = true;
  view.layout.is_shown[static_cast<std::size_t>(Panel::kRuns)] = false;
  view.layout.left_tab = Panel::kBookmarks;
  view.layout.right_tab = Panel::kScene;
  std::swap(view.layout.strips[1], view.layout.strips[2]);
  view.layout.strips[0].height_pt = 77.0;
  view.appearance = {LightOrDark::kLight, 1.5, true};
  view.draft = {"thesis", {{"particles", "500"}, {"match", "class"}}};
  view.selected_particle = 42;
  saved.playback = {12.5, false, 4.0, 1.0, 20.0};
  return saved;
}

TEST(ViewText, GivesTheSameViewAgain) {
  for (const SavedView& saved : {SavedView(), unusual_view()}) {
    const std::string text = view_text(saved);
    const auto read = parse_view_text(text, "session.toml");
    ASSERT_TRUE(read) << error_text(read);
    EXPECT_EQ(read->view, saved.view);
    EXPECT_EQ(read->playback, saved.playback);
    EXPECT_EQ(view_text(*read), text);
  }
}

TEST(ViewText, LeavesWhatIsMissingAsItBegins) {
  const auto read = parse_view_text("version = 1\n[map_view]\nwidth_m = 50\n", "s");
  ASSERT_TRUE(read) << error_text(read);
  ViewState expected = default_view_state();
  expected.map.width_m = 50.0;
  EXPECT_EQ(read->view, expected);
  EXPECT_EQ(read->playback, Playback());
}

TEST(ViewText, BringsWhatIsOutOfRangeIntoIt) {
  const auto read = parse_view_text(
      "version = 1\nactive_run = 9\ntime_s = -5\nspeed = 1000\nloop_from_s = 3\nloop_to_s = 2\n"
      "[[run]]\npath = \"/a\"\n[appearance]\nscale = 99\n[[layer]]\nname = \"truth\"\nopacity = "
      "7\n",
      "s");
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(read->view.active_run, 1);
  EXPECT_EQ(read->playback, (Playback{0.0, false, kMostSpeed, {}, {}}));
  EXPECT_EQ(read->view.appearance.scale, kMostScale);
  EXPECT_EQ(read->view.map.layer(Layer::kTruth).opacity, 1.0);
}

TEST(ViewText, LeavesWhatALaterVersionMayKnowAsItBegins) {
  const auto read = parse_view_text(
      "version = 1\n[map_view]\nup = \"down\"\nwidth_m = 50\n"
      "[[layer]]\nname = \"sky\"\nvisible = false\n"
      "[[layer]]\nname = \"truth\"\nvisible = false\n"
      "[layout]\npanels = [\"cellar\", \"log\"]\nleft_tab = \"cellar\"\n"
      "[[layout.strip]]\nname = \"smell\"\nvisible = false\n"
      "[appearance]\ntheme = \"sepia\"\n",
      "s");
  ASSERT_TRUE(read) << error_text(read);
  const ViewState normal = default_view_state();
  EXPECT_EQ(read->view.map.up, normal.map.up);
  EXPECT_EQ(read->view.map.width_m, 50.0) << "what it knows it takes";
  EXPECT_TRUE(read->view.map.layer(Layer::kPicture).is_visible) << "the sky is no picture";
  EXPECT_FALSE(read->view.map.layer(Layer::kTruth).is_visible);
  EXPECT_TRUE(read->view.layout.shows(Panel::kLog));
  EXPECT_FALSE(read->view.layout.shows(Panel::kLayers));
  EXPECT_EQ(read->view.layout.strips, normal.layout.strips);
  EXPECT_EQ(read->view.appearance, normal.appearance);
}

TEST(ViewText, RefusesWhatIsNoneNamingTheFault) {
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"", "s: version is missing"},
      {"version = \"one\"", "s: version is not a whole number (line 1)"},
      {"version = 2", "s: was written by a newer version of Nadir"},
      {"version = 1\nmap = 3", "s: map is not a text in quotes (line 2)"},
      {"version = 1\nactive_run = 99999999999",
       "s: active_run is 99999999999, which is out of range"},
      {"version = 1\n[map_view]\ncentre = [1]", "s: map_view: centre is not two numbers"},
      {"version = 1\n[map_view]\nmeasured = [1]", "s: map_view: measured is not pairs of numbers"},
      {"version = 1\n[map_view]\nwidth_m = inf",
       "s: map_view: width_m is inf, not a finite number"},
      {"version = 1\n[[layer]]\nname = 3", "s: layer[0]: name is not a text in quotes"},
      {"version = 1\nrun = 4", "s: run is not a list of tables"},
      {"version = 1\n[[layout.strip]]\nheight_pt = \"x\"",
       "s: layout: strip[0]: height_pt is not a number"},
      {"version = 1\ndraft = 1", "s: draft is not a table"}};
  for (const auto& [text, message] : faults) {
    EXPECT_EQ(error_text(parse_view_text(text, "s")), message) << text;
  }
  EXPECT_THAT(error_text(parse_view_text("version = ", "s")), HasSubstr("s: line 1"));
}

TEST(ViewText, IsReadWhereverItIsCutWithoutMoreThanASentence) {
  const std::string text = view_text(unusual_view());
  for (std::size_t length = 0; length < text.size(); length += 7) {
    const auto read = parse_view_text(text.substr(0, length), "s");
    if (!read) {
      EXPECT_EQ(read.error().message.rfind("s: ", 0), 0U) << read.error().message;
    }
  }
}

TEST(PreferencesText, GivesTheSameAgain) {
  Preferences preferences;
  preferences.appearance = {LightOrDark::kLight, 2.0, true};
  preferences.memory_megabytes = 512;
  preferences.recents = {"/a b", "/c"};
  preferences.recent_commands = {"theme dark", "go worst"};
  preferences.turned_sections = {"Right/Why/Modes", "Left/Runs/Errors"};
  preferences.layouts["mine \"own\""] = default_layout();
  preferences.layouts["wide"] = default_layout();
  preferences.layouts["wide"].left_pt = 444.0;
  preferences.layouts["wide"].strips[0].is_visible = false;
  const auto read = parse_preferences(preferences_text(preferences), "p");
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(read->appearance, preferences.appearance);
  EXPECT_EQ(read->memory_megabytes, 512);
  EXPECT_THAT(read->recents, ElementsAre("/a b", "/c"));
  EXPECT_EQ(read->turned_sections, preferences.turned_sections);
  EXPECT_EQ(read->recent_commands, preferences.recent_commands);
  EXPECT_EQ(read->layouts, preferences.layouts);
}

TEST(PreferencesText, IsRefusedOrRepaired) {
  EXPECT_EQ(parse_preferences("version = 1\nmemory_megabytes = 1", "p")->memory_megabytes,
            kLeastMemoryMegabytes);
  EXPECT_EQ(parse_preferences("version = 1\n[appearance]\nscale = 0.1", "p")->appearance.scale,
            kLeastScale);
  EXPECT_EQ(error_text(parse_preferences("version = 1\nrecents = [1]", "p")),
            "p: recents is not a list of texts in quotes (line 2)");
  EXPECT_EQ(
      error_text(parse_preferences("version = 1\n[[kept_layout]]\nname = \"x\"\nlayout = 3", "p")),
      "p: kept_layout[0]: layout is not a table");
  EXPECT_EQ(error_text(parse_preferences("version = 7", "p")),
            "p: was written by a newer version of Nadir");
}

}  // namespace view_text_test
}  // namespace nadir
