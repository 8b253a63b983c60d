// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "widgets/panels/panel_text.h"
#include "widgets/panels/run_labels.h"
#include "widgets/panels/run_metric_rows.h"

namespace nadir {
namespace {

constexpr int kMostDecimals = 2;
constexpr double kBetweenColumns = 4.0, kMostTitle = 96.0, kSettingNames = 96.0;  // of the design
/// Before the best of a row, which is also green: not everybody sees that.
constexpr const char* kBestMark = "•";

/// Names of the compared runs, without what they have in common.
std::vector<std::string> titles_of(const RunsModel& model, const RunsState& state) {
  std::vector<std::string> names;
  for (const int number : state.numbers) names.push_back(name_of_run(model, number));
  return told_apart(names);
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
    wanted = std::max(wanted, std::min(ui.text_width(title), ui.px(kMostTitle)));
  const double width = fitting(wanted) >= count ? wanted : widest;
  const std::size_t most = std::min(count, fitting(width));
  std::vector<RunColumns> parts;
  for (std::size_t first = 0; first < count; first += most)
    parts.push_back({first, std::min(count, first + most), std::min(width, room - between)});
  return parts;
}

/// Columns for a part of the runs, right of a first one.
std::vector<kit::Column> columns_of(const kit::Ui& ui,
                                    const RunsModel& model,
                                    const RunsState& state,
                                    const RunColumns& part,
                                    kit::Align align) {
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
    column.decimals = kMostDecimals;
    column.hint = {name, ""};
    columns.push_back(std::move(column));
  }
  return columns;
}

/// As the table shows it, with its mark.
std::string metric_digits(const ShownMetric& metric, double value, bool is_best) {
  return fmt::format("{}{:.{}f}", is_best ? kBestMark : "", value * metric.factor, metric.decimals);
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
  const auto best = best_run(metric, *row, state.comparison.is_same_flight);
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
    const bool is_best = best == i;
    ui.number_cell(metric_digits(metric, *value, is_best),
                   is_best ? kit::TextLook::kGood : kit::TextLook::kNumber);
    if (is_best) ui.hint({"The best of these runs: " + better_words(metric), ""});
  }
}

/// Groups of metrics, each a table: their columns stay below each other.
void draw_metrics_of(kit::Ui& ui,
                     const RunsModel& model,
                     const RunsState& state,
                     const RunColumns& part) {
  const auto columns = columns_of(ui, model, state, part, kit::Align::kDecimal);
  const std::string name = part.first == 0 ? "metrics" : fmt::format("metrics from {}", part.first);
  const auto all = shown_metrics();
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin;
    while (end < all.size() && all[end].group == all[begin].group) ++end;
    ui.text(std::string(all[begin].group), kit::TextLook::kNormal);
    const kit::TableOptions options{
        .has_header = begin == 0, .is_dense = true, .is_only_read = true};
    if (const auto table = ui.table(name, columns, options)) {
      for (; begin < end; ++begin) draw_metric(ui, all[begin], state, part);
    }
    begin = end;
  }
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
  const double digit = ui.text_width("0", kit::TextLook::kNumber);
  double widest = 0.0, names = 0.0;
  for (const ShownMetric& metric : shown_metrics()) {
    names = std::max(names, ui.text_width(std::string(metric.statistic)));
    const MetricRow* const row = row_of_metric(state, metric);
    if (row == nullptr) continue;
    const auto best = best_run(metric, *row, state.comparison.is_same_flight);
    for (std::size_t i = 0; i < row->values.size(); ++i) {
      if (!row->values[i]) continue;
      const std::string digits = metric_digits(metric, *row->values[i], best == i);
      // Below each other at their points, those with fewer digits end further left.
      widest = std::max(widest, ui.text_width(digits, kit::TextLook::kNumber) +
                                    digit * (kMostDecimals - metric.decimals));
    }
  }
  for (const RunColumns& part : parts_of(ui, model, state, std::ceil(widest) + 1.0, names))
    draw_metrics_of(ui, model, state, part);
  if (state.numbers.size() < 2) return;
  ui.wrapped(state.comparison.is_same_flight
                 ? std::string(kBestMark) + " and green: the best run by this number"
                 : std::string("Runs of different flights: none is marked as the best"),
             kit::TextLook::kMuted);
}

void draw_settings(kit::Ui& ui, const RunsModel& model, const RunsState& state) {
  const auto& settings = state.comparison.settings;
  const auto section = ui.section("Settings that differ", true, fmt::format("{}", settings.size()));
  if (!section) return;
  if (settings.empty()) {
    ui.text("None: the runs were made alike", kit::TextLook::kMuted);
    return;
  }
  double widest = 0.0;
  for (const SettingDifference& setting : settings) {
    for (const auto& value : setting.values)
      widest = std::max(widest, ui.text_width(value.value_or("–"), kit::TextLook::kNumber));
  }
  const double names = ui.px(kSettingNames);  // they may be cut, and are whole in their tooltips
  for (const RunColumns& part : parts_of(ui, model, state, std::ceil(widest) + 1.0, names)) {
    const auto columns = columns_of(ui, model, state, part, kit::Align::kRight);
    const std::string name =
        part.first == 0 ? "settings" : fmt::format("settings from {}", part.first);
    const auto table = ui.table(name, columns, {.is_dense = true, .is_only_read = true});
    if (!table) return;
    for (const SettingDifference& setting : settings) {
      ui.row(setting.name);
      ui.cell(
          setting.unit.empty() ? setting.name : fmt::format("{} [{}]", setting.name, setting.unit),
          kit::TextLook::kMuted);
      if (!setting.help.empty()) ui.hint({setting.help, ""});
      for (std::size_t i = part.first; i < part.end; ++i)
        ui.number_cell(setting.values[i].value_or("–"));
    }
  }
}

}  // namespace nadir
