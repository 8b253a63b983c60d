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

TEST(MomentKinds, TellTheSameByShapeAsByColour) {
  const Theme& dark = theme(ThemeName::kDark);
  for (std::size_t i = 0; i < kKinds; ++i) {
    for (std::size_t k = 0; k < kKinds; ++k) {
      const auto a = static_cast<MomentKind>(i), b = static_cast<MomentKind>(k);
      EXPECT_EQ(moment_mark(a) == moment_mark(b), moment_colour(a, dark) == moment_colour(b, dark));
    }
  }
  EXPECT_EQ(moment_mark(MomentKind::kLost), MomentMark::kFilledDiamond);
  EXPECT_EQ(moment_mark(MomentKind::kMissingData), MomentMark::kHollowDiamond);
  EXPECT_EQ(moment_mark(MomentKind::kFound), MomentMark::kDisc);
}

TEST(MomentKinds, TheKeyNamesEveryKindOnce) {
  std::string key;
  for (const std::string& line : mark_key_lines()) key += line + "\n";
  for (std::size_t i = 0; i < kKinds; ++i) {
    const std::string name(moment_kind_look(static_cast<MomentKind>(i)).name);
    EXPECT_THAT(key, HasSubstr(name));
    EXPECT_EQ(key.find(name), key.rfind(name)) << name;
  }
  EXPECT_THAT(key, HasSubstr("hollow amber diamond: low agreement, missing data\n"));
  EXPECT_THAT(key, HasSubstr("bookmark"));
}

TEST(MomentKinds, AreDrawnFullHollowOrRound) {
  const Theme& light = theme(ThemeName::kLight);
  const auto fills = [&light](MomentKind kind) {
    RecordedPage page;
    draw_moment_mark(page, {10.0, 10.0}, 4.0, kind, light);
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
  EXPECT_EQ(severity_words(3.21), "severity 3.2: so many times the limit of its kind");
  EXPECT_EQ(severity_words(42.3), "severity 42: so many times the limit of its kind");
}

}  // namespace moment_kinds_test
}  // namespace nadir
