// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/offscreen_context.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace nadir {
namespace {

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

}  // namespace
}  // namespace nadir
