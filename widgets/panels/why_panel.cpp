// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/why_panel.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/map_geometry.h"
#include "widgets/panels/why_surface.h"

namespace nadir {
namespace {

constexpr double kModeWidthM = 60.0;  ///< Of ground that a jump to a mode shows.

std::string cost_text(const std::optional<double>& cost) {
  return cost ? fmt::format("{:.4f}", *cost) : "not known";
}

void draw_fits(kit::Ui& ui, const MomentExplanation& moment) {
  static constexpr std::array<const char*, 3> kTitles = {"laid at", "mean cost", "fits"};
  const std::array<kit::Column, 3> columns = {
      kit::Column{kTitles[0]},
      kit::Column{kTitles[1],
                  kit::Align::kDecimal,
                  ui.px(88.0),
                  4,
                  {"What the filter's weights are made of: 0 fits everywhere, 1 nowhere", "", "",
                   "computed with the run's own options"}},
      kit::Column{kTitles[2],
                  kit::Align::kRight,
                  ui.px(64.0),
                  0,
                  {"Share of cells on known ground whose class the map has there", ""}}};
  const auto table = ui.table("Costs", columns);
  if (!table) return;
  std::optional<double> best = moment.estimate.mean_cost;
  for (const auto* fit : {&moment.truth, &moment.odometry}) {
    if (*fit && (*fit)->mean_cost && (!best || *(*fit)->mean_cost < *best))
      best = (*fit)->mean_cost;
  }
  const auto row = [&](const std::string& name, const PoseFit& fit) {
    ui.row(name);
    ui.cell(name);
    const bool is_best = fit.mean_cost && best && *fit.mean_cost == *best;
    ui.number_cell(cost_text(fit.mean_cost),
                   is_best ? kit::TextLook::kGood : kit::TextLook::kNumber);
    const auto share = fit.agreement.share();
    ui.number_cell(share ? fmt::format("{:.0f} %", 100.0 * *share) : "");
  };
  row("estimate", moment.estimate);
  if (moment.truth) row("truth", *moment.truth);
  if (moment.odometry) row("odometry", *moment.odometry);
}

void draw_modes_table(kit::Ui& ui, const MomentExplanation& moment, Actions& asked) {
  const std::array<kit::Column, 4> columns = {
      kit::Column{
          "mass", kit::Align::kRight, ui.px(56.0), 0, {"Share of the particles' weight", ""}},
      kit::Column{
          "from truth", kit::Align::kDecimal, 0.0, 2, {"Distance of the cluster's mean", "", "m"}},
      kit::Column{"mean cost", kit::Align::kDecimal, ui.px(84.0), 4},
      kit::Column{"", kit::Align::kLeft, ui.px(44.0)}};
  const auto table = ui.table("Modes", columns);
  if (!table) return;
  for (std::size_t i = 0; i < moment.modes.size(); ++i) {
    const ModeFit& mode = moment.modes[i];
    ui.row(fmt::format("{}", i + 1));
    ui.number_cell(fmt::format("{:.0f} %", 100.0 * mode.mode.mass));
    ui.number_cell(mode.to_truth_m ? metres_text(*mode.to_truth_m) : "");
    ui.number_cell(mode.mean_cost ? cost_text(mode.mean_cost) : "");
    ui.control_cell();
    if (ui.icon_button("Look", kit::Icon::kLocate, {"Show this place on the map", ""})) {
      const Eigen::Vector2d place = mode.mode.moments.mean.translation_m();
      asked.emplace_back(actions::LookAt{place.x(), place.y(), kModeWidthM});
    }
  }
}

void draw_classes(kit::Ui& ui, const MomentExplanation& moment) {
  const std::array<kit::Column, 4> columns = {
      kit::Column{"class"}, kit::Column{"estimate", kit::Align::kRight, ui.px(62.0)},
      kit::Column{"truth", kit::Align::kRight, ui.px(46.0)},
      kit::Column{"speaks for",
                  kit::Align::kLeft,
                  ui.px(74.0),
                  0,
                  {"Which of the two this class makes cheaper; the first one matters most", ""}}};
  const auto table = ui.table("Classes", columns);
  if (!table) return;
  const auto percent = [](const CellAgreement::Count& count) {
    const auto share = count.share();
    return share ? fmt::format("{:.0f} %", 100.0 * *share) : std::string();
  };
  for (const ClassDifference& difference : moment.by_class) {
    const std::string name(class_info(difference.id).name);
    ui.row(name);
    ui.cell(name);
    ui.number_cell(percent(difference.at_estimate));
    ui.number_cell(percent(difference.at_truth));
    const double cost = difference.cost_difference;
    constexpr double kNothing = 5e-5;
    ui.cell(std::abs(cost) < kNothing ? "" : (cost > 0.0 ? "estimate" : "truth"),
            cost < -kNothing ? kit::TextLook::kWarning : kit::TextLook::kMuted);
  }
}

}  // namespace

Actions draw_why_panel(kit::Ui& ui, const WhyModel& model, WhyState& state) {
  const auto scope = ui.scope("Why");
  if (model.is_reading) return draw_empty_state(ui, reading_state(model.run_name));
  if (model.run_name.empty()) {
    return draw_empty_state(ui, no_run_state("why the filter was right or wrong at a moment"));
  }
  if (!model.has_map) {
    return draw_empty_state(ui,
                            {kit::Icon::kMap,
                             "No map is open",
                             "Drop the run's map on the window: what was seen is compared with it.",
                             {},
                             {}});
  }
  if (!model.answer) {
    return draw_empty_state(ui, {kit::Icon::kClock,
                                 "Computing",
                                 model.has_step ? "What was seen is compared with the map."
                                                : "The run has no steps yet.",
                                 {},
                                 {}});
  }
  Actions asked;
  const MomentAnswer& answer = *model.answer;
  if (!answer.explanation) {
    return draw_empty_state(ui, {kit::Icon::kInfo, "No explanation", answer.error, {}, {}});
  }
  const VerdictHead head = verdict_head(answer.explanation->verdict);
  ui.text(head.words, head.look);
  if (model.is_computing && !model.is_answer_of_now) {
    ui.same_line();
    ui.text("computing…", kit::TextLook::kMuted);
  }
  ui.wrapped(answer.words);
  ui.space();
  draw_fits(ui, *answer.explanation);
  if (const auto section = ui.section("Error surface")) draw_surface(ui, model, state, asked);
  if (!answer.explanation->modes.empty()) {
    const std::size_t count = answer.explanation->modes.size();
    if (const auto section = ui.section("Modes", true, fmt::format("{}", count)))
      draw_modes_table(ui, *answer.explanation, asked);
  }
  if (!answer.explanation->by_class.empty()) {
    if (const auto section = ui.section("Classes")) draw_classes(ui, *answer.explanation);
  }
  return asked;
}

}  // namespace nadir
