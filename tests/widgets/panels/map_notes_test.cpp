// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_notes.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/made_moment.h"
#include "tests/widgets/views/drawn_chart.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/map_lines.h"

namespace nadir {
namespace map_notes_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

ApartRun apart(int number, const std::string& name, const std::string& map) {
  ApartRun run;
  run.number = number;
  run.name = name;
  run.map = map;
  return run;
}

TEST(MapNotes, SayNothingWhereAllIsWell) {
  const MadeMoment made;
  EXPECT_EQ(map_note(made.map_view()).words, "");
}

TEST(MapNotes, NameARunThatIsOnAnotherMap) {
  const MadeMoment made;
  MapViewModel model = made.map_view();
  model.apart = {apart(2, "harbour", "port")};
  EXPECT_EQ(map_note(model).words, "harbour is not drawn: it was made on another map, port");
  EXPECT_EQ(map_note(model).button, "");
  model.apart.push_back(apart(3, "hill", "alps"));
  EXPECT_EQ(map_note(model).words, "2 runs are not drawn: they were made on other maps");
}

TEST(MapNotes, OfferTheMapOfTheActiveRunWhereAnotherIsOpen) {
  const MadeMoment made;
  MapViewModel model = made.map_view();
  model.runs.clear();
  model.apart = {apart(2, "hill", "alps"), apart(1, "harbour", "port")};  // the active one last
  model.is_map_foreign = true;
  const MapNote note = map_note(model);
  EXPECT_EQ(note.words, "harbour was made on another map, port");
  EXPECT_EQ(note.action, Action(actions::ActivateRun{1}));
}

TEST(MapNotes, SayFirstWhatAClickDoes) {
  const MadeMoment made;
  MapViewModel model = made.map_view();
  model.map.reset();
  EXPECT_THAT(map_note(model).words, HasSubstr("No map is open"));
  model.reading = "town";
  EXPECT_EQ(map_note(model).words, "Reading town…");
  model.reading.clear();
  model.coming = "loop-2";
  EXPECT_EQ(map_note(model).words, "loop-2 shows here with its first step");
  model.work = JobStatus{};
  EXPECT_THAT(map_note(model).words, Not(HasSubstr("loop-2"))) << "its card says more";
  model.work.reset();
  model.look.tool = MapTool::kPick;
  EXPECT_THAT(map_note(model).words, StartsWith("Click a particle"));
  model.step.reset();
  EXPECT_THAT(map_note(model).words, StartsWith("No particles"));
}

TEST(MapNotes, AreLeftOutWhereThereIsNoRoom) {
  kit::HeadlessUi screen;
  const MapNote note{"No map is open", "Open the map…", Action(actions::OpenDemo{})};
  double width = 600.0;
  const auto draw = [&](kit::Ui& ui) {
    return draw_map_note(ui, note, {100.0, 50.0, width, 400.0});
  };
  EXPECT_THAT(screen.click("Note/Open the map…", draw), ElementsAre(Action(actions::OpenDemo{})));
  EXPECT_GE(screen.at("Note/Open the map…").rect.left, 100.0 + 48.0) << "beside the tools";
  EXPECT_LE(screen.at("Note/Open the map…").rect.right(), 100.0 + 600.0 - 40.0);
  const double beside = screen.at("Note/Open the map…").rect.top;
  width = 300.0;
  screen.wait(2, draw);
  EXPECT_GT(screen.at("Note/Open the map…").rect.top, beside + 10.0) << "below the words";
  width = 120.0;
  screen.wait(2, draw);
  EXPECT_FALSE(screen.has("Note/Open the map…"));
}

TEST(ShownThings, AreThoseInSight) {
  const MadeMoment made;
  MapViewModel model = made.map_view();
  // A made run has topviews of 100 cells and 1,000 particles.
  EXPECT_THAT(shown_things(model, model.runs[0]),
              ElementsAre("estimate", "ellipses", "particles", "topview"));
  model.look.layer(Layer::kEllipses).is_visible = false;
  model.look.layer(Layer::kParticles).opacity = 0.0;
  model.look.layer(Layer::kDisagreement).is_visible = true;
  model.look.topview_at = PoseSource::kTruth;
  EXPECT_THAT(shown_things(model, model.runs[0]),
              ElementsAre("estimate", "topview at the truth", "agreement"));
  model.map.reset();
  EXPECT_THAT(shown_things(model, model.runs[0]), Not(Contains("agreement")));
  model.runs[0].document.reset();
  EXPECT_THAT(shown_things(model, model.runs[0]), SizeIs(0));
}

TEST(PaneName, SaysAsMuchAsThereIsRoomForAndKeepsToTheMap) {
  const MadeMoment made;
  MapViewModel model = made.map_view();
  model.runs[0].name = "loop medium 7";
  const auto said = [&](double width) {
    RecordingCanvas canvas;
    const MapFrame frame{{0.0, 0.0, width, 400.0}, MapCamera{}, 96.0 / 72.0};
    draw_pane_name(canvas, frame, model, model.runs[0], nullptr, 48.0, theme(ThemeName::kDark));
    for (const auto& fill : canvas.fills) {
      for (const Eigen::Vector2d& corner : fill.outline) {
        EXPECT_GE(corner.x(), 48.0);
        EXPECT_LE(corner.x(), width);
        EXPECT_LE(corner.y(), 400.0);
      }
    }
    return canvas.texts.empty() ? std::string() : canvas.texts[0].line;
  };
  EXPECT_EQ(said(900.0), "loop medium 7: estimate, ellipses, particles, topview");
  EXPECT_THAT(said(360.0), StartsWith("loop medium 7: estimate"));
  EXPECT_THAT(said(360.0), Not(HasSubstr("topview")));
  EXPECT_EQ(said(60.0), "");
}

TEST(PaneName, LeavesOutWhatTheOtherHalfShowsToo) {
  const MadeMoment made;
  MapViewModel model = made.map_view();
  model.runs.push_back(model.runs[0]);
  model.runs[1].name = "loop-2";
  model.runs[1].is_active = false;
  const auto said = [&](std::size_t run) {
    RecordingCanvas canvas;
    const MapFrame frame{{0.0, 0.0, 500.0, 400.0}, MapCamera{}, 96.0 / 72.0};
    draw_pane_name(canvas, frame, model, model.runs[run], &model.runs[1 - run], 48.0,
                   theme(ThemeName::kDark));
    return canvas.texts.at(0).line;
  };
  EXPECT_EQ(said(0), "loop");
  EXPECT_EQ(said(1), "loop-2");
  model.look.layer(Layer::kReconstruction).is_visible = true;
  EXPECT_EQ(said(0), "loop: reconstruction") << "of the active run only";
  EXPECT_EQ(said(1), "loop-2");
}

TEST(PaneName, SaysWhichRunItIsWhereNamesAreLong) {
  const MadeMoment made;
  MapViewModel model = made.map_view();
  model.runs[0].name = "medium loop over the town at noon";
  model.runs.push_back(model.runs[0]);
  model.runs[1].number = model.runs[0].number + 1;
  model.runs[1].name += "-2";
  const auto said = [&](std::size_t run, double width) {
    RecordingCanvas canvas;
    const MapFrame frame{{0.0, 0.0, width, 400.0}, MapCamera{}, 96.0 / 72.0};
    draw_pane_name(canvas, frame, model, model.runs[run], nullptr, 48.0, theme(ThemeName::kDark));
    return canvas.texts.empty() ? std::string() : canvas.texts[0].line;
  };
  EXPECT_THAT(said(0, 600.0), StartsWith("medium loop over the town at noon: "));
  EXPECT_THAT(said(0, 200.0), StartsWith("…noon"));
  EXPECT_THAT(said(1, 200.0), StartsWith("…noon-2"));
  // Nothing in common: as much of it as there is room for.
  model.runs[0].name = "a quiet flight over the harbour";
  EXPECT_THAT(said(0, 260.0), HasSubstr("…"));
  EXPECT_THAT(said(0, 260.0), HasSubstr("harbour"));
}

TEST(EscapeWish, EndsOneThingAfterTheOther) {
  const MadeMoment made;
  MapViewModel model = made.map_view();
  EXPECT_FALSE(escape_wish(model));
  model.look.measured_in_enu_m = {{0.0, 0.0}};
  model.look.tool = MapTool::kMeasure;
  EXPECT_EQ(escape_wish(model), Action(actions::UseTool{MapTool::kPan}));
  model.look.tool = MapTool::kPan;
  EXPECT_EQ(escape_wish(model), Action(actions::MeasurePoint{}));
}

TEST(RunningWords, SayTheLegAndFromTheThirdPointOnAllOfIt) {
  EXPECT_THAT(running_words({}, {1.0, 1.0}), SizeIs(0));
  EXPECT_THAT(running_words({{0.0, 0.0}}, {0.0, 12.0}), ElementsAre("12.00 m  000.0°"));
  EXPECT_THAT(running_words({{0.0, 0.0}}, {0.0, 0.0}), ElementsAre("0.00 m"))
      << "no length has no bearing";
  EXPECT_THAT(running_words({{0.0, 0.0}, {0.0, 12.0}}, {5.0, 12.0}),
              ElementsAre("5.00 m  090.0°", "17.00 m in all"));
}

}  // namespace map_notes_test
}  // namespace nadir
