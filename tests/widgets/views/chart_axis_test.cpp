// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_axis.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace nadir {
namespace chart_axis_test {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool always_fit(const Ticks& /*ticks*/) { return true; }

TicksFit at_most(std::size_t count) {
  return [count](const Ticks& ticks) { return ticks.at.size() <= count; };
}

ChartSpec with_y(std::vector<double> y) {
  ChartSpec spec;
  LineSpec line;
  for (std::size_t i = 0; i < y.size(); ++i) line.x.push_back(static_cast<double>(i));
  line.y = std::move(y);
  spec.lines = {line};
  return spec;
}

ChartSpec with_bars(std::vector<double> heights, bool is_logarithmic) {
  ChartSpec spec;
  spec.bars = BarsSpec{{"a", "b", "c"}, {{"bars", std::move(heights), {}}}, is_logarithmic};
  return spec;
}

TEST(RoundTicks, AreMultiplesOfOneTwoOrFive) {
  EXPECT_THAT(round_ticks({0.0, 10.0}, false, always_fit).at, ElementsAre(0, 2, 4, 6, 8, 10));
  EXPECT_THAT(round_ticks({0.0, 7.0}, false, always_fit).at, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(round_ticks({0.0, 150.0}, false, always_fit).at,
              ElementsAre(0, 20, 40, 60, 80, 100, 120, 140));
  EXPECT_THAT(round_ticks({12.0, 61.0}, false, always_fit).at, ElementsAre(20, 30, 40, 50, 60));
}

TEST(RoundTicks, AreFourToEightForEveryRangeWhenTheyFit) {
  for (double span = 1e-6; span < 1e9; span *= 1.037) {
    for (const double low : {0.0, -0.37 * span, 0.91 * span, -7.3 * span}) {
      const Ticks ticks = round_ticks({low, low + span}, false, always_fit);
      EXPECT_GE(ticks.at.size(), 4U) << low << " + " << span;
      EXPECT_LE(ticks.at.size(), 8U) << low << " + " << span;
      EXPECT_EQ(ticks.at.size(), ticks.labels.size());
      EXPECT_GE(ticks.at.front(), low);
      EXPECT_LE(ticks.at.back(), low + span);
      for (std::size_t i = 2; i < ticks.at.size(); ++i) {
        EXPECT_NEAR(ticks.at[i] - ticks.at[i - 1], ticks.at[1] - ticks.at[0], 1e-6 * span);
      }
    }
  }
}

TEST(RoundTicks, HaveLabelsThatDifferForEveryRange) {
  for (double span = 1e-9; span < 1e12; span *= 3.1) {
    for (const double low : {0.0, -0.5 * span, 1234.5 * span}) {
      const Ticks ticks = round_ticks({low, low + span}, false, always_fit);
      for (std::size_t i = 1; i < ticks.labels.size(); ++i) {
        EXPECT_NE(ticks.labels[i], ticks.labels[i - 1]) << low << " + " << span;
      }
    }
  }
}

TEST(RoundTicks, BecomeFewerWhereTheyDoNotFit) {
  EXPECT_THAT(round_ticks({0.0, 10.0}, false, at_most(3)).at, ElementsAre(0, 5, 10));
  EXPECT_THAT(round_ticks({0.0, 10.0}, false, at_most(2)).at, ElementsAre(0, 10));
  EXPECT_EQ(round_ticks({0.0, 10.0}, false, at_most(0)).at.size(), 1U);
}

TEST(RoundTicks, TakeQuartersRatherThanThreeHalves) {
  const Ticks ticks = round_ticks({0.0, 1.04}, false, at_most(5));
  EXPECT_THAT(ticks.labels, ElementsAre("0.00", "0.25", "0.50", "0.75", "1.00"));
}

TEST(RoundTicks, AreWrittenWithTheDigitsThatTheyNeed) {
  EXPECT_THAT(round_ticks({0.0, 1.0}, false, always_fit).labels,
              ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(round_ticks({0.0, 0.04}, false, always_fit).labels,
              ElementsAre("0.00", "0.01", "0.02", "0.03", "0.04"));
  EXPECT_THAT(round_ticks({0.0, 50'000.0}, false, always_fit).labels,
              ElementsAre("0", "10000", "20000", "30000", "40000", "50000"));
}

TEST(RoundTicks, HaveATrueMinusAndNoMinusZero) {
  EXPECT_THAT(round_ticks({-0.11, 0.11}, false, always_fit).labels,
              ElementsAre("−0.10", "−0.05", "0.00", "0.05", "0.10"));
  for (double span = 1e-3; span < 1e4; span *= 1.3) {
    for (const std::string& label : round_ticks({-span, span}, false, always_fit).labels) {
      EXPECT_EQ(label.find('-'), std::string::npos) << label;
      if (label.starts_with("−")) {
        EXPECT_NE(label.find_first_of("123456789"), std::string::npos) << label;
      }
    }
  }
}

TEST(RoundTicks, AreWrittenWithPowersWhereDigitsWouldBeTooMany) {
  EXPECT_THAT(round_ticks({0.0, 4e6}, false, at_most(5)).labels,
              ElementsAre("0", "1×10⁶", "2×10⁶", "3×10⁶", "4×10⁶"));
  EXPECT_THAT(round_ticks({-4e-7, 0.0}, false, at_most(5)).labels,
              ElementsAre("−4×10⁻⁷", "−3×10⁻⁷", "−2×10⁻⁷", "−1×10⁻⁷", "0"));
}

TEST(RoundTicks, KeepTheLastDigitsOfTimeStamps) {
  EXPECT_THAT(round_ticks({1'700'000'000.0, 1'700'000'040.0}, true, at_most(5)).labels,
              ElementsAre("1700000000", "1700000010", "1700000020", "1700000030", "1700000040"));
}

TEST(RoundTicks, AreWholeSecondsWhereThereAreSeveral) {
  EXPECT_THAT(round_ticks({0.0, 3.2}, true, always_fit).labels, ElementsAre("0", "1", "2", "3"));
  EXPECT_THAT(round_ticks({0.0, 2.0}, true, always_fit).labels, ElementsAre("0", "1", "2"));
  EXPECT_THAT(round_ticks({0.0, 0.5}, true, always_fit).labels,
              ElementsAre("0.0", "0.1", "0.2", "0.3", "0.4", "0.5"));
  for (double span = 2.1; span < 5000.0; span *= 1.07) {
    for (const double at : round_ticks({0.3, 0.3 + span}, true, always_fit).at) {
      EXPECT_EQ(at, std::round(at)) << span;
    }
  }
}

TEST(RoundTicks, StayInsideOfTheAxisSoThatVtkDrawsThem) {
  const double high = 3 * 0.1;  // just above 0.3
  const Ticks ticks = round_ticks({0.1 + 0.2 - 0.3, high}, false, always_fit);
  EXPECT_GE(ticks.at.front(), 0.1 + 0.2 - 0.3);
  EXPECT_LE(ticks.at.back(), high);
  EXPECT_EQ(ticks.labels.front(), "0.00");
  EXPECT_EQ(ticks.labels.back(), "0.30");
}

TEST(LogarithmicTicks, AreAtOneTwoAndFiveOfShortRanges) {
  const Ticks ticks = logarithmic_ticks({0.5, 20.0}, always_fit);
  EXPECT_THAT(ticks.labels, ElementsAre("0.5", "1", "2", "5", "10", "20"));
  EXPECT_THAT(ticks.at, Pointwise(DoubleNear(1e-12), {std::log10(0.5), 0.0, std::log10(2.0),
                                                      std::log10(5.0), 1.0, std::log10(20.0)}));
}

TEST(LogarithmicTicks, AreAtPowersOfTenOfLongRanges) {
  EXPECT_THAT(logarithmic_ticks({0.001, 150.0}, always_fit).labels,
              ElementsAre("0.001", "0.01", "0.1", "1", "10", "100"));
  EXPECT_THAT(logarithmic_ticks({1e-6, 1e6}, at_most(5)).labels,
              ElementsAre("10⁻⁶", "0.001", "1", "1000", "10⁶"));
}

TEST(LogarithmicTicks, AreAtBothEndsBetweenPowersOfTen) {
  EXPECT_THAT(logarithmic_ticks({1e-7, 10.0}, at_most(4)).labels,
              ElementsAre("10⁻⁷", "0.001", "10"));
  EXPECT_THAT(logarithmic_ticks({1e-3, 1e4}, at_most(5)).labels, ElementsAre("0.001", "10000"));
}

TEST(ShortNumber, HasThreeDigitsThatCountOrTwoOfSmallOnes) {
  EXPECT_EQ(short_number(1234.4), "1234");
  EXPECT_EQ(short_number(123.4), "123");
  EXPECT_EQ(short_number(12.34), "12.3");
  EXPECT_EQ(short_number(1.234), "1.23");
  EXPECT_EQ(short_number(0.1234), "0.123");
  EXPECT_EQ(short_number(0.01234), "0.012");
  EXPECT_EQ(short_number(0.00123), "0.0012");
  EXPECT_EQ(short_number(4.51e-6), "4.5×10⁻⁶");
  EXPECT_EQ(short_number(9.99e5), "1.0×10⁶");
  EXPECT_THROW((void)short_number(0.0), std::logic_error);
}

TEST(LogarithmicTicks, AreNeverNoneWhereThereIsARoundNumber) {
  // No power of ten in it, and no two labels fit.
  EXPECT_THAT(logarithmic_ticks({0.15, 0.9}, at_most(1)).labels, ElementsAre("0.2"));
  EXPECT_THAT(logarithmic_ticks({0.5, 20.0}, at_most(1)).at, testing::SizeIs(1));
}

TEST(YRange, HasAMarginOfATwentieth) {
  EXPECT_EQ(y_range_of(with_y({-1.0, 3.0, 0.0})), (AxisRange{-1.2, 3.2}));
}

TEST(YRange, BeginsAtZeroWhereTheDataNearlyDo) {
  EXPECT_EQ(y_range_of(with_y({0.5, 2.5})), (AxisRange{0.0, 2.6}));
  EXPECT_EQ(y_range_of(with_y({-0.5, -2.5})), (AxisRange{-2.6, 0.0}));
  EXPECT_EQ(y_range_of(with_y({0.0, 0.0})).low, 0.0);
  EXPECT_GT(y_range_of(with_y({100.0, 104.0})).low, 99.0);
}

TEST(YRange, IsOpenedAroundEqualValues) {
  for (const double value : {3.0, -3.0, 1e-9, 0.0, 1e20}) {
    const AxisRange range = y_range_of(with_y({value, value, value}));
    EXPECT_LT(range.low, range.high) << value;
    EXPECT_LE(range.low, value);
    EXPECT_GE(range.high, value);
  }
}

TEST(YRange, LeavesOutWhatIsNotFinite) {
  EXPECT_EQ(y_range_of(with_y({-1.0, kNan, kInfinity, -kInfinity, 1e300, 3.0})),
            (AxisRange{-1.2, 3.2}));
}

TEST(YRange, IsThereWithoutAnyData) {
  EXPECT_EQ(y_range_of({}), (AxisRange{0.0, 1.0}));
  EXPECT_EQ(y_range_of(with_y({kNan, kNan})), (AxisRange{0.0, 1.0}));
}

TEST(YRange, HoldsLevelsAndBands) {
  ChartSpec spec = with_y({1.0, 2.0});
  spec.levels.push_back({.y = 7.81});
  spec.bands.push_back({.x = {0.0, 1.0}, .low = {-4.0, 0.0}, .high = {0.0, 2.0}});
  const AxisRange range = y_range_of(spec);
  EXPECT_LT(range.low, -4.0);
  EXPECT_GT(range.high, 7.81);
}

TEST(YRange, LooksOnlyAtWhatLiesAboveTheXAxis) {
  ChartSpec spec = with_y({1.0, -2.0, 2.0, 50.0});
  spec.x.high = 2.0;
  EXPECT_EQ(y_range_of(spec), (AxisRange{-2.2, 2.2}));
}

TEST(YRange, HasTheEndsThatAreAskedFor) {
  ChartSpec spec = with_y({1.0, 3.0});
  spec.y.low = -1.0;
  EXPECT_EQ(y_range_of(spec).low, -1.0);
  EXPECT_GT(y_range_of(spec).high, 3.0);
  spec.y.high = 2.0;
  EXPECT_EQ(y_range_of(spec), (AxisRange{-1.0, 2.0}));
}

TEST(YRange, GivesWayWhereTheAskedEndLiesBeyondTheData) {
  ChartSpec spec = with_y({-3.0, -1.0});
  spec.y.low = 5.0;
  EXPECT_EQ(y_range_of(spec).low, 5.0);
  EXPECT_GT(y_range_of(spec).high, 5.0);
  spec.y = {.high = -10.0};
  EXPECT_EQ(y_range_of(spec).high, -10.0);
  EXPECT_LT(y_range_of(spec).low, -10.0);
}

TEST(YRange, RefusesEndsInTheWrongOrder) {
  ChartSpec spec;
  spec.y = {.low = 2.0, .high = 1.0};
  EXPECT_THROW((void)y_range_of(spec), std::logic_error);
  spec.y = {.low = kNan};
  EXPECT_THROW((void)y_range_of(spec), std::logic_error);
}

TEST(YRange, OfBarsBeginsAtZero) {
  EXPECT_EQ(y_range_of(with_bars({9.0, 10.0, 8.0}, false)).low, 0.0);
  EXPECT_LT(y_range_of(with_bars({9.0, -1.0, 8.0}, false)).low, -1.0);
}

TEST(YRange, OfLogarithmicBarsBeginsAtAPowerOfTenBelowTheLowest) {
  const AxisRange range = y_range_of(with_bars({0.02, 30.0, 0.0}, true));
  EXPECT_DOUBLE_EQ(range.low, 0.01);
  EXPECT_DOUBLE_EQ(range.high, 100.0) << "a tick above the highest";
  EXPECT_DOUBLE_EQ(y_range_of(with_bars({0.02, 95.0}, true)).high, 1000.0) << "room for its value";
  EXPECT_DOUBLE_EQ(y_range_of(with_bars({0.01, 30.0, kNan}, true)).low, 0.001);
  const AxisRange nothing = y_range_of(with_bars({0.0, -1.0, kNan}, true));
  EXPECT_GT(nothing.low, 0.0);
  EXPECT_LT(nothing.low, nothing.high);
}

TEST(XRange, EndsWithTheData) {
  EXPECT_EQ(x_range_of(with_y({1.0, 2.0, kNan, 3.0})), (AxisRange{0.0, 3.0}));
  EXPECT_EQ(x_range_of({}), (AxisRange{0.0, 1.0}));
  const AxisRange single = x_range_of(with_y({1.0}));
  EXPECT_LT(single.low, single.high);
}

TEST(XRange, HasHalfAGroupBesideTheBars) {
  EXPECT_EQ(x_range_of(with_bars({1.0, 2.0, 3.0}, false)), (AxisRange{-0.5, 2.5}));
}

TEST(ValueScale, PutsTheLowEndOfALogarithmicAxisAtZero) {
  const ValueScale scale{true, -2.0};
  EXPECT_DOUBLE_EQ(scale.plotted(0.01), 0.0);
  EXPECT_DOUBLE_EQ(scale.plotted(10.0), 3.0);
  EXPECT_TRUE(std::isnan(scale.plotted(0.0)));
  EXPECT_TRUE(std::isnan(scale.plotted(-1.0)));
  EXPECT_TRUE(std::isnan(ValueScale{}.plotted(kInfinity)));
  EXPECT_DOUBLE_EQ(ValueScale{}.plotted(-7.0), -7.0);
}

}  // namespace chart_axis_test
}  // namespace nadir
