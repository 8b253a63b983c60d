// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/agreement_view.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/base/require.h"

namespace nadir {
namespace {

/// Cells from one dark stripe to the next, along rows and columns; half of them are dark.
constexpr int kStripeCells = 4;

Rgba darkened(Rgba colour) {
  const auto half = [](std::uint8_t channel) { return static_cast<std::uint8_t>(channel / 2); };
  return {half(colour.red), half(colour.green), half(colour.blue), colour.alpha};
}

}  // namespace

Rgba disagreement_stripe(const Theme& theme) { return darkened(theme.disagreement); }

Rigid2 enu_from_topview_corner(const Rigid2& enu_from_body,
                               const TopviewRaster& raster,
                               double metres_per_cell) {
  const Rigid2 body_from_corner{metres_per_cell * raster.body_row,
                                metres_per_cell * raster.body_column, -std::numbers::pi / 2.0};
  return enu_from_body * body_from_corner;
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
    const bool is_dark_stripe = (column + row) % kStripeCells < kStripeCells / 2;
    switch (agreement.of_cell[i]) {
      case CellVerdict::kAgrees:
        picture.at(column, row) = theme.agreement;
        break;
      case CellVerdict::kDisagrees:
        picture.at(column, row) = is_dark_stripe ? disagreement_stripe(theme) : theme.disagreement;
        break;
      case CellVerdict::kUnknown:
        picture.at(column, row) = theme.line;
        break;
    }
  }
  return picture;
}

std::vector<LegendEntry> agreement_legend(const CellAgreement& agreement, const Theme& theme) {
  const CellAgreement::Count total = agreement.total();
  const double all = static_cast<double>(agreement.of_cell.size());
  std::vector<LegendEntry> entries;
  const auto add = [&](const char* name, std::uint32_t cells, Rgba colour, LegendEntry::Kind kind) {
    if (cells == 0) return;
    entries.push_back(
        {fmt::format("{} {} cells ({:.0f} %)", name, cells, 100.0 * cells / all), colour, kind});
  };
  add("agrees", total.agreeing, theme.agreement, LegendEntry::Kind::kBar);
  add("disagrees", total.disagreeing, theme.disagreement, LegendEntry::Kind::kStripedBar);
  if (!entries.empty() && entries.back().kind == LegendEntry::Kind::kStripedBar) {
    entries.back().casing = disagreement_stripe(theme);
  }
  add("not known to the map", total.unknown, theme.line, LegendEntry::Kind::kBar);
  return entries;
}

AgreementView::AgreementView(MapScene& scene) : raster_(scene, MapLayer::kAgreement) {
  set_visible(true);
}

void AgreementView::show(const SemanticTopview& seen,
                         const CellAgreement& agreement,
                         const Rigid2& enu_from_body,
                         const Theme& theme) {
  NADIR_REQUIRE(agreement.of_cell.size() == seen.cells.size());
  has_cells_ = !seen.cells.empty() && enu_from_body.translation_m().allFinite() &&
               std::isfinite(enu_from_body.yaw_rad);
  if (has_cells_) {
    const TopviewRaster raster = topview_raster(seen);
    raster_.show(agreement_picture(seen, agreement, raster, theme),
                 enu_from_topview_corner(enu_from_body, raster, seen.metres_per_cell),
                 Eigen::Vector2d::Constant(seen.metres_per_cell), false);
  }
  set_visible(is_visible_);
}

void AgreementView::set_visible(bool visible) {
  is_visible_ = visible;
  raster_.set_visible(is_visible_ && has_cells_);
}

}  // namespace nadir
