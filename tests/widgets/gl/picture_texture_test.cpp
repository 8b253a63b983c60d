// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/picture_texture.h"

#include <gtest/gtest.h>
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>

#include <vector>

#include "widgets/gl/offscreen_context.h"

namespace nadir {
namespace picture_texture_test {

class PictureTextureTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto context = OffscreenContext::create();
    ASSERT_TRUE(context) << context.error().message;
    context_ = std::move(*context);
  }
  static Raster<Rgba> ramp(int width, int height) {
    Raster<Rgba> pixels(width, height);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        pixels.at(column, row) = {static_cast<std::uint8_t>(10 * column),
                                  static_cast<std::uint8_t>(10 * row), 7, 200};
      }
    }
    return pixels;
  }
  /// What OpenGL has of it.
  static Raster<Rgba> read(std::uint32_t texture, int width, int height) {
    Raster<Rgba> pixels(width, height);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    return pixels;
  }
  static GLint filter_of(std::uint32_t texture) {
    GLint filter = 0;
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, &filter);
    glBindTexture(GL_TEXTURE_2D, 0);
    return filter;
  }
  std::unique_ptr<OffscreenContext> context_;
};

TEST_F(PictureTextureTest, HoldsThePixelsOfAnyWidth) {
  for (const int width : {1, 3, 4, 7}) {
    PictureTexture texture;
    const Raster<Rgba> pixels = ramp(width, 5);
    EXPECT_EQ(read(texture.show(pixels, false), width, 5), pixels) << width;
  }
}

TEST_F(PictureTextureTest, KeepsItsNameForAnotherPicture) {
  PictureTexture texture;
  const std::uint32_t name = texture.show(ramp(3, 2), true);
  EXPECT_NE(name, 0U);
  EXPECT_EQ(texture.show(ramp(8, 9), true), name);
  EXPECT_EQ(texture.texture(), name);
  EXPECT_EQ(read(name, 8, 9), ramp(8, 9));
}

TEST_F(PictureTextureTest, MixesPixelsOnlyWhereTheyMayBeMixed) {
  PictureTexture photo, classes;
  EXPECT_EQ(filter_of(photo.show(ramp(3, 2), true)), GL_LINEAR);
  EXPECT_EQ(filter_of(classes.show(ramp(3, 2), false)), GL_NEAREST);
}

TEST_F(PictureTextureTest, LeavesBoundWhatWasBound) {
  PictureTexture first, second;
  const std::uint32_t bound = first.show(ramp(3, 2), true);
  glBindTexture(GL_TEXTURE_2D, bound);
  (void)second.show(ramp(4, 4), true);
  GLint now = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &now);
  EXPECT_EQ(static_cast<std::uint32_t>(now), bound);
}

TEST_F(PictureTextureTest, IsNoneForNoPixels) {
  PictureTexture texture;
  EXPECT_EQ(texture.show({}, true), 0U);
  EXPECT_EQ(texture.texture(), 0U);
}

TEST_F(PictureTextureTest, GoesWithItsOwner) {
  std::uint32_t name = 0;
  {
    PictureTexture texture;
    name = texture.show(ramp(3, 2), true);
    EXPECT_EQ(glIsTexture(name), GL_TRUE);
  }
  EXPECT_EQ(glIsTexture(name), GL_FALSE);
}

}  // namespace picture_texture_test
}  // namespace nadir
