// SPDX-License-Identifier: Apache-2.0
#include "core/session/change_words.h"

#include <gmock/gmock.h>

#include <set>

namespace nadir {
namespace change_words_test {

std::string title_of(const std::string& words, const ViewState& after = default_view_state()) {
  return change_title(parse_action(words).value(), after);
}
std::string key_of(const std::string& words) { return merge_key(parse_action(words).value()); }

TEST(ChangeTitle, SaysWhatHasBecomeOfTheView) {
  ViewState after = default_view_state();
  after.map.layer(Layer::kErrorSurface).is_visible = true;
  after.map.layer(Layer::kTruth).is_visible = false;
  after.map.is_following = true;
  after.layout.is_map_only = true;
  after.runs = {{"/a", true, 0}, {"/b", false, 1}};
  EXPECT_EQ(title_of("layer error-surface toggle", after), "Show error surface");
  EXPECT_EQ(title_of("layer truth toggle", after), "Hide truth");
  EXPECT_EQ(title_of("follow toggle", after), "Follow estimate");
  EXPECT_EQ(title_of("map-only", after), "Map only");
  EXPECT_EQ(title_of("show-run 2", after), "Hide run 2");
  EXPECT_EQ(title_of("panel log", after), "Hide panel log");
}

TEST(ChangeTitle, NamesWhatWasChanged) {
  EXPECT_EQ(title_of("open /runs/loop.nadir"), "Open loop.nadir");
  EXPECT_EQ(title_of("open /maps/town/"), "Open town");
  EXPECT_EQ(title_of("option particles 5"), "Set particles");
  EXPECT_EQ(title_of("preset /r/mine.toml"), "Preset mine.toml");
  EXPECT_EQ(title_of("theme dark"), "Dark theme");
  EXPECT_EQ(title_of("layer-move truth -1"), "Lower truth");
  EXPECT_EQ(title_of("layer-move truth 1"), "Raise truth");
  EXPECT_EQ(title_of("strip-height update-time 50"), "Height of strip update time");
  EXPECT_EQ(title_of("measure"), "Measure anew");
  EXPECT_EQ(title_of("measure 1 2"), "Measure");
  EXPECT_EQ(title_of("save-layout mine"), "Keep layout mine");
}

TEST(ChangeTitle, OfEveryActionFitsIntoAMenu) {
  for (const ActionHelp& help : action_helps()) {
    for (const std::string arguments :
         {"", " 1", " 1 2", " on", " truth", " truth 1", " truth #123456", " nees 1", " left 200",
          " layers", " light", " north", " pan", " flight", " start", " x", " palette", " nees"}) {
      const auto action = parse_action(std::string(help.name) + arguments);
      if (!action) continue;
      const std::string title = change_title(*action, default_view_state());
      EXPECT_FALSE(title.empty()) << help.name;
      EXPECT_LE(title.size(), 90U) << title;
      EXPECT_TRUE(std::isupper(static_cast<unsigned char>(title.front()))) << title;
    }
  }
}

TEST(MergeKey, IsTheSameForOneDrag) {
  EXPECT_EQ(key_of("look 1 2 3"), key_of("look 4 5 6"));
  EXPECT_EQ(key_of("splitter left 200"), key_of("splitter left 201"));
  EXPECT_EQ(key_of("option blur 1"), key_of("option blur 2"));
}

TEST(MergeKey, DiffersWhereTheTargetDoes) {
  const std::set<std::string> keys = {key_of("look 1 2 3"),
                                      key_of("zoom 2"),
                                      key_of("rotate 3"),
                                      key_of("splitter left 200"),
                                      key_of("splitter right 200"),
                                      key_of("layer-opacity truth 1"),
                                      key_of("layer-opacity labels 1"),
                                      key_of("layer-colour truth #123456"),
                                      key_of("strip-height nees 50"),
                                      key_of("option blur 1"),
                                      key_of("option seed 1"),
                                      key_of("bookmark-note 1 x"),
                                      key_of("bookmark-note 2 x"),
                                      key_of("scale 2"),
                                      key_of("memory 100")};
  EXPECT_EQ(keys.size(), 15U);
  EXPECT_FALSE(keys.contains(""));
}

TEST(MergeKey, IsEmptyForWhatIsDoneOnce) {
  for (const char* words : {"open x", "layer truth on", "theme dark", "undo", "bookmark", "fit map",
                            "measure 1 2", "close-run 1", "layer-move truth 1", "rerun start"}) {
    EXPECT_EQ(key_of(words), "") << words;
  }
}

}  // namespace change_words_test
}  // namespace nadir
