// SPDX-License-Identifier: Apache-2.0
// What a ground does not make anew, and what its tiles cost.
#include <gtest/gtest.h>

#include "app/gui/ground_picture.h"
#include "core/map/overhead_map_file.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/made_moment.h"
#include "widgets/gl/offscreen_context.h"

namespace nadir {
namespace ground_reuse_test {

constexpr int kWidth = 160, kHeight = 120;

class GroundReuseTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto context = OffscreenContext::create();
    if (!context) GTEST_SKIP() << context.error().message;
    context_ = std::move(*context);
    ASSERT_TRUE(write_overhead_map(made_.map->map(), {}, std::nullopt, folder_.path() / "map"));
    ground_ = GroundPicture::open(folder_.path() / "map", budget_).value();
    contents_.look = made_.map_view().look;
    contents_.look.layer(Layer::kTopview).is_visible = true;
    contents_.look.layer(Layer::kDisagreement).is_visible = true;
    contents_.step = made_.step;
    contents_.labels = std::shared_ptr<const OverheadMap>(made_.map, &made_.map->map());
  }
  void draw() {
    ground_->show(contents_);
    const MapCamera camera{contents_.look.centre_in_enu_m, 40.0 / kWidth};
    GroundPart part;
    part.layers = contents_.look.order;
    const auto drawn = ground_->draw(camera, kWidth, kHeight, 1.0, part);
    EXPECT_TRUE(drawn) << drawn.error().message;
  }

  MadeMoment made_;
  ScratchFolder folder_;
  std::shared_ptr<TileBudget> budget_ = std::make_shared<TileBudget>();
  GroundContents contents_;
  std::unique_ptr<OffscreenContext> context_;  // before what is drawn with it
  std::unique_ptr<GroundPicture> ground_;
};

TEST_F(GroundReuseTest, LaysTheTopviewOnceWhileOnlyTheCameraMoves) {
  draw();
  EXPECT_EQ(ground_->topviews_laid(), 1U);
  for (int i = 1; i <= 10; ++i) {
    contents_.look.centre_in_enu_m.x() += 0.3;  // panned, or following
    contents_.look.width_m *= 1.01;
    contents_.look.up_rad += 0.01;
    contents_.look.measured_in_enu_m.emplace_back(1.0 * i, 2.0);
    draw();
  }
  EXPECT_EQ(ground_->topviews_laid(), 1U);
  contents_.look.topview_at = PoseSource::kTruth;
  draw();
  EXPECT_EQ(ground_->topviews_laid(), 2U);
  contents_.look.layer(Layer::kDisagreement).is_visible = false;
  draw();
  EXPECT_EQ(ground_->topviews_laid(), 3U);
  contents_.step = made_.decoded(9);
  draw();
  EXPECT_EQ(ground_->topviews_laid(), 4U);
}

TEST_F(GroundReuseTest, CountsItsTilesInTheBudgetThatItWasGiven) {
  while (ground_->wants_more() || budget_->used_bytes() == 0) draw();
  EXPECT_GT(budget_->used_bytes(), 0U);
  ground_.reset();
  EXPECT_EQ(budget_->used_bytes(), 0U);
}

TEST_F(GroundReuseTest, OfAMapThatIsNotThereSaysSo) {
  EXPECT_FALSE(GroundPicture::open(folder_.path() / "elsewhere", budget_));
  EXPECT_EQ(budget_->used_bytes(), 0U);
}

}  // namespace ground_reuse_test
}  // namespace nadir
