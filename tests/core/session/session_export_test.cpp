// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include "core/base/settings.h"
#include "core/base/staged_output.h"
#include "core/session/run_table.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_export_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class SessionExportTest : public SessionTest {
 protected:
  [[nodiscard]] std::string in(const std::string& name) const {
    return (scratch_.path() / name).string();
  }
  template <typename Wanted>
  Wanted only_effect() {
    const auto effects = session_->take_effects();
    EXPECT_THAT(effects, SizeIs(1));
    if (effects.size() != 1 || !std::holds_alternative<Wanted>(effects[0])) {
      ADD_FAILURE() << "another effect";
      return {};
    }
    return std::get<Wanted>(effects[0]);
  }
};

TEST_F(SessionExportTest, AsksForAFigureOfWhatTheMapShowsNow) {
  open_run();
  act("seek 2.5");
  act("look 20 28 33");
  act("theme light");
  act("layer particles off");
  act("export " + in("m.svg"));
  const auto effect = only_effect<DrawFigureEffect>();
  EXPECT_EQ(effect.file, in("m.svg"));
  const auto recipe = Settings::parse(effect.recipe, "recipe").value();
  EXPECT_EQ(recipe.text("figure").value(), "moment");
  EXPECT_THAT(recipe.texts("runs").value(), ElementsAre(run_.string()));
  EXPECT_EQ(recipe.text("map").value(), SmallWorld::get().map.string());
  EXPECT_EQ(recipe.number("options.time").value(), 2.5);
  EXPECT_EQ(recipe.text("options.crop").value(), "33@20,28");
  EXPECT_EQ(recipe.text("options.theme").value(), "light");
  EXPECT_THAT(recipe.text("options.stack").value(), Not(HasSubstr("particles")));
  ASSERT_THAT(session_->jobs(), SizeIs(1));
  EXPECT_EQ(session_->jobs()[0].title, "drawing m.svg");
  EXPECT_EQ(session_->jobs()[0].number, effect.job);
}

TEST_F(SessionExportTest, AsksForTheRunsThatAFigureIsOf) {
  open_run();
  const fs::path second = copy_run("second.nadir"), third = copy_run("third.nadir");
  act("open " + second.string());
  settle();
  act("open " + third.string());
  settle();
  act("show-run 1 off");
  act("export " + in("c.png") + " compare");
  EXPECT_THAT(Settings::parse(only_effect<DrawFigureEffect>().recipe, "r")->texts("runs").value(),
              ElementsAre(third.string(), second.string()))
      << "the active one first, then those that are shown";
  act("export " + in("l.pdf") + " labels");
  EXPECT_FALSE(Settings::parse(only_effect<DrawFigureEffect>().recipe, "r")->has("runs"));
}

TEST_F(SessionExportTest, AsksForTheColourThatTheActiveRunHas) {
  open_run();
  act(open(copy_run("second.nadir")));
  settle();
  act("export " + in("m.png"));
  EXPECT_EQ(Settings::parse(only_effect<DrawFigureEffect>().recipe, "r")
                ->number("options.run-colour")
                .value(),
            2.0);
  act("run 1");
  act("export " + in("m.png"));
  EXPECT_FALSE(
      Settings::parse(only_effect<DrawFigureEffect>().recipe, "r")->has("options.run-colour"));
}

TEST_F(SessionExportTest, AsksForAWidthWithinItsRange) {
  open_run();
  act("export " + in("m.png") + " moment 2400");
  EXPECT_EQ(
      Settings::parse(only_effect<DrawFigureEffect>().recipe, "r")->text("options.size").value(),
      "2400");
  EXPECT_THAT(refused("export " + in("m.png") + " moment 10"),
              HasSubstr("a width of 10 pixels is not in [200, 16000]"));
}

TEST_F(SessionExportTest, AsksForAFilmOfTheLoop) {
  open_run();
  act("loop 1 3");
  act("speed 2");
  act("export " + in("film.MP4"));
  const auto recipe = Settings::parse(only_effect<DrawFigureEffect>().recipe, "r").value();
  EXPECT_EQ(recipe.number("options.from").value(), 1.0);
  EXPECT_EQ(recipe.number("options.to").value(), 3.0);
  EXPECT_EQ(recipe.number("options.speed").value(), 2.0);
}

