// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/mcl/option_effects.h"
#include "tests/support/error_text.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/settings_panel.h"

namespace nadir {

/// The panel of settings with a draft of the default preset.
class ShownSettings : public ::testing::Test {
 protected:
  ShownSettings() { refresh(); }
  void refresh() {
    model.rows = setting_rows(draft, {});
    model.presets = {"default", "thesis"};
    model.preset = "default";
  }
  /// Draws, and carries out what is asked for, as Session does.
  auto drawing() {
    return [this](kit::Ui& ui) {
      Actions asked = draw_settings_panel(ui, model, state);
      for (const Action& action : asked) {
        const auto* set = std::get_if<actions::SetOption>(&action);
        if (set == nullptr) continue;
        const auto done =
            set_option(draft, set->name, set->value.value_or(row(set->name).preset_value));
        EXPECT_TRUE(done) << error_text(done);
        refresh();
      }
      return asked;
    };
  }
  /// Gives the others the values that an option needs to have an effect.
  void let_count(const std::string& name) {
    draft = {};
    for (const EffectRule& rule : effect_rules()) {
      const EffectCondition& needed = rule.needs[0];
      if (rule.option != name || needed.option == "prior") continue;
      const auto done =
          set_option(draft, needed.option, needed.value == kAboveZero ? "1" : needed.value);
      EXPECT_TRUE(done) << error_text(done);
    }
    refresh();
  }
  const SettingRow& row(const std::string& name) const {
    return *std::find_if(model.rows.begin(), model.rows.end(),
                         [&](const SettingRow& one) { return one.name == name; });
  }
  std::string path(const std::string& name) const {
    return "Settings/" + row(name).group + "/" + name;
  }

  RunOptions draft;
  SettingsModel model;
  SettingsState state;
  kit::HeadlessUi screen{ThemeName::kDark, 1.0, {400.0, 2600.0}};
};

}  // namespace nadir
