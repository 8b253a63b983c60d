// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/cloud_view.h"

#include <limits>
#include <numbers>

#include "tests/widgets/views/space_page.h"
#include "widgets/views/space_picture.h"
#include "widgets/views/theme.h"

namespace nadir {
namespace cloud_view_test {

class Cloud : public SpacePage {
 protected:
  /// One point of each class, here and there in front of the body.
  static SemanticCloud scattered() {
    SemanticCloud cloud;
    for (int id = 0; id < kClassCount; ++id) {
      cloud.points_in_level_m.emplace_back(6.0F + 0.8F * static_cast<float>(id % 5),
                                           -4.0F + 0.6F * static_cast<float>(id),
                                           -1.5F + 0.4F * static_cast<float>(id % 7));
      cloud.labels.push_back(static_cast<ClassId>(id));
    }
    return cloud;
  }
  /// A camera behind the body.
  static SpaceCamera behind(const Rigid2& body) {
    const Eigen::Vector2d target = body * Eigen::Vector2d(7.0, 0.5);
    return {{target.x(), target.y(), 1.0}, 16.0, body.yaw_rad + 0.3, 0.5, 0.8};
  }
  static Rigid3 at(const Rigid2& body, double height_m) {
    return {rotation_of({0.0, 0.0, body.yaw_rad}), {body.x_m, body.y_m, height_m}};
  }
};

TEST_F(Cloud, DrawsEachPointWhereTheCameraSeesItInTheColourOfItsClass) {
  for (const Rigid2& body : {Rigid2{0, 0, 0}, Rigid2{120, -35, 2.2}, Rigid2{-3, 8, -1.0}}) {
    SpaceScene scene({100.0, -20.0});
    CloudView view(scene);
    view.set_size_pt(5.0);
    const SemanticCloud cloud = scattered();
    view.show(cloud);
    view.place(at(body, 2.0));
    const SpaceCamera camera = behind(body);
    const PinholeOracle oracle(camera, kPage);
    const Raster<Rgba> drawn = draw(scene, camera);
    int seen = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      // By hand: the body's heading turns the point, its place and height move it.
      const Eigen::Vector3d level = cloud.points_in_level_m[i].cast<double>();
      const Eigen::Vector2d plane = body * Eigen::Vector2d(level.head<2>());
      const auto expected = oracle.page_from_enu({plane.x(), plane.y(), 2.0 + level.z()});
      ASSERT_TRUE(expected);
      const auto found = centre_of(drawn, class_colour(cloud.labels[i]));
      if (!found || count_of(drawn, class_colour(cloud.labels[i])) != 25)
        continue;  // partly hidden
      ++seen;
      EXPECT_LT((*found - *expected).cwiseAbs().maxCoeff(), 0.51)
          << class_info(cloud.labels[i]).name;
    }
    EXPECT_GE(seen, 10);
  }
}

TEST_F(Cloud, IsExactFarFromTheOriginOfThePlane) {
  const Rigid2 body{500'005.25, -300'002.5, 0.4};
  SpaceScene scene({500'000.0, -300'000.0});
  CloudView view(scene);
  view.set_size_pt(3.0);
  view.show({{{7.0F, 0.5F, -1.0F}}, {kCar}});
  view.place(at(body, 2.0));
  SpaceCamera camera = behind(body);
  camera.distance_m = 2.0;
  const Eigen::Vector2d plane = body * Eigen::Vector2d(7.0, 0.5);
  const auto expected = PinholeOracle(camera, kPage).page_from_enu({plane.x(), plane.y(), 1.0});
  const auto found = centre_of(draw(scene, camera), class_colour(kCar));
  ASSERT_TRUE(found && expected);
  EXPECT_LT((*found - *expected).cwiseAbs().maxCoeff(), 0.51);
}

TEST_F(Cloud, HidesWhatIsBehindButNeverBehindTheGround) {
  SpaceScene scene({0.0, 0.0});
  SpacePicture ground(scene, SpaceLayer::kGround);
  ground.show(Raster<Rgba>(4, 4, kWhite), false);
  ground.place({-50, 50, 0}, {100, 0, 0}, {0, -100, 0});
  CloudView view(scene);
  view.set_size_pt(9.0);
  const SpaceCamera camera{{0, 0, 0}, 20.0, 0.0, 0.5, 0.6};
  // The second lies behind the first on the same ray; the third is under the ground by the noise of its depth.
  const Eigen::Vector3d eye = camera.eye_in_enu_m();
  const Eigen::Vector3f near = (0.5 * eye).cast<float>();
  const Eigen::Vector3f far = (0.1 * eye).cast<float>();
  view.show({{near, far, {0.0F, 4.0F, -0.4F}}, {kCar, kBuilding, kPole}});
  view.place({});
  const Raster<Rgba> drawn = draw(scene, camera);
  EXPECT_EQ(count_of(drawn, class_colour(kCar)), 81);
  EXPECT_EQ(count_of(drawn, class_colour(kBuilding)), 0);
  EXPECT_EQ(count_of(drawn, class_colour(kPole)), 81);
}

TEST_F(Cloud, LeavesOutWhatHasNoPlaceOrNoClass) {
  SpaceScene scene({0.0, 0.0});
  CloudView view(scene);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  view.show({{{1, 0, 0}, {nan, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {kCar, kCar, kUnclassified, kRoad}});
  EXPECT_EQ(view.drawn_count(), 2U);
  view.show({});
  EXPECT_EQ(view.drawn_count(), 0U);
  const SpaceCamera camera;
  EXPECT_EQ(draw(scene, camera), Raster<Rgba>(kPageWidth, kPageHeight, kNothing));
}

TEST_F(Cloud, IsReplacedMovedHiddenAndTakenAwayInPlace) {
  SpaceScene scene({0.0, 0.0});
  const SpaceCamera camera{{0, 0, 0}, 20.0, 0.0, 0.5, 0.6};
  auto view = std::make_unique<CloudView>(scene);
  view->set_size_pt(5.0);
  view->show({{{0, 0, 0}, {0, 1, 0}}, {kCar, kRoad}});
  view->place({});
  EXPECT_EQ(count_of(draw(scene, camera), class_colour(kRoad)), 25);
  view->show({{{0, 0, 0}}, {kCar}});
  Raster<Rgba> drawn = draw(scene, camera);
  EXPECT_EQ(count_of(drawn, class_colour(kRoad)), 0);
  EXPECT_LT((*centre_of(drawn, class_colour(kCar)) - kPage.centre()).norm(), 1.0);
  view->place(
      {Eigen::Quaterniond::Identity(), {0.0, -2.0, 0.0}});  // to the right of a view to the east
  drawn = draw(scene, camera);
  EXPECT_GT(centre_of(drawn, class_colour(kCar))->x(), kPage.centre().x() + 5.0);
  view->set_size_pt(3.0);
  EXPECT_EQ(count_of(draw(scene, camera), class_colour(kCar)), 9);
  view->set_visible(false);
  EXPECT_EQ(count_of(draw(scene, camera), class_colour(kCar)), 0);
  view->set_visible(true);
  view.reset();
  EXPECT_EQ(draw(scene, camera), Raster<Rgba>(kPageWidth, kPageHeight, kNothing));
}

}  // namespace cloud_view_test
}  // namespace nadir
