// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace nadir {

static_assert(std::endian::native == std::endian::little,
              "labels.gpkg holds little-endian numbers");

/// Walks over bytes that may be damaged. Private to this module. Beyond the end, reading gives zeros and failed() is true.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <typename Number>
  Number number(bool is_big_endian = false) {
    static_assert(std::is_arithmetic_v<Number>);
    std::array<std::uint8_t, sizeof(Number)> bytes{};
    if (rest_.size() < bytes.size()) {
      fail();
      return Number{};
    }
    std::copy_n(rest_.begin(), bytes.size(), bytes.begin());
    rest_ = rest_.subspan(bytes.size());
    if (is_big_endian) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Number>(bytes);
  }
  /// Seven bits a byte, the lowest first; the top bit says that more follow.
  std::uint64_t varying() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const auto byte = number<std::uint8_t>();
      value |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if ((byte & 0x80U) == 0) return value;
    }
    fail();
    return 0;
  }
  std::span<const std::uint8_t> take(std::uint64_t count) {
    if (count > rest_.size()) {
      fail();
      return {};
    }
    const auto taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(static_cast<std::size_t>(count));
    return taken;
  }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }
  [[nodiscard]] bool failed() const { return has_failed_; }

 private:
  void fail() {
    has_failed_ = true;
    rest_ = {};
  }
  std::span<const std::uint8_t> rest_;
  bool has_failed_ = false;
};

template <typename Number>
void append_number(std::vector<std::uint8_t>& bytes, Number value) {
  static_assert(std::is_arithmetic_v<Number>);
  const auto raw = std::bit_cast<std::array<std::uint8_t, sizeof(Number)>>(value);
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

inline void append_varying(std::vector<std::uint8_t>& bytes, std::uint64_t value) {
  for (; value >= 0x80U; value >>= 7U) {
    bytes.push_back(static_cast<std::uint8_t>(value & 0x7FU) | 0x80U);
  }
  bytes.push_back(static_cast<std::uint8_t>(value));
}

}  // namespace nadir
