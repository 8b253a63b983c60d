// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_options.h"

#include <gmock/gmock.h>

#include "core/map/map_summary.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace run_options_test {

using testing::HasSubstr;

std::string fault(const std::string& recipe) {
  const ScratchFolder scratch;
  const auto read = read_run_recipe(scratch.file("recipe.toml", recipe));
  return read ? "none" : read.error().message;
}

TEST(RunRecipe, SetsOptionsOfTopviewAndFilterOverItsPreset) {
  const ScratchFolder scratch;
  const auto recipe =
      read_run_recipe(scratch.file("r.toml",
                                   "preset = \"thesis\"\n[options]\nmin-votes = "
                                   "5\nlane-marking-vote = 2.5\nmatch = \"distance\"\n"));
  ASSERT_TRUE(recipe.has_value()) << recipe.error().message;
  EXPECT_EQ(recipe->preset, "thesis");
  EXPECT_EQ(recipe->options.topview.min_votes, 5);
  EXPECT_DOUBLE_EQ(recipe->options.topview.lane_marking_vote, 2.5);
  EXPECT_EQ(recipe->options.localiser.match, MatchKind::kDistance);
  EXPECT_EQ(recipe->options.localiser.likelihood, LikelihoodKind::kThesis);
}

TEST(RunPreset, OfTheDefaultWeighsClassesAsMapSummariesDo) {
  EXPECT_EQ(run_preset("default").value().localiser.alpha, MapSummary{}.alpha_reading);
  EXPECT_EQ(run_preset("thesis").value().localiser.alpha, ImportanceReading::kInverseShare);
}

TEST(RunRecipe, IsTheDefaultPresetWhenItIsEmpty) { EXPECT_EQ(fault(""), "none"); }

TEST(RunRecipe, NamesAnUnknownKeyAndTheNearestKnownOne) {
  EXPECT_THAT(fault("presset = \"thesis\"\n"),
              HasSubstr("presset is no known key (did you mean preset?)"));
  EXPECT_THAT(fault("[options]\nmin-vote = 5\n"), HasSubstr("did you mean min-votes?"));
  EXPECT_THAT(fault("preset = \"thesi\"\n"), HasSubstr("did you mean thesis?"));
}

TEST(RunRecipe, RefusesValuesOfTheWrongKindOrRange) {
  EXPECT_THAT(fault("[options]\nparticles = 0\n"),
              HasSubstr("--particles: 0 is not in [1, 1000000]"));
  EXPECT_THAT(fault("[options]\nparticles = \"many\"\n"),
              HasSubstr("'many' is not a whole number"));
  EXPECT_THAT(fault("[options]\ntemperature = nan\n"), HasSubstr("temperature"));
  EXPECT_THAT(fault("[options]\nmatch = [1]\n"), HasSubstr("match is not a single value"));
  EXPECT_THAT(fault("preset = 3\n"), HasSubstr("recipe.toml: preset is not a text"));
}

TEST(RunOptions, HaveOneNameEach) {
  std::vector<std::string> names;
  for (const OptionText& option : option_texts(RunOptions{})) {
    EXPECT_THAT(names, testing::Not(testing::Contains(option.name)));
    EXPECT_FALSE(option.help.empty()) << option.name;
    names.push_back(option.name);
  }
  EXPECT_GT(names.size(), 30U);
}

TEST(RunOptions, CanAllBeSetToTheTextThatTheyPrint) {
  const RunOptions defaults = run_preset("thesis").value();
  RunOptions copied;
  for (const OptionText& option : option_texts(defaults)) {
    ASSERT_TRUE(set_option(copied, option.name, option.value).has_value()) << option.name;
  }
  const auto again = option_texts(copied);
  const auto before = option_texts(defaults);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(again[i].value, before[i].value) << before[i].name;
}

}  // namespace run_options_test
}  // namespace nadir
