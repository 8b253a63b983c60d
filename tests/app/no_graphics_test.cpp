// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "core/base/staged_output.h"
#include "tests/app/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"

namespace nadir {
namespace no_graphics_test {

namespace fs = std::filesystem;

/// Of a child that has not written what it should have.
constexpr int kIncomplete = 99;

/// On a machine whose EGL knows no driver; in a process of its own, for EGL reads the environment once. Ends it with the
/// program's status, what the program said on standard error; with kIncomplete where it has not written what it should.
[[noreturn]] void run_without_graphics(
    const std::vector<std::string>& arguments,
    const std::function<bool()>& is_written = [] { return true; }) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the process has one thread
  ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);
  const ProgramOutput done = run_program(arguments);
  std::fputs(done.err.c_str(), stderr);
  std::_Exit(is_written() ? done.status : kIncomplete);
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

// A child has a scratch folder of its own, so it looks itself at what it has written.

TEST_F(NoGraphicsDeathTest, AReportHasItsChartsAndItsPageAndSaysOnceWhatIsMissing) {
  const fs::path out = folder_ / "out";
  const std::vector<std::string> report = {"report", (folder_ / "drive.nadir").string(), "--out",
                                           out.string()};
  std::vector<std::string> quiet = report;
  quiet.emplace_back("--quiet");
  const auto is_written = [&out] {
    return fs::exists(out / "cdf.png") && fs::exists(out / "table.txt") &&
           !fs::exists(out / "labels.png") &&
           read_text_file(out / "index.html")->find("<li>no OpenGL for flight, trajectories, ") !=
               std::string::npos;
  };
  EXPECT_EXIT(run_without_graphics(quiet, is_written), testing::ExitedWithCode(1),
              "^nadir: no OpenGL for flight, trajectories, [^\n]*labels: OpenGL without a display "
              "is not to be had here \\([^\n]*\\)[^\n]*\n$");
  EXPECT_EXIT(run_without_graphics(report, is_written), testing::ExitedWithCode(1),
              "^nadir: no OpenGL for [^\n]*\n[0-9]+ figures in [^\n]*index.html\n$");
}

TEST_F(NoGraphicsDeathTest, AReportWhoseMapIsGoneNeedsNone) {
  fs::remove_all(folder_ / "map");
  EXPECT_EXIT(run_without_graphics({"report", (folder_ / "drive.nadir").string(), "--out",
                                    (folder_ / "out").string(), "--quiet"}),
              testing::ExitedWithCode(0), "^$");
}

TEST_F(NoGraphicsDeathTest, TheDemoSaysThatItsMapsCannotBeDrawn) {
  fs::create_directories(folder_ / "maps");
  write_street(folder_ / "maps" / "proving-ground");
  scratch_.file("maps/proving-ground/routes/loop.toml",
                "name = \"street\"\n[[waypoint]]\neast_m = 15\nnorth_m = 20\n"
                "[[waypoint]]\neast_m = 45\nnorth_m = 20\n");
  const fs::path demo = folder_ / "demo";
  const auto is_written = [&demo] {
    return fs::exists(demo / "report" / "cdf.png") && fs::exists(demo / "table.json");
  };
  const auto run_demo = [&] {
    fs::current_path(folder_);
    run_without_graphics({"demo", "--out", demo.string(), "--quiet"}, is_written);
  };
  EXPECT_EXIT(run_demo(), testing::ExitedWithCode(1), "^nadir: no OpenGL for [^\n]*\n$");
}

}  // namespace no_graphics_test
}  // namespace nadir
