// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <set>
#include <utility>
#include <vector>

#include "core/label/label_raster.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"

namespace nadir {

/// The document after an edit, which has to fit, and whose reverse has to give back the same document.
[[nodiscard]] inline LabelDocument edited(const LabelDocument& document,
                                          const Result<LabelEdit>& edit) {
  EXPECT_TRUE(edit) << error_text(edit);
  if (!edit) return document;
  const auto fits = document.check(*edit);
  EXPECT_TRUE(fits) << error_text(fits);
  if (!fits) return document;
  LabelDocument after = document;
  after.apply(*edit);
  const LabelEdit back = reversed(*edit);
  const auto goes_back = after.check(back);
  EXPECT_TRUE(goes_back) << error_text(goes_back);
  LabelDocument again = after;
  again.apply(back);
  EXPECT_TRUE(again == document);
  return after;
}

/// Places that more than one object has, to the last bit.
[[nodiscard]] inline std::size_t shared_places(const LabelDocument& document) {
  std::map<std::pair<double, double>, std::set<ObjectId>> objects;
  for (const auto& [id, placed] : document.objects()) {
    for (const Ring& ring : placed.object->rings) {
      for (const Eigen::Vector2d& place : ring) objects[{place.x(), place.y()}].insert(id);
    }
  }
  return static_cast<std::size_t>(std::count_if(
      objects.begin(), objects.end(), [](const auto& at) { return at.second.size() > 1; }));
}

/// In how many objects' own rasters each cell is.
[[nodiscard]] inline Raster<int> cells_claimed(const LabelDocument& document) {
  Raster<int> claimed(document.grid().width, document.grid().height, 0);
  for (const auto& [id, placed] : document.objects()) {
    LabelDocument alone(document.plane(), document.grid());
    alone.apply(adding({*placed.object}));
    const Raster<ClassId> cells = rasterise(alone);
    for (std::size_t i = 0; i < cells.size(); ++i)
      claimed.values()[i] += cells.values()[i] != kUnclassified ? 1 : 0;
  }
  return claimed;
}

[[nodiscard]] inline const LabelObject& object_in(const LabelDocument& document, ObjectId id) {
  return *document.objects().at(id).object;
}

}  // namespace nadir
