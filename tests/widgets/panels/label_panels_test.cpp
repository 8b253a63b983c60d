// SPDX-License-Identifier: Apache-2.0
// Panels of the labelling workspace, and what a hand does on its map.
#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "core/desk/label_coverage.h"
#include "core/desk/label_desk.h"
#include "tests/core/desk/desk_at_work.h"
#include "tests/widgets/panels/asked.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/label_side_panel.h"
#include "widgets/panels/label_tools_panel.h"
#include "widgets/panels/map_view.h"

namespace nadir {
namespace label_panels_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A session at work on the labels of a package, a metre a cell, with what a window shows of it.
class LabelPanels : public testing::Test {
 protected:
  LabelPanels() {
    act("label \"" + half_a_road(folder_.path()).string() + "\"");
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (session_.label_desk() == nullptr && std::chrono::steady_clock::now() < end) {
      session_.poll(0.01);
      std::this_thread::yield();
    }
    if (session_.label_desk() == nullptr) throw std::runtime_error("no labels were opened");
    act("label-option snap false");
  }
  void act(const std::string& words) {
    const auto done = session_.apply(*parse_action(words));
    ASSERT_TRUE(done) << words << ": " << error_text(done);
  }
  [[nodiscard]] const LabelDesk& desk() const { return *session_.label_desk(); }
  [[nodiscard]] std::size_t object_count() const { return desk().sheet().now().objects().size(); }

  [[nodiscard]] auto tools() {
    return [this](kit::Ui& ui) { return draw_label_tools(ui, label_tools_model(session_)); };
  }
  [[nodiscard]] auto beside() {
    return [this](kit::Ui& ui) { return draw_label_side(ui, label_side_model(session_), side_); };
  }
  /// The map; what is asked for on it is done at once, as the window does.
  [[nodiscard]] auto map() {
    return [this](kit::Ui& ui) {
      Actions asked = draw_map_view(ui, map_view_model(session_), map_);
      for (const Action& action : asked) static_cast<void>(session_.apply(action));
      return asked;
    };
  }
  /// A place of the map's area, from its upper left corner, in enu.
  [[nodiscard]] Eigen::Vector2d at(double x, double y) const {
    return map_.camera.enu_from_page({x + 0.5, map_.where.top() - y - 0.5}, map_.where);
  }

