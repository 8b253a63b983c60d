// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/moment_panel.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numbers>

#include "core/eval/consistency.h"
#include "tests/widgets/panels/made_moment.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/camera_panel.h"
#include "widgets/panels/scene_panel.h"
#include "widgets/panels/topview_panel.h"

namespace nadir {
namespace moment_panel_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::shared_ptr<const CameraMoment> made_frame() {
  CameraMoment camera;
  camera.image = ColourRaster(64, 48, Colour{100, 110, 120});
  camera.labels = Raster<ClassId>(64, 48, kRoad);
  camera.depth_m = Raster<float>(64, 48, 7.25F);
  return std::make_shared<const CameraMoment>(std::move(camera));
}

class MomentPanelTest : public ::testing::Test {
 protected:
  auto drawing() {
    return [this](kit::Ui& ui) { return draw_moment_panel(ui, model, state); };
  }
  MadeMoment made;
  MomentModel model = made.moment();
  MomentPanelState state;
  kit::HeadlessUi screen{ThemeName::kDark, 1.0, {380.0, 1600.0}};
};

TEST_F(MomentPanelTest, SaysTheNumbersOfTheStep) {
  screen.wait(2, drawing());
  EXPECT_EQ(screen.at("Moment/Facts/position error").value, "3.00 m");
  EXPECT_EQ(screen.at("Moment/Facts/orientation error").value, "0.0 °");
  EXPECT_EQ(screen.at("Moment/Facts/sigma east, north").value, "0.50, 0.50 m");
  EXPECT_EQ(screen.at("Moment/Facts/sigma heading").value, "1.7 °");
  EXPECT_EQ(screen.at("Moment/Facts/effective sample size").value, "500 of 1000");
  // 3 m off with half a metre of deviation: 36 in squares.
  EXPECT_EQ(screen.at("Moment/Facts/NEES of this step").value, "36.0, above 9.35");
  EXPECT_THAT(screen.at("Moment/Facts/NEES of this step").tooltip,
              HasSubstr("chi-square bounds 0.22 and 9.35 (3 degrees of freedom). One step is no "
                        "test of consistency"));
  EXPECT_FALSE(screen.has("Moment/Facts/modes"));
}

TEST_F(MomentPanelTest, SaysWhatIsNotKnownInsteadOfANumber) {
  made.document = made_document(20, [](RunStep& step) {
    step.truth_in_enu.reset();
    step.agreement.reset();
  });
  model.document = made.document;
  screen.wait(2, drawing());
  EXPECT_EQ(screen.at("Moment/Facts/position error").value, "not known");
  EXPECT_EQ(screen.at("Moment/Facts/agreement").value, "not known");
  EXPECT_FALSE(screen.has("Moment/Facts/NEES of this step"));
}

TEST_F(MomentPanelTest, HasABarForEachClassAtBothPoses) {
  screen.wait(2, drawing());
  EXPECT_EQ(screen.at("Moment/Agreement by class/Agreement/all/truth").value, "100 %");
  const auto share =
      *cell_agreement(*made.step->topview, made.map->map(), made.step->estimate.moments.mean)
           .share();
  EXPECT_EQ(screen.at("Moment/Agreement by class/Agreement/all/estimate").value,
            fmt::format("{:.0f} %", 100.0 * share));
}

TEST_F(MomentPanelTest, HasADashForAClassThatHasNoCellsOnKnownGround) {
  RunStep lost = *made.step;
  lost.estimate.moments.mean = {1e4, 1e4, 0.0};  // far off the map
  model.step = std::make_shared<const RunStep>(lost);
  screen.wait(2, drawing());
  for (const char* row : {"road", "all"}) {
    const std::string path = std::string("Moment/Agreement by class/Agreement/") + row;
    EXPECT_EQ(screen.at(path + "/estimate").value, "–") << row;
    EXPECT_EQ(screen.at(path + "/truth").value, "100 %") << row;
  }
}

TEST_F(MomentPanelTest, HoveringAPictureSaysWhatTheCellIs) {
  screen.hover("Moment/Topview and map/seen picture", drawing());
  EXPECT_TRUE(screen.shows("Topview and map"));
  EXPECT_THAT(screen.tooltip() + screen.words(), HasSubstr("map at the truth"));
}

TEST_F(MomentPanelTest, ShowsTheCamerasFrameWithLabelsAsStrongAsWished) {
  model.camera = made_frame();
  model.has_camera_frame = true;
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.has("Moment/Camera/Camera picture"));
  screen.drag("Moment/Camera/Label opacity", 500.0, 0.0, drawing());
  EXPECT_DOUBLE_EQ(state.camera.label_opacity, 1.0);
  screen.click("Moment/Camera/##Show/Depth", drawing());
  EXPECT_EQ(state.camera.kind, CameraKind::kDepth);
  EXPECT_FALSE(screen.wait(1, drawing()).size());
  EXPECT_FALSE(screen.has("Moment/Camera/Label opacity"));
}

