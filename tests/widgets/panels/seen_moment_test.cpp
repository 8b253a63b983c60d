// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/seen_moment.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/support/made_topview.h"
#include "tests/widgets/panels/made_moment.h"

namespace nadir {
namespace seen_moment_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(SeenMoment, HasFourPicturesOfOneShape) {
  const MadeMoment made;
  SeenMomentCache cache;
  const SeenMoment& seen = cache.of(made.step, made.map, ThemeName::kDark);
  EXPECT_EQ(seen.why_not, "");
  for (const Picture* picture :
       {&seen.seen_picture, &seen.agreement_picture, &seen.estimate_picture, &seen.truth_picture}) {
    ASSERT_TRUE(*picture);
    EXPECT_EQ(picture->pixels->width(), seen.topview.labels.width());
    EXPECT_EQ(picture->pixels->height(), seen.topview.labels.height());
  }
  EXPECT_EQ(*seen.at_truth->share(), 1.0);  // the topview is what the map has there
  EXPECT_LT(*seen.at_estimate.share(), 1.0);
}

TEST(SeenMoment, IsMadeOnceAStepAndStaysUntilTheNextIsDecoded) {
  const MadeMoment made;
  SeenMomentCache cache;
  const auto first = cache.of(made.step, made.map, ThemeName::kDark).seen_picture.pixels;
  EXPECT_EQ(cache.of(made.step, made.map, ThemeName::kDark).seen_picture.pixels, first);
  EXPECT_EQ(cache.of(nullptr, made.map, ThemeName::kDark).seen_picture.pixels, first);
  EXPECT_NE(cache.of(made.decoded(9), made.map, ThemeName::kDark).seen_picture.pixels, first);
}

TEST(SeenMoment, SaysWhatIsMissing) {
  const MadeMoment made;
  SeenMomentCache cache;
  RunStep step = *made.step;
  step.topview.reset();
  EXPECT_EQ(cache.of(std::make_shared<const RunStep>(step), made.map, ThemeName::kDark).why_not,
            "the run holds no topviews");
  step.topview.emplace();
  EXPECT_EQ(cache.of(std::make_shared<const RunStep>(step), made.map, ThemeName::kDark).why_not,
            "nothing was seen in this step");
  step.topview = topview_of({{{1, 1}, kRoad}}, 0.5);
  const SeenMoment& unlike =
      cache.of(std::make_shared<const RunStep>(step), made.map, ThemeName::kDark);
  EXPECT_EQ(unlike.why_not, "the topview has cells of 0.5 m, this map of 0.25 m");
  EXPECT_TRUE(unlike.seen_picture);
  EXPECT_FALSE(unlike.agreement_picture);
  const SeenMoment& alone = cache.of(made.step, nullptr, ThemeName::kDark);
  EXPECT_TRUE(alone.seen_picture);
  EXPECT_FALSE(alone.estimate_picture);
}

TEST(SeenCell, SaysWhatWasSeenAndWhatTheMapHasThereAtBothPoses) {
  const MadeMoment made;
  SeenMomentCache cache;
  const SeenMoment& seen = cache.of(made.step, made.map, ThemeName::kDark);
  const OverheadMap& map = made.map->map();
  int compared = 0;
  for (int row = 0; row < seen.topview.labels.height(); ++row) {
    for (int column = 0; column < seen.topview.labels.width(); ++column) {
      const SeenCell cell = seen_cell(seen, {column, row});
      if (cell.seen == kUnclassified) continue;
      const Eigen::Vector2d in_body(cell.ahead_m, cell.left_m);
      EXPECT_EQ(cell.at_truth, map.class_at(*made.step->truth_in_enu * in_body));
      EXPECT_EQ(cell.at_estimate, map.class_at(made.step->estimate.moments.mean * in_body));
      EXPECT_EQ(cell.seen, *cell.at_truth);
      ++compared;
    }
  }
  EXPECT_EQ(compared, static_cast<int>(made.step->topview->cells.size()));
}

TEST(SeenCell, IsSaidInWords) {
  SeenCell cell{kRoad, kSidewalk, kRoad, 3.125, -1.125};
  EXPECT_THAT(seen_cell_words(cell),
              ElementsAre("saw road", "map at the estimate: sidewalk", "map at the truth: road",
                          "3.1 m ahead, 1.1 m to the right"));
  cell = {kUnclassified, {}, {}, -3.125, 1.125};
  EXPECT_THAT(seen_cell_words(cell),
              ElementsAre("nothing was seen here", "3.1 m behind, 1.1 m to the left"));
}

CameraMoment made_camera() {
  CameraMoment camera;
  camera.image = ColourRaster(4, 2, Colour{100, 100, 100});
  camera.labels = Raster<ClassId>(2, 1, kUnclassified);
  camera.labels.at(1, 0) = kRoad;
  camera.depth_m = Raster<float>(2, 1, 0.0F);
  camera.depth_m.at(1, 0) = 5.0F;
  return camera;
}

TEST(CameraPicture, MixesLabelsOverAnImageOfAnotherSize) {
  const CameraMoment camera = made_camera();
  const Rgba road = class_colour(kRoad);
  const Raster<Rgba> half = camera_picture(camera, 0.5);
  EXPECT_EQ(half.at(0, 0), (Rgba{100, 100, 100}));
  EXPECT_EQ(half.at(1, 1), (Rgba{100, 100, 100}));
  EXPECT_NEAR(half.at(2, 0).red, (100 + road.red) / 2.0, 0.51);
  EXPECT_NEAR(half.at(3, 1).green, (100 + road.green) / 2.0, 0.51);
  EXPECT_EQ(camera_picture(camera, 0.0).at(3, 0), (Rgba{100, 100, 100}));
  EXPECT_EQ(camera_picture(camera, 1.0).at(3, 0), road);
}

TEST(CameraPicture, IsTheLabelsWhereThereIsNoImage) {
  CameraMoment camera = made_camera();
  camera.image = {};
  const Raster<Rgba> picture = camera_picture(camera, 0.3);
  EXPECT_EQ(picture.at(1, 0), class_colour(kRoad));
  EXPECT_EQ(picture.at(0, 0), (Rgba{0, 0, 0}));
}

TEST(DepthPicture, IsLightNearAndClearWhereNothingWasMeasured) {
  Raster<float> depth(4, 1, 0.0F);
  depth.at(1, 0) = 1.0F;
  depth.at(2, 0) = 50.0F;
  depth.at(3, 0) = std::nanf("");
  const Raster<Rgba> picture = depth_picture(depth);
  EXPECT_EQ(picture.at(0, 0).alpha, 0);
  EXPECT_EQ(picture.at(3, 0).alpha, 0);
  const auto lightness = [](Rgba c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; };
  EXPECT_GT(lightness(picture.at(1, 0)), lightness(picture.at(2, 0)) + 50.0);
}

TEST(CameraPictureCache, MakesAPictureOnceAndKeepsItWhileTheNextIsDecoded) {
  CameraPictureCache cache;
  EXPECT_FALSE(cache.of(nullptr, CameraKind::kImage, 0.5));
  const auto camera = std::make_shared<const CameraMoment>(made_camera());
  const auto first = cache.of(camera, CameraKind::kImage, 0.5).pixels;
  EXPECT_EQ(cache.of(camera, CameraKind::kImage, 0.5).pixels, first);
  EXPECT_EQ(cache.of(nullptr, CameraKind::kImage, 0.5).pixels, first);
  EXPECT_NE(cache.of(camera, CameraKind::kImage, 0.6).pixels, first);
  EXPECT_EQ(cache.of(camera, CameraKind::kDepth, 0.6).pixels->width(), 2);
}

}  // namespace seen_moment_test
}  // namespace nadir
