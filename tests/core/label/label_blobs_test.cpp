// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_blobs.h"

#include <gmock/gmock.h>

#include <bit>

#include "core/label/byte_reader.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace label_blobs_test {

using testing::ElementsAre;
using testing::HasSubstr;

LabelObject noted_outline() {
  LabelObject object = outline(kBuilding, {box(0, 0, 9, 9), box(2, 2, 3.25, 4)}, 0.3, 12);
  object.note = "school, \xC3\xBC and \xFF";
  object.order = -5;
  return object;
}

TEST(ObjectImage, ComesBackWithEverything) {
  for (const LabelObject& object :
       {noted_outline(), line(kCurb, ring({{0.1, 0.2}, {1e5, -3}}), 0.15),
        area(kRoad, {box(0, 0, 1, 1)})}) {
    const auto back = object_of_image(object_image(object), object.id);
    ASSERT_TRUE(back) << error_text(back);
    EXPECT_EQ(*back, object);
  }
}

TEST(ObjectImage, IsRefusedWhereItIsCutOffAnywhere) {
  const Bytes image = object_image(noted_outline());
  for (std::size_t length = 0; length < image.size(); ++length) {
    const auto back = object_of_image(ByteSpan(image).first(length), 12);
    // After a ring's end it is a whole object with fewer rings, which nobody can tell.
    EXPECT_TRUE(!back || back->rings.size() < 2U) << length;
  }
  EXPECT_THAT(error_text(object_of_image(ByteSpan(image).first(20), 12)), HasSubstr("object 12"));
}

TEST(ObjectImage, NeverTrustsAByte) {
  const Bytes image = object_image(noted_outline());
  for (std::size_t at = 0; at < image.size(); ++at) {
    Bytes damaged = image;
    damaged[at] ^= 0xFFU;
    if (const auto back = object_of_image(damaged, 12)) {
      EXPECT_TRUE(check_object(*back)) << at;
    }
  }
}

/// As PostGIS and GDAL have it: POINTs of one byte order or the other.
Bytes geopackage_header(std::uint8_t flags, std::size_t envelope_bytes) {
  Bytes bytes{'G', 'P', 0, flags, 0xA0, 0x86, 0x01, 0x00};
  bytes.resize(bytes.size() + envelope_bytes, 0);
  return bytes;
}

void append_big_endian(Bytes& bytes, double value) {
  Bytes little;
  append_number(little, value);
  bytes.insert(bytes.end(), little.rbegin(), little.rend());
}

TEST(GeoPackageGeometry, BeginsAsTheStandardSays) {
  const Bytes bytes = geopackage_geometry(line(kCurb, {{1.0, 2.0}, {4.0, -3.0}}, 1.0), 100000);
  ASSERT_EQ(bytes.size(), 8U + 32U + 9U + 32U);
  EXPECT_THAT(Bytes(bytes.begin(), bytes.begin() + 8),
              ElementsAre('G', 'P', 0, 3, 0xA0, 0x86, 0x01, 0));
  ByteReader reader(ByteSpan(bytes).subspan(8));
  EXPECT_EQ(reader.number<double>(), 1.0);  // Least and greatest x, then y.
  EXPECT_EQ(reader.number<double>(), 4.0);
  EXPECT_EQ(reader.number<double>(), -3.0);
  EXPECT_EQ(reader.number<double>(), 2.0);
  EXPECT_EQ(reader.number<std::uint8_t>(), 1);
  EXPECT_EQ(reader.number<std::uint32_t>(), 2U);  // LINESTRING
  EXPECT_EQ(reader.number<std::uint32_t>(), 2U);
}

TEST(GeoPackageGeometry, ComesBackWithItsHolesAndWithoutTheRepeatedPlace) {
  const LabelObject object = noted_outline();
  const auto parts = parts_of_geometry(geopackage_geometry(object, 1));
  ASSERT_TRUE(parts) << error_text(parts);
  ASSERT_EQ(parts->size(), 1U);
  EXPECT_TRUE(parts->front().is_polygon);
  EXPECT_EQ(parts->front().rings, object.rings);
}

