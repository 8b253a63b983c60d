// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_spec.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/widgets/views/sample_charts.h"

namespace nadir {
namespace chart_spec_test {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(ChartLegend, ListsWhatHasANameOnce) {
  ChartSpec spec = sample_chart();
  spec.lines.push_back(
      {.name = "odometry", .x = {1.0}, .y = {2.0}, .colour = kOrange, .is_dashed = true});
  spec.lines.push_back({.x = {1.0}, .y = {2.0}, .colour = kOrange});
  const Rgba muted = light_theme().muted;
  spec.levels = {{"95 % bounds", 7.8, muted}, {"95 % bounds", 0.2, muted}};
  spec.bars = sample_bars().bars;
  EXPECT_THAT(legend_of(spec),
              ElementsAre(LegendEntry{"line", kLineBlue, LegendEntry::Kind::kLine},
                          LegendEntry{"odometry", kOrange, LegendEntry::Kind::kDashed},
                          LegendEntry{"band", kPaleBlue, LegendEntry::Kind::kBand},
                          LegendEntry{"odometry", kOrange, LegendEntry::Kind::kBar},
                          LegendEntry{"estimate", kLineBlue, LegendEntry::Kind::kBar},
                          LegendEntry{"95 % bounds", muted, LegendEntry::Kind::kDashed}));
}

TEST(ChartLegend, DoesNotNameWhatIsNotDrawn) {
  ChartSpec spec;
  spec.lines = {{.name = "empty"},
                {.name = "unknown", .x = {1.0, 2.0}, .y = {kNan, kNan}},
                {.name = "nowhere", .x = {kNan}, .y = {1.0}}};
  spec.bands = {{.name = "empty"},
                {.name = "one point", .x = {1.0}, .low = {0.0}, .high = {1.0}},
                {.name = "never two together",
                 .x = {1.0, 2.0, 3.0},
                 .low = {0.0, kNan, 0.0},
                 .high = {1.0, 1.0, 1.0}}};
  spec.levels = {{.name = "unknown", .y = kNan}};
  spec.bars = BarsSpec{{"a"},
                       {{"none", {}, kOrange},
                        {"unknown", {kNan}, kOrange},
                        {"beyond the groups", {kNan, 1.0}, kOrange},
                        {"not above 0", {0.0}, kOrange}},
                       true};
  EXPECT_THAT(legend_of(spec), IsEmpty());
  spec.bars->is_logarithmic = false;
  EXPECT_THAT(legend_of(spec),
              ElementsAre(LegendEntry{"not above 0", kOrange, LegendEntry::Kind::kBar}));
}

}  // namespace chart_spec_test
}  // namespace nadir
