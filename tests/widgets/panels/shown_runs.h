// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "tests/core/session/made_run.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/runs_panel.h"

namespace nadir {

[[nodiscard]] inline RunsModel::Row row_of(int number,
                                           const std::string& name,
                                           std::shared_ptr<const RunDocument> document) {
  RunsModel::Row row;
  row.number = number;
  row.name = name;
  row.path = "/runs/" + name + ".nadir";
  row.colour = number - 1;
  row.is_active = number == 1;
  row.document = std::move(document);
  return row;
}

/// Errors of 0.5 m against 0.2 m up to 10 s, and from then on 8 m; made with another seed.
[[nodiscard]] inline RunsModel two_runs() {
  RunDocument other =
      made_run(200, [](RunStep& step) { set_error_m(step, step.step < 100 ? 0.2 : 8.0); });
  other.header.seed = 2;
  RunsModel model;
  model.rows = {
      row_of(1, "calm", made_document(200, [](RunStep& step) { set_error_m(step, 0.5); })),
      row_of(2, "wild", RunDocument::from_steps(other))};
  return model;
}

struct ShownRuns {
  explicit ShownRuns(RunsModel shown, double width_pt = 340.0, double scale = 1.0)
      : model(std::move(shown)),
        screen(ThemeName::kDark, scale, {width_pt * scale, 800.0 * scale}) {
    asked = screen.wait(3, draw());
  }
  [[nodiscard]] std::function<Actions(kit::Ui&)> draw() {
    return [this](kit::Ui& ui) { return draw_runs(ui, model, state); };
  }
  Actions click_row(const std::string& path) { return screen.click_at(path, 20.0, 14.0, draw()); }
  [[nodiscard]] std::string cell(const std::string& metric, const std::string& run) const {
    return screen.at("Runs/Errors/metrics/" + metric + "/" + run).value;
  }

  RunsModel model;
  RunsState state;
  kit::HeadlessUi screen;
  Actions asked;
};

}  // namespace nadir