TEST_F(SessionExportTest, RefusesFilesThatCannotBe) {
  EXPECT_THAT(refused("export " + in("m.png")), HasSubstr("no run is open"));
  EXPECT_THAT(refused("export " + in("m.png") + " labels"), HasSubstr("no map is open"));
  open_run();
  EXPECT_THAT(refused("export " + in("m.bmp")),
              HasSubstr("m.bmp: does not end in .png, .svg, .pdf or .mp4"));
  EXPECT_THAT(refused("export " + in("no/such/m.png")), HasSubstr("no/such"));
  EXPECT_THAT(refused("export \"\""), HasSubstr("no file is named"));
  EXPECT_THAT(refused("export-table " + in("t.txt")), HasSubstr("t.txt: does not end in .csv"));
  EXPECT_THAT(refused("report " + in("no/such/report")), HasSubstr("its folder does not exist"));
  EXPECT_THAT(session_->take_effects(), IsEmpty());
  EXPECT_THAT(session_->jobs(), IsEmpty());
}

TEST_F(SessionExportTest, ShowsHowFarTheShellIsAndWhatCameOfIt) {
  open_run();
  act("export " + in("m.png"));
  const int job = only_effect<DrawFigureEffect>().job;
  session_->report_effect(job, 0.5, "drawing");
  ASSERT_THAT(session_->jobs(), SizeIs(1));
  EXPECT_EQ(session_->jobs()[0].fraction, 0.5);
  EXPECT_EQ(session_->jobs()[0].activity, "drawing");
  EXPECT_TRUE(session_->jobs()[0].left_s);
  session_->finish_effect(job, "", in("m.png"));
  EXPECT_THAT(session_->jobs(), IsEmpty());
  EXPECT_THAT(notice_texts(), ElementsAre(in("m.png") + " was written"));
  session_->finish_effect(job, "again", "");
  EXPECT_THAT(session_->notices(), SizeIs(1)) << "it has ended";
}

TEST_F(SessionExportTest, SaysWhatOfTheMapAFigureLeavesOut) {
  open_run();
  act("layer reconstruction on");
  act("rotate -90");  // west is up then
  act("export " + in("m.png"));
  const auto effect = only_effect<DrawFigureEffect>();
  EXPECT_EQ(Settings::parse(effect.recipe, "r")->text("options.up").value(), "270");
  EXPECT_THAT(session_->notices(), IsEmpty()) << "one notice for one file, once it is there";
  session_->finish_effect(effect.job, "", in("m.png"));
  EXPECT_THAT(notice_texts(),
              ElementsAre(in("m.png") + " was written; it does not show the reconstruction"));
  EXPECT_EQ(session_->notices()[0].kind, Notice::Kind::kInfo) << "the box had said so";
}

TEST_F(SessionExportTest, TellsAllWarningsInOneNotice) {
  open_run();
  act("layer reconstruction on");
  act("export " + in("m.png"));
  session_->finish_effect(only_effect<DrawFigureEffect>().job, "", in("m.png"),
                          {"DejaVu Sans is missing", "the map has changed"});
  ASSERT_THAT(session_->notices(), SizeIs(1));
  const Notice notice = session_->notices()[0];
  EXPECT_EQ(notice.kind, Notice::Kind::kWarning) << "it stays until it is read";
  EXPECT_EQ(notice.text, in("m.png") + " was written, with 3 warnings");
  EXPECT_EQ(notice.details,
            "it does not show the reconstruction\nDejaVu Sans is missing\nthe map has changed");
  act("dismiss");
  act("layer reconstruction off");
  act("export " + in("n.png"));
  session_->finish_effect(only_effect<DrawFigureEffect>().job, "", in("n.png"),
                          {"DejaVu Sans is missing"});
  EXPECT_THAT(notice_texts(), ElementsAre(in("n.png") + " was written; DejaVu Sans is missing"));
}

TEST_F(SessionExportTest, SaysWhyTheShellCouldNotDoIt) {
  open_run();
  act("export " + in("m.png"));
  session_->finish_effect(only_effect<DrawFigureEffect>().job, "m.png: the disk is full", "");
  ASSERT_THAT(session_->notices(), SizeIs(1));
  EXPECT_EQ(session_->notices()[0].kind, Notice::Kind::kError);
  EXPECT_EQ(session_->notices()[0].text, "m.png: the disk is full");
}

