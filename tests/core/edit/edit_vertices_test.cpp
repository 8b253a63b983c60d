// SPDX-License-Identifier: Apache-2.0
#include "core/edit/edit_vertices.h"

#include <gmock/gmock.h>

#include <numbers>

#include "core/edit/polygon_algebra.h"
#include "tests/core/edit/edited_labels.h"

namespace nadir {
namespace edit_vertices_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr std::array<ObjectId, 2> kBoth{1, 2};

/// Two areas with a jagged border between them.
LabelDocument jagged_neighbours() {
  Ring left{{0, 0}};
  Ring right{{20, 0}};
  Ring border;
  for (int i = 0; i <= 40; ++i)
    border.emplace_back(10.0 + 0.05 * (i % 2) + 0.3 * (i % 7), -0.5 * i);
  left.insert(left.end(), border.begin(), border.end());
  left.emplace_back(0, -20);
  right.emplace_back(20, -20);
  right.insert(right.end(), border.rbegin(), border.rend());
  std::rotate(right.begin(), right.begin() + 17, right.end());
  return document_of({area(kRoad, {left}, 1), area(kTerrain, {right}, 2)});
}

LabelDocument neighbours() {
  return document_of({area(kRoad, {box(0, 0, 10, 10)}, 1), area(kTerrain, {box(10, 0, 20, 10)}, 2),
                      line(kCurb, ring({{10, 0}, {10, 10}}), 0.2, 3)});
}

void expect_no_gap(const LabelDocument& document, int from_column = 0) {
  const Raster<int> claimed = cells_claimed(document);
  for (int row = 0; row < 20; ++row) {
    for (int column = from_column; column < 20; ++column) EXPECT_EQ(claimed.at(column, row), 1);
  }
}

TEST(MoveVertex, MovesAllThatShareIt) {
  const LabelDocument document = neighbours();
  const auto after =
      edited(document, move_vertex(document, {1, 0, 2}, {12.3, -11.7}, SharedBorders::kTogether));
  const Eigen::Vector2d moved = on_lattice({12.3, -11.7});
  EXPECT_EQ(object_in(after, 1).rings[0][2], moved);
  EXPECT_EQ(object_in(after, 2).rings[0][3], moved);
  EXPECT_EQ(object_in(after, 3).rings[0][1], moved);
  EXPECT_EQ(shared_places(after), shared_places(document));
}

TEST(MoveVertex, MovesOneAloneIfAsked) {
  const LabelDocument document = neighbours();
  const auto edit = move_vertex(document, {1, 0, 2}, {12, -12}, SharedBorders::kAlone);
  ASSERT_TRUE(edit);
  EXPECT_THAT(edit->objects, SizeIs(1));
  EXPECT_EQ(object_in(edited(document, edit), 2), object_in(document, 2));
}

TEST(MoveVertex, RefusesWhatWouldBeUnsoundInOneSentence) {
  const LabelDocument document = neighbours();
  EXPECT_THAT(error_text(move_vertex(document, {1, 0, 2}, {5, 5}, SharedBorders::kAlone)),
              HasSubstr("area 1 would cross itself at"));
  const LabelDocument triangle = document_of({area(kRoad, {ring({{0, 0}, {9, 0}, {0, 9}})}, 1)});
  EXPECT_THAT(error_text(move_vertex(triangle, {1, 0, 2}, {0, 0}, SharedBorders::kTogether)),
              HasSubstr("a ring has 2 different places, and needs 3"));
  EXPECT_THAT(error_text(move_vertex(triangle, {1, 0, 2}, {4.5, 0}, SharedBorders::kTogether)),
              HasSubstr("would have no inside"));
  EXPECT_THAT(error_text(move_vertex(triangle, {1, 0, 3}, {1, 1}, SharedBorders::kTogether)),
              HasSubstr("area 1 has no such place"));
  EXPECT_THAT(error_text(move_vertex(triangle, {7, 0, 0}, {1, 1}, SharedBorders::kTogether)),
              HasSubstr("there is no object 7"));
  EXPECT_FALSE(move_vertex(triangle, {1, 0, 0}, {std::nan(""), 0}, SharedBorders::kTogether));
  EXPECT_FALSE(move_vertex(triangle, {1, 0, 0}, {1e300, 0}, SharedBorders::kTogether));
}

TEST(MoveVertex, MovesCornersTogetherThatAnotherProgramHasRounded) {
  // Borders as two programs write them: equal but for the last bits.
  LabelDocument document = document_of(
      {area(kRoad, {box(0, 0, 10, 10)}, 1),
       area(kTerrain, {ring({{10 + 4e-7, 3e-7}, {20, 0}, {20, 10}, {10, 10 - 1e-6}})}, 2)});
  const auto together =
      edited(document, move_vertex(document, {1, 0, 2}, {12, -12}, SharedBorders::kTogether));
  EXPECT_EQ(object_in(together, 2).rings[0][3], Eigen::Vector2d(12, -12));
  EXPECT_EQ(shared_places(together), 1U);
  const auto with_more =
      edited(document, add_vertex(document, {1, 0, 1}, {10.5, -5}, SharedBorders::kTogether));
  EXPECT_THAT(object_in(with_more, 2).rings[0], SizeIs(5));
  const std::array<VertexRef, 1> corner{VertexRef{2, 0, 0}};
  const auto without =
      edited(document, remove_vertices(document, corner, SharedBorders::kTogether));
  EXPECT_THAT(object_in(without, 1).rings[0], SizeIs(3));
  const auto shifted =
      edited(document, move_vertices(document, corner, {1, 0}, SharedBorders::kTogether));
  EXPECT_EQ(object_in(shifted, 1).rings[0][1], object_in(shifted, 2).rings[0][0]);
}

TEST(MoveVertices, MovesEachOnceWithAllThatShareIt) {
  const LabelDocument document = neighbours();
  // The same border named by both of its neighbours, one corner twice.
  const std::array<VertexRef, 4> border{VertexRef{1, 0, 1}, VertexRef{2, 0, 3}, VertexRef{3, 0, 1},
                                        VertexRef{1, 0, 1}};
  const auto after =
      edited(document, move_vertices(document, border, {1.5, -0.25}, SharedBorders::kTogether));
  EXPECT_EQ(object_in(after, 1).rings[0], ring({{0, 0}, {11.5, 0.25}, {11.5, 10.25}, {0, 10}}));
  EXPECT_EQ(object_in(after, 3).rings[0], ring({{11.5, 0.25}, {11.5, 10.25}}));
  EXPECT_EQ(shared_places(after), shared_places(document));
  const auto alone =
      edited(document, move_vertices(document, border, {1.5, -0.25}, SharedBorders::kAlone));
  EXPECT_EQ(object_in(alone, 1).rings[0], ring({{0, 0}, {11.5, 0.25}, {10, 10}, {0, 10}}));
  EXPECT_EQ(object_in(alone, 2).rings[0], ring({{10, 0}, {20, 0}, {20, 10}, {11.5, 10.25}}));
  EXPECT_TRUE(move_vertices(document, border, {0, 0}, SharedBorders::kTogether)->empty());
}

TEST(MoveVertices, RefusesWhatWouldCrossItselfInOneSentence) {
  const LabelDocument document = neighbours();
  const std::array<VertexRef, 2> opposite{VertexRef{1, 0, 0}, VertexRef{1, 0, 2}};
  EXPECT_THAT(error_text(move_vertices(document, opposite, {0, -11}, SharedBorders::kTogether)),
              HasSubstr("Move vertices: area 1 would cross itself at"));
  const std::array<VertexRef, 2> border{VertexRef{1, 0, 1}, VertexRef{3, 0, 0}};
  EXPECT_THAT(error_text(move_vertices(document, border, {15, -5}, SharedBorders::kTogether)),
              HasSubstr("Move vertices: area 2 would cross itself at"))
      << "a neighbour that nobody has picked";
  const std::array<VertexRef, 1> none{VertexRef{1, 0, 4}};
  EXPECT_THAT(error_text(move_vertices(document, none, {1, 1}, SharedBorders::kAlone)),
              HasSubstr("area 1 has no such place"));
}

TEST(AddVertex, GoesIntoEveryRingWithThatEdge) {
  const LabelDocument document = neighbours();
  const auto after =
      edited(document, add_vertex(document, {2, 0, 3}, {10.5, -5}, SharedBorders::kTogether));
  EXPECT_THAT(object_in(after, 1).rings[0], SizeIs(5));
  EXPECT_THAT(object_in(after, 2).rings[0], SizeIs(5));
  EXPECT_THAT(object_in(after, 3).rings[0], SizeIs(3));
  EXPECT_EQ(shared_places(after), 3U);
  EXPECT_THAT(error_text(add_vertex(document, {3, 0, 1}, {10, -12}, SharedBorders::kTogether)),
              HasSubstr("line 3 ends there"));
}

TEST(RemoveVertices, TakesHolesAndObjectsThatAreLeftWithTwo) {
  const LabelDocument document =
      document_of({area(kRoad, {box(0, 0, 10, 10), ring({{2, 2}, {4, 2}, {2, 4}})}, 1),
                   area(kTerrain, {box(10, 0, 20, 10)}, 2)});
  const std::array<VertexRef, 1> of_hole{VertexRef{1, 1, 0}};
  const auto filled =
      edited(document, remove_vertices(document, of_hole, SharedBorders::kTogether));
  EXPECT_THAT(object_in(filled, 1).rings, SizeIs(1));
  const std::array<VertexRef, 2> of_border{VertexRef{1, 0, 1}, VertexRef{1, 0, 2}};
  const auto together =
      edited(document, remove_vertices(document, of_border, SharedBorders::kTogether));
  EXPECT_THAT(together.objects(), SizeIs(0)) << "both had only four";
  const auto alone = edited(document, remove_vertices(document, of_border, SharedBorders::kAlone));
  EXPECT_EQ(alone.objects().count(1), 0U);
  EXPECT_EQ(alone.objects().count(2), 1U);
}

TEST(MoveObjects, KeepsWhatTheyShare) {
  const LabelDocument document = neighbours();
  const std::array<ObjectId, 3> all{1, 2, 3};
  const auto after = edited(document, move_objects(document, all, {3.1, -0.7}));
  EXPECT_EQ(shared_places(after), shared_places(document));
  EXPECT_NEAR(object_in(after, 1).rings[0][0].x(), 3.1, kLatticeM);
  EXPECT_TRUE(move_objects(document, all, {0, 0})->empty());
  EXPECT_EQ(error_text(move_objects(document, {}, {1, 0})), "no object is selected");
}

TEST(Simplify, KeepsSharedBordersShared) {
  const LabelDocument document = jagged_neighbours();
  const std::array<ObjectId, 1> one{1};
  const auto after = edited(document, simplify(document, one, 0.2));
  EXPECT_LT(object_in(after, 1).rings[0].size(), object_in(document, 1).rings[0].size() - 4);
  // Of the border all that is left is shared, also by the one that was not asked for.
  EXPECT_EQ(shared_places(after), object_in(after, 1).rings[0].size() - 2);
  EXPECT_EQ(shared_places(after), object_in(after, 2).rings[0].size() - 2);
  expect_no_gap(after);
}

TEST(Simplify, LeavesFewerPlacesOutWhereAnAreaWouldCrossItself) {
  // A narrow bay: a tolerance wider than it would fold it.
  Ring bay{{0, 0}, {20, 0}, {20, -10}};
  for (int i = 0; i <= 10; ++i) bay.emplace_back(15.0 - i, -10.0 + 3.0 * std::sin(i * 0.6));
  bay.emplace_back(0, -10);
  const LabelDocument document = document_of({area(kRoad, {bay, box(8, 2, 9, 6)}, 1)});
  const std::array<ObjectId, 1> one{1};
  for (const double tolerance : {0.1, 1.0, 3.0, 5.0, 50.0}) {
    const auto after = edited(document, simplify(document, one, tolerance));
    EXPECT_TRUE(check_object(object_in(after, 1)));
    EXPECT_EQ(object_in(after, 1).rings.size(), 2U);
  }
  EXPECT_FALSE(simplify(document, one, 0.0));
  EXPECT_FALSE(simplify(document, one, std::nan("")));
}

TEST(Smooth, KeepsEndsAndSharedBorders) {
  const LabelDocument document = jagged_neighbours();
  const std::array<ObjectId, 1> one{1};
  const auto after = edited(document, smooth(document, one));
  EXPECT_GT(shared_places(after), shared_places(document));
  expect_no_gap(after, 4);  // Corners to the left are round now.
  const LabelDocument road = document_of({line(kRoad, {{0, 0}, {8, 0}, {8, -8}}, 2.0, 1)});
  EXPECT_THAT(object_in(edited(road, smooth(road, one)), 1).rings[0],
              ElementsAre(Eigen::Vector2d(0, 0), Eigen::Vector2d(6, 0), Eigen::Vector2d(8, -2),
                          Eigen::Vector2d(8, -8)));
}

TEST(Smooth, EndsWhereAMillionPlacesWouldBecomeTwo) {
  LabelDocument document = test_document();
  Ring comb;
  for (int i = 0; i < 1'000'001; ++i) comb.emplace_back(0.001 * i, i % 2);
  document.apply(adding({line(kRoad, comb, 1.0, 1)}));
  const std::array<ObjectId, 1> one{1};
  EXPECT_EQ(error_text(smooth(document, one)),
            "line 1 has 1000001 places, and would get twice as many");
}

TEST(Orthogonalise, MakesRightAnglesAndKeepsTheMiddle) {
  const double turn = 0.4;
  const auto turned = [&](double x, double y) {
    return Eigen::Vector2d(20 + std::cos(turn) * x - std::sin(turn) * y,
                           -10 + std::sin(turn) * x + std::cos(turn) * y);
  };
  const Ring wonky{turned(0, 0.3),   turned(10, -0.2), turned(10.2, 4),
                   turned(5.9, 4.1), turned(6, 8),     turned(0.2, 7.8)};
  const LabelDocument document = document_of({area(kBuilding, {wonky}, 1)});
  const std::array<ObjectId, 1> one{1};
  const auto after = edited(document, orthogonalise(document, one, Angle::degrees(15.0)));
  const Ring& square = object_in(after, 1).rings[0];
  Eigen::Vector2d before = Eigen::Vector2d::Zero();
  Eigen::Vector2d now = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < square.size(); ++i) {
    const Eigen::Vector2d in = (square[i] - square[(i + 5) % 6]).normalized();
    const Eigen::Vector2d out = (square[(i + 1) % 6] - square[i]).normalized();
    EXPECT_NEAR(in.dot(out), 0.0, 1e-5);
    EXPECT_LT((square[i] - wonky[i]).norm(), 0.5);
    before += wonky[i];
    now += square[i];
  }
  EXPECT_LT((before - now).norm(), 1e-5);
}

