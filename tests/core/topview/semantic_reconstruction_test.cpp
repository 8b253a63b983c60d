// SPDX-License-Identifier: Apache-2.0
#include "core/topview/semantic_reconstruction.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "core/topview/cell_placement.h"
#include "tests/support/drawn_map.h"
#include "tests/support/made_topview.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace semantic_reconstruction_test {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Moment {
  SemanticTopview seen;
  Rigid2 enu_from_body;
};

std::vector<Moment> random_moments(std::uint32_t count, double metres_per_cell) {
  std::vector<Moment> moments;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [u, v] = uniforms({.seed = 31, .particle = i, .draw = 0});
    const auto [turn, unused] = uniforms({.seed = 31, .particle = i, .draw = 1});
    static_cast<void>(unused);
    moments.push_back({random_topview(100 + i, 30, 5, metres_per_cell),
                       {30.0 * u - 20.0, 20.0 * v - 10.0, 8.0 * turn - 4.0}});
  }
  return moments;
}

SemanticReconstruction reconstruct(const std::vector<Moment>& moments, double metres_per_cell) {
  SemanticReconstruction reconstruction(metres_per_cell);
  for (const Moment& moment : moments) reconstruction.add(moment.seen, moment.enu_from_body);
  return reconstruction;
}

TEST(SemanticReconstruction, PutsACellIntoTheGridCellThatHoldsItsCentre) {
  SemanticReconstruction reconstruction(0.5);
  // 1.75 m ahead of a body that faces north, and 0.25 m to its left: at (9.75, 21.75).
  reconstruction.add(topview_of({{{3, 0}, kCurb}}, 0.5), {10.0, 20.0, kPi / 2.0});
  EXPECT_EQ(reconstruction.top_left_in_enu_m(), Eigen::Vector2d(9.5, 22.0));
  EXPECT_EQ(reconstruction.labels().value(), Raster<ClassId>(1, 1, kCurb));
  EXPECT_EQ(reconstruction.votes().value(), Raster<std::uint16_t>(1, 1, 1));
}

TEST(SemanticReconstruction, IsNorthUp) {
  SemanticReconstruction reconstruction(1.0);
  const auto one_cell = [](ClassId id) { return topview_of({{{0, 0}, id}}, 1.0); };
  reconstruction.add(one_cell(kRoad), {0.0, 0.0, 0.0});
  reconstruction.add(one_cell(kTerrain), {2.0, 0.0, 0.0});           // east
  reconstruction.add(one_cell(kSidewalk), {0.0, 1.0, 0.0});          // north
  EXPECT_EQ(reconstruction.labels().value(), drawn_map(1.0, {"S..",  //
                                                             "R.T"})
                                                 .labels);
  EXPECT_EQ(reconstruction.top_left_in_enu_m(), Eigen::Vector2d(0.0, 2.0));
}

TEST(SemanticReconstruction, HasCellBordersAtMultiplesOfItsResolutionWhateverComesFirst) {
  for (const double x_m : {-7.3, -0.2, 0.0, 0.13, 51.99}) {
    SemanticReconstruction reconstruction(0.5);
    reconstruction.add(topview_of({{{0, 0}, kRoad}}, 0.1), {x_m, -x_m, 0.0});
    const Eigen::Vector2d corner = reconstruction.top_left_in_enu_m() / 0.5;
    EXPECT_EQ(corner.x(), std::round(corner.x()));
    EXPECT_EQ(corner.y(), std::round(corner.y()));
    const double east_m = x_m + 0.05 - reconstruction.top_left_in_enu_m().x();
    const double south_m = reconstruction.top_left_in_enu_m().y() - (0.05 - x_m);
    EXPECT_TRUE(east_m >= 0.0 && east_m < 0.5 && south_m > 0.0 && south_m <= 0.5) << x_m;
  }
}

TEST(SemanticReconstruction, CountsCellsWestAndSouthOfTheOriginDownFromMinusOne) {
  SemanticReconstruction reconstruction(0.5);
  reconstruction.add(topview_of({{{0, 0}, kRoad}, {{-1, -1}, kTerrain}}, 0.5), {});
  EXPECT_EQ(reconstruction.top_left_in_enu_m(), Eigen::Vector2d(-0.5, 0.5));
  EXPECT_EQ(reconstruction.labels().value(), drawn_map(0.5, {".R",  //
                                                             "T."})
                                                 .labels);
}

