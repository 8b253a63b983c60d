// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_vehicle.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/shown_map.h"

namespace nadir {
namespace map_vehicle_test {

using ::testing::ElementsAre;
using ::testing::StartsWith;

class MapVehicle : public ShownMap {
 protected:
  [[nodiscard]] Eigen::Vector2d vehicle() const {
    return made.document->steps[made.index].estimate.moments.mean.translation_m();
  }
  void look_from(const Eigen::Vector2d& away_m) {
    model.look.centre_in_enu_m = vehicle() + away_m;
    show();
  }
  [[nodiscard]] const kit::Control* button() const {
    for (const kit::Control& control : screen.controls()) {
      if (control.path.starts_with("Map/Vehicle/Plate/")) return &control;
    }
    return nullptr;
  }
};

TEST_F(MapVehicle, HasNoArrowWhereItIsInSightOrTheMapFollows) {
  look_from({0.0, 0.0});
  EXPECT_FALSE(state.away);
  EXPECT_EQ(button(), nullptr);
  model.look.is_following = true;
  look_from({300.0, 0.0});
  EXPECT_FALSE(state.away);
  model.look.is_following = false;
  model.runs[0].step.reset();
  look_from({300.0, 0.0});
  EXPECT_FALSE(state.away) << "nobody knows where it is";
}

TEST_F(MapVehicle, IsPointedToFromTheBorderOfTheMap) {
  for (const Eigen::Vector2d& away :
       {Eigen::Vector2d(300.0, 0.0), Eigen::Vector2d(-300.0, 0.0), Eigen::Vector2d(0.0, 300.0),
        Eigen::Vector2d(210.0, -140.0)}) {
    look_from(away);
    ASSERT_TRUE(state.away);
    EXPECT_NEAR(state.away->distance_m, away.norm(), 1e-9);
    EXPECT_NEAR(state.away->along.norm(), 1.0, 1e-12);
    EXPECT_LT(state.away->along.dot(away.normalized()), -0.95) << "the way back";
    const PageRect& free = state.away->free;
    const Eigen::Vector2d& tip = state.away->tip;
    const double to_border = std::min(
        {tip.x() - free.left, free.right() - tip.x(), tip.y() - free.bottom, free.top() - tip.y()});
    EXPECT_NEAR(to_border, 0.0, 1e-6);
    ASSERT_NE(button(), nullptr);
    const kit::Rect map = screen.at(kGround).rect, words = button()->rect;
    const Eigen::Vector2d arrow(map.left + tip.x(), map.bottom() - tip.y());
    EXPECT_GE((words.centre() - arrow)
                  .cwiseAbs()
                  .cwiseQuotient(Eigen::Vector2d(words.width, words.height) / 2.0)
                  .maxCoeff(),
              1.0)
        << "the words do not lie on the arrow";
    EXPECT_GE(words.left, map.left);
    EXPECT_LE(words.right(), map.right());
    EXPECT_GE(words.top, map.top);
    EXPECT_LE(words.bottom(), map.bottom());
  }
}

TEST_F(MapVehicle, IsFollowedByOneClick) {
  look_from({34.0, 0.0});
  ASSERT_NE(button(), nullptr);
  EXPECT_EQ(button()->label, "vehicle 34 m");
  EXPECT_THAT(button()->tooltip, StartsWith("The vehicle is out of sight: follow it"));
  EXPECT_THAT(screen.click(button()->path, drawing()),
              ElementsAre(Action(actions::Follow{Switch::kOn})));
}

TEST(AwayWords, HaveAsManyDigitsAsMatter) {
  EXPECT_EQ(away_words(7.24), "vehicle 7.2 m");
  EXPECT_EQ(away_words(34.4), "vehicle 34 m");
  EXPECT_EQ(away_words(999.7), "vehicle 1.0 km");
  EXPECT_EQ(away_words(12'345.0), "vehicle 12.3 km");
}

}  // namespace map_vehicle_test
}  // namespace nadir
