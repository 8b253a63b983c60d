// SPDX-License-Identifier: Apache-2.0
#include "core/session/run_table.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <sstream>

#include "tests/core/session/made_run.h"

namespace nadir {
namespace {

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
  EXPECT_EQ(row.at("estimate_x_m"), "1.5");
  EXPECT_EQ(row.at("estimate_y_m"), "0.1");
  EXPECT_EQ(row.at("truth_y_m"), "0");
  EXPECT_EQ(row.at("odometry_yaw_rad"), "0.125");
  EXPECT_EQ(row.at("y_error_m"), "0.1");
  EXPECT_EQ(row.at("position_error_m"), "0.1");
  EXPECT_EQ(row.at("x_variance_m2"), "0.25");
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
  EXPECT_EQ(rows[0].at("odometry_x_m"), "");
  EXPECT_EQ(rows[0].at("heaviest_mass"), "");
  EXPECT_EQ(rows[1].at("truth_x_m"), "");
  EXPECT_EQ(rows[1].at("position_error_m"), "");
  EXPECT_EQ(rows[2].at("position_error_m"), "0.1") << "of its own step, not of the one before";
}

TEST(RunTable, OfNoStepsIsOneLine) {
  const std::string table = run_table(*made_document(0));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1);
}

}  // namespace
}  // namespace nadir
