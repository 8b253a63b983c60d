// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/moment_kinds.h"

#include <gmock/gmock.h>

#include <set>

#include "tests/support/recorded_page.h"

namespace nadir {
namespace moment_kinds_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::size_t kKinds = EnumNames<MomentKind>::kNames.size();

TEST(MomentKinds, HaveNamesMeaningsAndIconsOfTheirOwn) {
  std::set<std::string_view> names, meanings;
  std::set<kit::Icon> icons;
  for (std::size_t i = 0; i < kKinds; ++i) {
    const MomentKindLook& look = moment_kind_look(static_cast<MomentKind>(i));
    names.insert(look.name);
    meanings.insert(look.meaning);
    icons.insert(look.icon);
  }
  EXPECT_EQ(names.size(), kKinds);
  EXPECT_EQ(meanings.size(), kKinds);
  EXPECT_EQ(icons.size(), kKinds);
}

MomentMark mark_of_kind(MomentKind kind, bool is_near_truth = false) {
  WorstMoment moment;
  moment.kind = kind;
  moment.is_near_truth = is_near_truth;
  return moment_mark(moment);
}

TEST(MomentKinds, TellTheSameByShapeAsByColour) {
  const Theme& dark = theme(ThemeName::kDark);
  for (std::size_t i = 0; i < kKinds; ++i) {
    for (std::size_t k = 0; k < kKinds; ++k) {
      const MomentMark a = mark_of_kind(static_cast<MomentKind>(i));
      const MomentMark b = mark_of_kind(static_cast<MomentKind>(k));
      EXPECT_EQ(a == b, mark_colour(a, dark) == mark_colour(b, dark));
    }
  }
  EXPECT_EQ(mark_of_kind(MomentKind::kLost), MomentMark::kFilledDiamond);
  EXPECT_EQ(mark_of_kind(MomentKind::kMissingData), MomentMark::kHollowDiamond);
  EXPECT_EQ(mark_of_kind(MomentKind::kFound), MomentMark::kDisc);
}

TEST(MomentKinds, OfAnEstimateNearTheTruthNothingIsMarkedAsWrong) {
  for (std::size_t i = 0; i < kKinds; ++i) {
    const auto kind = static_cast<MomentKind>(i);
    EXPECT_NE(mark_of_kind(kind, true), MomentMark::kFilledDiamond) << enum_name(kind);
  }
  EXPECT_EQ(mark_of_kind(MomentKind::kLargestError, true), MomentMark::kHollowDiamond);
  EXPECT_EQ(mark_of_kind(MomentKind::kFound, true), MomentMark::kDisc);
}

TEST(MomentWords, SayWhatIsMarkedOnce) {
  WorstMoment moment;
  moment.words = "3.2 m off, 95 % ellipse 4.1 m";
  EXPECT_EQ(moment_words(moment), "largest error of this stretch: 3.2 m off, 95 % ellipse 4.1 m");
  moment.kind = MomentKind::kOverConfident;
  EXPECT_EQ(moment_words(moment), "high NEES: 3.2 m off, 95 % ellipse 4.1 m");
  moment.kind = MomentKind::kFound;
  moment.words = "found again after 4.2 s";
  EXPECT_EQ(moment_words(moment), "found again after 4.2 s");
}

TEST(MomentKinds, TheKeyNamesEveryKindOnce) {
  std::string key;
  for (const std::string& line : mark_key_lines()) key += line + "\n";
  for (std::size_t i = 0; i < kKinds; ++i) {
    const std::string name(moment_kind_look(static_cast<MomentKind>(i)).name);
    EXPECT_THAT(key, HasSubstr(name));
    EXPECT_EQ(key.find(name), key.rfind(name)) << name;
  }
  EXPECT_THAT(key, HasSubstr("hollow amber diamond, doubtful: low agreement, missing data\n"));
  EXPECT_THAT(key, HasSubstr("within 2 m and 10° of the truth"));
  EXPECT_THAT(key, HasSubstr("bookmark"));
}

TEST(MomentKinds, AreDrawnFullHollowOrRound) {
  const Theme& light = theme(ThemeName::kLight);
  const auto fills = [&light](MomentKind kind) {
    RecordedPage page;
    draw_moment_mark(page, {10.0, 10.0}, 4.0, mark_of_kind(kind), light);
    return page.fills;
  };
  EXPECT_EQ(fills(MomentKind::kLost), 1U);
  EXPECT_EQ(fills(MomentKind::kLowAgreement), 2U) << "its middle is the ground again";
  EXPECT_EQ(fills(MomentKind::kFound), 1U);
}

TEST(BySeverity, HasTheMostSevereFirstAndOfEqualsTheEarlier) {
  std::vector<WorstMoment> moments(4);
  moments[0].severity = 1.0;
  moments[1].severity = 3.0;
  moments[2].severity = 1.0;
  moments[3].severity = 7.0;
  EXPECT_THAT(by_severity(moments), ElementsAre(3U, 1U, 0U, 2U));
  EXPECT_TRUE(by_severity({}).empty());
}

TEST(SeverityWords, HaveAsManyDigitsAsMatter) {
  const auto words = [](double severity, MomentKind kind = MomentKind::kOverConfident) {
    WorstMoment moment;
    moment.kind = kind;
    moment.severity = severity;
    return severity_words(moment);
  };
  EXPECT_EQ(words(3.21), "3.2 times what is worth a look");
  EXPECT_EQ(words(42.3), "42 times what is worth a look");
  EXPECT_EQ(words(1.02), "just worth a look");
  EXPECT_EQ(words(0.3, MomentKind::kLargestError), "the largest of this run, and small");
  EXPECT_EQ(words(1.0, MomentKind::kFound), "") << "nothing is wrong";
}

}  // namespace moment_kinds_test
}  // namespace nadir
