// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/map/semantic_classes.h"

namespace nadir {

struct ImageSize {
  int width = 0;
  int height = 0;
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// Class ids from the bytes of an 8-bit grey PNG or PGM (P5) file; `name` stands for the file in
/// messages. Values are ids as they stand: a PGM is not stretched to its maximum, and an id that is
/// no class is an error, because a wrong remap is a fault to see.
/// @errors kMalformed: cut off, damaged, another size or kind of image, an id that is neither a
/// class nor 255.
///   kUnsupported: no PNG and no PGM.
[[nodiscard]] Result<Raster<ClassId>> decode_label_image(std::span<const std::uint8_t> bytes,
                                                         const std::string& name,
                                                         const ImageSize& expected);

/// Depth in metres from the bytes of a 16-bit grey PNG or PGM file. 0 stays 0: no depth there.
/// @param units_per_m  value of one metre: 1000 for millimetres, 5000 in the TUM RGB-D sets.
/// @errors As above.
[[nodiscard]] Result<Raster<float>> decode_depth_image(std::span<const std::uint8_t> bytes,
                                                       const std::string& name,
                                                       const ImageSize& expected,
                                                       double units_per_m);

/// PNG bytes of 8-bit ids, and of 16-bit millimetres: what is not in (0, 65.535] m becomes 0.
/// Lossless, fast rather than small. The raster is not empty. @errors kIo: the encoder gave up (out
/// of memory).
[[nodiscard]] Result<std::vector<std::uint8_t>> encode_label_png(const Raster<ClassId>& labels);
[[nodiscard]] Result<std::vector<std::uint8_t>> encode_depth_png(const Raster<float>& depth_m);

}  // namespace nadir
