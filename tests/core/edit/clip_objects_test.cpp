// SPDX-License-Identifier: Apache-2.0
// What is cut away, against rasters of what was there before.
#include <gmock/gmock.h>

#include <numbers>

#include "core/edit/edit_objects.h"
#include "core/edit/polygon_algebra.h"
#include "tests/core/edit/edited_labels.h"

namespace nadir {
namespace clip_objects_test {

using testing::SizeIs;

constexpr std::uint32_t kSeed = 311;

/// A ring that does not cross itself, about a place in cells.
Ring star(std::uint32_t scene, std::uint32_t number, double x, double y, double radius_m) {
  Ring places;
  for (std::uint32_t p = 0; p < 13; ++p) {
    const auto [radius, turn] = uniforms({kSeed, number, scene, p, 0});
    const double angle = 2.0 * std::numbers::pi * (p + 0.8 * turn) / 13.0;
    places.push_back(on_lattice({x + radius_m * (0.4 + 0.6 * radius) * std::cos(angle),
                                 -y + radius_m * (0.4 + 0.6 * radius) * std::sin(angle)}));
  }
  return places;
}

/// Fields with ponds and, above them, houses: areas and outlines that overlap as they come.
LabelDocument village(std::uint32_t scene) {
  std::vector<LabelObject> objects;
  for (std::uint32_t i = 0; i < 9; ++i) {
    const auto [x, y] = uniforms({kSeed, 100 + i, scene, 0, 0});
    const double east = 8.0 + 44.0 * x;
    const double south = 8.0 + 34.0 * y;
    std::vector<Ring> rings{star(scene, i, east, south, i < 4 ? 14.0 : 6.0)};
    if (i % 2 == 0) rings.push_back(star(scene, 50 + i, east, south, 1.5));
    const auto id = static_cast<ObjectId>(i) + 1;
    objects.push_back(i < 4   ? area(kTerrain, rings, id)
                      : i < 7 ? outline(kBuilding, rings, 0.8, id)
                              : area(kVegetation, rings, id));
  }
  LabelDocument document(test_plane(), test_grid(240, 200, 0.25));
  document.apply(adding(objects));
  return document;
}

std::vector<ObjectId> ids_of(const LabelDocument& document, ClassId id) {
  std::vector<ObjectId> ids;
  for (const auto& [number, placed] : document.objects()) {
    if (placed.object->class_id == id) ids.push_back(number);
  }
  return ids;
}

/// Cells in what some objects cover, of outlines their inside too.
Raster<int> covered(const LabelDocument& document, ClassId id) {
  LabelDocument areas(document.plane(), document.grid());
  std::vector<LabelObject> objects;
  for (const ObjectId number : ids_of(document, id)) {
    LabelObject object = object_in(document, number);
    object.kind = ObjectKind::kArea;
    object.width_m = 0.0;
    objects.push_back(object);
  }
  areas.apply(adding(objects));
  return cells_claimed(areas);
}

TEST(Clip, TakesWhatIsHiddenAndNothingThatShows) {
  for (std::uint32_t scene = 0; scene < 10; ++scene) {
    const LabelDocument document = village(scene);
    const auto after =
        edited(document, clip(document, ids_of(document, kTerrain), ClipSide::kThis));
    EXPECT_EQ(rasterise(after), rasterise(document)) << scene;
    // Under a house there is no field any more, neither below its wall nor inside.
    const Raster<int> fields_before = covered(document, kTerrain);
    const Raster<int> fields = covered(after, kTerrain);
    const Raster<int> houses = covered(document, kBuilding);
    const Raster<int> trees = covered(document, kVegetation);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const bool is_free = houses.values()[i] == 0 && trees.values()[i] == 0;
      const int expected = is_free && fields_before.values()[i] > 0 ? 1 : 0;
      ASSERT_EQ(fields.values()[i], expected) << "scene " << scene << ", cell " << i;
    }
  }
}

TEST(Clip, OfNeighboursLooksAsIfTheObjectLayOnTop) {
  for (std::uint32_t scene = 0; scene < 10; ++scene) {
    LabelDocument document = village(scene);
    const std::vector<ObjectId> houses = ids_of(document, kBuilding);
    const std::vector<ObjectId> one{houses.front()};
    const auto after = edited(document, clip(document, one, ClipSide::kOthers));
    LabelDocument on_top = document;
    on_top.apply(*reorder(document, one, OrderMove::kTop));
    // What other outlines lose they get a wall along, so that areas alone are compared.
    const Raster<int> others = covered(after, kTerrain);
    const Raster<int> before = covered(document, kTerrain);
    LabelDocument alone(document.plane(), document.grid());
    LabelObject inside = object_in(document, one[0]);
    inside.kind = ObjectKind::kArea;
    inside.width_m = 0.0;
    alone.apply(adding({inside}));
    const Raster<int> house = cells_claimed(alone);
    const Raster<ClassId> seen = rasterise(on_top);
    const Raster<ClassId> now = rasterise(after);
    for (std::size_t i = 0; i < others.size(); ++i) {
      ASSERT_EQ(others.values()[i], house.values()[i] > 0 ? 0 : before.values()[i]);
      // At its rim a sliver of another outline, narrower than a cell, gets the cells that it passes.
      const auto width = static_cast<std::size_t>(house.width());
      const bool is_inner = house.values()[i] > 0 && house.values()[i - 1] > 0 &&
                            house.values()[i + 1] > 0 && house.values()[i - width] > 0 &&
                            house.values()[i + width] > 0;
      if (is_inner) {
        ASSERT_EQ(now.values()[i], seen.values()[i]);
      }
    }
  }
}

TEST(Clip, OfSeveralIsOneAfterTheOtherAsOneStep) {
  for (std::uint32_t scene = 20; scene < 30; ++scene) {
    const LabelDocument document = village(scene);
    for (const ClipSide side : {ClipSide::kThis, ClipSide::kOthers}) {
      const std::vector<ObjectId> chosen{7, 2, 5, 1};
      const auto at_once = edited(document, clip(document, chosen, side));
      LabelDocument one_by_one = document;
      for (const ObjectId id : chosen) {
        if (one_by_one.objects().count(id) == 0) continue;
        one_by_one = edited(one_by_one, clip(one_by_one, std::vector<ObjectId>{id}, side));
      }
      EXPECT_EQ(rasterise(at_once), rasterise(one_by_one)) << scene;
      EXPECT_EQ(at_once.objects().size(), one_by_one.objects().size());
      for (const auto& [id, placed] : one_by_one.objects()) {
        ASSERT_EQ(at_once.objects().count(id), 1U);
      }
    }
  }
}

TEST(Subtract, TakesAllOthersFromEachPieceThatIsLeft) {
  // The first one cuts the field in two; the second lies in the smaller half.
  const LabelDocument document =
      document_of({area(kTerrain, {box(0, 0, 30, 10)}, 1), area(kRoad, {box(18, -1, 20, 11)}, 2),
                   outline(kBuilding, {box(23, 3, 27, 7)}, 0.5, 3)});
  const auto after = edited(document, subtract(document, 1, std::vector<ObjectId>{2, 3}));
  ASSERT_THAT(after.objects(), SizeIs(4));
  EXPECT_DOUBLE_EQ(area_m2(*region_of(object_in(after, 1))), 180.0);
  EXPECT_DOUBLE_EQ(area_m2(*region_of(object_in(after, 4))), 100.0 - 16.0)
      << "of a house its inside too";
  EXPECT_EQ(rasterise(after), rasterise(document));
}

}  // namespace clip_objects_test
}  // namespace nadir
