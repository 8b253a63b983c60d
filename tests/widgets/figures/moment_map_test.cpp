// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/moment_map.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/map/overhead_map_file.h"
#include "tests/support/error_text.h"
#include "tests/support/page_pixels.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "tests/widgets/figures/seen_page.h"
#include "widgets/figures/figures.h"
#include "widgets/views/map_colours.h"

namespace nadir {
namespace moment_map_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr double kPi = std::numbers::pi;
constexpr Rgba kOrange{0xFF, 0x88, 0x00};
constexpr double kMomentS = 7.5;  ///< Step 15, at 25 m east; the odometry is 1.5 m north of it.
const Eigen::Vector2d kHouse(11.0, 33.5);

const Theme& light() { return theme(ThemeName::kLight); }

/// 60 m of the street around its middle.
class MomentMaps : public ::testing::Test {
 protected:
  MomentMaps() {
    write_street(scratch_.path() / "map");
    write_drive(scratch_.path() / "a.nadir", scratch_.path() / "map", 30);
    recipe_.figure = "moment";
    recipe_.map = (scratch_.path() / "map").string();
    recipe_.runs = {(scratch_.path() / "a.nadir").string()};
    recipe_.options.size.width = 1000;
    recipe_.options.time_s = kMomentS;
    recipe_.options.crop = {60.0, kCentre};
  }
  [[nodiscard]] std::unique_ptr<Figure> made(const std::string& stack,
                                             const std::string& up = "north") {
    recipe_.options.stack = MapStack::from_text(stack).value();
    recipe_.options.up = MapUpward::from_text(up).value();
    auto figure = make_figure(recipe_);
    if (!figure) throw std::runtime_error(figure.error().message);
    return std::move(*figure);
  }
  [[nodiscard]] PageFormat format() const {
    return page_format(recipe_.options, figure_kind("moment")->aspect);
  }
  SeenPage drawn(const std::string& stack, const std::string& up = "north") {
    FigureContext context(format());
    SeenPage page;
    EXPECT_TRUE(made(stack, up)->draw(page, context).has_value());
    return page;
  }
  /// As the window would look there. @param picture  The ground.
  static MapFrame frame_of(const SeenPage& page, double up_rad, std::size_t picture = 0) {
    const PageRect& where = page.images.at(picture).where;
    return {where, {kCentre, 60.0 / where.width, up_rad}, 1.0};
  }
  static Rgba seen_at(const SeenPage& page, double up_rad, const Eigen::Vector2d& place) {
    return page.colour_at(0, frame_of(page, up_rad).page(place));
  }

