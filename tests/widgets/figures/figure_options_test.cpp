// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figure_options.h"

#include <gmock/gmock.h>

namespace nadir {
namespace {

using ::testing::HasSubstr;

std::string fault(std::string_view text) {
  const auto recipe = parse_figure_recipe(text, "r.toml");
  return recipe ? "none" : recipe.error().message;
}

TEST(FigureRecipe, ReadsWhatItWrites) {
  FigureRecipe recipe;
  recipe.figure = "compare";
  recipe.runs = {"a \"quoted\".nadir", "b.nadir"};
  recipe.map = "maps/proving-ground";
  recipe.route = "loop.toml";
  recipe.options.width = 801;
  recipe.options.theme = ThemeName::kDark;
  recipe.options.is_transparent = true;
  recipe.options.crop_east_m = -12.25;
  recipe.options.graticule = Graticule::kDegrees;
  const auto read = parse_figure_recipe(recipe_text(recipe), "r.toml");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->runs, recipe.runs);
  EXPECT_EQ(read->options.width, 801);
  EXPECT_EQ(read->options.theme, ThemeName::kDark);
  EXPECT_TRUE(read->options.is_transparent);
  EXPECT_DOUBLE_EQ(read->options.crop_east_m, -12.25);
  EXPECT_EQ(recipe_text(*read), recipe_text(recipe));
}

TEST(FigureRecipe, WritesOnlyWhatDiffersFromTheDefaults) {
  FigureRecipe recipe;
  recipe.figure = "labels";
  EXPECT_EQ(recipe_text(recipe), "figure = \"labels\"\n");
}

TEST(FigureRecipe, NamesAnUnknownKeyAndTheNearestKnownOne) {
  EXPECT_THAT(fault("figure = \"cdf\"\nrun = [\"a\"]\n"),
              HasSubstr("run is no known key (did you mean runs?)"));
  EXPECT_THAT(fault("figure = \"cdf\"\n[options]\nwitdh = 3\n"),
              HasSubstr("witdh: no such option (did you mean width?)"));
  EXPECT_THAT(fault("figure = \"cdf\"\n[options]\nwidth = 0\n"),
              HasSubstr("0 is not in [200, 16000]"));
  EXPECT_THAT(fault("figure = \"cdf\"\n[options]\ntheme = \"blue\"\n"), HasSubstr("theme"));
  EXPECT_THAT(fault("runs = []\n"), HasSubstr("figure"));
}

}  // namespace
}  // namespace nadir
