// SPDX-License-Identifier: Apache-2.0
#include "core/topview/semantic_topview.h"

#include <gmock/gmock.h>

#include <map>

#include "core/base/random.h"

namespace nadir {
namespace semantic_topview_test {

using testing::ElementsAre;
using testing::HasSubstr;

SemanticCloud cloud_of(std::initializer_list<std::pair<Eigen::Vector2f, ClassId>> points) {
  SemanticCloud cloud;
  for (const auto& [point, label] : points) {
    cloud.points_in_level_m.emplace_back(point.x(), point.y(), -2.0F);
    cloud.labels.push_back(label);
  }
  return cloud;
}

SemanticCloud random_cloud(std::size_t count) {
  SemanticCloud cloud;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [forward, left] = uniforms({.seed = 5, .particle = i});
    const auto words = random_words({.seed = 6, .particle = i});
    cloud.points_in_level_m.emplace_back(static_cast<float>(3.0 * forward - 0.5),
                                         static_cast<float>(2.0 * left - 1.0),
                                         static_cast<float>(words[1] % 3));
    cloud.labels.push_back(static_cast<ClassId>(words[0] % 20));
  }
  return cloud;
}

TEST(SemanticTopview, HasTheCellAheadAndLeftAtZeroZero) {
  const auto topview = build_semantic_topview(cloud_of({{{0.05F, 0.05F}, kRoad}}), 0.1);
  EXPECT_THAT(topview->cells, ElementsAre(TopviewCell{0, 0}));
  EXPECT_THAT(topview->of_class(kRoad), ElementsAre(TopviewCell{0, 0}));
}

TEST(SemanticTopview, CountsCellsBehindAndToTheRightDownFromMinusOne) {
  const auto topview = build_semantic_topview(cloud_of({{{-0.01F, -0.01F}, kRoad}}), 0.1);
  EXPECT_THAT(topview->cells, ElementsAre(TopviewCell{-1, -1}));
}

TEST(SemanticTopview, TakesTheClassWithMostVotesWhateverTheHeight) {
  SemanticCloud cloud =
      cloud_of({{{1.0F, 0.0F}, kRoad}, {{1.02F, 0.05F}, kCurb}, {{1.05F, 0.01F}, kCurb}});
  cloud.points_in_level_m[0].z() = 8.0F;
  const auto topview = build_semantic_topview(cloud, 0.1);
  EXPECT_EQ(topview->of_class(kCurb).size(), 1U);
  EXPECT_EQ(topview->of_class(kRoad).size(), 0U);
}

TEST(SemanticTopview, GivesEqualVotesToTheSmallerClass) {
  const auto topview =
      build_semantic_topview(cloud_of({{{1.0F, 0.0F}, kCurb}, {{1.0F, 0.0F}, kSidewalk}}), 0.1);
  EXPECT_EQ(topview->of_class(kSidewalk).size(), 1U);
}

TEST(SemanticTopview, LeavesACellUndefinedBelowMinVotes) {
  const auto cloud =
      cloud_of({{{1.0F, 0.0F}, kRoad}, {{1.0F, 0.0F}, kRoad}, {{2.0F, 0.0F}, kRoad}});
  const auto topview = build_semantic_topview(cloud, 0.1, {.min_votes = 2});
  EXPECT_EQ(topview->cells.size(), 1U);
}

TEST(SemanticTopview, CountsAWeightedLaneMarkingPointSeveralTimes) {
  const auto cloud =
      cloud_of({{{1.0F, 0.0F}, kRoad}, {{1.0F, 0.0F}, kRoad}, {{1.0F, 0.0F}, kLaneMarking}});
  EXPECT_EQ(build_semantic_topview(cloud, 0.1)->of_class(kLaneMarking).size(), 0U);
  const auto topview = build_semantic_topview(cloud, 0.1, {.lane_marking_vote = 3.0});
  EXPECT_EQ(topview->of_class(kLaneMarking).size(), 1U);
}

TEST(SemanticTopview, LetsNeitherSkyNorUnclassifiedVote) {
  const auto topview =
      build_semantic_topview(cloud_of({{{1.0F, 0.0F}, kSky}, {{1.0F, 0.0F}, kUnclassified}}), 0.1);
  EXPECT_TRUE(topview->cells.empty());
}

TEST(SemanticTopview, LeavesOutPointsBeyondTheRangeMeasuredOnTheGround) {
  SemanticCloud cloud = cloud_of({{{19.9F, 0.0F}, kRoad}, {{19.9F, 5.0F}, kRoad}});
  cloud.points_in_level_m[0].z() = 50.0F;
  EXPECT_EQ(build_semantic_topview(cloud, 0.1)->cells.size(), 1U);
}

TEST(SemanticTopview, AgreesWithABruteForceVoteOnARandomCloud) {
  const SemanticCloud cloud = random_cloud(5000);
  std::map<std::pair<int, int>, std::map<ClassId, int>> votes;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!can_lie_in_overhead(cloud.labels[i])) continue;
    const auto& point = cloud.points_in_level_m[i];
    ++votes[{static_cast<int>(std::floor(point.x() * 10.0F)),
             static_cast<int>(std::floor(point.y() * 10.0F))}][cloud.labels[i]];
  }
  std::map<std::pair<int, int>, ClassId> expected;
  for (const auto& [cell, count_of] : votes) {
    ClassId winner = 0;
    int most = 0;
    for (const auto& [id, count] : count_of) {
      if (count > most) most = count, winner = id;
    }
    if (most >= 3) expected[cell] = winner;
  }
  const auto topview = build_semantic_topview(cloud, 0.1, {.min_votes = 3});
  std::map<std::pair<int, int>, ClassId> actual;
  for (ClassId id = 0; id < kClassCount; ++id) {
    for (const TopviewCell& cell : topview->of_class(id)) actual[{cell.forward, cell.left}] = id;
  }
  EXPECT_EQ(actual, expected);
  EXPECT_EQ(topview->cells.size(), expected.size());
}

