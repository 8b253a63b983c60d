// SPDX-License-Identifier: Apache-2.0
#include "app/gui/ground_picture.h"

#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <algorithm>

#include "tests/app/gui/made_ground.h"
#include "tests/support/page_pixels.h"

namespace nadir {
namespace ground_picture_test {

constexpr double kMetresPerPx = 0.25;

class GroundPictureTest : public MadeGround {
 protected:
  void SetUp() override {
    MadeGround::SetUp();
    for (LayerLook& layer : contents_.look.layers) layer = {false, 1.0, std::nullopt};
  }
  void show(Layer layer, double opacity = 1.0) {
    contents_.look.layer(layer) = {true, opacity, std::nullopt};
  }
  /// As drawn once all tiles are there, rows from the bottom.
  Raster<Rgba> drawn(const GroundPart& part) {
    do {
      draw_once(part, kMetresPerPx);
    } while (ground_->wants_more());
    Raster<Rgba> pixels(kWidth, kHeight);
    glBindTexture(GL_TEXTURE_2D, ground_->texture(part.number));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
  Raster<Rgba> drawn() { return drawn(all_layers()); }
  void lift(Layer layer) {  // above all others
    std::erase(contents_.look.order, layer);
    contents_.look.order.push_back(layer);
  }
  static std::size_t differing(const Raster<Rgba>& a, const Raster<Rgba>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a.values()[i] == b.values()[i] ? 0U : 1U;
    return count;
  }
};

TEST_F(GroundPictureTest, HidesALayerAtOnce) {
  const Raster<Rgba> nothing = drawn();
  show(Layer::kLabels);
  EXPECT_GT(differing(drawn(), nothing), nothing.size() / 2);
  contents_.look.layer(Layer::kLabels).is_visible = false;
  EXPECT_EQ(differing(drawn(), nothing), 0U);
}

TEST_F(GroundPictureTest, HasInEachPixelTheClassThatIsAtItsMiddle) {
  show(Layer::kLabels);
  const Raster<Rgba> pixels = drawn();
  const OverheadMap& map = made_.map->map();
  const MapCamera camera{contents_.look.centre_in_enu_m, kMetresPerPx};
  const PageRect page{0.0, 0.0, 1.0 * kWidth, 1.0 * kHeight};
  int off = 0, compared = 0;
  for (int row = 0; row < kHeight; ++row) {  // from the bottom
    for (int column = 0; column < kWidth; ++column) {
      const Eigen::Vector2d place = camera.enu_from_page({column + 0.5, row + 0.5}, page);
      if (!map.contains(place) || map.class_at(place) == kUnclassified) continue;
      ++compared;
      if (pixels.at(column, row) != class_colour(map.class_at(place))) ++off;
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_EQ(off, 0) << "of " << compared;
}

TEST_F(GroundPictureTest, LaysLayersInTheirOrder) {
  show(Layer::kLabels);
  const Raster<Rgba> map = drawn();
  show(Layer::kTopview);
  lift(Layer::kTopview);
  EXPECT_GT(differing(drawn(), map), 50U) << "it says something else 3 m away";
  lift(Layer::kLabels);
  EXPECT_EQ(differing(drawn(), map), 0U) << "the labels cover it";
}

TEST_F(GroundPictureTest, FadesParticlesWithTheirLayer) {
  const Raster<Rgba> nothing = drawn();
  show(Layer::kParticles);
  const std::size_t in_full = differing(drawn(), nothing);
  EXPECT_GT(in_full, 20U);
  show(Layer::kParticles, 0.0);
  EXPECT_EQ(differing(drawn(), nothing), 0U);
  show(Layer::kParticles, 0.3);
  const Raster<Rgba> faded = drawn();
  EXPECT_GT(differing(faded, nothing), 20U);
  show(Layer::kParticles);
  EXPECT_GT(differing(drawn(), faded), 20U);
}

TEST_F(GroundPictureTest, OfAPartThatLiesOnLinesLetsThemThrough) {
  show(Layer::kParticles);
  GroundPart above;
  above.layers = {Layer::kParticles};
  above.is_lowest = false;
  const Raster<Rgba> part = drawn(above);
  const auto is_clear = [](const Rgba& pixel) { return pixel.alpha == 0; };
  EXPECT_GT(std::count_if(part.values().begin(), part.values().end(), is_clear), 1000);
  EXPECT_FALSE(std::all_of(part.values().begin(), part.values().end(), is_clear));
}

TEST_F(GroundPictureTest, OfATranslucentPartHasItsOwnColoursInBothThemes) {
  show(Layer::kLabels);
  const Raster<Rgba> opaque = drawn();
  show(Layer::kLabels, 0.5);
  GroundPart above;
  above.layers = {Layer::kLabels};
  above.is_lowest = false;
  for (const ThemeName theme : {ThemeName::kLight, ThemeName::kDark}) {
    contents_.theme = theme;
    const Raster<Rgba> part = drawn(above);
    std::size_t compared = 0, off = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Rgba& pixel = part.values()[i];
      if (pixel.alpha < 100) continue;  // beside the map
      const Rgba& full = opaque.values()[i];
      ++compared;
      if (difference(pixel, {full.red, full.green, full.blue, 128}) > 2) ++off;
    }
    EXPECT_GT(compared, 1000U);
    EXPECT_EQ(off, 0U) << "the window's colour shines through, of " << compared;
  }
}

TEST_F(GroundPictureTest, WithoutAMapHasWhatTheRunRecorded) {
  ground_ = GroundPicture::without_map(contents_.look.centre_in_enu_m);
  contents_.labels.reset();
  const Raster<Rgba> nothing = drawn();
  show(Layer::kParticles);
  EXPECT_GT(differing(drawn(), nothing), 20U);
  show(Layer::kTopview);
  EXPECT_GT(differing(drawn(), nothing), 200U);
}

}  // namespace ground_picture_test
}  // namespace nadir
