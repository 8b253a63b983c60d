// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/raster_view.h"

#include <numbers>
#include <stdexcept>

#include "tests/widgets/views/map_page.h"

namespace nadir {
namespace raster_view_test {

constexpr int kWidth = 90;
constexpr int kHeight = 60;
constexpr double kPi = std::numbers::pi;

/// Every pixel has its own colour.
Raster<Rgba> numbered(int width, int height) {
  Raster<Rgba> pixels(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      pixels.at(column, row) = {static_cast<std::uint8_t>(40 + 30 * column),
                                static_cast<std::uint8_t>(250 - 40 * row), 90};
    }
  }
  return pixels;
}

class RasterOnTheGround : public MapPage {
 protected:
  /// What lies at a place by the definition of the frame at the picture's corner.
  static Truth truth_of(const Raster<Rgba>& pixels,
                        const Rigid2& enu_from_corner,
                        const Eigen::Vector2d& metres_per_pixel) {
    return [=](const Eigen::Vector2d& point_in_enu) -> std::optional<Rgba> {
      const Eigen::Vector2d at =
          (enu_from_corner.inverse() * point_in_enu).cwiseQuotient(metres_per_pixel);
      if (is_near_border(at.x()) || is_near_border(at.y())) return std::nullopt;
      const auto column = static_cast<int>(std::floor(at.x()));
      const auto row = static_cast<int>(std::floor(-at.y()));
      return pixels.contains(column, row) ? pixels.at(column, row) : kNothing;
    };
  }

