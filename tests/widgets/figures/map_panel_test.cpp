// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/map_panel.h"

#include <gmock/gmock.h>
#include <vtkCallbackCommand.h>

#include <numbers>

#include "core/map/overhead_map_file.h"
#include "tests/support/error_text.h"
#include "tests/support/recorded_page.h"
#include "tests/support/scenery.h"
#include "tests/support/scratch_folder.h"
#include "widgets/canvas/cairo_canvas.h"
#include "widgets/figures/figures.h"
#include "widgets/views/raster_view.h"

namespace nadir {
namespace map_panel_test {

class MapPanels : public ::testing::Test {
 protected:
  MapPanels() {
    const auto written = write_overhead_map(patchwork_map(1300, 700, 0.5), {}, std::nullopt, map());
    EXPECT_TRUE(written) << error_text(written);
    format_.width = 400;
    format_.height = 300;
    format_.dpi = 72.0;
  }
  [[nodiscard]] std::filesystem::path map() const { return scratch_.path() / "map"; }
  [[nodiscard]] std::unique_ptr<MapPanel> panel() const {
    auto made = MapPanel::create(map(), MapPanel::Ground::kLabels, {});
    EXPECT_TRUE(made) << error_text(made);
    return std::move(*made);
  }

  /// The ground's pixels, as a page shows them.
  class Ground : public RecordedPage {
   public:
    Raster<Rgba> pixels;
    void image(const PageRect& /*where*/, const Raster<Rgba>& drawn) override { pixels = drawn; }
  };

  ScratchFolder scratch_;
  PageFormat format_;
};

TEST_F(MapPanels, DrawTheirOwnPixelsAgainAfterADrawingFailed) {
  const std::unique_ptr<MapPanel> drawn = panel();
  FigureContext context(format_);
  const PageRect page{0.0, 0.0, 400.0, 300.0};
  Ground before;
  ASSERT_TRUE(drawn->draw_ground(before, context, page));
  ASSERT_FALSE(before.pixels.empty());
  // Fine tiles are shown by then, and the graphics driver refuses so large a page.
  Ground none;
  EXPECT_FALSE(drawn->draw_ground(none, context, {0.0, 0.0, 40'000.0, 30'000.0}));
  EXPECT_TRUE(none.pixels.empty());
  Ground after;
  ASSERT_TRUE(drawn->draw_ground(after, context, page));
  EXPECT_EQ(after.pixels, before.pixels);
}

TEST_F(MapPanels, ShowTheWholeMapAlsoWhereItIsTurned) {
  const std::unique_ptr<MapPanel> drawn = panel();
  const PageRect page{20.0, 10.0, 400.0, 300.0};
  const Eigen::AlignedBox2d bounds = drawn->map_bounds_in_enu_m();
  constexpr double kPi = std::numbers::pi;
  for (const double up_rad : {0.0, 0.4, 1.0, kPi / 2.0 + 0.1, 2.5, kPi, -1.2}) {
    drawn->turn(up_rad);
    const MapFrame frame = drawn->place_in(page, 1.0).frame;
    Eigen::AlignedBox2d taken;
    for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                              Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight}) {
      taken.extend(frame.page(bounds.corner(corner)));
    }
    const Eigen::Vector2d low(frame.where.left, frame.where.bottom);
    const Eigen::Vector2d room(frame.where.width, frame.where.height);
    EXPECT_GE((taken.min() - low).minCoeff(), -1e-6) << up_rad;
    EXPECT_GE((low + room - taken.max()).minCoeff(), -1e-6) << up_rad;
    EXPECT_LE((room - taken.sizes()).minCoeff(), 1e-6) << "and no smaller than need be, " << up_rad;
  }
}

TEST_F(MapPanels, TakeNorthForNorthHoweverOftenTheyWereTurnedRound) {
  const std::unique_ptr<MapPanel> drawn = panel();
  const PageRect page{0.0, 0.0, 400.0, 300.0};
  const auto north = drawn->place_in(page, 1.0);
  ASSERT_EQ(north.graticule, Graticule::kMetres);
  drawn->turn(std::numbers::pi / 2.0 - 2.0 * std::numbers::pi);
  EXPECT_EQ(drawn->place_in(page, 1.0).graticule, Graticule::kMetres);
  EXPECT_EQ(drawn->place_in(page, 1.0).frame.where, north.frame.where);
  drawn->turn(0.1);
  EXPECT_EQ(drawn->place_in(page, 1.0).graticule, Graticule::kNone);
}

TEST_F(MapPanels, RenderOnlyThatPartOfTheGroundWhichHasChanged) {
  const std::unique_ptr<MapPanel> drawn = panel();
  RasterView topview(drawn->scene(), MapLayer::kTopview);
  const auto lay = [&](Rgba colour) {
    topview.show(Raster<Rgba>(8, 8, colour), Rigid2{300.0, 200.0, 0.0}, {10.0, 10.0}, false);
  };
  lay({255, 0, 0});
  int renderings = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&renderings);
  count->SetCallback([](vtkObject* /*scene*/, unsigned long /*event*/, void* counted,
                        void* /*nothing*/) { ++*static_cast<int*>(counted); });
  drawn->scene().renderer().AddObserver(vtkCommand::EndEvent, count);
  FigureContext context(format_);
  const MapFrame frame = drawn->place_in({0.0, 0.0, 400.0, 300.0}, 1.0).frame;
  const auto part = [&](MapLayer layer) {
    Ground page;
    const std::array layers = {layer};
    EXPECT_TRUE(drawn->draw_part(page, context, frame, layers, layer == MapLayer::kLabels));
    return page.pixels;
  };
  const Raster<Rgba> labels = part(MapLayer::kLabels), red = part(MapLayer::kTopview);
  EXPECT_EQ(renderings, 2);
  EXPECT_EQ(part(MapLayer::kLabels), labels);
  EXPECT_EQ(part(MapLayer::kTopview), red);
  EXPECT_EQ(renderings, 2) << "nothing has changed";
  lay({0, 0, 255});
  EXPECT_EQ(part(MapLayer::kLabels), labels);
  EXPECT_EQ(renderings, 2) << "the topview is none of it";
  const Raster<Rgba> blue = part(MapLayer::kTopview);
  EXPECT_EQ(renderings, 3);
  EXPECT_NE(blue, red);
  EXPECT_EQ(part(MapLayer::kLabels), labels);
  EXPECT_EQ(renderings, 3);
}

}  // namespace map_panel_test
}  // namespace nadir
