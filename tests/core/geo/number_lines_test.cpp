// SPDX-License-Identifier: Apache-2.0
#include "core/geo/number_lines.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace nadir {
namespace number_lines_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::vector<double>> all_lines(std::string_view text) {
  std::vector<std::vector<double>> result;
  NumberLines lines(text, "drawn.txt");
  while (true) {
    const auto line = lines.next();
    EXPECT_TRUE(line) << error_text(line);
    if (!line || !line->has_value()) return result;
    result.emplace_back((*line)->values.begin(), (*line)->values.end());
  }
}

std::string first_error(std::string_view text) {
  NumberLines lines(text, "drawn.txt");
  while (true) {
    const auto line = lines.next();
    if (!line) return error_text(line);
    if (!line->has_value()) return "(no error)";
  }
}

TEST(NumberLines, SkipsBlankLinesAndComments) {
  EXPECT_THAT(all_lines("# head\n\n1 2 # tail\n   \n#\n3\n"),
              ElementsAre(ElementsAre(1.0, 2.0), ElementsAre(3.0)));
}

TEST(NumberLines, ReadsLineEndsOfWindowsTabsAndAByteOrderMark) {
  EXPECT_THAT(all_lines("\xEF\xBB\xBF"
                        "1\t2\r\n 3  4 \r\n"),
              ElementsAre(ElementsAre(1.0, 2.0), ElementsAre(3.0, 4.0)));
}

TEST(NumberLines, TheLastLineNeedsNoEnd) {
  EXPECT_THAT(all_lines("1\n2"), ElementsAre(ElementsAre(1.0), ElementsAre(2.0)));
  EXPECT_THAT(all_lines(""), ElementsAre());
}

TEST(NumberLines, ReadsEveryWayToWriteANumber) {
  EXPECT_THAT(all_lines("+1.5 -2 3e2 4.E-1 .5 -0 1.000000000000000000e+00"),
              ElementsAre(ElementsAre(1.5, -2.0, 300.0, 0.4, 0.5, 0.0, 1.0)));
}

TEST(NumberLines, NamesFileAndLineOfAWordThatIsNoNumber) {
  EXPECT_EQ(first_error("1 2\n# comment\n3 x4\n"), "drawn.txt: line 3: 'x4' is not a number");
  EXPECT_THAT(first_error("1,2,3"), HasSubstr("'1,2,3' is not a number"));
  EXPECT_THAT(first_error("0x10"), HasSubstr("is not a number"));
  EXPECT_THAT(first_error("1-2"), HasSubstr("is not a number"));
  EXPECT_THAT(first_error("+-2"), HasSubstr("is not a number"));
  EXPECT_THAT(first_error("+"), HasSubstr("is not a number"));
}

TEST(NumberLines, RefusesNanInfinityAndNumbersTooLarge) {
  for (const char* const word : {"nan", "-NaN", "inf", "-Infinity", "1e400"}) {
    EXPECT_THAT(first_error(word), HasSubstr("is not a finite number")) << word;
  }
}

TEST(NumberLines, MessagesShowNeitherControlBytesNorEndlessWords) {
  EXPECT_THAT(first_error(std::string("a\x1B[31m\0b", 8)), Not(HasSubstr("\x1B")));
  EXPECT_LT(first_error(std::string(100'000, 'z')).size(), 100U);
}

TEST(NumberLines, CountsLinesAsAnEditorDoes) {
  NumberLines lines("\r\n# one\r\n\r\n7\r\n", "drawn.txt");
  const auto line = lines.next();
  ASSERT_TRUE(line && line->has_value());
  EXPECT_EQ((*line)->line, 4U);
  EXPECT_EQ(lines.where((*line)->line), "drawn.txt: line 4");
}

}  // namespace number_lines_test
}  // namespace nadir
