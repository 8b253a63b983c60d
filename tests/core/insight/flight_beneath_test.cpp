// SPDX-License-Identifier: Apache-2.0
#include "core/insight/flight_beneath.h"

#include <gmock/gmock.h>

#include <map>
#include <utility>

#include "core/topview/cell_placement.h"
#include "tests/core/run/recorded_run.h"
#include "tests/support/error_text.h"
#include "tests/support/made_topview.h"
#include "tests/support/scenery.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace flight_beneath_test {

constexpr double kCellM = 0.2;

/// A run of which nobody asks more than topviews and poses.
void write_run(const std::filesystem::path& file,
               const std::vector<std::pair<SemanticTopview, Rigid2>>& seen,
               bool has_truth) {
  auto writer = RunWriter::create(file, example_header()).value();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    RunStep step = example_step(static_cast<int>(i));
    step.topview = seen[i].first;
    step.estimate.moments.mean = seen[i].second;
    step.truth_in_enu.reset();
    if (has_truth) step.truth_in_enu = Rigid2{seen[i].second.x_m + 1.0, seen[i].second.y_m, 0.0};
    const auto written = writer.write(step);
    ASSERT_TRUE(written.has_value()) << error_text(written);
  }
  ASSERT_TRUE(writer.finish().has_value());
}

std::vector<std::pair<SemanticTopview, Rigid2>> random_views(std::uint32_t count) {
  std::vector<std::pair<SemanticTopview, Rigid2>> views;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [u, v] = uniforms({.seed = 21, .particle = i});
    views.emplace_back(random_topview(40 + i, 20, 12, kCellM),
                       Rigid2{26.0 * u - 2.0, 22.0 * v - 2.0, 6.0 * (u - v)});
  }
  return views;
}

TEST(FlightBeneath, CountsEveryCellOfEveryStep) {
  const ScratchFolder folder;
  const auto views = random_views(9);
  write_run(folder.path() / "r.nadir", views, false);
  const OverheadMap map = patchwork_map(110, 90, kCellM);  // 22 x 18 m: some cells fall beside it
  const auto run = RunReader::open(folder.path() / "r.nadir").value();
  const auto beneath = flight_beneath(run, map, FlightPose::kEstimate);
  ASSERT_TRUE(beneath.has_value()) << error_text(beneath);
  ASSERT_EQ(beneath->steps.size(), views.size());
  std::array<CellAgreement::Count, kClassCount> sums{};
  std::map<std::pair<int, int>, SemanticReconstruction::CellVotes> votes;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto& [seen, pose] = views[i];
    EXPECT_EQ(beneath->steps[i].total, cell_agreement(seen, map, pose).total());
    const CellPlacement placement(pose, kCellM);
    for (ClassId id = 0; id < kClassCount; ++id) {
      for (const TopviewCell& cell : seen.of_class(id)) {
        const Eigen::Vector2d at = map.overhead_from_enu(placement.centre_in_enu_m(cell));
        const auto column = static_cast<int>(std::floor(at.x()));
        const auto row = static_cast<int>(std::floor(at.y()));
        if (!map.labels.contains(column, row)) {
          ++sums[id].unknown;
          continue;
        }
        const ClassId there = map.labels.at(column, row);
        ++(there == id ? sums[id].agreeing : sums[id].disagreeing);
        ++votes[{column, row}][id];
      }
    }
  }
  EXPECT_EQ(beneath->of_class, sums);
  std::size_t visited = 0;
  beneath->votes.visit([&](int column, int row, const auto& of_cell) {
    ++visited;
    EXPECT_EQ(of_cell, (votes[{column, row}])) << column << ' ' << row;
  });
  EXPECT_EQ(visited, votes.size());
}

TEST(FlightBeneath, LaysAtTheTruthWhereThatIsAsked) {
  const ScratchFolder folder;
  const auto views = random_views(2);
  write_run(folder.path() / "with.nadir", views, true);
  write_run(folder.path() / "without.nadir", views, false);
  const OverheadMap map = patchwork_map(110, 90, kCellM);
  const auto with = RunReader::open(folder.path() / "with.nadir").value();
  const auto beneath = flight_beneath(with, map, FlightPose::kTruth).value();
  EXPECT_EQ(beneath.steps[1].enu_from_body,
            (Rigid2{views[1].second.x_m + 1.0, views[1].second.y_m, 0.0}));
  const auto without = RunReader::open(folder.path() / "without.nadir").value();
  EXPECT_THAT(error_text(flight_beneath(without, map, FlightPose::kTruth)),
              testing::HasSubstr("no step has a topview and a true pose"));
  const OverheadMap coarse = patchwork_map(30, 30, 0.5);
  EXPECT_THAT(error_text(flight_beneath(with, coarse, FlightPose::kTruth)),
              testing::HasSubstr("cells of 0.2 m, but map 'patchwork' of 0.5 m"));
}

