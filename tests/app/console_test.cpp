// SPDX-License-Identifier: Apache-2.0
#include "app/cli/console.h"

#include <gmock/gmock.h>

namespace nadir {
namespace console_test {

TEST(ProgressLine, OfAllTheWorkIsTheFractionItself) {
  EXPECT_EQ(cli::progress_line({}, 0.43, "drawing flight"), "progress 0.4300 drawing flight");
}

TEST(ProgressLine, OfAPartGoesFromItsBeginningToItsEnd) {
  const cli::ProgressShare second{0.25, 0.75};
  EXPECT_EQ(cli::progress_line(second, 0.0, "localising"), "progress 0.2500 localising");
  EXPECT_EQ(cli::progress_line(second, 0.5, "localising"), "progress 0.5000 localising");
  EXPECT_EQ(cli::progress_line(second, 1.0, "localising"), "progress 0.7500 localising");
}

}  // namespace console_test
}  // namespace nadir
