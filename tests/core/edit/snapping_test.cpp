// SPDX-License-Identifier: Apache-2.0
#include "core/edit/snapping.h"

#include <gmock/gmock.h>

#include "core/edit/polygon_algebra.h"
#include "tests/core/edit/edited_labels.h"

namespace nadir {
namespace snapping_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

LabelDocument two_squares() {
  return document_of({area(kRoad, {box(0, 0, 10, 10)}, 1), area(kTerrain, {box(10, 0, 20, 10)}, 2),
                      line(kCurb, ring({{30, 5}, {40, 5}}), 0.2, 3)});
}

TEST(SnapIndex, TakesAVertexBeforeAnEdge) {
  const SnapIndex index(two_squares());
  const auto vertex = index.nearest({10.4, -0.1}, 0.5);
  ASSERT_TRUE(vertex);
  EXPECT_EQ(vertex->kind, SnapKind::kVertex);
  EXPECT_EQ(vertex->in_enu_m, Eigen::Vector2d(10, 0));
  EXPECT_EQ(vertex->at, (VertexRef{1, 0, 1})) << "of equal ones the first";
  const auto edge = index.nearest({5.25, -0.3}, 0.5);
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->kind, SnapKind::kEdge);
  EXPECT_EQ(edge->in_enu_m, Eigen::Vector2d(5.25, 0));
  EXPECT_EQ(edge->at, (VertexRef{1, 0, 0}));
  EXPECT_FALSE(index.nearest({5, -5}, 0.5));
  EXPECT_FALSE(index.nearest({35, 0}, 4.9));
}

TEST(SnapIndex, PassesOverWhatIsMoved) {
  const SnapIndex index(two_squares());
  const std::array<ObjectId, 1> moved{1};
  EXPECT_EQ(index.nearest({10.4, -0.1}, 0.5, moved)->at, (VertexRef{2, 0, 0}));
  EXPECT_FALSE(index.nearest({0, 0}, 0.5, moved));
}

TEST(SnapIndex, KnowsWhatMovesTogether) {
  const SnapIndex index(two_squares());
  EXPECT_THAT(index.at({10, -10}), ElementsAre(VertexRef{1, 0, 2}, VertexRef{2, 0, 3}));
  EXPECT_THAT(index.at({10, -10.000001}), SizeIs(2)) << "as another program has rounded it";
  EXPECT_THAT(index.at({10, -10.00001}), SizeIs(0));
  EXPECT_THAT(index.edges_at({10, -4}), ElementsAre(VertexRef{1, 0, 1}, VertexRef{2, 0, 3}));
  EXPECT_THAT(index.edges_at({30, -5}), ElementsAre(VertexRef{3, 0, 0}));
  EXPECT_THAT(index.edges_at({10.1, -4}), SizeIs(0));
}

TEST(SnapIndex, FollowsEditsAndFindsWhatALookAtAllFinds) {
  LabelDocument document = test_document(300, 200);
  SnapIndex index(document);
  for (std::uint32_t step = 0; step < 120; ++step) {
    const LabelEdit edit = random_edit(document, 71, step);
    document.apply(edit);
    index.apply(edit);
    const auto [x, y] = uniforms({72, 0, step, 0, 0});
    const Eigen::Vector2d point(300.0 * x, -200.0 * y);
    double vertex_m = 1e9;
    double edge_m = 1e9;
    for (const auto& [id, placed] : document.objects()) {
      const LabelObject& object = *placed.object;
      for (const Ring& ring : object.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          vertex_m = std::min(vertex_m, (ring[i] - point).norm());
          if (object.kind == ObjectKind::kLine && i + 1 == ring.size()) break;
          const Eigen::Vector2d a = ring[i];
          const Eigen::Vector2d along = ring[(i + 1) % ring.size()] - a;
          const double t = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
          edge_m = std::min(edge_m, (a + t * along - point).norm());
        }
      }
    }
    const auto found = index.nearest(point, 5.0);
    const double expected = vertex_m <= 5.0 ? vertex_m : edge_m;
    ASSERT_EQ(found.has_value(), expected <= 5.0) << step;
    if (found) {
      EXPECT_NEAR((found->in_enu_m - point).norm(), expected, 2e-6);
    }
  }
}

TEST(SnapToDirection, GoesStraightOnOrSquare) {
  const Ring drawn{{0, 0}, {10, 0}};
  const auto along = snap_to_direction(drawn, {17, 0.2}, 0.5);
  ASSERT_TRUE(along);
  EXPECT_EQ(along->kind, SnapKind::kAlong);
  EXPECT_EQ(along->in_enu_m, Eigen::Vector2d(17, 0));
  const auto square = snap_to_direction(drawn, {10.3, -8}, 0.5);
  ASSERT_TRUE(square);
  EXPECT_EQ(square->kind, SnapKind::kSquare);
  EXPECT_EQ(square->in_enu_m, Eigen::Vector2d(10, -8));
  EXPECT_FALSE(snap_to_direction(drawn, {15, 5}, 0.5));
  EXPECT_FALSE(snap_to_direction(drawn, {5, 0.2}, 0.5)) << "that is back";
  EXPECT_FALSE(snap_to_direction({{1, 1}}, {5, 0.2}, 0.5));
}

TEST(TypedPlace, TakesFromThePointerWhatWasNotTyped) {
  const Eigen::Vector2d last(1, 1);
  EXPECT_EQ(typed_place(last, {4, 5}, 10.0, {}), Eigen::Vector2d(7, 9));
  EXPECT_EQ(typed_place(last, {4, 5}, {}, Angle::degrees(0.0)), Eigen::Vector2d(4, 1));
  EXPECT_EQ(typed_place(last, {4, 5}, 2.0, Angle::degrees(90.0)), Eigen::Vector2d(1, 3));
  EXPECT_EQ(typed_place(last, last, 2.0, {}), Eigen::Vector2d(3, 1));
}

