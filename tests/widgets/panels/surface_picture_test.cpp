// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/surface_picture.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/made_answer.h"

namespace nadir {
namespace surface_picture_test {

TEST(SurfacePicture, HasNorthUpAndLightWhereItIsCheap) {
  MomentSurface surface;
  surface.volume.grid = {.count_x = 3, .count_y = 3, .count_yaw = 1, .step_m = 1.0};
  surface.volume.centre_in_enu = {10.0, 20.0, 0.0};
  surface.plane = {0.9F, 0.9F, 0.9F, 0.9F, 0.5F,
                   0.9F, 0.9F, 0.9F, 0.1F};  // cheapest in the north-east
  const Raster<Rgba> picture = surface_picture(surface, surface.plane, nullptr);
  ASSERT_EQ(picture.width(), 3 * kSurfaceScale);
  EXPECT_EQ(picture.at(picture.width() - 1, 0), value_colour(ValueColours::kViridis, 1.0));
  EXPECT_EQ(picture.at(0, picture.height() - 1), value_colour(ValueColours::kViridis, 0.0));
  const PageRect where{5.0, 7.0, 300.0, 300.0};
  EXPECT_EQ(surface_point(surface, {2.0, 0.0, 0.0}, where), Eigen::Vector2d(255.0, 57.0));
  const GridPlace place = surface_place(surface, {255.0, 57.0}, where);
  EXPECT_NEAR(place.x, 2.0, 1e-9);
  EXPECT_NEAR(place.y, 0.0, 1e-9);
}

TEST(SurfacePicture, ParticlesLightenThePixelsTheyFallOn) {
  const MadeMoment made;
  const auto answer = answer_of(question_of(made));
  const Raster<Rgba> bare = surface_picture(*answer->surface, answer->surface->plane, nullptr);
  const Raster<Rgba> with =
      surface_picture(*answer->surface, answer->surface->plane, &*made.step->particles);
  const GridPlace place = answer->surface->place_of(made.step->particles->pose(0));
  const PageRect page{0.0, 0.0, static_cast<double>(bare.width()),
                      static_cast<double>(bare.height())};
  const Eigen::Vector2d at = surface_point(*answer->surface, place, page);
  const int column = static_cast<int>(at.x());
  const int row = bare.height() - 1 - static_cast<int>(at.y());
  EXPECT_GT(with.at(column, row).blue, bare.at(column, row).blue);
  EXPECT_EQ(with.at(0, 0), bare.at(0, 0));
}

TEST(CostRange, OfOneCostIsAsGoodAsCanBe) {
  const std::vector<float> same = {0.3F, 0.3F};
  EXPECT_EQ(cost_range(same).goodness(0.3F), 1.0);
  EXPECT_EQ(cost_range({}).goodness(0.0F), 1.0);
}

}  // namespace surface_picture_test
}  // namespace nadir
