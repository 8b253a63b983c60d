// SPDX-License-Identifier: Apache-2.0
// Figures of runs that do not fit their map, were moved, do not know everything, or reach too far.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/flight/colour_image.h"
#include "tests/support/error_text.h"
#include "tests/support/recorded_page.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/flight_moments.h"
#include "widgets/figures/moment_panels.h"
#include "widgets/figures/reconstruction_side.h"

namespace nadir {
namespace unusual_runs_test {

using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

class UnusualRuns : public ::testing::Test {
 protected:
  UnusualRuns() { write_street(scratch_.path() / "map"); }

  FigureRecipe recipe(std::string_view figure, const RunFaults& faults, int steps = 10) {
    const fs::path run = scratch_.path() / "odd.nadir";
    write_drive(run, scratch_.path() / "map", steps, faults);
    FigureRecipe made;
    made.figure = figure;
    made.map = (scratch_.path() / "map").string();
    made.runs = {run.string()};
    made.options.size.width = 1600;
    return made;
  }
  static Result<RecordedPage> record(const FigureRecipe& recipe) {
    auto figure = make_figure(recipe);
    if (!figure) return forward_error(figure);
    FigureContext context(page_format(recipe.options, figure_kind(recipe.figure)->aspect));
    RecordedPage canvas;
    if (auto drawn = (*figure)->draw(canvas, context); !drawn) return forward_error(drawn);
    return canvas;
  }
  /// All words of the page, or the fault's.
  static std::string words(const FigureRecipe& recipe) {
    const auto canvas = record(recipe);
    if (!canvas) return "refused: " + canvas.error().message;
    std::string all;
    for (const auto& text : canvas->texts) all += text.line + " ";
    return all;
  }

