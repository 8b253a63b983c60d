// SPDX-License-Identifier: Apache-2.0
// The program on a machine without display and without any setting, as a build server has it.
#include <gmock/gmock.h>

#include <cstdlib>

#include "tests/app/drawn_run.h"

namespace nadir {
namespace report_program_test {

namespace fs = std::filesystem;

class ReportProgram : public DrawnRun {
 protected:
  /// Of the program in an empty environment.
  static int status_of(const std::string& arguments) {
    const std::string command =
        "env -i \"PATH=$PATH\" \"HOME=$HOME\" " NADIR_PROGRAM " " + arguments;
    return std::system(command.c_str());  // NOLINT(concurrency-mt-unsafe): a test has one thread
  }
};

TEST_F(ReportProgram, WritesTheSameBytesTwiceWithoutDisplayAndEnvironment) {
  write_drive(path("b.nadir"), path("map"), 10);
  for (const char* folder : {"once", "twice"}) {
    ASSERT_EQ(status_of("report --quiet '" + path("run.nadir") + "' '" + path("b.nadir") +
                        "' --out '" + path(folder) + "'"),
              0);
  }
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(path("once"))) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(bytes("once/" + name), bytes("twice/" + name)) << name;
    ++files;
  }
  EXPECT_GT(files, 20U);
  EXPECT_EQ(std::distance(fs::directory_iterator(path("twice")), fs::directory_iterator()),
            static_cast<std::ptrdiff_t>(files));
}

}  // namespace report_program_test
}  // namespace nadir
