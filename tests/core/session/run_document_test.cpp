// SPDX-License-Identifier: Apache-2.0
#include "core/session/run_document.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/eval/report.h"
#include "core/run/evaluate_run.h"
#include "tests/core/run/recorded_run.h"
#include "tests/core/run/run_sql.h"
#include "tests/core/session/made_run.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace run_document_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Document = std::shared_ptr<const RunDocument>;

class RunFileDocument : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path() const { return scratch_.path() / "R.nadir"; }
  [[nodiscard]] Document load() const {
    auto run = RunDocument::load(path());
    if (!run) throw std::runtime_error(run.error().message);
    return *run;
  }
  [[nodiscard]] static Document grown(const Document& earlier) {
    auto run = RunDocument::grown(earlier);
    if (!run) throw std::runtime_error(run.error().message);
    return *run;
  }
  /// A run that is being written.
  [[nodiscard]] RunWriter begin() const {
    auto writer = RunWriter::create(path(), example_header());
    if (!writer) throw std::runtime_error(writer.error().message);
    return std::move(*writer);
  }
  static void add(RunWriter& writer, int first, int end) {
    for (int i = first; i < end; ++i) {
      if (const auto written = writer.write(example_step(i)); !written) {
        throw std::runtime_error(written.error().message);
      }
    }
  }
  static void expect_same(const Document& a, const Document& b) {
    EXPECT_EQ(a->header, b->header);
    EXPECT_EQ(a->is_complete, b->is_complete);
    EXPECT_EQ(a->time_s, b->time_s);
    EXPECT_EQ(a->errors.position_error_m, b->errors.position_error_m);
    EXPECT_EQ(a->errors.nees, b->errors.nees);
    EXPECT_EQ(a->series.agreement, b->series.agreement);
    EXPECT_EQ(a->gaps, b->gaps);
    EXPECT_EQ(report_as_json(std::vector{a->evaluation}),
              report_as_json(std::vector{b->evaluation}));
    ASSERT_EQ(a->steps.size(), b->steps.size());
    for (std::size_t i = 0; i < a->steps.size(); ++i) {
      EXPECT_EQ(a->steps[i].estimate.modes.size(), b->steps[i].estimate.modes.size());
      EXPECT_EQ(a->steps[i].time_s, b->steps[i].time_s);
    }
    ASSERT_EQ(a->worst_moments.size(), b->worst_moments.size());
    for (std::size_t i = 0; i < a->worst_moments.size(); ++i) {
      EXPECT_EQ(a->worst_moments[i].words, b->worst_moments[i].words);
    }
  }

  ScratchFolder scratch_;
};

TEST_F(RunFileDocument, HoldsWhatTheFileSaysAndWhatTheEvaluationMakesOfIt) {
  record_run(path(), 40, 5);
  const Document run = load();
  EXPECT_EQ(run->name, "R");
  EXPECT_EQ(run->path, path());
  EXPECT_EQ(run->header, example_header());
  EXPECT_TRUE(run->is_complete);
  ASSERT_EQ(run->steps.size(), 40U);
  EXPECT_FALSE(run->steps[3].particles) << "only StepCache decodes them";
  EXPECT_EQ(run->steps[3].estimate.modes.size(), 2U);
  EXPECT_EQ(report_as_json(std::vector{run->evaluation}),
            report_as_json(std::vector{*evaluate_run_file(path())}));
  EXPECT_EQ(run->errors.size(), 40U);
  EXPECT_NEAR(run->errors.position_error_m[7], std::hypot(0.1, 1.0 / 3.0), 1e-12);
  EXPECT_NEAR(run->median_period_s, 0.1, 1e-12);
  EXPECT_THAT(run->gaps, IsEmpty());
  EXPECT_NEAR(run->duration_s(), 3.9, 1e-12);
  EXPECT_TRUE(run->has_truth());
}

TEST_F(RunFileDocument, SaysWhatIsNotKnownAsNaN) {
  const auto run = made_document(3, [](RunStep& step) {
    if (step.step != 1) return;
    step.agreement.reset();
    step.effective_sample_size = std::nan("");
    step.estimate.moments.covariance.setConstant(std::nan(""));
  });
  EXPECT_THAT(run->series.agreement, ElementsAre(0.89, ::testing::IsNan(), 0.91));
  EXPECT_TRUE(std::isnan(run->series.effective_sample_size[1]));
  EXPECT_THAT(run->series.position_sigma_m, ElementsAre(0.5, ::testing::IsNan(), 0.5));
  EXPECT_THAT(run->series.x_sigma_m, ElementsAre(0.5, ::testing::IsNan(), 0.5));
  EXPECT_NEAR(run->series.yaw_sigma_rad[0], 0.03, 1e-12);
  EXPECT_THAT(run->series.update_ms, ElementsAre(10.0, 10.0, 10.0));
  EXPECT_THAT(run->series.topview_cells, ElementsAre(100.0, 100.0, 100.0));
  EXPECT_THAT(run->series.particle_count, ElementsAre(1000.0, 1000.0, 1000.0));
}

