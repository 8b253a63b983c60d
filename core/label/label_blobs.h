// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/label/label_object.h"
#include "core/label/label_paint.h"

namespace nadir {

/// What stands in the blobs of labels.gpkg. Private to this module. Whatever is read may be damaged; nothing is allocated by
/// a number that was read before it was compared with what is there. All errors are kMalformed and name no file.

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

/// All of an object but its id. Places are in rows of eight bytes a number with a mark between rings, so that images of an
/// object before and after an edit differ in one piece. Never empty.
[[nodiscard]] Bytes object_image(const LabelObject& object);
[[nodiscard]] Result<LabelObject> object_of_image(ByteSpan image, ObjectId id);

/// A geometry as GeoPackage has it: header with envelope, then well-known binary; rings closed by their first place.
[[nodiscard]] Bytes geopackage_geometry(const LabelObject& object, std::int32_t srs_id);
/// One part of a geometry: the rings of a polygon, or one polyline.
struct GeometryPart {
  bool is_polygon = false;
  std::vector<Ring> rings;
};
/// Lines, polygons and collections of them, of any byte order; heights and measures are left out.
[[nodiscard]] Result<std::vector<GeometryPart>> parts_of_geometry(ByteSpan geometry);

/// What differs between two texts of bytes, so that either gives the other. Empty texts stand for what there is not.
[[nodiscard]] Bytes byte_delta(ByteSpan before, ByteSpan after);
/// @errors also where `after` is not what the delta was made of.
[[nodiscard]] Result<Bytes> before_of(ByteSpan delta, ByteSpan after);
[[nodiscard]] Result<Bytes> after_of(ByteSpan delta, ByteSpan before);

[[nodiscard]] Bytes packed_tile(const PaintTile& tile);
[[nodiscard]] Result<std::shared_ptr<const PaintTile>> unpacked_tile(ByteSpan packed);
/// The same in both directions. Null tiles are those in which nothing is painted.
[[nodiscard]] Bytes tile_delta(const PaintTile* before, const PaintTile* after);
[[nodiscard]] Result<std::shared_ptr<const PaintTile>> other_tile(ByteSpan delta,
                                                                  const PaintTile* tile);

}  // namespace nadir
