// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/map/image_file.h"
#include "core/map/map_warp.h"
#include "core/map/tile_source.h"

namespace nadir {

/// An image on a grid of the plane, warped whenever a part of it is read. Private to this module.
///
/// @param image      Taken over.
/// @param placement  Of its pixels.
/// @param is_same    The cells are the image's own pixels, which then stay as they are; otherwise bilinear.
/// @errors kMalformed.
[[nodiscard]] Result<std::unique_ptr<TileSource>> tiles_on_plane(ImageFile image,
                                                                 const Placement& placement,
                                                                 const MapGrid& grid,
                                                                 bool is_same,
                                                                 const std::string& name);

}  // namespace nadir
