// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/label/byte_reader.h"
#include "core/label/label_blobs.h"

namespace nadir {
namespace {

constexpr std::uint8_t kImageVersion = 1;
/// In place of a coordinate: a ring has ended. All coordinates are finite.
constexpr double kRingEnd = std::numeric_limits<double>::infinity();

}  // namespace

Bytes object_image(const LabelObject& object) {
  Bytes image{kImageVersion, static_cast<std::uint8_t>(object.kind), object.class_id, 0};
  append_number(image, object.order);
  append_number(image, object.width_m);
  append_number(image, static_cast<std::uint32_t>(object.note.size()));
  image.insert(image.end(), object.note.begin(), object.note.end());
  for (const Ring& ring : object.rings) {
    for (const Eigen::Vector2d& point : ring) {
      append_number(image, point.x());
      append_number(image, point.y());
    }
    append_number(image, kRingEnd);
  }
  return image;
}

Result<LabelObject> object_of_image(ByteSpan image, ObjectId id) {
  ByteReader reader(image);
  const auto version = reader.number<std::uint8_t>();
  const auto kind = reader.number<std::uint8_t>();
  LabelObject object;
  object.id = id;
  object.class_id = reader.number<std::uint8_t>();
  reader.take(1);
  object.order = reader.number<std::int64_t>();
  object.width_m = reader.number<double>();
  const ByteSpan note = reader.take(reader.number<std::uint32_t>());
  object.note.assign(note.begin(), note.end());
  if (reader.failed() || version != kImageVersion || kind >= EnumNames<ObjectKind>::kNames.size()) {
    return fail(ErrorCode::kMalformed, "object {} is damaged", id);
  }
  object.kind = static_cast<ObjectKind>(kind);
  Ring ring;
  while (reader.left() > 0) {
    const auto x = reader.number<double>();
    if (x == kRingEnd) {
      object.rings.push_back(std::exchange(ring, {}));
      continue;
    }
    ring.emplace_back(x, reader.number<double>());
  }
  if (reader.failed() || !ring.empty()) {
    return fail(ErrorCode::kMalformed, "object {} is cut off", id);
  }
  if (const auto sound = check_object(object); !sound) return forward_error(sound);
  return object;
}

}  // namespace nadir
