// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_scene.h"

#include <vtkActor.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <numbers>

#include "tests/widgets/views/map_page.h"

namespace nadir {
namespace map_scene_test {

/// A rectangle of ground of one colour, drawn with nothing but VTK.
vtkNew<vtkActor> ground(const MapScene& scene,
                        const PageRect& in_enu_m,
                        Rgba colour,
                        MapLayer layer = MapLayer::kPicture) {
  const auto corner = [&](double x, double y) { return scene.scene_from_enu({x, y}, layer); };
  const Eigen::Vector3d origin = corner(in_enu_m.left, in_enu_m.bottom);
  const Eigen::Vector3d right = corner(in_enu_m.right(), in_enu_m.bottom);
  const Eigen::Vector3d above = corner(in_enu_m.left, in_enu_m.top());
  const vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(origin.x(), origin.y(), origin.z());
  plane->SetPoint1(right.x(), right.y(), right.z());
  plane->SetPoint2(above.x(), above.y(), above.z());
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->ForceTranslucentOn();
  actor->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  actor->GetProperty()->SetOpacity(colour.alpha / 255.0);
  return actor;
}

class Scene : public MapPage {
 protected:
  static constexpr int kWidth = 90;
  static constexpr int kHeight = 60;

  /// Red where the rectangle lies, nothing elsewhere.
  static Truth red_in(const PageRect& in_enu_m, double metres_per_px) {
    return [=](const Eigen::Vector2d& point) -> std::optional<Rgba> {
      const double margin = 0.05 * metres_per_px;
      const PageRect inner{in_enu_m.left + margin, in_enu_m.bottom + margin,
                           in_enu_m.width - 2 * margin, in_enu_m.height - 2 * margin};
      const PageRect outer{in_enu_m.left - margin, in_enu_m.bottom - margin,
                           in_enu_m.width + 2 * margin, in_enu_m.height + 2 * margin};
      if (holds(inner, point)) return kRed;
      if (!holds(outer, point)) return kNothing;
      return std::nullopt;
    };
  }
};

TEST_F(Scene, ShowsThingsWhereTheCameraSaysHoweverItIsTurned) {
  const PageRect place{1005, 2002, 9, 4};
  MapScene scene({1000, 2000});
  const auto actor = ground(scene, place, kRed);
  scene.add(*actor, MapLayer::kPicture);
  constexpr double kPi = std::numbers::pi;
  for (const double up_rad : {kPi / 2.0, 0.0, kPi, -kPi / 2.0, 0.3, 2.5, -2.0}) {
    for (const double metres_per_px : {0.2, 0.37, 1.3}) {
      const MapCamera camera{{1007, 2001}, metres_per_px, up_rad};
      SCOPED_TRACE(std::to_string(up_rad) + " rad, " + std::to_string(metres_per_px) + " m");
      expect_everywhere(draw(scene, camera, kWidth, kHeight), camera, red_in(place, metres_per_px));
    }
  }
  scene.remove(*actor);
}

TEST_F(Scene, IsNeitherMirroredNorUpsideDown) {
  MapScene scene({0, 0});
  const auto east = ground(scene, {10, -2, 4, 4}, kRed);
  const auto north = ground(scene, {-2, 10, 4, 4}, kBlue);
  scene.add(*east, MapLayer::kPicture);
  scene.add(*north, MapLayer::kPicture);
  const Raster<Rgba> drawn = draw(scene, {{0, 0}, 0.5}, kWidth, kHeight);
  EXPECT_EQ(drawn.at(45 + 24, 30), kRed);   // right of the middle
  EXPECT_EQ(drawn.at(45, 30 - 24), kBlue);  // above it
  EXPECT_EQ(drawn.at(45 - 24, 30), kNothing);
  EXPECT_EQ(drawn.at(45, 30 + 24), kNothing);
}

TEST_F(Scene, IsExactFarFromTheOriginOfThePlane) {
  const PageRect place{500'005, -300'002, 0.9, 0.4};
  MapScene scene({500'000, -300'000});
  const auto actor = ground(scene, place, kRed);
  scene.add(*actor, MapLayer::kPicture);
  const MapCamera camera{{500'005.2, -300'001.9}, 0.02};
  expect_everywhere(draw(scene, camera, kWidth, kHeight), camera, red_in(place, 0.02));
}

TEST_F(Scene, LaysHigherLayersAboveLowerOnesInWhateverOrderTheyCome) {
  const std::array layers = {MapLayer::kPicture, MapLayer::kLabels,  MapLayer::kReconstruction,
                             MapLayer::kSurface, MapLayer::kTopview, MapLayer::kParticles};
  const std::array<std::array<std::size_t, 6>, 4> orders = {
      {{0, 1, 2, 3, 4, 5}, {5, 4, 3, 2, 1, 0}, {2, 0, 5, 1, 4, 3}, {3, 5, 0, 4, 2, 1}}};
  for (const auto& order : orders) {
    MapScene scene({0, 0});
    std::vector<vtkNew<vtkActor>> actors;
    for (const std::size_t i : order) {
      // Each one reaches further west than the ones above it.
      const double reach = 60.0 - 10.0 * static_cast<double>(i);
      actors.push_back(ground(scene, {-30, -10, reach, 20},
                              {static_cast<std::uint8_t>(40 * (i + 1)), 0, 0}, layers.at(i)));
      scene.add(*actors.back(), layers.at(i));
    }
    const Raster<Rgba> drawn = draw(scene, {{0, 0}, 1.0}, kWidth, kHeight);
    for (std::size_t i = 0; i < 6; ++i) {
      // The strip that layer i has and layer i + 1 has not.
      const int column = 45 - 30 + 60 - 10 * static_cast<int>(i) - 5;
      EXPECT_EQ(drawn.at(column, 30), (Rgba{static_cast<std::uint8_t>(40 * (i + 1)), 0, 0})) << i;
    }
    for (auto& actor : actors) scene.remove(*actor);
  }
}

TEST_F(Scene, LaysLayersInAnotherOrderAlsoThoseThatComeLater) {
  MapScene scene({0, 0});
  const auto picture = ground(scene, {-20, -20, 40, 40}, kRed, MapLayer::kPicture);
  const auto topview = ground(scene, {-10, -20, 20, 40}, kGreen, MapLayer::kTopview);
  scene.add(*picture, MapLayer::kPicture);
  scene.add(*topview, MapLayer::kTopview);
  const auto drawn = [&] { return draw(scene, {{0, 0}, 1.0}, kWidth, kHeight); };
  EXPECT_EQ(drawn().at(45, 30), kGreen);
  scene.set_order(
      std::array{MapLayer::kTopview, MapLayer::kParticles, MapLayer::kPicture, MapLayer::kLabels});
  EXPECT_EQ(drawn().at(45, 30), kRed);
  // What is made after the order was set, below and above.
  const auto particles = ground(scene, {-5, -20, 10, 40}, kBlue, MapLayer::kParticles);
  scene.add(*particles, MapLayer::kParticles);
  EXPECT_EQ(drawn().at(45, 30), kRed);
  const auto labels = ground(scene, {-2, -20, 4, 40}, kBlue, MapLayer::kLabels);
  scene.add(*labels, MapLayer::kLabels);
  EXPECT_EQ(drawn().at(45, 30), kBlue);
  EXPECT_EQ(drawn().at(45 + 8, 30), kRed);
  EXPECT_FALSE(scene.holds_above(MapLayer::kLabels));
  EXPECT_TRUE(scene.holds_above(MapLayer::kParticles));
  // What an order does not name lies below it.
  scene.set_order(std::array{MapLayer::kTopview});
  EXPECT_EQ(drawn().at(45, 30), kGreen);
  for (const auto* actor : {&picture, &topview, &particles, &labels}) scene.remove(**actor);
  EXPECT_EQ(drawn().at(45, 30), kNothing);
}

TEST_F(Scene, ShowsSomeLayersAloneAndHidesNothingForGood) {
  MapScene scene({0, 0});
  const auto picture = ground(scene, {-20, -20, 40, 40}, kRed, MapLayer::kPicture);
  const auto topview = ground(scene, {-10, -10, 20, 20}, kGreen, MapLayer::kTopview);
  const auto hidden = ground(scene, {-10, -10, 20, 20}, kBlue, MapLayer::kParticles);
  scene.add(*picture, MapLayer::kPicture);
  scene.add(*topview, MapLayer::kTopview);
  scene.add(*hidden, MapLayer::kParticles);
  hidden->VisibilityOff();
  const auto drawn = [&] { return draw(scene, {{0, 0}, 1.0}, kWidth, kHeight); };
  scene.show_only(std::array{MapLayer::kTopview, MapLayer::kParticles});
  EXPECT_EQ(drawn().at(45, 30), kGreen);
  EXPECT_EQ(drawn().at(45 + 15, 30), kNothing);
  scene.show_all();
  EXPECT_EQ(drawn().at(45, 30), kGreen) << "what was hidden before stays so";
  EXPECT_EQ(drawn().at(45 + 15, 30), kRed);
  for (const auto* actor : {&picture, &topview, &hidden}) scene.remove(**actor);
}

TEST_F(Scene, BlendsHalfTransparentLayersFromBelow) {
  MapScene scene({0, 0});
  const auto above = ground(scene, {-10, -10, 20, 20}, {0, 0, 255, 128}, MapLayer::kTopview);
  const auto below = ground(scene, {-20, -20, 40, 40}, kRed, MapLayer::kPicture);
  scene.add(*above, MapLayer::kTopview);
  scene.add(*below, MapLayer::kPicture);
  const Raster<Rgba> drawn = draw(scene, {{0, 0}, 1.0}, kWidth, kHeight);
  EXPECT_LE(difference(drawn.at(45, 30), {127, 0, 128}), 1);
  EXPECT_EQ(drawn.at(45 + 15, 30), kRed);
}

TEST_F(Scene, ShowsWhatIsTranslucentInItsOwnColourOnAClearBackgroundOfAny) {
  MapScene scene({0, 0});
  const auto half = ground(scene, {-20, -20, 40, 40}, {255, 0, 0, 128}, MapLayer::kLabels);
  scene.add(*half, MapLayer::kLabels);
  for (const Rgba background : {Rgba{250, 240, 230}, kBlue, Rgba{0, 0, 0}}) {
    scene.set_background(background, true);
    const Raster<Rgba> drawn = draw(scene, {{0, 0}, 1.0}, kWidth, kHeight);
    EXPECT_LE(difference(drawn.at(45, 30), {255, 0, 0, 128}), 2);
    EXPECT_EQ(drawn.at(1, 1), kNothing);
  }
  scene.set_background(kBlue, false);
  EXPECT_LE(difference(draw(scene, {{0, 0}, 1.0}, kWidth, kHeight).at(45, 30), {128, 0, 127}), 1);
  scene.remove(*half);
}

TEST_F(Scene, TellsWhichLayersHaveChanged) {
  MapScene scene({0, 0});
  const std::array picture = {MapLayer::kPicture}, topview = {MapLayer::kTopview};
  const auto below = ground(scene, {-20, -20, 40, 40}, kRed, MapLayer::kPicture);
  const auto above = ground(scene, {-10, -10, 20, 20}, kGreen, MapLayer::kTopview);
  scene.add(*below, MapLayer::kPicture);
  scene.add(*above, MapLayer::kTopview);
  static_cast<void>(draw(scene, {{0, 0}, 1.0}, kWidth, kHeight));
  const auto of_picture = scene.stamps(picture), of_topview = scene.stamps(topview);
  static_cast<void>(draw(scene, {{5, 5}, 1.0}, kWidth, kHeight));
  EXPECT_EQ(scene.stamps(picture), of_picture) << "the camera is none of them";
  above->GetProperty()->SetOpacity(0.5);
  EXPECT_EQ(scene.stamps(picture), of_picture);
  EXPECT_NE(scene.stamps(topview), of_topview);
  EXPECT_EQ(scene.stamps({}).size(), 2U) << "all";
  scene.remove(*below);
  EXPECT_TRUE(scene.stamps(picture).empty());
  scene.remove(*above);
}

TEST_F(Scene, ForgetsWhatIsTakenOut) {
  MapScene scene({0, 0});
  const auto first = ground(scene, {-20, -20, 40, 40}, kRed, MapLayer::kPicture);
  const auto second = ground(scene, {-20, -20, 40, 40}, kBlue, MapLayer::kLabels);
  const auto third = ground(scene, {-20, -20, 40, 40}, kGreen, MapLayer::kPicture);
  scene.add(*first, MapLayer::kPicture);
  scene.add(*second, MapLayer::kLabels);
  const auto middle = [&] { return draw(scene, {{0, 0}, 1.0}, kWidth, kHeight).at(45, 30); };
  EXPECT_EQ(middle(), kBlue);
  scene.remove(*first);
  scene.remove(*first);  // once more does nothing
  scene.add(*third, MapLayer::kPicture);
  EXPECT_EQ(middle(), kBlue);
  scene.remove(*second);
  EXPECT_EQ(middle(), kGreen);
  scene.remove(*third);
  EXPECT_EQ(middle(), kNothing);
}

TEST_F(Scene, HasTheBackgroundThatItIsGiven) {
  MapScene scene({0, 0});
  EXPECT_EQ(draw(scene, {}, kWidth, kHeight), Raster<Rgba>(kWidth, kHeight, kNothing));
  scene.set_background({20, 130, 240}, false);
  EXPECT_EQ(draw(scene, {}, kWidth, kHeight), Raster<Rgba>(kWidth, kHeight, Rgba{20, 130, 240}));
  scene.set_background({20, 130, 240}, true);
  EXPECT_EQ(draw(scene, {}, kWidth, kHeight), Raster<Rgba>(kWidth, kHeight, kNothing));
}

}  // namespace map_scene_test
}  // namespace nadir
