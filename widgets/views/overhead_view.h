// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "widgets/views/tile_pyramid_view.h"

namespace nadir {

/// Shows one layer of an overhead, of any size, as TilePyramidView shows it.
class OverheadView {
 public:
  /// @param budget  Shared with other views; null: one of its own.
  OverheadView(MapScene& scene,
               OverheadTiles tiles,
               OverheadTiles::Layer layer,
               std::shared_ptr<TileBudget> budget = nullptr);

  /// As TilePyramidView::update(), which reads the file.
  [[nodiscard]] Result<bool> update(const MapCamera& camera,
                                    double width_px,
                                    double height_px,
                                    int most_new_tiles) {
    return view_.update(camera, width_px, height_px, most_new_tiles);
  }
  void set_opacity(double opacity) { view_.set_opacity(opacity); }
  void set_visible(bool visible) { view_.set_visible(visible); }
  [[nodiscard]] const OverheadTiles& tiles() const { return *tiles_; }
  [[nodiscard]] int level_for(double metres_per_px) const { return view_.level_for(metres_per_px); }

 private:
  std::shared_ptr<const OverheadTiles> tiles_;
  TilePyramidView view_;
};

}  // namespace nadir
