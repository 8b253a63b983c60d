// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/base/result.h"
#include "widgets/canvas/canvas.h"

namespace nadir {

/// What a PNG says about itself beside its pixels.
struct PngFacts {
  double dpi = 0.0;  ///< Pixels per inch; 0: not said.
  std::map<std::string, std::string>
      texts;  ///< Keyword (1 to 79 Latin letters) to UTF-8 text, as iTXt chunks.
};

/// 24 bits a pixel where all are opaque, else 32. The same pixels and facts give the same bytes.
[[nodiscard]] std::string encode_png(const Raster<Rgba>& pixels, const PngFacts& facts = {});

/// The texts of a PNG file. @errors kNotFound, kMalformed (not a PNG, cut short, a damaged chunk).
[[nodiscard]] Result<std::map<std::string, std::string>> read_png_texts(
    const std::filesystem::path& path);

/// The same of the bytes of a file; `name` stands for it in messages.
[[nodiscard]] Result<std::map<std::string, std::string>> parse_png_texts(std::string_view bytes,
                                                                         const std::string& name);

}  // namespace nadir
