// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/class_pictures.h"

#include <algorithm>
#include <array>

#include "core/base/require.h"

namespace nadir {

Raster<Rgba> class_picture(const Raster<ClassId>& labels) {
  std::array<Rgba, 256> colours{};
  for (int id = 0; id < 256; ++id) {
    colours.at(static_cast<std::size_t>(id)) = class_colour(static_cast<ClassId>(id));
  }
  Raster<Rgba> picture(labels.width(), labels.height());
  std::transform(labels.values().begin(), labels.values().end(), picture.values().begin(),
                 [&colours](ClassId id) { return colours[id]; });
  return picture;
}

Raster<Rgba> colour_picture(const ColourRaster& colours) {
  Raster<Rgba> picture(colours.width(), colours.height());
  std::transform(colours.values().begin(), colours.values().end(), picture.values().begin(),
                 [](const Colour& colour) {
                   return Rgba{colour.red, colour.green, colour.blue};
                 });
  return picture;
}

Raster<Rgba> agreement_picture(const SemanticTopview& seen,
                               const CellAgreement& agreement,
                               const TopviewRaster& raster,
                               const Theme& theme) {
  NADIR_REQUIRE(agreement.of_cell.size() == seen.cells.size());
  Raster<Rgba> picture(raster.labels.width(), raster.labels.height(), {0, 0, 0, 0});
  for (std::size_t i = 0; i < seen.cells.size(); ++i) {
    const int column = raster.body_column - 1 - seen.cells[i].left;
    const int row = raster.body_row - 1 - seen.cells[i].forward;
    if (!picture.contains(column, row)) continue;
    switch (agreement.of_cell[i]) {
      case CellVerdict::kAgrees:
        picture.at(column, row) = theme.agreement;
        break;
      case CellVerdict::kDisagrees:
        picture.at(column, row) = theme.disagreement;
        break;
      case CellVerdict::kUnknown:
        picture.at(column, row) = theme.line;
        break;
    }
  }
  return picture;
}

PageRect fitted(double width, double height, const PageRect& inside) {
  const double scale = std::min(inside.width / width, inside.height / height);
  const double w = width * scale;
  const double h = height * scale;
  return {inside.left + (inside.width - w) / 2.0, inside.bottom + (inside.height - h) / 2.0, w, h};
}

}  // namespace nadir