TEST(GeoPackageGeometry, MayBeBigEndianWithHeights) {
  Bytes bytes = geopackage_header(1U | 2U << 1U, 48);            // An envelope with z.
  bytes.insert(bytes.end(), {0, 0, 0, 0x03, 0xEA, 0, 0, 0, 2});  // LINESTRING Z of two places
  for (const double number : {1.0, 2.0, 50.0, 3.0, 4.0, 60.0}) append_big_endian(bytes, number);
  const auto parts = parts_of_geometry(bytes);
  ASSERT_TRUE(parts) << error_text(parts);
  EXPECT_FALSE(parts->front().is_polygon);
  EXPECT_EQ(parts->front().rings.front(), (Ring{{1.0, 2.0}, {3.0, 4.0}}));
}

TEST(GeoPackageGeometry, OfSeveralPartsGivesEach) {
  Bytes bytes = geopackage_header(1, 0);
  bytes.insert(bytes.end(), {1, 6, 0, 0, 0, 2, 0, 0, 0});  // MULTIPOLYGON of two
  for (const double left : {0.0, 10.0}) {
    const LabelObject one = area(kRoad, {box(left, 0, left + 1, 1)});
    const Bytes alone = geopackage_geometry(one, 1);
    bytes.insert(bytes.end(), alone.begin() + 40, alone.end());
  }
  const auto parts = parts_of_geometry(bytes);
  ASSERT_TRUE(parts) << error_text(parts);
  ASSERT_EQ(parts->size(), 2U);
  EXPECT_EQ(parts->back().rings.front(), box(10, 0, 11, 1));
}

TEST(GeoPackageGeometry, IsRefusedWhereItIsCutOffOrNoLineAndNoArea) {
  const Bytes whole = geopackage_geometry(noted_outline(), 1);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_FALSE(parts_of_geometry(ByteSpan(whole).first(length))) << length;
  }
  Bytes point = geopackage_header(1, 0);
  point.insert(point.end(), {1, 1, 0, 0, 0});
  point.resize(point.size() + 16, 0);
  EXPECT_THAT(error_text(parts_of_geometry(point)), HasSubstr("neither line nor area"));
  Bytes huge = geopackage_header(1, 0);  // Four thousand million places that are not there.
  huge.insert(huge.end(), {1, 2, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF});
  EXPECT_FALSE(parts_of_geometry(huge));
  Bytes nested = geopackage_header(1, 0);
  for (int depth = 0; depth < 1000; ++depth)
    nested.insert(nested.end(), {1, 7, 0, 0, 0, 1, 0, 0, 0});
  EXPECT_FALSE(parts_of_geometry(nested));
}

TEST(ByteDelta, GivesEitherSideFromTheOther) {
  const std::vector<Bytes> texts{{},           {1},    {1, 2, 3},      {1, 9, 3},     {2, 3},
                                 {1, 1, 1, 1}, {1, 1}, Bytes(5000, 7), Bytes(4000, 7)};
  for (const Bytes& before : texts) {
    for (const Bytes& after : texts) {
      const Bytes delta = byte_delta(before, after);
      ASSERT_TRUE(before_of(delta, after));
      EXPECT_EQ(*before_of(delta, after), before);
      ASSERT_TRUE(after_of(delta, before));
      EXPECT_EQ(*after_of(delta, before), after);
    }
  }
}

