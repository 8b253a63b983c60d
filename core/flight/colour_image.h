// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/map/overhead_map_file.h"

namespace nadir {

/// What the camera saw, for people to look at: nothing is localised with it. Pixel (0, 0) is the
/// upper left one. A picture shows the camera's whole view and may have another size than its
/// labels.

/// Colours from the bytes of a JPEG or PNG file; `name` stands for the file in messages. Grey
/// images come out grey, 16 bits are cut to 8, and a turn noted in EXIF is not carried out, because
/// labels and depth know nothing of it.
/// @errors kMalformed: empty, cut off, damaged, larger than 16,384 pixels on a side; kUnsupported:
///   no JPEG and no PNG.
[[nodiscard]] Result<ColourRaster> decode_colour_image(std::span<const std::uint8_t> bytes,
                                                       const std::string& name);

/// Reads FlightFrame::image. @errors as above, kNotFound, kIo.
[[nodiscard]] Result<ColourRaster> read_colour_image(const std::filesystem::path& file);

/// JPEG bytes at quality 85. The raster is not empty. The same picture gives the same bytes.
/// @errors kIo: the encoder gave up (out of memory).
[[nodiscard]] Result<std::vector<std::uint8_t>> encode_colour_jpeg(const ColourRaster& image);

/// Whether the bytes begin as a JPEG file does.
[[nodiscard]] bool is_jpeg(std::span<const std::uint8_t> bytes);

}  // namespace nadir