TEST_F(MomentPanelTest, WithoutAFlightItSaysWhereFramesComeFrom) {
  model.has_flight = false;
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows("The flight of this run is not open"));
}

TEST_F(MomentPanelTest, WithoutARunItOffersTheDemo) {
  model = {};
  EXPECT_THAT(screen.click("Moment/Open the demo", drawing()),
              ElementsAre(Action(actions::OpenDemo{})));
  model.is_reading = true;
  model.run_name = "loop";
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows("loop is being read"));
}

TEST(NeesWords, SayHowOneStepLiesToTheBoundsAndNoMore) {
  const double upper = chi_square_quantile(0.975, 3.0), lower = chi_square_quantile(0.025, 3.0);
  EXPECT_EQ(nees_words(3.0), "within 9.35");
  EXPECT_EQ(nees_words(upper - 0.01), "within 9.35");
  EXPECT_EQ(nees_words(upper + 0.01), "above 9.35");
  EXPECT_EQ(nees_words(lower - 0.01), "below 0.22");
  EXPECT_EQ(nees_look(upper + 0.01), kit::TextLook::kWarning);
  EXPECT_EQ(nees_look(0.01), kit::TextLook::kNumber) << "one careful step is no warning";
}

TEST_F(MomentPanelTest, SaysOfEachKindOfPictureWhetherTheFrameHasIt) {
  model.camera = made_frame();
  model.has_camera_frame = true;
  screen.click("Moment/Camera/##Show/Labels", drawing());
  EXPECT_EQ(state.camera.kind, CameraKind::kLabels);
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.has("Moment/Camera/Camera picture"));
  screen.click("Moment/Camera/##Show/Confidence", drawing());
  screen.wait(2, drawing());
  EXPECT_FALSE(screen.has("Moment/Camera/Camera picture"));
  EXPECT_TRUE(screen.shows("holds no confidence of its labels"));
  CameraMoment bare = *model.camera;
  bare.depth_m = {};
  model.camera = std::make_shared<const CameraMoment>(bare);
  screen.click("Moment/Camera/##Show/Depth", drawing());
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows("This frame has no depth"));
  bare.image = {};
  model.camera = std::make_shared<const CameraMoment>(bare);
  screen.click("Moment/Camera/##Show/Image", drawing());
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.has("Moment/Camera/Camera picture")) << "the labels stand in for it";
}

TEST(CameraPanel, MagnifiesAtTheMouseAndShowsAllAgainByADoubleClick) {
  MadeMoment made;
  MomentModel model = made.moment();
  model.camera = made_frame();
  model.has_camera_frame = true;
  CameraPanelState state;
  kit::HeadlessUi screen;
  const auto draw = [&](kit::Ui& ui) { return draw_camera_panel(ui, model, state); };
  screen.scroll("Camera/Camera picture", 3.0, draw);
  EXPECT_NEAR(state.camera.zoom.factor, 1.25 * 1.25 * 1.25, 1e-9);
  screen.drag("Camera/Camera picture", 100.0, 0.0, draw);
  EXPECT_LT(state.camera.zoom.centre.x(), 0.5);
  screen.double_click("Camera/Camera picture", draw);
  EXPECT_EQ(state.camera.zoom, PictureZoom{});
}

TEST(PicturePlace, FitsCentresAndNeverLeavesABorderThatItCouldFill) {
  const PageRect page{0.0, 0.0, 200.0, 100.0};
  EXPECT_EQ(picture_place(40.0, 40.0, page, {}), (PageRect{50.0, 0.0, 100.0, 100.0}));
  EXPECT_EQ(picture_place(40.0, 20.0, page, {}), page);
  PictureZoom zoom;
  zoom.factor = 2.0;
  zoom.centre = {0.0, 0.0};  // its upper left corner
  EXPECT_EQ(picture_place(40.0, 20.0, page, zoom), (PageRect{0.0, -100.0, 400.0, 200.0}));
  zoom.centre = {1.0, 1.0};
  EXPECT_EQ(picture_place(40.0, 20.0, page, zoom), (PageRect{-200.0, 0.0, 400.0, 200.0}));
}