TEST_F(RunFileDocument, FindsTheLatestStepAtATime) {
  const auto run = made_document(10);  // a clock that began at 100 s
  EXPECT_EQ(run->start_clock_s, 100.0);
  EXPECT_EQ(run->latest_at(-0.01), std::nullopt);
  EXPECT_EQ(run->index_at(-0.01), 0U);
  EXPECT_EQ(run->latest_at(0.0), 0U);
  EXPECT_EQ(run->latest_at(0.35), 3U);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(run->latest_at(0.1 * static_cast<double>(i)), i) << "rounding loses no step";
    EXPECT_EQ(run->latest_at(run->time_s[i]), i);
  }
  EXPECT_EQ(run->latest_at(1e9), 9U);
  EXPECT_DOUBLE_EQ(run->clock_s(0.5), 100.5);
  const auto empty = made_document(0);
  EXPECT_EQ(empty->index_at(0.0), std::nullopt);
  EXPECT_EQ(empty->duration_s(), 0.0);
}

TEST_F(RunFileDocument, KnowsTheGroundAroundItsPathsFromEverySide) {
  const auto run = made_document(40, [](RunStep& step) {
    const double t = 0.3 * step.step;
    step.estimate.moments.mean = {10.0 * std::cos(t), 4.0 * std::sin(3.0 * t), t};
    step.truth_in_enu = Rigid2{9.0 * std::cos(t) + 0.1 * t, 5.0 * std::sin(2.0 * t), t};
    step.odometry_in_enu.reset();
    if (step.step == 7) step.estimate.moments.mean.x_m = std::nan("");
    if (step.step == 9) step.odometry_in_enu = Rigid2{1e6, 0.0, 0.0};
  });
  EXPECT_TRUE(run->has_odometry);
  EXPECT_LT(run->outline_in_enu_m.size(), 40U);
  for (double angle = 0.0; angle < 6.3; angle += 0.1) {
    const Eigen::Vector2d side(std::cos(angle), std::sin(angle));
    double farthest = -1e9, outlined = -1e9;
    for (const RunStep& step : run->steps) {
      const Eigen::Vector2d estimate = step.estimate.moments.mean.translation_m();
      if (estimate.allFinite()) farthest = std::max(farthest, estimate.dot(side));
      farthest = std::max(farthest, step.truth_in_enu->translation_m().dot(side));
    }
    for (const Eigen::Vector2d& corner : run->outline_in_enu_m) {
      outlined = std::max(outlined, corner.dot(side));
    }
    EXPECT_EQ(outlined, farthest) << angle;
  }
  EXPECT_THAT(made_document(0)->outline_in_enu_m, IsEmpty());
  EXPECT_FALSE(made_document(0)->has_odometry);
  const auto standing = made_document(5, [](RunStep& step) {
    step.estimate.moments.mean = {1.0, 2.0, 0.0};
    step.truth_in_enu.reset();
  });
  EXPECT_THAT(standing->outline_in_enu_m, ElementsAre(Eigen::Vector2d(1.0, 2.0)));
}

TEST_F(RunFileDocument, SharesACursorWithARunThatBeganLater) {
  const auto run = made_document(20);
  const auto later = made_document(10, [](RunStep& step) { step.time_s += 1.0; });
  EXPECT_NEAR(run->time_in(*later, 1.5), 0.5, 1e-9);
  EXPECT_EQ(later->latest_at(run->time_in(*later, 1.5)), 5U);
  EXPECT_EQ(later->latest_at(run->time_in(*later, 0.5)), std::nullopt);
}

TEST_F(RunFileDocument, FindsTheErrorOfAStep) {
  const auto run = made_document(6, [](RunStep& step) {
    if (step.step % 2 == 1) step.truth_in_enu.reset();
  });
  EXPECT_EQ(run->error_index_of(4), 2U);
  EXPECT_EQ(run->error_index_of(3), std::nullopt);
  EXPECT_EQ(run->error_index_of(6), std::nullopt);
}

TEST_F(RunFileDocument, TellsWhereStepsAreMissing) {
  const auto run = made_document(20, [](RunStep& step) {
    if (step.step >= 12) step.time_s += 3.0;
  });
  EXPECT_THAT(run->gaps, ElementsAre(12U));
  EXPECT_THAT(run->error_gaps, ElementsAre(12U));
  EXPECT_NEAR(run->median_period_s, 0.1, 1e-9);
}

TEST_F(RunFileDocument, OfARunThatHasJustBegunIsEmptyAndGrows) {
  RunWriter writer = begin();
  const Document empty = load();
  EXPECT_THAT(empty->steps, IsEmpty());
  EXPECT_THAT(empty->worst_moments, IsEmpty());
  EXPECT_FALSE(empty->is_complete);
  add(writer, 0, 2);
  EXPECT_EQ(grown(empty)->steps.size(), 2U);
}

