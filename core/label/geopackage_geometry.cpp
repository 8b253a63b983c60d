// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "core/label/byte_reader.h"
#include "core/label/label_blobs.h"

namespace nadir {
namespace {

// OGC 12-128r15, 2.1.3: "GP", version 0, flags (bit 0: little endian, bits 1 to 3: which envelope, bit 4: empty), number of
// the reference system, envelope; then ISO well-known binary.
constexpr std::uint8_t kFlags =
    1U | 1U << 1U;  // Little endian, with minimum and maximum of x and y.
constexpr std::uint32_t kLineString = 2, kPolygon = 3, kMultiLineString = 5, kMultiPolygon = 6,
                        kCollection = 7;
constexpr int kMostNesting = 8;

std::uint32_t count_of(std::size_t count) { return static_cast<std::uint32_t>(count); }

void append_point(Bytes& bytes, const Eigen::Vector2d& point) {
  append_number(bytes, point.x());
  append_number(bytes, point.y());
}

/// Reads well-known binary into parts.
class WkbReader {
 public:
  explicit WkbReader(ByteSpan bytes) : reader_(bytes) {}

  Result<std::vector<GeometryPart>> read() {
    read_geometry(0);
    if (reader_.failed()) return fail(ErrorCode::kMalformed, "its geometry is cut off");
    if (is_strange_) return fail(ErrorCode::kMalformed, "its geometry is neither line nor area");
    return std::move(parts_);
  }

 private:
  void read_geometry(int depth) {
    const bool is_big_endian = reader_.number<std::uint8_t>() == 0;
    auto type = reader_.number<std::uint32_t>(is_big_endian);
    // Thousands tell of heights (1), measures (2) or both (3).
    const std::uint32_t thousands = type / 1000;
    if (thousands > 3) {
      is_strange_ = true;
      return;
    }
    const std::size_t numbers = thousands == 0 ? 2 : thousands == 3 ? 4 : 3;
    type %= 1000;
    if (type == kLineString) {
      parts_.push_back({false, {read_points(is_big_endian, numbers)}});
    } else if (type == kPolygon) {
      GeometryPart part{true, {}};
      const auto rings = reader_.number<std::uint32_t>(is_big_endian);
      for (std::uint32_t i = 0; i < rings && !reader_.failed(); ++i) {
        part.rings.push_back(read_points(is_big_endian, numbers));
        Ring& ring = part.rings.back();
        if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
      }
      parts_.push_back(std::move(part));
    } else if ((type == kMultiLineString || type == kMultiPolygon || type == kCollection) &&
               depth < kMostNesting) {
      const auto members = reader_.number<std::uint32_t>(is_big_endian);
      for (std::uint32_t i = 0; i < members && !reader_.failed() && !is_strange_; ++i) {
        read_geometry(depth + 1);
      }
    } else {
      is_strange_ = true;
    }
  }

  Ring read_points(bool is_big_endian, std::size_t numbers) {
    const auto count = reader_.number<std::uint32_t>(is_big_endian);
    Ring ring;
    ring.reserve(std::min<std::size_t>(count, reader_.left() / (numbers * sizeof(double))));
    for (std::uint32_t i = 0; i < count && !reader_.failed(); ++i) {
      const auto x = reader_.number<double>(is_big_endian);
      const auto y = reader_.number<double>(is_big_endian);
      for (std::size_t k = 2; k < numbers; ++k) reader_.number<double>(is_big_endian);
      ring.emplace_back(x, y);
    }
    return ring;
  }

  ByteReader reader_;
  std::vector<GeometryPart> parts_;
  bool is_strange_ = false;
};

}  // namespace

Bytes geopackage_geometry(const LabelObject& object, std::int32_t srs_id) {
  const bool is_line = object.kind == ObjectKind::kLine;
  PlaneBounds bounds;
  for (const Ring& ring : object.rings) {
    for (const Eigen::Vector2d& point : ring) bounds.include(point);
  }
  Bytes bytes{'G', 'P', 0, kFlags};
  append_number(bytes, srs_id);
  append_number(bytes, bounds.low.x());
  append_number(bytes, bounds.high.x());
  append_number(bytes, bounds.low.y());
  append_number(bytes, bounds.high.y());
  bytes.push_back(1);  // Little endian.
  append_number(bytes, is_line ? kLineString : kPolygon);
  if (!is_line) append_number(bytes, count_of(object.rings.size()));
  for (const Ring& ring : object.rings) {
    const bool is_open = !is_line && ring.front() != ring.back();
    append_number(bytes, count_of(ring.size() + (is_open ? 1 : 0)));
    for (const Eigen::Vector2d& point : ring) append_point(bytes, point);
    if (is_open) append_point(bytes, ring.front());
  }
  return bytes;
}

Result<std::vector<GeometryPart>> parts_of_geometry(ByteSpan geometry) {
  ByteReader reader(geometry);
  const bool is_marked =
      reader.number<std::uint8_t>() == 'G' && reader.number<std::uint8_t>() == 'P';
  reader.number<std::uint8_t>();
  const auto flags = reader.number<std::uint8_t>();
  reader.number<std::int32_t>();
  constexpr std::array<std::uint64_t, 5> kEnvelopeNumbers{0, 4, 6, 6, 8};
  const std::size_t envelope = flags >> 1U & 7U;
  if (!is_marked || envelope >= kEnvelopeNumbers.size()) {
    return fail(ErrorCode::kMalformed, "its geometry is no GeoPackage geometry");
  }
  reader.take(kEnvelopeNumbers.at(envelope) * sizeof(double));
  if (reader.failed()) return fail(ErrorCode::kMalformed, "its geometry is cut off");
  return WkbReader(reader.take(reader.left())).read();
}

}  // namespace nadir
