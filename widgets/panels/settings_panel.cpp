// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/settings_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/panel_text.h"
#include "widgets/panels/shortcut_hint.h"

namespace nadir {
namespace {

constexpr double kGroupHeading = 52.0;  ///< Height of a group's, with half of what follows it.
constexpr double kLabelWidth = 152.0;   ///< The longest name of an option, nearly.

double value_in(const std::string& text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

kit::Hint hint_of(const SettingRow& row) {
  std::string text = row.help;
  if (!row.range.empty()) text += fmt::format("; {}", row.range);
  text += fmt::format("; {} {}", row.base, row.preset_value);
  return {text, "", row.unit};
}

std::string no_effect_words(const SettingRow& row) {
  return row.no_effect.empty() ? std::string() : "no effect while " + row.no_effect;
}

/// What stands below a row: why it has no effect, or not with both buttons. Empty: nothing.
std::string words_below(const SettingRow& row) {
  if (row.is_of_start) {
    return "only From the start reads it: Rerun from here goes on with the recorded particles";
  }
  return no_effect_words(row);
}

/// The one thing that changing a control asks for; a value that is the preset's again is no change at all.
void set_to(const SettingRow& row, const std::string& value, Actions& asked) {
  if (value == row.value) return;
  if (value == row.preset_value) {
    asked.emplace_back(actions::SetOption{row.name, {}});
  } else {
    asked.emplace_back(actions::SetOption{row.name, value});
  }
}

/// What was typed last and not taken; empty: nothing.
std::string refused_in(const SettingRow& row, const SettingsState& state) {
  const auto found = state.refused.find(row.name);
  return found == state.refused.end() ? std::string() : found->second;
}

void draw_number(kit::Ui& ui, const SettingRow& row, SettingsState& state, Actions& asked) {
  const int decimals = setting_decimals(row);
  kit::NumberOptions options;
  options.least = row.least;
  options.most = row.most;
  options.decimals = decimals;
  options.unit = row.unit;
  options.step = setting_step(row);
  options.per_pixel = std::max(options.step / 10.0, std::pow(10.0, -decimals));
  options.reset = value_in(row.preset_value);
  options.hint = hint_of(row);
  options.refuses = true;
  options.refused = refused_in(row, state);
  const auto edit = ui.number_input(row.name, value_in(row.value), options);
  if (!edit.refused.empty()) {
    state.refused[row.name] = edit.refused;
    return;
  }
  const bool is_broken = row.kind == SettingRow::Kind::kWhole && edit.was_committed &&
                         edit.value != std::round(edit.value);
  if (is_broken) {
    state.refused[row.name] = fmt::format("{:g}", edit.value);
    return;
  }
  if (edit.was_ended || edit.was_committed) state.refused.erase(row.name);
  if (!edit.was_committed) return;
  if (edit.was_reset) {
    if (row.differs()) asked.emplace_back(actions::SetOption{row.name, {}});
    return;
  }
  // A preset's value that has more digits than are shown is itself, not what it is rounded to.
  const std::string text = setting_text(edit.value, decimals);
  set_to(row, text == setting_text(value_in(row.preset_value), decimals) ? row.preset_value : text,
         asked);
}

void draw_text(kit::Ui& ui, const SettingRow& row, SettingsState& state, Actions& asked) {
  kit::TextOptions options;
  options.hint = hint_of(row);
  const std::string refused = refused_in(row, state);
  const auto edit = ui.text_input(row.name, refused.empty() ? row.value : refused, options);
  if (!edit.was_committed || edit.was_cancelled) return;
  if (why_refused(row, edit.value).empty()) {
    state.refused.erase(row.name);
    set_to(row, edit.value, asked);
  } else {
    state.refused[row.name] = edit.value;
  }
}

void draw_control(kit::Ui& ui, const SettingRow& row, SettingsState& state, Actions& asked) {
  switch (row.kind) {
    case SettingRow::Kind::kNumber:
    case SettingRow::Kind::kWhole:
      return draw_number(ui, row, state, asked);
    case SettingRow::Kind::kSwitch: {
      const auto is_on = ui.checkbox(row.name, row.value == "true", hint_of(row));
      if (is_on) set_to(row, *is_on ? "true" : "false", asked);
      return;
    }
    case SettingRow::Kind::kChoice: {
      const auto now = std::find(row.choices.begin(), row.choices.end(), row.value);
      const auto chosen = ui.combo(
          row.name, row.choices, static_cast<std::size_t>(now - row.choices.begin()), hint_of(row));
      if (chosen) set_to(row, row.choices.at(*chosen), asked);
      return;
    }
    case SettingRow::Kind::kBigWhole:
    case SettingRow::Kind::kText:
      return draw_text(ui, row, state, asked);
  }
}

/// The control, where it differs from the preset a button that takes that back, and why what was typed is not taken.
void draw_row(kit::Ui& ui, const SettingRow& row, SettingsState& state, Actions& asked) {
  const double button = ui.px(28.0);
  ui.next_width(row.kind == SettingRow::Kind::kSwitch
                    ? 0.0
                    : std::max(ui.px(64.0), ui.room().width - button - ui.px(8.0)));
  {
    const auto pale = ui.disabled(!row.no_effect.empty(), no_effect_words(row));
    draw_control(ui, row, state, asked);
  }
  const std::string refused = refused_in(row, state);
  if (row.differs() || !refused.empty()) {
    ui.same_line();
    ui.right_align(button);
    if (ui.icon_button(fmt::format("Reset {}", row.name), kit::Icon::kUndo,
                       {fmt::format("Back to the {}'s {}", row.base, row.preset_value), ""})) {
      state.refused.erase(row.name);
      if (row.differs()) asked.emplace_back(actions::SetOption{row.name, {}});
    }
  }
  if (!refused.empty()) ui.wrapped(why_refused(row, refused), kit::TextLook::kBad);
}

/// Those of the rows that show, and under those without effect, once for all that follow each other, what keeps them from it.
void draw_setting_rows(kit::Ui& ui,
                       const std::vector<const SettingRow*>& rows,
                       SettingsState& state,
                       Actions& asked) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    draw_row(ui, *rows[i], state, asked);
    const std::string words = words_below(*rows[i]);
    const bool goes_on = i + 1 < rows.size() && words_below(*rows[i + 1]) == words;
    if (words.empty() || goes_on) continue;
    ui.wrapped(words, kit::TextLook::kMuted);
    ui.space(ui.px(4.0));
  }
}

/// Of the list: it does not end within a heading, or right below one.
double height_without_half_a_heading(const kit::Ui& ui, double height, const SettingsState& state) {
  if (state.is_scrolled || state.content_height <= height) return height;
  for (const double heading : state.headings) {
    if (heading > 0.0 && heading < height && heading + ui.px(kGroupHeading) > height)
      return heading;
  }
  return height;
}

void draw_presets(kit::Ui& ui, const SettingsModel& model, Actions& asked) {
  const auto now = std::find(model.presets.begin(), model.presets.end(), model.preset);
  std::vector<std::string> titles;
  for (const std::string& preset : model.presets)
    titles.push_back(preset == "run" ? "as the active run" : shortened(preset, 32));
  const auto chosen =
      ui.combo("preset", titles, static_cast<std::size_t>(now - model.presets.begin()),
               {"What all options are taken from; changes are lost", ""});
  if (chosen) asked.emplace_back(actions::UsePreset{model.presets.at(*chosen)});
  if (ui.button(
          "Save as a recipe…", kit::ButtonLook::kQuiet,
          {"A file with these options that nadir localise takes, and that this window opens", ""},
          kit::Icon::kSave)) {
    asked.emplace_back(actions::ShowOverlay{Overlay::kSaveRecipe});
  }
}

void draw_rerun(kit::Ui& ui, const SettingsModel& model, Actions& asked) {
  for (const JobStatus& job : model.running) {
    ui.cut_text(job.title);
    const std::string words = job.left_s ? left_text(*job.left_s) : job.activity;
    if (ui.progress(fmt::format("Job {}", job.number), job.fraction, words)) {
      asked.emplace_back(actions::CancelJob{job.number});
    }
  }
  const auto start = [&](const std::string& label, const std::string& why_not,
                         const std::string& help, RerunFrom from, kit::ButtonLook look) {
    const Action action = actions::Rerun{from};
    const auto off = ui.disabled(!why_not.empty(), why_not);
    if (ui.button(label, look, hint_for(help, action), kit::Icon::kPlay)) asked.push_back(action);
  };
  start("Rerun from here", model.why_not_from_cursor,
        "Localise on from this moment with the recorded particles. They are kept in single "
        "precision: with nothing changed the run comes out alike, not the same",
        RerunFrom::kCursor, kit::ButtonLook::kPrimary);
  ui.same_line();
  start("From the start", model.why_not_from_start, "Localise the whole flight again",
        RerunFrom::kStart, kit::ButtonLook::kNormal);
}

}  // namespace