TEST(SemanticReconstruction, ElectsTheClassWithMostVotesAndTheSmallerIdWhereTheyAreEqual) {
  SemanticReconstruction reconstruction(1.0);
  const auto vote = [&](ClassId id, int times) {
    for (int i = 0; i < times; ++i) reconstruction.add(topview_of({{{0, 0}, id}}, 1.0), {});
  };
  const auto winner = [&](int min_votes) { return reconstruction.labels(min_votes)->at(0, 0); };
  vote(kCurb, 2);
  vote(kSidewalk, 1);
  EXPECT_EQ(winner(1), kCurb);
  EXPECT_EQ(winner(2), kCurb);
  EXPECT_EQ(winner(3), kUnclassified) << "three votes, but two for the winner";
  vote(kSidewalk, 1);
  EXPECT_EQ(winner(1), kSidewalk);
  vote(kCurb, 1);
  EXPECT_EQ(winner(3), kCurb);
  EXPECT_EQ(reconstruction.votes()->at(0, 0), 5);
}

TEST(SemanticReconstruction, AgreesWithVotesCountedOneByOne) {
  constexpr double kMetresPerCell = 0.25;
  const auto moments = random_moments(25, kMetresPerCell);
  std::map<std::pair<int, int>, std::array<int, kClassCount>> counted;
  for (const Moment& moment : moments) {
    for (ClassId id = 0; id < kClassCount; ++id) {
      for (const TopviewCell& cell : moment.seen.of_class(id)) {
        const Eigen::Vector2d centre_in_level_m =
            Eigen::Vector2d(cell.forward + 0.5, cell.left + 0.5) * kMetresPerCell;
        const Eigen::Vector2d cells = moment.enu_from_body * centre_in_level_m / kMetresPerCell;
        ++counted[{static_cast<int>(std::floor(cells.x())),
                   static_cast<int>(std::floor(cells.y()))}][id];
      }
    }
  }
  const SemanticReconstruction reconstruction = reconstruct(moments, kMetresPerCell);
  const Eigen::Vector2d corner = reconstruction.top_left_in_enu_m() / kMetresPerCell;
  for (const int min_votes : {1, 2, 4}) {
    const auto labels = reconstruction.labels(min_votes).value();
    const auto votes = reconstruction.votes().value();
    ASSERT_GT(labels.width(), 150);  // several blocks
    std::size_t cells_with_votes = 0;
    for (int row = 0; row < labels.height(); ++row) {
      for (int column = 0; column < labels.width(); ++column) {
        const auto found = counted.find(
            {static_cast<int>(corner.x()) + column, static_cast<int>(corner.y()) - 1 - row});
        if (found == counted.end()) {
          ASSERT_EQ(labels.at(column, row), kUnclassified);
          ASSERT_EQ(votes.at(column, row), 0);
          continue;
        }
        ++cells_with_votes;
        const auto& of_class = found->second;
        const auto most = std::max_element(of_class.begin(), of_class.end());
        const auto expected = *most >= min_votes ? static_cast<ClassId>(most - of_class.begin())
                                                 : ClassId{kUnclassified};
        ASSERT_EQ(labels.at(column, row), expected) << column << ", " << row;
        ASSERT_EQ(votes.at(column, row), std::accumulate(of_class.begin(), of_class.end(), 0));
      }
    }
    EXPECT_EQ(cells_with_votes, counted.size());
  }
}

TEST(SemanticReconstruction, VisitsEachCellOnceWithItsVotesByClass) {
  constexpr double kCellM = 0.2;
  const auto moments = random_moments(7, kCellM);
  std::map<std::pair<int, int>, SemanticReconstruction::CellVotes> expected;
  for (const Moment& moment : moments) {
    const CellPlacement placement(moment.enu_from_body, kCellM);
    for (ClassId id = 0; id < kClassCount; ++id) {
      for (const TopviewCell& cell : moment.seen.of_class(id)) {
        const Eigen::Vector2d centre = placement.centre_in_enu_m(cell);
        const auto i = static_cast<int>(std::floor(centre.x() / kCellM));
        ++expected[{i, static_cast<int>(std::floor(centre.y() / kCellM))}][id];
      }
    }
  }
  std::map<std::pair<int, int>, SemanticReconstruction::CellVotes> visited;
  reconstruct(moments, kCellM)
      .visit_cells([&](int i, int j, const SemanticReconstruction::CellVotes& votes) {
        EXPECT_TRUE(visited.emplace(std::pair(i, j), votes).second) << i << ' ' << j;
      });
  EXPECT_EQ(visited, expected);
}

