// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "widgets/panels/panel_text.h"
#include "widgets/panels/run_labels.h"
#include "widgets/panels/run_metric_rows.h"

namespace nadir {
namespace {

constexpr double kBetweenColumns = 4.0, kMostTitle = 96.0,
                 kMostSettingName = 132.0;  // of the design
/// Before the best of a row, which is also green: not everybody sees that.
constexpr const char* kBestMark = "•";

std::vector<std::string> names_of(const RunsModel& model, const RunsState& state) {
  std::vector<std::string> names;
  for (const int number : state.numbers) names.push_back(name_of_run(model, number));
  return names;
}

/// Names of the compared runs, without what they have in common.
std::vector<std::string> titles_of(const RunsModel& model, const RunsState& state) {
  return told_apart(names_of(model, state));
}

/// Some of the runs, as many as have room beside each other, and how wide their columns are.
struct RunColumns {
  std::size_t first = 0, end = 0;  ///< Places in RunsState::numbers.
  double width = 0.0;
};

/// All runs in one part where they fit; no value is cut. @param widest  Of the values. @param names  Width of the first column.
std::vector<RunColumns> parts_of(const kit::Ui& ui,
                                 const RunsModel& model,
                                 const RunsState& state,
                                 double widest,
                                 double names) {
  const std::size_t count = state.numbers.size();
  const double between = ui.px(2.0 * kBetweenColumns);
  const double room = ui.room().width - names - between;
  const auto fitting = [&](double width) {
    return static_cast<std::size_t>(std::max(1.0, std::floor(room / (width + between))));
  };
  double wanted = widest;  // with its title, where that does not cost the place of another run
  for (const std::string& title : titles_of(model, state))
    wanted = std::max(wanted, std::min(std::ceil(ui.text_width(title)) + 1.0, ui.px(kMostTitle)));
  const double width = fitting(wanted) >= count ? wanted : widest;
  const std::size_t most = std::min(count, fitting(width));
  std::vector<RunColumns> parts;
  for (std::size_t first = 0; first < count; first += most)
    parts.push_back({first, std::min(count, first + most), std::min(width, room - between)});
  return parts;
}

/// Columns for a part of the runs, right of a first one. @param decimals  Of its numbers, at most.
std::vector<kit::Column> columns_of(const kit::Ui& ui,
                                    const RunsModel& model,
                                    const RunsState& state,
                                    const RunColumns& part,
                                    kit::Align align,
                                    int decimals = 0) {
  std::vector<kit::Column> columns(1);
  const std::vector<std::string> titles = titles_of(model, state);
  for (std::size_t i = part.first; i < part.end; ++i) {
    kit::Column column;
    const std::string name = name_of_run(model, state.numbers[i]);
    const std::string fitted = fitted_name(
        titles[i], part.width, [&ui](const std::string& line) { return ui.text_width(line); });
    column.title = fitted == name ? name : label_of(fitted, name);
    column.align = align;
    column.width = part.width;
    column.decimals = decimals;
    column.hint = {name, ""};
    columns.push_back(std::move(column));
  }
  return columns;
}

/// As the table shows it, with its mark.
std::string marked_digits(const ShownMetric& metric, double value, bool is_best) {
  return (is_best ? kBestMark : "") + metric_digits(metric, value);
}

const MetricRow* row_of_metric(const RunsState& state, const ShownMetric& metric) {
  const auto& rows = state.comparison.metrics;
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const MetricRow& one) { return one.key == metric.key; });
  return row == rows.end() ? nullptr : &*row;
}

void draw_metric(kit::Ui& ui,
                 const ShownMetric& metric,
                 const RunsState& state,
                 const RunColumns& part) {
  const MetricRow* const row = row_of_metric(state, metric);
  if (row == nullptr) return;
  const auto best = best_runs(metric, *row, state.comparison.do_compete());
  ui.row(std::string(metric.name));
  ui.cell(std::string(metric.statistic), kit::TextLook::kMuted);
  const std::string help = fmt::format("{}; {}", metric.help, better_words(metric));
  ui.hint({metric_label(metric), "", "", help});
  for (std::size_t i = part.first; i < part.end; ++i) {
    const auto& value = row->values[i];
    if (!value) {
      ui.number_cell("–", kit::TextLook::kMutedNumber);
      ui.hint({"Not known for this run", ""});
      continue;
    }
    const bool is_best = std::count(best.begin(), best.end(), i) > 0;
    ui.number_cell(marked_digits(metric, *value, is_best),
                   is_best ? kit::TextLook::kGood : kit::TextLook::kNumber);
    if (!is_best) continue;
    ui.hint({(best.size() > 1 ? "Shares the best of these runs: " : "The best of these runs: ") +
                 better_words(metric),
             ""});
  }
}

