// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "widgets/canvas/canvas.h"

struct ImFont;
struct ImFontAtlas;

namespace nadir::kit {

/// The fonts of the interface at one scale, in one picture. Text is 15 px of the em, numbers are 14, the small sizes are for
/// maps and charts, which draw all sizes from the nearest that is larger.
class FontSet {
 public:
  /// Asks fontconfig for the families that figures use, with icons among the letters of each; what is not installed is drawn with what
  /// the system puts in its place, and without any font at all with Dear ImGui's own.
  explicit FontSet(double scale);
  ~FontSet();
  FontSet(const FontSet&) = delete;
  FontSet& operator=(const FontSet&) = delete;

  /// The one of a scale, shared by all contexts that live at this moment.
  [[nodiscard]] static std::shared_ptr<FontSet> of_scale(double scale);

  ImFont* text = nullptr;
  ImFont* semibold = nullptr;
  ImFont* numbers = nullptr;
  ImFont* small_text = nullptr;
  ImFont* small_bold = nullptr;
  ImFont* small_numbers = nullptr;

  /// Pixels of the em that a font was made for.
  [[nodiscard]] double em_px(const ImFont* font) const;
  /// The one that draws a style best.
  [[nodiscard]] ImFont* for_style(const TextStyle& style) const;
  [[nodiscard]] ImFontAtlas& atlas() const { return *atlas_; }
  /// 8 bits of coverage a pixel.
  [[nodiscard]] Raster<Rgba> pixels() const;

 private:
  ImFont* add(FontFace face, int weight, double em_px);

  double scale_;
  std::unique_ptr<ImFontAtlas> atlas_;
  std::vector<std::pair<ImFont*, double>> ems_;
};

/// The file of a family, as fontconfig matches it; empty where there is none.
[[nodiscard]] std::string font_file(const std::string& family, int fontconfig_weight);

/// How many pixels Dear ImGui must be asked for so that the em has one: it counts from the ascender to the descender.
[[nodiscard]] double line_height_per_em(const std::string& font_bytes);

}  // namespace nadir::kit
