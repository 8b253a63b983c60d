// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figure_recipe.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace figure_recipe_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string fault(std::string_view text) { return error_text(parse_figure_recipe(text, "r.toml")); }

std::string option_fault(std::string_view name, std::string_view text) {
  FigureOptions options;
  return error_text(set_option(options, name, text));
}

TEST(FigureRecipe, ReadsWhatItWrites) {
  FigureRecipe recipe;
  recipe.figure = "compare";
  recipe.runs = {"a \"quoted\".nadir", "b.nadir"};
  recipe.map = "maps/proving-ground";
  recipe.route = "loop.toml";
  recipe.options.size = {801, 400};
  recipe.options.theme = ThemeName::kDark;
  recipe.options.is_transparent = true;
  recipe.options.crop = {40.0, Eigen::Vector2d(-12.25, 3.0)};
  recipe.options.layers.set(FigureLayer::kParticles, false);
  recipe.options.graticule = Graticule::kDegrees;
  recipe.inputs = {{"00ff", "01ff"}, "ab", "cd"};
  const auto read = parse_figure_recipe(recipe_text(recipe), "r.toml");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->runs, recipe.runs);
  EXPECT_EQ(read->options.size, recipe.options.size);
  EXPECT_EQ(read->options.theme, ThemeName::kDark);
  EXPECT_TRUE(read->options.is_transparent);
  EXPECT_EQ(read->options.crop, recipe.options.crop);
  EXPECT_EQ(read->options.layers, recipe.options.layers);
  EXPECT_THAT(read->inputs.runs, ElementsAre("00ff", "01ff"));
  EXPECT_EQ(read->inputs.map, "ab");
  EXPECT_EQ(read->inputs.route, "cd");
  EXPECT_EQ(recipe_text(*read), recipe_text(recipe));
}

TEST(FigureRecipe, WritesOnlyWhatDiffersFromTheDefaults) {
  FigureRecipe recipe;
  recipe.figure = "labels";
  EXPECT_EQ(recipe_text(recipe), "figure = \"labels\"\n");
}

TEST(FigureRecipe, QuotesWordsAndNotNumbersOfEveryOption) {
  FigureRecipe recipe;
  recipe.figure = "labels";
  for (const OptionText& option : option_texts(FigureOptions{})) {
    std::string other = option.kind == OptionKind::kBoolean ? "true" : "3";
    if (option.kind == OptionKind::kChoice) {
      other = option.range.substr(option.range.rfind(' ') + 1);
    }
    if (option.name == "size") other = "300";
    if (option.name == "crop") other = "30@1,2";
    if (option.name == "layers") other = "truth";
    if (option.name == "stack") other = "topview:0.5,truth#FF8800";
    if (option.name == "label-opacity") other = "0.5";
    ASSERT_TRUE(set_option(recipe.options, option.name, other).has_value()) << option.name;
  }
  const auto read = parse_figure_recipe(recipe_text(recipe), "r.toml");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(recipe_text(*read), recipe_text(recipe));
}

TEST(FigureRecipe, NamesAnUnknownKeyAndTheNearestKnownOne) {
  EXPECT_THAT(fault("figure = \"cdf\"\nrun = [\"a\"]\n"),
              HasSubstr("run is no known key (did you mean runs?)"));
  EXPECT_THAT(fault("figure = \"cdf\"\n[options]\nsise = 300\n"),
              HasSubstr("sise: no such option (did you mean size?)"));
  EXPECT_THAT(fault("figure = \"cdf\"\n[inputs]\nrun = \"a\"\n"),
              HasSubstr("run is no known key (did you mean runs?)"));
  EXPECT_THAT(fault("figure = \"cdf\"\n[options]\nsize = 0\n"),
              HasSubstr("r.toml: options: --size: a width of 0 is not in [200, 16000]"));
  EXPECT_THAT(fault("figure = \"cdf\"\n[options]\ntheme = \"blue\"\n"), HasSubstr("theme"));
  EXPECT_THAT(fault("runs = []\n"), HasSubstr("figure"));
}