TEST(Orthogonalise, MovesNeighboursAlongAndRefusesTriangles) {
  const LabelDocument document =
      document_of({area(kBuilding, {ring({{0, 0}, {10, 0.4}, {10.3, 10}, {0, 10}})}, 1),
                   area(kTerrain, {ring({{10, 0.4}, {20, 0}, {20, 10}, {10.3, 10}})}, 2)});
  const std::array<ObjectId, 1> one{1};
  const auto after = edited(document, orthogonalise(document, one, Angle::degrees(10.0)));
  EXPECT_EQ(shared_places(after), 2U);
  const LabelDocument triangle =
      document_of({area(kBuilding, {ring({{0, 0}, {10, 0}, {5, 9}})}, 1)});
  EXPECT_THAT(error_text(orthogonalise(triangle, one, Angle::degrees(45.0))),
              HasSubstr("area 1 has too few right angles"));
  EXPECT_FALSE(orthogonalise(triangle, one, Angle::degrees(46.0)));
}

TEST(JoinBorders, MakesNearlyEqualBordersEqual) {
  const LabelDocument document = document_of(
      {area(kRoad, {ring({{0, 0}, {10, 0}, {10.02, 20}, {0, 20}})}, 1),
       area(kTerrain, {ring({{10.03, 0.01}, {20, 0}, {20, 20}, {10, 20}, {9.97, 9}})}, 2)});
  EXPECT_EQ(shared_places(document), 0U);
  const auto after = edited(document, join_borders(document, kBoth, 0.1));
  EXPECT_EQ(shared_places(after), 3U);
  expect_no_gap(after);
  EXPECT_TRUE(join_borders(after, kBoth, 0.1)->empty()) << "once is enough";
  EXPECT_FALSE(join_borders(document, kBoth, 0.0));
}