TEST(FlightBeneath, StopsWhenItIsTold) {
  const ScratchFolder folder;
  write_run(folder.path() / "r.nadir", random_views(3), false);
  const auto run = RunReader::open(folder.path() / "r.nadir").value();
  std::stop_source stop;
  stop.request_stop();
  const auto stopped = flight_beneath(run, patchwork_map(30, 30, kCellM), FlightPose::kEstimate,
                                      {.stop = stop.get_token(), .progress = {}});
  EXPECT_EQ(error_code(stopped), ErrorCode::kCancelled);
}

/// Flights over ground as it is, in all directions.
FlightVotes votes_over(const OverheadMap& truth) {
  FlightVotes votes(truth);
  for (int i = 0; i < 40; ++i) {
    const Rigid2 pose{8.0 + 0.2 * i, 9.0 + std::sin(0.9 * i), 0.7 * i};
    votes.add(perfect_topview(truth, pose, 8.0), pose);
  }
  return votes;
}

/// 30 x 20 m of grass with a road through it.
OverheadMap road_map() {
  OverheadMap map = patchwork_map(150, 100, kCellM);
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 150; ++column) {
      map.labels.at(column, row) = row >= 40 && row < 70 ? kRoad : kTerrain;
    }
  }
  return map;
}

void fill(OverheadMap& map, const CellRect& cells, ClassId id) {
  for (auto row = static_cast<int>(cells.top); row < cells.bottom; ++row) {
    for (auto column = static_cast<int>(cells.left); column < cells.right; ++column) {
      map.labels.at(column, row) = id;
    }
  }
}

TEST(Contradictions, AreWhereTheLabelsAreWrongAndNowhereElse) {
  const OverheadMap truth = road_map();
  const FlightVotes votes = votes_over(truth);
  EXPECT_TRUE(find_contradictions(votes, *index_of(truth))->places.empty());
  OverheadMap wrong = truth;
  const CellRect large{50, 46, 65, 60};
  const CellRect small{70, 48, 78, 56};
  fill(wrong, large, kVegetation);
  fill(wrong, small, kUnclassified);
  const auto found = find_contradictions(votes, *index_of(wrong), {.tolerance_m = 0.0});
  ASSERT_EQ(found->places.size(), 2U);
  const ContradictedPlace& first = found->places.front();
  EXPECT_EQ(first.cells, large);
  EXPECT_EQ(first.seen, kRoad);
  EXPECT_EQ(first.labelled, kVegetation);
  EXPECT_NEAR(first.area_m2, 15 * 14 * kCellM * kCellM, 1e-9);
  EXPECT_GT(first.mean_share, 0.9);
  const Eigen::Vector2d middle = wrong.enu_from_overhead({57.5, 53.0});
  EXPECT_NEAR((first.middle_in_enu_m - middle).norm(), 0.0, 1e-9);
  EXPECT_EQ(found->places.back().cells, small);
  EXPECT_EQ(found->places.back().labelled, kUnclassified);
  EXPECT_EQ(found->seen.at(57, 50), kRoad);
  EXPECT_EQ(found->seen.at(57, 64), kUnclassified);
}

TEST(Contradictions, AreNotMadeByBordersThatLieALittleOff) {
  const OverheadMap truth = road_map();
  const FlightVotes votes = votes_over(truth);
  OverheadMap shifted = truth;
  fill(shifted, {0, 40, 150, 42}, kTerrain);  // 0.4 m less of the road
  EXPECT_TRUE(find_contradictions(votes, *index_of(shifted))->places.empty());
  EXPECT_FALSE(
      find_contradictions(votes, *index_of(shifted), {.tolerance_m = 0.1})->places.empty());
}

TEST(Contradictions, TakeEnoughVotesThatAgreeAndNothingThatMoves) {
  OverheadMap map = road_map();
  const CellRect spot{60, 50, 70, 60};
  const auto seen_as = [&](ClassId id, int times, FlightVotes& votes) {
    OverheadMap other = map;
    fill(other, spot, id);
    const Rigid2 pose{8.0, 9.0, 0.0};
    for (int i = 0; i < times; ++i) votes.add(perfect_topview(other, pose, 8.0), pose);
  };
  const auto places = [&](const FlightVotes& votes) {
    return find_contradictions(votes, *index_of(map))->places.size();
  };
  FlightVotes few(map);
  seen_as(kVegetation, 2, few);
  EXPECT_EQ(places(few), 0U);
  seen_as(kVegetation, 1, few);
  EXPECT_EQ(places(few), 1U);
  FlightVotes torn(map);
  seen_as(kVegetation, 5, torn);
  seen_as(kRoad, 4, torn);
  EXPECT_EQ(places(torn), 0U) << "5 of 9 are less than 60 %";
  FlightVotes parked(map);
  seen_as(kCar, 9, parked);
  EXPECT_EQ(places(parked), 0U);
  EXPECT_THAT(error_text(find_contradictions(few, *index_of(map), {.least_share = 2.0})),
              testing::HasSubstr("least-share"));
}

}  // namespace flight_beneath_test
}  // namespace nadir