class Tracing : public testing::Test {
 protected:
  Snap vertex(std::size_t place) const {
    return {SnapKind::kVertex, square_.rings[0][place], {1, 0, place}};
  }
  Snap on_edge(std::size_t before, Eigen::Vector2d place) const {
    return {SnapKind::kEdge, place, {1, 0, before}};
  }
  const LabelObject square_ = area(kRoad, {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}});
};

TEST_F(Tracing, TakesTheShorterWayOrTheOther) {
  EXPECT_THAT(*traced(square_, on_edge(0, {7, 0}), on_edge(1, {10, 4}), false, 0.0),
              ElementsAre(Eigen::Vector2d(7, 0), Eigen::Vector2d(10, 0), Eigen::Vector2d(10, 4)));
  EXPECT_THAT(*traced(square_, on_edge(1, {10, 4}), on_edge(0, {7, 0}), false, 0.0),
              ElementsAre(Eigen::Vector2d(10, 4), Eigen::Vector2d(10, 0), Eigen::Vector2d(7, 0)));
  EXPECT_THAT(*traced(square_, on_edge(0, {7, 0}), on_edge(1, {10, 4}), true, 0.0), SizeIs(5));
  EXPECT_THAT(*traced(square_, vertex(3), vertex(0), false, 0.0), SizeIs(2));
  EXPECT_THAT(*traced(square_, on_edge(0, {7, 0}), on_edge(0, {2, 0}), false, 0.0), SizeIs(2));
  EXPECT_THAT(*traced(square_, on_edge(0, {7, 0}), on_edge(0, {2, 0}), true, 0.0), SizeIs(6));
}

TEST_F(Tracing, GivesAParallelToItsLeft) {
  EXPECT_THAT(*traced(square_, vertex(0), vertex(2), false, 1.0),
              ElementsAre(Eigen::Vector2d(0, 1), Eigen::Vector2d(9, 1), Eigen::Vector2d(9, 10)));
  EXPECT_THAT(error_text(traced(square_, vertex(0), vertex(2), false, 100.0)),
              HasSubstr("bends too sharply"));
}

TEST_F(Tracing, StaysOnOneBorder) {
  const Snap other{SnapKind::kVertex, {10, 0}, {2, 0, 0}};
  EXPECT_THAT(error_text(traced(square_, vertex(0), other, false, 0.0)),
              HasSubstr("must lie on the same border"));
  const LabelObject road = line(kRoad, {{0, 0}, {10, 0}, {10, 10}}, 3.0);
  EXPECT_THAT(*traced(road, {SnapKind::kVertex, {10, 10}, {1, 0, 2}},
                      {SnapKind::kEdge, {4, 0}, {1, 0, 0}}, false, 0.0),
              ElementsAre(Eigen::Vector2d(10, 10), Eigen::Vector2d(10, 0), Eigen::Vector2d(4, 0)));
  EXPECT_THAT(error_text(traced(road, vertex(0), vertex(2), true, 0.0)), HasSubstr("one way only"));
}

TEST(Beside, IsAParallelWhoseInnerCornersDoNotCross) {
  EXPECT_THAT((*beside({{0, 0}, {10, 0}, {10, 10}}, 1.0))[0],
              ElementsAre(Eigen::Vector2d(0, 1), Eigen::Vector2d(9, 1), Eigen::Vector2d(9, 10)));
  EXPECT_THAT(
      (*beside({{0, 0}, {10, 0}, {10, 10}}, -1.0))[0],
      ElementsAre(Eigen::Vector2d(0, -1), Eigen::Vector2d(11, -1), Eigen::Vector2d(11, 10)));
  EXPECT_THAT(*beside({{0, 0}, {10, 0}, {10, 3}, {0, 3}}, 2.0), SizeIs(0)) << "no room inside";
  const auto around = beside({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}, -1.0);
  EXPECT_THAT((*around)[0], SizeIs(5));
  EXPECT_EQ((*around)[0].front(), (*around)[0].back());
}

TEST(Beside, NoPlaceOfItLiesNearerThanItsDistance) {
  for (std::uint32_t i = 0; i < 40; ++i) {
    Ring line{{0, 0}};
    for (std::uint32_t step = 0; step < 12; ++step) {
      const auto [along, turn] = uniforms({81, 0, i, step, 0});
      const double angle = 1.6 * (turn - 0.5) + 0.1 * step;
      line.push_back(line.back() +
                     (1.0 + 9.0 * along) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    for (const double offset : {1.5, -1.5}) {
      const auto made = beside(line, offset);
      ASSERT_TRUE(made && !made->empty());
      for (const Ring& parallel : *made) {
        for (std::size_t p = 1; p < parallel.size(); ++p) {
          for (const double t : {0.0, 0.3, 0.5, 1.0}) {
            const Eigen::Vector2d place = parallel[p - 1] + t * (parallel[p] - parallel[p - 1]);
            double least = 1e9;
            for (std::size_t e = 1; e < line.size(); ++e) {
              const Eigen::Vector2d side = line[e] - line[e - 1];
              const double s =
                  std::clamp((place - line[e - 1]).dot(side) / side.squaredNorm(), 0.0, 1.0);
              least = std::min(least, (line[e - 1] + s * side - place).norm());
            }
            EXPECT_GE(least, 1.5 - 1e-5);
            EXPECT_LE(least, 1.5 * std::sqrt(2.0) + 1e-5);
          }
        }
      }
    }
  }
}

}  // namespace snapping_test
}  // namespace nadir
