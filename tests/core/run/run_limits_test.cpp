// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_limits.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/run/run_schema.h"
#include "tests/core/run/recorded_run.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir::detail {
namespace run_limits_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What the writer says of step 0 after this damage, behind the name of the file.
std::string fault(const std::function<void(RunStep&)>& damage) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  auto writer = RunWriter::create(path, example_header()).value();
  RunStep step = example_step(0, 5);
  damage(step);
  const auto written = writer.write(step);
  EXPECT_FALSE(written);
  if (written) return "";
  EXPECT_EQ(error_code(written), ErrorCode::kMalformed);
  EXPECT_TRUE(writer.write(example_step(0, 5))) << "a refused step leaves the writer usable";
  EXPECT_EQ(RunReader::open(path)->steps()->size(), 1U);
  return error_text(written).substr(path.string().size() + 2);
}

TEST(RunLimits, AValueThatAReaderWouldRefuseIsNotWritten) {
  EXPECT_EQ(fault([](RunStep& s) { s.time_s = kInfinity; }),
            "step 0: time_s is inf, not a finite number");
  EXPECT_EQ(fault([](RunStep& s) { s.step = -3; }),
            "step -3: step is -3, not a whole number from 0 to 2147483647");
  EXPECT_EQ(fault([](RunStep& s) { s.odom_from_body.y_m = -1.5e8; }),
            "step 0: odom_y_m is -150000000, farther than any place on Earth");
  EXPECT_EQ(fault([](RunStep& s) { s.odometry_in_enu->x_m = std::nan(""); }),
            "step 0: odometry_x_m is nan, not a finite number");
  EXPECT_EQ(fault([](RunStep& s) {
              s.truth_in_enu = Rigid2{NAN, NAN, NAN};
            }),
            "step 0: truth_x_m is nan, not a finite number")
      << "it would come back as a truth that is not known";
  EXPECT_EQ(fault([](RunStep& s) { s.estimate.moments.mean.yaw_rad = NAN; }),
            "step 0: estimate_yaw_rad is nan, not a finite number");
  EXPECT_EQ(fault([](RunStep& s) { s.estimate.moments.covariance(1, 1) = -0.25; }),
            "step 0: covariance_yy_m2 is -0.25, and a variance is not negative");
  EXPECT_EQ(fault([](RunStep& s) { s.estimate.moments.covariance(0, 1) = 0.3; }),
            "step 0: covariance_xy_m2 is 0.3, more than the two variances allow");
  EXPECT_EQ(fault([](RunStep& s) {
              s.estimate.moments.covariance << 1, 0.9, 0.9, 0.9, 1, -0.9, 0.9, -0.9, 1;
            }),
            "step 0: its six covariances contradict each other (the matrix has a negative "
            "eigenvalue)");
  EXPECT_EQ(fault([](RunStep& s) { s.effective_sample_size = -1.0; }),
            "step 0: effective_sample_size is -1, not a finite number from 0 up");
  EXPECT_EQ(fault([](RunStep& s) { s.particle_count = -1; }),
            "step 0: particle_count is -1, not a whole number from 0 to 2147483647");
  EXPECT_EQ(fault([](RunStep& s) { s.agreement = 1.5; }),
            "step 0: agreement is 1.5, not a share from 0 to 1");
  EXPECT_EQ(fault([](RunStep& s) { s.topview_cells = -9; }),
            "step 0: topview_cells is -9, not a whole number from 0 to 2147483647");
  EXPECT_EQ(fault([](RunStep& s) { s.update_ms = kInfinity; }),
            "step 0: update_ms is inf, not a finite number from 0 up");
}

TEST(RunLimits, NeitherAreModesParticlesAndTopviewsThatAReaderWouldRefuse) {
  EXPECT_EQ(fault([](RunStep& s) { s.estimate.modes[1].mass = 1.25; }),
            "step 0, mode of rank 1: mass is 1.25, not a share from 0 to 1");
  EXPECT_EQ(fault([](RunStep& s) { s.estimate.modes[0].mass = NAN; }),
            "step 0, mode of rank 0: mass is nan, not a finite number");
  EXPECT_EQ(fault([](RunStep& s) { s.estimate.modes[1].moments.mean.x_m = 1e9; }),
            "step 0, mode of rank 1: x_m is 1000000000, farther than any place on Earth");
  EXPECT_EQ(
      fault([](RunStep& s) { s.estimate.modes[1].moments.covariance(2, 2) = -1.0; }),
      "step 0, mode of rank 1: covariance_yaw_yaw_rad2 is -1, and a variance is not negative");
  EXPECT_THAT(fault([](RunStep& s) { s.particles->weight[2] = NAN; }),
              HasSubstr("particles of step 0: particle 2 is no pose with a weight"));
  EXPECT_THAT(fault([](RunStep& s) { s.topview->metres_per_cell = 0.0; }),
              HasSubstr("topview of step 0: its cells are 0 m wide"));
}

