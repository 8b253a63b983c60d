// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/desk/label_desk.h"
#include "core/label/label_store.h"
#include "core/map/overhead_map_file.h"
#include "core/session/label_view.h"
#include "tests/core/desk/desk_at_work.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_labels_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A session on a copy of the small world's map, whose labels may be drawn on.
class SessionLabels : public SessionTest {
 protected:
  SessionLabels() {
    fs::copy(SmallWorld::get().map, package_, fs::copy_options::recursive);
    fs::remove(package_ / "labels.gpkg");  // its labels begin as those of labels.tif
    begin();
  }
  void begin() {
    session_.reset();
    SessionPlaces here = places();
    here.resources = fs::path(NADIR_SOURCE_DIR) / "resources";
    here.author = "ada";
    session_ = std::make_unique<Session>(here);
  }
  /// Ends it, and begins another one that opens what was open.
  void begin_again() {
    begin();
    session_->restore();
    settle();
  }
  void open_labels() {
    act("label \"" + package_.string() + "\"");
    settle();
    ASSERT_NE(session_->label_desk(), nullptr) << testing::PrintToString(notice_texts());
  }
  [[nodiscard]] const LabelDesk& desk() const { return *session_->label_desk(); }
  [[nodiscard]] std::size_t object_count() const { return desk().sheet().now().objects().size(); }
  [[nodiscard]] ClassId class_at(double east_m, double north_m) const {
    return desk().under({east_m, north_m}).class_id;
  }
  /// A place of the map's middle, so many metres from it.
  [[nodiscard]] std::string places_at(const std::vector<Eigen::Vector2d>& places) const {
    std::string text;
    for (const Eigen::Vector2d& place : places) {
      const Eigen::Vector2d there = middle() + place;
      text += fmt::format(" {},{}", there.x(), there.y());
    }
    return text;
  }
  [[nodiscard]] Eigen::Vector2d middle() const {
    const LabelGrid& grid = desk().sheet().now().grid();
    return grid.enu_from_cells({0.5 * grid.width, 0.5 * grid.height});
  }
  void draw_box(const std::string& class_name = "building") {
    act("draw-area " + class_name + places_at({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}));
  }

  fs::path package_ = scratch_.path() / "town";
};

TEST_F(SessionLabels, BeginOnAPackageThatHasNoneYetWithoutAWordOfError) {
  const fs::path bare = half_a_road(scratch_.path(), true);
  fs::remove(bare / "labels.tif");
  act("label \"" + bare.string() + "\"");
  settle();
  ASSERT_NE(session_->label_desk(), nullptr);
  EXPECT_EQ(notice_texts(), std::vector<std::string>());
  draw_box();
  EXPECT_EQ(object_count(), 1U);
}

TEST_F(SessionLabels, OfAPackageAreOpenedWithItsMap) {
  open_labels();
  EXPECT_EQ(session_->label_view().workspace, Workspace::kLabel);
  EXPECT_EQ(session_->label_view().path, package_.string());
  EXPECT_EQ(session_->view().map_path, package_.string());
  ASSERT_NE(session_->map(), nullptr);
  EXPECT_FALSE(fs::exists(package_ / "labels.gpkg")) << "looking writes nothing";
  EXPECT_THAT(session_->recents(), testing::Contains(package_.string()));
}

TEST_F(SessionLabels, AreDrawnByWordsAndAreOnDiskAtOnce) {
  open_labels();
  draw_box();
  EXPECT_EQ(object_count(), 1U);
  EXPECT_EQ(class_at(middle().x(), middle().y()), kBuilding);
  // As a program does that is killed now and another one looks.
  const auto store = LabelStore::open(package_ / "labels.gpkg", "bob", LabelAccess::kRead);
  ASSERT_TRUE(store) << error_text(store);
  EXPECT_EQ(store->document(), desk().sheet().now());
}

TEST_F(SessionLabels, AreWhatUndoIsAboutInTheirWorkspaceAndTheViewInTheOther) {
  open_labels();
  act("layer-opacity labels 0.25");
  draw_box();
  ASSERT_TRUE(session_->undo_title());
  const std::string drawn = *session_->undo_title();
  act("undo");
  EXPECT_EQ(object_count(), 0U);
  EXPECT_EQ(session_->view().map.layer(Layer::kLabels).opacity, 0.25);
  EXPECT_EQ(session_->redo_title(), drawn);
  act("redo");
  EXPECT_EQ(object_count(), 1U);
  act("workspace replay");
  EXPECT_NE(session_->undo_title(), drawn);
  act("undo");
  EXPECT_EQ(object_count(), 1U);
  EXPECT_NE(session_->view().map.layer(Layer::kLabels).opacity, 0.25);
}

