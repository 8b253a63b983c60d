// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/ui_pictures.h"

#include <cstring>

namespace nadir::kit {
namespace {

/// OpenGL's names have 32 bits; what has this one is ours.
constexpr std::uint64_t kOurs = std::uint64_t{1} << 63U;

/// FNV-1a over the pixels and the width.
std::uint64_t fingerprint(const Raster<Rgba>& pixels) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto take = [&hash](std::uint64_t value) { hash = (hash ^ value) * 1099511628211ULL; };
  take(static_cast<std::uint64_t>(pixels.width()));
  for (int row = 0; row < pixels.height(); ++row) {
    for (int column = 0; column < pixels.width(); ++column) {
      const Rgba colour = pixels.at(column, row);
      take((std::uint64_t{colour.red} << 24U) | (std::uint64_t{colour.green} << 16U) |
           (std::uint64_t{colour.blue} << 8U) | colour.alpha);
    }
  }
  return (hash & ~kOurs) | 2U;  // 0 and 1 have meanings
}

UiPictures::Id id_of(std::uint64_t number) {
  UiPictures::Id id = nullptr;
  std::memcpy(&id, &number, sizeof id);
  return id;
}

}  // namespace

UiPictures::Id UiPictures::add(const Raster<Rgba>& pixels) {
  const std::uint64_t number = fingerprint(pixels);
  const auto [there, is_new] = pictures_.try_emplace(number);
  if (is_new) there->second.pixels = pixels;
  there->second.is_used = true;
  return id_of(number | kOurs);
}

void UiPictures::begin_frame() {
  for (auto& [number, picture] : pictures_) picture.is_used = false;
}

void UiPictures::end_frame() {
  std::erase_if(pictures_, [](const auto& entry) { return !entry.second.is_used; });
}

UiPictures::Id UiPictures::font_id() { return id_of(1U | kOurs); }

UiPictures::Id UiPictures::texture_id(std::uint32_t texture) { return id_of(texture); }

std::uint64_t UiPictures::picture_of(Id id) {
  std::uint64_t number = 0;
  std::memcpy(&number, &id, sizeof id);
  return (number & kOurs) == 0 ? 0 : number & ~kOurs;
}

}  // namespace nadir::kit
