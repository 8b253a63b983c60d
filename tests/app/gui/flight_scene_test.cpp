// SPDX-License-Identifier: Apache-2.0
#include "app/gui/flight_scene.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/map/overhead_map_file.h"
#include "tests/support/scenery.h"
#include "tests/support/scratch_folder.h"
#include "widgets/gl/offscreen_context.h"

namespace nadir {
namespace flight_scene_test {

/// A camera of 16 x 12 pixels that looks ahead, and nothing recorded.
class LookingFlight : public FlightRecording {
 public:
  LookingFlight() : FlightRecording(described()) {}
  [[nodiscard]] Result<SemanticFrame> load(std::size_t /*frame*/) const override {
    return fail(ErrorCode::kNotFound, "nothing to load");
  }

 private:
  static FlightDescription described() {
    FlightDescription description;
    description.camera = CameraModel::from_horizontal_view(16, 12, 1.2);
    return description;
  }
};

class FlightSceneTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto context = OffscreenContext::create();
    if (!context) GTEST_SKIP() << context.error().message;
    context_ = std::move(*context);
    ASSERT_TRUE(
        write_overhead_map(patchwork_map(100, 80, 0.5), {}, std::nullopt, folder_.path() / "map"));
    scene_ = FlightScene::open(folder_.path() / "map").value();
  }
  [[nodiscard]] static std::shared_ptr<const CameraMoment> seen(int width, int height) {
    CameraMoment moment;
    moment.labels = Raster<ClassId>(width, height, kRoad);
    moment.depth_m = Raster<float>(16, 12, 6.0F);
    return std::make_shared<const CameraMoment>(std::move(moment));
  }

  ScratchFolder folder_;
  LookingFlight flight_;
  std::unique_ptr<OffscreenContext> context_;  // before what is drawn with it
  std::unique_ptr<FlightScene> scene_;
};

TEST_F(FlightSceneTest, ShowsNoCloudOfAnotherMomentWhereOneCannotBeMade) {
  const Rigid2 pose{20.0, 20.0, 0.0};
  EXPECT_FALSE(scene_->shows_cloud());
  ASSERT_TRUE(scene_->show(pose, seen(16, 12), &flight_));
  EXPECT_TRUE(scene_->shows_cloud());
  const auto damaged = scene_->show(Rigid2{21.0, 20.0, 0.0}, seen(7, 5), &flight_);
  EXPECT_FALSE(damaged) << "the labels are not as large as the camera says";
  EXPECT_FALSE(scene_->shows_cloud());
  ASSERT_TRUE(scene_->show(Rigid2{22.0, 20.0, 0.0}, seen(16, 12), &flight_));
  EXPECT_TRUE(scene_->shows_cloud());
}

TEST_F(FlightSceneTest, ShowsNoCloudWithoutPoseOrFrame) {
  ASSERT_TRUE(scene_->show(Rigid2{20.0, 20.0, 0.0}, nullptr, &flight_));
  EXPECT_FALSE(scene_->shows_cloud());
  ASSERT_TRUE(scene_->show(std::nullopt, seen(16, 12), &flight_));
  EXPECT_FALSE(scene_->shows_cloud());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(scene_->show(Rigid2{nan, 20.0, 0.0}, seen(16, 12), &flight_));
  EXPECT_FALSE(scene_->shows_cloud());
}

}  // namespace flight_scene_test
}  // namespace nadir
