// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "core/label/label_document.h"
#include "widgets/views/map_scene.h"
#include "widgets/views/raster_view.h"

namespace nadir {

/// Shows the borders of all objects of a document that are in sight, as thin light lines with a dark casing, so that they are
/// seen on any ground; objects smaller than kLeastObjectPx are left out.
///
/// Lines are drawn by the processor into a picture of the page and some ground around it, which takes a tenth of the time that
/// software rendering takes for 20,000 objects as lines, and moves for nothing: only another zoom, turn or document, or going
/// beyond that ground, draws them anew. Owns its VTK pipeline.
class LabelBordersView final : public SightedView {
 public:
  explicit LabelBordersView(MapScene& scene);
  ~LabelBordersView() override;  ///< Takes its prop out of the scene.
  LabelBordersView(const LabelBordersView&) = delete;
  LabelBordersView& operator=(const LabelBordersView&) = delete;

  /// The lines follow with the next look(). @param document  Null: nothing is shown.
  void show(std::shared_ptr<const LabelDocument> document);
  void set_visible(bool visible);
  void adapt_to(const MapSight& sight) override;
  /// How often lines were drawn: not while the camera only moves a little.
  [[nodiscard]] std::size_t times_drawn() const { return times_drawn_; }

 private:
  MapScene& scene_;
  std::shared_ptr<const LabelDocument> document_;
  RasterView picture_;
  std::optional<MapSight> drawn_for_;  ///< Of the picture; nothing: it is to be drawn.
  std::size_t times_drawn_ = 0;
  bool is_visible_ = true;
};

/// Borders of the objects that are in sight, as many pixels as the sight has. Clear where there are none.
[[nodiscard]] Raster<Rgba> border_picture(const LabelDocument& document, const MapSight& sight);

}  // namespace nadir
