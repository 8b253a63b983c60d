// SPDX-License-Identifier: Apache-2.0
// What the window exports of a moment is what it shows: same ground at the same place, by a recipe that can be kept.
#include <gmock/gmock.h>

#include "core/session/figure_request.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "tests/widgets/figures/seen_page.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/ground_layers.h"
#include "widgets/panels/map_geometry.h"
#include "widgets/panels/map_lines.h"
#include "widgets/views/map_colours.h"

namespace nadir {
namespace exported_moment_test {

class ExportedMoment : public ::testing::Test {
 protected:
  ExportedMoment() {
    write_street(scratch_.path() / "map");
    write_drive(scratch_.path() / "a.nadir", scratch_.path() / "map", 30);
    request_.figure = "moment";
    request_.runs = {(scratch_.path() / "a.nadir").string()};
    request_.map = (scratch_.path() / "map").string();
    request_.time_s = 7.5;
    request_.width_px = 1000;
    request_.look = default_map_look();
    request_.look.width_m = 60.0;
    request_.look.centre_in_enu_m = {31.25, 19.5};
    request_.look.layer(Layer::kLabels) = {true, 1.0, std::nullopt};
    request_.look.layer(Layer::kTopview).is_visible = false;
    request_.look.layer(Layer::kParticles).is_visible = false;
  }
  [[nodiscard]] FigureRecipe recipe() const {
    auto made = parse_figure_recipe(figure_recipe_text(request_), "recipe");
    EXPECT_TRUE(made) << error_text(made);
    return std::move(*made);
  }
  static SeenPage drawn(const FigureRecipe& recipe) {
    FigureContext context(page_format(recipe.options, figure_kind(recipe.figure)->aspect));
    auto figure = make_figure(recipe);
    if (!figure) throw std::runtime_error(figure.error().message);
    SeenPage page;
    EXPECT_TRUE((*figure)->draw(page, context).has_value());
    return page;
  }
  /// Colour of a source's line in the window's map, of the run that is active.
  [[nodiscard]] Rgba window_colour(PoseSource source) const {
    MapViewModel model;
    model.look = request_.look;
    model.map = std::make_shared<const MapIndex>(
        std::make_shared<const OverheadMap>(read_overhead_map(request_.map).value()));
    MapRun run;
    run.colour = static_cast<std::size_t>(request_.run_colour);
    run.is_active = true;
    return run_path_look(model, run, source, theme(ThemeName::kLight)).colour;
  }

