// SPDX-License-Identifier: Apache-2.0
// What the settings, and all who speak of them, take from a session.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/core/session/session_fixture.h"
#include "widgets/panels/menu_bar.h"
#include "widgets/panels/settings_panel.h"

namespace nadir {
namespace settings_model_test {

using ::testing::EndsWith;

class SettingsModelTest : public SessionTest {
 protected:
  /// The count that the settings say, the changes that they mark and what stands in the menu's line are one.
  void expect_changed(std::size_t count) const {
    const SettingsModel model = settings_model(*session_);
    EXPECT_EQ(changed_options(*session_), count);
    EXPECT_EQ(model.changed_count, count);
    const auto marked = std::count_if(model.rows.begin(), model.rows.end(),
                                      [](const SettingRow& row) { return row.differs(); });
    EXPECT_EQ(static_cast<std::size_t>(marked), count);
    const auto names = menu_bar_model(*session_).open_names;
    ASSERT_EQ(names.size(), 3U);
    EXPECT_THAT(names[2],
                EndsWith(count == 0 ? "as the active run"
                                    : fmt::format("as the active run, {} changed", count)));
  }
};

TEST_F(SettingsModelTest, SaysOneNumberOfChangesEverywhere) {
  open_run();
  expect_changed(0);
  act("option particles 100");
  act("option max-cells 40");
  expect_changed(2);
  act("option max-cells");
  expect_changed(1);
}

TEST_F(SettingsModelTest, WhatTheRunHasByNowIsNoChange) {
  open_run();
  act("option particles 100");
  act("rerun start");
  settle();
  ASSERT_EQ(session_->view().active_run, 2);
  ASSERT_EQ(session_->active_run()->document->header.options.at("particles"), "100");
  expect_changed(0);
  act("run 1");
  expect_changed(1);  // a rerun of the first one would have it again
}

TEST_F(SettingsModelTest, KnowsHowARunFromItsStartBegins) {
  open_run();
  for (const bool is_on_its_way : {false, true}) {
    if (is_on_its_way) act("rerun start");
    const SettingsModel model = settings_model(*session_);
    const auto row = std::find_if(model.rows.begin(), model.rows.end(), [](const SettingRow& one) {
      return one.name == "global-particles";
    });
    EXPECT_EQ(row->no_effect, "the start is known") << is_on_its_way;
  }
  settle();
}

}  // namespace settings_model_test
}  // namespace nadir
