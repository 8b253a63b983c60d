// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/mcl/cell_agreement.h"
#include "core/topview/semantic_topview.h"
#include "widgets/views/legend.h"
#include "widgets/views/raster_view.h"
#include "widgets/views/theme.h"

namespace nadir {

/// Where the upper left corner of a topview's raster lies when the topview is laid at a pose, as RasterView::show wants
/// it: its rows run to the right of the heading.
[[nodiscard]] Rigid2 enu_from_topview_corner(const Rigid2& enu_from_body,
                                             const TopviewRaster& raster,
                                             double metres_per_cell);

/// Cells of a topview that agree with the map and that do not, in the theme's two colours, on the topview's raster. What
/// disagrees has dark stripes across its cells, so that it is told apart in greyscale too; what the map does not know is
/// grey; what was not seen is clear.
/// @param agreement  Of the same topview.
[[nodiscard]] Raster<Rgba> agreement_picture(const SemanticTopview& seen,
                                             const CellAgreement& agreement,
                                             const TopviewRaster& raster,
                                             const Theme& theme);

/// Of the stripes across what disagrees.
[[nodiscard]] Rgba disagreement_stripe(const Theme& theme);

/// "agrees 812 cells (74 %)", "disagrees ...", "not known to the map ...": only those that there are; shares are of all
/// cells that were seen.
[[nodiscard]] std::vector<LegendEntry> agreement_legend(const CellAgreement& agreement,
                                                        const Theme& theme);

/// Lays the agreement of a topview with the map on the ground, where the topview lies at a pose.
class AgreementView {
 public:
  explicit AgreementView(MapScene& scene);

  /// @param agreement  cell_agreement() of this topview at this pose. An empty topview, or a pose that is not finite,
  ///                   shows nothing.
  void show(const SemanticTopview& seen,
            const CellAgreement& agreement,
            const Rigid2& enu_from_body,
            const Theme& theme);
  void set_opacity(double opacity) { raster_.set_opacity(opacity); }
  void set_visible(bool visible);

 private:
  RasterView raster_;
  bool is_visible_ = true;
  bool has_cells_ = false;
};

}  // namespace nadir
