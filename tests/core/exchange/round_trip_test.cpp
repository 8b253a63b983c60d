// SPDX-License-Identifier: Apache-2.0
// What Nadir has written comes back as it was.
#include <gmock/gmock.h>

#include <fstream>
#include <numbers>

#include "core/edit/polygon_algebra.h"
#include "core/exchange/label_export.h"
#include "core/label/label_raster.h"
#include "core/label/label_store.h"
#include "tests/core/exchange/import_sources.h"
#include "tests/core/label/drawn_labels.h"

namespace nadir {
namespace round_trip_test {

namespace fs = std::filesystem;

constexpr std::uint32_t kSeed = 511;

/// On the lattice, and not crossing itself.
Ring star(std::uint32_t scene, std::uint32_t number, const Eigen::Vector2d& middle, double most_m) {
  Ring places;
  for (std::uint32_t p = 0; p < 9; ++p) {
    const auto [radius, turn] = uniforms({kSeed, number, scene, p, 0});
    const double angle = 2.0 * std::numbers::pi * (p + 0.8 * turn) / 9.0;
    places.push_back(on_lattice(middle + most_m * (0.5 + 0.5 * radius) *
                                             Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return places;
}

/// Sound objects of all kinds with whatever numbers and words somebody may have given them.
LabelDocument random_objects(std::uint32_t scene) {
  constexpr std::array kNotes{
      "",        "café \"Zum Löwen\"", "a\\b, c; {d}", "two\nlines", "null", "12",
      "0012.50", "<b>&amp;</b>",       "人行横道",     "true"};
  constexpr std::array<ClassId, 5> kSome{kRoad, kTerrain, kBuilding, kLaneMarking, kUnclassified};
  std::vector<LabelObject> objects;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const auto [x, y] = uniforms({kSeed, 1000 + i, scene, 0, 0});
    const auto [kind, width] = uniforms({kSeed, 1000 + i, scene, 1, 0});
    const auto [order, level] = uniforms({kSeed, 1000 + i, scene, 2, 0});
    const Eigen::Vector2d middle(200.0 * x, -150.0 * y);
    std::vector<Ring> rings{star(scene, i, middle, 10.0)};
    const auto what = static_cast<ObjectKind>(3.0 * kind);
    if (what != ObjectKind::kLine && i % 3 == 0) {
      rings.push_back(star(scene, 100 + i, middle + Eigen::Vector2d(-1.0, -1.0), 0.7));
      rings.push_back(star(scene, 200 + i, middle + Eigen::Vector2d(1.0, 1.0), 0.7));
    }
    if (what == ObjectKind::kLine && i % 2 == 0) rings[0].push_back(rings[0].front());
    LabelObject object =
        drawn(what, kSome[i % 5], rings,
              what == ObjectKind::kArea ? 0.0 : std::exp(9.0 * width - 4.0), ObjectId{i} + 1);
    object.order = static_cast<std::int64_t>(15.0 * level - 1.0) * kOrdersPerLevel +
                   static_cast<std::int64_t>(order * 1e12);
    object.note = kNotes[(i * 7 + scene) % kNotes.size()];
    objects.push_back(object);
  }
  return document_of(objects, 200, 150);
}

/// The same but for the direction, which formats prescribe.
bool is_same_ring(const Ring& a, const Ring& b) {
  if (a == b) return true;
  Ring back = a;
  std::reverse(back.begin() + 1, back.end());
  return back == b;
}

void expect_same(const LabelObject& found, const LabelObject& drawn, const std::string& what) {
  EXPECT_EQ(found.kind, drawn.kind) << what;
  EXPECT_EQ(found.class_id, drawn.class_id) << what;
  EXPECT_EQ(found.order, drawn.order) << what;
  EXPECT_EQ(found.width_m, drawn.width_m) << what;
  EXPECT_EQ(found.note, drawn.note) << what;
  ASSERT_EQ(found.rings.size(), drawn.rings.size()) << what;
  for (std::size_t i = 0; i < drawn.rings.size(); ++i) {
    if (drawn.kind == ObjectKind::kLine) {
      EXPECT_EQ(found.rings[i], drawn.rings[i]) << what;
    } else {
      EXPECT_TRUE(is_same_ring(found.rings[i], drawn.rings[i])) << what << ", ring " << i;
    }
  }
}

class RoundTrip : public testing::Test {
 protected:
  void write(const LabelDocument& document, LabelFormat format, const std::string& name) {
    const auto done = export_labels(document, document.grid(), {"town", "", "", ""}, format,
                                    folder.path() / name);
    ASSERT_TRUE(done) << error_text(done);
  }
  void take(LabelDocument& into, const std::string& name) {
    const auto source = ImportSource::read(folder.path() / name);
    ASSERT_TRUE(source) << error_text(source);
    const auto labels = source->objects(bundled_rules(source->usual_rules()), into);
    ASSERT_TRUE(labels) << error_text(labels);
    into.apply(labels->edit);
  }
  [[nodiscard]] std::string bytes(const std::string& name) const {
    std::ifstream file(folder.path() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  ScratchFolder folder;
};

TEST_F(RoundTrip, GeoJsonKeepsObjectsAndIsWrittenTheSameAgain) {
  for (std::uint32_t scene = 0; scene < 6; ++scene) {
    const LabelDocument document = random_objects(scene);
    write(document, LabelFormat::kGeoJson, "out.geojson");
    LabelDocument back(document.plane(), document.grid());
    take(back, "out.geojson");
    ASSERT_EQ(back.objects().size(), document.objects().size());
    for (const auto& [id, placed] : document.objects()) {
      expect_same(*back.object(id), *placed.object, fmt::format("scene {}, {}", scene, id));
    }
    EXPECT_EQ(rasterise(back), rasterise(document));
    write(back, LabelFormat::kGeoJson, "again.geojson");
    EXPECT_EQ(bytes("again.geojson"), bytes("out.geojson"));
  }
}

TEST_F(RoundTrip, ShapefilesKeepObjectsAndAreWrittenTheSameAgain) {
  for (std::uint32_t scene = 10; scene < 14; ++scene) {
    const LabelDocument document = random_objects(scene);
    write(document, LabelFormat::kShapefile, "out");
    LabelDocument back(document.plane(), document.grid());
    std::vector<ObjectId> ids;
    for (const ObjectKind kind : {ObjectKind::kArea, ObjectKind::kLine, ObjectKind::kOutline}) {
      take(back, fmt::format("out/{}.shp", enum_name(kind)));
      for (const auto& [id, placed] : document.objects()) {
        if (placed.object->kind == kind) ids.push_back(id);
      }
    }
    ASSERT_EQ(back.objects().size(), document.objects().size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      expect_same(*back.object(static_cast<ObjectId>(i) + 1), *document.object(ids[i]),
                  fmt::format("scene {}, {}", scene, ids[i]));
    }
    write(back, LabelFormat::kShapefile, "again");
    for (const char* const name : {"area.shp", "line.shp", "outline.shp", "area.dbf", "line.dbf"}) {
      EXPECT_EQ(bytes(std::string("again/") + name), bytes(std::string("out/") + name)) << name;
    }
  }
}

TEST_F(RoundTrip, ADocumentsOwnLayersKeepOrderAndNotes) {
  const LabelDocument document = random_objects(20);
  ASSERT_TRUE(LabelStore::create(folder.path() / "labels.gpkg", document, "ada"));
  LabelDocument back(document.plane(), document.grid());
  take(back, "labels.gpkg");
  ASSERT_EQ(back.objects().size(), document.objects().size());
  std::multiset<std::tuple<int, std::int64_t, double, std::string>> was;
  std::multiset<std::tuple<int, std::int64_t, double, std::string>> now;
  for (const auto& [id, placed] : document.objects()) {
    const LabelObject& object = *placed.object;
    was.emplace(object.class_id, object.order, object.width_m, object.note);
  }
  for (const auto& [id, placed] : back.objects()) {
    const LabelObject& object = *placed.object;
    now.emplace(object.class_id, object.order, object.width_m, object.note);
  }
  EXPECT_EQ(now, was);
}

TEST_F(RoundTrip, AnOrderThatNoLevelHasIsNotTaken) {
  const std::string text =
      R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"class":"road",)"
      R"("kind":"line","width_m":2.0,"order":9223372036854775807,"note":"2024-05-01"},"geometry":)"
      R"({"type":"LineString","coordinates":[[8.0,49.0],[8.001,49.0]]}}]})";
  const Imported found = import_all(folder.file("far.geojson", text));
  ASSERT_EQ(found.labels.taken, 1U);
  EXPECT_EQ(level_of_order(found.object(0).order), drawing_level(kRoad));
  EXPECT_EQ(found.object(0).note, "2024-05-01") << "not as a date is written elsewhere";
}

}  // namespace round_trip_test
}  // namespace nadir
