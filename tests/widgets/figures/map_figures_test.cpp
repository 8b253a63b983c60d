// SPDX-License-Identifier: Apache-2.0
// What the figures of a map alone say and draw: overhead-pair, labels, route.
#include <gmock/gmock.h>

#include "core/sim/flight_path.h"
#include "core/sim/route.h"
#include "tests/support/recorded_page.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "tests/widgets/views/drawn_chart.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/map_panel.h"

namespace nadir {
namespace map_figures_test {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

/// A square of 20 m on the street's map.
constexpr const char* kLoop =
    "name = \"loop\"\nclosed = true\ncorner_radius_m = 5\n"
    "[[waypoint]]\neast_m = 10\nnorth_m = 10\nname = \"A\"\n"
    "[[waypoint]]\neast_m = 30\nnorth_m = 10\nname = \"B\"\n"
    "[[waypoint]]\neast_m = 30\nnorth_m = 30\nname = \"C\"\n"
    "[[waypoint]]\neast_m = 10\nnorth_m = 30\nname = \"D\"\n";

class MapFigures : public ::testing::Test {
 protected:
  FigureRecipe recipe(const std::string& figure, const std::string& route = kLoop) {
    FigureRecipe made;
    made.figure = figure;
    made.map = (scratch_.path() / "map").string();
    if (figure == "route") made.route = scratch_.file("loop.toml", route).string();
    made.options.size.width = 800;
    return made;
  }

  RecordedPage drawn(const FigureRecipe& asked) {
    RecordedPage page;
    auto figure = make_figure(asked);
    if (!figure) throw std::runtime_error(figure.error().message);
    context_.set_format(page_format(asked.options, figure_kind(asked.figure)->aspect));
    const auto done = (*figure)->draw(page, context_);
    if (!done) throw std::runtime_error(done.error().message);
    return page;
  }

  static std::string words(const RecordedPage& page) {
    std::string all;
    for (const auto& text : page.texts) all += text.line + "\n";
    return all;
  }

