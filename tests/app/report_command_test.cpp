// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/app/drawn_run.h"

namespace nadir {
namespace report_command_test {

using testing::EndsWith;
using testing::HasSubstr;

class ReportCommand : public DrawnRun {};

TEST_F(ReportCommand, SaysWhatItHasDrawnAndWhatIsLeftOut) {
  write_drive(path("blind.nadir"), path("map"), 5, {.has_truth = false});
  const auto report = run_program({"report", path("blind.nadir"), "--out", path("out")});
  ASSERT_EQ(report.status, 0) << report.err;
  EXPECT_EQ(report.out, "");
  EXPECT_THAT(report.err, HasSubstr("left out: flight: "));
  EXPECT_THAT(report.err,
              EndsWith(" figures in " + path("out") + "; open " + path("out") + "/index.html\n"));
  EXPECT_TRUE(exists("out/index.html") && exists("out/table.txt") && exists("out/moment.png"));
}

TEST_F(ReportCommand, LeavesAFolderOfSomethingElseAlone) {
  scratch_.file("mine/letter.txt", "dear");
  const auto refused = run_program({"report", path("run.nadir"), "--out", path("mine")});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("exists and holds no index.html, so it is left alone"));
  EXPECT_EQ(bytes("mine/letter.txt"), "dear");
}

TEST_F(ReportCommand, NamesTheRunThatIsNotThere) {
  const auto refused =
      run_program({"report", path("run.nadir"), path("none.nadir"), "--out", path("out")});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("none.nadir"));
  EXPECT_FALSE(exists("out"));
}

}  // namespace report_command_test
}  // namespace nadir
