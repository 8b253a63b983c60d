// SPDX-License-Identifier: Apache-2.0
#include "app/gui/picture_textures.h"

namespace nadir {
namespace {

/// A panel that is left and come back to finds its pictures.
constexpr std::uint64_t kFramesKept = 30;

}  // namespace

kit::TextureId PictureTextures::of(const Picture& picture) {
  if (!picture) return 0;
  Kept& kept = kept_[picture.pixels.get()];
  kept.last_used = frame_;
  if (kept.pixels == nullptr) {
    kept.pixels = picture.pixels;
    kept.texture.show(*picture.pixels, picture.is_smooth);
  }
  return kept.texture.texture();
}

void PictureTextures::end_frame() {
  ++frame_;
  std::erase_if(
      kept_, [this](const auto& entry) { return entry.second.last_used + kFramesKept < frame_; });
}

}  // namespace nadir
