// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <string_view>

#include "core/eval/trajectory_error.h"

namespace nadir::detail {

/// One number of an error summary by the key under which JSON and CSV give it. NaN stands for
/// unknown.
struct ErrorKey {
  std::string_view key;
  double (*value)(const PoseErrorSummary& summary);
};

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// The promised keys first, in their order; what is new goes to the end.
inline constexpr std::array<ErrorKey, 24> kErrorKeys = {{
    {"position_mse_m2", [](const PoseErrorSummary& s) { return s.position_m.mean_square; }},
    {"position_rmse_m", [](const PoseErrorSummary& s) { return s.position_m.root_mean_square; }},
    {"position_mean_m", [](const PoseErrorSummary& s) { return s.position_m.mean; }},
    {"position_median_m", [](const PoseErrorSummary& s) { return s.position_m.median; }},
    {"position_p90_m", [](const PoseErrorSummary& s) { return s.position_m.p90; }},
    {"position_max_m", [](const PoseErrorSummary& s) { return s.position_m.maximum; }},
    {"orientation_mse_rad2",
     [](const PoseErrorSummary& s) { return s.orientation_rad.mean_square; }},
    {"orientation_median_rad", [](const PoseErrorSummary& s) { return s.orientation_rad.median; }},
    {"orientation_p90_rad", [](const PoseErrorSummary& s) { return s.orientation_rad.p90; }},
    {"recall_1m", [](const PoseErrorSummary& s) { return s.recall_1m; }},
    {"recall_3m", [](const PoseErrorSummary& s) { return s.recall_3m; }},
    {"recall_5m", [](const PoseErrorSummary& s) { return s.recall_5m; }},
    {"orientation_rmse_rad",
     [](const PoseErrorSummary& s) { return s.orientation_rad.root_mean_square; }},
    {"orientation_mean_rad", [](const PoseErrorSummary& s) { return s.orientation_rad.mean; }},
    {"orientation_max_rad", [](const PoseErrorSummary& s) { return s.orientation_rad.maximum; }},
    {"lateral_rmse_m", [](const PoseErrorSummary& s) { return s.lateral_m.root_mean_square; }},
    {"lateral_median_m", [](const PoseErrorSummary& s) { return s.lateral_m.median; }},
    {"lateral_p90_m", [](const PoseErrorSummary& s) { return s.lateral_m.p90; }},
    {"longitudinal_rmse_m",
     [](const PoseErrorSummary& s) { return s.longitudinal_m.root_mean_square; }},
    {"longitudinal_median_m", [](const PoseErrorSummary& s) { return s.longitudinal_m.median; }},
    {"longitudinal_p90_m", [](const PoseErrorSummary& s) { return s.longitudinal_m.p90; }},
    {"relative_segment_m",
     [](const PoseErrorSummary& s) { return s.relative ? s.relative->segment_m : kUnknown; }},
    {"relative_position_m_per_m",
     [](const PoseErrorSummary& s) {
       return s.relative ? s.relative->position_m_per_m : kUnknown;
     }},
    {"relative_orientation_rad_per_m",
     [](const PoseErrorSummary& s) {
       return s.relative ? s.relative->orientation_rad_per_m : kUnknown;
     }},
}};

}  // namespace nadir::detail
