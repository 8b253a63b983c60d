// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/wrapped_lines.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

namespace nadir::kit {
namespace wrapped_lines_test {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string& long_words() {
  static const std::string words =
      "What the filter's weights are made of: 0 fits everywhere, 1 nowhere; computed with the "
      "run's own options, at the place where the estimate was at this moment";
  return words;
}

std::string without_spaces(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text;
}

TEST(WrappedLines, LeaveWhatFitsAsItIs) {
  EXPECT_THAT(wrapped_lines("Play or pause", 60), ElementsAre("Play or pause"));
  EXPECT_THAT(wrapped_lines("made  1.25 m", 60), ElementsAre("made  1.25 m"))
      << "spaces that line something up";
  EXPECT_THAT(wrapped_lines("", 60), IsEmpty());
}

TEST(WrappedLines, AreNoLongerThanTheyMayBe) {
  for (std::size_t most = 8; most <= 80; ++most) {
    for (const std::string& line : wrapped_lines(long_words(), most)) {
      EXPECT_LE(character_count(line), most) << line;
      EXPECT_NE(line.front(), ' ');
      EXPECT_NE(line.back(), ' ');
    }
  }
}

TEST(WrappedLines, LoseNoWord) {
  for (std::size_t most = 4; most <= 80; ++most) {
    std::string all;
    for (const std::string& line : wrapped_lines(long_words(), most)) all += line;
    EXPECT_EQ(without_spaces(all), without_spaces(long_words())) << most;
  }
}

TEST(WrappedLines, AreAsFewAsPossible) {
  for (std::size_t most = 20; most <= 80; ++most) {
    const std::size_t least = (long_words().size() + most) / (most + 1);
    const std::size_t lines = wrapped_lines(long_words(), most).size();
    EXPECT_GE(lines, least);
    EXPECT_LE(lines, least + 2) << "words are shorter than half a line";
  }
}

TEST(WrappedLines, AreAboutEquallyLong) {
  const auto lines =
      wrapped_lines("a tooltip of sixty and some characters would leave one word", 56);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_GT(lines[1].size(), 20U) << "not one word alone";
  const auto three = wrapped_lines(long_words(), 60);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_GT(three[2].size(), 40U);
}

TEST(WrappedLines, KeepANumberWithItsUnit) {
  for (std::size_t most = 10; most < 40; ++most) {
    const auto lines =
        wrapped_lines("the bar is 250 m long and 43 % of it are at 12.5 Hz now", most);
    std::string all;
    for (const std::string& line : lines) {
      EXPECT_NE(line.substr(0, 2), "m ") << most;
      EXPECT_NE(line.substr(0, 1), "%") << most;
      EXPECT_NE(line.substr(0, 2), "Hz") << most;
      all += line;
    }
    EXPECT_EQ(without_spaces(all), "thebaris250mlongand43%ofitareat12.5Hznow");
  }
}

TEST(WrappedLines, PartPathsAfterASlash) {
  const std::string path = "/srv/flights/2018/proving-ground/medium-loop/run-7.nadir";
  const auto lines = wrapped_lines(path, 30);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].back(), '/');
  EXPECT_EQ(lines[1].back(), '/');
  EXPECT_EQ(lines[0] + lines[1] + lines[2], path);
}

TEST(WrappedLines, PartAnythingThatIsTooLong) {
  const auto lines = wrapped_lines(std::string(25, 'x'), 10);
  EXPECT_THAT(lines, testing::SizeIs(3));
  for (const std::string& line : lines) EXPECT_LE(line.size(), 10U);
  EXPECT_THAT(wrapped_lines("ab", 0), ElementsAre("a", "b")) << "a line has room for something";
}

TEST(WrappedLines, DoNotCutCharactersInTwo) {
  const auto lines = wrapped_lines("äöüäöüäöüäöü", 5);
  for (const std::string& line : lines) {
    EXPECT_LE(character_count(line), 5U);
    EXPECT_EQ(line.size() % 2, 0U) << "each of these has two bytes";
  }
}

TEST(WrappedLines, KeepTheBreaksThatAreThere) {
  EXPECT_THAT(wrapped_lines("one\ntwo three", 60), ElementsAre("one", "two three"));
  EXPECT_THAT(wrapped_lines("one two\nthree", 4), ElementsAre("one", "two", "thre", "e"));
}

TEST(CharacterCounts, AreNotThoseOfBytes) {
  EXPECT_EQ(character_count("µm"), 2U);
  EXPECT_EQ(character_count("12 °"), 4U);
  EXPECT_EQ(character_count(""), 0U);
}

}  // namespace wrapped_lines_test
}  // namespace nadir::kit
