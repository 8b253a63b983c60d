// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/core/label/label_file.h"

namespace nadir {
namespace foreign_changes_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A road, a curb and a house, closed.
class ForeignChangesTest : public LabelFile {
 protected:
  ForeignChangesTest() {
    const auto drawn = made().commit(
        adding({area(kRoad, {box(0, 0, 9, 5)}, 1), line(kCurb, ring({{0, 5}, {9, 5}}), 0.15, 2),
                outline(kBuilding, {box(1, 7, 5, 12)}, 0.3, 3)}));
    EXPECT_TRUE(drawn) << error_text(drawn);
  }
};

TEST_F(ForeignChangesTest, OfAClosedFileBecomeAStepThatCanBeUndone) {
  const LabelDocument before = opened().document();
  run_elsewhere("UPDATE area SET class = 'Terrain', note = 'moved'; DELETE FROM line");
  {
    LabelStore store = opened();
    EXPECT_EQ(store.document().object(1)->class_id, kTerrain);
    EXPECT_EQ(store.document().object(1)->note, "moved");
    EXPECT_EQ(store.document().object(2), nullptr);
    EXPECT_EQ(store.undo_step()->title, "Take over changes of another program");
  }
  LabelStore store = opened();
  EXPECT_EQ(store.history(1, 10)->size(), 2U);  // Taken over once.
  ASSERT_TRUE(store.undo());
  EXPECT_TRUE(store.document() == before);
  EXPECT_EQ(value_elsewhere("SELECT class FROM area"), "road");
  EXPECT_EQ(value_elsewhere("SELECT width_m FROM line WHERE fid = 2"), "0.15");
}

TEST_F(ForeignChangesTest, WhileItIsOpenAreSeenAndNeverOverwritten) {
  LabelStore store = opened();
  ASSERT_TRUE(store.take_foreign_changes());
  EXPECT_TRUE(store.take_foreign_changes()->empty());
  run_elsewhere("UPDATE outline SET thickness_m = 0.5");
  const LabelEdit mine = adding({area(kRoad, {box(20, 20, 22, 22)}, 4)});
  EXPECT_THAT(error_text(store.commit(mine)), HasSubstr("another program has changed it"));
  EXPECT_FALSE(store.undo());
  const auto taken = store.take_foreign_changes();
  ASSERT_TRUE(taken) << error_text(taken);
  ASSERT_EQ(taken->objects.size(), 1U);
  EXPECT_EQ(taken->objects.front().after->width_m, 0.5);
  EXPECT_TRUE(store.commit(mine));
  EXPECT_EQ(store.document().object(3)->width_m, 0.5);
}

TEST_F(ForeignChangesTest, MayAddObjectsWithoutOrderUnderNumbersThatAreTaken) {
  // Number 1 is an area and 3 an outline; both tables may give 4.
  run_elsewhere(
      "INSERT INTO line (fid, geom, class, width_m) SELECT 1, geom, 'lane marking', 0.1 FROM line;"
      "INSERT INTO line (fid, geom, class, width_m) SELECT 4, geom, 'lane marking', 0.2 FROM line "
      "WHERE fid = 2;"
      "INSERT INTO area (fid, geom, class) SELECT 4, geom, 'sidewalk' FROM area");
  {
    const LabelStore store = opened();
    EXPECT_EQ(store.document().objects().size(), 6U);
    EXPECT_EQ(store.document().object(1)->class_id, kRoad);
    EXPECT_EQ(store.document().object(4)->class_id, kSidewalk);
    for (const ObjectId id : {5, 6}) {
      ASSERT_NE(store.document().object(id), nullptr);
      EXPECT_EQ(store.document().object(id)->class_id, kLaneMarking);
      EXPECT_EQ(level_of_order(store.document().object(id)->order), drawing_level(kLaneMarking));
    }
    EXPECT_THAT(store.notices(), IsEmpty());
  }
  EXPECT_EQ(value_elsewhere("SELECT group_concat(fid) FROM line"), "2,5,6");
  EXPECT_EQ(opened().history(1, 10)->size(), 2U);
}

TEST_F(ForeignChangesTest, ThatAreNoObjectsAreToldAndLeaveThingsAsTheyWere) {
  run_elsewhere(
      "UPDATE area SET class = 'lava'; UPDATE line SET width_m = NULL;"
      "UPDATE outline SET geom = x'4750';"
      "INSERT INTO outline (fid, geom, class, thickness_m) SELECT 9, geom, 'building', 1 FROM "
      "line");
  const LabelStore store = opened();
  EXPECT_EQ(store.document().objects().size(), 3U);
  EXPECT_EQ(store.document().object(1)->class_id, kRoad);
  EXPECT_EQ(store.document().object(2)->width_m, 0.15);
  EXPECT_THAT(store.notices(),
              ElementsAre("area 1: \"lava\" is no class, so it stays as it was",
                          "line 2: its width of 0 m is not in (0, 10000], so it stays as it was",
                          "outline 3: its geometry is cut off, so it stays as it was",
                          "outline 9: its geometry is of another kind"));
}

TEST_F(ForeignChangesTest, AnObjectOfSeveralPartsBecomesSeveral) {
  // MULTILINESTRING of the curb and another line: header without envelope, then well-known binary.
  run_elsewhere(
      "UPDATE line SET geom = x'47500001A0860100' || x'0105000000' || x'02000000'"
      "|| x'010200000002000000' || x'0000000000000000' || x'0000000000000000' || "
      "x'000000000000F03F' || x'0000000000000000'"
      "|| x'010200000002000000' || x'0000000000000000' || x'000000000000F03F' || "
      "x'000000000000F03F' || x'000000000000F03F'");
  run_elsewhere("UPDATE line SET geom = CAST(geom AS BLOB)");
  const LabelStore store = opened();
  EXPECT_THAT(store.notices(), IsEmpty());
  EXPECT_EQ(store.document().objects().size(), 4U);
  EXPECT_EQ(store.document().object(2)->rings.front(), (Ring{{0.0, 0.0}, {1.0, 0.0}}));
  EXPECT_EQ(store.document().object(4)->rings.front(), (Ring{{0.0, 1.0}, {1.0, 1.0}}));
}

TEST_F(ForeignChangesTest, ASpatialIndexThatAGisHasMadeIsKeptUpToDate) {
  // As the standard has it (annex F.3), cut to what inserting and updating run.
  run_elsewhere(
      "CREATE VIRTUAL TABLE rtree_area_geom USING rtree(id, minx, maxx, miny, maxy);"
      "CREATE TRIGGER rtree_area_geom_insert AFTER INSERT ON area WHEN (new.geom NOT NULL AND NOT "
      "ST_IsEmpty(NEW.geom)) BEGIN "
      "INSERT OR REPLACE INTO rtree_area_geom VALUES (NEW.fid, ST_MinX(NEW.geom), "
      "ST_MaxX(NEW.geom), ST_MinY(NEW.geom), ST_MaxY(NEW.geom)); END;"
      "CREATE TRIGGER rtree_area_geom_update1 AFTER UPDATE OF geom ON area WHEN OLD.fid = NEW.fid "
      "AND (NEW.geom NOTNULL AND NOT ST_IsEmpty(NEW.geom)) BEGIN "
      "INSERT OR REPLACE INTO rtree_area_geom VALUES (NEW.fid, ST_MinX(NEW.geom), "
      "ST_MaxX(NEW.geom), ST_MinY(NEW.geom), ST_MaxY(NEW.geom)); END;"
      "CREATE TRIGGER rtree_area_geom_delete AFTER DELETE ON area WHEN old.geom NOT NULL BEGIN "
      "DELETE FROM rtree_area_geom WHERE id = OLD.fid; END;");
  LabelStore store = opened();
  const auto done = store.commit(adding({area(kRoad, {box(20, 10, 25, 12)}, 4)}));
  ASSERT_TRUE(done) << error_text(done);
  EXPECT_EQ(value_elsewhere("SELECT minx || ' ' || maxx || ' ' || miny || ' ' || maxy "
                            "FROM rtree_area_geom WHERE id = 4"),
            "20.0 25.0 -12.0 -10.0");
  ASSERT_TRUE(store.undo());
  EXPECT_EQ(value_elsewhere("SELECT count(*) FROM rtree_area_geom"), "0");
}

}  // namespace foreign_changes_test
}  // namespace nadir
