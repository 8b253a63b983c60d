// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/map_panel.h"

#include <gmock/gmock.h>

#include "core/map/overhead_map_file.h"
#include "tests/support/error_text.h"
#include "tests/support/recorded_page.h"
#include "tests/support/scenery.h"
#include "tests/support/scratch_folder.h"
#include "widgets/canvas/cairo_canvas.h"
#include "widgets/figures/figures.h"

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

}  // namespace map_panel_test
}  // namespace nadir