  inline static const Eigen::Vector2d kCentre{30.0, 20.0};
  ScratchFolder scratch_;
  FigureRecipe recipe_;
};

TEST_F(MomentMaps, AreTurnedWithAllThatLiesOnThem) {
  const SeenPage north = drawn("labels,truth");
  EXPECT_EQ(seen_at(north, kPi / 2.0, kHouse), class_colour(kBuilding));
  // East is up: the building, in the north-west, is now at the lower left, and the drive east goes up.
  const SeenPage east = drawn("labels,truth", "90");
  const MapFrame frame = frame_of(east, 0.0);
  const Eigen::Vector2d on_page = frame.page(kHouse) - frame.where.centre();
  EXPECT_LT(on_page.x(), 0.0);
  EXPECT_LT(on_page.y(), 0.0);
  EXPECT_EQ(seen_at(east, 0.0, kHouse), class_colour(kBuilding));
  EXPECT_EQ(seen_at(east, 0.0, {30.0, 20.0}), class_colour(kRoad));
  EXPECT_EQ(seen_at(east, 0.0, {30.0, 30.0}), class_colour(kTerrain));
  const auto line = east.line_in(light().truth_on_imagery);
  ASSERT_GE(line.size(), 2U);
  EXPECT_LT((line.front() - frame.page({10.0, 20.0})).norm(), 1e-6);
  EXPECT_LT((line.back() - frame.page({25.0, 20.0})).norm(), 1e-6);
  EXPECT_NEAR(line.back().x(), line.front().x(), 1e-6);
  EXPECT_GT(line.back().y(), line.front().y());
}

TEST_F(MomentMaps, FollowTheHeadingOfTheirMoment) {
  const SeenPage page = drawn("labels,estimate", "heading");
  EXPECT_EQ(seen_at(page, 0.01, kHouse), class_colour(kBuilding));
  const auto line = page.line_in(light().estimate_on_imagery);
  ASSERT_GE(line.size(), 2U);
  EXPECT_GT(line.back().y() - line.front().y(),
            10.0 * std::abs(line.back().x() - line.front().x()));
}

TEST_F(MomentMaps, HaveTheirLayersInTheirOrder) {
  // Where the odometry has the topview's right curb the map has its road.
  recipe_.options.laid_at = LaidAt::kOdometry;
  const Eigen::Vector2d place(30.0, 18.0);
  EXPECT_EQ(seen_at(drawn("labels,topview"), kPi / 2.0, place), class_colour(kCurb));
  EXPECT_EQ(seen_at(drawn("topview,labels"), kPi / 2.0, place), class_colour(kRoad));
  EXPECT_EQ(seen_at(drawn("labels"), kPi / 2.0, place), class_colour(kRoad));
  recipe_.options.laid_at = LaidAt::kEstimate;
  EXPECT_EQ(seen_at(drawn("labels,topview"), kPi / 2.0, place), class_colour(kRoad));
}

TEST_F(MomentMaps, HaveLinesBelowTheGroundThatLiesOnThem) {
  const auto is_line_on_ground = [](const SeenPage& page) {
    const auto line = page.line_in(light().truth_on_imagery);
    const auto stroke = std::find_if(page.strokes.begin(), page.strokes.end(),
                                     [&line](const auto& one) { return one.points == line; });
    const auto place_of = [&page](char kind, std::ptrdiff_t number) {
      const std::pair wanted(kind, static_cast<std::size_t>(number));
      return std::find(page.order.begin(), page.order.end(), wanted) - page.order.begin();
    };
    return place_of('s', stroke - page.strokes.begin()) > place_of('i', 0);
  };
  EXPECT_TRUE(is_line_on_ground(drawn("labels,truth")));
  const SeenPage buried = drawn("truth,labels:0.5");
  EXPECT_FALSE(is_line_on_ground(buried));
  const Rgba house = seen_at(buried, kPi / 2.0, kHouse), truth = class_colour(kBuilding);
  EXPECT_NEAR(house.alpha, 128, 2) << "what lies below shows through";
  EXPECT_LE(difference(house, {truth.red, truth.green, truth.blue, house.alpha}), 2) << "no veil";
}

TEST_F(MomentMaps, HaveTheOpacitiesAndColoursOfTheirLayers) {
  const SeenPage page = drawn("labels:0.25,truth:0.5#FF8800,odometry#FF8800");
  const Rgba pale = seen_at(page, kPi / 2.0, kHouse);
  EXPECT_NEAR(pale.red, 0.25 * class_colour(kBuilding).red + 0.75 * light().page.red, 2.0);
  EXPECT_NEAR(pale.blue, 0.25 * class_colour(kBuilding).blue + 0.75 * light().page.blue, 2.0);
  EXPECT_THAT(page.line_in(faded(kOrange, 0.5)), Not(IsEmpty()));
  EXPECT_THAT(page.line_in(kOrange), Not(IsEmpty()));
  EXPECT_THAT(page.line_in(light().truth_on_imagery), IsEmpty());
  EXPECT_THAT(page.line_in(light().estimate_on_imagery), IsEmpty()) << "it is not shown";
}

TEST_F(MomentMaps, OfAMapWithoutAPictureHaveItsLabelsInThePicturesPlace) {
  write_street(scratch_.path() / "bare", false);
  recipe_.map = (scratch_.path() / "bare").string();
  EXPECT_EQ(seen_at(drawn("picture"), kPi / 2.0, kHouse), class_colour(kBuilding));
  for (const char* stack : {"labels:0.4", "picture:0.4"}) {
    const Rgba pale = seen_at(drawn(stack), kPi / 2.0, kHouse);
    EXPECT_NEAR(pale.red, 0.4 * class_colour(kBuilding).red + 0.6 * light().page.red, 2.0) << stack;
  }
}

TEST_F(MomentMaps, ShowNoGroundWhereNoneIsInSight) {
  const SeenPage with = drawn("labels"), without = drawn("none");
  EXPECT_EQ(with.pictures.size(), without.pictures.size() + 1);
  EXPECT_THAT(drawn("labels,truth,topview:0.5").pictures, SizeIs(with.pictures.size() + 1))
      << "the line lies between two parts of the ground";
}

TEST_F(MomentMaps, SayWhatTheyCannotShow) {
  EXPECT_THAT(drawn("labels,error-surface").words(), HasSubstr("the map is without error surface"));
  EXPECT_THAT(drawn("reconstruction,error-surface").words(),
              HasSubstr("without reconstruction and error surface"));
  EXPECT_THAT(drawn("labels").words(), Not(HasSubstr("the map is without")));
}

TEST_F(MomentMaps, HaveTheGraticuleOfTheWindowTurnedOrNot) {
  const auto is_east = [](const auto& text) { return text.line.rfind("E ", 0) == 0; };
  const auto count_of_east = [&is_east](const SeenPage& page) {
    return std::count_if(page.texts.begin(), page.texts.end(), is_east);
  };
  EXPECT_EQ(count_of_east(drawn("labels")), 0);
  for (const char* up : {"north", "30", "359.9999999999"}) {
    const SeenPage page = drawn("labels,graticule:0.5#FF8800", up);
    EXPECT_GT(count_of_east(page), 0) << up;
    const Rgba line = grid_look_on_imagery(light(), kOrange, 0.5).line;
    EXPECT_THAT(page.line_in(line), SizeIs(2)) << up;
  }
}

TEST_F(MomentMaps, HaveEllipsesAsPaleAsTheEstimateUnlessTheyHaveAColour) {
  const Rgba blue = light().estimate_on_imagery;
  const SeenPage pale = drawn("labels,estimate:0.5,ellipses:0.5");
  EXPECT_THAT(pale.line_in(faded(blue, 0.25)), Not(IsEmpty()));
  const SeenPage orange = drawn("labels,estimate:0.5,ellipses:0.5#FF8800");
  EXPECT_THAT(orange.line_in(faded(kOrange, 0.5)), Not(IsEmpty()));
  EXPECT_THAT(orange.line_in(faded(blue, 0.25)), IsEmpty());
}

TEST_F(MomentMaps, HaveTheRunInTheColourThatItIsToHave) {
  recipe_.options.run_colour = 3;
  EXPECT_THAT(drawn("labels,estimate").line_in(light().third_run), Not(IsEmpty()));
  EXPECT_THAT(drawn("labels,estimate#FF8800").line_in(kOrange), Not(IsEmpty()));
}

TEST_F(MomentMaps, WithoutAGroundHaveTheColoursOfThePage) {
  for (const char* stack : {"truth,odometry,estimate", "labels:0.2,truth,odometry,estimate"}) {
    const SeenPage page = drawn(stack);
    EXPECT_THAT(page.line_in(light().truth), Not(IsEmpty())) << stack;
    EXPECT_THAT(page.line_in(light().estimate), Not(IsEmpty())) << stack;
    EXPECT_THAT(page.line_in(light().truth_on_imagery), IsEmpty()) << "white on white, " << stack;
  }
  const auto lines = [](const SeenPage& page) {
    return std::count_if(page.strokes.begin(), page.strokes.end(),
                         [](const auto& stroke) { return stroke.style.colour == light().line; });
  };
  EXPECT_GT(lines(drawn("graticule")), lines(drawn("none")));
}

TEST_F(MomentMaps, OfAFilmWithTwoPartsOfGroundAreThoseOfTheirMoments) {
  const std::string stack = "labels,truth,topview:0.5,particles";
  const std::unique_ptr<Figure> film = made(stack);
  FigureContext context(format());
  for (const double time_s : {2.5, 7.5, 2.5}) {
    film->show_at(time_s);
    SeenPage frame;
    ASSERT_TRUE(film->draw(frame, context).has_value());
    recipe_.options.time_s = time_s;
    EXPECT_EQ(frame.pictures, drawn(stack).pictures) << time_s;
  }
}

TEST_F(MomentMaps, OfAStepThatWasLostAreDrawnAllTheSame) {
  RunStep lost = street_step(15, {});
  lost.estimate.moments.mean = {std::nan(""), std::nan(""), std::nan("")};
  lost.estimate.modes.clear();
  const auto map = read_overhead_map(recipe_.map).value();
  for (const char* up : {"north", "30", "heading"}) {
    recipe_.options.crop = {};
    recipe_.options.stack = MapStack::from_text("labels,truth,topview,estimate").value();
    recipe_.options.up = MapUpward::from_text(up).value();
    auto shown = MomentMap::create(recipe_.map, with_stack_applied(recipe_.options));
    ASSERT_TRUE(shown) << error_text(shown);
    (*shown)->show(lost, map, light());
    FigureContext context(format());
    SeenPage page;
    const FigureRun run = open_figure_run(recipe_.runs[0], recipe_.options).value();
    ASSERT_TRUE((*shown)->draw(page, context, {0.0, 0.0, 400.0, 400.0}, run, 16, lost)) << up;
    EXPECT_THAT(page.line_in(light().truth_on_imagery), Not(IsEmpty())) << up;
  }
}

}  // namespace moment_map_test
}  // namespace nadir