TEST(SemanticReconstruction, IsJustAsLargeAsWhatWasSeen) {
  const auto labels = reconstruct(random_moments(5, 0.25), 0.25).labels().value();
  const auto is_seen = [](ClassId id) { return id != kUnclassified; };
  const auto any_in_column = [&](int column) {
    for (int row = 0; row < labels.height(); ++row) {
      if (is_seen(labels.at(column, row))) return true;
    }
    return false;
  };
  EXPECT_TRUE(std::any_of(labels.row(0).begin(), labels.row(0).end(), is_seen));
  const auto last = labels.row(labels.height() - 1);
  EXPECT_TRUE(std::any_of(last.begin(), last.end(), is_seen));
  EXPECT_TRUE(any_in_column(0));
  EXPECT_TRUE(any_in_column(labels.width() - 1));
}

TEST(SemanticReconstruction, DoesNotDependOnTheOrderOfTheTopviews) {
  auto moments = random_moments(12, 0.25);
  const SemanticReconstruction forwards = reconstruct(moments, 0.25);
  std::reverse(moments.begin(), moments.end());
  const SemanticReconstruction backwards = reconstruct(moments, 0.25);
  EXPECT_EQ(forwards.labels().value(), backwards.labels().value());
  EXPECT_EQ(forwards.votes().value(), backwards.votes().value());
  EXPECT_EQ(forwards.top_left_in_enu_m(), backwards.top_left_in_enu_m());
}

TEST(SemanticReconstruction, AtTruePosesIsTheMapAndAtWrongOnesIsNot) {
  const OverheadMap map = patchwork_map(300, 200, 0.2);
  const auto share_like_map = [&](double drift_m_per_m) {
    SemanticReconstruction reconstruction(0.2);
    for (double way_m = 0.0; way_m < 40.0; way_m += 1.0) {
      const Rigid2 truth{5.0 + way_m, 20.0, 0.3 * std::sin(0.2 * way_m)};
      const Rigid2 believed{truth.x_m, truth.y_m + drift_m_per_m * way_m, truth.yaw_rad};
      reconstruction.add(perfect_topview(map, truth, 12.0), believed);
    }
    const auto labels = reconstruction.labels().value();
    const Eigen::Vector2d corner = reconstruction.top_left_in_enu_m();
    int same = 0;
    int known = 0;
    for (int row = 0; row < labels.height(); ++row) {
      for (int column = 0; column < labels.width(); ++column) {
        if (labels.at(column, row) == kUnclassified) continue;
        ++known;
        const Eigen::Vector2d centre_in_enu_m(corner.x() + 0.2 * (column + 0.5),
                                              corner.y() - 0.2 * (row + 0.5));
        same += map.class_at(centre_in_enu_m) == labels.at(column, row) ? 1 : 0;
      }
    }
    EXPECT_GT(known, 5000);
    return static_cast<double>(same) / known;
  };
  EXPECT_GT(share_like_map(0.0), 0.95);
  EXPECT_LT(share_like_map(0.1), 0.8);
}

