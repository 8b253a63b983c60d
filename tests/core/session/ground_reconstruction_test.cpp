// SPDX-License-Identifier: Apache-2.0
#include "core/session/ground_reconstruction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/run/run_file.h"
#include "core/topview/semantic_reconstruction.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace ground_reconstruction_test {

using ::testing::HasSubstr;

/// One cell of a class, just ahead and left of the body.
SemanticTopview one_cell(ClassId id) {
  SemanticTopview seen;
  seen.metres_per_cell = 0.5;
  seen.cells = {{0, 0}};
  for (std::size_t next = id + 1U; next < seen.class_begin.size(); ++next)
    seen.class_begin[next] = 1;
  return seen;
}

/// A drive east in steps of a metre; the truth lies 10 m north of the estimate.
RunStep step_at(int number) {
  RunStep step;
  step.step = number;
  step.time_s = 100.0 + number;
  step.estimate.moments.mean = {1.0 * number, 0.0, 0.0};
  step.estimate.moments.covariance = Eigen::Matrix3d::Identity();
  step.truth_in_enu = Rigid2{1.0 * number, 10.0, 0.0};
  step.odometry_in_enu = Rigid2{1.0 * number, 20.0, 0.0};
  step.topview = one_cell(number % 2 == 0 ? kRoad : kCurb);
  step.topview_cells = 1;
  return step;
}

class GroundReconstructionTest : public ::testing::Test {
 protected:
  static constexpr int kSteps = 12, kLong = 650;

  std::shared_ptr<const RunDocument> run(int steps = kSteps) {
    RunHeader header;
    header.program_version = "0";
    const auto path = folder_.path() / "drive.nadir";
    auto writer = RunWriter::create(path, header);
    EXPECT_TRUE(writer) << error_text(writer);
    for (int i = 0; i < steps; ++i) {
      const auto written = writer->write(step_at(i));
      EXPECT_TRUE(written) << error_text(written);
    }
    EXPECT_TRUE(writer->finish());
    auto document = RunDocument::load(path);
    EXPECT_TRUE(document) << error_text(document);
    return *document;
  }

  std::shared_ptr<const ReconstructedGround> answer_to(const ReconstructionQuestion& question) {
    maker_.ask(question);
    for (int i = 0; i < 5'000 && maker_.is_working(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return maker_.answer();
  }

  /// The same, laid by hand.
  static ReconstructedGround expected(int steps, double north_m) {
    SemanticReconstruction seen(0.5);
    for (int i = 0; i < steps; ++i) seen.add(*step_at(i).topview, {1.0 * i, north_m, 0.0});
    return {*seen.labels(), seen.top_left_in_enu_m(), 0.5, static_cast<std::size_t>(steps)};
  }

  ScratchFolder folder_;
  GroundReconstruction maker_;
};

void expect_same(const std::shared_ptr<const ReconstructedGround>& made,
                 const ReconstructedGround& expected) {
  ASSERT_NE(made, nullptr);
  EXPECT_EQ(made->labels, expected.labels);
  EXPECT_EQ(made->top_left_in_enu_m, expected.top_left_in_enu_m);
  EXPECT_EQ(made->metres_per_cell, expected.metres_per_cell);
  EXPECT_EQ(made->steps, expected.steps);
}

TEST_F(GroundReconstructionTest, LaysEveryTopviewUpToAStepForwardsAndBack) {
  const auto document = run();
  expect_same(answer_to({document, 3, PoseSource::kEstimate}), expected(4, 0.0));
  expect_same(answer_to({document, 9, PoseSource::kEstimate}), expected(10, 0.0));
  expect_same(answer_to({document, 1, PoseSource::kEstimate}), expected(2, 0.0));
  expect_same(answer_to({document, 99, PoseSource::kEstimate}), expected(kSteps, 0.0));
}

TEST_F(GroundReconstructionTest, NeverShowsMoreThanWasSeenUntilThen) {
  const auto document = run();
  expect_same(answer_to({document, 9, PoseSource::kEstimate}), expected(10, 0.0));
  maker_.ask({document, 2, PoseSource::kEstimate});
  const auto at_once = maker_.answer();
  EXPECT_TRUE(at_once == nullptr || at_once->steps <= 3U) << at_once->steps;
  expect_same(answer_to({document, 2, PoseSource::kEstimate}), expected(3, 0.0));
}

TEST_F(GroundReconstructionTest, GoesBackAndForthThroughALongRun) {
  const auto document = run(kLong);
  for (const std::size_t step : {649U, 10U, 430U, 401U, 648U, 199U, 200U, 0U, 649U}) {
    const auto made = answer_to({document, step, PoseSource::kEstimate});
    expect_same(made, expected(static_cast<int>(step) + 1, 0.0));
  }
}

TEST_F(GroundReconstructionTest, LaysThemAtThePosesThatAreAskedFor) {
  const auto document = run();
  expect_same(answer_to({document, 5, PoseSource::kTruth}), expected(6, 10.0));
  expect_same(answer_to({document, 5, PoseSource::kOdometry}), expected(6, 20.0));
}

TEST_F(GroundReconstructionTest, AsksForTheNewestOnlyWhenItIsHurried) {
  const auto document = run();
  for (std::size_t step = 0; step < kSteps; ++step) {
    maker_.ask({document, step, PoseSource::kEstimate});
  }
  expect_same(answer_to({document, 7, PoseSource::kEstimate}), expected(8, 0.0));
}

TEST_F(GroundReconstructionTest, SaysOnceWhyThereIsNone) {
  const auto document = run();
  std::filesystem::remove(document->path);
  EXPECT_EQ(answer_to({document, 3, PoseSource::kEstimate}), nullptr);
  EXPECT_THAT(maker_.take_error(), HasSubstr("drive.nadir"));
  EXPECT_EQ(maker_.take_error(), "");
}

TEST_F(GroundReconstructionTest, IsNotAskedWithoutARun) {
  maker_.ask({});
  EXPECT_FALSE(maker_.is_working());
  EXPECT_EQ(maker_.answer(), nullptr);
}

}  // namespace ground_reconstruction_test
}  // namespace nadir
