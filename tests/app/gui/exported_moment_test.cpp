// SPDX-License-Identifier: Apache-2.0
// What the window exports of a moment is what it shows: same ground at the same place, by a recipe that can be kept.
#include <gmock/gmock.h>

#include "core/session/figure_request.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "tests/widgets/figures/seen_page.h"
#include "widgets/figures/figures.h"
#include "widgets/panels/map_geometry.h"

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

}  // namespace exported_moment_test
}  // namespace nadir
