// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace choices_test {

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> names = {"x-y", "yaw", "all"};
  return names;
}

TEST(Choices, GiveTheItemThatWasClicked) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) { return ui.choice("Slices", kinds(), 0); };
  EXPECT_EQ(screen.click("Slices/all", draw), std::optional<std::size_t>(2));
  EXPECT_EQ(screen.at("Slices").value, "x-y");
  EXPECT_TRUE(screen.at("Slices/x-y").is_selected);
  EXPECT_FALSE(screen.at("Slices/all").is_selected);
}

TEST(Choices, SayNothingWhereTheChosenItemIsClicked) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) { return ui.choice("Slices", kinds(), 1); };
  EXPECT_EQ(screen.click("Slices/yaw", draw), std::nullopt);
}

TEST(Choices, LieBesideEachOtherWithoutGaps) {
  HeadlessUi screen;
  screen.frame([](Ui& ui) { (void)ui.choice("Slices", kinds(), 0); });
  const Rect whole = screen.at("Slices").rect;
  double at = whole.left;
  for (const std::string& kind : kinds()) {
    const Rect part = screen.at("Slices/" + kind).rect;
    EXPECT_EQ(part.left, at);
    at = part.right();
  }
  EXPECT_EQ(at, whole.right());
}

TEST(RadioButtons, GiveTheItemThatWasClicked) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) { return ui.radio("Topview", kinds(), 0); };
  EXPECT_EQ(screen.click("Topview/yaw", draw), std::optional<std::size_t>(1));
  EXPECT_EQ(screen.click("Topview/x-y", draw), std::nullopt);
  EXPECT_TRUE(screen.shows("Topview"));
}

TEST(Combos, OpenAListAndGiveWhatIsPickedFromIt) {
  HeadlessUi screen;
  std::size_t chosen = 0;
  const auto draw = [&chosen](Ui& ui) {
    if (const auto picked = ui.combo("Preset", kinds(), chosen)) chosen = *picked;
  };
  screen.frame(draw);
  EXPECT_FALSE(screen.has("Preset/all"));
  screen.click("Preset/all", draw);
  EXPECT_EQ(chosen, 2U);
  screen.wait(3, draw);
  EXPECT_EQ(screen.at("Preset").value, "all");
  EXPECT_FALSE(screen.has("Preset/all")) << "closed by the choice";
}

TEST(Combos, CloseWithoutAChoiceWhenTheMouseClicksElsewhere) {
  HeadlessUi screen;
  std::size_t picks = 0;
  const auto draw = [&picks](Ui& ui) {
    if (ui.combo("Preset", kinds(), 0)) ++picks;
    ui.space(400.0);
    (void)ui.button("Elsewhere");
  };
  screen.click("Preset", draw);
  screen.wait(2, draw);
  EXPECT_TRUE(screen.has("Preset/all"));
  screen.click("Elsewhere", draw);
  screen.wait(2, draw);
  EXPECT_FALSE(screen.has("Preset/all"));
  EXPECT_EQ(picks, 0U);
}

TEST(Combos, OfADisabledScopeStayClosed) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    const auto off = ui.disabled(true, "running");
    return ui.combo("Preset", kinds(), 7);
  };
  EXPECT_THROW((void)screen.click("Preset", draw), std::logic_error);
  EXPECT_EQ(screen.at("Preset").value, "") << "an index beyond the items shows nothing";
}

TEST(Tabs, GiveTheTabThatWasClickedAndDrawNothingElse) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) { return ui.tabs("Side", kinds(), 0); };
  EXPECT_EQ(screen.click("Side/yaw", draw), std::optional<std::size_t>(1));
  EXPECT_EQ(screen.click("Side/x-y", draw), std::nullopt);
  EXPECT_TRUE(screen.at("Side/x-y").is_selected);
  EXPECT_EQ(screen.at("Side/yaw").kind, ControlKind::kTab);
}

TEST(Tabs, ThatAreTooManyForOneRowFitIntoSeveral) {
  HeadlessUi screen(ThemeName::kLight, 1.0, {160.0, 300.0});
  const std::vector<std::string> titles = {"Measurements", "Comparisons", "Reconstruction"};
  screen.frame([&titles](Ui& ui) { (void)ui.tabs("Side", titles, 0); });
  EXPECT_LE(screen.at("Side/Reconstruction").rect.right(), 160.0 - 12.0 + 0.5);
  EXPECT_GT(screen.at("Side/Reconstruction").rect.top, screen.at("Side/Measurements").rect.top);
  EXPECT_EQ(screen.at("Side/Comparisons").tooltip, "") << "nothing is cut";
}

TEST(Tabs, ThatAreWiderThanTheRoomAreCutAndTellTheirName) {
  HeadlessUi screen(ThemeName::kLight, 1.0, {90.0, 300.0});
  const std::vector<std::string> titles = {"Measurements of all runs", "Log"};
  screen.frame([&titles](Ui& ui) { (void)ui.tabs("Side", titles, 0); });
  EXPECT_LE(screen.at("Side/Measurements of all runs").rect.right(), 90.0 - 12.0 + 0.5);
  EXPECT_EQ(screen.at("Side/Measurements of all runs").tooltip, "Measurements of all runs");
}

TEST(Colours, AreTypedAsHexadecimalDigits) {
  HeadlessUi screen;
  Rgba colour{1, 2, 3};
  int commits = 0;
  const auto draw = [&](Ui& ui) {
    const auto edit = ui.colour("Estimate", colour);
    if (edit.was_committed) ++commits;
    if (edit.is_changed || edit.was_committed) colour = edit.value;
  };
  screen.frame(draw);
  EXPECT_EQ(screen.at("Estimate").value, "#010203");
  screen.type("Estimate/Hex", "#0B6FB8", draw);
  screen.wait(2, draw);
  EXPECT_EQ(colour, (Rgba{0x0B, 0x6F, 0xB8}));
  EXPECT_EQ(commits, 1);
  screen.type("Estimate/Hex", "blue", draw);
  EXPECT_EQ(colour, (Rgba{0x0B, 0x6F, 0xB8})) << "no colour";
}

TEST(Colours, OfOneDragOfASliderAreOneCommit) {
  HeadlessUi screen;
  Rgba colour{100, 100, 100};
  int commits = 0;
  int changes = 0;
  const auto draw = [&](Ui& ui) {
    const auto edit = ui.colour("Estimate", colour);
    if (edit.was_committed) ++commits;
    if (edit.is_changed) ++changes;
    if (edit.is_changed || edit.was_committed) colour = edit.value;
  };
  screen.drag("Estimate/Red", 40.0, 0.0, draw);
  EXPECT_EQ(commits, 1);
  EXPECT_GE(changes, 2);
  EXPECT_GT(colour.red, 128);
  EXPECT_EQ(colour.green, 100);
}

}  // namespace choices_test
}  // namespace nadir::kit
