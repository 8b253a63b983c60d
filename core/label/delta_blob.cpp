// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <memory>

#include "core/base/zstd.h"
#include "core/label/byte_reader.h"
#include "core/label/label_blobs.h"

namespace nadir {
namespace {

constexpr std::size_t kTileBytes = static_cast<std::size_t>(kPaintTileSide) * kPaintTileSide;
/// Of one text in a delta, so that a damaged length is not allocated: a hundred million places.
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 31U;
/// Shorter ones do not get shorter by packing.
constexpr std::size_t kLeastPacked = 200;

tl::unexpected<Error> damaged(const char* what) {
  return fail(ErrorCode::kMalformed, "{} is damaged", what);
}

Result<Bytes> decompressed(ByteSpan packed, std::uint64_t most_bytes, const char* what) {
  auto raw = zstd_unpacked(packed, most_bytes);
  if (!raw) return damaged(what);
  return std::move(*raw);
}

Result<Bytes> decompressed_tile(ByteSpan packed, const char* what) {
  auto raw = decompressed(packed, kTileBytes, what);
  if (raw && raw->size() != kTileBytes) return damaged(what);
  return raw;
}

/// A delta read from its bytes: how much is common at the beginning and at the end, and what lies between.
struct Difference {
  std::uint64_t common_before = 0, common_after = 0;
  Bytes before, after;
};

Result<Difference> difference_of(ByteSpan delta) {
  constexpr const char* kWhat = "a step of its history";
  ByteReader packing(delta);
  const auto is_packed = packing.number<std::uint8_t>();
  if (packing.failed() || is_packed > 1) return damaged(kWhat);
  Bytes unpacked;
  ByteSpan content = packing.take(packing.left());
  if (is_packed == 1) {
    auto raw = decompressed(content, 2 * kMostBytes, kWhat);
    if (!raw) return forward_error(raw);
    unpacked = std::move(*raw);
    content = unpacked;
  }
  ByteReader reader(content);
  Difference difference;
  difference.common_before = reader.varying();
  difference.common_after = reader.varying();
  const ByteSpan before = reader.take(reader.varying());
  const ByteSpan after = reader.take(reader.left());
  if (reader.failed()) return damaged(kWhat);
  difference.before.assign(before.begin(), before.end());
  difference.after.assign(after.begin(), after.end());
  return difference;
}

/// Puts one middle in the place of the other.
Result<Bytes> replaced(ByteSpan text,
                       const Difference& difference,
                       ByteSpan expected,
                       ByteSpan wanted) {
  const auto fits = fail(ErrorCode::kMalformed, "its history does not fit what it holds");
  const std::uint64_t from = difference.common_before;
  if (from > text.size() || difference.common_after > text.size() - from ||
      expected.size() != text.size() - from - difference.common_after) {
    return fits;
  }
  const ByteSpan middle = text.subspan(static_cast<std::size_t>(from), expected.size());
  if (!std::equal(middle.begin(), middle.end(), expected.begin())) return fits;
  Bytes result;
  result.reserve(text.size() - expected.size() + wanted.size());
  result.insert(result.end(), text.begin(), middle.begin());
  result.insert(result.end(), wanted.begin(), wanted.end());
  result.insert(result.end(), middle.end(), text.end());
  return result;
}

Result<std::shared_ptr<const PaintTile>> tile_of_bytes(const Bytes& values) {
  if (!std::all_of(values.begin(), values.end(), is_paint_value)) return damaged("its paint");
  auto tile = std::make_shared<PaintTile>();
  std::copy(values.begin(), values.end(), tile->values.begin());
  return tile;
}

}  // namespace

Bytes byte_delta(ByteSpan before, ByteSpan after) {
  const auto [at_before, at_after] =
      std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  const auto common_before = static_cast<std::size_t>(at_before - before.begin());
  const std::size_t most = std::min(before.size(), after.size()) - common_before;
  std::size_t common_after = 0;
  while (common_after < most &&
         before[before.size() - 1 - common_after] == after[after.size() - 1 - common_after]) {
    ++common_after;
  }
  const ByteSpan middle_before =
      before.subspan(common_before, before.size() - common_before - common_after);
  const ByteSpan middle_after =
      after.subspan(common_before, after.size() - common_before - common_after);
  Bytes content;
  append_varying(content, common_before);
  append_varying(content, common_after);
  append_varying(content, middle_before.size());
  content.insert(content.end(), middle_before.begin(), middle_before.end());
  content.insert(content.end(), middle_after.begin(), middle_after.end());
  const bool is_packed = content.size() >= kLeastPacked;
  if (is_packed) content = zstd_packed(content);
  content.insert(content.begin(), is_packed ? 1 : 0);
  return content;
}

Result<Bytes> before_of(ByteSpan delta, ByteSpan after) {
  const auto difference = difference_of(delta);
  if (!difference) return forward_error(difference);
  return replaced(after, *difference, difference->after, difference->before);
}

Result<Bytes> after_of(ByteSpan delta, ByteSpan before) {
  const auto difference = difference_of(delta);
  if (!difference) return forward_error(difference);
  return replaced(before, *difference, difference->before, difference->after);
}

Bytes packed_tile(const PaintTile& tile) { return zstd_packed(tile.values); }

Result<std::shared_ptr<const PaintTile>> unpacked_tile(ByteSpan packed) {
  const auto values = decompressed_tile(packed, "its paint");
  if (!values) return forward_error(values);
  return tile_of_bytes(*values);
}

Bytes tile_delta(const PaintTile* before, const PaintTile* after) {
  Bytes both(kTileBytes);
  for (std::size_t i = 0; i < both.size(); ++i) {
    const PaintValue was = before != nullptr ? before->values[i] : kNoPaint;
    const PaintValue becomes = after != nullptr ? after->values[i] : kNoPaint;
    both[i] = was ^ becomes;
  }
  return zstd_packed(both);
}

Result<std::shared_ptr<const PaintTile>> other_tile(ByteSpan delta, const PaintTile* tile) {
  auto values = decompressed_tile(delta, "a step of its history");
  if (!values) return forward_error(values);
  bool is_blank = true;
  for (std::size_t i = 0; i < values->size(); ++i) {
    (*values)[i] ^= tile != nullptr ? tile->values[i] : kNoPaint;
    is_blank = is_blank && (*values)[i] == kNoPaint;
  }
  if (is_blank) return std::shared_ptr<const PaintTile>();
  return tile_of_bytes(*values);
}

}  // namespace nadir
