// SPDX-License-Identifier: Apache-2.0
#include "core/base/hash.h"

#include <fmt/core.h>

namespace nadir {

Hash& Hash::add(const void* data, std::size_t bytes) {
  constexpr std::uint64_t kPrime = 0x100000001B3ULL;
  const auto* byte = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < bytes; ++i) value_ = (value_ ^ byte[i]) * kPrime;
  return *this;
}

std::string Hash::text() const { return fmt::format("{:016x}", value_); }

}  // namespace nadir
