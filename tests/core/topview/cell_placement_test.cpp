// SPDX-License-Identifier: Apache-2.0
#include "core/topview/cell_placement.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "core/base/random.h"

namespace nadir {
namespace cell_placement_test {

TEST(CellPlacement, PutsTheCentreOfACellHalfACellBeyondItsIndices) {
  const CellPlacement placement(Rigid2{}, 0.2);
  EXPECT_EQ(placement.centre_in_enu_m(TopviewCell{0, 0}), Eigen::Vector2d(0.1, 0.1));
  EXPECT_EQ(placement.centre_in_enu_m(TopviewCell{-1, -1}), Eigen::Vector2d(-0.1, -0.1));
  EXPECT_TRUE(placement.centre_in_enu_m(TopviewCell{3, -2}).isApprox(Eigen::Vector2d(0.7, -0.3)));
}

TEST(CellPlacement, LaysCellsAheadToTheNorthAndCellsOnTheLeftToTheWestOfABodyThatFacesNorth) {
  const CellPlacement placement({10.0, 20.0, std::numbers::pi / 2.0}, 0.2);
  EXPECT_TRUE(placement.centre_in_enu_m(TopviewCell{3, 0}).isApprox(Eigen::Vector2d(9.9, 20.7)));
  EXPECT_TRUE(placement.centre_in_enu_m(TopviewCell{0, -4}).isApprox(Eigen::Vector2d(10.7, 20.1)));
}

TEST(CellPlacement, HasTheSameBitsAsThePoseTimesTheCentre) {
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const auto [u, v] = uniforms({.seed = 3, .particle = i, .draw = 0});
    const auto [turn, size] = uniforms({.seed = 3, .particle = i, .draw = 1});
    const auto words = random_words({.seed = 4, .particle = i});
    const Rigid2 pose{4000.0 * u - 2000.0, 4000.0 * v - 2000.0, 20.0 * turn - 10.0};
    const double metres_per_cell = 0.05 + size;
    const TopviewCell cell{static_cast<std::int16_t>(words[0] % 8000 - 4000),
                           static_cast<std::int16_t>(words[1] % 8000 - 4000)};
    const Eigen::Vector2d centre_in_level_m =
        Eigen::Vector2d(cell.forward + 0.5, cell.left + 0.5) * metres_per_cell;
    EXPECT_EQ(CellPlacement(pose, metres_per_cell).centre_in_enu_m(cell), pose * centre_in_level_m);
  }
}

TEST(CellPlacement, OfAPoseThatIsNotFiniteIsNowhere) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Rigid2& pose :
       {Rigid2{kNaN, kNaN, 0.0}, Rigid2{0.0, 0.0, kNaN}, Rigid2{0.0, 0.0, kInfinity}}) {
    EXPECT_TRUE(CellPlacement(pose, 0.1).centre_in_enu_m(TopviewCell{1, 1}).array().isNaN().all());
  }
}

}  // namespace cell_placement_test
}  // namespace nadir