  ScratchFolder scratch_;
  FigureContext context_{PageFormat{}};
};

/// A quarter of the street without labels.
void write_street_with_holes(const std::filesystem::path& folder) {
  std::vector<std::string> rows(40, std::string(60, 'R'));
  for (int row = 0; row < 20; ++row) rows[static_cast<std::size_t>(row)].replace(0, 30, 30, '.');
  const auto written = write_overhead_map(drawn_map(1.0, rows), {"holes", "drawn", "CC0-1.0", ""},
                                          std::nullopt, folder);
  if (!written) throw std::runtime_error(written.error().message);
}

TEST_F(MapFigures, PairOfAMapWithoutAPictureIsOnePanelThatSaysSo) {
  write_street(scratch_.path() / "map", false);
  const RecordedPage page = drawn(recipe("overhead-pair"));
  EXPECT_THAT(page.images, SizeIs(1));
  EXPECT_THAT(words(page), AllOf(HasSubstr("the map has no picture"), Not(HasSubstr("(a)"))));
}

TEST_F(MapFigures, PairOfAMapWithAPictureHasBoth) {
  write_street(scratch_.path() / "map");
  const RecordedPage page = drawn(recipe("overhead-pair"));
  EXPECT_THAT(page.images, SizeIs(2));
  EXPECT_THAT(words(page), AllOf(HasSubstr("(a)"), HasSubstr("(b)"), Not(HasSubstr("no picture"))));
  FigureRecipe without = recipe("overhead-pair");
  without.options.layers.set(FigureLayer::kPicture, false);
  EXPECT_THAT(words(drawn(without)),
              AllOf(HasSubstr("as asked"), Not(HasSubstr("has no picture"))));
}

TEST_F(MapFigures, LabelsNameWhatHasNoClassSoThatSharesAreTheWhole) {
  write_street_with_holes(scratch_.path() / "map");
  const RecordedPage page = drawn(recipe("labels"));
  EXPECT_THAT(words(page), AllOf(HasSubstr("road 75.0 %"), HasSubstr("unclassified 25.0 %")));
  EXPECT_THAT(words(drawn(recipe("overhead-pair"))), HasSubstr("unclassified"));
}

TEST_F(MapFigures, LabelsOfAMapThatIsAllClassifiedNameNothingElse) {
  write_street(scratch_.path() / "map");
  EXPECT_THAT(words(drawn(recipe("labels"))), Not(HasSubstr("unclassified")));
}

TEST_F(MapFigures, LabelsOfAPartSayThatSharesAreOfTheWhole) {
  write_street(scratch_.path() / "map");
  FigureRecipe asked = recipe("labels");
  EXPECT_THAT(words(drawn(asked)), Not(HasSubstr("whole map")));
  asked.options.crop.width_m = 20.0;
  EXPECT_THAT(words(drawn(asked)), HasSubstr("whole map"));
}

TEST_F(MapFigures, RouteIsAsLongAndAsRoundAsItIsFlown) {
  write_street(scratch_.path() / "map");
  const auto path = build_flight_path(parse_route(kLoop, "loop").value());
  ASSERT_TRUE(path);
  ASSERT_LT(path->length_m, 79.0);
  const RecordedPage page = drawn(recipe("route"));
  EXPECT_THAT(words(page), HasSubstr(fmt::format("loop: {:.0f} m", path->length_m)));
  // No line of the way bends by more than a little, and the corner at B is not reached.
  std::size_t longest = 0;
  for (const auto& stroke : page.strokes) {
    if (stroke.style.colour == estimate_look(theme(ThemeName::kLight)).colour) {
      longest = std::max(longest, stroke.points.size());
    }
  }
  EXPECT_GT(longest, 20U);
}

TEST_F(MapFigures, RouteThatTurnsBackIsDrawnStraightAndSaysThatItCannotBeFlown) {
  write_street(scratch_.path() / "map");
  const RecordedPage page =
      drawn(recipe("route",
                   "name = \"back\"\n[[waypoint]]\neast_m = 10\nnorth_m = 20\n"
                   "[[waypoint]]\neast_m = 50\nnorth_m = 20\n"
                   "[[waypoint]]\neast_m = 20\nnorth_m = 20\n"));
  EXPECT_THAT(words(page), AllOf(HasSubstr("back: 70 m"), HasSubstr("cannot be flown")));
}

TEST_F(MapFigures, RouteHasBadgesOnlyOfWaypointsOnThePartShown) {
  write_street(scratch_.path() / "map");
  FigureRecipe asked = recipe("route");
  const RecordedPage whole = drawn(asked);
  for (const char* name : {"A", "B", "C", "D"}) EXPECT_TRUE(whole.has_text(name)) << name;
  asked.options.crop = {12.0, Eigen::Vector2d(20.0, 20.0)};  // where no waypoint is
  const RecordedPage part = drawn(asked);
  for (const auto& text : part.texts) {
    EXPECT_NE(text.line, "A");
    EXPECT_NE(text.line, "C");
  }
}

TEST_F(MapFigures, RouteHasAnArrowInTheMiddleOfWhatIsSeenOfEachPiece) {
  write_street(scratch_.path() / "map");
  const auto arrows_of = [this](const std::string& places) {
    FigureRecipe asked = recipe("route", "name = \"far\"\n" + places);
    asked.options.crop = {16.0, Eigen::Vector2d(30.0, 20.0)};
    RecordingCanvas canvas;
    auto figure = make_figure(asked);
    EXPECT_TRUE(figure.has_value());
    context_.set_format(page_format(asked.options, figure_kind("route")->aspect));
    EXPECT_TRUE((*figure)->draw(canvas, context_).has_value());
    return canvas.fills_in(estimate_look(theme(ThemeName::kLight)).colour);
  };
  // The middle of the piece as a whole, at 15 m, is not on the part around (30, 20).
  const auto seen = arrows_of(
      "[[waypoint]]\neast_m = -5\nnorth_m = 20\n[[waypoint]]\neast_m = 35\nnorth_m = 20\n"
      "[[waypoint]]\neast_m = 65\nnorth_m = 23\n");
  ASSERT_FALSE(seen.empty());
  for (const auto& arrow : seen) {
    ASSERT_THAT(arrow.clips, SizeIs(1));
    for (const Eigen::Vector2d& point : arrow.outline) {
      EXPECT_GT(point.x(), arrow.clips[0].left);
      EXPECT_LT(point.x(), arrow.clips[0].right());
    }
  }
  EXPECT_TRUE(arrows_of("[[waypoint]]\neast_m = 2\nnorth_m = 1\n"
                        "[[waypoint]]\neast_m = 58\nnorth_m = 1\n"
                        "[[waypoint]]\neast_m = 58\nnorth_m = 39\n"
                        "[[waypoint]]\neast_m = 2\nnorth_m = 39\n")
                  .empty());
}

}  // namespace map_figures_test
}  // namespace nadir