TEST(JoinBorders, LeavesWhatIsSmallerThanTheReach) {
  const LabelDocument document =
      document_of({area(kRoad, {box(0, 0, 10, 10)}, 1), area(kPole, {box(9.9, 4, 10.1, 4.2)}, 2)});
  const auto after = edited(document, join_borders(document, kBoth, 0.5));
  EXPECT_EQ(after.objects().size(), 2U);
  EXPECT_TRUE(check_object(object_in(after, 2)));
}

TEST(EditVertices, MillionPlacesAreMovedInAMoment) {
  Ring wheel;
  for (int i = 0; i < 1'000'000; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 1e6;
    wheel.emplace_back(1000.0 * std::cos(angle), 1000.0 * std::sin(angle));
  }
  LabelDocument document = test_document();
  document.apply(adding({area(kRoad, {wheel}, 1)}));
  const auto edit = move_vertex(document, {1, 0, 5}, {1000.5, 0.1}, SharedBorders::kTogether);
  ASSERT_TRUE(edit) << error_text(edit);
  EXPECT_EQ(edit->objects.at(0).after->rings[0][5], on_lattice({1000.5, 0.1}));
  EXPECT_THAT(error_text(move_vertex(document, {1, 0, 5}, {-1001, 0.1}, SharedBorders::kTogether)),
              HasSubstr("would cross itself"));
}

}  // namespace edit_vertices_test
}  // namespace nadir
