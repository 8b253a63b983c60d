// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "widgets/panels/run_metric_rows.h"

namespace nadir {
namespace {

void renew_texts(const kit::Ui& ui, const RunsModel& model, RunsState& state) {
  std::set<std::string> live;
  for (const RunsModel::Row& row : model.rows) {
    if (row.is_live) live.insert(row.name);
  }
  std::vector<std::string> names;
  for (const int number : state.numbers) names.push_back(name_of_run(model, number));
  renew_table_texts(state.texts, ui, state.revision, state.comparison, state.compared,
                    std::move(names), std::move(live));
}

void draw_metric(kit::Ui& ui,
                 const ShownMetric& metric,
                 const MetricTexts& texts,
                 const RunColumns& part) {
  if (!texts.is_there) return;
  ui.row(std::string(metric.name));
  ui.cell(std::string(metric.statistic), kit::TextLook::kMuted);
  ui.hint({metric_label(metric), "", "", fmt::format("{}; {}", metric.help, better_words(metric))});
  for (std::size_t i = part.first; i < part.end; ++i) {
    if (texts.digits[i].empty()) {
      ui.number_cell("–", kit::TextLook::kMutedNumber);
      ui.hint({"Not known for this run", ""});
      continue;
    }
    const bool is_best = texts.is_best[i];
    ui.number_cell(texts.digits[i], is_best ? kit::TextLook::kGood : kit::TextLook::kNumber);
    if (!is_best) continue;
    ui.hint({(texts.is_shared ? "Shares the best of these runs: " : "The best of these runs: ") +
                 better_words(metric),
             ""});
  }
}

/// Groups of metrics, each a table: their columns stay below each other.
void draw_metrics_of(kit::Ui& ui, const RunTableTexts& texts, const RunColumns& part) {
  const std::string name = part.first == 0 ? "metrics" : fmt::format("metrics from {}", part.first);
  const auto all = shown_metrics();
  std::vector<kit::Column> columns = part.columns;
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    while (end < all.size() && all[end].group == all[begin].group) ++end;
    int decimals = 0;  // of this group, whose numbers end below the runs' names
    for (std::size_t i = begin; i < end; ++i) decimals = std::max(decimals, all[i].decimals);
    for (std::size_t i = 1; i < columns.size(); ++i) columns[i].decimals = decimals;
    ui.text(std::string(all[begin].group), kit::TextLook::kNormal);
    const kit::TableOptions options{
        .has_header = begin == 0, .is_dense = true, .is_only_read = true};
    if (const auto table = ui.table(name, columns, options)) {
      for (; begin < end; ++begin) draw_metric(ui, all[begin], texts.metrics[begin], part);
    }
    begin = end;
  }
}

/// What an option is for, and what keeps it from having any effect.
void explain_setting(kit::Ui& ui, const SettingDifference& setting) {
  std::string words = setting.help;
  if (!setting.has_effect()) {
    words +=
        (words.empty() ? "" : "; ") + std::string("no effect while ") + setting.no_effect.front();
  }
  if (!words.empty()) ui.hint({words, ""});
}

/// A line a run, each as long as it needs to be.
void draw_wordy_setting(kit::Ui& ui, const RunTableTexts& texts, const SettingDifference& setting) {
  const auto scope = ui.scope(setting.name);
  ui.text(label_of_setting(setting), kit::TextLook::kMuted);
  explain_setting(ui, setting);
  for (std::size_t i = 0; i < setting.values.size() && i < texts.titles.size(); ++i) {
    ui.wrapped(fmt::format("{}: {}", texts.titles[i], setting.values[i].value_or("–")));
  }
}

void draw_setting(kit::Ui& ui, const SettingDifference& setting, const RunColumns& part) {
  ui.row(setting.name);
  ui.cell(label_of_setting(setting), kit::TextLook::kMuted);
  explain_setting(ui, setting);
  for (std::size_t i = part.first; i < part.end; ++i) {
    const bool is_idle = i < setting.no_effect.size() && !setting.no_effect[i].empty();
    ui.number_cell(setting.values[i].value_or("–"),
                   is_idle ? kit::TextLook::kMutedNumber : kit::TextLook::kNumber);
    if (is_idle) ui.hint({"No effect in this run while " + setting.no_effect[i], ""});
  }
}

/// Numbers and names in columns, and below them what is said in words.
void draw_setting_tables(kit::Ui& ui,
                         const RunTableTexts& texts,
                         SettingTexts& settings,
                         const std::string& title) {
  if (!settings.in_columns.empty()) {
    for (const RunColumns& part : parts_for(settings.columns, ui, texts, kit::Align::kRight)) {
      const std::string name =
          part.first == 0 ? title : fmt::format("{} from {}", title, part.first);
      const auto table = ui.table(name, part.columns, {.is_dense = true, .is_only_read = true});
      if (!table) break;
      for (const SettingDifference& setting : settings.in_columns) {
        draw_setting(ui, setting, part);
      }
    }
  }
  for (const SettingDifference& setting : settings.in_words) {
    draw_wordy_setting(ui, texts, setting);
  }
}

}  // namespace

std::string name_of_run(const RunsModel& model, int number) {
  const auto row =
      std::find_if(model.rows.begin(), model.rows.end(),
                   [number](const RunsModel::Row& one) { return one.number == number; });
  return row == model.rows.end() ? std::string() : row->name;
}

void draw_metrics(kit::Ui& ui, const RunsModel& model, RunsState& state) {
  const auto section = ui.section("Errors");
  if (!section) return;
  renew_texts(ui, model, state);
  RunTableTexts& texts = state.texts;
  ui.wrapped(texts.span, kit::TextLook::kMuted);
  if (state.comparison.span.begins_last || state.comparison.span.ends_first) {
    ui.hint(
        {"Over different parts of a flight no numbers compare. Close the run that covers least to "
         "compare the others over more",
         ""});
  }
  if (!texts.copied.empty()) ui.wrapped(texts.copied, kit::TextLook::kMuted);
  ui.space();
  for (const RunColumns& part : parts_for(texts.metric_columns, ui, texts, kit::Align::kDecimal)) {
    draw_metrics_of(ui, texts, part);
  }
  if (state.numbers.size() < 2 || !state.comparison.do_compete()) return;
  ui.wrapped(std::string(kBestMark) + " and green: the best run by this number",
             kit::TextLook::kMuted);
}

void draw_settings(kit::Ui& ui, const RunsModel& model, RunsState& state) {
  const auto& settings = state.comparison.settings;
  const auto& idle = state.comparison.idle_settings;
  const auto section = ui.section("Settings that differ", true, fmt::format("{}", settings.size()));
  if (!section) return;
  renew_texts(ui, model, state);
  if (settings.empty()) {
    ui.text(idle.empty() ? "None: the runs were made alike" : "None that has an effect",
            kit::TextLook::kMuted);
  }
  draw_setting_tables(ui, state.texts, state.texts.settings, "settings");
  if (idle.empty()) return;
  ui.wrapped("These differ too, but have no effect in any of these runs", kit::TextLook::kMuted);
  draw_setting_tables(ui, state.texts, state.texts.idle_settings, "without effect");
}

}  // namespace nadir