  ScratchFolder scratch_;
};

RunFaults finer() { return {.metres_per_cell = 0.5}; }

TEST_F(UnusualRuns, OnAMapOfAnotherResolutionHaveNoErrorSurface) {
  const auto drawn = record(recipe("error-surface", finer()));
  ASSERT_FALSE(drawn);
  EXPECT_EQ(error_code(drawn), ErrorCode::kMalformed);
  EXPECT_THAT(error_text(drawn),
              HasSubstr("odd.nadir: the topview has cells of 0.5 m and map 'street' of 1 m"));
  EXPECT_THAT(words(recipe("error-surface", {})), Not(HasSubstr("refused")));
}

TEST_F(UnusualRuns, OnAMapOfAnotherResolutionAreNotComparedWithItCellByCell) {
  const std::string why = "the topview has cells of 0.5 m and map 'street' of 1 m";
  const std::string moment = words(recipe("moment", finer()));
  EXPECT_THAT(moment, HasSubstr(why));
  EXPECT_THAT(moment, HasSubstr("road"));  // the topview lies on the map all the same
  EXPECT_THAT(moment, Not(HasSubstr("terrain")));
  EXPECT_THAT(moment, Not(HasSubstr("(e) map")));
  EXPECT_THAT(moment, Not(HasSubstr("share at estimate")));
  const std::string seen = words(recipe("reconstruction", finer()));
  EXPECT_THAT(seen, HasSubstr(why));
  EXPECT_THAT(seen, HasSubstr("road"));
  EXPECT_THAT(seen, Not(HasSubstr("disagreeing [%]")));
  EXPECT_THAT(words(recipe("moment", {})), HasSubstr("(e) map"));
}

TEST_F(UnusualRuns, ThatDoNotKnowTheirSpreadSayNothingOfIt) {
  const std::string blank = words(recipe("moment", {.knows_spread = false}));
  EXPECT_THAT(blank, Not(HasSubstr("nan")));
  EXPECT_THAT(blank, Not(HasSubstr("spread")));
  EXPECT_THAT(blank, Not(HasSubstr("sigma")));
  EXPECT_THAT(blank, HasSubstr("100 particles"));
  const std::string known = words(recipe("moment", {}));
  EXPECT_THAT(known, HasSubstr("spread of the particles 0.63 m"));
  EXPECT_THAT(known, HasSubstr("effective sample size 60 of 100 particles"));
}

TEST_F(UnusualRuns, ThatDoNotKnowTheirSpreadAreShownWithTheTruthAllTheSame) {
  RunStep step = street_step(4, {.knows_spread = false});
  EXPECT_EQ(belief_words(step), fmt::format(", {:.2f} m from the truth · 1 mode · 100 particles",
                                            (step.estimate.moments.mean.translation_m() -
                                             step.truth_in_enu->translation_m())
                                                .norm()));
  step.estimate.moments.mean.x_m = std::nan("");
  EXPECT_EQ(belief_words(step), " · 1 mode · 100 particles");
}

TEST_F(UnusualRuns, ThatWereMovedWithTheirFlightShowItsImagesAtTheirTimesOnly) {
  const FigureRecipe asked = recipe("moment", {});  // says that the flight is at "no/such/flight"
  const auto jpeg = encode_colour_jpeg(ColourRaster(24, 16));
  ASSERT_TRUE(jpeg) << error_text(jpeg);
  scratch_.file("flight/image.jpg", std::string(jpeg->begin(), jpeg->end()));
  EXPECT_THAT(words(asked), HasSubstr("the flight holds no camera images"));
  scratch_.file("flight/rgb.txt", "100.0 image.jpg\n101.5 image.jpg\n");
  const auto has_image = [&asked](double time_s) {
    FigureRecipe at_time = asked;
    at_time.options.time_s = time_s;
    const auto page = record(at_time);
    EXPECT_TRUE(page) << error_text(page);
    const bool is_shown =
        std::any_of(page->images.begin(), page->images.end(),
                    [](const auto& image) { return image.width == 24 && image.height == 16; });
    EXPECT_EQ(page->has_text("no camera image of this moment"), !is_shown) << time_s;
    return is_shown;
  };
  EXPECT_TRUE(has_image(0.0));
  EXPECT_FALSE(has_image(0.5));
  EXPECT_FALSE(has_image(1.0));
  EXPECT_TRUE(has_image(1.5));
  EXPECT_FALSE(has_image(4.5));
  fs::remove_all(scratch_.path() / "flight");
  EXPECT_THAT(words(asked), HasSubstr("no camera image: the flight no/such/flight is not there"));
}

TEST(PoseReach, ChoosesCellsThatALongRunCanBeDrawnIn) {
  PoseReach reach;
  EXPECT_EQ(reconstruction_cell_m(reach, 0.25), 0.25);
  reach.include({0.0, 0.0});
  reach.include({std::nan(""), 5.0});
  reach.include({2000.0, -100.0});
  EXPECT_EQ(reach.span_m(), 2000.0);
  EXPECT_EQ(reach.farthest_m(), 2000.0);
  EXPECT_EQ(reconstruction_cell_m(reach, 0.25), 0.25);
  reach.include({5000.0, 0.0});
  EXPECT_EQ(reconstruction_cell_m(reach, 0.25), 1.0);
  PoseReach far_away;
  far_away.include({-1e8, 3.0});
  EXPECT_EQ(far_away.span_m(), 0.0);
  EXPECT_EQ(reconstruction_cell_m(far_away, 0.25), 0.25);
  EXPECT_EQ(reconstruction_cell_m(far_away, 0.1), 0.2);
}

TEST_F(UnusualRuns, ThatReachFarAreReconstructedInCoarserCells) {
  const std::string jump =
      words(recipe("reconstruction", {.metres_per_cell = 0.1, .jumps_at = 5, .jump_m = 3000.0}));
  EXPECT_THAT(jump, HasSubstr("with most votes per cell of 0.4 m"));
  EXPECT_THAT(jump, Not(HasSubstr("refused")));
  const std::string far =
      words(recipe("reconstruction", {.shift_m = 9.9995e7, .metres_per_cell = 0.1}));
  EXPECT_THAT(far, HasSubstr("with most votes per cell of 0.2 m"));
  const std::string both =
      words(recipe("reconstruction", {.metres_per_cell = 0.1, .jumps_at = 5, .jump_m = 9.9e7}));
  EXPECT_THAT(both, Not(HasSubstr("refused")));
  EXPECT_THAT(words(recipe("reconstruction", {})), HasSubstr("with most votes per cell · "));
}

TEST_F(UnusualRuns, WhoseTopviewsReachTooFarAreRefusedByName) {
  auto panel = MapPanel::create(scratch_.path() / "map", MapPanel::Ground::kLabels, {});
  ASSERT_TRUE(panel) << error_text(panel);
  const OverheadMap street = read_overhead_map(scratch_.path() / "map").value();
  ReconstructionSide side(std::move(*panel), Source::kEstimate, 0.1);
  ASSERT_TRUE(side.add(street_step(0, {.metres_per_cell = 0.1}), street));
  const auto far = side.add(street_step(1, {.shift_m = 5000.0, .metres_per_cell = 0.1}), street);
  EXPECT_EQ(error_code(far), ErrorCode::kUnsupported);
  EXPECT_THAT(error_text(far), HasSubstr("too far to be drawn in cells of 0.1 m"));
  EXPECT_EQ(error_code(side.add(street_step(1, {.metres_per_cell = 1e6}), street)),
            ErrorCode::kUnsupported);
  EXPECT_TRUE(side.add(street_step(2, {.metres_per_cell = 0.1}), street));
  EXPECT_TRUE(side.refresh());
}

}  // namespace unusual_runs_test
}  // namespace nadir
