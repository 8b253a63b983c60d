// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_table_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/panels/panel_text.h"
#include "widgets/panels/run_labels.h"
#include "widgets/panels/run_metric_rows.h"

namespace nadir {
namespace {

constexpr double kBetweenColumns = 4.0, kMostTitle = 96.0,
                 kMostSettingName = 132.0;  // of the design

MetricTexts texts_of_metric(const ShownMetric& metric, const RunComparison& comparison) {
  MetricTexts texts;
  const auto& rows = comparison.metrics;
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const MetricRow& one) { return one.key == metric.key; });
  if (row == rows.end()) return texts;
  texts.is_there = true;
  const std::vector<std::size_t> best = best_runs(metric, *row, comparison.do_compete());
  texts.is_shared = best.size() > 1;
  texts.is_best.assign(row->values.size(), false);
  for (const std::size_t run : best) texts.is_best[run] = true;
  for (std::size_t i = 0; i < row->values.size(); ++i) {
    const auto& value = row->values[i];
    texts.digits.push_back(value
                               ? (texts.is_best[i] ? kBestMark : "") + metric_digits(metric, *value)
                               : std::string());
  }
  return texts;
}

void measure_metrics(RunTableTexts& texts, const kit::Ui& ui) {
  BrokenColumns& columns = texts.metric_columns = {};
  const auto all = shown_metrics();
  for (std::size_t i = 0; i < all.size(); ++i) {
    columns.names = std::max(columns.names, ui.text_width(std::string(all[i].statistic)));
    for (const std::string& digits : texts.metrics[i].digits) {
      columns.widest = std::max(columns.widest, ui.text_width(digits, kit::TextLook::kNumber));
    }
  }
  columns.widest = std::ceil(columns.widest) + 1.0;
}

/// Whether a value is words, which no column has room for.
bool has_words_for_values(const SettingDifference& setting) {
  const auto are_words = [](const auto& value) {
    return value && value->find(' ') < value->size();
  };
  return std::any_of(setting.values.begin(), setting.values.end(), are_words);
}

SettingTexts texts_of_settings(const std::vector<SettingDifference>& settings, const kit::Ui& ui) {
  SettingTexts texts;
  BrokenColumns& columns = texts.columns;
  for (const SettingDifference& setting : settings) {
    if (has_words_for_values(setting)) {
      texts.in_words.push_back(setting);
      continue;
    }
    texts.in_columns.push_back(setting);
    columns.names = std::max(columns.names, ui.text_width(label_of_setting(setting)));
    for (const auto& value : setting.values) {
      const double width = ui.text_width(value.value_or("–"), kit::TextLook::kNumber);
      columns.widest = std::max(columns.widest, width);
    }
  }
  columns.names = std::min(std::ceil(columns.names) + 1.0, ui.px(kMostSettingName));
  columns.widest = std::ceil(columns.widest) + 1.0;
  return texts;
}

/// What stands above a part of the runs, right of a first column.
std::vector<kit::Column> columns_of(const kit::Ui& ui,
                                    const RunTableTexts& texts,
                                    const RunColumns& part,
                                    kit::Align align) {
  std::vector<kit::Column> columns(1);
  for (std::size_t i = part.first; i < part.end; ++i) {
    kit::Column column;
    const std::string& name = texts.names[i];
    const std::string fitted =
        fitted_name(texts.titles[i], part.width,
                    [&ui](const std::string& line) { return ui.text_width(line); });
    column.title = fitted == name ? name : label_of(fitted, name);
    column.align = align;
    column.width = part.width;
    column.hint = {name, ""};
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace

std::string label_of_setting(const SettingDifference& setting) {
  return setting.unit.empty() ? setting.name : fmt::format("{} [{}]", setting.name, setting.unit);
}

void renew_table_texts(RunTableTexts& texts,
                       const kit::Ui& ui,
                       std::uint64_t revision,
                       const RunComparison& comparison,
                       RunDocuments runs,
                       std::vector<std::string> names,
                       std::set<std::string> live) {
  const double px = ui.px(1.0);
  const bool is_same =
      texts.revision == revision && texts.names == names && texts.live == live && texts.px == px;
  if (is_same) return;
  texts = {};
  texts.revision = revision;
  texts.names = std::move(names);
  texts.live = std::move(live);
  texts.px = px;
  texts.titles = told_apart(texts.names);
  texts.span = span_words(comparison, texts.names, texts.live);
  texts.copied = copied_words(runs, texts.names);
  for (const ShownMetric& metric : shown_metrics()) {
    texts.metrics.push_back(texts_of_metric(metric, comparison));
  }
  measure_metrics(texts, ui);
  texts.settings = texts_of_settings(comparison.settings, ui);
  texts.idle_settings = texts_of_settings(comparison.idle_settings, ui);
}

const std::vector<RunColumns>& parts_for(BrokenColumns& broken,
                                         const kit::Ui& ui,
                                         const RunTableTexts& texts,
                                         kit::Align align) {
  const double all_room = ui.room().width;
  if (broken.room == all_room) return broken.parts;
  broken.room = all_room;
  broken.parts.clear();
  const std::size_t count = texts.names.size();
  const double between = ui.px(2.0 * kBetweenColumns);
  const double room = all_room - broken.names - between;
  const auto fitting = [&](double width) {
    return static_cast<std::size_t>(std::max(1.0, std::floor(room / (width + between))));
  };
  double wanted = broken.widest;  // with its title, where that does not cost another run its place
  for (const std::string& title : texts.titles) {
    wanted = std::max(wanted, std::min(std::ceil(ui.text_width(title)) + 1.0, ui.px(kMostTitle)));
  }
  const double width = fitting(wanted) >= count ? wanted : broken.widest;
  const std::size_t most = std::min(count, fitting(width));
  for (std::size_t first = 0; first < count; first += most) {
    RunColumns part{first, std::min(count, first + most), std::min(width, room - between), {}};
    part.columns = columns_of(ui, texts, part, align);
    broken.parts.push_back(std::move(part));
  }
  return broken.parts;
}

}  // namespace nadir
