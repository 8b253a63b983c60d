// SPDX-License-Identifier: Apache-2.0
#include "core/base/zstd.h"

#include <gmock/gmock.h>

#include <cstddef>
#include <limits>

namespace nadir {
namespace zstd_test {

using Bytes = std::vector<std::uint8_t>;

/// Neither all the same nor without any order.
Bytes made(std::size_t count) {
  Bytes bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(i * i / 7);
  return bytes;
}

TEST(Zstd, GivesBackWhatWasPacked) {
  for (const std::size_t count : {0U, 1U, 200U, 100'000U}) {
    const Bytes content = made(count);
    const Bytes frame = zstd_packed(content);
    EXPECT_EQ(zstd_content_bytes(frame), count);
    EXPECT_EQ(zstd_unpacked(frame, count), content);
  }
  EXPECT_LT(zstd_packed(Bytes(100'000, 7)).size(), 100U);
}

TEST(Zstd, UnpacksNothingLongerThanItMay) {
  const Bytes frame = zstd_packed(made(1000));
  EXPECT_EQ(zstd_unpacked(frame, 999), std::nullopt);
  EXPECT_TRUE(zstd_unpacked(frame, std::numeric_limits<std::uint64_t>::max()));
}

TEST(Zstd, FindsEveryFlippedBit) {
  const Bytes content = made(300), frame = zstd_packed(content);
  for (std::size_t bit = 0; bit < 8 * frame.size(); ++bit) {
    Bytes damaged = frame;
    damaged[bit / 8] = static_cast<std::uint8_t>(damaged[bit / 8] ^ (1U << (bit % 8)));
    const auto unpacked = zstd_unpacked(damaged, content.size());
    EXPECT_TRUE(!unpacked || *unpacked == content) << "bit " << bit;
  }
}

TEST(Zstd, TakesNothingThatIsCutOffAndNoOtherBytes) {
  const Bytes content = made(300), frame = zstd_packed(content);
  for (std::size_t length = 0; length < frame.size(); ++length) {
    EXPECT_EQ(zstd_unpacked(std::span(frame).first(length), 300), std::nullopt) << length;
  }
  EXPECT_EQ(zstd_content_bytes(Bytes()), std::nullopt);
  EXPECT_EQ(zstd_content_bytes(made(100)), std::nullopt);
  EXPECT_EQ(zstd_unpacked(made(100), 1000), std::nullopt);
}

}  // namespace zstd_test
}  // namespace nadir
