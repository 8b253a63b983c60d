// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figure_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/mcl/option_effects.h"
#include "core/run/evaluate_run.h"
#include "core/run/place_beside.h"
#include "core/run/run_options.h"

namespace nadir {
namespace fs = std::filesystem;

std::size_t FigureRun::index_at(double elapsed) const {
  const auto after =
      std::upper_bound(steps.begin(), steps.end(), start_s + elapsed + kSameTimeS,
                       [](double time_s, const RunStep& step) { return time_s < step.time_s; });
  return after == steps.begin() ? 0 : static_cast<std::size_t>(after - steps.begin()) - 1;
}

Result<FigureRun> open_figure_run(const fs::path& path, const FigureOptions& options) {
  auto reader = RunReader::open(path);
  if (!reader) return forward_error(reader);
  // Asked first: what is complete now was complete when its steps are read.
  const bool is_complete = reader->is_complete();
  auto steps = reader->steps();
  if (!steps) return forward_error(steps);
  if (steps->empty()) return fail(ErrorCode::kMalformed, "{}: holds no steps", path.string());
  FigureRun run;
  run.name = path.stem().string();
  run.path = path;
  run.start_s = steps->front().time_s;
  run.reader = std::make_shared<const RunReader>(std::move(*reader));
  for (RunStep& step : *steps) {
    const double elapsed_s = run.elapsed_s(step);
    if (elapsed_s >= options.from_s - kSameTimeS && elapsed_s <= options.to_s + kSameTimeS) {
      run.steps.push_back(std::move(step));
    }
  }
  if (run.steps.empty()) {
    return fail(ErrorCode::kMalformed,
                "{}: has no step from {:g} s to {:g} s after its start; it ends after {:g} s",
                path.string(), options.from_s, std::min(options.to_s, run.elapsed_s(steps->back())),
                run.elapsed_s(steps->back()));
  }
  run.judged.reserve(run.steps.size());
  std::transform(run.steps.begin(), run.steps.end(), std::back_inserter(run.judged),
                 evaluated_step);
  auto evaluation = evaluate_steps(run.judged);
  if (!evaluation) return forward_error(evaluation, path.string());
  run.evaluation = std::move(*evaluation);
  describe(run.evaluation, run.reader->header(), path.string());
  run.evaluation.is_complete = is_complete;
  return run;
}

Result<fs::path> find_map_of(const FigureRun& run) {
  const fs::path named = run.reader->header().map_path;
  if (auto place = place_beside(run.path, named, "map.toml")) return *place;
  return fail(ErrorCode::kNotFound, "{}: its map {} is not there; name one with --map",
              run.path.string(), named.string());
}

namespace {

/// What was set besides the preset: " with temperature 0.05", the options that have an effect.
std::string changed_words(const RunHeader& header) {
  const auto preset = run_preset(header.preset);
  if (!preset) return {};
  constexpr int kMostNamed = 4;
  std::string words;
  int changed = 0;
  for (const OptionText& option : option_texts(*preset)) {
    const auto found = header.options.find(option.name);
    if (found == header.options.end() || found->second == option.value) continue;
    if (!why_no_effect(option.name, header.options).empty()) continue;
    if (++changed > kMostNamed) continue;
    words += fmt::format("{}{} {}", changed == 1 ? " with " : ", ", option.name, found->second);
  }
  if (changed > kMostNamed) words += fmt::format(" and {} more", changed - kMostNamed);
  return words;
}

}  // namespace

std::string made_words(const RunHeader& header, double start_s) {
  std::string words =
      fmt::format("preset {}{}, seed {}", header.preset, changed_words(header), header.seed);
  if (header.started_at_s) {
    words += fmt::format(", gone on from {} after {:.1f} s",
                         fs::path(header.parent_run).filename().string(),
                         *header.started_at_s - start_s);
  }
  return words;
}

std::string foot_of(const FigureRun& run) {
  const RunEvaluation& evaluation = run.evaluation;
  const RunHeader& header = run.reader->header();
  std::string text =
      fmt::format("{} on {}, {}", header.flight, header.map, made_words(header, run.start_s));
  if (!evaluation.is_complete) text += " · stopped before its end";
  for (const std::string& remark : run.remarks) text += " · " + remark;
  if (run.has_truth()) {
    text += fmt::format(
        " · {} alignment · {} matched pairs, {} steps dropped",
        evaluation.alignment == Alignment::kNone ? "no" : enum_name(evaluation.alignment),
        evaluation.matched_pairs, evaluation.dropped_steps);
    if (evaluation.estimate) {
      text += fmt::format(" · position RMSE {:.2f} m",
                          evaluation.estimate->position_m.root_mean_square);
      if (evaluation.odometry) {
        text +=
            fmt::format(", odometry {:.2f} m", evaluation.odometry->position_m.root_mean_square);
      }
    }
  } else {
    text += fmt::format(" · {} steps, no truth", run.steps.size());
  }
  return text;
}

std::optional<Rigid2> pose_of(const RunStep& step, Source source) {
  switch (source) {
    case Source::kTruth:
      return step.truth_in_enu;
    case Source::kOdometry:
      return step.odometry_in_enu;
    case Source::kEstimate:
      break;
  }
  const Rigid2& mean = step.estimate.moments.mean;
  if (!is_finite(mean)) return std::nullopt;
  return mean;
}

Source source_of(LaidAt laid_at) {
  switch (laid_at) {
    case LaidAt::kOdometry:
      return Source::kOdometry;
    case LaidAt::kTruth:
      return Source::kTruth;
    case LaidAt::kEstimate:
      break;
  }
  return Source::kEstimate;
}

std::vector<Eigen::Vector2d> path_of(const FigureRun& run, Source source) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(run.steps.size());
  for (const RunStep& step : run.steps) {
    const auto pose = pose_of(step, source);
    points.push_back(pose ? pose->translation_m() : Eigen::Vector2d::Constant(std::nan("")));
  }
  return points;
}

}  // namespace nadir
