// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace nadir {

/// FNV-1a over 64 bits: tells inputs apart in run files. Not cryptographic.
class Hash {
 public:
  Hash& add(const void* data, std::size_t bytes);
  Hash& add(std::string_view text) { return add(text.data(), text.size()); }
  template <typename Number>
  Hash& add_number(Number value) {
    static_assert(std::is_arithmetic_v<Number>);
    return add(&value, sizeof value);
  }
  /// Sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const;

 private:
  std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

}  // namespace nadir
