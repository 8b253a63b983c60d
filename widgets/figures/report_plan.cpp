// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/report_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "widgets/figures/figure_sources.h"
#include "widgets/figures/figures.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

/// Seconds after the start of the largest position error, else of the end.
double worst_moment_s(const FigureRun& run) {
  double worst_s = run.elapsed_s(run.steps.back());
  double largest_m = -1.0;
  for (const RunStep& step : run.steps) {
    if (!step.truth_in_enu) continue;
    const double error_m =
        (step.estimate.moments.mean.translation_m() - step.truth_in_enu->translation_m()).norm();
    if (error_m > largest_m) {
      largest_m = error_m;
      worst_s = run.elapsed_s(step);
    }
  }
  return worst_s;
}

/// The others show a whole run.
bool shows_an_instant(const FigureKind& kind) {
  constexpr std::array<std::string_view, 3> kInstants = {"moment", "error-surface", "scene"};
  return std::find(kInstants.begin(), kInstants.end(), kind.name) != kInstants.end();
}

class Planner {
 public:
  Planner(const ReportRequest& request, std::span<const FigureRun> runs)
      : request_(request), runs_(runs) {}

  ReportPlan plan() {
    for (const FigureRun& run : runs_) maps_.push_back(map_of(run));
    if (runs_.size() > 1) {
      section_ = "All runs";
      for (const FigureKind& kind : figure_kinds()) {
        if (!is_of_all(kind) || (kind.needs_map && maps_.front().empty())) continue;
        add(kind, request_.runs);
      }
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) plan_run(i);
    plan_maps();
    return std::move(plan_);
  }

 private:
  /// Empty where it is not there, which is noted.
  fs::path map_of(const FigureRun& run) {
    if (!request_.map.empty()) return request_.map;
    auto map = find_map_of(run);
    if (map) return std::move(*map);
    plan_.left_out.push_back("figures over the map: " + map.error().message);
    return {};
  }

  /// Figures that compare, and charts that have room for all runs: those are drawn once.
  [[nodiscard]] bool is_of_all(const FigureKind& kind) const {
    return kind.fewest_runs > 1 ||
           (runs_.size() > 1 && kind.fewest_runs == 1 && kind.most_runs > 1 && !kind.needs_map);
  }

  PlannedFigure& add(const FigureKind& kind, const std::vector<std::string>& runs) {
    PlannedFigure figure;
    figure.recipe = {std::string(kind.name), runs, request_.map, "", request_.options, {}};
    figure.section = section_;
    figure.file = std::string(kind.name) + tag_;
    figure.caption = kind.summary;
    figure.has_vectors = !kind.needs_map;
    plan_.figures.push_back(std::move(figure));
    return plan_.figures.back();
  }

  void plan_run(std::size_t i) {
    const FigureRun& run = runs_[i];
    section_ = section_of(run);
    // Two runs of one name in different folders must not share a file.
    tag_ = runs_.size() == 1 ? "" : fmt::format("-{}-{}", i + 1, run.path.stem().string());
    const double worst_s = worst_moment_s(run);
    for (const FigureKind& kind : figure_kinds()) {
      if (kind.fewest_runs != 1 || is_of_all(kind)) continue;
      if (kind.needs_map && maps_[i].empty()) continue;
      PlannedFigure& figure = add(kind, {request_.runs[i]});
      if (!shows_an_instant(kind)) continue;
      figure.recipe.options.time_s = worst_s;
      figure.caption += fmt::format(", {:.1f} s after the start{}", worst_s,
                                    run.has_truth() ? ", where the error is largest" : "");
    }
  }

  /// Each map once, however many runs are on it.
  void plan_maps() {
    std::vector<fs::path> drawn;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto is_same = [this, i](const fs::path& map) {
        std::error_code error;
        return map == maps_[i] || fs::equivalent(map, maps_[i], error);
      };
      if (maps_[i].empty() || std::any_of(drawn.begin(), drawn.end(), is_same)) continue;
      drawn.push_back(maps_[i]);
      tag_ = drawn.size() > 1 ? fmt::format("-{}", drawn.size()) : "";
      section_ = "Map " + runs_[i].reader->header().map;
      std::error_code error;
      const bool has_route = fs::exists(default_route_of(maps_[i]), error);
      for (const FigureKind& kind : figure_kinds()) {
        if (kind.fewest_runs > 0 || (kind.name == "route" && !has_route)) continue;
        add(kind, {request_.runs[i]});
      }
    }
  }

  const ReportRequest& request_;
  std::span<const FigureRun> runs_;
  std::vector<fs::path> maps_;
  std::string section_, tag_;
  ReportPlan plan_;
};

}  // namespace

std::string section_of(const FigureRun& run) { return "Run " + run.name; }

ReportPlan plan_report(const ReportRequest& request, std::span<const FigureRun> runs) {
  return Planner(request, runs).plan();
}

}  // namespace nadir