TEST(TopviewPanel, ShowsWhatIsAskedFor) {
  MadeMoment made;
  const MomentModel model = made.moment();
  TopviewPanelState state;
  kit::HeadlessUi screen;
  const auto draw = [&](kit::Ui& ui) { return draw_topview_panel(ui, model, state); };
  screen.click("Topview/##Show/Fit", draw);
  EXPECT_EQ(state.shown, TopviewPanelState::Shown::kAgreement);
  screen.click("Topview/##Show/At truth", draw);
  EXPECT_EQ(state.shown, TopviewPanelState::Shown::kMapAtTruth);
  EXPECT_TRUE(screen.has("Topview/Topview picture"));
}

TEST(TopviewPanel, SaysWhyThereIsNoPicture) {
  MadeMoment made;
  MomentModel model = made.moment();
  RunStep step = *made.step;
  step.topview.reset();
  model.step = std::make_shared<const RunStep>(step);
  TopviewPanelState state;
  kit::HeadlessUi screen;
  screen.wait(2, [&](kit::Ui& ui) { return draw_topview_panel(ui, model, state); });
  EXPECT_TRUE(screen.shows("the run holds no topviews"));
}

constexpr PageRect kScene{0.0, 0.0, 800.0, 600.0};

TEST(SceneCamera, MovingKeepsTheGroundUnderTheMouse) {
  SpaceCamera camera = behind({10.0, 20.0, 0.7});
  camera.down_rad = 1.5;  // nearly from above, where a pixel is the same length everywhere
  const Eigen::Vector2d middle = kScene.centre();
  const Eigen::Vector2d held = *camera.ground_from_page(middle, kScene);
  const Eigen::Vector2d drag(40.0, -25.0);
  const SpaceCamera moved = shifted(camera, drag, kScene);
  const Eigen::Vector2d now = *moved.ground_from_page(middle + drag, kScene);
  EXPECT_LT((now - held).norm(), 0.05 * (camera.distance_m / 35.0));
}

TEST(SceneCamera, TurningKeepsTargetAndDistance) {
  const SpaceCamera camera = behind({10.0, 20.0, 0.7});
  const SpaceCamera turned = orbited(camera, {400.0, 0.0}, kScene);
  EXPECT_EQ(turned.target_in_enu_m, camera.target_in_enu_m);
  EXPECT_NEAR((turned.eye_in_enu_m() - turned.target_in_enu_m).norm(), 35.0, 1e-9);
  EXPECT_NEAR(wrap_rad(camera.yaw_rad - turned.yaw_rad), std::numbers::pi / 2.0, 1e-9);
  EXPECT_GE(orbited(camera, {0.0, 1e6}, kScene).down_rad, 0.0);
  EXPECT_LE(orbited(camera, {0.0, -1e6}, kScene).down_rad, std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(nearer(camera, 7.0).distance_m, 5.0);
  EXPECT_DOUBLE_EQ(nearer(camera, 1e9).distance_m, 0.5);
}

TEST(ScenePanel, LooksFromBehindTheEstimateAndGoesWithItUntilItIsMoved) {
  MadeMoment made;
  MomentModel model = made.moment();
  SceneState state;
  kit::HeadlessUi screen;
  std::vector<SceneWish> wishes;
  state.scene = [&](const SceneWish& wish) {
    wishes.push_back(wish);
    return kit::TextureId{0};
  };
  const auto draw = [&](kit::Ui& ui) { return draw_scene_panel(ui, model, state); };
  screen.wait(2, draw);
  const Eigen::Vector2d first = model.recorded().estimate.moments.mean.translation_m();
  EXPECT_EQ(wishes.back().camera.target_in_enu_m.head<2>(), first);
  model.index = 12;
  screen.wait(1, draw);
  EXPECT_EQ(state.camera.target_in_enu_m.x(), first.x() + 2.0);
  screen.drag("Scene/View", 80.0, 0.0, draw, kit::MouseButton::kRight);
  EXPECT_FALSE(state.is_following);
  const Eigen::Vector3d target = state.camera.target_in_enu_m;
  model.index = 14;
  screen.drag("Scene/View", 80.0, 0.0, draw);
  EXPECT_EQ(state.camera.target_in_enu_m, target);
  screen.click("Scene/Behind", draw);
  screen.wait(1, draw);
  EXPECT_TRUE(state.is_following);
}

}  // namespace moment_panel_test
}  // namespace nadir
