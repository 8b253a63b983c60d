// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/base/staged_output.h"
#include "core/map/overhead_map_file.h"
#include "tests/app/program.h"
#include "tests/core/sim/street_map.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace simulate_command_test {

using testing::AllOf;
using testing::HasSubstr;

class SimulateCommand : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(write_overhead_map(street_map(0.2), {.name = "crossing"}, std::nullopt, path("map"))
                    .has_value());
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (scratch_.path() / name).string();
  }
  [[nodiscard]] ProgramOutput simulate(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"simulate", path("map"), "--out", path("flight")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  /// One sentence that holds `fault`, and no flight.
  void expect_refused(const std::vector<std::string>& more,
                      const std::string& fault,
                      int status) const {
    const auto refused = simulate(more);
    EXPECT_EQ(refused.status, status) << fault;
    EXPECT_THAT(refused.err, HasSubstr(fault));
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(path("flight")));
  }

  ScratchFolder scratch_;
};

TEST_F(SimulateCommand, SaysHowToNameAPathWhereTheMapHasNoRoute) {
  expect_refused({},
                 path("map") +
                     ": has no routes/loop.toml; name a route with --route, or a "
                     "recorded path with --truth",
                 1);
}

TEST_F(SimulateCommand, FailsWithAFileThatIsMissingNamingIt) {
  expect_refused({"--route", path("no.toml")}, path("no.toml"), 1);
  expect_refused({"--truth", path("no.txt")}, "--truth: " + path("no.txt"), 1);
  const auto truth = scratch_.file("truth.txt", "0 1 1 0 0 0 0 1\n1 2 1 0 0 0 0 1\n").string();
  expect_refused({"--truth", truth, "--odometry", path("no.txt")}, "--odometry: " + path("no.txt"),
                 1);
}

TEST_F(SimulateCommand, RefusesValuesThatMakeNoSense) {
  expect_refused({"--camera-height", "900"}, "nadir simulate: --camera-height: 900 is not in", 1);
  expect_refused({"--level", "harsh"}, "--level: 'harsh' is not one of easy, medium, hard", 1);
  const auto truth = scratch_.file("truth.txt", "0 1 1 0 0 0 0 1\n1 2 1 0 0 0 0 1\n").string();
  expect_refused({"--truth", truth, "--start", "1,2"}, "--start: '1,2' is not 3 numbers", 1);
  expect_refused({"--truth", truth, "--route", "r.toml"}, "exclude each other", 2);
}

TEST_F(SimulateCommand, FailsWhereTheRouteLeadsOffTheMapThoughTheFlagsAreFine) {
  const auto route = scratch_
                         .file("far.toml",
                               "name = \"far\"\nspeed_mps = 4.0\n[[waypoint]]\neast_m = -500.0\n"
                               "north_m = 0.0\n[[waypoint]]\neast_m = -400.0\nnorth_m = 0.0\n")
                         .string();
  expect_refused({"--route", route, "--quiet"}, "far", 1);
}

}  // namespace simulate_command_test
}  // namespace nadir
