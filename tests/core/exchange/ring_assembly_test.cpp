// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/ring_assembly.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "core/base/random.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace ring_assembly_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

Ring round(double x, double y, double radius, int places = 24) {
  Ring ring;
  for (int i = 0; i < places; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / places;
    ring.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  return ring;
}

/// Circles in circles, none of which touches another: about a place, ever smaller ones beside each other.
void nest(
    std::vector<Ring>& rings, double x, double y, double radius, int depth, std::uint32_t& n) {
  rings.push_back(round(x, y, radius));
  if (depth == 0) return;
  for (const double side : {-0.45, 0.45}) {
    if (uniforms({17, 0, n++, 0, 0})[0] < 0.2) continue;
    nest(rings, x + side * radius, y, 0.4 * radius, depth - 1, n);
  }
}

TEST(AreasOf, PutsEachHoleIntoTheAreaThatItLiesIn) {
  std::vector<Ring> rings;
  std::uint32_t drawn = 0;
  for (int i = 0; i < 20; ++i) nest(rings, 30.0 * i, 5.0 * (i % 3), 10.0, 5, drawn);
  // Shuffled, for files have them in any order.
  for (std::size_t i = rings.size(); i-- > 1;) {
    const double at = uniforms({18, 0, static_cast<std::uint32_t>(i), 0, 0})[0];
    std::swap(rings[i], rings[static_cast<std::size_t>(at * static_cast<double>(i + 1))]);
  }
  const auto centre = [](const Ring& ring) {
    return Eigen::Vector2d((ring[0] + ring[ring.size() / 2]) / 2.0);
  };
  const auto radius = [](const Ring& ring) { return (ring[0] - ring[12]).norm() / 2.0; };
  const auto holds = [&](const Ring& outer, const Ring& inner) {
    return radius(outer) > radius(inner) && (centre(outer) - centre(inner)).norm() < radius(outer);
  };
  const auto areas = areas_of(rings);
  ASSERT_TRUE(areas) << error_text(areas);
  std::size_t placed = 0;
  for (const std::vector<Ring>& area : *areas) {
    placed += area.size();
    const auto depth = [&](const Ring& ring) {
      return std::count_if(rings.begin(), rings.end(),
                           [&](const Ring& other) { return holds(other, ring); });
    };
    EXPECT_EQ(depth(area[0]) % 2, 0);
    for (std::size_t i = 1; i < area.size(); ++i) {
      EXPECT_TRUE(holds(area[0], area[i]));
      EXPECT_EQ(depth(area[i]), depth(area[0]) + 1);
    }
  }
  EXPECT_EQ(placed, rings.size());
  EXPECT_GT(rings.size(), 400U);
}

TEST(AreasOf, TakesTensOfThousandsOfRingsAndCanBeStopped) {
  std::vector<Ring> rings{round(0.0, 0.0, 1000.0, 20'000)};
  for (int i = 0; i < 20'000; ++i) {
    rings.push_back(round(-500.0 + 5.0 * (i % 200), -250.0 + 5.0 * (i / 200), 2.0, 8));
  }
  const auto areas = areas_of(rings);
  ASSERT_TRUE(areas);
  ASSERT_THAT(*areas, SizeIs(1));
  EXPECT_THAT(areas->front(), SizeIs(20'001));
  std::stop_source stop;
  stop.request_stop();
  WorkContext context;
  context.stop = stop.get_token();
  EXPECT_EQ(areas_of(rings, context).error().code, ErrorCode::kCancelled);
}

TEST(JoinWays, GoesThroughANodeInWhichThousandsOfWaysEnd) {
  // A star: each ray goes out and comes back by another way.
  std::vector<NodeChain> ways;
  for (std::int64_t i = 1; i <= 50'000; ++i) {
    ways.push_back({0, 2 * i, 2 * i + 1});
    ways.push_back({0, 3'000'000 + i, 2 * i + 1});
  }
  const std::vector<NodeChain> chains = join_ways(ways);
  ASSERT_THAT(chains, SizeIs(50'000));
  EXPECT_THAT(chains[0], ElementsAre(0, 2, 3, 3'000'001, 0));
  for (const NodeChain& chain : chains) EXPECT_EQ(chain.front(), chain.back());
}

TEST(JoinWays, HasEachWayOnceInAnyDirection) {
  EXPECT_THAT(join_ways({{1, 2}, {4, 3}, {2, 3}, {8, 9}, {}, {5, 6, 5}}),
              ElementsAre(NodeChain{4, 3, 2, 1}, NodeChain{9, 8}, NodeChain{5, 6, 5}));
  EXPECT_THAT(join_ways({}), IsEmpty());
}

}  // namespace ring_assembly_test
}  // namespace nadir
