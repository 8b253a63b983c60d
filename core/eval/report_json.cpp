// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "core/eval/report.h"
#include "core/eval/report_keys.h"

namespace nadir {
namespace {

using Json = nlohmann::ordered_json;

Json json_number(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json errors(const std::optional<PoseErrorSummary>& summary) {
  Json object = Json::object();
  for (const detail::ErrorKey& entry : detail::kErrorKeys) {
    object[std::string(entry.key)] = summary ? json_number(entry.value(*summary)) : Json(nullptr);
  }
  return object;
}

Json alignment_of(const RunEvaluation& evaluation, const Similarity2& applied) {
  if (evaluation.alignment == Alignment::kNone) return nullptr;
  return {{"x_m", applied.rigid.x_m},
          {"y_m", applied.rigid.y_m},
          {"yaw_rad", applied.rigid.yaw_rad},
          {"scale", applied.scale}};
}

Json run_object(const RunEvaluation& e) {
  return {{"flight", e.flight},
          {"map", e.map},
          {"preset", e.preset},
          {"seed", e.seed},
          {"steps", e.steps},
          {"matched_pairs", e.matched_pairs},
          {"alignment", enum_name(e.alignment)},
          {"estimate", errors(e.estimate)},
          {"odometry", errors(e.odometry)},
          {"nees_mean", json_number(e.consistency.nees_mean)},
          {"coverage_95", json_number(e.consistency.coverage_95)},
          {"converged_after_s", json_number(e.convergence.after_s)},
          {"converged_after_m", json_number(e.convergence.after_m)},
          {"update_rate_hz", json_number(e.update_rate_hz)},
          {"is_complete", e.is_complete},
          {"dropped_steps", e.dropped_steps},
          {"duration_s", e.duration_s},
          {"distance_m", e.matched_pairs > 0 ? Json(e.distance_m) : Json(nullptr)},
          {"estimate_alignment", alignment_of(e, e.estimate_alignment)},
          {"odometry_alignment", alignment_of(e, e.odometry_alignment)},
          {"nees_lower_95", json_number(e.consistency.nees_lower_95)},
          {"nees_upper_95", json_number(e.consistency.nees_upper_95)},
          {"nees_steps", e.consistency.nees_steps},
          {"nees_excluded_steps", e.consistency.excluded_steps},
          {"lost_stretches", e.convergence.lost_stretches},
          {"lost_m", e.convergence.lost_m},
          {"coverage_steps", e.consistency.coverage_steps}};
}

}  // namespace

std::string report_as_json(std::span<const RunEvaluation> evaluations) {
  Json runs = Json::array();
  for (const RunEvaluation& evaluation : evaluations) runs.push_back(run_object(evaluation));
  const Json report = {{"runs", std::move(runs)}};
  // Names come out of files: bytes that are no UTF-8 must not throw here.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace nadir
