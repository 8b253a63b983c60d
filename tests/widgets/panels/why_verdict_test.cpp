// SPDX-License-Identifier: Apache-2.0
// The verdict of "why here?", and the mark that the timeline has at the same moment.
#include <gtest/gtest.h>

#include <set>

#include "tests/widgets/panels/made_answer.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/why_panel.h"

namespace nadir {
namespace why_verdict_test {

WorstMoment small_error() {
  WorstMoment mark;
  mark.kind = MomentKind::kLargestError;
  mark.words = "1.6 m off, 95 % ellipse 0.9 m";
  mark.is_near_truth = true;
  return mark;
}

TEST(WhyVerdict, EveryOneHasWordsOfItsOwn) {
  std::set<std::string> words;
  for (const auto verdict : {MomentVerdict::kNoEvidence, MomentVerdict::kNoTruth,
                             MomentVerdict::kFound, MomentVerdict::kTruthFitsBetter,
                             MomentVerdict::kMapMisleads, MomentVerdict::kBothFitAlike}) {
    words.insert(verdict_head(verdict).words);
  }
  EXPECT_EQ(words.size(), 6U);
  EXPECT_FALSE(words.contains(""));
}

TEST(WhyVerdict, IsNoBetterThanTheMarkOnTheTimeline) {
  EXPECT_EQ(verdict_head(MomentVerdict::kFound).look, kit::TextLook::kGood);
  WorstMoment mark = small_error();
  const VerdictHead marked = verdict_head(MomentVerdict::kFound, mark);
  EXPECT_EQ(marked.words, "Near the truth, but worth a look");
  EXPECT_EQ(marked.look, kit::TextLook::kWarning) << "as amber as the mark";
  mark.kind = MomentKind::kFound;
  EXPECT_EQ(verdict_head(MomentVerdict::kFound, mark).look, kit::TextLook::kGood);
}

TEST(WhyVerdict, StandsAboveWhatIsMarkedThere) {
  const MadeMoment made;
  WhyModel model;
  model.run_name = "loop";
  model.has_map = model.has_step = model.is_answer_of_now = true;
  model.answer = answer_of(question_of(made));
  WhyState state;
  kit::HeadlessUi screen{ThemeName::kDark, 1.0, {400.0, 1400.0}};
  const auto draw = [&](kit::Ui& ui) { return draw_why_panel(ui, model, state); };
  screen.wait(2, draw);
  EXPECT_FALSE(screen.shows("Marked on the timeline"));
  model.mark = small_error();
  screen.wait(2, draw);
  EXPECT_TRUE(screen.shows("Marked on the timeline: largest error of this stretch: 1.6 m off"))
      << screen.words();
}

}  // namespace why_verdict_test
}  // namespace nadir
