// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/why_panel.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "tests/widgets/panels/made_answer.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/surface_picture.h"

namespace nadir {
namespace why_panel_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

WhyModel model_of(const std::shared_ptr<const MomentAnswer>& answer) {
  WhyModel model;
  model.run_name = "loop";
  model.has_map = true;
  model.has_step = true;
  model.answer = answer;
  model.is_answer_of_now = true;
  return model;
}

class WhyPanelTest : public ::testing::Test {
 protected:
  auto drawing() {
    return [this](kit::Ui& ui) { return draw_why_panel(ui, model, state); };
  }
  MadeMoment made;
  WhyModel model = model_of(answer_of(question_of(made)));
  WhyState state;
  kit::HeadlessUi screen{ThemeName::kDark, 1.0, {400.0, 1400.0}};
};

TEST_F(WhyPanelTest, SaysThatTheTruthWouldHaveFittedBetter) {
  // What was seen is what the map has at the truth, so nothing fits better.
  ASSERT_EQ(model.answer->explanation->verdict, MomentVerdict::kTruthFitsBetter);
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows("Missed: the truth fits better"));
  EXPECT_TRUE(screen.shows(model.answer->words)) << screen.words();
  EXPECT_EQ(screen.at("Why/Mean cost/Costs/truth/mean cost").value, "0.0000");
  EXPECT_EQ(screen.at("Why/Mean cost/Costs/truth/fits").value, "100 %");
}

TEST_F(WhyPanelTest, ShowsTheSurfaceWithItsCosts) {
  screen.wait(2, drawing());
  ASSERT_TRUE(model.answer->surface);
  EXPECT_TRUE(screen.has("Why/Error surface and topview/Surface"));
  EXPECT_TRUE(screen.has("Why/Heading/Turn"));
  EXPECT_EQ(screen.at("Why/Heading/cost at the truth").value, "0.0000");
  const auto first = state.surface.pixels;
  screen.wait(1, drawing());
  EXPECT_EQ(state.surface.pixels, first);  // made once
  screen.click("Why/Error surface and topview/##Cut", drawing());
  screen.click("Why/Error surface and topview/##Cut/best heading", drawing());
  screen.wait(1, drawing());
  EXPECT_TRUE(state.shows_best_turn);
  EXPECT_NE(state.surface.pixels, first);
}

TEST_F(WhyPanelTest, HasSentencePicturesAndFirstBarsInSightOfASmallWindow) {
  // A window of 1280 x 800 leaves the panel 356 x 480.
  kit::HeadlessUi small(ThemeName::kDark, 1.0, {380.0, 504.0});
  small.wait(3, [this](kit::Ui& ui) {
    const auto content = ui.scroll_area("Content");
    return draw_why_panel(ui, model, state);
  });
  const auto bottom_of = [&](const std::string& path) { return small.at(path).rect.bottom(); };
  const kit::Rect surface = small.at("Why/Error surface and topview/Surface").rect;
  const kit::Rect patch = small.at("Why/Error surface and topview/Patch").rect;
  EXPECT_LE(small.at("Why/" + model.answer->words).rect.bottom(), surface.top);
  EXPECT_EQ(surface.top, patch.top);
  EXPECT_EQ(surface.height, patch.height);
  EXPECT_GT(patch.left, surface.right());
  EXPECT_LT(patch.right(), 380.0);
  EXPECT_GT(bottom_of("Why/Agreement by class/Agreement"), surface.bottom());
  EXPECT_LT(bottom_of("Why/Agreement by class/Agreement/road"), 492.0);
}

TEST_F(WhyPanelTest, ShowsThePictureThatIsChosen) {
  screen.wait(2, drawing());
  const std::string combo = "Why/Error surface and topview/##Patch";
  EXPECT_EQ(screen.at(combo).value, "fits the map");
  screen.click(combo, drawing());
  screen.click(combo + "/map at truth", drawing());
  screen.wait(1, drawing());
  EXPECT_EQ(screen.at(combo).value, "map at truth");
  screen.hover("Why/Error surface and topview/Patch", drawing());
  EXPECT_THAT(screen.tooltip(), HasSubstr("map at the truth"));
}

TEST_F(WhyPanelTest, AFoldedSectionStaysFoldedWhileAnotherPanelShows) {
  screen.wait(2, drawing());
  screen.click("Why/Agreement by class", drawing());
  screen.wait(1, drawing());
  EXPECT_EQ(screen.at("Why/Agreement by class").value, "closed");
  screen.wait(120, [](kit::Ui& ui) { ui.text("another panel"); });
  screen.wait(2, drawing());
  EXPECT_EQ(screen.at("Why/Agreement by class").value, "closed");
  EXPECT_FALSE(screen.has("Why/Agreement by class/Agreement"));
  EXPECT_EQ(screen.at("Why/Cost by class").value, "open");
}

