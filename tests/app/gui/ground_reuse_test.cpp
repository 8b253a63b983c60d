// SPDX-License-Identifier: Apache-2.0
// What a ground does not make anew, and what its tiles cost.
#include <gtest/gtest.h>

#include "tests/app/gui/made_ground.h"

namespace nadir {
namespace ground_reuse_test {

class GroundReuseTest : public MadeGround {
 protected:
  void SetUp() override {
    MadeGround::SetUp();
    contents_.look.layer(Layer::kTopview).is_visible = true;
    contents_.look.layer(Layer::kDisagreement).is_visible = true;
  }
  void draw() { draw_once(all_layers(), 40.0 / kWidth); }
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
