// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/moment_map.h"

#include <gmock/gmock.h>

#include <numbers>

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
  SeenPage drawn(const std::string& stack, const std::string& up = "north") {
    recipe_.options.stack = MapStack::from_text(stack).value();
    recipe_.options.up = MapUpward::from_text(up).value();
    FigureContext context(page_format(recipe_.options, figure_kind("moment")->aspect));
    auto figure = make_figure(recipe_);
    if (!figure) throw std::runtime_error(figure.error().message);
    SeenPage page;
    EXPECT_TRUE((*figure)->draw(page, context).has_value());
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
  EXPECT_NEAR(seen_at(buried, kPi / 2.0, kHouse).alpha, 128, 2) << "what lies below shows through";
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

TEST_F(MomentMaps, HaveLinesOfTheGraticuleAlsoWhereTheyAreTurned) {
  EXPECT_FALSE(drawn("labels").has_text("E 20"));
  const SeenPage page = drawn("labels,graticule", "30");
  EXPECT_TRUE(page.has_text("E 20") || page.has_text("E 40") || page.has_text("N 20"));
}

}  // namespace moment_map_test
}  // namespace nadir