TEST_F(WhyPanelTest, SaysAtWhichPoseEachClassIsCheaperAndByHowMuch) {
  screen.wait(2, drawing());
  const MomentExplanation& moment = *model.answer->explanation;
  const std::string table = "Why/Cost by class/Cost by class/";
  EXPECT_TRUE(screen.shows("lower is better"));
  double sum = 0.0;
  for (const ClassDifference& difference : moment.by_class) {
    const std::string row = table + std::string(class_info(difference.id).name);
    sum += difference.cost_difference;
    if (std::abs(difference.cost_difference) < 5e-5) {
      EXPECT_EQ(screen.at(row + "/cheaper at").value, "neither");
      continue;
    }
    EXPECT_EQ(screen.at(row + "/cheaper at").value,
              difference.cost_difference < 0.0 ? "truth" : "estimate");
    EXPECT_EQ(screen.at(row + "/by").value,
              fmt::format("{:.4f}", std::abs(difference.cost_difference)));
  }
  EXPECT_EQ(screen.at(table + "all/cheaper at").value, "truth") << "nothing fits better";
  EXPECT_EQ(screen.at(table + "all/by").value, fmt::format("{:.4f}", std::abs(sum)));
}

TEST_F(WhyPanelTest, AClickOnTheSurfaceShowsThatPlaceOnTheMap) {
  screen.wait(2, drawing());
  const kit::Rect area = screen.at("Why/Error surface and topview/Surface").rect;
  const ErrorSurfaceGrid& grid = model.answer->surface->volume.grid;
  const Actions asked = screen.click_at("Why/Error surface and topview/Surface",
                                        area.width / 2.0 + 10.0 * area.width / grid.count_x,
                                        area.height / 2.0, drawing());
  ASSERT_EQ(asked.size(), 1U);
  const auto& look = std::get<actions::LookAt>(asked[0]);
  const Rigid2& estimate = made.step->estimate.moments.mean;
  EXPECT_NEAR(look.east_m, estimate.x_m + 10.0 * grid.step_m, 1e-6);
  EXPECT_NEAR(look.north_m, estimate.y_m, 1e-6);
}

TEST_F(WhyPanelTest, EveryPixelOfTheSurfaceIsThePlaceThatItShows) {
  screen.wait(2, drawing());
  const std::string path = "Why/Error surface and topview/Surface";
  const kit::Rect area = screen.at(path).rect;
  const ErrorSurfaceGrid& grid = model.answer->surface->volume.grid;
  const Rigid2& estimate = made.step->estimate.moments.mean;
  const int side = static_cast<int>(area.width);
  const auto sample = [&](int pixel, int count) {  // at the middle of the pixel
    return (2 * pixel + 1) * count / (2 * side);
  };
  for (const int pixel : {0, 1, 2, 3, 4, 60, 74, 75, 76, 100, side - 3, side - 2, side - 1}) {
    SCOPED_TRACE(pixel);
    const Actions asked = screen.click_at(path, pixel, pixel, drawing());
    ASSERT_EQ(asked.size(), 1U);
    const auto& look = std::get<actions::LookAt>(asked[0]);
    const int east = sample(pixel, grid.count_x) - grid.count_x / 2;
    const int south = sample(pixel, grid.count_y) - grid.count_y / 2;
    EXPECT_NEAR(look.east_m, estimate.x_m + east * grid.step_m, 1e-9);
    EXPECT_NEAR(look.north_m, estimate.y_m - south * grid.step_m, 1e-9);
  }
}

TEST_F(WhyPanelTest, SaysHowWellThePlaceIsHeldAndKeepsConsistencyForItsOwnSection) {
  screen.wait(2, drawing());
  ASSERT_THAT(model.answer->hold_words, HasSubstr("The place is not held: the cost falls by 0.50 "
                                                  "towards a place 3.0 m south of it."));
  EXPECT_TRUE(screen.shows(model.answer->hold_words)) << screen.words();
  ASSERT_THAT(model.answer->surety, HasSubstr("NEES"));
  EXPECT_TRUE(screen.has("Why/Consistency/" + model.answer->surety));
  MomentQuestion question = question_of(made);
  question.with_surface = false;
  EXPECT_EQ(answer_of(question)->hold_words, "") << "nobody knows without a surface";
}

