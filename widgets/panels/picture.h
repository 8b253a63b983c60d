// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "core/base/raster.h"
#include "widgets/canvas/canvas.h"
#include "widgets/kit/ui_parts.h"

namespace nadir {

/// A picture that a panel has made and wants to show. It never changes: another picture is another pointer.
struct Picture {
  std::shared_ptr<const Raster<Rgba>> pixels;  ///< Null: there is none.
  bool is_smooth =
      false;  ///< Colours between pixels are mixed; false for anything that shows classes or cells.
  [[nodiscard]] explicit operator bool() const { return pixels != nullptr && !pixels->empty(); }
  friend bool operator==(const Picture&, const Picture&) = default;
};

/// Gives the texture of a picture; uploads it when it is asked for first. The window keeps textures by the pointer and lets
/// go of those that nobody has asked for in a while. It may be left empty: then pictures are drawn by the canvas, which
/// compares all their pixels with the last frame's.
using TextureOf = std::function<kit::TextureId(const Picture&)>;

}  // namespace nadir