  MapScene scene{{100, 200}};
  const MapCamera camera{{103.1, 197.3}, 0.13};
};

TEST_F(RasterOnTheGround, HasEachPixelInItsPlace) {
  RasterView view(scene, MapLayer::kLabels);
  const Raster<Rgba> pixels = numbered(6, 4);
  for (const double yaw_rad : {0.0, kPi / 2.0, 0.4, -2.6}) {
    for (const double up_rad : {kPi / 2.0, 1.0, -2.0}) {
      for (const Eigen::Vector2d& metres_per_pixel :
           {Eigen::Vector2d(1.0, 1.0), Eigen::Vector2d(0.7, 1.3)}) {
        const Rigid2 enu_from_corner{101.0, 199.5, yaw_rad};
        const MapCamera turned{camera.centre_in_enu_m, camera.metres_per_px, up_rad};
        view.show(pixels, enu_from_corner, metres_per_pixel, false);
        SCOPED_TRACE("yaw " + std::to_string(yaw_rad) + ", up " + std::to_string(up_rad));
        expect_everywhere(draw(scene, turned, kWidth, kHeight), turned,
                          truth_of(pixels, enu_from_corner, metres_per_pixel));
      }
    }
  }
}

TEST_F(RasterOnTheGround, HasItsTopRowInTheNorth) {
  RasterView view(scene, MapLayer::kLabels);
  Raster<Rgba> pixels(2, 2);
  pixels.at(0, 0) = kRed;
  pixels.at(1, 0) = kGreen;
  pixels.at(0, 1) = kBlue;
  pixels.at(1, 1) = kWhite;
  view.show(pixels, {100, 202, 0.0}, {2.0, 2.0}, false);
  const Raster<Rgba> drawn = draw(scene, {{102, 200}, 0.1}, kWidth, kHeight);
  EXPECT_EQ(drawn.at(35, 20), kRed);    // north-west
  EXPECT_EQ(drawn.at(55, 20), kGreen);  // north-east
  EXPECT_EQ(drawn.at(35, 40), kBlue);
  EXPECT_EQ(drawn.at(55, 40), kWhite);
}

TEST_F(RasterOnTheGround, MovesWithoutBeingShownAgain) {
  RasterView view(scene, MapLayer::kLabels);
  const Raster<Rgba> pixels = numbered(6, 4);
  view.show(pixels, {101, 199.5, 0.0}, {1.0, 1.0}, false);
  (void)draw(scene, camera, kWidth, kHeight);
  const Rigid2 elsewhere{104.2, 198.1, 0.8};
  view.place(elsewhere, {0.6, 0.9});
  expect_everywhere(draw(scene, camera, kWidth, kHeight), camera,
                    truth_of(pixels, elsewhere, {0.6, 0.9}));
}

TEST_F(RasterOnTheGround, ShowsAnotherPictureOfAnotherSize) {
  RasterView view(scene, MapLayer::kLabels);
  view.show(numbered(6, 4), {101, 199.5, 0.0}, {1.0, 1.0}, false);
  (void)draw(scene, camera, kWidth, kHeight);
  const Raster<Rgba> other = numbered(3, 5);
  view.show(other, {101, 199.5, 0.0}, {1.0, 1.0}, false);
  expect_everywhere(draw(scene, camera, kWidth, kHeight), camera,
                    truth_of(other, {101, 199.5, 0.0}, {1.0, 1.0}));
}

TEST_F(RasterOnTheGround, LetsThroughWhatLiesBelowItsHoles) {
  RasterView above(scene, MapLayer::kLabels);
  RasterView below(scene, MapLayer::kPicture);  // comes later and stays below
  Raster<Rgba> holed = numbered(6, 4);
  for (int column = 0; column < 6; column += 2) holed.at(column, 1) = kNothing;
  const Raster<Rgba> whole(8, 8, kBlue);
  above.show(holed, {101, 199.5, 0.0}, {1.0, 1.0}, false);
  below.show(whole, {100, 201.5, 0.0}, {1.0, 1.0}, false);
  const Truth top = truth_of(holed, {101, 199.5, 0.0}, {1.0, 1.0});
  const Truth ground = truth_of(whole, {100, 201.5, 0.0}, {1.0, 1.0});
  expect_everywhere(draw(scene, camera, kWidth, kHeight), camera,
                    [&](const Eigen::Vector2d& point) {
                      const auto seen = top(point);
                      return seen == kNothing ? ground(point) : seen;
                    });
}

TEST_F(RasterOnTheGround, KeepsItsColoursWhenItIsHalfTransparent) {
  RasterView view(scene, MapLayer::kLabels);
  view.show(numbered(6, 4), {101, 199.5, 0.0}, {1.0, 1.0}, false);
  view.set_opacity(0.5);
  const Truth opaque = truth_of(numbered(6, 4), {101, 199.5, 0.0}, {1.0, 1.0});
  expect_everywhere(
      draw(scene, camera, kWidth, kHeight), camera,
      [&](const Eigen::Vector2d& point) {
        auto seen = opaque(point);
        if (seen && seen->alpha == 255) seen->alpha = 128;
        return seen;
      },
      2);
  view.set_opacity(1.0);
  expect_everywhere(draw(scene, camera, kWidth, kHeight), camera, opaque);
}

TEST_F(RasterOnTheGround, MultipliesItsOwnOpacityWithThatOfThePicture) {
  RasterView view(scene, MapLayer::kLabels);
  view.show(Raster<Rgba>(4, 4, Rgba{200, 100, 50, 102}), {100, 202, 0.0}, {5.0, 5.0}, false);
  view.set_opacity(0.5);
  const Rgba seen = draw(scene, {{102, 200}, 0.1}, kWidth, kHeight).at(45, 30);
  EXPECT_LE(difference(seen, {200, 100, 50, 51}), 4);
}

TEST_F(RasterOnTheGround, DisappearsWhenItIsHiddenAndWhenItIsGone) {
  const Raster<Rgba> empty(kWidth, kHeight, kNothing);
  {
    RasterView view(scene, MapLayer::kLabels);
    view.show(numbered(6, 4), {101, 199.5, 0.0}, {1.0, 1.0}, false);
    const Raster<Rgba> shown = draw(scene, camera, kWidth, kHeight);
    EXPECT_NE(shown, empty);
    view.set_visible(false);
    EXPECT_EQ(draw(scene, camera, kWidth, kHeight), empty);
    view.set_visible(true);
    EXPECT_EQ(draw(scene, camera, kWidth, kHeight), shown);
  }
  EXPECT_EQ(draw(scene, camera, kWidth, kHeight), empty);
}

TEST_F(RasterOnTheGround, MixesNeighboursOnlyWhereItIsSmooth) {
  Raster<Rgba> pixels(2, 1);
  pixels.at(0, 0) = kBlack;
  pixels.at(1, 0) = kWhite;
  RasterView view(scene, MapLayer::kPicture);
  view.show(pixels, {98, 204, 0.0}, {4.0, 8.0}, true);
  // Between the centres of the two, 4 m apart, lightness rises evenly.
  const Raster<Rgba> smooth = draw(scene, {{102, 200}, 0.1}, kWidth, kHeight);
  for (const int column : {35, 40, 45, 50, 55}) {
    const double share = ((column + 0.5 - 45.0) * 0.1 + 2.0) / 4.0;
    EXPECT_NEAR(smooth.at(column, 30).red, 255.0 * share, 8.0) << column;
  }
  view.show(pixels, {98, 204, 0.0}, {4.0, 8.0}, false);
  const Raster<Rgba> sharp = draw(scene, {{102, 200}, 0.1}, kWidth, kHeight);
  EXPECT_EQ(sharp.at(44, 30), kBlack);
  EXPECT_EQ(sharp.at(45, 30), kWhite);
  view.show(pixels, {98, 204, 0.0}, {4.0, 8.0}, true);
  EXPECT_EQ(draw(scene, {{102, 200}, 0.1}, kWidth, kHeight), smooth);
}

TEST_F(RasterOnTheGround, DrawsTheSameBytesTwice) {
  const auto drawn = [] {
    MapScene other({100, 200});
    RasterView view(other, MapLayer::kPicture);
    view.show(numbered(6, 4), {101, 199.5, 0.3}, {0.77, 0.77}, true);
    return draw(other, {{103.1, 197.3}, 0.13, 1.1}, kWidth, kHeight);
  };
  EXPECT_EQ(drawn(), drawn());
}

TEST_F(RasterOnTheGround, ShowsAPartOfAnotherWhereThatOneShowsIt) {
  for (const double yaw_rad : {0.0, 0.4}) {
    RasterView whole(scene, MapLayer::kPicture);
    const Rigid2 corner{98, 203, yaw_rad};
    whole.show(numbered(8, 4), corner, {1.0, 1.5}, false);
    const Raster<Rgba> all = draw(scene, camera, kWidth, kHeight);
    whole.set_visible(false);
    const Eigen::AlignedBox2d part(Eigen::Vector2d(0.25, 0.5), Eigen::Vector2d(0.75, 1.0));
    RasterView cut(scene, MapLayer::kPicture);
    cut.show_part_of(whole, part);
    const Raster<Rgba> drawn = draw(scene, camera, kWidth, kHeight);
    const PageRect page{0, 0, kWidth, kHeight};
    for (int row = 0; row < kHeight; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        const Eigen::Vector2d point =
            camera.enu_from_page(centre_of_pixel(drawn, column, row), page);
        const Eigen::Vector2d in_picture = corner.inverse() * point;
        const Eigen::Vector2d share(in_picture.x() / 8.0, -in_picture.y() / 6.0);
        if (is_near_border(8.0 * share.x()) || is_near_border(4.0 * share.y())) continue;
        ASSERT_EQ(drawn.at(column, row), part.contains(share) ? all.at(column, row) : kNothing);
      }
    }
  }
}

TEST_F(RasterOnTheGround, HasNoPartsOfWhatIsNotShown) {
  RasterView whole(scene, MapLayer::kPicture);
  RasterView cut(scene, MapLayer::kPicture);
  const Eigen::AlignedBox2d all(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1));
  EXPECT_THROW(cut.show_part_of(whole, all), std::logic_error);
  whole.show(numbered(8, 4), {98, 203, 0.0}, {1.0, 1.0}, false);
  EXPECT_THROW(cut.show_part_of(whole, {Eigen::Vector2d(0, 0), Eigen::Vector2d(1.1, 1)}),
               std::logic_error);
}

TEST_F(RasterOnTheGround, CannotBeEmpty) {
  RasterView view(scene, MapLayer::kPicture);
  EXPECT_THROW(view.show({}, {}, {1.0, 1.0}, false), std::logic_error);
}

}  // namespace raster_view_test
}  // namespace nadir
