// SPDX-License-Identifier: Apache-2.0
// What has no effect, what is changed, and where the list ends.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/widgets/panels/shown_settings.h"

namespace nadir {
namespace settings_effects_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using SettingsEffects = ShownSettings;

TEST_F(SettingsEffects, WhatHasNoEffectIsPaleAndSaysWhy) {
  screen.wait(2, drawing());
  const std::string why = "no effect while motion = scaled";
  for (const char* const name : {"rotation-noise", "translation-noise"}) {
    EXPECT_FALSE(screen.at(path(name)).is_enabled) << name;
    EXPECT_THAT(screen.at(path(name)).tooltip, HasSubstr(why)) << name;
    EXPECT_THAT(screen.at(path(name)).tooltip, HasSubstr(row(name).help)) << name;
  }
  EXPECT_TRUE(screen.at(path("along-noise")).is_enabled);
  EXPECT_EQ(std::count_if(screen.controls().begin(), screen.controls().end(),
                          [&](const kit::Control& one) { return one.value == why; }),
            1)
      << "once for both";
  const kit::Rect words = screen.at("Settings/Motion/" + why).rect;
  EXPECT_GE(words.top, screen.at(path("translation-noise")).rect.bottom());
  EXPECT_LE(words.bottom(), screen.at(path("position-noise")).rect.top);
  draft.localiser.motion = MotionKind::kThesis;
  refresh();
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.at(path("translation-noise")).is_enabled);
  EXPECT_FALSE(screen.at(path("along-noise")).is_enabled);
  EXPECT_TRUE(screen.shows("no effect while motion = thesis"));
}

TEST_F(SettingsEffects, AChangeWithoutEffectCanBeTakenBack) {
  draft.localiser.translation_noise_m = 0.9;
  refresh();
  EXPECT_THAT(screen.click("Settings/Motion/Reset translation-noise", drawing()),
              ElementsAre(Action(actions::SetOption{"translation-noise", {}})));
}

TEST_F(SettingsEffects, SaysHowManyOptionsAreChanged) {
  const auto words = [this] {
    return fmt::format("{} of {} changed", model.changed_count, model.rows.size());
  };
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows(words())) << screen.words();
  model.changed_count = 3;
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows(words())) << screen.words();
}

TEST_F(SettingsEffects, TheListNeverEndsWithinAHeading) {
  for (double height = 300.0; height < 1300.0; height += 7.0) {
    kit::HeadlessUi low(ThemeName::kDark, 1.0, {380.0, height});
    low.wait(3, drawing());
    for (const kit::Control& control : low.controls()) {
      if (control.kind != kit::ControlKind::kSection || !control.is_visible) continue;
      EXPECT_LE(control.rect.bottom(), height - 11.0) << control.label << ", " << height;
    }
  }
}

TEST_F(SettingsEffects, AListThatIsScrolledFillsItsRoom) {
  kit::HeadlessUi low(ThemeName::kDark, 1.0, {380.0, 480.0});
  low.wait(3, drawing());
  while (!state.headings.empty() && !state.is_scrolled) low.scroll(path("seed"), -1.0, drawing());
  low.wait(2, drawing());
  double lowest = 0.0;
  for (const kit::Control& control : low.controls()) {
    if (control.is_visible) lowest = std::max(lowest, control.rect.bottom());
  }
  EXPECT_GE(lowest, 480.0 - 44.0) << "a row, or the space below one, ends the panel";
}

TEST_F(SettingsEffects, SaysWhatARerunFromTheCursorDoesNotRead) {
  const std::string words = "only From the start reads it";
  for (const SettingRow& one : setting_rows(draft, {}, "")) {
    EXPECT_FALSE(one.is_of_start) << one.name << ": nobody knows how it starts";
  }
  model.rows = setting_rows(draft, {}, "global");
  for (const SettingRow& one : model.rows) {
    EXPECT_EQ(one.is_of_start, one.name == "global-particles") << one.name;
  }
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.at(path("global-particles")).is_enabled);
  EXPECT_TRUE(screen.shows(words)) << screen.words();
  model.rows = setting_rows(draft, {}, "truth of the first frame");
  screen.wait(2, drawing());
  EXPECT_FALSE(screen.shows(words)) << "the other button does not read it either";
}

TEST(SettingRows, GlobalParticlesCountWhereTheRunBeginsAnywhere) {
  const auto why = [](const std::string& prior) {
    for (const SettingRow& row : setting_rows({}, {}, prior)) {
      if (row.name == "global-particles") return row.no_effect;
    }
    return std::string("none");
  };
  EXPECT_EQ(why(""), "") << "nobody knows";
  EXPECT_EQ(why("global"), "");
  EXPECT_EQ(why("truth of the first frame"), "the start is known");
}

}  // namespace settings_effects_test
}  // namespace nadir
