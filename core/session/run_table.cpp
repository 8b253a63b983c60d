// SPDX-License-Identifier: Apache-2.0
#include "core/session/run_table.h"

#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>

namespace nadir {
namespace {

constexpr std::array<std::string_view, 31> kTableColumns = {"step",
                                                            "time_s",
                                                            "elapsed_s",
                                                            "estimate_x_enu_m",
                                                            "estimate_y_enu_m",
                                                            "estimate_yaw_enu_rad",
                                                            "truth_x_enu_m",
                                                            "truth_y_enu_m",
                                                            "truth_yaw_enu_rad",
                                                            "odometry_x_enu_m",
                                                            "odometry_y_enu_m",
                                                            "odometry_yaw_enu_rad",
                                                            "x_error_enu_m",
                                                            "y_error_enu_m",
                                                            "yaw_error_rad",
                                                            "position_error_m",
                                                            "nees",
                                                            "x_variance_enu_m2",
                                                            "xy_covariance_enu_m2",
                                                            "y_variance_enu_m2",
                                                            "xyaw_covariance_enu_m_rad",
                                                            "yyaw_covariance_enu_m_rad",
                                                            "yaw_variance_rad2",
                                                            "modes",
                                                            "heaviest_mass",
                                                            "effective_sample_size",
                                                            "particles",
                                                            "was_resampled",
                                                            "agreement",
                                                            "topview_cells",
                                                            "update_ms"};

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

/// Adds fields to a line.
class TableLine {
 public:
  explicit TableLine(std::string& text) : text_(text) {}
  void add(double value) {
    separate();
    if (std::isfinite(value)) fmt::format_to(std::back_inserter(text_), "{}", value);
  }
  void add_count(std::size_t value) {
    separate();
    fmt::format_to(std::back_inserter(text_), "{}", value);
  }
  void add(const std::optional<Rigid2>& pose) {
    add(pose ? pose->x_m : kNotKnown);
    add(pose ? pose->y_m : kNotKnown);
    add(pose ? pose->yaw_rad : kNotKnown);
  }
  void end() { text_ += '\n'; }

 private:
  void separate() {
    if (!is_first_) text_ += ',';
    is_first_ = false;
  }
  std::string& text_;
  bool is_first_ = true;
};

}  // namespace

std::string run_table(const RunDocument& run) {
  std::string text;
  for (const std::string_view column : kTableColumns) {
    text += (text.empty() ? "" : ",") + std::string(column);
  }
  text += '\n';
  for (std::size_t i = 0; i < run.steps.size(); ++i) {
    const RunStep& step = run.steps[i];
    const Eigen::Matrix3d& covariance = step.estimate.moments.covariance;
    const auto error = run.error_index_of(i);
    const auto error_of = [&](const std::vector<double>& series) {
      return error ? series[*error] : kNotKnown;
    };
    TableLine line(text);
    line.add_count(static_cast<std::size_t>(step.step));
    line.add(step.time_s);
    line.add(run.time_s[i]);
    line.add(std::optional<Rigid2>(step.estimate.moments.mean));
    line.add(step.truth_in_enu);
    line.add(step.odometry_in_enu);
    line.add(error_of(run.errors.x_error_m));
    line.add(error_of(run.errors.y_error_m));
    line.add(error_of(run.errors.yaw_error_rad));
    line.add(error_of(run.errors.position_error_m));
    line.add(error_of(run.errors.nees));
    line.add(covariance(0, 0));
    line.add(covariance(0, 1));
    line.add(covariance(1, 1));
    line.add(covariance(0, 2));
    line.add(covariance(1, 2));
    line.add(covariance(2, 2));
    line.add_count(step.estimate.modes.size());
    line.add(step.estimate.modes.empty() ? kNotKnown : step.estimate.modes.front().mass);
    line.add(step.effective_sample_size);
    line.add_count(static_cast<std::size_t>(step.particle_count));
    line.add_count(step.was_resampled ? 1 : 0);
    line.add(step.agreement.value_or(kNotKnown));
    line.add_count(static_cast<std::size_t>(step.topview_cells));
    line.add(step.update_ms);
    line.end();
  }
  return text;
}

}  // namespace nadir
