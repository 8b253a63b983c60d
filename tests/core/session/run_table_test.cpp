// SPDX-License-Identifier: Apache-2.0
#include "core/session/run_table.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "tests/core/session/made_run.h"

namespace nadir {
namespace run_table_test {

/// The rows of a table by the names of its columns.
std::vector<std::map<std::string, std::string>> rows_of(const std::string& table) {
  std::vector<std::map<std::string, std::string>> rows;
  std::istringstream lines(table);
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> fields(1);
    for (const char letter : line) {
      if (letter == ',') {
        fields.emplace_back();
      } else {
        fields.back() += letter;
      }
    }
    if (names.empty()) {
      names = fields;
      continue;
    }
    EXPECT_EQ(fields.size(), names.size()) << line;
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(names.size(), fields.size()); ++i)
      row[names[i]] = fields[i];
  }
  return rows;
}

TEST(RunTable, HasALineForEachStepWithItsNumbers) {
  const auto run = made_document(5, [](RunStep& step) {
    if (step.step == 3) {
      step.estimate.modes = {{0.75, step.estimate.moments}, {0.25, step.estimate.moments}};
      step.odometry_in_enu = Rigid2{1.5, 2.5, 0.125};
      step.was_resampled = true;
    }
  });
  const auto rows = rows_of(run_table(*run));
  ASSERT_EQ(rows.size(), 5U);
  const auto& row = rows[3];
  EXPECT_EQ(row.at("step"), "3");
  EXPECT_EQ(std::stod(row.at("time_s")), run->steps[3].time_s) << "every bit of it";
  EXPECT_EQ(std::stod(row.at("elapsed_s")), run->time_s[3]);
  EXPECT_EQ(row.at("estimate_x_enu_m"), "1.5");
  EXPECT_EQ(row.at("estimate_y_enu_m"), "0.1");
  EXPECT_EQ(row.at("truth_y_enu_m"), "0");
  EXPECT_EQ(row.at("odometry_yaw_enu_rad"), "0.125");
  EXPECT_EQ(row.at("y_error_enu_m"), "0.1");
  EXPECT_EQ(row.at("position_error_m"), "0.1");
  EXPECT_EQ(row.at("x_variance_enu_m2"), "0.25");
  EXPECT_EQ(row.at("yaw_variance_rad2"), "0.0009");
  EXPECT_NEAR(std::stod(row.at("nees")), 0.01 / 0.25, 1e-12);
  EXPECT_EQ(row.at("modes"), "2");
  EXPECT_EQ(row.at("heaviest_mass"), "0.75");
  EXPECT_EQ(row.at("particles"), "1000");
  EXPECT_EQ(row.at("was_resampled"), "1");
  EXPECT_EQ(row.at("topview_cells"), "100");
}

TEST(RunTable, LeavesEmptyWhatIsNotKnown) {
  const auto run = made_document(3, [](RunStep& step) {
    step.agreement.reset();
    step.update_ms = std::nan("");
    if (step.step == 1) step.truth_in_enu.reset();
  });
  const auto rows = rows_of(run_table(*run));
  EXPECT_EQ(rows[0].at("agreement"), "");
  EXPECT_EQ(rows[0].at("update_ms"), "");
  EXPECT_EQ(rows[0].at("odometry_x_enu_m"), "");
  EXPECT_EQ(rows[0].at("heaviest_mass"), "");
  EXPECT_EQ(rows[1].at("truth_x_enu_m"), "");
  EXPECT_EQ(rows[1].at("position_error_m"), "");
  EXPECT_EQ(rows[2].at("position_error_m"), "0.1") << "of its own step, not of the one before";
}

TEST(RunTable, NamesUnitAndFrameOfEveryLength) {
  const std::string table = run_table(*made_document(0));
  std::istringstream names(table.substr(0, table.find('\n')));
  const auto ends_with = [](const std::string& name, std::string_view end) {
    return name.size() >= end.size() &&
           name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  const std::set<std::string> without_unit = {"step",          "nees",      "modes",
                                              "heaviest_mass", "particles", "effective_sample_size",
                                              "was_resampled", "agreement", "topview_cells"};
  // Of no direction, and so of no frame: a distance, and angles whose difference is the same in all of them.
  const std::set<std::string> without_frame = {"position_error_m", "yaw_error_rad",
                                               "yaw_variance_rad2"};
  for (std::string name; std::getline(names, name, ',');) {
    if (without_unit.count(name) > 0) continue;
    const bool is_time = ends_with(name, "_s") || ends_with(name, "_ms");
    const bool has_unit = is_time || ends_with(name, "_m") || ends_with(name, "_m2") ||
                          ends_with(name, "_rad") || ends_with(name, "_rad2");
    EXPECT_TRUE(has_unit) << name;
    const bool has_frame = name.find("_enu_") != std::string::npos;
    EXPECT_EQ(has_frame, !is_time && without_frame.count(name) == 0) << name;
  }
}

TEST(RunTable, OfNoStepsIsOneLine) {
  const std::string table = run_table(*made_document(0));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1);
}

}  // namespace run_table_test
}  // namespace nadir
