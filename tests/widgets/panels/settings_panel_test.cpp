// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/settings_panel.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/widgets/panels/shown_settings.h"

namespace nadir {
namespace settings_panel_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using SettingsPanelTest = ShownSettings;

TEST_F(SettingsPanelTest, HasAControlForEveryOptionOfTheList) {
  const auto texts = option_texts(RunOptions{});
  ASSERT_THAT(model.rows, SizeIs(texts.size()));
  screen.wait(2, drawing());
  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_EQ(model.rows[i].name, texts[i].name);
    EXPECT_EQ(model.rows[i].value, texts[i].value);
    EXPECT_FALSE(model.rows[i].group.empty());
    const kit::Control& control = screen.at(path(texts[i].name));
    EXPECT_THAT(control.tooltip, HasSubstr(texts[i].help));
    EXPECT_THAT(control.tooltip, HasSubstr("preset " + texts[i].value));
  }
}

/// A text that the option takes and that is not its value.
std::string another_value(const SettingRow& row) {
  switch (row.kind) {
    case SettingRow::Kind::kSwitch:
      return row.value == "true" ? "false" : "true";
    case SettingRow::Kind::kChoice:
      return row.choices.at(row.value == row.choices[0] ? 1 : 0);
    case SettingRow::Kind::kBigWhole:
      return "18446744073709551615";
    case SettingRow::Kind::kWhole:
      return setting_text(std::min(row.most, std::max(row.least, std::stod(row.value) + 1.0)), 0);
    default: {
      const double now = std::stod(row.value);
      const double step = setting_step(row);
      return setting_text(now + step <= row.most ? now + step : now - step, setting_decimals(row));
    }
  }
}

TEST_F(SettingsPanelTest, EveryOptionAsksForItselfOnceAndCanBeTakenBack) {
  screen.wait(2, drawing());
  for (std::size_t i = 0; i < model.rows.size(); ++i) {
    let_count(model.rows[i].name);
    const SettingRow before = model.rows[i];
    const std::string wanted = another_value(before);
    SCOPED_TRACE(before.name + " to " + wanted);
    Actions asked;
    switch (before.kind) {
      case SettingRow::Kind::kSwitch:
        asked = screen.click(path(before.name), drawing());
        break;
      case SettingRow::Kind::kChoice:
        screen.click(path(before.name), drawing());
        asked = screen.click(path(before.name) + "/" + wanted, drawing());
        break;
      default:
        asked = screen.type(path(before.name), wanted, drawing());
        break;
    }
    ASSERT_THAT(asked, ElementsAre(Action(actions::SetOption{before.name, wanted})));
    screen.wait(2, drawing());
    EXPECT_TRUE(row(before.name).differs());
    const Actions reset =
        screen.click("Settings/" + before.group + "/Reset " + before.name, drawing());
    ASSERT_THAT(reset, ElementsAre(Action(actions::SetOption{before.name, {}})));
    EXPECT_FALSE(row(before.name).differs());
  }
}

TEST_F(SettingsPanelTest, ADragIsOneChange) {
  const Actions asked = screen.drag(path("temperature"), 60.0, 0.0, drawing());
  ASSERT_THAT(asked, SizeIs(1));
  const auto& set = std::get<actions::SetOption>(asked[0]);
  EXPECT_EQ(set.name, "temperature");
  EXPECT_GT(std::stod(*set.value), 0.01);
}

TEST_F(SettingsPanelTest, WhatIsTypedBackToThePresetIsNoChangeAtAll) {
  screen.type(path("temperature"), "0.5", drawing());
  EXPECT_THAT(screen.type(path("temperature"), "0.01", drawing()),
              ElementsAre(Action(actions::SetOption{"temperature", {}})));
}

TEST_F(SettingsPanelTest, SearchAndOnlyChangedLeaveOutTheRest) {
  state.search = "drift";
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.has(path("yaw-noise")));
  EXPECT_FALSE(screen.has(path("temperature")));
  state.search = "no such option";
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows("No option has"));
  state.search.clear();
  draft.localiser.temperature = 0.5;
  refresh();
  screen.click("Settings/only changed", drawing());
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.has(path("temperature")));
  EXPECT_FALSE(screen.has(path("yaw-noise")));
}

TEST_F(SettingsPanelTest, RunsStartFromHereOrFromTheStart) {
  EXPECT_THAT(screen.click("Settings/Rerun from here", drawing()),
              ElementsAre(Action(actions::Rerun{RerunFrom::kCursor})));
  EXPECT_THAT(screen.click("Settings/From the start", drawing()),
              ElementsAre(Action(actions::Rerun{RerunFrom::kStart})));
  model.why_not_from_cursor = "no particles were recorded here";
  screen.wait(2, drawing());
  EXPECT_FALSE(screen.at("Settings/Rerun from here").is_enabled);
  EXPECT_THAT(screen.at("Settings/Rerun from here").tooltip,
              HasSubstr("no particles were recorded here"));
  EXPECT_TRUE(screen.at("Settings/From the start").is_enabled);
}

