// SPDX-License-Identifier: Apache-2.0
#include "core/base/utf8.h"

#include <gmock/gmock.h>

#include <random>

namespace nadir {
namespace utf8_test {

using namespace std::string_view_literals;

TEST(Utf8, KnowsTheLengthOfEveryCharacter) {
  EXPECT_EQ(utf8_length("a"), 1U);
  EXPECT_EQ(utf8_length("\xC3\xA9 and more"), 2U);
  EXPECT_EQ(utf8_length("\xE2\x82\xAC"), 3U);
  EXPECT_EQ(utf8_length("\xF0\x9F\x9B\xA9"), 4U);
  EXPECT_EQ(utf8_length("\xF4\x8F\xBF\xBF"), 4U) << "the last";
}

TEST(Utf8, TakesNothingElseForACharacter) {
  for (const char* const none :
       {"\xE9", "\x80", "\xC3", "\xC3(", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80",
        "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xE2\x82"}) {
    EXPECT_EQ(utf8_length(none), 0U);
  }
}

TEST(Utf8, LeavesTextAsItIs) {
  for (const char* const text : {"", "loop.nadir",
                                 "Stra\xC3\x9F"
                                 "e \xE2\x82\xAC \xF0\x9F\x9B\xA9",
                                 "\xEE\xBE\x80"}) {
    EXPECT_EQ(utf8_of_bytes(text), text);
    EXPECT_EQ(bytes_of_utf8(text), text);
  }
}

TEST(Utf8, WritesBytesThatAreNoTextByTheirNumbers) {
  const std::string mark(kByteMark);
  EXPECT_EQ(utf8_of_bytes("caf\xE9.nadir"), "caf" + mark + "E9.nadir");
  EXPECT_EQ(utf8_of_bytes(kByteMark), mark + "EF" + mark + "BF" + mark + "BF");
}

TEST(Utf8, LeavesAMarkThatStandsBeforeNoNumber) {
  const std::string mark(kByteMark);
  for (const std::string& text : {mark, mark + "E", mark + "eg", mark + "e9"}) {
    EXPECT_EQ(bytes_of_utf8(text), text);
  }
}

TEST(Utf8, GivesAnyBytesBackAndIsAlwaysText) {
  // Bytes of which characters, broken ones, marks and what looks like an escape are made.
  constexpr std::string_view kBytes =
      "\xEF\xBF\xBF\xEF\xBF\xBF"
      "E9aF\xC3\xA9\x80\xFF\xF0\x9F\x00\xED\xA0"sv;
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes;
    for (int i = 0; i < 12; ++i) {
      bytes += kBytes[random() % kBytes.size()];
    }
    const std::string text = utf8_of_bytes(bytes);
    EXPECT_EQ(bytes_of_utf8(text), bytes);
    for (std::string_view left = text; !left.empty(); left.remove_prefix(utf8_length(left))) {
      ASSERT_GT(utf8_length(left), 0U) << round;
    }
  }
}

}  // namespace utf8_test
}  // namespace nadir
