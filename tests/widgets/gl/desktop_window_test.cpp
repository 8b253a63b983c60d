// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/desktop_window.h"

#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>

#include "tests/support/error_text.h"

namespace nadir {
namespace desktop_window_test {

/// Ends the process with what create() says and 7, so that its parent sees both; 0 where a window came.
[[noreturn]] void open_and_tell() {
  for (int i = 0; i < 3; ++i) {  // a failure leaves nothing behind that a second try trips over
    const auto window = DesktopWindow::create("Nadir", 640, 480);
    if (window) std::_Exit(0);
    if (i == 2) std::fputs(error_text(window).c_str(), stderr);
    if (error_code(window) != ErrorCode::kUnsupported) std::_Exit(1);
  }
  std::_Exit(7);
}

/// In a process of its own, for the environment is the process's.
class DesktopWindowDeathTest : public testing::Test {
 protected:
  DesktopWindowDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

// NOLINTBEGIN(concurrency-mt-unsafe): the processes have one thread
TEST_F(DesktopWindowDeathTest, SaysInOneSentenceThatThereIsNoDisplay) {
  const auto without = [] {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    open_and_tell();
  };
  EXPECT_EXIT(
      without(), testing::ExitedWithCode(7),
      "^no display: neither WAYLAND_DISPLAY nor DISPLAY is set; figures and reports need none$");
}

TEST_F(DesktopWindowDeathTest, TakesAnEmptyNameForNone) {
  const auto without = [] {
    ::setenv("DISPLAY", "", 1);
    ::setenv("WAYLAND_DISPLAY", "", 1);
    open_and_tell();
  };
  EXPECT_EXIT(without(), testing::ExitedWithCode(7), "^no display: neither WAYLAND_DISPLAY nor");
}

TEST_F(DesktopWindowDeathTest, SaysWhatWentWrongWithADisplayThatIsNotThere) {
  const auto without = [] {
    ::unsetenv("WAYLAND_DISPLAY");
    ::setenv("DISPLAY", ":54321", 1);
    open_and_tell();
  };
  EXPECT_EXIT(without(), testing::ExitedWithCode(7),
              "^no display: none can be opened \\(.*:54321.*\\); figures and reports need none$");
}
// NOLINTEND(concurrency-mt-unsafe)

TEST(DesktopWindow, WithoutPixelsIsABrokenPrecondition) {
  EXPECT_THROW((void)DesktopWindow::create("Nadir", 0, 480), std::logic_error);
  EXPECT_THROW((void)DesktopWindow::create("Nadir", 640, -1), std::logic_error);
}

}  // namespace desktop_window_test
}  // namespace nadir