TEST_F(WhyPanelTest, EachModeCanBeLookedAt) {
  RunStep step = *made.step;
  PoseMode near{0.7, step.estimate.moments};
  PoseMode far = near;
  far.mass = 0.3;
  far.moments.mean.x_m += 6.0;
  step.estimate.modes = {near, far};
  MomentQuestion question = question_of(made);
  question.step = std::make_shared<const RunStep>(step);
  question.with_surface = false;
  model = model_of(answer_of(question));
  screen.wait(2, drawing());
  EXPECT_EQ(screen.at("Why/Modes/Modes/1/mass").value, "70 %");
  EXPECT_EQ(screen.at("Why/Modes/Modes/1/from truth").value, "3.00");
  const Actions asked = screen.click("Why/Modes/Modes/2/Look", drawing());
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_DOUBLE_EQ(std::get<actions::LookAt>(asked[0]).east_m, far.moments.mean.x_m);
}

TEST_F(WhyPanelTest, SaysWhatItWaitsForAndWhatIsMissing) {
  model.answer = nullptr;
  model.is_computing = true;
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows("Computing"));
  model.has_map = false;
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows("No map is open"));
  model = {};
  EXPECT_THAT(screen.click("Why/Open the demo", drawing()),
              ElementsAre(Action(actions::OpenDemo{})));
}

TEST_F(WhyPanelTest, WhileARunPlaysItSaysToPauseForTheSurface) {
  MomentQuestion question = question_of(made);
  question.with_surface = false;
  model = model_of(answer_of(question));
  model.is_playing = true;
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows("Pause to see the error surface."));
}

TEST_F(WhyPanelTest, AStepWithoutTopviewIsExplainedInItsOwnSentence) {
  RunStep step = *made.step;
  step.topview.reset();
  MomentQuestion question = question_of(made);
  question.step = std::make_shared<const RunStep>(step);
  model = model_of(answer_of(question));
  EXPECT_FALSE(model.answer->explanation);
  screen.wait(2, drawing());
  EXPECT_TRUE(screen.shows(model.answer->error)) << screen.words();
}

TEST(MomentInquiry, AnswersAsTheCallerWouldOnItsOwnThread) {
  const MadeMoment made;
  const MomentQuestion question = question_of(made);
  MomentInquiry inquiry;
  EXPECT_EQ(inquiry.answer(), nullptr);
  inquiry.ask(question);
  inquiry.ask(question);
  while (inquiry.is_working()) std::this_thread::yield();
  const auto answer = inquiry.answer();
  ASSERT_TRUE(answer);
  const auto expected = answer_of(question);
  EXPECT_EQ(answer->step, made.step);
  EXPECT_EQ(answer->words, expected->words);
  ASSERT_TRUE(answer->surface);
  EXPECT_EQ(answer->surface->plane, expected->surface->plane);
}

TEST(MomentInquiry, OfManyQuestionsTheLastIsAnswered) {
  const MadeMoment made;
  MomentInquiry inquiry;
  std::shared_ptr<const RunStep> last;
  for (std::size_t i = 0; i < 12; ++i) {
    MomentQuestion question = question_of(made);
    question.step = last = made.decoded(i);
    inquiry.ask(question);
  }
  while (inquiry.is_working()) std::this_thread::yield();
  EXPECT_EQ(inquiry.answer()->step, last);
  EXPECT_TRUE(inquiry.answer()->surface);
}

TEST(MomentInquiry, CanBeLeftWhileItWorks) {
  const MadeMoment made;
  const auto inquiry = std::make_unique<MomentInquiry>();
  inquiry->ask(question_of(made));
}

TEST(MomentInquiry, TakesTheOptionsThatTheRunWasMadeWith) {
  RunHeader header;
  header.options = {{"temperature", "0.5"}, {"particles", "77"}, {"an-option-of-tomorrow", "3"}};
  const RunOptions options = options_of(header);
  EXPECT_DOUBLE_EQ(options.localiser.temperature, 0.5);
  EXPECT_EQ(options.localiser.particle_count, 77);
  EXPECT_EQ(options.topview.min_votes, RunOptions{}.topview.min_votes);
}

TEST_F(WhyPanelTest, TheWheelOverTheErrorSurfaceScrollsThePanel) {
  kit::HeadlessUi low(ThemeName::kDark, 1.0, {400.0, 500.0});
  low.wait(3, drawing());
  // Down over the first, and up again over the second, which lies at the panel's end.
  for (const auto& [picture, notches] : {std::pair("Why/Error surface and topview/Surface", -2.0),
                                         std::pair("Why/Heading/Turn", 2.0)}) {
    low.hover(picture, drawing());
    const double before = low.at(picture).rect.top;
    low.scroll(picture, notches, drawing());
    low.wait(2, drawing());
    EXPECT_GT((low.at(picture).rect.top - before) * notches, 20.0) << picture;
  }
}

}  // namespace why_panel_test
}  // namespace nadir
