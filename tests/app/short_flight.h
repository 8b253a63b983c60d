// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/map/overhead_map_file.h"
#include "tests/app/program.h"
#include "tests/core/sim/street_map.h"
#include "tests/support/scratch_folder.h"

namespace nadir {

/// A small town and a short flight over it, made once for all tests of a suite.
class ShortFlight : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = new ScratchFolder();
    OverheadMap map = street_map(0.2);
    map.name = "crossing";
    ASSERT_TRUE(
        write_overhead_map(map, {.name = "crossing"}, std::nullopt, path("map")).has_value());
    scratch_->file("route.toml",
                   "name = \"along\"\nspeed_mps = 4.0\n"
                   "[[waypoint]]\neast_m = 8.0\nnorth_m = 28.0\n[[waypoint]]\neast_m = "
                   "68.0\nnorth_m = 28.0\n");
    const auto made = run_program({"simulate", path("map"), "--route", path("route.toml"), "--out",
                                   path("flight"), "--image-width", "160", "--image-height", "120",
                                   "--seed", "3", "--level", "easy"});
    ASSERT_EQ(made.status, 0) << made.err;
  }
  static void TearDownTestSuite() {
    delete scratch_;
    scratch_ = nullptr;
  }
  static std::string path(const std::string& name) { return (scratch_->path() / name).string(); }

  static std::vector<std::string> localise(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"localise", path("flight"), "--map", path("map")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  /// Exit status 1 (or 2 where the command line is wrong), one sentence that holds `fault`, and no file left under the name.
  static void expect_refused(const std::vector<std::string>& arguments,
                             const std::string& fault,
                             int status = 1) {
    const auto refused = run_program(arguments);
    EXPECT_EQ(refused.status, status) << fault;
    EXPECT_THAT(refused.err, testing::HasSubstr(fault));
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_EQ(refused.out, "");
    EXPECT_FALSE(std::filesystem::exists(path("refused.nadir")));
  }

  inline static ScratchFolder* scratch_ = nullptr;
};

}  // namespace nadir
