// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/label_objects_view.h"

#include <gmock/gmock.h>

#include <set>
#include <tuple>

#include "tests/core/label/drawn_labels.h"
#include "tests/support/page_pixels.h"
#include "widgets/canvas/cairo_canvas.h"
#include "widgets/views/label_marks.h"

namespace nadir {
namespace label_objects_view_test {

constexpr Rgba kGround{120, 124, 90};
constexpr int kSide = 200;

MapFrame frame_of(double metres_per_px = 0.1, const Eigen::Vector2d& centre = {10.0, -10.0}) {
  return {{0, 0, kSide, kSide}, {centre, metres_per_px}, 1.0};
}

Raster<Rgba> drawn_on(Rgba ground,
                      const LabelOverlay& overlay,
                      const MapFrame& frame = frame_of()) {
  const auto canvas = CairoCanvas::for_pixels(kSide, kSide, ground);
  draw_label_overlay(*canvas, frame, overlay, theme(ThemeName::kDark));
  return canvas->pixels();
}

int changed_pixels(const Raster<Rgba>& page, Rgba ground) {
  return static_cast<int>(
      std::count_if(page.values().begin(), page.values().end(),
                    [&](Rgba pixel) { return difference(pixel, ground) > 40; }));
}

std::shared_ptr<const LabelObject> shared(LabelObject object) {
  return std::make_shared<const LabelObject>(std::move(object));
}

/// Overlays with one thing each, in the middle of the page or around it.
std::vector<std::pair<std::string, LabelOverlay>> single_things() {
  std::vector<std::pair<std::string, LabelOverlay>> all;
  const auto add = [&all](std::string name) -> LabelOverlay& {
    return all.emplace_back(std::move(name), LabelOverlay{}).second;
  };
  all.reserve(20);
  const auto square = shared(area(kRoad, {box(5, 5, 15, 15)}));
  add("selected").selected = {square};
  LabelOverlay& corners = add("corners");
  corners.selected = {square};
  corners.shows_corners = true;
  add("picked").picked = {{10.0, -10.0}};
  add("under hand").under_hand = square;
  add("coming").coming = {{{box(5, 5, 15, 15)}, true, kVegetation}};
  add("taken away").coming = {{{box(5, 5, 15, 15)}, true, kUnclassified}};
  LabelOverlay& tool = add("tool");
  tool.places = ring({{5, 5}, {15, 5}});
  tool.next = Eigen::Vector2d(15.0, -15.0);
  tool.closes = true;
  add("words").words = {{{3.0, -10.0}, {17.0, -10.0}, "14.00 m", false}};
  for (const SnapMark mark : {SnapMark::kCorner, SnapMark::kEdge, SnapMark::kContinuing,
                              SnapMark::kSquareOn, SnapMark::kClosing}) {
    add("snap " + std::to_string(static_cast<int>(mark))).snapped = {mark, {10.0, -10.0}};
  }
  add("brush").brush = {{10.0, -10.0}, 5.0};
  return all;
}

TEST(LabelOverlay, IsSeenOnAnyGround) {
  for (const auto& [name, overlay] : single_things()) {
    for (const Rgba ground : {kWhite, kBlack, kGround, Rgba{86, 180, 233}, Rgba{224, 160, 48},
                              Rgba{76, 166, 232}, Rgba{221, 226, 230}}) {
      EXPECT_GT(changed_pixels(drawn_on(ground, overlay), ground), 15)
          << name << " on " << testing::PrintToString(ground);
    }
  }
}

TEST(LabelOverlay, OfNothingIsNothing) {
  EXPECT_EQ(changed_pixels(drawn_on(kGround, {}), kGround), 0);
}

TEST(LabelOverlay, LeavesOutWhatIsOutOfSightOrTooSmall) {
  LabelOverlay overlay;
  overlay.selected = {shared(area(kRoad, {box(500, 500, 510, 510)}))};
  overlay.under_hand = shared(area(kRoad, {box(-90, 0, -80, 5)}));
  overlay.picked = {{400.0, 0.0}};
  overlay.shows_corners = true;
  EXPECT_EQ(changed_pixels(drawn_on(kGround, overlay), kGround), 0);
  // 0.15 m are 1.5 pixels here, 3 there.
  overlay = {};
  overlay.selected = {shared(area(kRoad, {box(10, 10, 10.15, 10.15)}))};
  EXPECT_EQ(changed_pixels(drawn_on(kGround, overlay), kGround), 0);
  EXPECT_GT(changed_pixels(drawn_on(kGround, overlay, frame_of(0.05)), kGround), 0);
}

TEST(LabelOverlay, FillsWhatIsComingWithItsClassAndLeavesHolesOpen) {
  LabelOverlay overlay;
  overlay.coming = {{{box(2, 2, 18, 18), box(8, 8, 12, 12)}, true, kVegetation}};
  const Raster<Rgba> page = drawn_on(kWhite, overlay);
  // Page y counts up: the ring reaches from 20 to 180 pixels, its hole from 80 to 120.
  const Rgba filled = pixel_at(page, 50, 100);
  const Rgba of_class = class_colour(kVegetation);
  const auto mixed = [](int channel) { return 255 + 0.35 * (channel - 255); };
  EXPECT_NEAR(filled.red, mixed(of_class.red), 3);
  EXPECT_NEAR(filled.green, mixed(of_class.green), 3);
  EXPECT_NEAR(filled.blue, mixed(of_class.blue), 3);
  EXPECT_EQ(pixel_at(page, 100, 100), kWhite) << "the hole";
  EXPECT_EQ(pixel_at(page, 10, 100), kWhite) << "outside";
}

TEST(LabelOverlay, MarksEachKindOfSnapByItsOwnForm) {
  // In one colour, so that the form alone tells them apart.
  std::set<std::string> forms;
  for (const SnapMark mark : {SnapMark::kCorner, SnapMark::kEdge, SnapMark::kContinuing,
                              SnapMark::kSquareOn, SnapMark::kClosing}) {
    const auto canvas = CairoCanvas::for_pixels(32, 32, kWhite);
    draw_snap_mark(*canvas, {16.0, 16.0}, mark, {1.0, 0.0}, {kBlack, kWhite, 1.0});
    std::string form;
    const Raster<Rgba> page = canvas->pixels();
    for (const Rgba pixel : page.values()) form += pixel.red < 128 ? '#' : '.';
    EXPECT_GT(std::count(form.begin(), form.end(), '#'), 15);
    for (const std::string& other : forms) {
      int different = 0;
      for (std::size_t i = 0; i < form.size(); ++i) different += form[i] != other[i] ? 1 : 0;
      EXPECT_GT(different, 20);
    }
    forms.insert(form);
  }
  EXPECT_EQ(forms.size(), 5U);
}

TEST(LabelOverlay, ShowsPickedCornersLargerThanOthers) {
  const auto ink = [](bool is_picked) {
    const auto canvas = CairoCanvas::for_pixels(32, 32, kWhite);
    draw_corner(*canvas, {16.0, 16.0}, is_picked, {kBlack, kWhite, 1.0});
    return ink_area(canvas->pixels());
  };
  EXPECT_GT(ink(true), 2.0 * ink(false));
}

TEST(LabelOverlay, DrawsTheBrushAsLargeAsItIs) {
  for (const double radius_m : {3.0, 8.0}) {
    LabelOverlay overlay;
    overlay.brush = {{10.0, -10.0}, radius_m};
    const PageRect ink = ink_box(drawn_on(kGround, overlay), kGround);
    EXPECT_NEAR(ink.width, 20.0 * radius_m + 2.0, 2.0);
    EXPECT_NEAR(ink.height, 20.0 * radius_m + 2.0, 2.0);
    EXPECT_NEAR(ink.centre().x(), 100.0, 0.6);
  }
  LabelOverlay tiny;
  tiny.brush = {{10.0, -10.0}, 0.01};
  EXPECT_GT(changed_pixels(drawn_on(kGround, tiny), kGround), 10) << "the cross still says where";
}

TEST(LabelOverlay, NamesShortLegsOnlyWhereSomebodyTyped) {
  LabelOverlay overlay;
  overlay.words = {{{10.0, -10.0}, {10.5, -10.0}, "0.50 m", false}};
  EXPECT_EQ(changed_pixels(drawn_on(kGround, overlay), kGround), 0);
  overlay.words[0].is_typed = true;
  EXPECT_GT(changed_pixels(drawn_on(kGround, overlay), kGround), 100);
}

TEST(LabelOverlay, HasABoundForHowMuchOfASelectionIsCased) {
  LabelOverlay many;
  for (int i = 0; i < 900; ++i) {
    const double x = (i % 30) * 0.66, y = (i / 30) * 0.66;
    many.selected.push_back(shared(area(kRoad, {box(x, y, x + 0.5, y + 0.5)}, i + 1)));
  }
  // Each is seen all the same.
  const Raster<Rgba> page = drawn_on(kBlack, many);
  for (const auto& object : many.selected) {
    const Eigen::Vector2d corner = frame_of().page(object->rings[0][0]);
    int lit = 0;
    for (int y = -2; y <= 2; ++y) {
      for (int x = -2; x <= 2; ++x) {
        const double at_x = corner.x() + x, at_y = corner.y() + y;
        if (at_x < 0 || at_y < 0 || at_x >= kSide || at_y >= kSide) continue;
        lit += difference(pixel_at(page, at_x, at_y), kBlack) > 60 ? 1 : 0;
      }
    }
    EXPECT_GT(lit, 0);
  }
}

TEST(BorderOf, IsClosedAroundAreasAndBothSidesOfLines) {
  const LabelObject with_hole = area(kRoad, {box(0, 0, 9, 9), box(3, 3, 6, 6)});
  const auto rings = border_of(with_hole, 0.1);
  ASSERT_EQ(rings.size(), 2U);
  for (const Ring& closed : rings) {
    EXPECT_EQ(closed.size(), 5U);
    EXPECT_EQ(closed.front(), closed.back());
  }
  // A bent road of 2 m: every place of its border lies 1 m from its middle, or sqrt 2 at the corner.
  const LabelObject road = line(kRoad, ring({{0, 0}, {10, 0}, {10, 10}}), 2.0);
  const auto sides = border_of(road, 0.1);
  ASSERT_EQ(sides.size(), 1U);
  const Ring& around = sides[0];
  EXPECT_EQ(around.front(), around.back());
  const auto has = [&around](double x, double y) {
    return std::any_of(around.begin(), around.end(), [&](const Eigen::Vector2d& place) {
      return (place - Eigen::Vector2d(x, -y)).norm() < 1e-9;
    });
  };
  for (const auto& [x, y] :
       {std::pair(0.0, -1.0), {0.0, 1.0}, {11.0, -1.0}, {9.0, 1.0}, {11.0, 10.0}, {9.0, 10.0}}) {
    EXPECT_TRUE(has(x, y)) << x << " " << y;
  }
  // Where its sides would touch on the page, its middle stands for it.
  EXPECT_EQ(border_of(road, 1.0), std::vector<Ring>{road.rings[0]});
}

TEST(BorderOf, StaysNearItsLineWhereThatTurnsBack) {
  const LabelObject hairpin = line(kRoad, {{0.0, 0.0}, {10.0, 0.0}, {0.0, 0.01}}, 1.0);
  const std::vector<Ring> border = border_of(hairpin, 0.01);
  for (const Eigen::Vector2d& place : border.at(0)) {
    EXPECT_LT(place.x(), 11.5);
    EXPECT_LT(std::abs(place.y()), 1.5);
  }
}

TEST(PageLine, KeepsItsEndsAndLeavesOutWhatNobodyCanTellApart) {
  Ring fine;
  for (int i = 0; i <= 1000; ++i) fine.emplace_back(0.02 * i, -10.0);
  const auto on_page = page_line(frame_of(), fine, 2.0);
  EXPECT_LE(on_page.size(), 102U);
  EXPECT_GE(on_page.size(), 90U);
  EXPECT_EQ(on_page.front(), frame_of().page(fine.front()));
  EXPECT_EQ(on_page.back(), frame_of().page(fine.back()));
  for (std::size_t i = 2; i < on_page.size(); ++i) {
    EXPECT_GE((on_page[i - 1] - on_page[i - 2]).norm(), 2.0);
  }
}

}  // namespace label_objects_view_test
}  // namespace nadir
