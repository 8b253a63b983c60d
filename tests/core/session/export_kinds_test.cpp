// SPDX-License-Identifier: Apache-2.0
#include "core/session/export_kinds.h"

#include <set>

#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace export_kinds_test {

using testing::HasSubstr;
using testing::Not;

class ExportKindsTest : public SessionTest {
 protected:
  static const ExportKind& kind(std::string_view name) { return *export_kind(name); }
};

TEST_F(ExportKindsTest, EachHasANameATitleAndALineOfItsOwn) {
  std::set<std::string_view> names, titles, lines;
  for (const ExportKind& one : export_kinds()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_TRUE(titles.insert(one.title).second) << one.title;
    EXPECT_TRUE(lines.insert(one.line).second) << one.line;
    EXPECT_LE(one.line.size(), 48U) << "one line of the box";
    EXPECT_EQ(export_kind(one.name), &one);
  }
  EXPECT_EQ(export_kind("nothing"), nullptr);
}

TEST_F(ExportKindsTest, SayWhyTheyCannotBeMade) {
  EXPECT_EQ(why_no_export(kind("moment"), *session_), "open a run first");
  EXPECT_EQ(why_no_export(kind("labels"), *session_), "open a map first");
  EXPECT_EQ(why_no_export(kind("report"), *session_), "open a run first");
  open_run();
  EXPECT_EQ(why_no_export(kind("compare"), *session_), "show a second run first");
}

TEST_F(ExportKindsTest, OfWhichNothingIsSaidAreTakenByTheSession) {
  open_run();
  act("open " + copy_run("second.nadir").string());
  settle();
  for (const ExportKind& one : export_kinds()) {
    ASSERT_EQ(why_no_export(one, *session_), "") << one.name;
    std::string file = (scratch_.path() / one.name).string();
    if (const auto endings = export_endings(one.form); !endings.empty()) file += endings.front();
    const auto done = session_->apply(export_action(one, file, std::nullopt));
    EXPECT_TRUE(done) << one.name << ": " << error_text(done);
  }
  for (const JobStatus& job : session_->jobs()) session_->finish_effect(job.number, "", "x");
  settle();
}

TEST_F(ExportKindsTest, AreRefusedBySessionAndBoxAlikeWhileNothingIsOpen) {
  for (const ExportKind& one : export_kinds()) {
    EXPECT_NE(why_no_export(one, *session_), "") << one.name;
    EXPECT_FALSE(session_->apply(export_action(one, "/tmp/x.png", std::nullopt))) << one.name;
  }
}

TEST_F(ExportKindsTest, ProposeANameOfRunFigureAndMoment) {
  open_run();
  act("seek 2.5");
  EXPECT_EQ(export_name(kind("moment"), *session_), "loop-moment-2.5s");
  EXPECT_EQ(export_name(kind("cdf"), *session_), "loop-cdf");
  EXPECT_EQ(export_name(kind("labels"), *session_), "street-labels") << "it is of the map";
  EXPECT_EQ(export_name(kind("report"), *session_), "loop-report");
}

TEST_F(ExportKindsTest, SayInOneSentenceWhatWillBeDone) {
  open_run();
  act("seek 2.5");
  EXPECT_EQ(export_sentence(kind("moment"), *session_, "~/a.png", 1600),
            "Draws figure ‘moment’ of loop at 2.5 s, 1600 pixels wide, into ~/a.png.");
  EXPECT_EQ(export_sentence(kind("labels"), *session_, "~/l.svg", std::nullopt),
            "Draws figure ‘labels’ of street into ~/l.svg.");
  EXPECT_EQ(export_sentence(kind("table"), *session_, "~/t.csv", std::nullopt),
            "Writes every step of loop into ~/t.csv.");
  EXPECT_EQ(export_sentence(kind("film"), *session_, "~/f.mp4", std::nullopt),
            "Films loop from start to end at 1 times the speed of the flight, into ~/f.mp4.");
  act("loop 1 3");
  act("speed 2");
  EXPECT_THAT(export_sentence(kind("film"), *session_, "~/f.mp4", std::nullopt),
              HasSubstr("from 1.0 s to 3.0 s at 2 times"));
  act("open " + copy_run("second.nadir").string());
  settle();
  EXPECT_THAT(export_sentence(kind("report"), *session_, "~/r", std::nullopt),
              HasSubstr("of second and 1 more run "));
}

TEST_F(ExportKindsTest, SayWhatOfTheMapTheyLeaveOut) {
  open_run();
  for (const ExportKind& one : export_kinds()) {
    EXPECT_EQ(left_out_sentence(one, *session_), "") << one.name;
  }
  act("layer error-surface on");
  EXPECT_EQ(left_out_sentence(kind("moment"), *session_), "Not in it: the error surface.");
  act("open " + copy_run("second.nadir").string());
  settle();
  act("measure 1 2");
  EXPECT_EQ(left_out_sentence(kind("film"), *session_),
            "Not in it: the error surface, 1 other run and what is measured.");
  EXPECT_EQ(left_out_sentence(kind("trajectories"), *session_), "");
  act("rotate 30");
  EXPECT_EQ(left_out_sentence(kind("trajectories"), *session_), "Not in it: the turn of the map.");
  EXPECT_THAT(left_out_sentence(kind("moment"), *session_), Not(HasSubstr("turn")));
  EXPECT_EQ(left_out_sentence(kind("cdf"), *session_), "") << "it shows no map";
  act("rotate -30");
  ASSERT_EQ(session_->view().map.up, MapUp::kFree);
  EXPECT_EQ(left_out_sentence(kind("trajectories"), *session_), "") << "north is up again";
}

TEST_F(ExportKindsTest, SayThatBookmarksAreMissingFromAMoment) {
  open_run();
  act("bookmark here");
  EXPECT_EQ(left_out_sentence(kind("moment"), *session_), "Not in it: bookmarks.");
  EXPECT_EQ(left_out_sentence(kind("cdf"), *session_), "");
}

TEST_F(ExportKindsTest, SayThatOrderAndColoursAreTheWindowsOnly) {
  open_run();
  const std::string told = "Not in it: the order and colours of the layers.";
  act("layer-colour truth #FF8800");
  EXPECT_EQ(left_out_sentence(kind("trajectories"), *session_), told);
  EXPECT_EQ(left_out_sentence(kind("moment"), *session_), "") << "it has them";
  act("layer truth off");
  EXPECT_EQ(left_out_sentence(kind("trajectories"), *session_), "") << "nobody sees it";
  act("layer-move particles 1");
  EXPECT_EQ(left_out_sentence(kind("trajectories"), *session_), told);
}

TEST_F(ExportKindsTest, OfAFilmIsAFigureInAFileOfAFilm) {
  EXPECT_EQ(action_text(export_action(kind("film"), "/a.mp4", 1280)), "export /a.mp4 moment 1280");
  EXPECT_EQ(action_text(export_action(kind("cdf"), "/a.svg", std::nullopt)), "export /a.svg cdf");
  EXPECT_EQ(action_text(export_action(kind("table"), "/a.csv", std::nullopt)),
            "export-table /a.csv");
  EXPECT_EQ(action_text(export_action(kind("report"), "/r", std::nullopt)), "report /r");
}

}  // namespace export_kinds_test
}  // namespace nadir
