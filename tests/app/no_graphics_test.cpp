// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "tests/app/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

/// On a machine whose EGL knows no driver; in a process of its own, for EGL reads the environment once. Ends it with the
/// program's status, what the program said on standard error.
[[noreturn]] void run_without_graphics(const std::vector<std::string>& arguments) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the process has one thread
  ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);
  const ProgramOutput done = run_program(arguments);
  std::fputs(done.err.c_str(), stderr);
  std::_Exit(done.status);
}

class NoGraphicsDeathTest : public testing::Test {
 protected:
  NoGraphicsDeathTest() {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    write_street(folder_ / "map");
    write_drive(folder_ / "drive.nadir", folder_ / "map");
  }

  ScratchFolder scratch_;
  fs::path folder_ = scratch_.path();
};

TEST_F(NoGraphicsDeathTest, FiguresOfMapsFailWithOneSentence) {
  const std::string out = (folder_ / "labels.png").string();
  EXPECT_EXIT(
      run_without_graphics({"figure", "labels", "--map", (folder_ / "map").string(), "--out", out}),
      testing::ExitedWithCode(1),
      "^[^\n]*OpenGL without a display is not to be had here \\([^\n]*\\)[^\n]*\n$");
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(NoGraphicsDeathTest, ChartsNeedNone) {
  const std::string out = (folder_ / "cdf.png").string();
  EXPECT_EXIT(run_without_graphics({"figure", "cdf", "--run", (folder_ / "drive.nadir").string(),
                                    "--out", out, "--quiet"}),
              testing::ExitedWithCode(0), "^$");
}

}  // namespace
}  // namespace nadir
