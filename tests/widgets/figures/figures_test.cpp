// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figures.h"

#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/canvas/png_file.h"
#include "widgets/figures/film.h"

namespace nadir {
namespace figures_test {

using ::testing::HasSubstr;

class Figures : public ::testing::Test {
 protected:
  Figures() { write_street(map()); }

  [[nodiscard]] std::filesystem::path map() const { return scratch_.path() / "map"; }
  std::string drive(const std::string& name, int steps = 30, const RunFaults& faults = {}) {
    const std::filesystem::path path = scratch_.path() / name;
    write_drive(path, map(), steps, faults);
    return path.string();
  }
  /// A recipe for every figure, with as many runs as it takes.
  FigureRecipe recipe(std::string_view figure, const std::vector<std::string>& runs) {
    FigureRecipe made;
    made.figure = figure;
    made.map = map().string();
    const auto kind = figure_kind(figure);
    for (std::size_t i = 0; kind && i < std::min(runs.size(), kind->most_runs); ++i) {
      made.runs.push_back(runs[i]);
    }
    made.options.size.width = 480;
    if (figure == "route") {
      made.route = scratch_
                       .file("route.toml",
                             "name = \"street\"\n[[waypoint]]\neast_m = 10\nnorth_m = 20\n"
                             "[[waypoint]]\neast_m = 50\nnorth_m = 20\n")
                       .string();
    }
    return made;
  }
  static Result<std::string> draw(const FigureRecipe& recipe, PageFile kind) {
    auto figure = make_figure(recipe);
    if (!figure) return forward_error(figure);
    FigureContext context(page_format(recipe.options, figure_kind(recipe.figure)->aspect));
    return draw_file(**figure, context, kind, {"title", recipe_text(recipe)});
  }
  static std::string fault(const FigureRecipe& recipe) {
    const auto drawn = draw(recipe, PageFile::kPng);
    return drawn ? "none" : drawn.error().message;
  }