Actions draw_settings_panel(kit::Ui& ui, const SettingsModel& model, SettingsState& state) {
  const auto scope = ui.scope("Settings");
  Actions asked;
  draw_rerun(ui, model, asked);
  if (!model.fault.empty()) ui.wrapped(model.fault, kit::TextLook::kBad);
  ui.space();
  draw_presets(ui, model, asked);
  ui.line();
  kit::TextOptions search;
  search.placeholder = "Find an option";
  state.search = ui.search_input("Search", state.search, search).value;
  const std::string base = model.rows.empty() ? "preset" : model.rows.front().base;
  const auto only = ui.checkbox("only changed", state.shows_only_changed,
                                {fmt::format("Options whose value is not the {}'s", base), ""});
  if (only) state.shows_only_changed = *only;
  const std::string count = fmt::format("{} of {} changed", model.changed_count, model.rows.size());
  ui.same_line();
  ui.right_align(ui.text_width(count));
  ui.text(count, kit::TextLook::kMuted);
  const auto is_shown = [&](const SettingRow& row) {
    return fits_search(row, state.search) && (!state.shows_only_changed || row.differs());
  };
  if (std::none_of(model.rows.begin(), model.rows.end(), is_shown)) {
    if (!state.search.empty()) {
      ui.wrapped(
          fmt::format("No option has “{}” in its name or help.", shortened(state.search, 40)),
          kit::TextLook::kMuted);
    } else {
      ui.text(fmt::format("All options are the {}'s.", base), kit::TextLook::kMuted);
    }
    return asked;
  }
  const kit::Rect room = ui.room();
  const auto area =
      ui.scroll_area("Options", height_without_half_a_heading(ui, room.height, state));
  const double top = ui.room().top;
  state.is_scrolled = top < room.top - 1.0;
  state.headings.clear();
  const auto labels = ui.label_width(ui.px(kLabelWidth));
  for (auto row = model.rows.begin(); row != model.rows.end();) {
    const auto end = std::find_if(
        row, model.rows.end(), [&](const SettingRow& other) { return other.group != row->group; });
    std::vector<const SettingRow*> shown;
    for (auto one = row; one != end; ++one) {
      if (is_shown(*one)) shown.push_back(&*one);
    }
    if (!shown.empty()) {
      const auto changed =
          std::count_if(row, end, [](const SettingRow& one) { return one.differs(); });
      state.headings.push_back(ui.room().top - top);
      if (const auto group =
              ui.section(row->group, true, changed > 0 ? fmt::format("{} changed", changed) : "")) {
        draw_setting_rows(ui, shown, state, asked);
      }
    }
    row = end;
  }
  state.content_height = ui.room().top - top;
  return asked;
}

}  // namespace nadir
