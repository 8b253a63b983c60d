// SPDX-License-Identifier: Apache-2.0
// The tables of a report's page.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "core/base/angle.h"
#include "widgets/canvas/printable.h"
#include "widgets/figures/report_page.h"

namespace nadir {
namespace {

constexpr int kErrorColumns = 8;

std::string cell(const std::string& text) { return "<td>" + markup_text(text) + "</td>"; }

/// A number with so many decimals, or a dash where it is not known.
std::string number_cell(std::optional<double> value, int decimals) {
  if (!value || !std::isfinite(*value)) return "<td class=\"number\">–</td>";
  return fmt::format("<td class=\"number\">{:.{}f}</td>", *value, decimals);
}

std::string cells_of(const std::array<std::optional<double>, kErrorColumns>& values,
                     const std::array<int, kErrorColumns>& decimals) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) text += number_cell(values.at(i), decimals.at(i));
  return text;
}

/// All unknown without a summary.
std::array<std::optional<double>, kErrorColumns> errors_of(
    const std::optional<PoseErrorSummary>& known) {
  if (!known) return {};
  const PoseErrorSummary& summary = *known;
  const auto degrees = [](double radians) { return Angle::radians(radians).degrees(); };
  const ErrorStatistics& position = summary.position_m;
  const ErrorStatistics& orientation = summary.orientation_rad;
  return {position.root_mean_square,
          position.median,
          position.p90,
          position.maximum,
          100.0 * summary.recall_1m,
          degrees(orientation.root_mean_square),
          degrees(orientation.median),
          degrees(orientation.maximum)};
}

std::string consistency_cells(const RunEvaluation& evaluation) {
  const auto& coverage = evaluation.consistency.coverage_95;
  return number_cell(evaluation.consistency.nees_mean, 2) +
         number_cell(coverage ? std::optional(100.0 * *coverage) : std::nullopt, 1) +
         number_cell(evaluation.convergence.after_s, 1);
}

std::string rows_of(const FigureRun& run) {
  const RunEvaluation& evaluation = run.evaluation;
  if (!evaluation.estimate) {
    return fmt::format(
        "<tbody>\n<tr><th scope=\"row\">{}</th><td colspan=\"{}\">its truth is not known, so there "
        "are no errors</td></tr>\n</tbody>\n",
        markup_text(run.name), kErrorColumns + 4);
  }
  const auto odometry = errors_of(evaluation.odometry);
  const auto estimate = errors_of(evaluation.estimate);
  std::array<std::optional<double>, kErrorColumns> ratio;
  constexpr std::size_t kRecall = 4;  // of shares a ratio says nothing
  for (std::size_t i = 0; i < ratio.size(); ++i) {
    const auto& of_odometry = odometry.at(i);
    if (i != kRecall && of_odometry && *of_odometry > 0.0)
      ratio.at(i) = *estimate.at(i) / *of_odometry;
  }
  constexpr std::array<int, kErrorColumns> kDecimals = {2, 2, 2, 2, 1, 2, 2, 2};
  constexpr std::array<int, kErrorColumns> kRatioDecimals = {3, 3, 3, 3, 3, 3, 3, 3};
  const char* const no_consistency = "<td colspan=\"3\"></td>";
  return fmt::format(
      "<tbody>\n<tr><th scope=\"rowgroup\" rowspan=\"3\">{}</th><td>odometry "
      "(input)</td>{}{}</tr>\n"
      "<tr><td>estimate</td>{}{}</tr>\n"
      "<tr class=\"ratio\"><td>estimate / odometry</td>{}{}</tr>\n</tbody>\n",
      markup_text(run.name), cells_of(odometry, kDecimals), no_consistency,
      cells_of(estimate, kDecimals), consistency_cells(evaluation), cells_of(ratio, kRatioDecimals),
      no_consistency);
}

}  // namespace

std::string run_table(std::span<const FigureRun> runs) {
  std::string text = "<div class=\"wide\"><table>\n<caption>What was run</caption>\n<thead>\n<tr>";
  for (const char* title :
       {"Run", "Flight", "Map", "Preset", "Seed", "Steps", "Flown", "Truth", "Localised by"}) {
    text += fmt::format("<th scope=\"col\">{}</th>", title);
  }
  text += "</tr>\n</thead>\n<tbody>\n";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const FigureRun& run = runs[i];
    const RunHeader& header = run.reader->header();
    const RunEvaluation& evaluation = run.evaluation;
    std::string flown = fmt::format("{:.1f} s", evaluation.duration_s);
    if (run.has_truth()) flown += fmt::format(", {:.1f} m", evaluation.distance_m);
    const std::string truth = run.has_truth()
                                  ? fmt::format("{} pairs matched, {} steps dropped, no alignment",
                                                evaluation.matched_pairs, evaluation.dropped_steps)
                                  : std::string("not known");
    text += fmt::format(
        "<tr id=\"run-{}\"><th scope=\"row\" title=\"{}\">{}</th>{}{}{}{}{}{}{}{}</tr>\n", i + 1,
        markup_text(run.path.string()), markup_text(run.name), cell(header.flight),
        cell(header.map), cell(header.preset), cell(fmt::format("{}", header.seed)),
        cell(fmt::format("{}{}", run.steps.size(),
                         evaluation.is_complete ? "" : " (stopped before its end)")),
        cell(flown), cell(truth), cell("Nadir " + header.program_version));
  }
  return text + "</tbody>\n</table></div>\n";
}

std::string error_table(std::span<const FigureRun> runs) {
  std::string text =
      "<div class=\"wide\"><table>\n<caption>Errors</caption>\n<thead>\n"
      "<tr><th rowspan=\"2\" scope=\"col\">Run</th><th rowspan=\"2\" scope=\"col\">Of</th>"
      "<th colspan=\"5\" scope=\"colgroup\">Position [m]</th>"
      "<th colspan=\"3\" scope=\"colgroup\">Orientation [deg]</th>"
      "<th colspan=\"3\" scope=\"colgroup\">Filter</th></tr>\n<tr>";
  for (const char* title :
       {"RMSE", "median", "90 % below", "largest", "within 1 m [%]", "RMSE", "median", "largest",
        "mean NEES", "inside 95 % ellipse [%]", "converged after [s]"}) {
    text += fmt::format("<th scope=\"col\">{}</th>", title);
  }
  text += "</tr>\n</thead>\n";
  for (const FigureRun& run : runs) text += rows_of(run);
  return text +
         "</table></div>\n<p class=\"note\">Odometry is the input alone, dead reckoned from the "
         "start; the estimate is what the localiser made of it on the map, and below a ratio of 1 "
         "it helped. RMSE is the root of the mean squared error. A filter that is as sure as it "
         "may be has a mean NEES of 3 and 95 % of the true positions inside its 95 % ellipse. "
         "More rows as text: <a href=\"table.txt\">table.txt</a>.</p>\n";
}

}  // namespace nadir
