// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/base/raster.h"
#include "widgets/canvas/canvas.h"

namespace nadir {

/// Pixels as a texture of the OpenGL context that is current, for a window to show. That context must be current whenever this
/// is used and when it goes.
class PictureTexture {
 public:
  PictureTexture() = default;
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  /// Uploads; whatever texture was bound stays so. @param is_smooth  Mixed between pixels when enlarged; false for classes.
  /// @returns the texture's name, rows from the top; 0 for an empty raster.
  std::uint32_t show(const Raster<Rgba>& pixels, bool is_smooth);
  [[nodiscard]] std::uint32_t texture() const { return texture_; }

 private:
  std::uint32_t texture_ = 0;
};

}  // namespace nadir
