// SPDX-License-Identifier: Apache-2.0
#include "core/insight/class_importance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/require.h"
#include "core/eval/trajectory_error.h"
#include "core/insight/stretch_rerun.h"
#include "core/map/class_statistics.h"

namespace nadir {
namespace {

/// Reads another recording and hides one class.
class HiddenClassFlight : public FlightRecording {
 public:
  HiddenClassFlight(std::shared_ptr<const FlightRecording> flight, ClassId id)
      : FlightRecording(flight->description()), flight_(std::move(flight)), id_(id) {}
  [[nodiscard]] Result<SemanticFrame> load(std::size_t frame) const override {
    auto loaded = flight_->load(frame);
    if (loaded) {
      auto& labels = loaded->labels.values();
      std::replace(labels.begin(), labels.end(), id_, ClassId{kUnclassified});
    }
    return loaded;
  }

 private:
  std::shared_ptr<const FlightRecording> flight_;
  ClassId id_;
};

/// Of one run of the filter.
struct RunQuality {
  std::optional<double> error_m, lost_share;
  double sigma_m = 0.0;
};

/// By seed.
struct QualityOfSeeds {
  std::vector<double> error_m, sigma_m, lost_share;

  void add(const RunQuality& quality) {
    if (quality.error_m) error_m.push_back(*quality.error_m);
    if (quality.lost_share) lost_share.push_back(*quality.lost_share);
    sigma_m.push_back(quality.sigma_m);
  }
  [[nodiscard]] LocalisedQuality means() const {
    return {mean_over_seeds(error_m), mean_over_seeds(sigma_m), mean_over_seeds(lost_share)};
  }
};

Result<RunQuality> run_once(const FlightRecording& flight,
                            const std::shared_ptr<const MapIndex>& map,
                            const LocaliseRequest& request,
                            const WorkContext& context) {
  double error_sum_m = 0.0;
  double sigma_sum_m = 0.0;
  std::size_t known = 0;
  std::size_t lost = 0;
  std::size_t steps = 0;
  const auto judge = [&](const RunStep& step) -> Result<void> {
    const PoseMoments& moments = step.estimate.moments;
    sigma_sum_m += std::sqrt(moments.covariance(0, 0) + moments.covariance(1, 1));
    ++steps;
    if (!step.truth_in_enu) return {};
    const double error_m = pose_error(moments.mean, *step.truth_in_enu).head<2>().norm();
    error_sum_m += error_m;
    ++known;
    if (error_m > kLostM) ++lost;
    return {};
  };
  const auto summary = localise_flight(flight, map, request, judge, context);
  if (!summary) return forward_error(summary);
  RunQuality quality;
  quality.sigma_m = sigma_sum_m / static_cast<double>(steps);
  if (known > 0) {
    quality.error_m = error_sum_m / static_cast<double>(known);
    quality.lost_share = static_cast<double>(lost) / static_cast<double>(known);
  }
  return quality;
}

/// Counts runs, for progress.
struct RunCounter {
  const WorkContext& context;
  std::size_t done = 0, all = 1;
  std::string activity;

