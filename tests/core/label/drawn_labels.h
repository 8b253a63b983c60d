// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/label/label_document.h"

namespace nadir {

/// Small documents that tests draw on.

[[nodiscard]] inline ProjectPlane test_plane() { return *ProjectPlane::create({48.9877, 8.3877}); }

/// Cells from the plane's origin to the right and *down*, so that cell (x, y) lies at enu (x, -y) times their size.
[[nodiscard]] inline LabelGrid test_grid(int width, int height, double metres_per_cell = 1.0) {
  return {metres_per_cell, {0.0, 0.0}, width, height};
}

[[nodiscard]] inline LabelDocument test_document(int width = 40,
                                                 int height = 30,
                                                 double metres_per_cell = 1.0) {
  return {test_plane(), test_grid(width, height, metres_per_cell)};
}

/// Places in cells of one metre, so y counts down.
[[nodiscard]] inline Ring ring(const std::vector<std::pair<double, double>>& places_in_cells) {
  Ring places;
  for (const auto& [x, y] : places_in_cells) places.emplace_back(x, -y);
  return places;
}
[[nodiscard]] inline Ring box(double left, double top, double right, double bottom) {
  return ring({{left, top}, {right, top}, {right, bottom}, {left, bottom}});
}

[[nodiscard]] inline LabelObject drawn(ObjectKind kind,
                                       ClassId class_id,
                                       std::vector<Ring> rings,
                                       double width_m = 0.0,
                                       ObjectId id = 1) {
  return {id,       kind,
          class_id, drawing_level(class_id) * kOrdersPerLevel + kOrderStep,
          width_m,  std::move(rings),
          {}};
}
[[nodiscard]] inline LabelObject area(ClassId class_id, std::vector<Ring> rings, ObjectId id = 1) {
  return drawn(ObjectKind::kArea, class_id, std::move(rings), 0.0, id);
}
[[nodiscard]] inline LabelObject line(ClassId class_id,
                                      Ring places,
                                      double width_m,
                                      ObjectId id = 1) {
  return drawn(ObjectKind::kLine, class_id, {std::move(places)}, width_m, id);
}
[[nodiscard]] inline LabelObject outline(ClassId class_id,
                                         std::vector<Ring> rings,
                                         double thickness_m,
                                         ObjectId id = 1) {
  return drawn(ObjectKind::kOutline, class_id, std::move(rings), thickness_m, id);
}

[[nodiscard]] inline ObjectChange added(LabelObject object) {
  return {nullptr, std::make_shared<const LabelObject>(std::move(object))};
}
[[nodiscard]] inline LabelEdit adding(std::vector<LabelObject> objects,
                                      std::string title = "Draw") {
  LabelEdit edit{std::move(title), {}, {}, {}};
  for (LabelObject& object : objects) edit.objects.push_back(added(std::move(object)));
  return edit;
}
[[nodiscard]] inline LabelDocument document_of(std::vector<LabelObject> objects,
                                               int width = 40,
                                               int height = 30) {
  LabelDocument document = test_document(width, height);
  document.apply(adding(std::move(objects)));
  return document;
}

/// Paints cells of the document's grid with one value. Cells without change make no edit.
[[nodiscard]] inline LabelEdit painting(const LabelDocument& document,
                                        const CellRect& cells,
                                        PaintValue value) {
  LabelEdit edit{"Paint", {}, {}, {}};
  const auto tile_of = [](std::int64_t cell) {
    return static_cast<int>((cell + (std::int64_t{1} << 40U)) / kPaintTileSide -
                            (std::int64_t{1} << 40U) / kPaintTileSide);
  };
  for (int row = tile_of(cells.top); row <= tile_of(cells.bottom - 1); ++row) {
    for (int column = tile_of(cells.left); column <= tile_of(cells.right - 1); ++column) {
      const CellRect of_tile{
          std::int64_t{column} * kPaintTileSide, std::int64_t{row} * kPaintTileSide,
          std::int64_t{column + 1} * kPaintTileSide, std::int64_t{row + 1} * kPaintTileSide};
      const CellRect part = cells.cut_to(of_tile);
      const auto before = document.tile({column, row});
      auto after =
          before != nullptr ? std::make_shared<PaintTile>(*before) : std::make_shared<PaintTile>();
      for (std::int64_t y = part.top; y < part.bottom; ++y) {
        for (std::int64_t x = part.left; x < part.right; ++x) {
          after->at(static_cast<int>(x - of_tile.left), static_cast<int>(y - of_tile.top)) = value;
        }
      }
      const bool is_blank = *after == PaintTile();
      if (is_blank && before == nullptr) continue;
      edit.tiles.push_back({{column, row}, {before, is_blank ? nullptr : after}});
    }
  }
  return edit;
}

/// What somebody might do next: draw, move, recolour or delete an object, paint or erase, set a value. A pure function of the
/// document and the numbers.
[[nodiscard]] inline LabelEdit random_edit(const LabelDocument& document,
                                           std::uint64_t seed,
                                           std::uint32_t step) {
  std::uint32_t draws = 0;
  const auto random = [&](double low, double high) {
    return low + (high - low) * uniforms({seed, 0, step, 0, draws++})[0];
  };
  const auto choice = [&](int count) { return static_cast<int>(random(0.0, count)); };
  constexpr std::array<ClassId, 6> kClasses{kRoad, kTerrain,     kBuilding,
                                            kCurb, kLaneMarking, kUnclassified};
  const auto some_class = [&] { return kClasses.at(static_cast<std::size_t>(choice(6))); };
  const double width = document.grid().width;
  const double height = document.grid().height;
  const auto some_ring = [&](int places) {
    const double x = random(-4.0, width + 4.0);
    const double y = random(-4.0, height + 4.0);
    Ring made;
    for (int i = 0; i < places; ++i)
      made.emplace_back(x + random(-9.0, 9.0), -y + random(-9.0, 9.0));
    return made;
  };
  LabelEdit edit{fmt::format("Step {}", step), {}, {}, {}};
  const int what = choice(10);
  if (what < 4 || (what < 7 && document.objects().empty())) {
    const auto kind = static_cast<ObjectKind>(choice(3));
    std::vector<Ring> rings{some_ring(3 + choice(6))};
    if (kind != ObjectKind::kLine && choice(3) == 0) rings.push_back(some_ring(3));
    LabelObject object =
        drawn(kind, some_class(), rings, kind == ObjectKind::kArea ? 0.0 : random(0.1, 4.0),
              document.next_id());
    object.order = document.next_order(object.class_id);
    edit.objects.push_back(added(object));
  } else if (what < 7) {
    auto chosen = document.objects().begin();
    std::advance(chosen, choice(static_cast<int>(document.objects().size())));
    LabelObject object = *chosen->second.object;
    if (what == 4) {
      edit.objects.push_back({chosen->second.object, nullptr});
      return edit;
    }
    if (what == 5) object.class_id = some_class();
    if (what == 6) object.rings.front().front() += Eigen::Vector2d(random(-5.0, 5.0), 1.0);
    object.note = fmt::format("touched by step {}", step);
    edit.objects.push_back({chosen->second.object, std::make_shared<const LabelObject>(object)});
  } else if (what < 9) {
    const auto left = static_cast<std::int64_t>(random(-300.0, width));
    const auto top = static_cast<std::int64_t>(random(-20.0, height));
    const ClassId id = some_class();
    const PaintValue value = choice(4) == 0 ? kNoPaint
                             : id == kUnclassified
                                 ? PaintValue{kUnclassified}
                                 : static_cast<PaintValue>(id + kPaintOver * choice(2));
    edit.tiles =
        painting(document, {left, top, left + 1 + choice(30), top + 1 + choice(20)}, value).tiles;
    if (!edit.empty()) return edit;
    edit.values.push_back(
        {"blank", {document.value("blank"), std::make_shared<const std::string>(edit.title)}});
  } else {
    const std::string key = fmt::format("key {}", choice(3));
    const auto before = document.value(key);
    const bool removes = before != nullptr && choice(3) == 0;
    edit.values.push_back(
        {key, {before, removes ? nullptr : std::make_shared<const std::string>(edit.title)}});
  }
  return edit;
}

}  // namespace nadir
