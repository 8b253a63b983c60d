// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/moment_panels.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/widgets/figures/made_drive.h"
#include "tests/widgets/views/drawn_chart.h"
#include "widgets/views/chart_values.h"

namespace nadir {
namespace moment_panels_test {

using ::testing::ElementsAre;
using ::testing::IsNan;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

CellAgreement agreement_of(ClassId id, std::uint32_t agreeing, std::uint32_t disagreeing) {
  CellAgreement made;
  made.of_class.at(id) = {agreeing, disagreeing, 0};
  return made;
}

constexpr Rgba kRunColour{204, 121, 167};

TEST(AgreementBars, StandForEachClassSeenOnKnownGround) {
  CellAgreement at_estimate = agreement_of(kRoad, 3, 1);
  at_estimate.of_class[kCurb] = {0, 5, 0};
  at_estimate.of_class[kTerrain] = {0, 0, 7};  // off the map
  const auto chart = agreement_bars({at_estimate, agreement_of(kRoad, 4, 0)}, light(), kRunColour);
  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->y.title, "agreeing [%]");
  EXPECT_EQ(chart->y.high, 100.0);
  const auto& bars = *chart->bars;
  const std::string road_name(class_info(kRoad).name);
  EXPECT_THAT(bars.groups,
              testing::UnorderedElementsAre(road_name, std::string(class_info(kCurb).name)));
  const std::size_t road = bars.groups[0] == road_name ? 0 : 1;
  EXPECT_DOUBLE_EQ(bars.series[0].heights[road], 75.0);
  EXPECT_DOUBLE_EQ(bars.series[0].heights[1 - road], 0.0);
  EXPECT_DOUBLE_EQ(bars.series[1].heights[road], 100.0);
  EXPECT_THAT(bars.series[1].heights[1 - road], IsNan());
  EXPECT_THAT(names_of(*chart), ElementsAre("at estimate", "at truth"));
  EXPECT_EQ(bars.series[0].colour, kRunColour) << "as the estimate on the map";
}

TEST(AgreementBars, AreADashWhereAClassHasNoCellsAndNothingElseWhereNoneAgree) {
  CellAgreement at_estimate = agreement_of(kRoad, 0, 4);
  at_estimate.of_class[kCurb] = {3, 2, 0};
  const auto chart = agreement_bars({at_estimate, agreement_of(kRoad, 4, 0)}, light(), kRunColour);
  ASSERT_TRUE(chart);
  RecordingCanvas canvas;
  XyChart(*chart, light(), 1.5).draw(canvas, {0.0, 0.0, 400.0, 200.0}, 400, 200);
  const auto dashes = std::count_if(canvas.texts.begin(), canvas.texts.end(),
                                    [](const auto& text) { return text.line == kNoBar; });
  EXPECT_EQ(dashes, 1) << "of the curb at the truth";
}

TEST(AgreementBars, StandAlsoForClassesThatOnlyTheTruthKnows) {
  const auto chart = agreement_bars({{}, agreement_of(kRoad, 1, 1)}, light(), kRunColour);
  ASSERT_TRUE(chart);
  EXPECT_THAT(chart->bars->groups, SizeIs(1));
  EXPECT_THAT(names_of(*chart), ElementsAre("at truth"));
}

TEST(AgreementBars, AreNoneWithoutCellsOnKnownGroundAndOneSeriesWithoutTruth) {
  EXPECT_FALSE(agreement_bars({}, light(), kRunColour));
  EXPECT_FALSE(agreement_bars({{}, CellAgreement{}}, light(), kRunColour));
  const auto chart = agreement_bars({agreement_of(kRoad, 1, 1), {}}, light(), kRunColour);
  ASSERT_TRUE(chart);
  EXPECT_THAT(chart->bars->series, SizeIs(1));
}

}  // namespace moment_panels_test
}  // namespace nadir