TEST(ByteDelta, OfOnePlaceAmongManyIsSmallAlsoWhereItWasAdded) {
  Ring many;
  for (int i = 0; i < 100'000; ++i)
    many.emplace_back(std::cos(i * 6e-5) * 900, std::sin(i * 6e-5) * 900);
  const LabelObject before = area(kTerrain, {many, box(-1, -1, 1, 1)});
  LabelObject moved = before;
  moved.rings.front()[50'000] += Eigen::Vector2d(0.5, 0.25);
  LabelObject longer = before;
  longer.rings.front().insert(longer.rings.front().begin() + 7, Eigen::Vector2d(3.0, 4.0));
  EXPECT_LT(byte_delta(object_image(before), object_image(moved)).size(), 60U);
  EXPECT_LT(byte_delta(object_image(before), object_image(longer)).size(), 60U);
}

TEST(ByteDelta, DoesNotFitAnythingElse) {
  const Bytes delta = byte_delta(Bytes{1, 2, 3, 4}, Bytes{1, 9, 4});
  EXPECT_FALSE(after_of(delta, Bytes{1, 2, 2, 4}));
  EXPECT_FALSE(after_of(delta, Bytes{1}));
  EXPECT_FALSE(before_of(delta, Bytes{1, 2, 3, 4}));
  EXPECT_FALSE(after_of(Bytes{}, Bytes{1, 2, 3, 4}));
  EXPECT_FALSE(
      after_of(Bytes{0, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF}, Bytes{1}));
  EXPECT_FALSE(after_of(Bytes{1, 2, 3, 4, 5}, Bytes{1, 2, 3, 4}));
}

std::shared_ptr<PaintTile> mask_tile() {
  auto tile = std::make_shared<PaintTile>();
  for (int building = 0; building < 12; ++building) {
    const int left = building * 37 % 220;
    const int top = building * 61 % 220;
    for (int row = 0; row < 24; ++row) {
      for (int column = 0; column < 30; ++column) tile->at(left + column, top + row) = kBuilding;
    }
  }
  return tile;
}

TEST(TileCode, ComesBack) {
  const auto tile = mask_tile();
  const auto back = unpacked_tile(packed_tile(*tile));
  ASSERT_TRUE(back) << error_text(back);
  EXPECT_EQ(**back, *tile);
}

TEST(TileCode, OfABuildingMaskTakesAFewHundredBytes) {
  EXPECT_LT(packed_tile(*mask_tile()).size(), 600U);
}

TEST(TileCode, OfAStrokeThroughATileTakesLittle) {
  const auto before = mask_tile();
  auto after = std::make_shared<PaintTile>(*before);
  for (int column = 10; column < 240; ++column) {
    for (int row = -6; row < 6; ++row) after->at(column, 100 + column / 4 + row) = kRoad;
  }
  const Bytes delta = tile_delta(before.get(), after.get());
  EXPECT_LT(delta.size(), 1000U);
  EXPECT_EQ(**other_tile(delta, before.get()), *after);
  EXPECT_EQ(**other_tile(delta, after.get()), *before);
}

TEST(TileCode, KnowsTilesThatAreNone) {
  const auto tile = mask_tile();
  const Bytes delta = tile_delta(nullptr, tile.get());
  EXPECT_EQ(**other_tile(delta, nullptr), *tile);
  ASSERT_TRUE(other_tile(delta, tile.get()));
  EXPECT_EQ(*other_tile(delta, tile.get()), nullptr);
}

TEST(TileCode, IsRefusedWhereItIsDamaged) {
  const Bytes packed = packed_tile(*mask_tile());
  for (std::size_t length = 0; length < packed.size(); length += 3) {
    EXPECT_FALSE(unpacked_tile(ByteSpan(packed).first(length))) << length;
  }
  EXPECT_FALSE(unpacked_tile(Bytes(300, 1)));
  auto nothing = std::make_shared<PaintTile>();
  nothing->at(0, 0) = 100;  // No class.
  EXPECT_FALSE(unpacked_tile(packed_tile(*nothing)));
  EXPECT_FALSE(other_tile(tile_delta(nullptr, mask_tile().get()), nothing.get()));
}

}  // namespace label_blobs_test
}  // namespace nadir
