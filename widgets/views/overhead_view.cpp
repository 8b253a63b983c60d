// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/overhead_view.h"

#include <utility>

namespace nadir {

OverheadView::OverheadView(MapScene& scene,
                           OverheadTiles tiles,
                           OverheadTiles::Layer layer,
                           std::shared_ptr<TileBudget> budget)
    : tiles_(std::make_shared<const OverheadTiles>(std::move(tiles))),
      view_(scene,
            layer == OverheadTiles::Layer::kPicture ? MapLayer::kPicture : MapLayer::kLabels,
            std::make_shared<const OverheadPictures>(tiles_, layer),
            std::move(budget)) {}

}  // namespace nadir
