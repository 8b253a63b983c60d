// SPDX-License-Identifier: Apache-2.0
#include "core/session/moment_episodes.h"

#include <gmock/gmock.h>

#include <cmath>

namespace nadir {
namespace moment_episodes_test {

using ::testing::SizeIs;

TEST(Episodes, AreOneAcrossAShortBreakAndKeepTheFirstOfEqualPeaks) {
  const std::vector<double> time_s = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const std::vector<double> value = {1.0, 2.0, std::nan(""), 2.0, 0.5, 0.5, 3.0};
  const auto severity = [&](std::size_t i) { return value[i]; };
  const auto merged = detail::find_episodes(time_s, 2.5, severity);
  ASSERT_THAT(merged, SizeIs(2));
  EXPECT_EQ(merged[0].first, 0U);
  EXPECT_EQ(merged[0].last, 3U);
  EXPECT_EQ(merged[0].peak, 1U);
  EXPECT_EQ(merged[1].first, 6U);
  EXPECT_THAT(detail::find_episodes(time_s, 0.0, severity), SizeIs(3));
  EXPECT_THAT(detail::find_episodes(time_s, 100.0, severity), SizeIs(1));
}

TEST(MomentWords, HaveNoMoreDigitsThanHelp) {
  EXPECT_EQ(detail::length_words(0.123), "0.12 m");
  EXPECT_EQ(detail::length_words(0.996), "1.0 m");
  EXPECT_EQ(detail::length_words(12.34), "12.3 m");
  EXPECT_EQ(detail::length_words(134.4), "134 m");
  EXPECT_EQ(detail::duration_words(12.34), "12.3 s");
  EXPECT_EQ(detail::duration_words(125.2), "2 min 5 s");
}

}  // namespace moment_episodes_test
}  // namespace nadir