TEST(SemanticTopview, IsEmptyForAnEmptyCloudWithoutAnError) {
  const auto topview = build_semantic_topview({}, 0.1);
  ASSERT_TRUE(topview.has_value());
  EXPECT_TRUE(topview->cells.empty());
  EXPECT_TRUE(topview_raster(*topview).labels.empty());
}

TEST(SemanticTopview, RefusesOptionsOutOfRangeByName) {
  EXPECT_EQ(build_semantic_topview({}, 0.1, {.min_votes = 0}).error().message,
            "--min-votes: 0 is not in [1, 1000]");
  EXPECT_THAT(build_semantic_topview({}, 0.0).error().message, HasSubstr("0 m per cell"));
  EXPECT_THAT(build_semantic_topview({}, 1e-6).error().message, HasSubstr("does not fit"));
}

TEST(TopviewRaster, HasRowZeroFarthestAheadAndColumnZeroLeftmost) {
  const auto topview =
      build_semantic_topview(cloud_of({{{0.35F, 0.15F}, kRoad}, {{0.05F, -0.05F}, kCurb}}), 0.1);
  const TopviewRaster raster = topview_raster(*topview);
  EXPECT_EQ(raster.labels.width(), 3);
  EXPECT_EQ(raster.labels.height(), 4);
  EXPECT_EQ(raster.labels.at(0, 0), kRoad);
  EXPECT_EQ(raster.labels.at(2, 3), kCurb);
  EXPECT_EQ(raster.labels.at(1, 1), kUnclassified);
}

TEST(TopviewRaster, IsUndoneByTopviewFromRaster) {
  const auto topview = build_semantic_topview(random_cloud(3000), 0.1);
  EXPECT_EQ(topview_from_raster(topview_raster(*topview), 0.1), *topview);
}

}  // namespace semantic_topview_test
}  // namespace nadir
