// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/runs_panel.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "tests/widgets/panels/shown_runs.h"

namespace nadir {
namespace runs_panel_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(RunsPanel, ARowMakesItsRunActive) {
  ShownRuns shown(two_runs());
  EXPECT_THAT(shown.asked, IsEmpty());
  EXPECT_THAT(shown.click_row("Runs/2/##activate"), ElementsAre(Action(actions::ActivateRun{2})));
  EXPECT_THAT(shown.click_row("Runs/1/##activate"), IsEmpty()) << "it is already";
  EXPECT_TRUE(shown.screen.at("Runs/1/##activate").is_selected);
}

TEST(RunsPanel, HidesAndClosesARun) {
  ShownRuns shown(two_runs());
  EXPECT_THAT(shown.screen.click("Runs/2/shown", shown.draw()),
              ElementsAre(Action(actions::ShowRun{2, Switch::kOff})));
  EXPECT_FALSE(shown.screen.at("Runs/1/shown").is_enabled) << "the active run always shows";
  EXPECT_THAT(shown.screen.click("Runs/2/Close", shown.draw()),
              ElementsAre(Action(actions::CloseRun{2})));
}

TEST(RunsPanel, ComparesRunsAndMarksTheBetter) {
  ShownRuns shown(two_runs());
  EXPECT_THAT(shown.cell("position median", "calm"), HasSubstr("0.50"));
  EXPECT_THAT(shown.cell("position max", "wild"), HasSubstr("8.00"));
  const std::string check = std::string("•");
  EXPECT_THAT(shown.cell("position RMSE", "calm"), HasSubstr(check));
  EXPECT_THAT(shown.cell("position RMSE", "wild"), ::testing::Not(HasSubstr(check)));
  EXPECT_THAT(shown.cell("within 1 m", "calm"), HasSubstr("100.0"));
  EXPECT_THAT(shown.cell("within 1 m", "wild"), HasSubstr("50.0"));
  EXPECT_THAT(shown.cell("NEES mean", "calm"), HasSubstr(check)) << "1 is nearer to 3 than 128";
}

TEST(RunsPanel, LabelsEveryNumberWithStatisticAndUnitAndExplainsTheMark) {
  ShownRuns shown(two_runs());
  EXPECT_TRUE(shown.screen.shows("Position error [m]")) << shown.screen.words();
  EXPECT_TRUE(shown.screen.shows("Heading error [deg]"));
  EXPECT_EQ(shown.screen.at("Runs/Errors/metrics/position RMSE/").value, "RMSE");
  EXPECT_EQ(shown.screen.at("Runs/Errors/metrics/heading median/").value, "median");
  EXPECT_THAT(shown.screen.at("Runs/Errors/metrics/heading median/").tooltip,
              HasSubstr("heading median [deg]"));
  EXPECT_EQ(shown.screen.at("Runs/Errors/metrics/NEES mean/").value, "mean");
  EXPECT_TRUE(shown.screen.shows("and green: the best run by this number"));
  const auto tip = [&](const std::string& path) {
    return shown.screen.at("Runs/Errors/metrics/" + path).tooltip;
  };
  EXPECT_THAT(tip("position RMSE/calm"), HasSubstr("The best of these runs: lower is better"));
  EXPECT_THAT(tip("within 1 m/calm"), HasSubstr("higher is better"));
  EXPECT_THAT(tip("NEES mean/calm"), HasSubstr("nearer to 3 is better"));
  EXPECT_EQ(tip("position RMSE/wild"), "");
}

TEST(RunsPanel, OfOneRunMarksNothing) {
  RunsModel model = two_runs();
  model.rows.pop_back();
  ShownRuns shown(model);
  EXPECT_THAT(shown.cell("position RMSE", "calm"), HasSubstr("0.50"));
  EXPECT_FALSE(shown.screen.shows(std::string("•"))) << shown.screen.words();
  EXPECT_FALSE(shown.screen.at("Runs/Split view").is_enabled);
  EXPECT_FALSE(shown.screen.has("Runs/Parting"));
  EXPECT_FALSE(shown.screen.has("Runs/1/shown"));
}

TEST(RunsPanel, OfRunsWithoutTruthHasDashes) {
  RunsModel model;
  model.rows = {
      row_of(1, "blind", made_document(50, [](RunStep& step) { step.truth_in_enu.reset(); }))};
  EXPECT_EQ(ShownRuns(model).cell("position RMSE", "blind"), "–");
}

TEST(RunsPanel, TellsSettingsThatDiffer) {
  ShownRuns shown(two_runs());
  EXPECT_EQ(shown.screen.at("Runs/Settings that differ/settings/seed/calm").value, "1");
  EXPECT_EQ(shown.screen.at("Runs/Settings that differ/settings/seed/wild").value, "2");
  EXPECT_FALSE(shown.screen.has("Runs/Settings that differ/settings/preset"));
}

TEST(RunsPanel, JumpsToWhereRunsPart) {
  ShownRuns shown(two_runs());
  EXPECT_TRUE(shown.screen.shows("00:10.0")) << shown.screen.words();
  EXPECT_THAT(shown.click_row("Runs/Parting/2/##go"),
              ElementsAre(Action(actions::GoToDivergence{2})));
  EXPECT_TRUE(shown.screen.shows("Where a run first parts from calm: " + divergence_words()));
  EXPECT_THAT(shown.screen.at("Runs/Parting/2/##go").tooltip,
              HasSubstr("Parted is " + divergence_words()));
  RunsModel alike = two_runs();
  alike.rows[1].document = alike.rows[0].document;
  EXPECT_TRUE(ShownRuns(alike).screen.shows("wild nowhere parts from calm"));
}

TEST(RunsPanel, SplitsTheView) {
  ShownRuns shown(two_runs());
  EXPECT_THAT(shown.screen.click("Runs/Split view", shown.draw()),
              ElementsAre(Action(actions::SplitView{Switch::kOn})));
  shown.model.is_split = true;
  EXPECT_THAT(shown.screen.click("Runs/Split view", shown.draw()),
              ElementsAre(Action(actions::SplitView{Switch::kOff})));
}

TEST(RunsPanel, WatchesALiveRunAndCancelsIt) {
  RunsModel model = two_runs();
  model.rows[1].is_live = true;
  model.rows[1].progress = 0.43;
  model.rows[1].progress_words = "12 s left";
  model.rows[1].job = 7;
  ShownRuns shown(model);
  EXPECT_THAT(shown.screen.at("Runs/2/localising").value, HasSubstr("43 %"));
  EXPECT_THAT(shown.screen.click("Runs/2/localising/Cancel", shown.draw()),
              ElementsAre(Action(actions::CancelJob{7})));
}

TEST(RunsPanel, MarksARunThatWasStoppedBeforeItsEnd) {
  RunsModel model = two_runs();
  EXPECT_FALSE(ShownRuns(model).screen.shows("incomplete"));
  RunDocument stopped = made_run(101);
  stopped.is_complete = false;
  model.rows[1].document = RunDocument::from_steps(stopped);
  model.rows[1].flight_end_s = 40.0;
  ShownRuns shown(model);
  EXPECT_EQ(shown.screen.at("Runs/2/incomplete").tooltip,
            "wild stopped at 00:10.0 of 00:40.0, after 101 steps");
  EXPECT_THAT(shown.screen.at("Runs/2/##activate").tooltip,
              HasSubstr("incomplete: stopped at 00:10.0 of 00:40.0"));
  model.rows[1].is_live = true;
  EXPECT_FALSE(ShownRuns(model).screen.has("Runs/2/incomplete")) << "it is still going on";
}

TEST(RunsPanel, OfThreeRunsNamesWhatTellsThemApartAndTellsThemWhole) {
  RunsModel model = two_runs();
  const auto name = [](int number) {
    return "a flight over the town at noon-" + std::to_string(number);
  };
  model.rows.push_back(row_of(3, name(3), made_document(210)));
  model.rows[1].name = name(2);
  ShownRuns shown(model);
  std::vector<std::string> titles;
  for (const kit::Control& control : shown.screen.controls()) {
    if (control.kind == kit::ControlKind::kColumn &&
        control.path.find("metrics") != std::string::npos)
      titles.push_back(control.path);
  }
  ASSERT_EQ(titles.size(), 4U);
  EXPECT_THAT(titles[2], HasSubstr("2##" + name(2)));
  EXPECT_THAT(titles[3], HasSubstr("3##" + name(3)));
  EXPECT_THAT(shown.screen.at(titles[3]).tooltip, HasSubstr(name(3)));
  EXPECT_FALSE(shown.screen.has("Runs/3/" + name(3)));
  EXPECT_TRUE(shown.screen.shows("noon-3")) << shown.screen.words();
}

TEST(RunsPanel, CutsNoValueHoweverManyRunsAndHoweverNarrow) {
  for (const double scale : {1.0, 1.5}) {
    for (const double width_pt : {220.0, 260.0, 300.0, 340.0, 500.0}) {
      for (const int count : {1, 2, 3, 5, 9}) {
        RunsModel model;
        for (int i = 1; i <= count; ++i) {
          const double error_m = 0.1 * i;
          RunDocument made = made_run(200, [&](RunStep& step) { set_error_m(step, error_m); });
          made.header.seed = static_cast<std::uint64_t>(1'000'000 + i);
          const std::string name = "over the town at noon-" + std::to_string(i);
          model.rows.push_back(row_of(i, name, RunDocument::from_steps(made)));
        }
        ShownRuns shown(model, width_pt, scale);
        std::map<std::string, std::set<double>> widths;
        int values = 0;
        for (const kit::Control& control : shown.screen.controls()) {
          const bool is_name = control.label.empty() || control.path.ends_with("/");
          if (control.kind != kit::ControlKind::kCell || is_name) continue;
          // What is cut says all of itself in its tooltip.
          EXPECT_THAT(control.tooltip, ::testing::Not(HasSubstr(control.value))) << control.path;
          EXPECT_LE(control.rect.right(), width_pt * scale) << control.path;
          const std::string table = control.path.substr(0, control.path.find('/', 20));
          widths[table.substr(0, 15)].insert(control.rect.width);
          ++values;
        }
        EXPECT_GE(values, 11 * count);
        for (const auto& [table, found] : widths) EXPECT_EQ(found.size(), 1U) << table;
        for (const int number : shown.state.numbers)
          EXPECT_TRUE(shown.screen.shows("noon-" + std::to_string(number)));
      }
    }
  }
}

TEST(RunsPanel, ComparesAgainOnlyWhenARunHasChanged) {
  ShownRuns shown(two_runs());
  const MetricRow* const kept = shown.state.comparison.metrics.data();
  shown.screen.wait(3, shown.draw());
  EXPECT_EQ(shown.state.comparison.metrics.data(), kept);
  shown.model.rows[1].document = made_document(210);
  shown.screen.wait(2, shown.draw());
  EXPECT_THAT(shown.cell("position max", "wild"), HasSubstr("0.10"));
}

TEST(RunsPanel, PutsTheActiveRunFirst) {
  RunsModel model = two_runs();
  model.rows[0].is_active = false;
  model.rows[1].is_active = true;
  ShownRuns shown(model);
  EXPECT_THAT(shown.state.numbers, ElementsAre(2, 1));
  EXPECT_THAT(shown.cell("position max", "wild"), HasSubstr("8.00"));
}

TEST(RunsPanel, ARunThatIsBeingReadIsNamedAndNotCompared) {
  RunsModel model = two_runs();
  model.rows[1].document.reset();
  ShownRuns shown(model);
  EXPECT_TRUE(shown.screen.shows("wild"));
  EXPECT_THAT(shown.state.numbers, ElementsAre(1));
}

TEST(RunsPanel, WithoutRunsOffersTheDemo) {
  ShownRuns shown(RunsModel{});
  EXPECT_THAT(shown.screen.click("Runs/Open the demo", shown.draw()),
              ElementsAre(Action(actions::OpenDemo{})));
}

}  // namespace runs_panel_test
}  // namespace nadir