  /// What one run is told: its own part of the whole progress.
  [[nodiscard]] WorkContext next() {
    const auto before = static_cast<double>(done++);
    return {.stop = context.stop, .progress = [this, before](double fraction, const std::string&) {
              context.report((before + fraction) / static_cast<double>(all), activity);
            }};
  }
};

Result<QualityOfSeeds> run_seeds(const ImportanceTask& task,
                                 const FlightRecording& flight,
                                 const std::shared_ptr<const MapIndex>& map,
                                 LocaliseRequest request,
                                 RunCounter& counter) {
  QualityOfSeeds qualities;
  for (const std::uint64_t seed : task.seeds) {
    request.options.localiser.seed = seed;
    const auto quality = run_once(flight, map, request, counter.next());
    if (!quality) return forward_error(quality);
    qualities.add(*quality);
  }
  return qualities;
}

SeedMean mean_difference(const std::vector<double>& without, const std::vector<double>& with) {
  std::vector<double> differences;
  differences.reserve(with.size());
  for (std::size_t i = 0; i < std::min(without.size(), with.size()); ++i) {
    differences.push_back(without[i] - with[i]);
  }
  return mean_over_seeds(differences);
}

std::vector<ClassId> classes_to_leave_out(const ImportanceTask& task) {
  const ClassStatistics& statistics = task.map->statistics();
  std::vector<ClassId> classes;
  for (ClassId id = 0; id < kClassCount; ++id) {
    const bool is_asked =
        task.classes.empty() || std::count(task.classes.begin(), task.classes.end(), id) > 0;
    if (is_asked && statistics.cells[id] > 0 && statistics.present_classes() > 2) {
      classes.push_back(id);
    }
  }
  return classes;
}

Result<LocaliseRequest> request_of(const ImportanceTask& task) {
  LocaliseRequest request;
  request.options = task.options;
  request.prior = task.prior;
  request.resume_after = task.resume_after;
  request.record_particles = false;
  request.record_topviews = false;
  if (!task.to_s) return request;
  const double from_s = task.resume_after ? task.resume_after->after.time_s
                                          : -std::numeric_limits<double>::infinity();
  request.most_frames = frames_between(task.flight->description(), from_s, *task.to_s);
  if (*request.most_frames == 0) {
    return fail(ErrorCode::kInvalidOptions, "no frame of the flight comes before {:.3f} s",
                *task.to_s);
  }
  return request;
}

}  // namespace

std::shared_ptr<const FlightRecording> flight_without_class(
    std::shared_ptr<const FlightRecording> flight, ClassId id) {
  NADIR_REQUIRE(flight != nullptr);
  return std::make_shared<const HiddenClassFlight>(std::move(flight), id);
}

std::shared_ptr<const MapIndex> map_without_class(const OverheadMap& map, ClassId id) {
  OverheadMap hidden = map;
  std::replace(hidden.labels.values().begin(), hidden.labels.values().end(), id,
               ClassId{kUnclassified});
  return std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(std::move(hidden)));
}

bool SeedMean::is_more_than_chance() const {
  // Student's t at 97.5 % for 1, 2, ... degrees of freedom; the last stands for more, on the safe side.
  constexpr std::array<double, 20> kQuantiles = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
                                                 2.306,  2.262, 2.228, 2.201, 2.179, 2.160, 2.145,
                                                 2.131,  2.120, 2.110, 2.101, 2.093, 2.086};
  if (!standard_error || seeds < 2) return false;
  const auto freedom = std::min(static_cast<std::size_t>(seeds) - 1, kQuantiles.size());
  return std::abs(mean) > kQuantiles[freedom - 1] * *standard_error;
}

SeedMean mean_over_seeds(const std::vector<double>& values) {
  SeedMean result;
  result.seeds = static_cast<int>(values.size());
  if (values.empty()) return result;
  const auto count = static_cast<double>(values.size());
  for (const double value : values) result.mean += value / count;
  if (values.size() == 1) return result;
  double squares = 0.0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  result.standard_error = std::sqrt(squares / (count - 1.0) / count);
  return result;
}

Result<ImportanceTable> class_importance(
    const ImportanceTask& task,
    const WorkContext& context,
    const std::function<void(const ImportanceTable&)>& publish) {
  NADIR_REQUIRE(task.flight != nullptr && task.map != nullptr);
  if (task.seeds.empty()) {
    return fail(ErrorCode::kInvalidOptions, "class importance: no seed to run with");
  }
  const auto request = request_of(task);
  if (!request) return forward_error(request);
  const std::vector<ClassId> classes = classes_to_leave_out(task);
  const ClassStatistics& statistics = task.map->statistics();
  const ClassWeights weights = importance_weights(statistics, task.options.localiser.alpha);
  RunCounter counter{context, 0, task.seeds.size() * (classes.size() + 1), "with all classes"};
  const auto with_all = run_seeds(task, *task.flight, task.map, *request, counter);
  if (!with_all) return forward_error(with_all);
  ImportanceTable table{.with_all = with_all->means(), .classes = {}};
  if (publish) publish(table);
  for (const ClassId id : classes) {
    counter.activity = fmt::format("without {}", class_info(id).name);
    const auto without = run_seeds(task, *flight_without_class(task.flight, id),
                                   map_without_class(task.map->map(), id), *request, counter);
    if (!without) return forward_error(without);
    table.classes.push_back(
        {.id = id,
         .weight = weights[id],
         .share = statistics.share_of_classified(id),
         .without = without->means(),
         .error_change_m = mean_difference(without->error_m, with_all->error_m),
         .sigma_change_m = mean_difference(without->sigma_m, with_all->sigma_m)});
    if (publish) publish(table);
  }
  return table;
}

}  // namespace nadir