/// Groups of metrics, each a table: their columns stay below each other.
void draw_metrics_of(kit::Ui& ui,
                     const RunsModel& model,
                     const RunsState& state,
                     const RunColumns& part) {
  const std::string name = part.first == 0 ? "metrics" : fmt::format("metrics from {}", part.first);
  const auto all = shown_metrics();
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    while (end < all.size() && all[end].group == all[begin].group) ++end;
    int decimals = 0;  // of this group, whose numbers end below the runs' names
    for (std::size_t i = begin; i < end; ++i) decimals = std::max(decimals, all[i].decimals);
    const auto columns = columns_of(ui, model, state, part, kit::Align::kDecimal, decimals);
    ui.text(std::string(all[begin].group), kit::TextLook::kNormal);
    const kit::TableOptions options{
        .has_header = begin == 0, .is_dense = true, .is_only_read = true};
    if (const auto table = ui.table(name, columns, options)) {
      for (; begin < end; ++begin) draw_metric(ui, all[begin], state, part);
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

std::string label_of_setting(const SettingDifference& setting) {
  return setting.unit.empty() ? setting.name : fmt::format("{} [{}]", setting.name, setting.unit);
}

/// Whether a value is words, which no column has room for.
bool has_words_for_values(const SettingDifference& setting) {
  const auto are_words = [](const auto& value) {
    return value && value->find(' ') < value->size();
  };
  return std::any_of(setting.values.begin(), setting.values.end(), are_words);
}

/// A line a run, each as long as it needs to be.
void draw_wordy_setting(kit::Ui& ui,
                        const RunsModel& model,
                        const RunsState& state,
                        const SettingDifference& setting) {
  const auto scope = ui.scope(setting.name);
  ui.text(label_of_setting(setting), kit::TextLook::kMuted);
  explain_setting(ui, setting);
  const std::vector<std::string> titles = titles_of(model, state);
  for (std::size_t i = 0; i < setting.values.size() && i < titles.size(); ++i) {
    ui.wrapped(fmt::format("{}: {}", titles[i], setting.values[i].value_or("–")));
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

void draw_setting_columns(kit::Ui& ui,
                          const RunsModel& model,
                          const RunsState& state,
                          const std::vector<SettingDifference>& settings,
                          const std::string& title) {
  if (settings.empty()) return;
  double widest = 0.0, names = 0.0;
  for (const SettingDifference& setting : settings) {
    names = std::max(names, ui.text_width(label_of_setting(setting)));
    for (const auto& value : setting.values) {
      widest = std::max(widest, ui.text_width(value.value_or("–"), kit::TextLook::kNumber));
    }
  }
  names = std::min(std::ceil(names) + 1.0, ui.px(kMostSettingName));
  for (const RunColumns& part : parts_of(ui, model, state, std::ceil(widest) + 1.0, names)) {
    const auto columns = columns_of(ui, model, state, part, kit::Align::kRight);
    const std::string name = part.first == 0 ? title : fmt::format("{} from {}", title, part.first);
    const auto table = ui.table(name, columns, {.is_dense = true, .is_only_read = true});
    if (!table) return;
    for (const SettingDifference& setting : settings) draw_setting(ui, setting, part);
  }
}

/// Numbers and names in columns, and below them what is said in words.
void draw_setting_tables(kit::Ui& ui,
                         const RunsModel& model,
                         const RunsState& state,
                         std::vector<SettingDifference> settings,
                         const std::string& title) {
  const auto wordy = std::stable_partition(
      settings.begin(), settings.end(),
      [](const SettingDifference& one) { return !has_words_for_values(one); });
  const std::vector<SettingDifference> in_words(wordy, settings.end());
  settings.erase(wordy, settings.end());
  draw_setting_columns(ui, model, state, settings, title);
  for (const SettingDifference& setting : in_words) draw_wordy_setting(ui, model, state, setting);
}

}  // namespace

std::string name_of_run(const RunsModel& model, int number) {
  const auto row =
      std::find_if(model.rows.begin(), model.rows.end(),
                   [number](const RunsModel::Row& one) { return one.number == number; });
  return row == model.rows.end() ? std::string() : row->name;
}

void draw_metrics(kit::Ui& ui, const RunsModel& model, const RunsState& state) {
  const auto section = ui.section("Errors");
  if (!section) return;
  std::set<std::string> live;
  for (const RunsModel::Row& row : model.rows) {
    if (row.is_live) live.insert(row.name);
  }
  ui.wrapped(span_words(state.comparison, names_of(model, state), live), kit::TextLook::kMuted);
  if (state.comparison.span.begins_last || state.comparison.span.ends_first) {
    ui.hint(
        {"Over different parts of a flight no numbers compare. Close the run that covers least to "
         "compare the others over more",
         ""});
  }
  if (const std::string copied = copied_words(state.compared, names_of(model, state));
      !copied.empty()) {
    ui.wrapped(copied, kit::TextLook::kMuted);
  }
  ui.space();
  double widest = 0.0, names = 0.0;
  for (const ShownMetric& metric : shown_metrics()) {
    names = std::max(names, ui.text_width(std::string(metric.statistic)));
    const MetricRow* const row = row_of_metric(state, metric);
    if (row == nullptr) continue;
    const auto best = best_runs(metric, *row, state.comparison.do_compete());
    for (std::size_t i = 0; i < row->values.size(); ++i) {
      if (!row->values[i]) continue;
      const bool is_best = std::count(best.begin(), best.end(), i) > 0;
      const std::string digits = marked_digits(metric, *row->values[i], is_best);
      widest = std::max(widest, ui.text_width(digits, kit::TextLook::kNumber));
    }
  }
  for (const RunColumns& part : parts_of(ui, model, state, std::ceil(widest) + 1.0, names))
    draw_metrics_of(ui, model, state, part);
  if (state.numbers.size() < 2 || !state.comparison.do_compete()) return;
  ui.wrapped(std::string(kBestMark) + " and green: the best run by this number",
             kit::TextLook::kMuted);
}

void draw_settings(kit::Ui& ui, const RunsModel& model, const RunsState& state) {
  const auto& settings = state.comparison.settings;
  const auto& idle = state.comparison.idle_settings;
  const auto section = ui.section("Settings that differ", true, fmt::format("{}", settings.size()));
  if (!section) return;
  if (settings.empty()) {
    ui.text(idle.empty() ? "None: the runs were made alike" : "None that has an effect",
            kit::TextLook::kMuted);
  }
  draw_setting_tables(ui, model, state, settings, "settings");
  if (idle.empty()) return;
  ui.wrapped("These differ too, but have no effect in any of these runs", kit::TextLook::kMuted);
  draw_setting_tables(ui, model, state, idle, "without effect");
}

}  // namespace nadir
