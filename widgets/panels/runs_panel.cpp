// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/runs_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/panel_text.h"
#include "widgets/panels/run_labels.h"
#include "widgets/panels/run_tables.h"
#include "widgets/panels/shortcut_hint.h"
#include "widgets/panels/time_axis.h"

namespace nadir {
namespace {

constexpr const char* kIncomplete = "incomplete";

/// Compares again only where other runs are open, or one has grown. The active one comes first.
void compare_again(const RunsModel& model, RunsState& state) {
  std::vector<const RunsModel::Row*> rows;
  for (const RunsModel::Row& row : model.rows) {
    if (row.document != nullptr) rows.push_back(&row);
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto* a, const auto* b) { return a->is_active && !b->is_active; });
  std::vector<int> numbers;
  std::vector<std::shared_ptr<const RunDocument>> documents;
  for (const RunsModel::Row* row : rows) {
    numbers.push_back(row->number);
    documents.push_back(row->document);
  }
  if (documents == state.compared && numbers == state.numbers) return;
  state.comparison = compare_runs(documents);
  ++state.revision;
  state.numbers = std::move(numbers);
  state.compared = std::move(documents);
}

std::string facts_of(const RunsModel::Row& row) {
  if (row.document == nullptr) return row.path + "\nis being read";
  const RunDocument& run = *row.document;
  std::string facts =
      fmt::format("{}\n{} steps in {}, preset {}, seed {}", row.path, run.steps.size(),
                  clock_text(run.duration_s()), run.header.preset, run.header.seed);
  if (is_incomplete(run, row.is_live)) {
    facts += "\nincomplete: " + incomplete_words(run, row.flight_end_s);
  }
  return facts;
}

void draw_run_row(kit::Ui& ui, const RunsModel::Row& row, std::size_t count, Actions& asked) {
  const auto scope = ui.scope(fmt::format("{}", row.number));
  const double button = ui.px(28.0);
  const double inside = ui.room().width - ui.px(8.0);
  kit::ListRow look;
  look.is_selected = row.is_active;
  look.hint = {facts_of(row), ""};
  if (ui.list_row("##activate", look).was_clicked && !row.is_active) {
    asked.emplace_back(actions::ActivateRun{row.number});
  }
  ui.same_line(0.0);
  ui.right_align(inside);
  ui.colour_dot(run_colour(ui.theme(), static_cast<std::size_t>(std::max(0, row.colour))));
  ui.same_line();
  const bool is_muted = row.document == nullptr || (!row.is_shown && !row.is_active);
  const bool has_stopped = row.document != nullptr && is_incomplete(*row.document, row.is_live);
  const double tag = has_stopped ? ui.text_width(kIncomplete) + ui.px(8.0) : 0.0;
  const std::string name =
      fitted_name(row.name, ui.room().width - 2.0 * button - tag,
                  [&ui](const std::string& line) { return ui.text_width(line); });
  ui.text(name, is_muted ? kit::TextLook::kMuted : kit::TextLook::kNormal);
  if (name != row.name) ui.hint({row.name, ""});
  ui.same_line(0.0);
  if (has_stopped) {
    ui.right_align(2.0 * button + tag);
    ui.text(kIncomplete, kit::TextLook::kWarning);
    ui.hint({row.name + " " + incomplete_words(*row.document, row.flight_end_s), ""});
    ui.same_line(0.0);
  }
  ui.right_align(2.0 * button);
  if (count > 1) {
    const auto always = ui.disabled(row.is_active, "The active run always shows");
    const auto shown =
        ui.eye("shown", row.is_shown || row.is_active, {"Draw it beside the active run", ""});
    if (shown)
      asked.emplace_back(actions::ShowRun{row.number, *shown ? Switch::kOn : Switch::kOff});
    ui.same_line(0.0);
    ui.right_align(button);
  } else {
    ui.right_align(button);
  }
  if (ui.icon_button("Close", kit::Icon::kClose,
                     hint_for("Close this run; its file stays", actions::CloseRun{row.number}))) {
    asked.emplace_back(actions::CloseRun{row.number});
  }
  if (!row.is_live) return;
  const std::size_t steps = row.document == nullptr ? 0 : row.document->steps.size();
  const std::string words =
      row.progress_words.empty() ? fmt::format("{} steps", steps) : row.progress_words;
  if (ui.progress("localising", row.progress, words, row.job.has_value())) {
    asked.emplace_back(actions::CancelJob{row.job});
  }
}

void draw_divergences(kit::Ui& ui, const RunsModel& model, const RunsState& state, Actions& asked) {
  const auto section = ui.section("Parting");
  if (!section) return;
  const std::string active = name_of_run(model, state.numbers.front());
  ui.wrapped(fmt::format("Where a run first parts from {}: {}", active, divergence_words()),
             kit::TextLook::kMuted);
  for (std::size_t i = 1; i < state.numbers.size(); ++i) {
    const int number = state.numbers[i];
    const auto scope = ui.scope(fmt::format("{}", number));
    const auto& divergence = state.comparison.divergence[i];
    const std::string name = name_of_run(model, number);
    if (!divergence) {
      ui.cut_text(fmt::format("{} nowhere parts from {}", name, active), kit::TextLook::kMuted);
      ui.hint({fmt::format("{} and {} are nowhere {}", name, active, divergence_words()), ""});
      continue;
    }
    const double inside = ui.room().width - ui.px(8.0);
    kit::ListRow row;
    row.hint = {fmt::format("Go to where {} first parts from {}", name, active), "", "",
                "Parted is " + divergence_words()};
    if (ui.list_row("##go", row).was_clicked) asked.emplace_back(actions::GoToDivergence{number});
    ui.same_line(0.0);
    ui.right_align(inside);
    ui.text(clock_text(divergence->time_s), kit::TextLook::kNumber);
    ui.same_line(ui.px(10.0));
    ui.cut_text(state.numbers.size() > 2 ? name + ": " + divergence->words : divergence->words);
  }
}

}  // namespace

Actions draw_runs(kit::Ui& ui, const RunsModel& model, RunsState& state) {
  const auto scope = ui.scope("Runs");
  if (model.rows.empty())
    return draw_empty_state(ui, no_run_state("how it did, and how others compare"));
  Actions asked;
  compare_again(model, state);
  const auto area = ui.scroll_area("Runs area");
  for (const RunsModel::Row& row : model.rows) draw_run_row(ui, row, model.rows.size(), asked);
  ui.space();
  {
    const auto alone = ui.disabled(model.rows.size() < 2, "Open a second run first");
    const auto split = ui.checkbox("Split view", model.is_split,
                                   {"One map for each of two runs, moved together", ""});
    if (split) asked.emplace_back(actions::SplitView{*split ? Switch::kOn : Switch::kOff});
  }
  if (state.numbers.empty()) return asked;
  ui.space();
  draw_metrics(ui, model, state);
  if (state.numbers.size() < 2) return asked;
  draw_settings(ui, model, state);
  draw_divergences(ui, model, state, asked);
  return asked;
}

}  // namespace nadir
