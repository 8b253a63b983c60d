// SPDX-License-Identifier: Apache-2.0
#include "core/edit/edit_objects.h"

#include <gmock/gmock.h>

#include <numbers>

#include "core/edit/polygon_algebra.h"
#include "core/edit/street_profile.h"
#include "tests/core/edit/edited_labels.h"

namespace nadir {
namespace edit_objects_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

TEST(Draw, PutsAnObjectOnTopOfItsLevel) {
  const LabelDocument document = document_of({area(kRoad, {box(0, 0, 10, 10)}, 4)});
  const auto edit = draw(document, {ObjectKind::kArea, kRoad, 0.0}, box(10, 2, 20, 8));
  ASSERT_TRUE(edit) << error_text(edit);
  EXPECT_EQ(edit->title, "Draw road");
  const auto after = edited(document, edit);
  EXPECT_GT(object_in(after, 5).order, object_in(after, 4).order);
  // It begins on an edge of the other one, which gets its places.
  EXPECT_THAT(object_in(after, 4).rings[0], SizeIs(6));
  EXPECT_EQ(shared_places(after), 2U);
}

TEST(Draw, RefusesWhatIsNothingInOneSentence) {
  const LabelDocument document = test_document();
  const auto said = [&](ObjectKind kind, double width_m, Ring places) {
    return error_text(draw(document, {kind, kRoad, width_m}, std::move(places)));
  };
  EXPECT_THAT(said(ObjectKind::kArea, 0.0, ring({{0, 0}, {10, 10}, {10, 0}, {0, 10}})),
              HasSubstr("Draw road: area 1 would cross itself at 5.00 E, -5.00 N"));
  EXPECT_THAT(said(ObjectKind::kArea, 0.0, ring({{0, 0}, {10, 10}})),
              HasSubstr("a ring has 2 different places, and needs 3"));
  EXPECT_THAT(said(ObjectKind::kArea, 0.0, ring({{0, 0}, {5, 5}, {10, 10}})),
              HasSubstr("would have no inside"));
  EXPECT_THAT(said(ObjectKind::kLine, 2.0, ring({{0, 0}, {1e-8, 0}})),
              HasSubstr("it has 1 different places, and needs 2"));
  EXPECT_THAT(said(ObjectKind::kLine, 0.0, ring({{0, 0}, {1, 0}})), HasSubstr("width"));
  EXPECT_THAT(said(ObjectKind::kArea, 0.0, {}), HasSubstr("needs 3"));
}

TEST(Draw, TakesAPolygonOfManyPlaces) {
  const LabelDocument document = test_document();
  const Ring wheel = circle({0, 0}, 3000.0, 200'000);
  const auto edit = draw(document, {ObjectKind::kArea, kRoad, 0.0}, wheel);
  ASSERT_TRUE(edit) << error_text(edit);
  Ring scribble;
  for (std::uint32_t i = 0; i < 5'000; ++i) {
    const auto [x, y] = uniforms({19, 0, 0, i, 0});
    scribble.emplace_back(1000.0 * x, 1000.0 * y);
  }
  EXPECT_THAT(error_text(draw(document, {ObjectKind::kArea, kRoad, 0.0}, scribble)),
              HasSubstr("borders cross more than"));
}

TEST(Shapes, AreWhatTheyAreCalled) {
  const Ring box = rectangle({0, 0}, {3, 4}, 10.0);
  EXPECT_THAT(box, ElementsAre(Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 4),
                               Eigen::Vector2d(-5, 10), Eigen::Vector2d(-8, 6)));
  const Ring round = circle({5, 5}, 2.0);
  ASSERT_THAT(round, SizeIs(64));
  EXPECT_EQ(round[0], Eigen::Vector2d(7, 5));
  for (const Eigen::Vector2d& place : round)
    EXPECT_NEAR((place - Eigen::Vector2d(5, 5)).norm(), 2.0, 2e-6);
}

TEST(Reclass, KeepsTheOrderAmongThoseThatChange) {
  LabelObject high = area(kRoad, {box(0, 0, 10, 10)}, 1);
  high.order += 5;
  const LabelDocument document =
      document_of({high, area(kRoad, {box(5, 5, 9, 9)}, 2), area(kBuilding, {box(0, 0, 3, 3)}, 3)});
  const std::array<ObjectId, 2> both{1, 2};
  const auto after = edited(document, reclass(document, both, kBuilding));
  EXPECT_GT(object_in(after, 1).order, object_in(after, 2).order);
  EXPECT_GT(object_in(after, 2).order, object_in(after, 3).order);
  EXPECT_EQ(level_of_order(object_in(after, 1).order), drawing_level(kBuilding));
  EXPECT_FALSE(reclass(document, both, kSky));
}

TEST(SetWidth, IsForWhatHasOne) {
  const LabelDocument document =
      document_of({line(kRoad, ring({{0, 0}, {5, 5}}), 3.0, 1), area(kRoad, {box(0, 0, 3, 3)}, 2)});
  const std::array<ObjectId, 2> all{1, 2};
  const auto after = edited(document, set_width(document, std::span(all.data(), 1), 4.5));
  EXPECT_EQ(object_in(after, 1).width_m, 4.5);
  EXPECT_EQ(error_text(set_width(document, all, 4.5)), "area 2 has no width");
  EXPECT_FALSE(set_width(document, std::span(all.data(), 1), 0.0));
}

TEST(Reorder, MovesAmongWhatLiesThere) {
  std::vector<LabelObject> objects;
  for (ObjectId id = 1; id <= 4; ++id) {
    objects.push_back(area(kRoad, {box(0, 0, 10, 10)}, id));
    objects.back().order = 100 + id % 2;  // no room between them
  }
  objects.push_back(area(kRoad, {box(20, 20, 30, 29)}, 5));
  const LabelDocument document = document_of(objects);
  const auto drawn = [](const LabelDocument& after) {
    std::vector<std::pair<std::int64_t, ObjectId>> order;
    for (const auto& [id, placed] : after.objects()) order.emplace_back(placed.object->order, id);
    std::sort(order.begin(), order.end());
    std::vector<ObjectId> ids;
    for (const auto& [at, id] : order)
      if (id != 5) ids.push_back(id);
    return ids;
  };
  EXPECT_THAT(drawn(document), ElementsAre(2, 4, 1, 3));
  const auto moved = [&](std::vector<ObjectId> ids, OrderMove move) {
    return drawn(edited(document, reorder(document, ids, move)));
  };
  EXPECT_THAT(moved({4}, OrderMove::kUp), ElementsAre(2, 1, 4, 3));
  EXPECT_THAT(moved({1}, OrderMove::kDown), ElementsAre(2, 1, 4, 3));
  EXPECT_THAT(moved({2}, OrderMove::kTop), ElementsAre(4, 1, 3, 2));
  EXPECT_THAT(moved({3}, OrderMove::kBottom), ElementsAre(3, 2, 4, 1));
  EXPECT_THAT(moved({2, 4}, OrderMove::kUp), ElementsAre(1, 2, 4, 3));
  EXPECT_THAT(moved({2, 4}, OrderMove::kTop), ElementsAre(1, 3, 2, 4));
  EXPECT_THAT(moved({1, 3}, OrderMove::kBottom), ElementsAre(1, 3, 2, 4));
  EXPECT_THAT(moved({3}, OrderMove::kUp), ElementsAre(2, 4, 1, 3)) << "is on top already";
}

TEST(Clipboard, GivesTheSameObjectsBack) {
  LabelObject park = area(kVegetation, {box(0, 0, 10.123456789, 10), box(2, 2, 4, 4)}, 1);
  park.note = "\"park\"\n\xff";
  const LabelDocument document =
      document_of({park, line(kLaneMarking, ring({{0, 0}, {5, 5.1}}), 0.12, 2),
                   outline(kBuilding, {box(20, 20, 30, 29)}, 0.4, 3)});
  const std::array<ObjectId, 3> all{1, 2, 3};
  const auto text = objects_text(document, all);
  ASSERT_TRUE(text) << error_text(text);
  const auto after = edited(document, paste(document, *text, {0, 0}));
  ASSERT_EQ(after.objects().size(), 6U);
  for (ObjectId id = 4; id <= 6; ++id) {
    const LabelObject& pasted = object_in(after, id);
    const auto same = std::find_if(all.begin(), all.end(), [&](ObjectId other) {
      return object_in(document, other).rings == pasted.rings;
    });
    ASSERT_NE(same, all.end());
    EXPECT_EQ(pasted.kind, object_in(document, *same).kind);
    EXPECT_EQ(pasted.class_id, object_in(document, *same).class_id);
    EXPECT_EQ(pasted.width_m, object_in(document, *same).width_m);
  }
  const auto moved = edited(document, duplicate(document, std::span(all.data(), 1), {30, 1}));
  EXPECT_EQ(object_in(moved, 4).rings[0][0], Eigen::Vector2d(30, 1));
}

TEST(Clipboard, RefusesOtherTextsInOneSentence) {
  const LabelDocument document = test_document();
  for (const char* const text : {"", "hello", "[]", "{\"type\":\"FeatureCollection\"}", "null"}) {
    EXPECT_EQ(error_text(paste(document, text, {0, 0})),
              "the clipboard holds no objects of a label map");
  }
  const std::string begin = R"({"frame":"enu","features":[{"properties":{"kind":"area","class":)";
  EXPECT_THAT(error_text(paste(document, begin + R"("water"}}]})", {0, 0})), HasSubstr("no class"));
  EXPECT_THAT(error_text(paste(document, begin + R"("road"}}]})", {0, 0})), HasSubstr("no places"));
  EXPECT_THAT(error_text(paste(document, begin + R"("road"},"geometry":{"coordinates":[[[1]]]}}]})",
                               {0, 0})),
              HasSubstr("a place is not two numbers"));
}

constexpr const char* kProfile = R"(
name = "lane"
[[strip]]
class = "road"
width_m = 6.0
[[strip]]
class = "curb"
offset_m = 3.1
width_m = 0.2
both_sides = true
[[strip]]
class = "lane marking"
width_m = 0.12
dash_m = 3.0
gap_m = 6.0
)";