TEST_F(RunFileDocument, GrowsToWhatLoadingGives) {
  RunWriter writer = begin();
  add(writer, 0, 10);
  Document run = load();
  EXPECT_FALSE(run->is_complete);
  for (const int end : {11, 30, 60}) {
    add(writer, static_cast<int>(run->steps.size()), end);
    const Document earlier = run;
    run = grown(earlier);
    expect_same(run, load());
    EXPECT_LT(earlier->steps.size(), run->steps.size()) << "the earlier value never changes";
  }
  ASSERT_TRUE(writer.finish());
  const Document complete = grown(run);
  EXPECT_TRUE(complete->is_complete);
  EXPECT_TRUE(complete->evaluation.is_complete);
  expect_same(complete, load());
}

TEST_F(RunFileDocument, StaysTheSameValueWhereNothingIsNew) {
  RunWriter writer = begin();
  add(writer, 0, 10);
  const Document run = load();
  EXPECT_EQ(grown(run), run);
  ASSERT_TRUE(writer.finish());
  const Document complete = grown(run);
  EXPECT_NE(complete, run);
  EXPECT_EQ(grown(complete), complete);
}

TEST_F(RunFileDocument, ReadsOnlyNewStepsWhenItGrows) {
  record_run(path(), 10);
  const Document run = load();
  // What was read is not read again: a row that could not be read any more does not matter.
  run_sql(path(), "UPDATE step SET estimate_x_m = 'text' WHERE step = 3");
  run_sql(path(),
          "INSERT INTO step SELECT 10, 7.5, odom_x_m, odom_y_m, odom_yaw_rad, odometry_x_m, "
          "odometry_y_m, odometry_yaw_rad, truth_x_m, truth_y_m, truth_yaw_rad, estimate_x_m, "
          "estimate_y_m, estimate_yaw_rad, covariance_xx_m2, covariance_xy_m2, "
          "covariance_x_yaw_m_rad, covariance_yy_m2, covariance_y_yaw_m_rad, "
          "covariance_yaw_yaw_rad2, effective_sample_size, particle_count, was_resampled, "
          "agreement, topview_cells, update_ms FROM step WHERE step = 9");
  const Document more = grown(run);
  ASSERT_EQ(more->steps.size(), 11U);
  EXPECT_EQ(more->time_s.back(), 7.5);
  EXPECT_THAT(error_text(RunDocument::load(path())), HasSubstr("row 3"));
}

TEST_F(RunFileDocument, ReadsAllOfAnotherRunThatTookItsName) {
  record_run(path(), 10);
  const Document run = load();
  record_run(path(), 6, 0, false);
  const Document other = grown(run);
  EXPECT_EQ(other->steps.size(), 6U);
  EXPECT_FALSE(other->is_complete);
  EXPECT_NE(other->file, run->file);
}

TEST_F(RunFileDocument, ReadsAllWhereItsLastStepIsNotTheSame) {
  record_run(path(), 10);
  const Document run = load();
  run_sql(path(), "UPDATE step SET estimate_x_m = estimate_x_m + 1");
  EXPECT_NEAR(grown(run)->errors.x_error_m.front(), 1.1, 1e-9);
  run_sql(path(), "DELETE FROM mode WHERE step > 4");
  run_sql(path(), "DELETE FROM step WHERE step > 4");
  EXPECT_EQ(grown(run)->steps.size(), 5U);
}

TEST_F(RunFileDocument, PassesErrorsOn) {
  EXPECT_EQ(error_code(RunDocument::load(path())), ErrorCode::kNotFound);
  record_run(path(), 3);
  const Document run = load();
  std::filesystem::remove(path());
  EXPECT_EQ(error_code(RunDocument::grown(run)), ErrorCode::kNotFound);
  (void)scratch_.file("R.nadir", "no run");
  EXPECT_EQ(error_code(RunDocument::grown(run)), ErrorCode::kMalformed);
}

TEST_F(RunFileDocument, ReportsAndStops) {
  record_run(path(), 3);
  std::vector<double> fractions;
  WorkContext context;
  context.progress = [&](double fraction, const std::string& activity) {
    fractions.push_back(fraction);
    EXPECT_FALSE(activity.empty());
  };
  ASSERT_TRUE(RunDocument::load(path(), context));
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
  std::stop_source stop;
  stop.request_stop();
  context.stop = stop.get_token();
  EXPECT_EQ(error_code(RunDocument::load(path(), context)), ErrorCode::kCancelled);
}

TEST_F(RunFileDocument, KeepsTheNameItIsGiven) {
  RunDocument made = made_run(2);
  EXPECT_EQ(RunDocument::from_steps(made)->name, "made");
  made.name = "live";
  EXPECT_EQ(RunDocument::from_steps(made)->name, "live");
}

}  // namespace run_document_test
}  // namespace nadir
