// SPDX-License-Identifier: Apache-2.0
#include "app/gui/picture_textures.h"

#include <gtest/gtest.h>

#include "widgets/gl/offscreen_context.h"

namespace nadir {
namespace picture_textures_test {

Picture picture_of(int width, int height) {
  return {std::make_shared<Raster<Rgba>>(width, height, Rgba{10, 20, 30})};
}

class PictureTexturesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto context = OffscreenContext::create();
    if (!context) GTEST_SKIP() << context.error().message;
    context_ = std::move(*context);
  }
  std::unique_ptr<OffscreenContext> context_;  // before what is in it
  PictureTextures textures_;
};

TEST_F(PictureTexturesTest, UploadEachPictureOnce) {
  const Picture one = picture_of(3, 2);
  const Picture other = picture_of(3, 2);
  const auto texture = textures_.of(one);
  EXPECT_NE(texture, 0U);
  EXPECT_EQ(textures_.of(one), texture);
  EXPECT_NE(textures_.of(other), texture);
  EXPECT_EQ(textures_.count(), 2U);
}

TEST_F(PictureTexturesTest, OfPicturesThatFollowEachOtherKeepTheNewest) {
  constexpr std::size_t kBytes = 2 * 1241 * 376 * sizeof(Rgba);  // in main memory and as a texture
  for (int frame = 0; frame < 40; ++frame) {
    EXPECT_NE(textures_.of(picture_of(1241, 376)), 0U);
    textures_.end_frame();
    EXPECT_LE(textures_.bytes(), 2 * kBytes);
  }
  textures_.end_frame();
  EXPECT_EQ(textures_.bytes(), 0U);
}

TEST_F(PictureTexturesTest, LetGoOfWhatNobodyAsksForInAWhile) {
  const Picture kept = picture_of(2, 2);
  {
    const Picture dropped = picture_of(2, 2);
    EXPECT_NE(textures_.of(dropped), 0U);
  }
  for (int frame = 0; frame < 100; ++frame) {
    EXPECT_NE(textures_.of(kept), 0U);
    textures_.end_frame();
  }
  EXPECT_EQ(textures_.count(), 1U);
}

TEST_F(PictureTexturesTest, HaveNoneForNoPicture) {
  EXPECT_EQ(textures_.of({}), 0U);
  EXPECT_EQ(textures_.of(picture_of(0, 0)), 0U);
  EXPECT_EQ(textures_.count(), 0U);
}

}  // namespace picture_textures_test
}  // namespace nadir
