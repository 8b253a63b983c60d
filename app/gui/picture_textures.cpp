// SPDX-License-Identifier: Apache-2.0
#include "app/gui/picture_textures.h"

namespace nadir {
namespace {

/// A picture that is made anew each frame would fill the memory with those before: what one frame did not show goes.
constexpr std::uint64_t kFramesKept = 1;

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

std::size_t PictureTextures::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [pixels, kept] : kept_) bytes += 2 * pixels->size() * sizeof(Rgba);
  return bytes;
}

void PictureTextures::end_frame() {
  ++frame_;
  std::erase_if(
      kept_, [this](const auto& entry) { return entry.second.last_used + kFramesKept < frame_; });
}

}  // namespace nadir
