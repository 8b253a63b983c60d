// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/base/angle.h"
#include "core/eval/report.h"

namespace nadir {
namespace {

constexpr double kDegreesPerRadian = Angle::radians(1.0).degrees();

/// A value with so many decimals in 12 places, its decimal point always in the same column.
std::string column(std::optional<double> value, int decimals) {
  if (!value || !std::isfinite(*value)) return fmt::format("{:>8}    ", "-");
  const int after_point = decimals > 0 ? decimals + 1 : 0;
  return fmt::format("{:>{}.{}f}{:>{}}", *value, 8 + after_point, decimals, "", 4 - after_point);
}

std::string row(std::string_view name,
                std::string_view unit,
                std::optional<double> odometry,
                std::optional<double> estimate,
                bool with_ratio = true) {
  std::optional<double> ratio;
  if (with_ratio && odometry && estimate && *odometry > 0.0) ratio = *estimate / *odometry;
  std::string text =
      fmt::format("  {:<28}{:<8}{}  {}", name, unit, column(odometry, 3), column(estimate, 3));
  if (with_ratio) text += "  " + column(ratio, 3);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

template <typename Value>
std::string error_row(const RunEvaluation& e,
                      std::string_view name,
                      std::string_view unit,
                      Value value,
                      bool with_ratio = true) {
  std::optional<double> odometry;  // of a run whose truth begins after its first step there is none
  if (e.odometry) odometry = value(*e.odometry);
  return row(name, unit, odometry, value(*e.estimate), with_ratio);
}

std::string statistics_rows(const RunEvaluation& e,
                            const std::string& name,
                            const std::string& unit,
                            const ErrorStatistics PoseErrorSummary::*part,
                            double factor) {
  const auto of = [&](const double ErrorStatistics::*which, double scale) {
    return [=](const PoseErrorSummary& s) { return s.*part.*which * scale; };
  };
  return error_row(e, name + " MSE", unit + "^2",
                   of(&ErrorStatistics::mean_square, factor * factor)) +
         error_row(e, name + " RMSE", unit, of(&ErrorStatistics::root_mean_square, factor)) +
         error_row(e, name + " mean", unit, of(&ErrorStatistics::mean, factor)) +
         error_row(e, name + " median", unit, of(&ErrorStatistics::median, factor)) +
         error_row(e, name + " 90th percentile", unit, of(&ErrorStatistics::p90, factor)) +
         error_row(e, name + " maximum", unit, of(&ErrorStatistics::maximum, factor));
}

std::string error_table(const RunEvaluation& e) {
  using Summary = PoseErrorSummary;
  std::string text =
      fmt::format("\n  {:<36}{:>12}  {:>12}  {:>12}\n", "", "odometry", "estimate", "ratio");
  text += statistics_rows(e, "position", "m", &Summary::position_m, 1.0);
  text += error_row(e, "lateral RMSE", "m",
                    [](const Summary& s) { return s.lateral_m.root_mean_square; });
  text += error_row(e, "longitudinal RMSE", "m",
                    [](const Summary& s) { return s.longitudinal_m.root_mean_square; });
  text += statistics_rows(e, "orientation", "deg", &Summary::orientation_rad, kDegreesPerRadian);
  text += error_row(
      e, "within 1 m", "%", [](const Summary& s) { return 100.0 * s.recall_1m; }, false);
  text += error_row(
      e, "within 3 m", "%", [](const Summary& s) { return 100.0 * s.recall_3m; }, false);
  text += error_row(
      e, "within 5 m", "%", [](const Summary& s) { return 100.0 * s.recall_5m; }, false);
  const bool has_drift = e.estimate->relative && (!e.odometry || e.odometry->relative);
  if (has_drift) {
    text += error_row(e, fmt::format("drift over {:.0f} m", e.estimate->relative->segment_m), "%",
                      [](const Summary& s) { return 100.0 * s.relative->position_m_per_m; });
    text += error_row(
        e, fmt::format("turn over {:.0f} m", e.estimate->relative->segment_m), "deg/m",
        [](const Summary& s) { return kDegreesPerRadian * s.relative->orientation_rad_per_m; });
  }
  return text;
}

std::string judgement(const RunEvaluation& e) {
  std::string text = "\n";
  const Consistency& c = e.consistency;
  if (c.nees_mean) {
    text += fmt::format(
        "  NEES mean      {:.2f} (95 % bounds of {} independent steps: {:.2f} to {:.2f})\n",
        *c.nees_mean, c.nees_steps, *c.nees_lower_95, *c.nees_upper_95);
  }
  if (c.excluded_steps > 0) {
    text += fmt::format("  NEES left out  {} steps with a singular or unknown covariance\n",
                        c.excluded_steps);
  }
  if (c.coverage_95) {
    text += fmt::format(
        "  coverage       {:.1f} % of {} steps with the truth inside the 95 % ellipse\n",
        100.0 * *c.coverage_95, c.coverage_steps);
  }
  if (c.coverage_excluded_steps > 0) {
    text +=
        fmt::format("  cov. left out  {} steps without a covariance\n", c.coverage_excluded_steps);
  }
  if (e.convergence.after_s) {
    text += fmt::format("  converged      after {:.1f} s and {:.1f} m\n", *e.convergence.after_s,
                        *e.convergence.after_m);
    text += e.convergence.lost_stretches == 0
                ? std::string("  lost again     never\n")
                : fmt::format("  lost again     {} times, {:.1f} m in all\n",
                              e.convergence.lost_stretches, e.convergence.lost_m);
  } else {
    text += "  converged      never\n";
  }
  return text;
}

std::string alignment_line(const RunEvaluation& e) {
  if (e.alignment == Alignment::kNone) return "  alignment      none\n";
  const auto words = [](const Similarity2& s) {
    return fmt::format("moved {:.2f} m east, {:.2f} m north, turned {:.3f} deg, scaled {:.5f}",
                       s.rigid.x_m, s.rigid.y_m, s.rigid.yaw_rad * kDegreesPerRadian, s.scale);
  };
  return fmt::format(
      "  alignment      {} (least squares on all pairs, so the errors are not those of a user)\n"
      "    estimate     {}\n    odometry     {}\n",
      enum_name(e.alignment), words(e.estimate_alignment), words(e.odometry_alignment));
}

std::string table(const RunEvaluation& e) {
  std::string text = fmt::format("{}{}\n", e.run, e.is_complete ? "" : " (stopped before its end)");
  text += fmt::format("  flight         {}\n  map            {}\n  preset, seed   {}, {}\n",
                      e.flight, e.map, e.preset, e.seed);
  text += fmt::format("  steps          {}: {} matched pairs, {} dropped\n", e.steps,
                      e.matched_pairs, e.dropped_steps);
  text += alignment_line(e);
  text += fmt::format("  flown          {:.1f} s", e.duration_s);
  if (e.matched_pairs > 0) text += fmt::format(", {:.1f} m", e.distance_m);
  if (e.update_rate_hz) text += fmt::format(", {:.2f} updates a second", *e.update_rate_hz);
  text += "\n";
  if (e.computing_ms_mean) {
    text += fmt::format("  computing      {:.2f} ms an update\n", *e.computing_ms_mean);
  }
  if (!e.estimate) return text + "\n  The truth is not known, so there are no errors.\n";
  return text + error_table(e) + judgement(e);
}

}  // namespace

std::string report_as_text(std::span<const RunEvaluation> evaluations) {
  std::string text;
  for (const RunEvaluation& evaluation : evaluations) {
    if (!text.empty()) text += "\n";
    text += table(evaluation);
  }
  return text;
}

}  // namespace nadir
