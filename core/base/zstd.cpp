// SPDX-License-Identifier: Apache-2.0
#include "core/base/zstd.h"

#include <zstd.h>

#include <cstddef>
#include <memory>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr int kCompressionLevel = 1;

}  // namespace

std::vector<std::uint8_t> zstd_packed(std::span<const std::uint8_t> content) {
  struct Freed {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  };
  const std::unique_ptr<ZSTD_CCtx, Freed> context(ZSTD_createCCtx());
  NADIR_REQUIRE(context != nullptr);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kCompressionLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  std::vector<std::uint8_t> frame(ZSTD_compressBound(content.size()));
  const std::size_t size =
      ZSTD_compress2(context.get(), frame.data(), frame.size(), content.data(), content.size());
  NADIR_REQUIRE(ZSTD_isError(size) == 0U);
  frame.resize(size);
  return frame;
}

std::optional<std::uint64_t> zstd_content_bytes(std::span<const std::uint8_t> frame) {
  const unsigned long long size = ZSTD_getFrameContentSize(frame.data(), frame.size());
  if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR) return std::nullopt;
  return size;
}

std::optional<std::vector<std::uint8_t>> zstd_unpacked(std::span<const std::uint8_t> frame,
                                                       std::uint64_t most_bytes) {
  const auto size = zstd_content_bytes(frame);
  if (!size || *size > most_bytes) return std::nullopt;
  std::vector<std::uint8_t> content(static_cast<std::size_t>(*size));
  if (ZSTD_decompress(content.data(), content.size(), frame.data(), frame.size()) !=
      content.size()) {
    return std::nullopt;
  }
  return content;
}

}  // namespace nadir
