// SPDX-License-Identifier: Apache-2.0
// Pictures of an editor's map: labels over the picture below, and everything that is drawn over them.
#include "core/desk/label_place.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/golden_image.h"
#include "tests/support/small_png.h"
#include "tests/widgets/views/map_page.h"
#include "widgets/canvas/cairo_canvas.h"
#include "widgets/views/label_borders_view.h"
#include "widgets/views/label_objects_view.h"
#include "widgets/views/label_pictures.h"
#include "widgets/views/overhead_view.h"
#include "widgets/views/tile_pyramid_view.h"

namespace nadir {
namespace label_golden_test {

constexpr int kWidth = 480;
constexpr int kHeight = 320;
constexpr int kAll = 1000;
constexpr double kCellM = 0.2;

/// The labels of the bundled map as a document, and the picture below them.
class LabelGoldens : public MapPage {
 protected:
  static LabelDocument proving_ground() {
    const auto place = find_label_place(NADIR_PROVING_GROUND);
    EXPECT_TRUE(place) << error_text(place);
    LabelDocument document = *place->begins_as;
    document.apply(place->takes_over);
    return document;
  }
  /// The ground as it is drawn below an overlay. @param with_borders  Of all objects.
  Raster<Rgba> ground(const LabelDocument& document, double opacity, bool with_borders) {
    const auto shared = std::make_shared<const LabelDocument>(document);
    MapScene scene(camera.centre_in_enu_m);
    OverheadView picture(
        scene, OverheadTiles::open(NADIR_PROVING_GROUND, OverheadTiles::Layer::kPicture).value(),
        OverheadTiles::Layer::kPicture);
    TilePyramidView labels(scene, MapLayer::kLabels, std::make_shared<const LabelPictures>(shared));
    labels.set_opacity(opacity);
    LabelBordersView borders(scene);
    if (with_borders) borders.show(shared);
    EXPECT_TRUE(picture.update(camera, kWidth, kHeight, kAll).value());
    EXPECT_TRUE(labels.update(camera, kWidth, kHeight, kAll).value());
    return draw(scene, camera, kWidth, kHeight);
  }
  void expect_overlay(const std::string& name, const LabelOverlay& overlay, ThemeName look) {
    const auto canvas = CairoCanvas::for_pixels(kWidth, kHeight, {0, 0, 0});
    canvas->image({0, 0, kWidth, kHeight}, ground(objects(), 0.5, false));
    draw_label_overlay(*canvas, {{0, 0, kWidth, kHeight}, camera, 96.0 / 72.0}, overlay,
                       theme(look));
    expect_golden("labels-" + name, in_few_colours(canvas->pixels()));
  }
  /// From the middle of the page, in pixels to the right and up.
  [[nodiscard]] Eigen::Vector2d at(double right_px, double up_px) const {
    return camera.centre_in_enu_m + camera.metres_per_px * Eigen::Vector2d(right_px, up_px);
  }
  [[nodiscard]] Ring around(double right_px, double up_px, double half_px) const {
    return {at(right_px - half_px, up_px - half_px), at(right_px + half_px, up_px - half_px),
            at(right_px + half_px, up_px + half_px), at(right_px - half_px, up_px + half_px)};
  }
  /// An area with a hole, a road and a building over what the map has.
  [[nodiscard]] std::vector<LabelObject> drawn_objects() const {
    return {
        area(kVegetation, {around(-150, 60, 60), around(-150, 60, 20)}, 1),
        line(kRoad, {at(-230, -80), at(-40, -90), at(60, -20), at(70, 150)}, 24 * kCellM / 2, 2),
        outline(kBuilding, {around(160, 60, 45)}, 1.2, 3),
        line(kLaneMarking, {at(-230, -80), at(-40, -90), at(60, -20), at(70, 150)}, 0.15, 4)};
  }
  [[nodiscard]] LabelDocument objects() const {
    LabelDocument document(proving_ground().plane(), proving_ground().grid());
    document.apply(adding(drawn_objects()));
    return document;
  }
  [[nodiscard]] std::shared_ptr<const LabelObject> object(std::size_t number) const {
    return std::make_shared<const LabelObject>(drawn_objects().at(number));
  }

  MapCamera camera = [] {
    const LabelGrid grid = proving_ground().grid();
    return MapCamera{grid.enu_from_cells({grid.width * 0.45, grid.height * 0.5}), 0.2};
  }();
};

TEST_F(LabelGoldens, LabelsLieOverThePictureHalfOpaque) {
  expect_golden("labels-over-picture", in_few_colours(ground(proving_ground(), 0.5, false)));
}

TEST_F(LabelGoldens, BordersOfAllObjects) {
  expect_golden("labels-borders", in_few_colours(ground(objects(), 0.5, true)));
}

TEST_F(LabelGoldens, SelectionWithItsCorners) {
  LabelOverlay overlay;
  overlay.selected = {object(0), object(1)};
  overlay.shows_corners = true;
  overlay.picked = {at(-40, -90), at(60, -20), at(-210, 0)};
  overlay.under_hand = object(2);
  expect_overlay("selection-dark", overlay, ThemeName::kDark);
  expect_overlay("selection-light", overlay, ThemeName::kLight);
}

TEST_F(LabelGoldens, ToolAtWork) {
  LabelOverlay overlay;
  overlay.places = {at(-180, -110), at(-180, 70), at(40, 110)};
  overlay.next = at(150, -60);
  overlay.closes = true;
  Ring coming = overlay.places;
  coming.push_back(*overlay.next);
  overlay.coming = {{{coming}, true, kSidewalk}};
  overlay.words = {{overlay.places[0], overlay.places[1], "36.00 m", false},
                   {overlay.places[1], overlay.places[2], "44.72 m", false},
                   {overlay.places[2], *overlay.next, "40.00 m  147.1°", true}};
  overlay.snapped = LabelOverlay::Snapped{SnapMark::kSquareOn, *overlay.next};
  expect_overlay("tool-dark", overlay, ThemeName::kDark);
  expect_overlay("tool-light", overlay, ThemeName::kLight);
}

TEST_F(LabelGoldens, ABrushAndEveryMarkOfWhatIsSnappedTo) {
  // Side by side on one page: each overlay has one mark.
  constexpr std::array<SnapMark, 5> kMarks = {SnapMark::kCorner, SnapMark::kEdge,
                                              SnapMark::kContinuing, SnapMark::kSquareOn,
                                              SnapMark::kClosing};
  const auto canvas = CairoCanvas::for_pixels(kWidth, kHeight, {0, 0, 0});
  canvas->image({0, 0, kWidth, kHeight}, ground(objects(), 0.5, false));
  const MapFrame frame{{0, 0, kWidth, kHeight}, camera, 96.0 / 72.0};
  for (std::size_t i = 0; i < kMarks.size(); ++i) {
    LabelOverlay overlay;
    const double right = -160.0 + 80.0 * static_cast<double>(i);
    overlay.places = {at(right - 50, -60)};
    overlay.next = at(right, -10);
    overlay.snapped = LabelOverlay::Snapped{kMarks.at(i), *overlay.next};
    if (i == 2) overlay.brush = LabelOverlay::Brush{at(0, 90), 8.0};
    draw_label_overlay(*canvas, frame, overlay, theme(ThemeName::kDark));
  }
  expect_golden("labels-marks", in_few_colours(canvas->pixels()));
}

}  // namespace label_golden_test
}  // namespace nadir
