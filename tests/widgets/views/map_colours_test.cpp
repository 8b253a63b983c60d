// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_colours.h"

#include <gtest/gtest.h>

namespace nadir {
namespace map_colours_test {

TEST(MapColours, AreReadFromSixDigitsOnly) {
  EXPECT_EQ(colour_from_hex("#FF8000"), (Rgba{255, 128, 0}));
  EXPECT_EQ(colour_from_hex("#0a0b0c"), (Rgba{10, 11, 12}));
  for (const char* text : {"", "#12345", "#12345G", "1234567", "#1234567"}) {
    EXPECT_FALSE(colour_from_hex(text)) << text;
  }
}

TEST(MapColours, FadeWithTheOpacityThatTheyHave) {
  EXPECT_EQ(faded({1, 2, 3}, 0.5), (Rgba{1, 2, 3, 128}));
  EXPECT_EQ(faded({1, 2, 3, 100}, 0.5), (Rgba{1, 2, 3, 50}));
  EXPECT_EQ(faded({1, 2, 3, 100}, 0.0).alpha, 0);
}

TEST(MapColours, OverImageryAreLightOnTheDarkCasing) {
  for (const ThemeName name : {ThemeName::kLight, ThemeName::kDark}) {
    const Rgba light = light_on_imagery(theme(name)), dark = theme(name).casing_on_imagery;
    EXPECT_GT(light.red + light.green + light.blue, 600 + dark.red + dark.green + dark.blue);
  }
}

}  // namespace map_colours_test
}  // namespace nadir