TEST_F(SessionExportTest, StopsWorkOfTheShell) {
  open_run();
  EXPECT_EQ(refused("cancel"), "no work is going on");
  act("dismiss");
  act("export " + in("a.png"));
  act("export " + in("b.mp4"));
  const auto effects = session_->take_effects();
  const int first = std::get<DrawFigureEffect>(effects[0]).job;
  const int second = std::get<DrawFigureEffect>(effects[1]).job;
  act("cancel");
  EXPECT_THAT(session_->take_cancelled_effects(), ElementsAre(second)) << "the newest";
  EXPECT_THAT(session_->take_cancelled_effects(), IsEmpty());
  session_->finish_effect(second, "killed", "");
  EXPECT_THAT(notice_texts(), ElementsAre("drawing b.mp4 was stopped")) << "that is no error";
  act("cancel " + std::to_string(first));
  EXPECT_THAT(session_->take_cancelled_effects(), ElementsAre(first));
  EXPECT_EQ(refused("cancel 4711"), "there is no work 4711");
}

TEST_F(SessionExportTest, WritesEveryStepAsATable) {
  open_run();
  act("export-table " + in("run.csv"));
  settle();
  EXPECT_EQ(read_text_file(in("run.csv")).value(), run_table(document()));
  EXPECT_THAT(notice_texts(), ElementsAre(in("run.csv") + " was written"));
}

TEST_F(SessionExportTest, WritesNoTableThatWasStoppedInTime) {
  open_run();
  act("export-table " + in("run.csv"));
  act("cancel");
  settle();
  const bool was_written = fs::exists(in("run.csv"));  // it may have been done already
  EXPECT_THAT(notice_texts(), was_written ? testing::Matcher<std::vector<std::string>>(testing::_)
                                          : testing::Matcher<std::vector<std::string>>(
                                                ElementsAre("writing run.csv was stopped")));
}

TEST_F(SessionExportTest, AsksForAReportOfTheRunsThatAreShown) {
  open_run();
  const fs::path second = copy_run("second.nadir");
  act("open " + second.string());
  settle();
  act("run 1");
  act("show-run 2 off");
  act("report " + in("report"));
  const auto effect = only_effect<WriteReportEffect>();
  EXPECT_THAT(effect.runs, ElementsAre(run_.string()));
  EXPECT_EQ(effect.folder, in("report"));
}

TEST_F(SessionExportTest, CopiesTexts) {
  act("copy 32.4 N 83.7 W");
  EXPECT_EQ(only_effect<SetClipboardEffect>().text, "32.4 N 83.7 W");
}

TEST_F(SessionExportTest, CopiesAndPastesTheWholeView) {
  open_run();
  act("seek 2.5");
  act("look 20 28 33");
  act("layer particles off");
  act("theme light");
  act("splitter left 333");
  act("copy-view");
  const std::string text = only_effect<SetClipboardEffect>().text;
  const ViewState copied = session_->view();
  act("close-run 1");
  act("theme dark");
  act("layout default");
  ASSERT_TRUE(session_->apply(actions::PasteView{text}));
  settle();
  EXPECT_EQ(session_->view(), copied);
  EXPECT_EQ(session_->playback().time_s, 2.5);
  EXPECT_EQ(session_->undo_title(), "Paste view");
  act("undo");
  EXPECT_EQ(session_->view().appearance.theme, LightOrDark::kDark);
  EXPECT_THAT(session_->runs(), IsEmpty());
}

TEST_F(SessionExportTest, RefusesToPasteWhatIsNoViewOrNotHere) {
  EXPECT_THAT(refused("paste-view \"some text\""), HasSubstr("the clipboard"));
  const auto elsewhere =
      parse_action("paste-view \"version = 1\\n[[run]]\\npath = '/no/such/run.nadir'\"");
  ASSERT_TRUE(elsewhere);
  EXPECT_EQ(error_text(session_->apply(*elsewhere)),
            "/no/such/run.nadir: does not exist here, so the view cannot be shown");
  EXPECT_EQ(session_->view(), default_view_state());
}

}  // namespace session_export_test
}  // namespace nadir
