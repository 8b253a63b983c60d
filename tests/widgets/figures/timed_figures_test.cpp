// SPDX-License-Identifier: Apache-2.0
// Figures that show a moment: stills, frames of films, and the words around them.
#include <gmock/gmock.h>

#include "tests/support/recorded_page.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/run_lines.h"

namespace nadir {
namespace timed_figures_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kMiddleS = 7.5;

class TimedFigures : public ::testing::Test {
 protected:
  TimedFigures() { write_street(scratch_.path() / "map"); }

  std::string drive(const std::string& name, int steps = 30, const RunFaults& faults = {}) {
    const std::filesystem::path path = scratch_.path() / name;
    std::filesystem::create_directories(path.parent_path());
    write_drive(path, scratch_.path() / "map", steps, faults);
    return path.string();
  }
  FigureRecipe recipe(std::string_view figure, const std::vector<std::string>& runs) {
    FigureRecipe made;
    made.figure = figure;
    made.map = (scratch_.path() / "map").string();
    made.runs = runs;
    made.options.size.width = 480;
    return made;
  }
  static std::unique_ptr<Figure> make(const FigureRecipe& recipe) {
    auto made = make_figure(recipe);
    if (!made) throw std::runtime_error(made.error().message);
    return std::move(*made);
  }
  static Raster<Rgba> pixels(Figure& figure, const FigureRecipe& recipe) {
    FigureContext context(page_format(recipe.options, figure_kind(recipe.figure)->aspect));
    return draw_pixels(figure, context).value();
  }
  static RecordedPage record(const FigureRecipe& recipe) {
    FigureContext context(page_format(recipe.options, figure_kind(recipe.figure)->aspect));
    RecordedPage canvas;
    EXPECT_TRUE(make(recipe)->draw(canvas, context).has_value());
    return canvas;
  }
  static std::vector<std::string> lines(const RecordedPage& canvas) {
    std::vector<std::string> found;
    for (const auto& text : canvas.texts) found.push_back(text.line);
    return found;
  }
  /// All lines in one, so that a line break hides nothing.
  static std::string words(const RecordedPage& canvas) {
    std::string all;
    for (const auto& text : canvas.texts) all += text.line + " ";
    return all;
  }

