// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/panel_text.h"

#include <gmock/gmock.h>

#include <limits>

namespace nadir {
namespace panel_text_test {

TEST(NameOf, IsTheLastNameWithoutARunsEnding) {
  EXPECT_EQ(name_of("/flights/loop medium 7.nadir"), "loop medium 7");
  EXPECT_EQ(name_of("/maps/town/"), "town");
  EXPECT_EQ(name_of("figure.svg"), "figure.svg");
}

TEST(NameOf, IsNeverEmptyForAPath) {
  EXPECT_EQ(name_of("/"), "/");
  EXPECT_EQ(name_of(".nadir"), ".nadir");
}

TEST(FolderOf, WritesTheHomeAsATilde) {
  EXPECT_EQ(folder_of("/home/ada/flights/a.nadir", "/home/ada"), "~/flights");
  EXPECT_EQ(folder_of("/home/ada/a.nadir", "/home/ada"), "~");
}

TEST(FolderOf, DoesNotTakeANameThatBeginsLikeTheHomeForIt) {
  EXPECT_EQ(folder_of("/home/adam/a.nadir", "/home/ada"), "/home/adam");
}

TEST(FolderOf, OfAFolderIsTheOneAroundIt) { EXPECT_EQ(folder_of("/maps/town/"), "/maps"); }

TEST(Shortened, LeavesWhatFits) {
  EXPECT_EQ(shortened("abcdef", 6), "abcdef");
  EXPECT_EQ(shortened("", 3), "");
}

TEST(Shortened, KeepsBothEndsAndMoreOfTheLast) { EXPECT_EQ(shortened("0123456789", 7), "01…6789"); }

TEST(Shortened, CountsCharactersAndCutsNoneInTwo) {
  EXPECT_EQ(shortened("äöüäöüäöü", 9), "äöüäöüäöü");
  EXPECT_EQ(shortened("äöüäöüäöü", 4), "ä…öü");
}

TEST(MemoryText, CountsAsSystemMonitorsDo) {
  EXPECT_EQ(memory_text(0), "0 MB");
  EXPECT_EQ(memory_text(212'400'000), "212 MB");
  EXPECT_EQ(memory_text(999'400'000), "999 MB");
  EXPECT_EQ(memory_text(999'600'000), "1.0 GB");
  EXPECT_EQ(memory_text(1'440'000'000), "1.4 GB");
}

TEST(LeftText, SaysNoMoreThanIsKnown) {
  EXPECT_EQ(left_text(0.2), "a few seconds left");
  EXPECT_EQ(left_text(12.3), "12 s left");
  EXPECT_EQ(left_text(180.0), "3 min left");
  EXPECT_EQ(left_text(7300.0), "2 h left");
  EXPECT_EQ(left_text(std::numeric_limits<double>::infinity()), "");
  EXPECT_EQ(left_text(std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(HasWords, WantsEachWordAnywhereInAnyCase) {
  EXPECT_TRUE(has_words("Open the demo", "DEMO open"));
  EXPECT_FALSE(has_words("Open the demo", "demo close"));
  EXPECT_TRUE(has_words("anything", "  "));
  EXPECT_FALSE(has_words("", "a"));
}

TEST(LabelOf, ShowsOneThingAndIsToldApartByAnother) {
  EXPECT_EQ(label_of("loop", "/a/loop"), "loop##/a/loop");
}

}  // namespace panel_text_test
}  // namespace nadir
