// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_vehicle.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

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
    const Eigen::Vector2d& tip = state.away->tip;
    const double to_border =
        std::min({tip.x(), state.where.width - tip.x(), tip.y(), state.where.height - tip.y()});
    EXPECT_LT(to_border, screen.at("Map/Tools/Measure").rect.right() + 24.0)
        << "beside what controls cover";
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

TEST_F(MapVehicle, LiesOnNothingThatIsThere) {
  const PageRect page{0.0, 0.0, 400.0, 280.0};
  const ArrowRoom room{{56.0, 48.0, 336.0, 184.0},
                       {{180.0, 0.0, 220.0, 110.0}, {230.0, 150.0, 162.0, 90.0}}};
  for (int degrees = 0; degrees < 360; degrees += 3) {
    const double angle = degrees * 3.14159265358979 / 180.0;
    const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    const MapFrame frame{page, MapCamera{vehicle() - 90.0 * way, 0.1}, 96.0 / 72.0};
    const auto away =
        screen.frame([&](kit::Ui& ui) { return vehicle_away(ui, model, frame, room); });
    ASSERT_TRUE(away) << degrees;
    EXPECT_GT(away->along.dot(way), 0.98) << degrees;
    ASSERT_TRUE(away->plate) << degrees << ": there is room for it";
    const Eigen::Vector2d back = away->tip - 20.0 * away->along;
    const PageRect arrow{std::min(away->tip.x(), back.x()), std::min(away->tip.y(), back.y()),
                         std::abs(away->tip.x() - back.x()), std::abs(away->tip.y() - back.y())};
    EXPECT_FALSE(overlap(arrow, *away->plate)) << degrees;
    for (const PageRect& taken : room.taken) {
      EXPECT_FALSE(overlap(arrow, taken)) << degrees;
      EXPECT_FALSE(overlap(*away->plate, taken)) << degrees;
    }
    EXPECT_GE(away->plate->left, room.inside.left);
    EXPECT_LE(away->plate->right(), room.inside.right());
    EXPECT_GE(away->plate->bottom, room.inside.bottom);
    EXPECT_LE(away->plate->top(), room.inside.top());
  }
}

TEST_F(MapVehicle, PointsWithoutWordsWhereNoneHaveRoom) {
  const MapFrame frame{
      {0.0, 0.0, 120.0, 90.0}, MapCamera{vehicle() - Eigen::Vector2d(90.0, 0.0), 0.1}, 96.0 / 72.0};
  for (const PageRect& taken : {PageRect{}, PageRect{0.0, 0.0, 120.0, 90.0}}) {
    const ArrowRoom room{{56.0, 24.0, 56.0, 40.0}, {taken}};
    const auto away =
        screen.frame([&](kit::Ui& ui) { return vehicle_away(ui, model, frame, room); });
    ASSERT_TRUE(away);
    EXPECT_FALSE(away->plate);
    EXPECT_NEAR(away->tip.x(), room.inside.right(), 1e-9);
  }
}

TEST_F(MapVehicle, KeepsClearOfLegendAndCardsInASmallWindow) {
  // As large as the map of the smallest useful window.
  screen.input().size_px = {400.0, 300.0};
  model.look.layer(Layer::kLegend).is_visible = true;
  model.look.measured_in_enu_m = {{0.0, 0.0}, {3.0, 4.0}};
  for (const Eigen::Vector2d& away :
       {Eigen::Vector2d(300.0, 0.0), Eigen::Vector2d(-300.0, 0.0), Eigen::Vector2d(0.0, 300.0),
        Eigen::Vector2d(-210.0, 140.0), Eigen::Vector2d(-210.0, -140.0)}) {
    look_from(away);
    ASSERT_NE(button(), nullptr);
    const kit::Rect map = screen.at(kGround).rect, words = button()->rect;
    ASSERT_EQ(state.cards.size(), 1U);
    const kit::Rect& card = state.cards[0];
    const kit::Rect legend{map.right() - state.legend.width - 20.0,
                           map.bottom() - state.legend_height_px, state.legend.width + 20.0,
                           state.legend_height_px};
    for (const kit::Rect& other : {card, legend}) {
      EXPECT_TRUE(words.right() <= other.left || words.left >= other.right() ||
                  words.bottom() <= other.top || words.top >= other.bottom());
    }
  }
}

TEST_F(MapVehicle, IsOneButtonHoweverFarItHasComeBetweenPressAndRelease) {
  look_from({34.0, 0.0});
  const std::string path = button()->path;
  EXPECT_EQ(path, "Map/Vehicle/Plate/Follow");
  screen.input().mouse_px = button()->rect.centre();
  screen.wait(1, drawing());
  screen.input().buttons[0] = true;
  screen.wait(1, drawing());
  model.look.centre_in_enu_m.x() += 2.0;
  screen.wait(1, drawing());
  EXPECT_EQ(button()->label, "vehicle 36 m");
  EXPECT_EQ(button()->path, path);
  screen.input().buttons[0] = false;
  EXPECT_THAT(screen.frame(drawing()), ElementsAre(Action(actions::Follow{Switch::kOn})));
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