TEST_F(SettingsPanelTest, ARunningOneShowsItsProgressAndCanBeCancelled) {
  model.running.push_back({7, "localising loop", 0.43, "", 12.0});
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows("localising loop"));
  EXPECT_THAT(screen.click("Settings/Job 7/Cancel", drawing()),
              ElementsAre(Action(actions::CancelJob{7})));
}

TEST_F(SettingsPanelTest, PresetsAreChosenAndSaved) {
  screen.click("Settings/preset", drawing());
  EXPECT_THAT(screen.click("Settings/preset/thesis", drawing()),
              ElementsAre(Action(actions::UsePreset{"thesis"})));
  EXPECT_THAT(screen.click("Settings/Save as a recipe…", drawing()),
              ElementsAre(Action(actions::ShowOverlay{Overlay::kSaveRecipe})));
}

TEST_F(SettingsPanelTest, EveryNumberOutOfRangeIsRefusedAtItsControlAndKept) {
  screen.wait(2, drawing());
  for (const SettingRow& before : std::vector<SettingRow>(model.rows)) {
    const bool is_number =
        before.kind == SettingRow::Kind::kNumber || before.kind == SettingRow::Kind::kWhole;
    if (!is_number || !std::isfinite(before.least) || before.least < -1e6) continue;
    const std::string wrong = setting_text(before.least - 1.0, 1);
    SCOPED_TRACE(before.name + " to " + wrong);
    let_count(before.name);
    EXPECT_THAT(screen.type(path(before.name), wrong, drawing()), IsEmpty());
    screen.wait(2, drawing());
    EXPECT_EQ(screen.at(path(before.name)).value, wrong) << "it stays until it is corrected";
    EXPECT_TRUE(screen.shows(before.range)) << screen.words();
    EXPECT_TRUE(screen.shows("The run keeps " + before.value));
    screen.click("Settings/" + before.group + "/Reset " + before.name, drawing());
    screen.wait(2, drawing());
    EXPECT_FALSE(screen.shows("The run keeps"));
    EXPECT_NE(screen.at(path(before.name)).value, wrong);
  }
}

TEST_F(SettingsPanelTest, WhatIsNoNumberIsRefusedAndCorrectedInPlace) {
  screen.type(path("temperature"), "warm", drawing());
  screen.wait(2, drawing());
  EXPECT_EQ(screen.at(path("temperature")).value, "warm");
  EXPECT_TRUE(screen.shows("'warm' is not a number")) << screen.words();
  EXPECT_THAT(screen.type(path("temperature"), "0.5", drawing()),
              ElementsAre(Action(actions::SetOption{"temperature", "0.5"})));
  screen.wait(2, drawing());
  EXPECT_FALSE(screen.shows("is not a number"));
}

TEST_F(SettingsPanelTest, EscapeTakesARefusedNumberBack) {
  screen.type(path("temperature"), "-1", drawing());
  EXPECT_EQ(state.refused.size(), 1U);
  screen.type(path("temperature"), "-2", drawing(), false);
  screen.press("Escape", drawing());
  screen.wait(2, drawing());
  EXPECT_TRUE(state.refused.empty());
}

TEST_F(SettingsPanelTest, HalfAParticleIsRefused) {
  EXPECT_THAT(screen.type(path("particles"), "500.5", drawing()), IsEmpty());
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows("'500.5' is not a whole number")) << screen.words();
}

TEST_F(SettingsPanelTest, AFaultIsSaid) {
  model.fault = "--particles: 0 is not in [1, 1000000]";
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows(model.fault));
}

TEST(SettingRows, DecimalsShowTheWholeValueAndLeaveOneToChange) {
  SettingRow row;
  row.value = row.preset_value = "0.01";
  EXPECT_EQ(setting_decimals(row), 3);
  EXPECT_DOUBLE_EQ(setting_step(row), 0.001);
  row.value = "0.0125";
  EXPECT_EQ(setting_decimals(row), 4);
  row.value = row.preset_value = "1e-06";
  EXPECT_EQ(setting_decimals(row), 7);
  row.value = row.preset_value = "20";
  EXPECT_EQ(setting_decimals(row), 1);
  EXPECT_DOUBLE_EQ(setting_step(row), 1.0);
  row.kind = SettingRow::Kind::kWhole;
  row.preset_value = "10000";
  EXPECT_EQ(setting_decimals(row), 0);
  EXPECT_DOUBLE_EQ(setting_step(row), 1000.0);
}

TEST(SettingRows, TextsOfNumbersHaveNoNeedlessZeros) {
  EXPECT_EQ(setting_text(0.5, 4), "0.5");
  EXPECT_EQ(setting_text(12000.0, 0), "12000");
  EXPECT_EQ(setting_text(3.0, 2), "3");
  EXPECT_EQ(setting_text(-0.0, 2), "0");
}

TEST(SettingRows, EachGroupIsOneStretchOfTheList) {
  std::set<std::string> seen;
  std::string group;
  for (const SettingRow& row : setting_rows({}, {})) {
    if (row.group == group) continue;
    group = row.group;
    EXPECT_TRUE(seen.insert(group).second) << group;
  }
  EXPECT_EQ(seen.size(), 5U);
}

}  // namespace settings_panel_test
}  // namespace nadir
