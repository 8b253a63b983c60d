// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/why_panel.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/map_geometry.h"
#include "widgets/panels/moment_kinds.h"
#include "widgets/panels/moment_panel.h"
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
                  {"What the filter's weights are made of: 0 fits everywhere, 1 nowhere; lower is "
                   "better, the lowest is green",
                   "", "", "computed with the run's own options"}},
      kit::Column{
          kTitles[2],
          kit::Align::kRight,
          ui.px(64.0),
          0,
          {"Share of cells on known ground whose class the map has there; more is better", ""}}};
  const auto table = ui.table("Costs", columns, {.is_only_read = true});
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
    ui.number_cell(share ? fmt::format("{:.0f} %", 100.0 * *share) : "–");
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
      kit::Column{"mean cost",
                  kit::Align::kDecimal,
                  ui.px(84.0),
                  4,
                  {"At the cluster's mean: 0 fits everywhere, 1 nowhere; lower is better", ""}},
      kit::Column{"", kit::Align::kLeft, ui.px(44.0)}};
  const auto table = ui.table("Modes", columns, {.is_only_read = true});
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

/// Where a class costs less, and by how much: "truth", "0.0123".
void draw_class_costs(kit::Ui& ui, const MomentExplanation& moment) {
  ui.wrapped(
      "Each class's part in the mean cost (0 fits everywhere, 1 nowhere; lower is better): at "
      "which "
      "pose it costs less, and by how much.",
      kit::TextLook::kMuted);
  const std::array<kit::Column, 3> columns = {
      kit::Column{"class"},
      kit::Column{"cheaper at",
                  kit::Align::kLeft,
                  ui.px(84.0),
                  0,
                  {"The pose at which this class fits the map better; the class that matters most "
                   "comes first",
                   ""}},
      kit::Column{"by",
                  kit::Align::kDecimal,
                  ui.px(68.0),
                  4,
                  {"Difference of the class's parts in the two mean costs; over all classes it is "
                   "that of the mean costs",
                   ""}}};
  const auto table = ui.table("Cost by class", columns, {.is_only_read = true});
  if (!table) return;
  constexpr double kNothing = 5e-5;
  const auto row = [&ui](const std::string& name, double at_truth_less_at_estimate) {
    ui.row(name);
    ui.cell(name);
    const double by = std::abs(at_truth_less_at_estimate);
    if (by < kNothing) {
      ui.cell("neither", kit::TextLook::kMuted);
      ui.number_cell("0.0000", kit::TextLook::kMutedNumber);
      return;
    }
    ui.cell(at_truth_less_at_estimate > 0.0 ? "estimate" : "truth");
    ui.number_cell(fmt::format("{:.4f}", by));
  };
  for (const ClassDifference& difference : moment.by_class) {
    row(std::string(class_info(difference.id).name), difference.cost_difference);
  }
  if (moment.truth && moment.truth->mean_cost && moment.estimate.mean_cost) {
    row("all", *moment.truth->mean_cost - *moment.estimate.mean_cost);
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
  const VerdictHead head = verdict_head(answer.explanation->verdict, model.mark);
  ui.text(head.words, head.look);
  if (model.is_computing && !model.is_answer_of_now) {
    ui.same_line();
    ui.text("computing…", kit::TextLook::kMuted);
  }
  if (model.mark) {
    ui.wrapped("Marked on the timeline: " + moment_words(*model.mark) + ".", kit::TextLook::kMuted);
    ui.hint({std::string(moment_kind_look(model.mark->kind).meaning), "", "",
             severity_words(*model.mark)});
  }
  ui.wrapped(answer.words);
  if (!answer.hold_words.empty()) {
    ui.wrapped(answer.hold_words);
    ui.hint(
        {"How far the estimate could be moved, with its heading, while the mean cost stays "
         "about as good: the light valley around the ring of the error surface",
         "", "", "computed with the run's own options"});
  }
  const MomentExplanation& moment = *answer.explanation;
  if (const auto section = ui.section("Error surface and topview")) {
    draw_surface_and_patch(ui, model, state, asked);
  }
  if (const auto section = ui.section("Agreement by class")) {
    draw_agreement_table(ui, state.seen.of(answer.step, answer.map, ui.theme_name()),
                         run_colour(ui.theme(), model.colour));
  }
  if (!moment.by_class.empty()) {
    if (const auto section = ui.section("Cost by class")) draw_class_costs(ui, moment);
  }
  if (const auto section = ui.section("Mean cost")) draw_fits(ui, moment);
  if (const auto section = ui.section("Heading")) draw_surface_cuts(ui, model);
  if (!answer.surety.empty()) {
    if (const auto section = ui.section("Consistency")) ui.wrapped(answer.surety);
  }
  if (!moment.modes.empty()) {
    if (const auto section = ui.section("Modes", true, fmt::format("{}", moment.modes.size())))
      draw_modes_table(ui, moment, asked);
  }
  return asked;
}

}  // namespace nadir
