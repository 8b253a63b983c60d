// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_colours.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/colour_vision.h"

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

TEST(Casing, LetsEveryLineOverImageryStandOut) {
  for (const ThemeName name : {ThemeName::kLight, ThemeName::kDark}) {
    const Theme& colours = theme(name);
    std::vector<Rgba> lines = {colours.truth_on_imagery, colours.odometry_on_imagery,
                               Rgba{10, 10, 60}, Rgba{250, 250, 120}};
    for (std::size_t run = 0; run < 4; ++run) lines.push_back(run_colour_on_imagery(colours, run));
    for (const Rgba line : lines) {
      const Rgba casing = casing_over_imagery(colours, line);
      EXPECT_GE(contrast(line, casing), 4.5);
      EXPECT_GE(contrast(line, casing), contrast(line, light_on_imagery(colours)));
      EXPECT_GE(contrast(line, casing), contrast(line, colours.casing_on_imagery));
    }
  }
}

TEST(Casing, IsLightUnderADarkLineAlone) {
  const Theme& light = theme(ThemeName::kLight);
  EXPECT_EQ(casing_over_imagery(light, light.estimate_on_imagery), light_on_imagery(light));
  EXPECT_EQ(casing_over_imagery(light, light.truth_on_imagery), light.casing_on_imagery);
  EXPECT_EQ(casing_over_imagery(light, light.second_run), light.casing_on_imagery);
  const Theme& dark = theme(ThemeName::kDark);
  EXPECT_EQ(casing_over_imagery(dark, dark.estimate_on_imagery), dark.casing_on_imagery);
}

}  // namespace map_colours_test
}  // namespace nadir