TEST(StreetProfile, DrawsAllStripsAsOneStep) {
  const auto profile = StreetProfile::parse(kProfile, "lane.toml");
  ASSERT_TRUE(profile) << error_text(profile);
  EXPECT_THAT(profile->strips, SizeIs(4));
  const LabelDocument document = test_document();
  const auto after = edited(document, draw_street(document, *profile, ring({{0, 10}, {20, 10}})));
  ASSERT_EQ(after.objects().size(), 6U);
  EXPECT_EQ(object_in(after, 1).rings[0], ring({{0, 10}, {20, 10}}));
  EXPECT_NEAR(object_in(after, 2).rings[0][0].y(), -6.9, 1e-6);
  EXPECT_NEAR(object_in(after, 3).rings[0][0].y(), -13.1, 1e-6);
  EXPECT_EQ(object_in(after, 4).rings[0], ring({{0, 10}, {3, 10}}));
  EXPECT_EQ(object_in(after, 5).rings[0], ring({{9, 10}, {12, 10}}));
  EXPECT_EQ(object_in(after, 6).rings[0], ring({{18, 10}, {20, 10}})) << "to the end of the line";
}

TEST(StreetProfile, DashesGoAroundCornersAndCurbsDoNotCross) {
  const auto profile = StreetProfile::parse(kProfile, "lane.toml");
  const LabelDocument document = test_document(100, 100);
  const auto after = edited(
      document, draw_street(document, *profile, ring({{10, 80}, {40, 80}, {40, 40}, {80, 40}})));
  double dashes_m = 0.0;
  for (const auto& [id, placed] : after.objects()) {
    const LabelObject& object = *placed.object;
    if (object.class_id == kCurb) {
      EXPECT_THAT(object.rings[0], SizeIs(4));
    }
    if (object.class_id != kLaneMarking) continue;
    for (std::size_t i = 1; i < object.rings[0].size(); ++i)
      dashes_m += (object.rings[0][i] - object.rings[0][i - 1]).norm();
  }
  EXPECT_NEAR(dashes_m, 12 * 3.0 + 2.0, 1e-4) << "of 110 m";
  EXPECT_THAT(error_text(draw_street(document, *profile, ring({{0, 0}, {9, 0}, {9, 3}, {0, 3}}))),
              HasSubstr("lane: the line bends too sharply, or meets itself, for curb"));
  EXPECT_FALSE(draw_street(document, *profile, ring({{0, 0}})));
}

