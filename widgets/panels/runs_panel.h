// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/session/action.h"
#include "core/session/run_comparison.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/run_table_texts.h"

namespace nadir {

class Session;

/// The runs that are open, and how they compare.
struct RunsModel {
  struct Row {
    int number = 1;  ///< As actions count.
    std::string name, path;
    int colour = 0;  ///< Of run_colour().
    bool is_active = false, is_shown = true, is_live = false;
    std::shared_ptr<const RunDocument> document;  ///< Null while it is read.
    // Of a live one.
    double progress =
        std::numeric_limits<double>::quiet_NaN();  ///< 0 to 1; NaN where nobody knows.
    std::string progress_words;
    std::optional<int> job;  ///< That computes it.
    /// Last frame of its flight, after the run's first step; 0 where that is not known.
    double flight_end_s = 0.0;
  };
  std::vector<Row> rows;  ///< In the order of their numbers.
  bool is_split = false;
};

[[nodiscard]] RunsModel runs_model(const Session& session);

/// What is compared, kept while the runs stay.
struct RunsState {
  std::vector<int> numbers;  ///< Of the runs that are compared, the active one first.
  std::vector<std::shared_ptr<const RunDocument>> compared;
  RunComparison comparison;
  std::uint64_t revision = 0;  ///< Of the comparison: counts those that were made.
  RunTableTexts texts;         ///< What its tables say.
};

/// Paths, for the second run: "Runs/2/##activate", "Runs/2/shown", "Runs/2/Close", "Runs/2/localising/Cancel"; "Runs/Split view";
/// "Runs/Errors/metrics/position RMSE/NAME"; "Runs/Settings that differ/settings/seed/NAME" (options without effect
/// ".../without effect/..."); "Runs/Parting/2/##go".
[[nodiscard]] Actions draw_runs(kit::Ui& ui, const RunsModel& model, RunsState& state);

}  // namespace nadir
