// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/ui_fonts.h"

#include <fontconfig/fontconfig.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

#include "widgets/canvas/fonts.h"
#include "widgets/kit/ui_pictures.h"

namespace nadir::kit {
namespace {

/// Letters of Europe, Greek, and the signs of measuring: first and last of each range.
constexpr std::array<ImWchar, 23> kGlyphs = {
    0x0020, 0x017F, 0x0391, 0x03C9, 0x2010, 0x2027, 0x2030, 0x203A, 0x2070, 0x208E, 0x20AC, 0x20AC,
    0x2190, 0x2199, 0x2202, 0x221E, 0x2248, 0x2265, 0x25B2, 0x25CF, 0x2605, 0x2606, 0};
constexpr std::array<ImWchar, 3> kIcons = {0xF000, 0xF2E0, 0};
constexpr std::array<ImWchar, 5> kSmallGlyphs = {0x0020, 0x017F, 0x2010, 0x2265, 0};

struct FreeFontPattern {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
using FontPattern = std::unique_ptr<FcPattern, FreeFontPattern>;

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

unsigned word_at(const std::string& bytes, std::size_t at) {
  if (at + 2 > bytes.size()) return 0;
  return static_cast<unsigned char>(bytes[at]) * 256U + static_cast<unsigned char>(bytes[at + 1]);
}

int signed_word_at(const std::string& bytes, std::size_t at) {
  return static_cast<std::int16_t>(word_at(bytes, at));
}

/// Where a table of an OpenType file begins; 0 where there is none.
std::size_t table_at(const std::string& bytes, const char* tag) {
  const unsigned tables = word_at(bytes, 4);
  for (unsigned i = 0; i < tables; ++i) {
    const std::size_t entry = 12 + 16 * static_cast<std::size_t>(i);
    if (bytes.compare(entry > bytes.size() ? bytes.size() : entry, 4, tag) == 0) {
      return word_at(bytes, entry + 8) * std::size_t{65536} + word_at(bytes, entry + 10);
    }
  }
  return 0;
}

/// Whether Dear ImGui's reader takes it: one font in the file, TrueType or OpenType.
bool is_readable(const std::string& bytes) {
  return bytes.compare(0, 4, std::string("\0\1\0\0", 4)) == 0 || bytes.compare(0, 4, "OTTO") == 0 ||
         bytes.compare(0, 4, "true") == 0;
}

void add_font_bytes(ImFontAtlas& atlas,
                    const std::string& bytes,
                    ImFontConfig& config,
                    double size_px,
                    const ImWchar* ranges) {
  void* const copy = ImGui::MemAlloc(bytes.size());  // the atlas frees it
  std::memcpy(copy, bytes.data(), bytes.size());
  atlas.AddFontFromMemoryTTF(copy, static_cast<int>(bytes.size()), static_cast<float>(size_px),
                             &config, ranges);
}

}  // namespace

std::string font_file(const std::string& family, int fontconfig_weight) {
  const FontPattern wanted(FcPatternCreate());
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, fontconfig_weight);
  FcPatternAddInteger(wanted.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcPatternAddBool(wanted.get(), FC_OUTLINE, FcTrue);
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult outcome = FcResultNoMatch;
  const FontPattern match(FcFontMatch(nullptr, wanted.get(), &outcome));
  FcChar8* file = nullptr;
  if (!match || FcPatternGetString(match.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(file);
}

double line_height_per_em(const std::string& font_bytes) {
  const std::size_t head = table_at(font_bytes, "head");
  const std::size_t hhea = table_at(font_bytes, "hhea");
  const unsigned units_per_em = head == 0 ? 0 : word_at(font_bytes, head + 18);
  if (hhea == 0 || units_per_em == 0) return 1.0;
  const int height = signed_word_at(font_bytes, hhea + 4) - signed_word_at(font_bytes, hhea + 6);
  return height <= 0 ? 1.0 : static_cast<double>(height) / units_per_em;
}

FontSet::FontSet(double scale) : scale_(scale), atlas_(std::make_unique<ImFontAtlas>()) {
  atlas_->FontBuilderIO =
      ImFontAtlasGetBuilderForStbTruetype();  // widths are not rounded: as in figures
  atlas_->Flags |= ImFontAtlasFlags_NoBakedLines | ImFontAtlasFlags_NoMouseCursors;
  atlas_->TexDesiredWidth = 2048;
  atlas_->TexGlyphPadding = 1;
  text = add(FontFace::kText, FC_WEIGHT_REGULAR, 15.0);
  semibold = add(FontFace::kText, FC_WEIGHT_DEMIBOLD, 15.0);
  numbers = add(FontFace::kNumbers, FC_WEIGHT_REGULAR, 14.0);
  // The weights that Cairo takes for normal and bold, so that maps and charts look as they do in figures.
  small_text = add(FontFace::kText, FC_WEIGHT_MEDIUM, 12.0);
  small_bold = add(FontFace::kText, FC_WEIGHT_BOLD, 12.0);
  small_numbers = add(FontFace::kNumbers, FC_WEIGHT_MEDIUM, 12.0);
  atlas_->Build();
  atlas_->SetTexID(UiPictures::font_id());
}

FontSet::~FontSet() = default;

ImFont* FontSet::add(FontFace face, int weight, double em_px) {
  const double em = em_px * scale_;
  ImFontConfig config;
  config.OversampleH = scale_ < 1.9 ? 2 : 1;
  config.OversampleV = 1;
  const bool is_small = em_px < 14.0;
  const std::string bytes = bytes_of(font_file(font_family(face), weight));
  ImFont* made = nullptr;
  if (is_readable(bytes)) {
    add_font_bytes(*atlas_, bytes, config, em * line_height_per_em(bytes),
                   is_small ? kSmallGlyphs.data() : kGlyphs.data());
    made = atlas_->Fonts.back();
  } else {
    config.SizePixels = static_cast<float>(std::max(8.0, std::floor(em)));
    made = atlas_->AddFontDefault(&config);
  }
  if (!is_small && face == FontFace::kText) {
    const std::string icons = font_file("forkawesome", FC_WEIGHT_REGULAR);
    if (const std::string icon_bytes = bytes_of(icons);
        icons.find("awesome") != std::string::npos && is_readable(icon_bytes)) {
      ImFontConfig merged;
      merged.MergeMode = true;
      merged.OversampleH = merged.OversampleV = 1;
      merged.PixelSnapH = true;
      merged.GlyphOffset.y = static_cast<float>(std::floor(scale_ + 0.5));
      add_font_bytes(*atlas_, icon_bytes, merged, em * line_height_per_em(icon_bytes),
                     kIcons.data());
    }
  }
  ems_.push_back({made, em});
  return made;
}

std::shared_ptr<FontSet> FontSet::of_scale(double scale) {
  // Making one takes time, and it is never changed. The one made last is kept even if nobody uses it: tests open and close many.
  static std::map<double, std::weak_ptr<FontSet>> shared;
  static std::shared_ptr<FontSet> last;
  std::erase_if(shared, [](const auto& entry) { return entry.second.expired(); });
  if (auto there = shared[scale].lock()) return there;
  auto made = std::make_shared<FontSet>(scale);
  shared[scale] = made;
  last = made;
  return made;
}

double FontSet::em_px(const ImFont* font) const {
  for (const auto& [each, em] : ems_) {
    if (each == font) return em;
  }
  return font->FontSize;
}

ImFont* FontSet::for_style(const TextStyle& style) const {
  const bool is_small = style.size_px <= 12.5 * scale_;
  if (style.face == FontFace::kNumbers) return is_small ? small_numbers : numbers;
  if (style.is_bold) return small_bold;
  return is_small ? small_text : text;
}

Raster<Rgba> FontSet::pixels() const {
  unsigned char* alpha = nullptr;
  int width = 0;
  int height = 0;
  atlas_->GetTexDataAsAlpha8(&alpha, &width, &height);
  Raster<Rgba> made(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      made.at(column, row) = {255, 255, 255,
                              alpha[static_cast<std::ptrdiff_t>(row) * width + column]};
    }
  }
  return made;
}

}  // namespace nadir::kit