TEST(SemanticReconstruction, StopsCountingInsteadOfStartingAgain) {
  SemanticReconstruction reconstruction(1.0);
  const auto road = topview_of({{{0, 0}, kRoad}}, 1.0);
  const auto curb = topview_of({{{0, 0}, kCurb}}, 1.0);
  for (int i = 0; i < 40'000; ++i) reconstruction.add(road, {});
  for (int i = 0; i < 70'000; ++i) reconstruction.add(curb, {});
  EXPECT_EQ(reconstruction.votes()->at(0, 0), 65'535) << "not 110,000 modulo 65,536";
  EXPECT_EQ(reconstruction.labels(65'535)->at(0, 0), kCurb);
}

TEST(SemanticReconstruction, CountsCellsOfAnotherResolutionByTheirCentres) {
  SemanticReconstruction reconstruction(1.0);
  reconstruction.add(random_topview(5, 20, 1, 0.1), {0.0, 0.0, 0.0});  // 4 m x 4 m of road
  const auto votes = reconstruction.votes().value();
  EXPECT_EQ(votes.width(), 4);
  EXPECT_EQ(votes.height(), 4);
  const auto cells = random_topview(5, 20, 1, 0.1).cells.size();
  EXPECT_EQ(std::accumulate(votes.values().begin(), votes.values().end(), std::size_t{0}), cells);
  for (const std::uint16_t cell : votes.values()) EXPECT_NEAR(cell, 50, 25);
}

TEST(SemanticReconstruction, NeedsMemoryForTheGroundThatWasSeenOnly) {
  // 3.7 km from south-west to north-east at 0.33 m; the rectangle around it has 63 million cells.
  SemanticReconstruction drive(0.33);
  const auto seen = random_topview(6, 60, 8, 0.33);
  for (double way_m = 0.0; way_m < 3700.0; way_m += 10.0) {
    drive.add(seen, {way_m * std::sqrt(0.5), way_m * std::sqrt(0.5), kPi / 4.0});
  }
  EXPECT_GT(drive.labels()->size(), 60'000'000U);
  EXPECT_LT(drive.bytes(), 64U << 20U);
  // 400 m at 0.1 m.
  SemanticReconstruction flight(0.1);
  const auto near = random_topview(6, 200, 8, 0.1);
  for (double way_m = 0.0; way_m < 400.0; way_m += 10.0) flight.add(near, {way_m, 0.0, 0.0});
  EXPECT_LT(flight.bytes(), 64U << 20U);
}

TEST(SemanticReconstruction, RefusesRastersThatNobodyCouldDraw) {
  SemanticReconstruction reconstruction(0.1);
  const auto seen = topview_of({{{0, 0}, kRoad}}, 0.1);
  reconstruction.add(seen, {});
  reconstruction.add(seen, {-9'000.0, 12'000.0, 0.0});
  EXPECT_LT(reconstruction.bytes(), 100'000U);
  const auto labels = reconstruction.labels();
  ASSERT_FALSE(labels.has_value());
  EXPECT_EQ(labels.error().code, ErrorCode::kUnsupported);
  EXPECT_THAT(
      labels.error().message,
      HasSubstr("reconstruction: 90001 x 120001 cells of 0.1 m are more than the 1000000000"));
  EXPECT_FALSE(reconstruction.votes().has_value());
}

TEST(SemanticReconstruction, RefusesPosesThatAreNotFiniteOrOutOfThisWorld) {
  SemanticReconstruction reconstruction(0.5);
  const auto seen = topview_of({{{0, 0}, kRoad}}, 0.5);
  for (const Rigid2& pose : {Rigid2{kNaN, 0.0, 0.0}, Rigid2{0.0, kNaN, 0.0}, Rigid2{0.0, 0.0, kNaN},
                             Rigid2{0.0, 0.0, std::numeric_limits<double>::infinity()},
                             Rigid2{-1e300, 0.0, 0.0}, Rigid2{0.0, 5.1e8, 0.0}}) {
    EXPECT_THROW(reconstruction.add(seen, pose), std::logic_error);
  }
  EXPECT_TRUE(reconstruction.empty());
  EXPECT_THROW(reconstruction.add(topview_of({{{0, 0}, kRoad}}, 0.0), {}), std::logic_error);
  EXPECT_THROW(reconstruction.add(topview_of({{{0, 0}, kRoad}}, kNaN), {}), std::logic_error);
  reconstruction.add(seen, {4.9e8, -4.9e8, 1.0});
  EXPECT_EQ(reconstruction.labels()->size(), 1U);
  EXPECT_THROW(SemanticReconstruction(0.0), std::logic_error);
  EXPECT_THROW(SemanticReconstruction{kNaN}, std::logic_error);
}

TEST(SemanticReconstruction, OfNothingIsEmpty) {
  SemanticReconstruction reconstruction(0.5);
  reconstruction.add({}, {1.0, 2.0, 3.0});
  EXPECT_TRUE(reconstruction.empty());
  EXPECT_TRUE(reconstruction.labels()->empty());
  EXPECT_TRUE(reconstruction.votes()->empty());
  EXPECT_THROW(static_cast<void>(reconstruction.top_left_in_enu_m()), std::logic_error);
  EXPECT_THROW(static_cast<void>(reconstruction.labels(0)), std::logic_error);
}

}  // namespace semantic_reconstruction_test
}  // namespace nadir