  ScratchFolder scratch_;
};

TEST_F(TimedFigures, ShowInAStillWhatTheFilmShowsAtThatTime) {
  const std::vector<std::string> runs = {drive("a.nadir"), drive("b.nadir", 25)};
  for (const FigureKind& kind : figure_kinds()) {
    if (kind.fewest_runs == 0) continue;
    FigureRecipe asked = recipe(kind.name, runs);
    asked.runs.resize(std::min(asked.runs.size(), kind.most_runs));
    const auto film = make(asked);
    if (!film->times()) continue;
    const auto end = pixels(*film, asked);
    FigureRecipe at_middle = asked;
    at_middle.options.time_s = kMiddleS;
    const auto still = make(at_middle);
    const auto middle = pixels(*still, at_middle);
    EXPECT_NE(middle, end) << kind.name;
    film->show_at(2.0);
    EXPECT_NE(pixels(*film, asked), middle) << kind.name;
    film->show_at(kMiddleS);
    EXPECT_EQ(pixels(*film, asked), middle) << kind.name;
    film->show_at(11.0);
    static_cast<void>(pixels(*film, asked));
    film->show_at(kMiddleS);  // backwards
    EXPECT_EQ(pixels(*film, asked), middle) << kind.name;
  }
}

TEST_F(TimedFigures, MarkTheMomentInChartsOnlyWhileTheRunLasts) {
  FigureRecipe asked = recipe("flight", {drive("a.nadir")});
  const auto long_uprights = [&asked] {
    const RecordedPage page = record(asked);
    return std::count_if(page.strokes.begin(), page.strokes.end(),
                         [](const RecordedPage::Stroke& stroke) {
                           return stroke.points.size() == 2 && stroke.style.colour.alpha > 0 &&
                                  stroke.points[0].x() == stroke.points[1].x() &&
                                  std::abs(stroke.points[0].y() - stroke.points[1].y()) > 12.0;
                         });
  };
  const auto of_all = long_uprights();
  asked.options.time_s = kMiddleS;
  EXPECT_EQ(long_uprights(), of_all + 4);  // one in each chart
  asked.options.time_s = 1000.0;
  EXPECT_EQ(long_uprights(), of_all);
}

TEST_F(TimedFigures, SpeakOfEllipsesOnlyWhereTheyAreDrawn) {
  for (const char* figure : {"trajectories", "flight"}) {
    FigureRecipe asked = recipe(figure, {drive("a.nadir")});
    EXPECT_THAT(lines(record(asked)), Contains("ellipses: 1 and 3 sigma")) << figure;
    asked.options.ellipse_every_s = 0.0;
    EXPECT_THAT(words(record(asked)), Not(HasSubstr("1 and 3 sigma"))) << figure;
  }
}

TEST_F(TimedFigures, NameOnlyLayersThatAreShown) {
  FigureRecipe asked = recipe("moment", {drive("a.nadir")});
  asked.options.size.width = 1600;
  const std::vector<std::string> all = lines(record(asked));
  for (const char* name : {"truth", "odometry (input)", "estimate", "particles, light is heavy"}) {
    EXPECT_THAT(all, Contains(name));
  }
  asked.options.layers = FigureLayers::from_text("picture").value();
  const std::vector<std::string> bare = lines(record(asked));
  for (const char* name : {"truth", "odometry (input)", "estimate", "particles, light is heavy"}) {
    EXPECT_THAT(bare, Not(Contains(name)));
  }
}

TEST_F(TimedFigures, SayWhoseTruthIsDrawnWhereThereAreSeveralRuns) {
  const RecordedPage canvas =
      record(recipe("trajectories", {drive("a.nadir"), drive("b.nadir", 25)}));
  EXPECT_THAT(lines(canvas), Contains("truth of a"));
  EXPECT_THAT(lines(canvas), Contains("odometry (input) of a"));
  EXPECT_THAT(lines(canvas), Contains("b"));
}

TEST_F(TimedFigures, TellRunsOfOneNameApart) {
  const RecordedPage canvas =
      record(recipe("trajectories", {drive("one/run.nadir"), drive("two/run.nadir", 25)}));
  EXPECT_THAT(lines(canvas), Contains("one/run"));
  EXPECT_THAT(lines(canvas), Contains("two/run"));
  std::vector<FigureRun> runs(3);
  for (FigureRun& run : runs) run.name = "run";
  runs[0].path = "x/run.nadir";
  runs[1].path = "y/run.nadir";
  runs[2].path = "z/x/run.nadir";
  name_apart(runs);
  EXPECT_EQ(runs[0].name, "x/run");
  EXPECT_EQ(runs[1].name, "y/run");
  EXPECT_EQ(runs[2].name, "x/run (2)");
}

TEST_F(TimedFigures, MomentNamesOnlyWhatItDraws) {
  FigureRecipe asked = recipe("moment", {drive("a.nadir")});
  asked.options.size.width = 1600;
  const RecordedPage full = record(asked);
  for (const char* name : {"road", "curb", "share at estimate", "at truth"}) {
    EXPECT_THAT(lines(full), Contains(name));
  }
  EXPECT_THAT(words(full), HasSubstr("1 mode"));
  EXPECT_THAT(words(full), Not(HasSubstr("1 modes")));
  EXPECT_THAT(words(full), HasSubstr("spread of the particles"));
  FigureRecipe bare = recipe("moment", {drive("bare.nadir", 10, {.has_topviews = false})});
  bare.options.size.width = 1600;
  const RecordedPage less = record(bare);
  for (const char* name : {"road", "share at estimate", "at truth"}) {
    EXPECT_THAT(lines(less), Not(Contains(name)));
  }
}

TEST_F(TimedFigures, ErrorSurfaceNamesParticlesWhereTheyAreDrawn) {
  FigureRecipe asked = recipe("error-surface", {drive("a.nadir")});
  asked.options.size.width = 1600;
  EXPECT_TRUE(record(asked).has_text("particles, light is heavy"));
  asked.options.layers.set(FigureLayer::kParticles, false);
  EXPECT_FALSE(record(asked).has_text("particles, light is heavy"));
}

TEST_F(TimedFigures, ReconstructionCountsTopviewsAndShowsTruthWhereThereIsOne) {
  FigureRecipe asked = recipe("reconstruction", {drive("a.nadir")});
  asked.options.size.width = 1600;
  asked.options.time_s = 4.5;
  const RecordedPage canvas = record(asked);
  EXPECT_THAT(words(canvas), HasSubstr("10 topviews,"));
  EXPECT_TRUE(canvas.has_text("(c) topviews by truth"));
  EXPECT_TRUE(canvas.has_text("(d) cells that disagree with the map"));
  EXPECT_THAT(lines(canvas), Contains("road"));
  asked.options.time_s = 0.0;
  EXPECT_THAT(words(record(asked)), HasSubstr("1 topview,"));
  FigureRecipe blind = recipe("reconstruction", {drive("b.nadir", 10, {.has_truth = false})});
  EXPECT_FALSE(record(blind).has_text("topviews by truth"));
}

TEST_F(TimedFigures, RenderAMapThatStandsStillOnce) {
  for (const char* name : {"trajectories", "flight", "moment"}) {
    FigureRecipe asked = recipe(name, {drive("a.nadir")});
    const auto figure = make(asked);
    FigureContext context(page_format(asked.options, figure_kind(name)->aspect));
    const auto ground = [&](double time_s) {
      figure->show_at(time_s);
      RecordedPage canvas;
      EXPECT_TRUE(figure->draw(canvas, context).has_value());
      return canvas.images.at(0).pixels;
    };
    const Rgba* const first = ground(3.0);
    EXPECT_EQ(ground(3.1), first) << name;  // the same step
    const bool moves_along = asked.figure == "moment";
    EXPECT_EQ(ground(9.0) != first, moves_along) << name;
  }
}

}  // namespace timed_figures_test
}  // namespace nadir
