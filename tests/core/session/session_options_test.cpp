// SPDX-License-Identifier: Apache-2.0
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_options_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

class SessionOptionsTest : public SessionTest {
 protected:
  [[nodiscard]] const RunDraft& draft() const { return session_->view().draft; }
};

TEST_F(SessionOptionsTest, SetsOptionsByTheirNamesAndForgetsThoseThatAreThePresets) {
  act("option particles 500");
  act("option match class");
  EXPECT_THAT(draft().changed, ElementsAre(Pair("match", "class"), Pair("particles", "500")));
  EXPECT_EQ(session_->draft_options()->localiser.particle_count, 500);
  EXPECT_EQ(session_->draft_options()->localiser.match, MatchKind::kClass);
  act("option particles 10000");
  EXPECT_THAT(draft().changed, ElementsAre(Pair("match", "class"))) << "as the preset has it";
  act("option match");
  EXPECT_THAT(draft().changed, IsEmpty());
}

TEST_F(SessionOptionsTest, RefusesOptionsInWordsWithoutDashes) {
  EXPECT_EQ(refused("option particles 0"), "particles: 0 is not in [1, 1000000]");
  EXPECT_THAT(refused("option particles many"), HasSubstr("particles: "));
  EXPECT_EQ(refused("option particels 5"), "particels: no such option (did you mean particles?)");
  EXPECT_EQ(refused("option particels"), "particels: no such option (did you mean particles?)");
}

TEST_F(SessionOptionsTest, TakesPresetsByNameFileOrRun) {
  act("option particles 500");
  act("preset thesis");
  EXPECT_EQ(draft(), (RunDraft{"thesis", {}}));
  EXPECT_THAT(refused("preset thesi"), HasSubstr("did you mean thesis?"));
  EXPECT_THAT(refused("preset /no/such.toml"), HasSubstr("/no/such.toml: does not exist"));
  EXPECT_THAT(refused("preset run"), HasSubstr("no run is open"));
  open_run();
  EXPECT_EQ(session_->draft_options()->localiser.particle_count,
            run_preset("thesis")->localiser.particle_count);
  act("preset run");
  EXPECT_EQ(draft(), RunDraft());
  EXPECT_EQ(session_->draft_options()->localiser.particle_count, 300);
  EXPECT_EQ(session_->draft_options()->localiser.max_cells_per_class, 50);
}

TEST_F(SessionOptionsTest, TakesTheActiveRunsOwnOptionsUnlessToldOtherwise) {
  const auto text_of = [](const RunOptions& options) {
    std::string text;
    for (const OptionText& option : option_texts(options))
      text += option.name + option.value + "\n";
    return text;
  };
  EXPECT_EQ(text_of(*session_->draft_options()), text_of(RunOptions())) << "without a run";
  open_run();
  EXPECT_EQ(text_of(*session_->draft_options()), text_of(few_particles()));
  EXPECT_EQ(text_of(*session_->draft_base()), text_of(few_particles()));
  act("option particles 500");
  act("option seed 7");
  EXPECT_EQ(session_->draft_base()->localiser.particle_count, 300);
  act("option particles 300");
  EXPECT_THAT(draft().changed, ElementsAre(Pair("seed", "7"))) << "300 is the run's own";
  act("rerun start");
  EXPECT_EQ(session_->draft_base()->localiser.seed, 7U) << "of the run that has just begun";
  settle();
  EXPECT_EQ(document().header.seed, 7U);
  EXPECT_EQ(document().header.options.at("particles"), "300");
  EXPECT_EQ(document().header.options.at("max-cells"), "50");
  const fs::path file = scratch_.path() / "as-the-run.toml";
  act("save-preset " + file.string());
  const auto recipe = read_run_recipe(file);
  ASSERT_TRUE(recipe) << error_text(recipe);
  EXPECT_EQ(text_of(recipe->options), text_of(*session_->draft_options()));
}

TEST_F(SessionOptionsTest, TakesOptionsWhileTheRunIsStillBeingRead) {
  act("open " + run_.string());
  act("option particles 400");
  EXPECT_THAT(session_->draft_options().error().message, HasSubstr("is still being read"));
  EXPECT_EQ(refused("option particles 0"), "particles: 0 is not in [1, 1000000]");
  settle();
  EXPECT_EQ(session_->draft_options()->localiser.particle_count, 400);
  EXPECT_EQ(session_->draft_options()->localiser.max_cells_per_class, 50);
}

TEST_F(SessionOptionsTest, WritesRecipesThatLocaliseTakes) {
  act("preset thesis");
  act("option particles 500");
  act("option match distance");
  act("option adapt-particles true");
  const RunOptions expected = *session_->draft_options();
  const fs::path file = scratch_.path() / "mine.toml";
  act("save-preset " + file.string());
  const auto recipe = read_run_recipe(file);
  ASSERT_TRUE(recipe) << error_text(recipe);
  EXPECT_EQ(recipe->preset, "thesis");
  const auto text_of = [](const RunOptions& options) {
    std::string text;
    for (const OptionText& option : option_texts(options))
      text += option.name + option.value + "\n";
    return text;
  };
  EXPECT_EQ(text_of(recipe->options), text_of(expected));
  act("preset default");
  act("preset " + file.string());
  EXPECT_EQ(text_of(*session_->draft_options()), text_of(expected));
  EXPECT_THAT(refused("save-preset /no/such/folder/x.toml"), HasSubstr("/no/such/folder"));
}

}  // namespace session_options_test
}  // namespace nadir
