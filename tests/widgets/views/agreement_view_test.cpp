// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/agreement_view.h"

#include <limits>
#include <numbers>

#include "tests/support/drawn_map.h"
#include "tests/support/scenery.h"
#include "tests/widgets/views/drawn_chart.h"
#include "tests/widgets/views/map_page.h"

namespace nadir {
namespace agreement_view_test {

constexpr double kPi = std::numbers::pi;

const Theme& light() { return theme(ThemeName::kLight); }

/// A topview of 2 x 3 cells ahead, all road.
SemanticTopview road_ahead(double metres_per_cell) {
  TopviewRaster raster{Raster<ClassId>(3, 4, kUnclassified), 2, 4};
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) raster.labels.at(column, row) = kRoad;
  }
  return topview_from_raster(raster, metres_per_cell);
}

CellAgreement::Count count_of(const Raster<Rgba>& picture) {
  CellAgreement::Count count;
  for (const Rgba pixel : picture.values()) {
    if (pixel == kNothing) continue;
    if (pixel == light().agreement) {
      ++count.agreeing;
    } else if (pixel == light().line) {
      ++count.unknown;
    } else {
      ++count.disagreeing;
    }
  }
  return count;
}

TEST(AgreementPicture, HasOnePixelForEachCellThatWasSeen) {
  const OverheadMap map = patchwork_map(200, 200, 0.5);
  const Rigid2 pose{50.2, 49.7, 0.6};
  const SemanticTopview seen = perfect_topview(map, pose, 15.0);
  for (const Rigid2& laid : {pose, Rigid2{52.0, 47.0, 0.4}, Rigid2{99.0, 50.0, 0.0}}) {
    const CellAgreement agreement = cell_agreement(seen, map, laid);
    EXPECT_EQ(count_of(agreement_picture(seen, agreement, topview_raster(seen), light())),
              agreement.total());
  }
}

TEST(AgreementPicture, IsToldApartInGreyByStripes) {
  // Everything disagrees.
  const OverheadMap map = drawn_map(1.0, std::vector<std::string>(40, std::string(40, 'T')));
  TopviewRaster raster{Raster<ClassId>(16, 16, kRoad), 8, 16};
  const SemanticTopview seen = topview_from_raster(raster, 1.0);
  const CellAgreement agreement = cell_agreement(seen, map, {20.0, 20.0, 0.0});
  ASSERT_EQ(agreement.total().disagreeing, 256U);
  const Raster<Rgba> picture = agreement_picture(seen, agreement, raster, light());
  const auto luma = [](Rgba colour) {
    return 0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue;
  };
  const Rgba dark = picture.at(0, 0);
  EXPECT_LT(luma(dark), luma(light().disagreement) - 40.0);
  EXPECT_LT(luma(dark), luma(light().agreement) - 40.0);
  // Half of the cells, in stripes along one diagonal.
  EXPECT_EQ(std::count(picture.values().begin(), picture.values().end(), dark), 128);
  for (int i = 0; i + 1 < 16; ++i) EXPECT_EQ(picture.at(i, 15 - i), picture.at(i + 1, 14 - i));
}

TEST(AgreementPicture, NeedsTheAgreementOfItsOwnTopview) {
  const SemanticTopview seen = road_ahead(1.0);
  EXPECT_THROW((void)agreement_picture(seen, {}, topview_raster(seen), light()), std::logic_error);
}

TEST(AgreementLegend, CountsWhatThePictureShows) {
  CellAgreement agreement{.of_cell = std::vector<CellVerdict>(8), .of_class = {}};
  agreement.of_class[kRoad] = {3, 2, 1};
  agreement.of_class[kTerrain] = {1, 0, 1};
  const std::vector<LegendEntry> legend = agreement_legend(agreement, light());
  ASSERT_EQ(legend.size(), 3U);
  EXPECT_EQ(legend[0].name, "agrees 4 cells (50 %)");
  EXPECT_EQ(legend[1].name, "disagrees 2 cells (25 %)");
  EXPECT_EQ(legend[2].name, "not known to the map 2 cells (25 %)");
  EXPECT_EQ(legend[0].colour, light().agreement);
  EXPECT_EQ(legend[1].colour, light().disagreement);
  EXPECT_EQ(legend[1].kind, LegendEntry::Kind::kStripedBar);
  EXPECT_TRUE(agreement_legend({}, light()).empty());
}

