// SPDX-License-Identifier: Apache-2.0
// Runs that somebody edited by hand or wrote with another program: one sentence that names file, table
// and row, or an evaluation without NaN; never a crash.
#include <gmock/gmock.h>

#include "core/eval/report.h"
#include "core/run/evaluate_run.h"
#include "tests/core/run/recorded_run.h"
#include "tests/core/run/run_sql.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace edited_run_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class EditedRun : public testing::Test {
 protected:
  /// Evaluates a run of 31 steps after this SQL.
  [[nodiscard]] Result<RunEvaluation> evaluated(const std::string& sql) const {
    record_run(path_, 31);
    EXPECT_EQ(run_sql(path_, sql), "") << sql;
    return evaluate_run_file(path_);
  }
  /// What is said about it after the name of the file.
  [[nodiscard]] std::string fault(const std::string& sql) const {
    const auto evaluation = evaluated(sql);
    EXPECT_EQ(error_code(evaluation), ErrorCode::kMalformed) << sql;
    const std::string text = error_text(evaluation);
    EXPECT_THAT(text, StartsWith(path_.string() + ": ")) << sql;
    return text.substr(std::min(text.size(), path_.string().size() + 2));
  }
  /// The fault of one column of row 7.
  [[nodiscard]] std::string fault_of(const std::string& column, const std::string& value) const {
    const std::string text = fault("UPDATE step SET " + column + " = " + value + " WHERE step = 7");
    const std::string begin = "table step, row 7: " + column + " is ";
    EXPECT_THAT(text, StartsWith(begin));
    return text.substr(std::min(text.size(), begin.size()));
  }

  ScratchFolder folder_;
  fs::path path_ = folder_.path() / "R.nadir";
};

TEST_F(EditedRun, TimesThatRepeatOrGoBackAreNamed) {
  EXPECT_EQ(
      fault("UPDATE step SET time_s = 0.25 WHERE step = 2; UPDATE step SET time_s = 0.25 WHERE "
            "step = 3"),
      "table step, row 3: time_s is 0.25, not after the 0.25 of row 2");
  EXPECT_EQ(fault("UPDATE step SET time_s = -4 WHERE step = 8"),
            "table step, row 8: time_s is -4, not after the 0.7000000000000001 of row 7");
  EXPECT_THAT(fault("UPDATE step SET time_s = 99 WHERE step = 8"), HasSubstr("row 9: time_s is"));
}

