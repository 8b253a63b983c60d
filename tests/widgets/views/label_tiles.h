// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/label/edit_paint.h"
#include "core/label/label_raster.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/widgets/views/map_page.h"
#include "widgets/views/label_pictures.h"
#include "widgets/views/raster_pictures.h"
#include "widgets/views/theme.h"
#include "widgets/views/tile_pyramid_view.h"

namespace nadir {

/// A random number in [0, 1) of a test.
[[nodiscard]] inline double share_of(std::uint32_t seed, std::uint32_t draw) {
  return uniforms({.seed = seed, .particle = draw})[0];
}

/// An edit at random: an area, a line, an outline, a stroke, or one of the objects goes.
[[nodiscard]] inline LabelEdit random_edit(const LabelDocument& document, std::uint32_t seed) {
  constexpr std::array<ClassId, 5> kClasses = {kRoad, kTerrain, kVegetation, kCurb, kLaneMarking};
  const LabelGrid& grid = document.grid();
  const auto place = [&](std::uint32_t draw) {
    return grid.enu_from_cells({(share_of(seed, draw) * 1.2 - 0.1) * grid.width,
                                (share_of(seed, draw + 1) * 1.2 - 0.1) * grid.height});
  };
  const ClassId id = kClasses.at(static_cast<std::size_t>(5.0 * share_of(seed, 0)));
  const auto kind = static_cast<int>(5.0 * share_of(seed, 1));
  if (kind == 0 && !document.objects().empty()) {
    LabelEdit edit;
    edit.objects.push_back({document.objects().begin()->second.object, nullptr});
    return edit;
  }
  if (kind == 1) {
    return paint_stroke(document, {place(2), place(4)},
                        (1.0 + 30.0 * share_of(seed, 6)) * grid.metres_per_cell, id, "Paint");
  }
  const Eigen::Vector2d middle = place(2);
  const double reach = (3.0 + 150.0 * share_of(seed, 8)) * grid.metres_per_cell;
  Ring corners;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const double angle = 1.2566 * i;
    corners.emplace_back(middle + reach * (0.4 + share_of(seed, 10 + i)) *
                                      Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  const double width = (0.3 + 8.0 * share_of(seed, 9)) * grid.metres_per_cell;
  const ObjectKind shape = kind == 2   ? ObjectKind::kArea
                           : kind == 3 ? ObjectKind::kLine
                                       : ObjectKind::kOutline;
  return adding(
      {drawn(shape, id, {corners}, shape == ObjectKind::kArea ? 0.0 : width, document.next_id())});
}

/// Where an edit changes cells of the document's grid.
[[nodiscard]] inline PlaneBounds bounds_of(const LabelEdit& edit, const LabelGrid& grid) {
  const CellRect cells = changed_cells(edit, grid, grid);
  PlaneBounds bounds;
  if (cells.empty()) return bounds;
  bounds.include(
      grid.enu_from_cells({static_cast<double>(cells.left), static_cast<double>(cells.top)}));
  bounds.include(
      grid.enu_from_cells({static_cast<double>(cells.right), static_cast<double>(cells.bottom)}));
  return bounds;
}

/// A document at work and a view that follows it.
class FollowedLabels {
 public:
  explicit FollowedLabels(LabelDocument document) : document_(std::move(document)) {}

  [[nodiscard]] const LabelDocument& document() const { return document_; }
  [[nodiscard]] std::shared_ptr<const LabelPictures> pictures() const {
    return std::make_shared<const LabelPictures>(std::make_shared<const LabelDocument>(document_));
  }
  void edit(const LabelEdit& edit, TilePyramidView& view) {
    document_.apply(edit);
    view.show(pictures());
    view.forget(bounds_of(edit, document_.grid()));
  }
  void edit_at_random(std::uint32_t seed, TilePyramidView& view) {
    edit(random_edit(document_, seed), view);
  }

 private:
  LabelDocument document_;
};

}  // namespace nadir