  ScratchFolder scratch_;
  FigureRequest request_;
};

TEST_F(ExportedMoment, HasEveryPlaceWhereTheWindowHasItWhicheverWayItIsTurned) {
  const OverheadMap map = read_overhead_map(request_.map).value();
  request_.look.up = MapUp::kFree;
  for (const double up_rad : {1.5707963267948966, 0.0, 3.141592653589793, 2.2}) {
    request_.look.up_rad = up_rad;
    const SeenPage page = drawn(recipe());
    const PageRect& where = page.images.at(0).where;
    const MapCamera window = map_camera(request_.look, where, {});
    std::size_t compared = 0;
    for (double east = 2.5; east < 60.0; east += 5.0) {
      for (double north = 2.5; north < 40.0; north += 5.0) {
        const Eigen::Vector2d at = window.page_from_enu({east, north}, where);
        const bool is_inside = at.x() > where.left + 1.0 && at.x() < where.right() - 1.0 &&
                               at.y() > where.bottom + 1.0 && at.y() < where.top() - 1.0;
        if (!is_inside) continue;
        EXPECT_EQ(page.colour_at(0, at), class_colour(map.class_at({east, north})))
            << east << " " << north << ", up " << up_rad;
        ++compared;
      }
    }
    EXPECT_GT(compared, 40U);
  }
}

TEST_F(ExportedMoment, IsTheSameByTheRecipeThatItsFileCarries) {
  request_.look.up = MapUp::kFree;
  request_.look.up_rad = 0.7;
  request_.look.layer(Layer::kTruth) = {true, 0.5, "#FF8800"};
  std::swap(request_.look.order[0], request_.look.order[1]);
  const FigureRecipe asked = recipe();
  const auto carried = parse_figure_recipe(recipe_text(asked), "file");
  ASSERT_TRUE(carried) << error_text(carried);
  EXPECT_EQ(recipe_text(*carried), recipe_text(asked));
  EXPECT_EQ(carried->options.stack, MapStack::of(request_.look));
  EXPECT_EQ(carried->options.up, MapUpward::of(request_.look));
  EXPECT_EQ(drawn(*carried).pictures, drawn(asked).pictures);
}

TEST_F(ExportedMoment, OfAMapThatGoesWithTheVehicleHasItInTheMiddleAndItsHeadingUp) {
  request_.look.layer(Layer::kEllipses).is_visible = false;  // they have the colour of the way
  request_.look.is_following = true;
  request_.look.up = MapUp::kHeading;
  request_.look.centre_in_enu_m = {-1e3, 0.0};  // where it stopped following last
  const SeenPage page = drawn(recipe());
  const PageRect& where = page.images.at(0).where;
  const Rigid2 estimate = street_step(15, {}).estimate.moments.mean;
  const auto way = page.line_in(theme(ThemeName::kLight).estimate_on_imagery);
  ASSERT_FALSE(way.empty());
  EXPECT_LT((way.back() - where.centre()).norm(), 1e-6);
  const MapCamera window{estimate.translation_m(), 60.0 / where.width, estimate.yaw_rad};
  const Eigen::Vector2d start = street_step(0, {}).estimate.moments.mean.translation_m();
  EXPECT_LT((way.front() - window.page_from_enu(start, where)).norm(), 1e-6);
}

TEST_F(ExportedMoment, HasLinesInTheColoursOfTheWindowWhicheverRunIsActiveAndWhateverIsBelow) {
  for (const int colour : {0, 1, 2, 3, 5}) {
    for (const double labels : {1.0, 0.2}) {
      request_.run_colour = colour;
      request_.look.layer(Layer::kPicture).is_visible = false;
      request_.look.layer(Layer::kLabels).opacity = labels;
      request_.look.layer(Layer::kEstimate).opacity = 0.75;
      const SeenPage page = drawn(recipe());
      for (const PoseSource source :
           {PoseSource::kTruth, PoseSource::kOdometry, PoseSource::kEstimate}) {
        EXPECT_FALSE(page.line_in(window_colour(source)).empty())
            << enum_name(source) << " of run " << colour + 1 << " over labels of " << labels;
      }
    }
  }
}

TEST_F(ExportedMoment, HasTheEllipsesOfAHiddenEstimateInItsOwnColour) {
  request_.look.layer(Layer::kEstimate) = {false, 0.5, "#FF8800"};
  request_.look.layer(Layer::kEllipses).opacity = 0.5;
  const Rgba window = faded(window_colour(PoseSource::kEstimate), 0.5);
  EXPECT_EQ(window, faded({0xFF, 0x88, 0x00}, 0.25));
  EXPECT_FALSE(drawn(recipe()).line_in(window).empty());
  request_.look.layer(Layer::kEllipses).colour = "#112233";
  EXPECT_FALSE(drawn(recipe()).line_in(faded({0x11, 0x22, 0x33}, 0.5)).empty());
}

TEST_F(ExportedMoment, TakesColoursOverImageryWhereTheWindowDoes) {
  MapLook look = request_.look;
  for (const double picture : {0.0, 0.2, 0.3, 0.31, 1.0}) {
    for (const double labels : {0.0, 0.3, 0.4}) {
      for (const bool is_picture_shown : {false, true}) {
        look.layer(Layer::kPicture) = {is_picture_shown, picture, std::nullopt};
        look.layer(Layer::kLabels).opacity = labels;
        EXPECT_EQ(is_ground_below_lines(look), has_ground_picture(look, true))
            << picture << " " << labels;
      }
    }
  }
}

}  // namespace exported_moment_test
}  // namespace nadir
