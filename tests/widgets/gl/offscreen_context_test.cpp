// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/offscreen_context.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>

#include "tests/support/error_text.h"

namespace nadir {
namespace offscreen_context_test {

TEST(OffscreenContext, IsHadFromEglAndCurrentAtOnce) {
  auto context = OffscreenContext::create();
  ASSERT_TRUE(context) << error_text(context);
  EXPECT_THAT((*context)->kind(), testing::StartsWith("EGL "));
  EXPECT_NE(eglGetCurrentContext(), EGL_NO_CONTEXT);
  context->reset();
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

TEST(OffscreenContext, IsOneOfSeveralOfWhichAnyCanBeMadeCurrent) {
  auto first = OffscreenContext::create();
  ASSERT_TRUE(first) << error_text(first);
  EGLContext const egl_first = eglGetCurrentContext();
  auto second = OffscreenContext::create();
  ASSERT_TRUE(second) << error_text(second);
  EGLContext const egl_second = eglGetCurrentContext();
  EXPECT_NE(egl_first, egl_second);
  (*first)->make_current();
  EXPECT_EQ(eglGetCurrentContext(), egl_first);
  // One that is not current goes without touching the one that is.
  second->reset();
  EXPECT_EQ(eglGetCurrentContext(), egl_first);
}

TEST(OffscreenContext, CanBeHadAgainAndAgain) {
  for (int i = 0; i < 20; ++i) {
    const auto context = OffscreenContext::create();
    ASSERT_TRUE(context) << i << ": " << error_text(context);
  }
}

/// Ends the process with what create() says and 7; 0 where a context came.
[[noreturn]] void ask_and_tell() {
  const auto context = OffscreenContext::create();
  if (context) std::_Exit(0);
  std::fputs(error_text(context).c_str(), stderr);
  std::_Exit(error_code(context) == ErrorCode::kUnsupported ? 7 : 1);
}

/// In a process of its own: EGL reads the environment once.
class OffscreenContextDeathTest : public testing::Test {
 protected:
  OffscreenContextDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

// NOLINTBEGIN(concurrency-mt-unsafe): the processes have one thread
TEST_F(OffscreenContextDeathTest, SaysInOneSentenceThatThereIsNoDriver) {
  const auto without = [] {
    ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);
    ask_and_tell();
  };
  EXPECT_EXIT(without(), testing::ExitedWithCode(7),
              "^OpenGL without a display is not to be had here \\([^.]*\\); Mesa's EGL driver "
              "draws without a graphics card$");
}

TEST_F(OffscreenContextDeathTest, SaysWhatEachWayLacks) {
  const auto old = [] {
    ::setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
    ask_and_tell();
  };
  EXPECT_EXIT(old(), testing::ExitedWithCode(7), "EGL surfaceless has no OpenGL 3.3");
}
// NOLINTEND(concurrency-mt-unsafe)

}  // namespace offscreen_context_test
}  // namespace nadir
