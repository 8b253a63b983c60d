// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/base/result.h"

/// The headers of the image formats that labels and depth are made of, looked at before anything is
/// decoded: a file that is cut off, damaged or of another kind is told from its header and
/// checksums, so that no library has to stumble over it. Private to core/flight.
namespace nadir {

struct GreyImageHeader {
  int width = 0;
  int height = 0;
  int bits = 0;                  ///< 8 or 16 a pixel.
  std::size_t pixels_begin = 0;  ///< PGM only: where the first pixel is.
};

[[nodiscard]] bool is_png(std::span<const std::uint8_t> bytes);
[[nodiscard]] bool is_pgm(std::span<const std::uint8_t> bytes);

/// Walks through the parts of a PNG and checks their lengths and checksums. @errors kMalformed: cut
/// off, damaged, in colour, with a palette, or of less than 8 bits (which libraries stretch to
/// 0..255).
[[nodiscard]] Result<GreyImageHeader> check_png(std::span<const std::uint8_t> bytes,
                                                const std::string& name);

/// The same walk for a PNG of any kind, colours, palettes and few bits too.
[[nodiscard]] Result<void> check_any_png(std::span<const std::uint8_t> bytes,
                                         const std::string& name);

/// @errors kMalformed: no header, or fewer pixels than it promises.
[[nodiscard]] Result<GreyImageHeader> check_pgm(std::span<const std::uint8_t> bytes,
                                                const std::string& name);

}  // namespace nadir