TEST(FigureRecipe, OfAFileHasPathsThatStartAtTheFilesFolder) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "map");
  const auto path = folder.file("recipes/r.toml",
                                "figure = \"compare\"\nruns = [\"../a.nadir\", \"/b.nadir\"]\n"
                                "map = \"../map\"\nroute = \"loop.toml\"\n");
  const auto recipe = read_figure_recipe(path);
  ASSERT_TRUE(recipe) << recipe.error().message;
  EXPECT_THAT(recipe->runs, ElementsAre((folder.path() / "a.nadir").string(), "/b.nadir"));
  EXPECT_EQ(recipe->map, (folder.path() / "map").string());
  EXPECT_EQ(recipe->route, (folder.path() / "recipes/loop.toml").string());
}

TEST(FigureRecipe, OfAFileKeepsTheNameOfAMapThatTheProgramBringsAlong) {
  const ScratchFolder folder;
  const auto path = folder.file("r.toml", "figure = \"labels\"\nmap = \"maps/proving-ground\"\n");
  const auto recipe = read_figure_recipe(path);
  ASSERT_TRUE(recipe) << recipe.error().message;
  EXPECT_EQ(recipe->map, "maps/proving-ground");
  EXPECT_EQ(recipe->route, "");
}

TEST(ChangedInputs, AreNamedWhereBothHashesAreKnownAndDiffer) {
  FigureRecipe recipe;
  recipe.runs = {"a.nadir", "b.nadir"};
  recipe.inputs = {{"1", "2"}, "3", "4"};
  EXPECT_THAT(changed_inputs(recipe, recipe.inputs), IsEmpty());
  EXPECT_THAT(changed_inputs(recipe, {{"1", "x"}, "y", "z"}),
              ElementsAre("b.nadir has changed since the figure was drawn",
                          "the run's map has changed since the figure was drawn",
                          "the map's route has changed since the figure was drawn"));
  recipe.map = "town";
  recipe.route = "loop.toml";
  EXPECT_THAT(changed_inputs(recipe, {{}, "y", "z"}),
              ElementsAre(HasSubstr("town has changed"), HasSubstr("loop.toml has changed")));
  EXPECT_THAT(changed_inputs(recipe, {}), IsEmpty());
  recipe.inputs = {};
  EXPECT_THAT(changed_inputs(recipe, {{"1"}, "3", "4"}), IsEmpty());
}

TEST(PageSizeOption, IsAWidthOrBothSides) {
  FigureOptions options;
  ASSERT_TRUE(set_option(options, "size", "1600x1000"));
  EXPECT_EQ(options.size, (PageSize{1600, 1000}));
  EXPECT_EQ(options.size.text(), "1600x1000");
  ASSERT_TRUE(set_option(options, "size", "320"));
  EXPECT_EQ(options.size, (PageSize{320, 0}));
  EXPECT_EQ(options.size.text(), "320");
}

TEST(PageSizeOption, IsRefusedByOneSentence) {
  EXPECT_EQ(option_fault("size", "0"), "--size: a width of 0 is not in [200, 16000]");
  EXPECT_EQ(option_fault("size", "100000"), "--size: a width of 100000 is not in [200, 16000]");
  EXPECT_EQ(option_fault("size", "800x0"), "--size: a height of 0 is not in [100, 16000]");
  EXPECT_EQ(option_fault("size", "800x100000"),
            "--size: a height of 100000 is not in [100, 16000]");
  for (const char* bad :
       {"", "x", "800x", "x600", "800*600", "8e2", "800x600x2", " 800", "99999999999", "1600.0"}) {
    EXPECT_EQ(option_fault("size", bad),
              "--size: '" + std::string(bad) + "' is neither WIDTH nor WIDTHxHEIGHT in pixels");
  }
  FigureOptions options;
  options.size.height = -1;
  EXPECT_EQ(error_text(validate(options)), "--size: a height of -1 is not in [100, 16000]");
}

TEST(FigureLayersOption, IsAllNoneAListOrAllButAList) {
  FigureOptions options;
  EXPECT_EQ(options.layers.text(), "all");
  ASSERT_TRUE(set_option(options, "layers", "truth,picture"));
  EXPECT_EQ(options.layers.text(), "picture,truth");
  EXPECT_TRUE(options.layers.has(FigureLayer::kTruth));
  EXPECT_FALSE(options.layers.has(FigureLayer::kParticles));
  ASSERT_TRUE(set_option(options, "layers", "-particles,-modes"));
  EXPECT_EQ(options.layers.text(), "picture,truth,odometry,estimate,ellipses,topview");
  ASSERT_TRUE(set_option(options, "layers", "none"));
  EXPECT_EQ(options.layers.text(), "none");
  ASSERT_TRUE(set_option(options, "layers", "all"));
  EXPECT_EQ(options.layers, FigureLayers());
}

