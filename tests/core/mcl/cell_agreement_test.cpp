// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/cell_agreement.h"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "core/mcl/measurement_model.h"
#include "tests/support/drawn_map.h"
#include "tests/support/made_topview.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace cell_agreement_test {

using testing::Each;
using testing::ElementsAre;
using Count = CellAgreement::Count;
constexpr auto kAgrees = CellVerdict::kAgrees;
constexpr auto kDisagrees = CellVerdict::kDisagrees;
constexpr auto kUnknown = CellVerdict::kUnknown;

Rigid2 random_pose(std::uint32_t number, double side_m) {
  const auto [u, v] = uniforms({.seed = 21, .particle = number, .draw = 0});
  const auto [turn, unused] = uniforms({.seed = 21, .particle = number, .draw = 1});
  static_cast<void>(unused);
  return {side_m * (1.4 * u - 0.2), side_m * (1.4 * v - 0.2), 8.0 * turn - 4.0};
}

TEST(CellAgreement, ListsVerdictsInTheOrderOfTheCellsAndCountsThemByTheClassSeen) {
  const OverheadMap map = drawn_map(1.0, {"RRT."});
  const auto seen = topview_of(
      {{{0, 0}, kRoad}, {{1, 0}, kTerrain}, {{2, 0}, kTerrain}, {{3, 0}, kRoad}, {{7, 0}, kCurb}},
      1.0);
  const CellAgreement result = cell_agreement(seen, map, {});
  ASSERT_THAT(seen.cells, ElementsAre(TopviewCell{0, 0}, TopviewCell{3, 0}, TopviewCell{1, 0},
                                      TopviewCell{2, 0}, TopviewCell{7, 0}));
  EXPECT_THAT(result.of_cell, ElementsAre(kAgrees, kUnknown, kDisagrees, kAgrees, kUnknown));
  EXPECT_EQ(result.of_class[kRoad], (Count{1, 0, 1}));
  EXPECT_EQ(result.of_class[kTerrain], (Count{1, 1, 0}));
  EXPECT_EQ(result.of_class[kCurb], (Count{0, 0, 1}));
  EXPECT_EQ(result.of_class[kSidewalk], Count{});
  EXPECT_EQ(result.total(), (Count{2, 1, 2}));
  EXPECT_DOUBLE_EQ(result.share().value(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(result.of_class[kRoad].share().value(), 1.0);
  EXPECT_FALSE(result.of_class[kCurb].share().has_value());
}

TEST(CellAgreement, LaysTheFourCellsAroundTheBodyOnTheFourCellsAroundItsPlace) {
  const OverheadMap map = drawn_map(2.0, {"RT",  //
                                          "SV"});
  const Rigid2 facing_north{2.0, 2.0, std::numbers::pi / 2.0};
  const auto seen = topview_of(
      {{{0, 0}, kRoad}, {{0, -1}, kTerrain}, {{-1, 0}, kSidewalk}, {{-1, -1}, kVegetation}}, 2.0);
  EXPECT_THAT(cell_agreement(seen, map, facing_north).of_cell, Each(kAgrees));
  const Rigid2 facing_south{2.0, 2.0, -std::numbers::pi / 2.0};
  EXPECT_THAT(cell_agreement(seen, map, facing_south).of_cell, Each(kDisagrees));
  // Mirrored left to right it must not fit.
  const auto mirrored = topview_of(
      {{{0, -1}, kRoad}, {{0, 0}, kTerrain}, {{-1, -1}, kSidewalk}, {{-1, 0}, kVegetation}}, 2.0);
  EXPECT_THAT(cell_agreement(mirrored, map, facing_north).of_cell, Each(kDisagrees));
}

TEST(CellAgreement, EndsAtTheEdgesOfTheMap) {
  const OverheadMap map = drawn_map(1.0, {"RR"});
  const auto verdict = [&](double x_m, double y_m) {
    return cell_agreement(topview_of({{{0, 0}, kRoad}}, 1.0), map, {x_m - 0.5, y_m - 0.5, 0.0})
        .of_cell[0];
  };
  EXPECT_EQ(verdict(0.0, 0.5), kAgrees) << "the left edge belongs to the map";
  EXPECT_EQ(verdict(-0.01, 0.5), kUnknown);
  EXPECT_EQ(verdict(1.99, 0.5), kAgrees);
  EXPECT_EQ(verdict(2.0, 0.5), kUnknown) << "the right edge does not";
  EXPECT_EQ(verdict(0.5, 1.0), kAgrees) << "the upper edge belongs to the map";
  EXPECT_EQ(verdict(0.5, 0.0), kUnknown) << "the lower edge does not";
}

TEST(CellAgreement, FollowsARotationInComplexNumbers) {
  const OverheadMap map = patchwork_map(120, 90, 0.2);
  const auto seen = random_topview(7, 40, kClassCount, 0.2);
  std::size_t compared = 0;
  for (std::uint32_t number = 0; number < 20; ++number) {
    const Rigid2 pose = random_pose(number, 20.0);
    const CellAgreement result = cell_agreement(seen, map, pose);
    ASSERT_EQ(result.of_cell.size(), seen.cells.size());
    std::array<Count, kClassCount> counted;
    for (std::size_t i = 0; i < seen.cells.size(); ++i) {
      ClassId id = 0;
      while (i >= seen.class_begin[id + 1U]) ++id;
      auto& count = counted[id];
      ++(result.of_cell[i] == kAgrees      ? count.agreeing
         : result.of_cell[i] == kDisagrees ? count.disagreeing
                                           : count.unknown);
      const std::complex<double> in_body_m(0.2 * seen.cells[i].forward + 0.1,
                                           0.2 * seen.cells[i].left + 0.1);
      const std::complex<double> in_enu_m =
          std::complex<double>(pose.x_m, pose.y_m) + std::polar(1.0, pose.yaw_rad) * in_body_m;
      const double column = in_enu_m.real() / 0.2;
      const double row = 90.0 - in_enu_m.imag() / 0.2;
      if (std::abs(column - std::round(column)) < 1e-6 || std::abs(row - std::round(row)) < 1e-6) {
        continue;  // On a border, where rounding decides.
      }
      const bool is_on_map = column > 0.0 && column < 120.0 && row > 0.0 && row < 90.0;
      const ClassId there = is_on_map
                                ? map.labels.at(static_cast<int>(column), static_cast<int>(row))
                                : ClassId{kUnclassified};
      const CellVerdict expected = there == kUnclassified ? kUnknown
                                   : there == id          ? kAgrees
                                                          : kDisagrees;
      ASSERT_EQ(result.of_cell[i], expected) << "cell " << i << " of pose " << number;
      ++compared;
    }
    EXPECT_EQ(result.of_class, counted);
  }
  EXPECT_GT(compared, 20U * seen.cells.size() * 9 / 10);
}

TEST(CellAgreement, GivesAgreementTheNumberThatTheFormulaGives) {
  const OverheadMap map = patchwork_map(120, 120, 0.2);
  const auto seen = random_topview(8, 30, 9, 0.2);
  for (std::uint32_t number = 0; number < 50; ++number) {
    const Rigid2 pose = random_pose(number, 24.0);
    std::size_t known = 0;
    std::size_t same = 0;
    for (ClassId id = 0; id < kClassCount; ++id) {
      for (const TopviewCell& cell : seen.of_class(id)) {
        const ClassId there = map.class_at(
            pose * Eigen::Vector2d(Eigen::Vector2d(cell.forward + 0.5, cell.left + 0.5) * 0.2));
        known += there != kUnclassified ? 1U : 0U;
        same += there == id ? 1U : 0U;
      }
    }
    const auto share = agreement(seen, map, pose);
    ASSERT_EQ(share.has_value(), known > 0);
    EXPECT_EQ(share.value_or(0.0),
              known == 0 ? 0.0 : static_cast<double>(same) / static_cast<double>(known));
    EXPECT_EQ(share, cell_agreement(seen, map, pose).share());
  }
}

TEST(CellAgreement, IsCompleteForAPerfectObserverAtTheTruePoseAndLessElsewhere) {
  const OverheadMap map = patchwork_map(200, 200, 0.2);
  const Rigid2 truth{20.0, 18.0, 0.7};
  const auto seen = perfect_topview(map, truth, 12.0);
  EXPECT_GT(cell_agreement(seen, map, truth).share().value(), 0.999);  // floats, at borders
  EXPECT_LT(cell_agreement(seen, map, truth * Rigid2{2.0, 0.0, 0.0}).share().value(), 0.8);
}

TEST(CellAgreement, CountsClassesThatNoMapHoldsAsDisagreeingOnKnownGround) {
  const OverheadMap map = drawn_map(1.0, {"RT."});
  const auto seen = topview_of({{{0, 0}, kCar}, {{2, 0}, kCar}}, 1.0);
  EXPECT_EQ(cell_agreement(seen, map, {}).of_class[kCar], (Count{0, 1, 1}));
}

TEST(CellAgreement, OfAPoseThatIsNotFiniteOrOffTheMapIsUnknownEverywhere) {
  const OverheadMap map = drawn_map(1.0, {"RT"});
  const auto seen = topview_of({{{0, 0}, kRoad}, {{1, 0}, kTerrain}}, 1.0);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Rigid2& pose : {Rigid2{kNaN, 0.0, 0.0}, Rigid2{0.0, 0.0, kNaN},
                             Rigid2{kInfinity, 0.0, 0.0}, Rigid2{1e9, -1e9, 0.0}}) {
    const CellAgreement result = cell_agreement(seen, map, pose);
    EXPECT_THAT(result.of_cell, ElementsAre(kUnknown, kUnknown));
    EXPECT_FALSE(result.share().has_value());
  }
}

TEST(CellAgreement, OfAnEmptyTopviewIsNothing) {
  const CellAgreement result = cell_agreement({}, drawn_map(1.0, {"RT"}), {});
  EXPECT_TRUE(result.of_cell.empty());
  EXPECT_EQ(result.total(), Count{});
  EXPECT_FALSE(result.share().has_value());
}

}  // namespace cell_agreement_test
}  // namespace nadir