  ScratchFolder scratch_;
};

TEST_F(Figures, AllDrawTheSameBytesTwiceAsPixelsAndVectors) {
  const std::vector<std::string> runs = {drive("a.nadir"), drive("b.nadir", 25)};
  for (const FigureKind& kind : figure_kinds()) {
    for (const PageFile file : {PageFile::kPng, PageFile::kSvg, PageFile::kPdf}) {
      const auto once = draw(recipe(kind.name, runs), file);
      ASSERT_TRUE(once.has_value()) << kind.name << ": " << once.error().message;
      const auto twice = draw(recipe(kind.name, runs), file);
      EXPECT_EQ(*once, *twice) << kind.name;
    }
  }
}

TEST_F(Figures, CarryTheRecipeThatDrawsThemAgain) {
  FigureRecipe asked = recipe("trajectories", {drive("a.nadir")});
  asked.options.theme = ThemeName::kDark;
  asked.options.time_s = 7.5;
  const auto png = draw(asked, PageFile::kPng);
  ASSERT_TRUE(png);
  const auto texts = parse_png_texts(*png, "figure");
  ASSERT_TRUE(texts);
  const auto again = parse_figure_recipe(texts->at("nadir-recipe"), "figure");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(recipe_text(*again), recipe_text(asked));
  EXPECT_EQ(draw(*again, PageFile::kPng).value(), *png);
}

TEST_F(Figures, ThatNeedTruthSayWhichRunHasNone) {
  const std::string blind = drive("blind.nadir", 10, {.has_truth = false});
  EXPECT_THAT(fault(recipe("flight", {blind})),
              HasSubstr("blind.nadir: has no truth, which figure 'flight' needs"));
  for (const char* figure : {"trajectories", "moment", "error-surface", "reconstruction"}) {
    EXPECT_EQ(fault(recipe(figure, {blind})), "none") << figure;
  }
}

TEST_F(Figures, DoWithoutParticlesAndWithASingleStep) {
  const std::string bare = drive("bare.nadir", 10, {.has_particles = false, .has_topviews = false});
  EXPECT_EQ(fault(recipe("moment", {bare})), "none");
  EXPECT_EQ(fault(recipe("error-surface", {bare})), "none");
  EXPECT_THAT(fault(recipe("reconstruction", {bare})), HasSubstr("holds no topviews"));
  const std::string single = drive("single.nadir", 1);
  for (const FigureKind& kind : figure_kinds()) {
    if (kind.fewest_runs > 1) continue;
    EXPECT_EQ(fault(recipe(kind.name, {single})), "none") << kind.name;
  }
}

TEST_F(Figures, DrawARunFarFromItsMap) {
  const std::string far = drive("far.nadir", 10, {.shift_m = 5000.0});
  for (const FigureKind& kind : figure_kinds()) {
    if (kind.fewest_runs != 1) continue;
    EXPECT_EQ(fault(recipe(kind.name, {far})), "none") << kind.name;
  }
}

TEST_F(Figures, AreRefusedByOneSentence) {
  const std::string run = drive("a.nadir");
  EXPECT_EQ(fault(recipe("trajectory", {run})),
            "'trajectory' is no figure (did you mean trajectories?)");
  EXPECT_EQ(fault(recipe("flight", {})), "figure 'flight' needs a run (--run FILE)");
  FigureRecipe two = recipe("flight", {run});
  two.runs.push_back(run);
  EXPECT_EQ(fault(two), "figure 'flight' shows one run, and 2 are given");
  FigureRecipe lost = recipe("trajectories", {run});
  lost.map = (scratch_.path() / "nowhere").string();
  EXPECT_THAT(fault(lost), HasSubstr("nowhere"));
  FigureRecipe huge = recipe("labels", {});
  huge.options.size.width = 100'000;
  EXPECT_THAT(fault(huge), HasSubstr("--size: a width of 100000 is not in [200, 16000]"));
  FigureRecipe never = recipe("flight", {run});
  never.options.from_s = 500.0;
  EXPECT_THAT(fault(never), HasSubstr("has no step from 500 s to "));
  FigureRecipe tiny = recipe("labels", {});
  tiny.options.crop.width_m = 1e-13;
  EXPECT_EQ(fault(tiny), "--crop: a width of 1e-13 m is not in [0.1, 1e+06]");
  FigureRecipe nothing = recipe("labels", {});
  nothing.map.clear();
  EXPECT_EQ(fault(nothing), "figure 'labels' needs a map (--map FOLDER)");
}

TEST_F(Figures, FindTheMapBesideARunThatWasMoved) {
  const std::string run = drive("a.nadir");
  const std::filesystem::path moved = scratch_.path() / "elsewhere";
  std::filesystem::create_directory(moved);
  std::filesystem::rename(run, moved / "a.nadir");
  std::filesystem::rename(map(), moved / "map");
  FigureRecipe asked = recipe("trajectories", {(moved / "a.nadir").string()});
  asked.map.clear();
  EXPECT_EQ(fault(asked), "none");
  std::filesystem::rename(moved / "map", moved / "other");
  EXPECT_THAT(fault(asked), HasSubstr("is not there; name one with --map"));
}

TEST_F(Figures, PutTheBuildingWhereItsCoordinatesAre) {
  FigureRecipe asked = recipe("labels", {});
  asked.options.size.width = 600;
  auto figure = make_figure(asked);
  ASSERT_TRUE(figure);
  FigureContext context(page_format(asked.options, 1.25));
  const auto pixels = draw_pixels(**figure, context);
  ASSERT_TRUE(pixels);
  // The building of the drawing lies in the north-west: its colour may only be found there.
  const Rgba building = class_colour(kBuilding);
  double sum_column = 0.0;
  double sum_row = 0.0;
  int count = 0;
  for (int row = 60; row < pixels->height();
       ++row) {  // below the legend, which shows the colour too
    for (int column = 0; column < pixels->width(); ++column) {
      if (pixels->at(column, row) != building) continue;
      sum_column += column;
      sum_row += row;
      ++count;
    }
  }
  ASSERT_GT(count, 500);
  EXPECT_LT(sum_column / count, 0.4 * pixels->width());
  EXPECT_LT(sum_row / count, 0.5 * pixels->height());
}

TEST_F(Figures, MakeAFilmOfTheTimesAskedFor) {
  auto figure = make_figure(recipe("trajectories", {drive("a.nadir")}));
  ASSERT_TRUE(figure);
  PageFormat format;
  format.width = 321;
  format.height = 200;
  format.dpi = 72.0;
  FigureContext context(format);
  context.supersampling = 1;
  const std::filesystem::path file = scratch_.path() / "film.mp4";
  const auto film = write_film(**figure, context, {.fps = 10.0, .speed = 5.0}, file, {});
  ASSERT_TRUE(film) << film.error().message;
  EXPECT_EQ(film->frames, 30);  // 14.5 s of flight at half a second a frame, both ends included
  EXPECT_GT(std::filesystem::file_size(file), 1000U);
  auto still = make_figure(recipe("labels", {}));
  ASSERT_TRUE(still);
  const auto refused = write_film(**still, context, {}, scratch_.path() / "none.mp4", {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("has no times"));
  EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "none.mp4"));
  format.is_transparent = true;
  FigureContext clear(format);
  const auto black = write_film(**figure, clear, {}, scratch_.path() / "none.mp4", {});
  ASSERT_FALSE(black);
  EXPECT_THAT(black.error().message, HasSubstr("a film has no transparency"));
}

TEST_F(Figures, StopAFilmWithoutLeavingAPiece) {
  auto figure = make_figure(recipe("trajectories", {drive("a.nadir")}));
  ASSERT_TRUE(figure);
  PageFormat format;
  format.width = 320;
  format.height = 200;
  FigureContext context(format);
  std::stop_source stop;
  const WorkContext work{stop.get_token(), [&stop](double fraction, const std::string&) {
                           if (fraction > 0.3) stop.request_stop();
                         }};
  const auto film =
      write_film(**figure, context, {.fps = 10.0}, scratch_.path() / "film.mp4", work);
  ASSERT_FALSE(film);
  EXPECT_EQ(film.error().code, ErrorCode::kCancelled);
  EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "film.mp4"));
}

}  // namespace figures_test
}  // namespace nadir