TEST(RunLimits, EveryStepThatIsWrittenCanBeRead) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  auto writer = RunWriter::create(path, example_header()).value();
  const std::vector<std::function<double&(RunStep&)>> places = {
      [](RunStep& s) -> double& { return s.odom_from_body.x_m; },
      [](RunStep& s) -> double& { return s.odometry_in_enu->y_m; },
      [](RunStep& s) -> double& { return s.truth_in_enu->yaw_rad; },
      [](RunStep& s) -> double& { return s.estimate.moments.mean.x_m; },
      [](RunStep& s) -> double& { return s.estimate.moments.covariance(0, 0); },
      [](RunStep& s) -> double& { return s.estimate.moments.covariance(0, 1); },
      [](RunStep& s) -> double& { return s.estimate.moments.covariance(2, 2); },
      [](RunStep& s) -> double& { return s.effective_sample_size; },
      [](RunStep& s) -> double& { return *s.agreement; },
      [](RunStep& s) -> double& { return s.update_ms; },
      [](RunStep& s) -> double& { return s.estimate.modes[0].mass; },
      [](RunStep& s) -> double& { return s.estimate.modes[1].moments.mean.yaw_rad; },
      [](RunStep& s) -> double& { return s.estimate.modes[1].moments.covariance(1, 1); },
      [](RunStep& s) -> double& { return s.particles->x_in_enu_m[1]; },
      [](RunStep& s) -> double& { return s.particles->weight[1]; },
      [](RunStep& s) -> double& { return s.topview->metres_per_cell; }};
  int number = 0;
  std::size_t written = 0;
  std::size_t refused = 0;
  for (const auto& place : places) {
    for (const double value :
         {std::nan(""), -kInfinity, kInfinity, -1e300, -1.1e8, -1.0, -1e-320, 0.0, 1e-320, 0.04,
          0.5, 1.0, 1.0 + 1e-7, 1.1, 7.0, 1e8, 1.1e8, 1e39, 1e300}) {
      RunStep step = example_step(++number, 3);
      place(step) = value;
      if (!writer.write(step)) {
        ++refused;
        continue;
      }
      ++written;
      const auto read = RunReader::open(path)->step(number);
      EXPECT_TRUE(read) << error_text(read);
    }
  }
  EXPECT_GT(written, 120U);
  EXPECT_GT(refused, 90U);
  const auto steps = RunReader::open(path)->steps();
  ASSERT_TRUE(steps) << error_text(steps);
  EXPECT_EQ(steps->size(), written);
}

TEST(RunLimits, AnOriginThatIsNoPlaceOnEarthIsNotWritten) {
  const ScratchFolder folder;
  for (const auto& [latitude_deg, longitude_deg] :
       {std::pair(90.5, 0.0), std::pair(0.0, -180.5), std::pair(std::nan(""), 0.0)}) {
    RunHeader header = example_header();
    header.plane_latitude_deg = latitude_deg;
    header.plane_longitude_deg = longitude_deg;
    const auto refused = RunWriter::create(folder.path() / "R.nadir", header);
    ASSERT_FALSE(refused);
    EXPECT_EQ(error_code(refused), ErrorCode::kMalformed);
    EXPECT_THAT(error_text(refused), HasSubstr("R.nadir: the origin of its plane, latitude "));
    EXPECT_EQ(folder.entries(), 0);
  }
}

TEST(RunLimits, TheNamesOfAFaultAreThoseOfTheTables) {
  EXPECT_EQ(fault_text({.column = 0, .value = -1, .what = "w"}, kStepColumns), "step is -1, w");
  EXPECT_EQ(fault_text({.column = 25, .value = 2.5, .what = "w"}, kStepColumns),
            "update_ms is 2.5, w");
  EXPECT_EQ(fault_text({.column = 11, .value = 0, .what = "w"}, kModeColumns),
            "covariance_yaw_yaw_rad2 is 0, w");
  EXPECT_EQ(fault_text({.column = {}, .what = "all of it"}, kStepColumns), "all of it");
}

}  // namespace run_limits_test
}  // namespace nadir::detail