TEST(Legend, ShowsStripesInsideOfTheBarOfWhatDisagrees) {
  CellAgreement agreement{.of_cell = std::vector<CellVerdict>(1), .of_class = {}};
  agreement.of_class[kRoad] = {0, 1, 0};
  RecordingCanvas canvas;
  draw_legend(canvas, {10, 10, 300, 30}, agreement_legend(agreement, light()), light(), 2.0);
  const auto bars = canvas.fills_in(light().disagreement);
  ASSERT_EQ(bars.size(), 1U);
  ASSERT_GE(canvas.strokes.size(), 2U);
  for (const auto& stripe : canvas.strokes) {
    ASSERT_EQ(stripe.clips.size(), 1U);
    EXPECT_EQ(outline_of(stripe.clips[0]), bars[0].outline);
  }
}

class AgreementOnTheGround : public MapPage {
 protected:
  static constexpr int kWidth = 120;
  static constexpr int kHeight = 80;
  MapScene scene{{0.0, 0.0}};
};

TEST_F(AgreementOnTheGround, LiesWhereTheMapIsAskedAtEveryPose) {
  // West of x = 20 the map is road, east of it terrain, and beyond x = 30 nothing is known.
  const OverheadMap map =
      drawn_map(1.0, std::vector<std::string>(
                         40, std::string(20, 'R') + std::string(10, 'T') + std::string(10, '.')));
  const SemanticTopview seen = road_ahead(1.5);
  const MapCamera camera{{20.0, 20.0}, 0.5};
  for (const Rigid2& pose : {Rigid2{18.3, 20.1, 0.0}, Rigid2{21.0, 18.0, kPi / 2.0},
                             Rigid2{26.2, 22.7, 0.4}, Rigid2{20.4, 23.0, -2.5}}) {
    AgreementView view(scene);
    view.show(seen, cell_agreement(seen, map, pose), pose, light());
    expect_everywhere(
        draw(scene, camera, kWidth, kHeight), camera,
        [&](const Eigen::Vector2d& point) -> std::optional<Rgba> {
          const Eigen::Vector2d cells = (pose.inverse() * point) / seen.metres_per_cell;
          const Eigen::Vector2d cell(std::floor(cells.x()), std::floor(cells.y()));
          if (is_near_border(cells.x()) || is_near_border(cells.y())) return std::nullopt;
          // Two to four cells ahead, from one to the right to two to the left.
          if (cell.x() < 2 || cell.x() > 3 || cell.y() < -1 || cell.y() > 1) return kNothing;
          const ClassId there = map.class_at(pose * (1.5 * (cell + Eigen::Vector2d(0.5, 0.5))));
          if (there == kUnclassified) return light().line;
          if (there == kRoad) return light().agreement;
          const int column = 1 - static_cast<int>(cell.y());
          const int row = 3 - static_cast<int>(cell.x());
          const Rgba plain = light().disagreement;
          return (column + row) % 4 < 2 ? Rgba{static_cast<std::uint8_t>(plain.red / 2),
                                               static_cast<std::uint8_t>(plain.green / 2),
                                               static_cast<std::uint8_t>(plain.blue / 2)}
                                        : plain;
        });
  }
}

TEST_F(AgreementOnTheGround, ShowsNothingOfNothing) {
  const Raster<Rgba> empty(kWidth, kHeight, kNothing);
  const MapCamera camera{{20.0, 20.0}, 0.5};
  const OverheadMap map = drawn_map(1.0, std::vector<std::string>(40, std::string(40, 'R')));
  const SemanticTopview seen = road_ahead(1.5);
  const Rigid2 pose{20.0, 20.0, 0.0};
  AgreementView view(scene);
  EXPECT_EQ(draw(scene, camera, kWidth, kHeight), empty);
  view.show(seen, cell_agreement(seen, map, pose), pose, light());
  EXPECT_NE(draw(scene, camera, kWidth, kHeight), empty);
  view.set_visible(false);
  view.show(seen, cell_agreement(seen, map, pose), pose, light());
  EXPECT_EQ(draw(scene, camera, kWidth, kHeight), empty);
  view.set_visible(true);
  EXPECT_NE(draw(scene, camera, kWidth, kHeight), empty);
  const Rigid2 nowhere{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};
  view.show(seen, cell_agreement(seen, map, nowhere), nowhere, light());
  EXPECT_EQ(draw(scene, camera, kWidth, kHeight), empty);
  view.show({}, {}, pose, light());
  EXPECT_EQ(draw(scene, camera, kWidth, kHeight), empty);
}

}  // namespace agreement_view_test
}  // namespace nadir
