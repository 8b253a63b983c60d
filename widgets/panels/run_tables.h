// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "widgets/panels/runs_panel.h"

namespace nadir {

/// Empty where there is no such run.
[[nodiscard]] std::string name_of_run(const RunsModel& model, int number);

/// The errors of the runs beside each other. Their columns are as wide as the widest value, so that none is cut: where not all runs
/// have room, the others follow in further tables ("metrics from 3").
void draw_metrics(kit::Ui& ui, const RunsModel& model, RunsState& state);

/// The same of the settings in which they differ.
void draw_settings(kit::Ui& ui, const RunsModel& model, RunsState& state);

}  // namespace nadir