TEST_F(EditedRun, TextAndBlobsInPlaceOfNumbersAreNamed) {
  EXPECT_EQ(fault_of("time_s", "'noon'"), "noon, not a number");
  EXPECT_EQ(fault_of("estimate_x_m", "''"), ", not a number");
  EXPECT_EQ(fault_of("truth_yaw_rad", "'north'"), "north, not a number");
  EXPECT_EQ(fault_of("odometry_y_m", "'1,5'"), "1,5, not a number");
  EXPECT_EQ(fault_of("covariance_xy_m2", "'nan'"), "nan, not a number");
  EXPECT_EQ(fault_of("effective_sample_size", "'many'"), "many, not a number");
  EXPECT_EQ(fault_of("update_ms", "'long'"), "long, not a number");
  EXPECT_EQ(fault_of("agreement", "x'4142'"), "AB, not a number");
  EXPECT_THAT(fault_of("topview_cells", "'few'"), StartsWith("few, not a whole number"));
  EXPECT_THAT(fault_of("was_resampled", "'yes'"), StartsWith("yes, not a whole number"));
  EXPECT_THAT(fault_of("particle_count", "2.5"), StartsWith("2.5, not a whole number"));
  EXPECT_THAT(fault_of("particle_count", "3000000000"), StartsWith("3000000000, not a whole"));
  EXPECT_LT(fault_of("time_s", "'" + std::string(100'000, 'x') + "'").size(), 100U);
}

TEST_F(EditedRun, TextThatIsANumberIsANumber) {
  const auto evaluation = evaluated(
      "UPDATE step SET estimate_x_m = '507.1', time_s = '0.7' WHERE "
      "step = 7");
  ASSERT_TRUE(evaluation) << error_text(evaluation);
  EXPECT_NEAR(evaluation->estimate->longitudinal_m.maximum, 0.1, 1e-9);
}

TEST_F(EditedRun, PosesThatAreNoneAreNamed) {
  EXPECT_EQ(fault_of("truth_x_m", "NULL"), "NULL, not a finite number") << "part of a truth";
  EXPECT_EQ(fault_of("truth_x_m", "-9e999"), "-Inf, not a finite number");
  EXPECT_EQ(fault_of("odom_x_m", "9e999"), "Inf, not a finite number");
  EXPECT_EQ(fault_of("estimate_y_m", "1e300"), "1.0e+300, farther than any place on Earth");
}

TEST_F(EditedRun, ColumnsWithoutTheirRulesAreReadLikeAnyOther) {
  // Another program need not have declared NOT NULL, nor any type.
  record_run(path_, 3);
  const std::string made = run_sql(path_,
                                   "CREATE TABLE other AS SELECT * FROM step; DROP TABLE step; "
                                   "ALTER TABLE other RENAME TO step; "
                                   "UPDATE step SET time_s = 'x' WHERE step = 1");
  EXPECT_EQ(made, "");
  const auto evaluation = evaluate_run_file(path_);
  EXPECT_EQ(error_code(evaluation), ErrorCode::kMalformed) << error_text(evaluation);
  EXPECT_THAT(error_text(evaluation), StartsWith(path_.string() + ": "));
}

TEST_F(EditedRun, CovariancesThatAreNoneAreNamed) {
  EXPECT_EQ(fault_of("covariance_xx_m2", "-0.25"), "-0.25, and a variance is not negative");
  EXPECT_EQ(fault_of("covariance_yaw_yaw_rad2", "-1e-300"),
            "-1.0e-300, and a variance is not negative");
  EXPECT_EQ(fault_of("covariance_xy_m2", "0.3"), "0.3, more than the two variances allow");
  EXPECT_EQ(fault_of("covariance_y_yaw_m_rad", "-1"), "-1.0, more than the two variances allow");
  EXPECT_EQ(fault("UPDATE step SET covariance_xx_m2 = 0 WHERE step = 7"),
            "table step, row 7: covariance_xy_m2 is 0.01, more than the two variances allow");
  // Each pair is possible, the three are not.
  EXPECT_THAT(fault("UPDATE step SET covariance_xx_m2 = 1, covariance_yy_m2 = 1, "
                    "covariance_yaw_yaw_rad2 = 1, covariance_xy_m2 = 0.9, covariance_x_yaw_m_rad = "
                    "0.9, covariance_y_yaw_m_rad = -0.9 WHERE step = 7"),
              AllOf(StartsWith("table step, row 7: its six covariances"),
                    EndsWith("(the matrix has a negative eigenvalue)")));
}

TEST_F(EditedRun, CovariancesThatAreSingularOrUnknownAreLeftOutAndCounted) {
  for (const char* covariance :
       {"covariance_xx_m2 = NULL", "covariance_xx_m2 = 9e999", "covariance_x_yaw_m_rad = NULL",
        "covariance_xx_m2 = 0, covariance_xy_m2 = 0, covariance_x_yaw_m_rad = 0",
        "covariance_xx_m2 = 0.25, covariance_yy_m2 = 0.25, covariance_xy_m2 = 0.25, "
        "covariance_x_yaw_m_rad = 0, covariance_y_yaw_m_rad = 0",
        "covariance_xx_m2 = 0.25, covariance_yy_m2 = 0.25, covariance_xy_m2 = 0.25000000000001, "
        "covariance_x_yaw_m_rad = 0, covariance_y_yaw_m_rad = 0"}) {
    const auto evaluation =
        evaluated(std::string("UPDATE step SET ") + covariance + " WHERE step < 10");
    ASSERT_TRUE(evaluation) << error_text(evaluation);
    EXPECT_EQ(evaluation->consistency.excluded_steps, 10U) << covariance;
    EXPECT_EQ(evaluation->consistency.nees_steps, 21U) << covariance;
    EXPECT_TRUE(std::isfinite(*evaluation->consistency.nees_mean));
    const std::string json = report_as_json(std::vector{*evaluation});
    EXPECT_THAT(json, AllOf(HasSubstr("\"nees_excluded_steps\": 10"), Not(HasSubstr("nan"))));
    EXPECT_THAT(json, Not(HasSubstr("\"nees_mean\": null")));
  }
}

TEST_F(EditedRun, WhatMayBeUnknownLeavesNoNaNBehind) {
  const auto evaluation = evaluated(
      "UPDATE step SET update_ms = NULL, agreement = NULL, effective_sample_size = NULL WHERE step "
      "> "
      "0; UPDATE step SET truth_x_m = NULL, truth_y_m = NULL, truth_yaw_rad = NULL WHERE step = 3");
  ASSERT_TRUE(evaluation) << error_text(evaluation);
  EXPECT_EQ(evaluation->computing_ms_mean, 12.5) << "of the one step that says";
  EXPECT_EQ(evaluation->dropped_steps, 1U);
  const auto silent = evaluated("UPDATE step SET update_ms = NULL");
  ASSERT_TRUE(silent) << error_text(silent);
  EXPECT_FALSE(silent->computing_ms_mean);
}

TEST_F(EditedRun, SharesOutsideZeroToOneAndNegativeAmountsAreNamed) {
  EXPECT_EQ(fault_of("agreement", "1.5"), "1.5, not a share from 0 to 1");
  EXPECT_EQ(fault_of("update_ms", "-3"), "-3.0, not a finite number from 0 up");
  EXPECT_EQ(fault_of("effective_sample_size", "9e999"), "Inf, not a finite number from 0 up");
}

TEST_F(EditedRun, ModesAreCheckedLikeSteps) {
  const std::string row = "table mode, row of step 7 and rank 1: ";
  EXPECT_EQ(fault("UPDATE mode SET mass = 'half' WHERE step = 7 AND rank = 1"),
            row + "mass is half, not a number");
  EXPECT_EQ(fault("UPDATE mode SET mass = -0.5 WHERE step = 7 AND rank = 1"),
            row + "mass is -0.5, not a share from 0 to 1");
  EXPECT_EQ(fault("UPDATE mode SET covariance_yy_m2 = -1 WHERE step = 7 AND rank = 1"),
            row + "covariance_yy_m2 is -1.0, and a variance is not negative");
  EXPECT_EQ(fault("UPDATE mode SET step = 99 WHERE step = 30 AND rank = 1"),
            "table mode, row of step 99 and rank 1: belongs to no step or comes twice");
}

TEST_F(EditedRun, NumbersOfTableAboutAreNumbers) {
  EXPECT_EQ(fault("UPDATE about SET value = 'lucky' WHERE key = 'seed'"),
            "table about, row seed: lucky is no number from 0 to 18446744073709551615");
  EXPECT_EQ(fault("UPDATE about SET value = '12 ' WHERE key = 'seed'"),
            "table about, row seed: 12  is no number from 0 to 18446744073709551615");
  EXPECT_EQ(fault("UPDATE about SET value = 'nan' WHERE key = 'plane_latitude_deg'"),
            "table about, row plane_latitude_deg: nan is no number from -90 to 90");
  EXPECT_EQ(fault("UPDATE about SET value = '200' WHERE key = 'plane_longitude_deg'"),
            "table about, row plane_longitude_deg: 200 is no number from -180 to 180");
  EXPECT_EQ(fault("UPDATE about SET value = '' WHERE key = 'plane_longitude_deg'"),
            "table about, row plane_longitude_deg: an empty text is no number from -180 to 180");
  const auto bare = evaluated("DELETE FROM about");
  ASSERT_TRUE(bare) << error_text(bare);
  EXPECT_FALSE(bare->is_complete);
}

}  // namespace edited_run_test
}  // namespace nadir
