// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_tables.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/shown_runs.h"

namespace nadir {
namespace run_tables_test {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kMark = "•";

/// The second run was stopped after 8 s, before the flight became hard for both.
RunsModel with_a_stopped_run() {
  const auto hard_at_the_end = [](RunStep& step) {
    set_error_m(step, step.step < 100 ? 0.2 : 8.0);
  };
  RunDocument stopped = made_run(80, hard_at_the_end);
  stopped.is_complete = false;
  RunsModel model;
  model.rows = {row_of(1, "calm", made_document(200, hard_at_the_end)),
                row_of(2, "wild", RunDocument::from_steps(stopped))};
  return model;
}

TEST(RunTables, CompareAStoppedRunOverTheTimeThatBothCover) {
  ShownRuns shown(with_a_stopped_run());
  EXPECT_TRUE(
      shown.screen.shows("Only over 00:00.0 to 00:07.9, which all of these runs cover: wild "
                         "ends there"))
      << shown.screen.words();
  EXPECT_THAT(shown.cell("position RMSE", "calm"), EndsWith("0.20"))
      << "not 5.66, as over all of it";
  for (const char* const metric : {"position RMSE", "position max", "within 1 m", "NEES mean"}) {
    EXPECT_EQ(shown.cell(metric, "wild"), shown.cell(metric, "calm")) << metric << ": no better";
  }
}

TEST(RunTables, DoNotSayOfARunThatIsStillMadeThatItEnds) {
  RunsModel model = with_a_stopped_run();
  model.rows[1].is_live = true;
  const ShownRuns shown(model);
  EXPECT_TRUE(shown.screen.shows("which all of these runs cover: wild has come that far"))
      << shown.screen.words();
  EXPECT_FALSE(shown.screen.shows("ends there"));
  RunsModel alone = model;
  alone.rows.erase(alone.rows.begin());
  alone.rows[0].is_active = true;
  EXPECT_TRUE(ShownRuns(alone).screen.shows("Over the run so far, 00:00.0 to 00:07.9"));
}

TEST(RunTables, SayOverWhichTimeTheNumbersAre) {
  EXPECT_TRUE(ShownRuns(two_runs()).screen.shows("Over all of these runs, 00:00.0 to 00:19.9"));
  RunsModel alone = two_runs();
  alone.rows.pop_back();
  EXPECT_TRUE(ShownRuns(alone).screen.shows("Over the whole run, 00:00.0 to 00:19.9"));
}

TEST(RunTables, OfRunsThatShareNoTimeMarkNone) {
  RunDocument late = made_run(200);
  late.steps.erase(late.steps.begin(), late.steps.begin() + 120);
  RunsModel model = with_a_stopped_run();
  model.rows[0].document = model.rows[1].document;
  model.rows[1].document = RunDocument::from_steps(late);
  ShownRuns shown(model);
  EXPECT_TRUE(
      shown.screen.shows("These runs share no time of the flight: each number is over all of "
                         "its own run, and none is marked as the best"));
  EXPECT_FALSE(shown.screen.shows(kMark)) << shown.screen.words();
  RunDocument elsewhere = made_run(200);
  elsewhere.header.flight_hash = "f2";
  model.rows[1].document = RunDocument::from_steps(elsewhere);
  EXPECT_TRUE(
      ShownRuns(model).screen.shows("Runs of different flights: each number is over all of"));
}

TEST(RunTables, TellThatARunWentOnFromTheOther) {
  RunsModel model = two_runs();
  RunDocument parent = made_run(200), child = made_run(200);
  parent.path = "/runs/made.nadir";
  model.rows[0].document = RunDocument::from_steps(parent);
  child.path = "/runs/wild.nadir";
  child.header.parent_run = "/old/place/made.nadir";
  child.header.started_at_s = 108.0;
  model.rows[1].document = RunDocument::from_steps(child);
  EXPECT_TRUE(ShownRuns(model).screen.shows("Up to 00:08.0 wild has its steps from calm"));
  for (const char* const named : {"made.nadir", "../runs/made.nadir", "/runs/made.nadir"}) {
    child.header.parent_run = named;
    model.rows[1].document = RunDocument::from_steps(child);
    EXPECT_TRUE(ShownRuns(model).screen.shows("wild has its steps from calm")) << named;
  }
  parent.path = "/others/made.nadir";  // of the same name, but another
  model.rows[0].document = RunDocument::from_steps(parent);
  EXPECT_FALSE(ShownRuns(model).screen.shows("has its steps from"));
  child.header.parent_run = "/runs/closed.nadir";
  model.rows[1].document = RunDocument::from_steps(child);
  EXPECT_FALSE(ShownRuns(model).screen.shows("has its steps from"));
}

TEST(RunTables, TellSettingsApartThatHaveNoEffect) {
  const auto document = [](const std::string& noise, const std::string& motion) {
    RunDocument made = made_run(200);
    made.header.options = {{"motion", motion}, {"translation-noise", noise}};
    return RunDocument::from_steps(made);
  };
  RunsModel model;
  model.rows = {row_of(1, "calm", document("0.3", "scaled")),
                row_of(2, "wild", document("0.5", "scaled"))};
  ShownRuns shown(model);
  const std::string section = "Runs/Settings that differ/";
  EXPECT_TRUE(shown.screen.shows("None that has an effect")) << shown.screen.words();
  EXPECT_FALSE(shown.screen.has(section + "settings/translation-noise"));
  EXPECT_EQ(shown.screen.at(section + "without effect/translation-noise/wild").value, "0.5");
  EXPECT_THAT(shown.screen.at(section + "without effect/translation-noise/").tooltip,
              HasSubstr("no effect while motion = scaled"));
  EXPECT_TRUE(shown.screen.shows("These differ too, but have no effect in any of these runs"));
  // One of the two uses it: then it is a difference, and the other says that it does not.
  model.rows[1].document = document("0.5", "thesis");
  ShownRuns mixed(model);
  EXPECT_TRUE(mixed.screen.has(section + "settings/motion"));
  EXPECT_FALSE(mixed.screen.has(section + "without effect"));
  EXPECT_THAT(mixed.screen.at(section + "settings/translation-noise/calm").tooltip,
              HasSubstr("No effect in this run while motion = scaled"));
  EXPECT_EQ(mixed.screen.at(section + "settings/translation-noise/wild").tooltip, "");
}

TEST(RunTables, SayASettingThatIsASentenceInFullBelowTheColumns) {
  RunsModel model = two_runs();
  RunDocument child = made_run(200);
  child.header.seed = 2;
  child.header.options["prior"] = "particles of step 240 of a run with a long name.nadir";
  model.rows[1].document = RunDocument::from_steps(child);
  ShownRuns shown(model);
  const std::string words = "wild: particles of step 240 of a run with a long name.nadir";
  EXPECT_TRUE(shown.screen.shows("calm: –")) << "it does not say how it began";
  const std::string section = "Runs/Settings that differ/";
  const kit::Rect sentence = shown.screen.at(section + "prior/" + words).rect;
  const kit::Rect seeds = shown.screen.at(section + "settings/seed/wild").rect;
  EXPECT_GE(sentence.top, seeds.bottom());
  EXPECT_LE(sentence.right(), 340.0) << "it is wrapped, not cut";
}

TEST(RunTables, NumbersOfEveryGroupEndBelowTheNamesOfTheirRuns) {
  ShownRuns shown(two_runs());
  for (const char* const run : {"calm", "wild"}) {
    const double right = shown.screen.at(std::string("Runs/Errors/metrics/") + run).rect.right();
    for (const char* const metric : {"position RMSE", "NEES mean", "within 1 m"}) {
      const std::string path = std::string("Runs/Errors/metrics/") + metric + "/" + run;
      EXPECT_DOUBLE_EQ(shown.screen.at(path).rect.right(), right) << metric;
    }
  }
}

}  // namespace run_tables_test
}  // namespace nadir