  ScratchFolder folder_;
  Session session_{SessionPlaces{folder_.path() / "config", folder_.path() / "data", {}}};
  kit::HeadlessUi screen_;
  MapViewState map_;
  LabelSideState side_;
};

TEST_F(LabelPanels, ToolsAreTakenUpByAClick) {
  EXPECT_THAT(texts(screen_.click("Labels/Tools/Area", tools())),
              ElementsAre("label-option tool area"));
  act("label-option tool brush");
  screen_.wait(2, tools());
  EXPECT_TRUE(screen_.at("Labels/Tools/Brush").is_selected);
  EXPECT_TRUE(screen_.has("Labels/Options/radius"));
  EXPECT_FALSE(screen_.has("Labels/Options/width"));
}

TEST_F(LabelPanels, ClassesAreTakenUpByAClickAndSayWhatTheyCover) {
  EXPECT_THAT(texts(screen_.click("Labels/Classes/2  building##building", tools())),
              ElementsAre("label-option class building"));
  while (!desk().sheet().coverage().is_complete()) session_.poll(0.01);
  screen_.wait(2, tools());
  EXPECT_EQ(screen_.at("Labels/Classes/0  road##road").value, "3.00 ha");
}

TEST_F(LabelPanels, OptionsOfTheToolAreSetByTheirControls) {
  act("label-option tool line");
  EXPECT_THAT(texts(screen_.type("Labels/Options/width", "4.5", tools())),
              testing::Contains("label-option line-width 4.5"));
}

TEST_F(LabelPanels, SayWhetherAnythingIsOnDisk) {
  screen_.wait(2, tools());
  EXPECT_TRUE(screen_.shows("first stroke makes labels.gpkg"));
  act("draw-area building 10,-10 20,-10 20,-20");
  screen_.wait(2, tools());
  EXPECT_TRUE(screen_.shows("every stroke is on disk"));
}

TEST_F(LabelPanels, ObjectsAreListedAndSelected) {
  screen_.wait(2, beside());
  EXPECT_TRUE(screen_.shows("No objects yet"));
  act("draw-area building 10,-10 20,-10 20,-20 10,-20");
  act("draw-line curb 0.2 30,-10 60,-10");
  act("select-labels");
  screen_.wait(2, beside());
  EXPECT_TRUE(screen_.shows("Nothing is selected"));
  EXPECT_THAT(texts(screen_.click("Beside labels/area 1##1", beside())),
              testing::Contains("select-labels 1"));
  act("select-labels 1");
  screen_.wait(2, beside());
  EXPECT_TRUE(screen_.shows("100.0 m²"));
  EXPECT_TRUE(screen_.shows("40.00"));
  EXPECT_THAT(texts(screen_.click("Beside labels/Selection/Do/Delete", beside())),
              ElementsAre("labels delete"));
}

TEST_F(LabelPanels, HistoryGoesBackToAStep) {
  act("draw-area building 10,-10 20,-10 20,-20");
  const std::int64_t first = desk().sheet().step();
  act("draw-area building 30,-10 40,-10 40,-20");
  act("label-tab history");
  screen_.wait(2, beside());
  const auto asked =
      texts(screen_.click(fmt::format("Beside labels/Draw building##{}", first), beside()));
  EXPECT_THAT(asked, ElementsAre(fmt::format("label-step {}", first))) << screen_.words();
}

TEST_F(LabelPanels, MapTakesPlacesOfATool) {
  act("label-option tool area");
  screen_.click_at("Map/Ground", 500, 300, map());
  const Eigen::Vector2d first = at(500, 300);
  screen_.click_at("Map/Ground", 600, 300, map());
  screen_.click_at("Map/Ground", 600, 400, map());
  ASSERT_EQ(desk().points().size(), 3U);
  EXPECT_LT((desk().points().all().front().in_enu_m - first).norm(), 1e-6);
  screen_.click_at("Map/Ground", 600, 400, map(), kit::MouseButton::kRight);
  EXPECT_EQ(object_count(), 1U);
}

TEST_F(LabelPanels, MapSelectsByClickAndByBoxAndMovesWhatIsSelected) {
  screen_.wait(2, map());
  const Eigen::Vector2d a = at(500, 300), c = at(600, 400);
  act(fmt::format("draw-area building {},{} {},{} {},{} {},{}", a.x(), a.y(), c.x(), a.y(), c.x(),
                  c.y(), a.x(), c.y()));
  act("select-labels");
  screen_.click_at("Map/Ground", 550, 350, map());
  EXPECT_THAT(desk().selection().ids(), ElementsAre(1));
  screen_.click_at("Map/Ground", 200, 200, map());
  EXPECT_TRUE(desk().selection().empty());
  act("select-labels 1");
  const kit::Rect ground = screen_.at("Map/Ground").rect;
  // Drags begin in the middle of the area.
  const Eigen::Vector2d middle(ground.width / 2, ground.height / 2);
  const Eigen::Vector2d m = at(middle.x(), middle.y());
  act(fmt::format("move-labels {} {}", m.x() - 0.5 * (a.x() + c.x()),
                  m.y() - 0.5 * (a.y() + c.y())));
  const Ring there = desk().sheet().now().object(1)->rings.front();
  screen_.drag("Map/Ground", 40, 0, map());
  const Ring after = desk().sheet().now().object(1)->rings.front();
  EXPECT_NEAR((after[0] - there[0]).x(), 40 * map_.camera.metres_per_px, 1e-3);
  EXPECT_NEAR((after[0] - there[0]).y(), 0.0, 1e-3);
}

TEST_F(LabelPanels, MapPaintsAStrokeAsOneStep) {
  screen_.wait(2, map());
  act("label-option tool brush");
  act("label-option class vegetation");
  act("label-option paint-over true");
  const std::int64_t before = desk().sheet().step();
  screen_.drag("Map/Ground", 80, 0, map());
  EXPECT_TRUE(desk().points().empty());
  EXPECT_GT(desk().sheet().step(), before);
  const kit::Rect ground = screen_.at("Map/Ground").rect;
  EXPECT_EQ(desk().under(at(ground.width / 2 + 40, ground.height / 2)).class_id, kVegetation);
  // The log holds the whole stroke as one line, so that it can be played back.
  EXPECT_THAT(session_.log().back(), StartsWith("stroke vegetation"));
  act("undo");
  EXPECT_NE(desk().under(at(ground.width / 2 + 40, ground.height / 2)).class_id, kVegetation);
}

TEST_F(LabelPanels, MapZoomsByTheWheelAndReadsTheLabelsThatAreDrawn) {
  act("draw-area building 0,-200 300,-200 300,0 0,0");  // over road, as buildings are
  screen_.wait(2, map());
  const double before = map_.camera.metres_per_px;
  screen_.scroll("Map/Ground", 1.0, map());
  screen_.wait(2, map());
  EXPECT_LT(map_.camera.metres_per_px, before);
  ASSERT_TRUE(map_.readout);
  EXPECT_EQ(map_.readout->class_name, "building");
}

}  // namespace label_panels_test
}  // namespace nadir
