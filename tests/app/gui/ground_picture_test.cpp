// SPDX-License-Identifier: Apache-2.0
#include "app/gui/ground_picture.h"

#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <algorithm>

#include "core/map/overhead_map_file.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/made_moment.h"
#include "widgets/gl/offscreen_context.h"

namespace nadir {
namespace ground_picture_test {

constexpr int kWidth = 160, kHeight = 120;
constexpr double kMetresPerPx = 0.25;

/// A ground of the made moment, whose topview lies 3 m north of where it was seen: there its classes are not the map's.
class GroundPictureTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto context = OffscreenContext::create();
    if (!context) GTEST_SKIP() << context.error().message;
    context_ = std::move(*context);
    ASSERT_TRUE(write_overhead_map(made_.map->map(), {}, std::nullopt, folder_.path() / "map"));
    ground_ = GroundPicture::open(folder_.path() / "map").value();
    contents_.look = made_.map_view().look;
    for (LayerLook& layer : contents_.look.layers) layer = {false, 1.0, std::nullopt};
    contents_.step = made_.step;
    contents_.labels = std::shared_ptr<const OverheadMap>(made_.map, &made_.map->map());
  }
  void show(Layer layer, double opacity = 1.0) {
    contents_.look.layer(layer) = {true, opacity, std::nullopt};
  }
  /// As drawn once all tiles are there, rows from the bottom.
  Raster<Rgba> drawn(const GroundPart& part) {
    const MapCamera camera{contents_.look.centre_in_enu_m, kMetresPerPx};
    do {
      ground_->show(contents_);
      EXPECT_TRUE(ground_->draw(camera, kWidth, kHeight, 1.0, part));
    } while (ground_->wants_more());
    Raster<Rgba> pixels(kWidth, kHeight);
    glBindTexture(GL_TEXTURE_2D, ground_->texture(part.number));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  }
  Raster<Rgba> drawn() {
    GroundPart part;
    part.layers = contents_.look.order;
    return drawn(part);
  }
  void lift(Layer layer) {  // above all others
    std::erase(contents_.look.order, layer);
    contents_.look.order.push_back(layer);
  }
  static std::size_t differing(const Raster<Rgba>& a, const Raster<Rgba>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += a.values()[i] == b.values()[i] ? 0U : 1U;
    return count;
  }

  MadeMoment made_;
  ScratchFolder folder_;
  GroundContents contents_;
  std::unique_ptr<OffscreenContext> context_;  // before what is drawn with it
  std::unique_ptr<GroundPicture> ground_;
};

TEST_F(GroundPictureTest, HidesALayerAtOnce) {
  const Raster<Rgba> nothing = drawn();
  show(Layer::kLabels);
  EXPECT_GT(differing(drawn(), nothing), nothing.size() / 2);
  contents_.look.layer(Layer::kLabels).is_visible = false;
  EXPECT_EQ(differing(drawn(), nothing), 0U);
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
