// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/map_patch.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "core/mcl/cell_agreement.h"
#include "tests/support/drawn_map.h"
#include "tests/support/made_topview.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace map_patch_test {

using testing::Each;

constexpr double kPi = std::numbers::pi;

TopviewRaster frame(int width, int height, int body_column, int body_row) {
  return {.labels = Raster<ClassId>(width, height, kUnclassified),
          .body_column = body_column,
          .body_row = body_row};
}

TEST(MapPatch, OfABodyThatFacesNorthIsTheMapItself) {
  const OverheadMap map = drawn_map(0.5, {"RTSB",  //
                                          "VCLF",  //
                                          "TTRS",  //
                                          "BVCR"});
  const Rigid2 in_the_middle{1.0, 1.0, kPi / 2.0};
  EXPECT_EQ(map_patch(map, in_the_middle, frame(4, 4, 2, 2)), map.labels);
}

TEST(MapPatch, TurnsWithTheBody) {
  const OverheadMap map = drawn_map(0.5, {"RTSB",  //
                                          "VCLF",  //
                                          "TTRS",  //
                                          "BVCR"});
  const auto facing_east = map_patch(map, {1.0, 1.0, 0.0}, frame(4, 4, 2, 2));
  EXPECT_EQ(facing_east, drawn_map(0.5, {"BFSR",  // the easternmost column, from north to south
                                         "SLRC",  //
                                         "TCTV",  //
                                         "RVTB"})
                             .labels);
  const auto facing_south = map_patch(map, {1.0, 1.0, -kPi / 2.0}, frame(4, 4, 2, 2));
  EXPECT_EQ(facing_south, drawn_map(0.5, {"RCVB",  //
                                          "SRTT",  //
                                          "FLCV",  //
                                          "BSTR"})
                              .labels);
}

TEST(MapPatch, MayLieAnywhereAboutTheBodyAndIsUnclassifiedOffTheMap) {
  const OverheadMap map = drawn_map(1.0, {"RT",  //
                                          "SV"});
  const Rigid2 at_the_lower_left{0.0, 0.0, kPi / 2.0};
  EXPECT_EQ(map_patch(map, at_the_lower_left, frame(4, 3, 1, 3)), drawn_map(1.0, {"....",  //
                                                                                  ".RT.",  //
                                                                                  ".SV."})
                                                                      .labels);
  // All of it behind and to the right of the body.
  const Rigid2 at_the_upper_left{0.0, 2.0, kPi / 2.0};
  EXPECT_EQ(map_patch(map, at_the_upper_left, frame(1, 1, -1, -1)), drawn_map(1.0, {"V"}).labels);
}

TEST(MapPatch, AsksTheMapAtTheCentresOfTheCells) {
  const OverheadMap map = drawn_map(1.0, {"RT"});
  const auto right_of_the_body = [&](double x_m) {
    return map_patch(map, {x_m, 0.0, kPi / 2.0}, frame(1, 1, 0, 1)).at(0, 0);
  };
  EXPECT_EQ(right_of_the_body(0.49), kRoad);
  EXPECT_EQ(right_of_the_body(0.51), kTerrain);
  EXPECT_EQ(right_of_the_body(-0.49), kRoad);
  EXPECT_EQ(right_of_the_body(-0.51), kUnclassified);
}

TEST(MapPatch, HoldsUnderEverySeenCellWhatItsVerdictIsAbout) {
  const OverheadMap map = patchwork_map(120, 90, 0.2);
  const auto seen = random_topview(9, 40, 9, 0.2);
  const TopviewRaster picture = topview_raster(seen);
  for (const Rigid2& pose : {Rigid2{12.0, 9.0, 0.3}, Rigid2{1.0, 17.0, 2.5}, Rigid2{}}) {
    const Raster<ClassId> patch = map_patch(map, pose, picture);
    const CellAgreement agreement = cell_agreement(seen, map, pose);
    for (std::size_t i = 0; i < seen.cells.size(); ++i) {
      const int column = picture.body_column - 1 - seen.cells[i].left;
      const int row = picture.body_row - 1 - seen.cells[i].forward;
      const ClassId there = patch.at(column, row);
      const CellVerdict expected = there == kUnclassified ? CellVerdict::kUnknown
                                   : there == picture.labels.at(column, row)
                                       ? CellVerdict::kAgrees
                                       : CellVerdict::kDisagrees;
      ASSERT_EQ(agreement.of_cell[i], expected);
    }
  }
}

TEST(MapPatch, IsWhatAPerfectObserverSees) {
  const OverheadMap map = patchwork_map(200, 200, 0.2);
  const Rigid2 truth{20.0, 18.0, 0.7};
  const TopviewRaster seen = topview_raster(perfect_topview(map, truth, 12.0));
  const Raster<ClassId> patch = map_patch(map, truth, seen);
  std::size_t cells = 0;
  std::size_t different = 0;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    if (seen.labels.values()[i] == kUnclassified) continue;
    ++cells;
    different += patch.values()[i] != seen.labels.values()[i] ? 1U : 0U;
  }
  EXPECT_GT(cells, 1000U);
  EXPECT_LE(different, cells / 1000);  // floats, at borders
}

TEST(MapPatch, DoesNotReadTheLabelsOfThePicture) {
  const OverheadMap map = drawn_map(1.0, {"RTS"});
  TopviewRaster like = frame(3, 1, 0, 1);
  const auto expected = map_patch(map, {0.0, 0.0, kPi / 2.0}, like);
  like.labels = Raster<ClassId>(3, 1, kCar);
  EXPECT_EQ(map_patch(map, {0.0, 0.0, kPi / 2.0}, like), expected);
  EXPECT_EQ(expected, map.labels);
}

TEST(MapPatch, IsEmptyGroundForAPoseThatIsNotFiniteAndEmptyForAnEmptyPicture) {
  const OverheadMap map = drawn_map(1.0, {"RTS"});
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const Rigid2& pose : {Rigid2{kNaN, 0.0, 0.0}, Rigid2{0.0, 0.0, kNaN}}) {
    EXPECT_THAT(map_patch(map, pose, frame(3, 2, 1, 1)).values(), Each(kUnclassified));
  }
  EXPECT_TRUE(map_patch(map, {}, topview_raster({})).empty());
}

}  // namespace map_patch_test
}  // namespace nadir