TEST_F(SessionLabels, HaveAnUndoThatSurvivesTheProgram) {
  open_labels();
  draw_box();
  begin_again();
  ASSERT_NE(session_->label_desk(), nullptr);
  EXPECT_EQ(session_->label_view().workspace, Workspace::kLabel);
  act("undo");
  EXPECT_EQ(object_count(), 0U);
}

TEST_F(SessionLabels, AreDrawnByTheToolPlaceByPlace) {
  open_labels();
  act("label-option tool area");
  act("label-option class building");
  for (const Eigen::Vector2d& place :
       {Eigen::Vector2d(-3, -1), Eigen::Vector2d(3, -1), Eigen::Vector2d(0, 4)}) {
    act("point" + fmt::format(" {} {}", middle().x() + place.x(), middle().y() + place.y()));
  }
  EXPECT_EQ(session_->undo_title(), "Last place");
  act("finish");
  EXPECT_EQ(object_count(), 1U);
  EXPECT_EQ(class_at(middle().x(), middle().y()), kBuilding);
  act("cancel-tool");  // the selection
  EXPECT_TRUE(desk().selection().empty());
  act("cancel-tool");
  EXPECT_EQ(session_->label_view().tool.kind, ToolKind::kSelect);
}

TEST_F(SessionLabels, KeepTheToolFromOneStartToTheNext) {
  open_labels();
  act("label-option tool line");
  act("label-option line-width 7.25");
  act("label-option class curb");
  act("last-class");
  const LabelTool tool = session_->label_view().tool;
  EXPECT_EQ(tool.class_id.id, kRoad);
  EXPECT_EQ(tool.last_class.id, kCurb);
  begin_again();
  EXPECT_EQ(session_->label_view().tool, tool);
  EXPECT_EQ(desk().tool(), tool);
}

TEST_F(SessionLabels, TakeLengthsAndBearingsThatAreTyped) {
  open_labels();
  act("label-option tool line");
  act("label-option snap false");
  act(fmt::format("point {} {}", middle().x(), middle().y()));
  act("leg length 5");
  act("leg bearing 90");
  act(fmt::format("point {} {}", middle().x() + 1.0, middle().y() + 3.0));
  act("finish");
  ASSERT_EQ(object_count(), 1U);
  const Ring line = desk().sheet().now().object(desk().selection().ids().front())->rings.front();
  EXPECT_NEAR((line[1] - line[0]).x(), 5.0, 1e-6);
  EXPECT_NEAR((line[1] - line[0]).y(), 0.0, 1e-6);
  EXPECT_THAT(refused("leg length -1"), HasSubstr("leads nowhere"));
}

TEST_F(SessionLabels, MayBeStreetsOfAProfile) {
  open_labels();
  ASSERT_FALSE(desk().profiles().empty());
  const std::string name = desk().profiles().front().name;
  act("draw-street \"" + name + "\"" + places_at({{-8, 0}, {8, 0}}));
  EXPECT_GT(object_count(), 2U);
  EXPECT_THAT(refused("draw-street motorwai" + places_at({{-8, 0}, {8, 0}})),
              HasSubstr("no street profile 'motorwai'"));
}

TEST_F(SessionLabels, ArePaintedErasedAndFilled) {
  open_labels();
  const ClassId before = class_at(middle().x(), middle().y());
  act("label-option paint-over true");
  act("stroke vegetation 1.5" + places_at({{-1, 0}, {1, 0}}));
  EXPECT_EQ(class_at(middle().x(), middle().y()), kVegetation);
  act("stroke nothing 3" + places_at({{-1, 0}, {1, 0}}));
  EXPECT_EQ(desk().under(middle()).paint, kNoPaint);
  act("undo");
  act("undo");
  EXPECT_EQ(class_at(middle().x(), middle().y()), before);
}

TEST_F(SessionLabels, AreSelectedMovedCopiedAndDeleted) {
  open_labels();
  draw_box();
  const ObjectId id = desk().selection().ids().front();
  act("select-labels");
  EXPECT_TRUE(desk().selection().empty());
  EXPECT_THAT(refused("labels delete"), HasSubstr("nothing is selected"));
  act(fmt::format("select-labels {}", id));
  const Eigen::Vector2d corner = desk().sheet().now().object(id)->rings.front().front();
  act("move-labels 10 0");
  const Eigen::Vector2d moved = desk().sheet().now().object(id)->rings.front().front();
  EXPECT_LT((moved - corner - Eigen::Vector2d(10.0, 0.0)).norm(), 1e-5);
  act("labels copy");
  const auto effects = session_->take_effects();
  ASSERT_EQ(effects.size(), 1U);
  const auto* const copied = std::get_if<SetClipboardEffect>(&effects.front());
  ASSERT_NE(copied, nullptr);
  ASSERT_TRUE(session_->apply(actions::PasteLabels{copied->text}));
  EXPECT_EQ(object_count(), 2U);
  act("labels select-all");
  act("labels delete");
  EXPECT_EQ(object_count(), 0U);
  EXPECT_THAT(refused("paste-labels nonsense"), testing::Not(testing::IsEmpty()));
}

