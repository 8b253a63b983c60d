// SPDX-License-Identifier: Apache-2.0
// Figures that are charts alone: mse-bars, cdf, consistency, timing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "widgets/figures/chart_panel.h"
#include "widgets/figures/error_charts.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"

namespace nadir {
namespace {

using MakeCharts = std::vector<CaptionedChart> (*)(std::span<const FigureRun>, const Theme&);

/// A grid of charts with one legend above and the foot of the runs below.
class ChartFigure : public Figure {
 public:
  ChartFigure(FigureInputs inputs, MakeCharts make, std::size_t columns_wanted, std::string words)
      : inputs_(std::move(inputs)),
        make_(make),
        columns_(columns_wanted),
        words_(std::move(words)) {}

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    ChartGrid charts(make_(inputs_.runs, format.colours()), columns_);
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest,
              (words_.empty() ? "" : words_ + " · ") + foot_of_all(inputs_.runs));
    draw_page_legend(canvas, format, rest, charts.legend());
    charts.draw(canvas, format, rest);
    return {};
  }

 private:
  FigureInputs inputs_;
  MakeCharts make_;
  std::size_t columns_;
  std::string words_;
};

std::vector<CaptionedChart> mse_charts(std::span<const FigureRun> runs, const Theme& theme) {
  return {{"(a) position", mse_chart(runs, ErrorKind::kPosition, theme)},
          {"(b) orientation", mse_chart(runs, ErrorKind::kOrientation, theme)}};
}

std::vector<CaptionedChart> cdf_charts(std::span<const FigureRun> runs, const Theme& theme) {
  return {{"(a) position", cdf_chart(runs, ErrorKind::kPosition, theme)},
          {"(b) orientation", cdf_chart(runs, ErrorKind::kOrientation, theme)}};
}

std::vector<CaptionedChart> consistency_charts(std::span<const FigureRun> runs,
                                               const Theme& theme) {
  const FigureRun& run = runs.front();
  std::vector<CaptionedChart> charts = {
      {"(a) normalised error squared", nees_chart(run, theme)},
      {"(b) calibration of the position ellipse", calibration_chart(run, theme)},
      {"(c) effective sample size", sample_size_chart(run, theme)},
      {"(d) agreement with the map", agreement_chart(runs, theme)}};
  // Each panel's caption says what of the run its line is; the legend names the run once for all of them.
  for (CaptionedChart& captioned : charts) captioned.chart.lines.front().name = "this run";
  return charts;
}

std::vector<CaptionedChart> timing_charts(std::span<const FigureRun> runs, const Theme& theme) {
  return {
      {"(a) computing time of each update", timing_chart(runs.front(), theme)},
      {"(b) particles and their effective sample size", sample_size_chart(runs.front(), theme)}};
}

/// "mean update 8.0 ms, longest 9.1 ms, steps 500 ms apart", as far as it is known.
std::string timing_words(const FigureRun& run) {
  double sum_ms = 0.0;
  double longest_ms = 0.0;
  int count = 0;
  for (const RunStep& step : run.steps) {
    if (!std::isfinite(step.update_ms)) continue;
    sum_ms += step.update_ms;
    longest_ms = std::max(longest_ms, step.update_ms);
    ++count;
  }
  std::string words = "computing times are not known";
  if (count > 0) {
    words = fmt::format("mean update {:.1f} ms, longest {:.1f} ms", sum_ms / count, longest_ms);
  }
  const auto period_ms = step_period_ms(run);
  if (period_ms) words += fmt::format(", steps {:.0f} ms apart", *period_ms);
  return words;
}

}  // namespace

Result<std::unique_ptr<Figure>> make_mse_bars(FigureInputs inputs) {
  return std::make_unique<ChartFigure>(std::move(inputs), mse_charts, 2, "");
}

Result<std::unique_ptr<Figure>> make_cdf(FigureInputs inputs) {
  return std::make_unique<ChartFigure>(std::move(inputs), cdf_charts, 2, "");
}

Result<std::unique_ptr<Figure>> make_consistency(FigureInputs inputs) {
  const Consistency& consistency = inputs.runs.front().evaluation.consistency;
  std::string words;
  if (consistency.nees_mean) {
    words = fmt::format(
        "mean NEES {:.2f} (3 if consistent; 95 % of means of {} independent steps lie in {:.2f} to "
        "{:.2f})",
        *consistency.nees_mean, consistency.nees_steps, *consistency.nees_lower_95,
        *consistency.nees_upper_95);
  }
  if (consistency.coverage_95) {
    words += fmt::format("{}{:.1f} % of true positions inside the 95 % ellipse",
                         words.empty() ? "" : " · ", 100.0 * *consistency.coverage_95);
  }
  if (consistency.excluded_steps > 0) {
    words += fmt::format("{}{} steps without a usable covariance left out of NEES",
                         words.empty() ? "" : " · ", consistency.excluded_steps);
    if (consistency.coverage_excluded_steps > 0) {
      words +=
          fmt::format(", {} without any out of calibration", consistency.coverage_excluded_steps);
    }
  }
  return std::make_unique<ChartFigure>(std::move(inputs), consistency_charts, 2, words);
}

Result<std::unique_ptr<Figure>> make_timing(FigureInputs inputs) {
  const std::string words = timing_words(inputs.runs.front());
  return std::make_unique<ChartFigure>(std::move(inputs), timing_charts, 1, words);
}

}  // namespace nadir
