// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/printable.h"

#include <gmock/gmock.h>

namespace nadir {
namespace printable_test {

const std::string kMark = "\xef\xbf\xbd";

TEST(Printable, LeavesUtf8AsItIs) {
  for (const std::string text :
       {"", "Euclidean error, m", "line\n\tnext", "\xc3\xbc \xe2\x88\x9e \xf0\x9f\x9a\x81",
        "\xc2\x80", "\xed\x9f\xbf", "\xee\x80\x80", "\xf4\x8f\xbf\xbf", "\xef\xbf\xbd"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, MarksEveryByteThatIsNoUtf8) {
  EXPECT_EQ(printable("M\xfcnchen"), "M" + kMark + "nchen");
  EXPECT_EQ(printable("\xff\xfe"), kMark + kMark);
  EXPECT_EQ(printable("a\xe2\x88"), "a" + kMark + kMark);  // cut short
  EXPECT_EQ(printable("\x80"), kMark);                     // begins in the middle
  EXPECT_EQ(printable("\xc3("), kMark + "(");
  EXPECT_EQ(printable("\xe2\x88("), kMark + kMark + "(");
}

TEST(Printable, MarksWhatUnicodeForbids) {
  for (const std::string text : {"\xc0\xaf", "\xc1\xbf"}) {  // longer than need be
    EXPECT_EQ(printable(text), kMark + kMark);
  }
  for (const std::string text :
       {"\xe0\x80\xaf", "\xed\xa0\x80", "\xed\xbf\xbf", "\xef\xbf\xbe", "\xef\xbf\xbf"}) {
    EXPECT_EQ(printable(text), kMark + kMark + kMark);
  }
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), kMark + kMark + kMark + kMark);
  EXPECT_EQ(printable("\xf0\x8f\xbf\xbf"), kMark + kMark + kMark + kMark);
}

TEST(Printable, LeavesOutControlCharacters) {
  EXPECT_EQ(printable(std::string("a\0b\x01\x1b\r\x1f", 7)), "ab");
}

TEST(Printable, ChangesNothingTheSecondTime) {
  std::string every;
  for (int byte = 0; byte < 256; ++byte) every += std::string(3, static_cast<char>(byte)) + " ";
  EXPECT_EQ(printable(printable(every)), printable(every));
}

}  // namespace printable_test
}  // namespace nadir