TEST(StreetProfile, TheBundledOnesCanBeReadAndDrawn) {
  const std::filesystem::path folder =
      std::filesystem::path(NADIR_SOURCE_DIR) / "resources/profiles";
  const LabelDocument document = test_document(200, 200);
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const auto profile = StreetProfile::read(file.path());
    ASSERT_TRUE(profile) << error_text(profile);
    EXPECT_TRUE(draw_street(document, *profile, ring({{0, 10}, {90, 30}, {150, 100}})));
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST(StreetProfile, SaysWhatIsWrongWithAFile) {
  const auto said = [](const std::string& text) {
    return error_text(StreetProfile::parse("name = \"x\"\n" + text, "lane.toml"));
  };
  const std::string strip = "[[strip]]\nclass = \"road\"\n";
  EXPECT_THAT(said(strip), HasSubstr("width_m of 0 is not in [0.001, 100]"));
  EXPECT_THAT(said(strip + "width_m = -1"), HasSubstr("lane.toml"));
  EXPECT_THAT(said(strip + "width_m = 1\ndash_m = 2"), HasSubstr("dash_m and gap_m go together"));
  EXPECT_THAT(said(strip + "width_m = 1\ndash_m = 1e-9\ngap_m = 1"),
              HasSubstr("shorter than 0.01 m"));
  EXPECT_THAT(said(strip + "width_m = 1\nboth_sides = true"), HasSubstr("needs an offset_m"));
  EXPECT_THAT(said(strip + "wide_m = 1"), HasSubstr("did you mean width_m"));
  EXPECT_THAT(said("[[strip]]\nclass = \"sky\"\nwidth_m = 1"), HasSubstr("sky is no class"));
  EXPECT_THAT(said("strip = []"), HasSubstr("lane.toml"));
  EXPECT_EQ(StreetProfile::read("/nowhere/lane.toml").error().code, ErrorCode::kNotFound);
}

}  // namespace edit_objects_test
}  // namespace nadir
