// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "widgets/gl/picture_texture.h"
#include "widgets/panels/picture.h"

namespace nadir {

/// Textures of the pictures that panels show, uploaded when they are asked for first and let go at the end of a frame in which
/// nobody has asked for them. The context that the window draws with must be current whenever this is used.
class PictureTextures {
 public:
  /// @returns 0 for no picture.
  [[nodiscard]] kit::TextureId of(const Picture& picture);
  /// Once a frame, after everything has been asked for.
  void end_frame();
  [[nodiscard]] std::size_t count() const { return kept_.size(); }
  /// Of the pictures that are kept, in main memory and as textures.
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Kept {
    std::shared_ptr<const Raster<Rgba>> pixels;  ///< So that no other picture gets its address.
    PictureTexture texture;
    std::uint64_t last_used = 0;
  };
  std::map<const Raster<Rgba>*, Kept> kept_;
  std::uint64_t frame_ = 0;
};

}  // namespace nadir
