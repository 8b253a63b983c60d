// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "tests/support/drawn_map.h"
#include "tests/support/scenery.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/views/map_page.h"
#include "widgets/views/overhead_view.h"
#include "widgets/views/theme.h"

namespace nadir {

/// A test that shows a map of 700 x 1,100 cells of 0.5 m, of which four tiles of the finest level meet at (512, 512).
class MapOnTheGround : public MapPage {
 protected:
  using Layer = OverheadTiles::Layer;
  static constexpr int kWidth = 120;
  static constexpr int kHeight = 80;
  static constexpr int kAnyNumber = 1000;

  static void SetUpTestSuite() {
    MapPage::SetUpTestSuite();
    folder() = std::make_unique<ScratchFolder>();
    map() = std::make_unique<OverheadMap>(patchwork_map(700, 1100, 0.5));
    ColourRaster picture(700, 1100);
    for (int row = 0; row < 1100; ++row) {
      for (int column = 0; column < 700; ++column) {
        picture.at(column, row) = {static_cast<std::uint8_t>(column / 4),
                                   static_cast<std::uint8_t>(row / 5), 100};
      }
    }
    ASSERT_TRUE(write_overhead_map(*map(), {}, picture, folder()->path() / "map"));
  }
  static void TearDownTestSuite() {
    map().reset();
    folder().reset();
    MapPage::TearDownTestSuite();
  }

  static OverheadTiles tiles(Layer layer) {
    return OverheadTiles::open(folder()->path() / "map", layer).value();
  }
  static std::unique_ptr<ScratchFolder>& folder() {
    static std::unique_ptr<ScratchFolder> made;
    return made;
  }
  static std::unique_ptr<OverheadMap>& map() {
    static std::unique_ptr<OverheadMap> made;
    return made;
  }
  /// The class that the map has at a place, in its colour.
  static std::optional<Rgba> label_at(const Eigen::Vector2d& point_in_enu) {
    const Eigen::Vector2d cell = map()->overhead_from_enu(point_in_enu);
    if (is_near_border(cell.x()) || is_near_border(cell.y())) return std::nullopt;
    return class_colour(map()->class_at(point_in_enu));
  }
  static void update(OverheadView& view, const MapCamera& camera) {
    const auto complete = view.update(camera, kWidth, kHeight, kAnyNumber);
    ASSERT_TRUE(complete) << error_text(complete);
    EXPECT_TRUE(*complete);
  }

  MapScene scene{map()->enu_from_overhead({350, 550})};
};

}  // namespace nadir
