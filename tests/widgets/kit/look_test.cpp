// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <imgui.h>

#include <fstream>

#include "widgets/kit/ui_fonts.h"
#include "widgets/kit/ui_look.h"
#include "widgets/kit/ui_pictures.h"

namespace nadir::kit {
namespace look_test {

Rgba unpacked(std::uint32_t colour) {
  return {static_cast<std::uint8_t>(colour), static_cast<std::uint8_t>(colour >> 8U),
          static_cast<std::uint8_t>(colour >> 16U), static_cast<std::uint8_t>(colour >> 24U)};
}

TEST(Contrast, IsThatOfTheStandard) {
  EXPECT_DOUBLE_EQ(contrast({0, 0, 0}, {255, 255, 255}), 21.0);
  EXPECT_DOUBLE_EQ(contrast({80, 80, 80}, {80, 80, 80}), 1.0);
  EXPECT_NEAR(contrast({118, 118, 118}, {255, 255, 255}), 4.54, 0.01);
}

TEST(Looks, CanBeReadEverywhere) {
  for (const ThemeName name : {ThemeName::kLight, ThemeName::kDark}) {
    const Look look = look_of(theme(name));
    for (const std::uint32_t ground : {look.window, look.panel, look.raised, look.hovered}) {
      EXPECT_GE(contrast(unpacked(look.text), unpacked(ground)), 4.5) << enum_name(name);
    }
    for (const std::uint32_t words : {look.muted, look.good, look.warning, look.bad, look.accent}) {
      EXPECT_GE(contrast(unpacked(words), unpacked(look.panel)), 4.5) << enum_name(name);
    }
    EXPECT_GE(contrast(unpacked(look.on_accent), unpacked(look.accent)), 4.5);
    const Rgba chosen =
        mixed(theme(name).page, theme(name).accent, unpacked(look.accent_soft).alpha / 255.0);
    EXPECT_GE(contrast(unpacked(look.text), chosen), 4.5);
  }
}

TEST(Looks, AreTheThemesAndTheDarkRaisesByLightness) {
  const Look dark = look_of(theme(ThemeName::kDark));
  EXPECT_EQ(unpacked(dark.panel), theme(ThemeName::kDark).page);
  EXPECT_GT(unpacked(dark.raised).red, unpacked(dark.panel).red);
  EXPECT_EQ(unpacked(dark.plate).alpha, 217);
  const Look light = look_of(theme(ThemeName::kLight));
  EXPECT_EQ(light.raised, light.panel);
}

TEST(Looks, ScaleTheirSizes) {
  ImGuiStyle style;
  set_style(style, look_of(theme(ThemeName::kDark)), 1.5);
  EXPECT_EQ(style.WindowPadding.x, 18.0F);
  EXPECT_EQ(style.FrameRounding, 6.0F);
  EXPECT_EQ(style.FrameBorderSize, 0.0F);
}

TEST(Fonts, HaveTheSizeOfTheEm) {
  for (const double scale : {0.75, 1.0, 2.0}) {
    const FontSet fonts(scale);
    EXPECT_EQ(fonts.em_px(fonts.text), 15.0 * scale);
    EXPECT_EQ(fonts.em_px(fonts.numbers), 14.0 * scale);
    for (ImFont* const font : {fonts.text, fonts.small_text}) {
      TextStyle style;
      style.size_px = fonts.em_px(font);
      const double figures = measure_text("Localiser", style).width;
      const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0F, "Localiser").x;
      EXPECT_NEAR(width, figures, font == fonts.text ? 0.03 * figures : 0.1);
    }
  }
}

TEST(Fonts, HaveTheIconsAmongTheLetters) {
  const FontSet fonts(1.0);
  EXPECT_NE(fonts.text->FindGlyphNoFallback(0xF04B), nullptr);
  EXPECT_NE(fonts.semibold->FindGlyphNoFallback(0xF002), nullptr);
  for (const ImWchar sign : {ImWchar{0x2026}, ImWchar{0x00B0}, ImWchar{0x03C3}, ImWchar{0x00D7},
                             ImWchar{0x2013}, ImWchar{0x00B7}}) {
    EXPECT_NE(fonts.text->FindGlyphNoFallback(sign), nullptr) << static_cast<int>(sign);
  }
}

TEST(Fonts, OfOneScaleAreMadeOnce) {
  const auto first = FontSet::of_scale(1.25);
  EXPECT_EQ(FontSet::of_scale(1.25), first);
  EXPECT_NE(FontSet::of_scale(1.0), first);
}

TEST(Fonts, ThatAreMissingAreReplaced) {
  EXPECT_FALSE(font_file("No Such Family At All", 80).empty());
  EXPECT_EQ(line_height_per_em("no font"), 1.0);
  EXPECT_EQ(line_height_per_em(""), 1.0);
  EXPECT_EQ(line_height_per_em(std::string(64, '\xFF')), 1.0);
}

TEST(Fonts, ArePickedBySizeAndFace) {
  const FontSet fonts(1.0);
  TextStyle style;
  style.size_px = 10.0;
  EXPECT_EQ(fonts.for_style(style), fonts.small_text);
  style.size_px = 20.0;
  EXPECT_EQ(fonts.for_style(style), fonts.text);
  style.is_bold = true;
  EXPECT_EQ(fonts.for_style(style), fonts.small_bold);
  style.face = FontFace::kNumbers;
  EXPECT_EQ(fonts.for_style(style), fonts.numbers);
}

TEST(Pictures, AreKeptForAsLongAsFramesShowThem) {
  UiPictures pictures;
  const Raster<Rgba> red(3, 2, {255, 0, 0});
  pictures.begin_frame();
  const auto id = pictures.add(red);
  EXPECT_EQ(pictures.add(Raster<Rgba>(2, 3, {255, 0, 0})) == id, false) << "another shape";
  pictures.end_frame();
  EXPECT_EQ(pictures.all().size(), 2U);
  EXPECT_EQ(pictures.all().at(UiPictures::picture_of(id)).pixels, red);
  pictures.begin_frame();
  EXPECT_EQ(pictures.add(red), id);
  pictures.end_frame();
  EXPECT_EQ(pictures.all().size(), 1U);
}

TEST(Pictures, AreToldFromTexturesOfOpenGl) {
  EXPECT_EQ(UiPictures::picture_of(UiPictures::texture_id(7)), 0U);
  EXPECT_EQ(UiPictures::picture_of(UiPictures::font_id()), 1U);
}

}  // namespace look_test
}  // namespace nadir::kit
