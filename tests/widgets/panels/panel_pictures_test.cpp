// SPDX-License-Identifier: Apache-2.0
// What panels look like as pixels. With NADIR_PICTURES set to a folder, the pictures are kept there to be looked at.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "tests/widgets/panels/panel_scenes.h"
#include "widgets/canvas/png_file.h"

namespace nadir {
namespace panel_pictures_test {

/// Relative luminance as WCAG 2.1 has it.
double luminance(const Rgba& colour) {
  const auto linear = [](std::uint8_t channel) {
    const double share = channel / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

/// The strongest contrast of any two pixels within a rectangle of the window: of letters on what they stand on.
double contrast_within(const Raster<Rgba>& picture, const kit::Rect& rect) {
  double least = 1.0, most = 0.0;
  const int right = std::min(picture.width(), static_cast<int>(rect.right()));
  const int bottom = std::min(picture.height(), static_cast<int>(rect.bottom()));
  for (int row = std::max(0, static_cast<int>(rect.top)); row < bottom; ++row) {
    for (int column = std::max(0, static_cast<int>(rect.left)); column < right; ++column) {
      const double value = luminance(picture.at(column, row));
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  return (most + 0.05) / (least + 0.05);
}

class PanelPictures : public testing::TestWithParam<PanelLook> {};

TEST_P(PanelPictures, EveryTextInSightIsLegibleAndInsideTheWindow) {
  UiCamera camera;
  const char* const kept = std::getenv("NADIR_PICTURES");
  for (const PanelScene& scene : panel_scenes()) {
    const SeenScene seen = see(scene, GetParam(), camera);
    if (kept != nullptr) {
      const std::string name = fmt::format("{}/{}-{}-{}.png", kept, scene.name,
                                           enum_name(GetParam().theme), GetParam().scale);
      std::ofstream(name, std::ios::binary) << encode_png(seen.cut_out);
    }
    for (const kit::Control& control : seen.controls) {
      if (control.kind != kit::ControlKind::kText || !control.is_visible || !control.is_enabled)
        continue;
      if (control.label == "dot") continue;
      EXPECT_GE(contrast_within(seen.picture, control.rect), 4.0)
          << scene.name << ": " << control.path;
      EXPECT_LE(control.rect.right(), seen.picture.width()) << scene.name << ": " << control.path;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Looks, PanelPictures, testing::ValuesIn(panel_looks()));

}  // namespace panel_pictures_test
}  // namespace nadir