TEST(FigureLayersOption, NamesTheNearestLayerAndRefusesAMixture) {
  EXPECT_EQ(option_fault("layers", "partikles"),
            "--layers: 'partikles' is no layer (did you mean particles?)");
  EXPECT_EQ(option_fault("layers", "truth,-modes"),
            "--layers: '-modes': either all names have a minus or none has");
  EXPECT_EQ(option_fault("layers", "truth,"), "--layers: '' is no layer");
  EXPECT_EQ(option_fault("layers", ""), "--layers: '' is no layer");
}

TEST(ChangedInputs, NameThePictureOfAMapWhereItIsShown) {
  FigureRecipe recipe;
  recipe.figure = "trajectories";
  recipe.inputs.picture = "01";
  InputHashes now;
  now.picture = "01";
  EXPECT_THAT(changed_inputs(recipe, now), testing::IsEmpty());
  now.picture = "02";
  EXPECT_THAT(
      changed_inputs(recipe, now),
      testing::ElementsAre("the picture of the run's map has changed since the figure was drawn"));
  now.picture.clear();  // it is gone
  recipe.map = "town";
  EXPECT_THAT(changed_inputs(recipe, now),
              testing::ElementsAre("the picture of town has changed since the figure was drawn"));
  recipe.options.layers.set(FigureLayer::kPicture, false);
  EXPECT_THAT(changed_inputs(recipe, now), testing::IsEmpty());
  const auto again = parse_figure_recipe(recipe_text(recipe), "r");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->inputs.picture, "01");
}

TEST(MapCropOption, IsAWidthWithOrWithoutAPoint) {
  FigureOptions options;
  EXPECT_EQ(options.crop.text(), "all");
  ASSERT_TRUE(set_option(options, "crop", "40.5"));
  EXPECT_EQ(options.crop, (MapCrop{40.5, std::nullopt}));
  ASSERT_TRUE(set_option(options, "crop", "40@12.5,-30"));
  EXPECT_EQ(options.crop, (MapCrop{40.0, Eigen::Vector2d(12.5, -30.0)}));
  EXPECT_EQ(options.crop.text(), "40@12.5,-30");
  ASSERT_TRUE(set_option(options, "crop", "all"));
  EXPECT_TRUE(options.crop.is_all());
}

TEST(MapCropOption, IsRefusedByOneSentence) {
  const auto fault_of = [](const char* text) {
    const auto crop = MapCrop::from_text(text);
    if (!crop) return crop.error().message;
    const auto checked = crop->check();
    return checked ? std::string("none") : checked.error().message;
  };
  for (const char* text : {"", "wide", "40,3", "40@", "40@1", "40@1,", "40@1,x", "nan", "4 0"}) {
    EXPECT_EQ(fault_of(text), fmt::format("'{}' is neither all, WIDTH nor WIDTH@EAST,NORTH in "
                                          "metres",
                                          text));
  }
  EXPECT_EQ(fault_of("0"), "a width of 0 m shows nothing");
  EXPECT_EQ(fault_of("1e-13"), "a width of 1e-13 m is not in [0.1, 1e+06]");
  EXPECT_EQ(fault_of("-4"), "a width of -4 m is not in [0.1, 1e+06]");
  EXPECT_EQ(fault_of("4@2e6,0"), "2e+06,0 is more than 1e+06 m from the map's origin");
  EXPECT_EQ(fault_of("4@1e6,-1e6"), "none");
}

TEST(FigureRecipe, TakesLayersAsAList) {
  const auto recipe = parse_figure_recipe(
      "figure = \"moment\"\n[options]\nlayers = [\"truth\", \"picture\"]\n", "r.toml");
  ASSERT_TRUE(recipe) << recipe.error().message;
  EXPECT_EQ(recipe->options.layers.text(), "picture,truth");
}

}  // namespace figure_recipe_test
}  // namespace nadir