TEST_F(SessionLabels, HaveHistoryToGoTo) {
  open_labels();
  draw_box("road");
  const std::int64_t first = desk().sheet().step();
  draw_box("curb");
  act(fmt::format("label-step {}", first));
  EXPECT_EQ(object_count(), 1U);
}

TEST_F(SessionLabels, ThatFailChangeNothing) {
  open_labels();
  draw_box();
  const LabelDocument before = desk().sheet().now();
  for (const std::string words :
       {"draw-area roof 0,0 1,0 1,1", "draw-area road 0,0 1,0", "draw-line road nan 0,0 1,0",
        "set-label width wide", "set-label class roof", "label-option line-width -3",
        "label-option colour red", "label-step 99", "trace 0 0 1", "select-labels 99",
        "move-vertex 99 0 0 1 1", "recode road roof", "join-borders -1", "split-labels 0,0"}) {
    EXPECT_NE(refused(words), "(no error)") << words;
    EXPECT_EQ(desk().sheet().now(), before) << words;
  }
}

TEST_F(SessionLabels, ThatAreNotThereAreSaidSo) {
  EXPECT_THAT(refused("label /no/such/map"), HasSubstr("/no/such/map: does not exist"));
  EXPECT_THAT(refused("workspace label"), HasSubstr("nothing to label"));
  EXPECT_THAT(refused("draw-area road 0,0 1,0 1,1"), HasSubstr("no labels are open"));
  const fs::path text = scratch_.path() / "notes.txt";
  std::ofstream(text) << "no map\n";
  act("label " + text.string());
  settle();
  EXPECT_EQ(session_->label_view().workspace, Workspace::kReplay);
  ASSERT_FALSE(session_->notices().empty());
  EXPECT_THAT(session_->notices().back().text, HasSubstr("notes.txt"));
}

TEST_F(SessionLabels, OfTheMapThatIsOpenAreOneCommandAway) {
  act("open \"" + package_.string() + "\"");
  settle();
  act("workspace label");
  settle();
  ASSERT_NE(session_->label_desk(), nullptr);
  EXPECT_EQ(session_->label_view().path, package_.string());
}

TEST_F(SessionLabels, OfAnotherPlaceHaveASightOfTheirOwn) {
  open_run();
  act("look 3 4 55");
  open_labels();
  ASSERT_NE(session_->view().map_path, session_->label_view().path);
  const MapLook whole = session_->resolved_map_look();
  EXPECT_NE(whole.width_m, 55.0) << "all of what is labelled is shown first";
  act("zoom 2");
  EXPECT_NEAR(session_->resolved_map_look().width_m, 0.5 * whole.width_m, 1e-9);
  act("workspace replay");
  EXPECT_EQ(session_->resolved_map_look().width_m, 55.0);
  EXPECT_EQ(session_->resolved_map_look().centre_in_enu_m, Eigen::Vector2d(3, 4));
  act("workspace label");
  EXPECT_NEAR(session_->resolved_map_look().width_m, 0.5 * whole.width_m, 1e-9);
}

TEST_F(SessionLabels, GoOutToFilesAndComeBack) {
  open_labels();
  draw_box();
  const fs::path file = scratch_.path() / "out.geojson";
  act("export-labels geojson \"" + file.string() + "\"");
  settle();
  ASSERT_TRUE(fs::exists(file)) << testing::PrintToString(notice_texts());
  act("labels delete");
  ASSERT_EQ(object_count(), 0U);
  act("import-labels \"" + file.string() + "\"");
  settle();
  EXPECT_GE(object_count(), 1U) << testing::PrintToString(notice_texts());
  EXPECT_EQ(class_at(middle().x(), middle().y()), kBuilding);
  EXPECT_THAT(refused("import-labels /no/such.osm"), HasSubstr("does not exist"));
  const fs::path copy = scratch_.path() / "copy.gpkg";
  act("save-labels-copy \"" + copy.string() + "\"");
  settle();
  const auto store = LabelStore::open(copy, "bob", LabelAccess::kRead);
  ASSERT_TRUE(store) << error_text(store);
  EXPECT_EQ(store->document().objects().size(), object_count());
  EXPECT_THAT(refused("save-labels-copy \"" + copy.string() + "\""), HasSubstr("there already"));
}

TEST_F(SessionLabels, ThatAreClosedLeaveTheWorkspace) {
  open_labels();
  act("close-labels");
  EXPECT_EQ(session_->label_desk(), nullptr);
  EXPECT_EQ(session_->label_view().workspace, Workspace::kReplay);
  EXPECT_THAT(refused("close-labels"), HasSubstr("no labels are open"));
}

}  // namespace session_labels_test
}  // namespace nadir
