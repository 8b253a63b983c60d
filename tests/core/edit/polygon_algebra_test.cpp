// SPDX-License-Identifier: Apache-2.0
#include "core/edit/polygon_algebra.h"

#include <gmock/gmock.h>
#include <ogr_geometry.h>

#include <numbers>

#include "core/edit/edge_tree.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace polygon_algebra_test {

using testing::HasSubstr;

Region region(std::vector<std::vector<Ring>> parts) { return {std::move(parts)}; }
Region square(double left, double bottom, double side) {
  return region({{{{left, bottom},
                   {left + side, bottom},
                   {left + side, bottom + side},
                   {left, bottom + side}}}});
}

/// A ring around a place whose corners go around it, so it does not cross itself.
Ring random_star(std::uint64_t seed, std::uint32_t number, const Eigen::Vector2d& centre) {
  Ring ring;
  const int places = 5 + static_cast<int>(uniforms({seed, number, 0, 0, 0})[0] * 30.0);
  for (int i = 0; i < places; ++i) {
    const auto [radius, turn] = uniforms({seed, number, 1, static_cast<std::uint32_t>(i), 0});
    const double angle = 2.0 * std::numbers::pi * (i + 0.9 * turn) / places;
    ring.push_back(on_lattice(centre + (3.0 + 40.0 * radius) *
                                           Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return ring;
}

OGRPolygon ogr_polygon(const std::vector<Ring>& rings) {
  OGRPolygon polygon;
  for (const Ring& ring : rings) {
    OGRLinearRing places;
    for (const Eigen::Vector2d& place : ring) places.addPoint(place.x(), place.y());
    places.closeRings();
    polygon.addRing(&places);
  }
  return polygon;
}

void expect_sound(const Region& made) {
  for (const auto& part : made.parts) {
    EXPECT_TRUE(ogr_polygon(part).IsValid());
    for (const Ring& ring : part) {
      ASSERT_GE(ring.size(), 3U);
      for (const Eigen::Vector2d& place : ring) EXPECT_EQ(place, on_lattice(place));
    }
  }
}

TEST(Lattice, IsExactFarFromTheOrigin) {
  const Eigen::Vector2d place = on_lattice({999'999.123456789, -0.0000001});
  EXPECT_EQ(place, on_lattice(place));
  EXPECT_EQ(std::remainder(place.x(), kLatticeM), 0.0);
  EXPECT_NEAR(place.x(), 999'999.123456789, kLatticeM);
  EXPECT_FALSE(std::signbit(place.y()));
}

TEST(PolygonAlgebra, KnowsTheAreasOfSquares) {
  const Region a = square(0, 0, 10);
  const Region b = square(5, 5, 10);
  const std::array<Region, 2> both{a, b};
  EXPECT_DOUBLE_EQ(area_m2(*united(both)), 175.0);
  EXPECT_DOUBLE_EQ(area_m2(*without(a, b)), 75.0);
  EXPECT_DOUBLE_EQ(area_m2(*common(a, b)), 25.0);
  EXPECT_DOUBLE_EQ(area_m2(*grown(a, 1.0)), 144.0);
  EXPECT_DOUBLE_EQ(area_m2(*grown(a, -1.0)), 64.0);
  EXPECT_TRUE(grown(a, -6.0)->empty());
  EXPECT_TRUE(common(a, square(10, 0, 3))->empty()) << "a common edge is no area";
  EXPECT_TRUE(united({})->empty());
}

TEST(PolygonAlgebra, RandomPolygonsKeepTheIdentitiesOfSets) {
  for (std::uint32_t i = 0; i < 60; ++i) {
    const Region a = region({{random_star(1, i, {0, 0})}});
    const Region b = region({{random_star(2, i, {11, 7})}});
    const std::array<Region, 2> both{a, b};
    const auto all = united(both);
    const auto both_have = common(a, b);
    const auto only_a = without(a, b);
    const auto only_b = without(b, a);
    ASSERT_TRUE(all && both_have && only_a && only_b);
    for (const Region& made : {*all, *both_have, *only_a, *only_b}) expect_sound(made);
    // The lattice moves borders by a micrometre at most.
    const double rounding = 1e-6 * 2000.0;
    EXPECT_NEAR(area_m2(*all) + area_m2(*both_have), area_m2(a) + area_m2(b), rounding);
    EXPECT_NEAR(area_m2(*only_a) + area_m2(*both_have), area_m2(a), rounding);
    EXPECT_NEAR(area_m2(*only_b) + area_m2(*both_have), area_m2(b), rounding);
    const OGRPolygon ogr_a = ogr_polygon(a.parts.front());
    const OGRPolygon ogr_b = ogr_polygon(b.parts.front());
    const std::unique_ptr<OGRGeometry> expected(ogr_a.Union(&ogr_b));
    double expected_m2 = 0.0;
    if (wkbFlatten(expected->getGeometryType()) == wkbPolygon)
      expected_m2 = expected->toPolygon()->get_Area();
    if (wkbFlatten(expected->getGeometryType()) == wkbMultiPolygon)
      expected_m2 = expected->toMultiPolygon()->get_Area();
    EXPECT_NEAR(area_m2(*all), expected_m2, rounding);
  }
}

TEST(PolygonAlgebra, SplitConservesTheArea) {
  for (std::uint32_t i = 0; i < 60; ++i) {
    Ring star = random_star(3, i, {0, 0});
    double around = 0.0;
    for (std::size_t p = 0; p < star.size(); ++p) {
      around += 20.0 * (star[(p + 1) % star.size()] - star[p]).norm();
    }
    for (Eigen::Vector2d& place : star) place = 20.0 * place + Eigen::Vector2d(500'000, -300'000);
    const Region whole = region({{star}});
    const std::vector<Ring> lines{{{498'000, -300'700}, {502'000, -299'306}},
                                  {{500'003, -302'000}, {500'001, -298'000}}};
    const auto pieces = split(whole, lines);
    ASSERT_TRUE(pieces) << error_text(pieces);
    ASSERT_GE(pieces->size(), 3U);
    double sum = 0.0;
    for (const Region& piece : *pieces) {
      expect_sound(piece);
      sum += area_m2(piece);
      EXPECT_LE(area_m2(piece), area_m2(pieces->front()));
    }
    EXPECT_NEAR(sum / area_m2(whole), 1.0, 1e-9);
    // Places where a cut ends are rounded, so the border bends there by less than the lattice's step.
    EXPECT_NEAR(sum, area_m2(whole), around * kLatticeM);
  }
}

TEST(PolygonAlgebra, ReadsCrossingRingsByOddAndEven) {
  // A bow-tie, a star with five points whose middle is surrounded twice, a square within a square within a square.
  EXPECT_DOUBLE_EQ(area_m2(*region_of(area(kRoad, {{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}))), 50.0);
  Ring star;
  for (int i = 0; i < 5; ++i) {
    const double angle = i * 4.0 * std::numbers::pi / 5.0;
    star.emplace_back(10.0 * std::cos(angle), 10.0 * std::sin(angle));
  }
  const auto points = region_of(area(kRoad, {star}));
  EXPECT_EQ(points->parts.size(), 5U);
  EXPECT_NEAR(area_m2(*points), 77.5677, 1e-3);
  const auto nested =
      region_of(area(kRoad, {square(0, 0, 9).parts[0][0], square(1, 1, 7).parts[0][0],
                             square(2, 2, 5).parts[0][0]}));
  EXPECT_DOUBLE_EQ(area_m2(*nested), 81.0 - 49.0 + 25.0);
  expect_sound(*nested);
}

TEST(PolygonAlgebra, AStrokeEndsSquareAndTurnsRound) {
  EXPECT_DOUBLE_EQ(area_m2(*region_of(line(kRoad, {{0, 0}, {10, 0}}, 4.0))), 40.0);
  const auto bent = region_of(line(kRoad, {{0, 0}, {10, 0}, {10, 10}}, 4.0));
  // Two strips, less the square where they overlap, and a quarter of a disc outside of it.
  EXPECT_NEAR(area_m2(*bent), 80.0 - 4.0 + std::numbers::pi, 0.01);
}

TEST(PolygonAlgebra, ALineShorterThanTheLatticeIsOneSentence) {
  const auto line = beside({{0, 0}, {1e-8, 0}}, 1.0);
  ASSERT_FALSE(line);
  EXPECT_EQ(error_text(line), "a line needs two different places");
}

TEST(PolygonAlgebra, ABorderThatIsAScribbleIsRefusedInsteadOfTakingHours) {
  LabelObject scribble = area(kRoad, {{}});
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    const auto [x, y] = uniforms({9, 0, 0, i, 0});
    scribble.rings[0].emplace_back(1000.0 * x, 1000.0 * y);
  }
  const auto made = region_of(scribble);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kInvalidOptions);
  EXPECT_THAT(error_text(made), HasSubstr("cross more than 100000 times"));
}

TEST(PolygonAlgebra, SimplifiedStaysWithinTheTolerance) {
  Ring ring;
  for (int i = 0; i < 720; ++i) {
    const double angle = i * std::numbers::pi / 360.0;
    ring.emplace_back(50.0 * std::cos(angle), 50.0 * std::sin(angle));
  }
  const auto made = simplified(region({{ring}}), 0.5);
  ASSERT_TRUE(made);
  expect_sound(*made);
  EXPECT_LT(made->parts[0][0].size(), 40U);
  const EdgeTree edges(made->parts[0], true);
  for (const Eigen::Vector2d& place : ring) {
    double least = 1e9;
    edges.visit(box_around(place, place, 2.0), [&](const EdgeTree::Edge& edge) {
      least = std::min(least, (nearest_on_edge(edge.from, edge.to, place) - place).norm());
    });
    EXPECT_LE(least, 0.5 + 1e-5);
  }
}

TEST(EdgeTree, FindsWhatALookAtAllEdgesFinds) {
  const std::vector<Ring> rings{random_star(5, 0, {0, 0}), random_star(5, 1, {8, 0}), {}};
  const EdgeTree tree(rings, true);
  std::vector<EdgeTree::Edge> all;
  for (std::size_t i = 0; i < tree.size(); ++i) all.push_back(tree.edge(i));
  EXPECT_EQ(all.size(), rings[0].size() + rings[1].size());
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j)
      crossings += crossing_of_edges(all[i].from, all[i].to, all[j].from, all[j].to) ? 1 : 0;
  }
  EXPECT_GT(crossings, 0U);
  EXPECT_EQ(*count_crossings(rings), crossings);
  for (std::uint32_t i = 0; i < 300; ++i) {
    const auto [x, y] = uniforms({6, 0, 0, i, 0});
    const Eigen::Vector2d place(100.0 * x - 50.0, 100.0 * y - 50.0);
    bool is_inside = false;
    for (const EdgeTree::Edge& edge : all) {
      if ((edge.from.y() <= place.y()) == (edge.to.y() <= place.y())) continue;
      const double t = (place.y() - edge.from.y()) / (edge.to.y() - edge.from.y());
      is_inside ^= edge.from.x() + t * (edge.to.x() - edge.from.x()) > place.x();
    }
    EXPECT_EQ(tree.holds(place), is_inside);
  }
}

TEST(NewCrossing, TellsWhatAChangeCrosses) {
  const LabelObject before = area(kRoad, {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}});
  LabelObject after = before;
  EXPECT_FALSE(*new_crossing(&before, after));
  after.rings[0][2] = {5, -5};
  const auto crossing = new_crossing(&before, after);
  ASSERT_TRUE(crossing && *crossing);
  EXPECT_NEAR((*crossing)->y(), 0.0, 1e-12);
  // What crosses itself already may be moved as it is.
  LabelObject moved = after;
  for (Eigen::Vector2d& place : moved.rings[0]) place += Eigen::Vector2d(1.0, 2.0);
  EXPECT_FALSE(*new_crossing(&after, moved));
  EXPECT_TRUE(*new_crossing(nullptr, after));
}

}  // namespace polygon_algebra_test
}  // namespace nadir
