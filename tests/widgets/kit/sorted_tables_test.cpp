// SPDX-License-Identifier: Apache-2.0
// Tables as panels use them: sorted by whoever draws them, scrolled, chosen from.
#include <gmock/gmock.h>

#include <algorithm>

#include "widgets/kit/headless_ui.h"
#include "widgets/kit/icons.h"

namespace nadir::kit {
namespace sorted_tables_test {

struct RunRow {
  std::string name;
  double error_m = 0.0;
};

/// A table that is sorted as its user wants it, as panels do it.
struct SortedRuns {
  std::vector<RunRow> runs = {{"beta", 2.5}, {"alpha", 10.25}, {"gamma", 0.5}};
  TableOptions options;
  std::string chosen;

  SortedRuns() { options.is_sortable = true; }
  void operator()(Ui& ui) {
    const std::vector<Column> columns = {{"Run", Align::kLeft, 0.0, 0, {"Its file's name", ""}},
                                         {"Error", Align::kDecimal, 100.0, 2, {"Mean", "", "m"}}};
    const auto table = ui.table("Runs", columns, options);
    if (const auto by = ui.sorting()) {
      std::sort(runs.begin(), runs.end(), [&by](const RunRow& a, const RunRow& b) {
        const RunRow& first = by->is_descending ? b : a;
        const RunRow& second = by->is_descending ? a : b;
        return by->column == 0 ? first.name < second.name : first.error_m < second.error_m;
      });
    }
    for (const RunRow& run : runs) {
      if (ui.row(run.name, run.name == chosen)) chosen = run.name;
      ui.cell(run.name);
      ui.number_cell(std::to_string(run.error_m).substr(0, 4));
    }
  }
  [[nodiscard]] std::vector<std::string> order(const HeadlessUi& screen) const {
    std::vector<std::pair<double, std::string>> rows;
    for (const RunRow& run : runs)
      rows.emplace_back(screen.at("Runs/" + run.name).rect.top, run.name);
    std::sort(rows.begin(), rows.end());
    std::vector<std::string> names;
    for (const auto& [top, name] : rows) names.push_back(name);
    return names;
  }
};

auto drawing(SortedRuns& table) {
  return [&table](Ui& ui) { table(ui); };
}

TEST(SortedTables, AreSortedUpAndThenDown) {
  HeadlessUi screen;
  SortedRuns table;
  screen.wait(2, drawing(table));
  EXPECT_THAT(table.order(screen), testing::ElementsAre("beta", "alpha", "gamma"));
  screen.click("Runs/Run", drawing(table));
  screen.wait(1, drawing(table));
  EXPECT_THAT(table.order(screen), testing::ElementsAre("alpha", "beta", "gamma"));
  screen.click("Runs/Run", drawing(table));
  screen.wait(1, drawing(table));
  EXPECT_THAT(table.order(screen), testing::ElementsAre("gamma", "beta", "alpha"));
}

TEST(SortedTables, AreSortedByTheColumnThatWasClicked) {
  HeadlessUi screen;
  SortedRuns table;
  screen.click("Runs/Error", drawing(table));
  screen.wait(1, drawing(table));
  EXPECT_THAT(table.order(screen), testing::ElementsAre("gamma", "beta", "alpha"));
  screen.click("Runs/Run", drawing(table));
  screen.wait(1, drawing(table));
  EXPECT_THAT(table.order(screen), testing::ElementsAre("alpha", "beta", "gamma"));
}

TEST(SortedTables, AreLeftAloneWhereTheyAreNotSortable) {
  HeadlessUi screen;
  SortedRuns table;
  table.options.is_sortable = false;
  screen.click("Runs/Error", drawing(table));
  screen.wait(1, drawing(table));
  EXPECT_THAT(table.order(screen), testing::ElementsAre("beta", "alpha", "gamma"));
}

TEST(SortedTables, KeepTheChosenRowWhereverItGoes) {
  HeadlessUi screen;
  SortedRuns table;
  screen.click("Runs/alpha", drawing(table));
  screen.click("Runs/Error", drawing(table));
  screen.wait(1, drawing(table));
  EXPECT_TRUE(screen.at("Runs/alpha").is_selected);
  EXPECT_FALSE(screen.at("Runs/gamma").is_selected);
}

TEST(Cells, LieUnderTheTitlesOfTheirColumns) {
  for (const double scale : {1.0, 1.5, 2.0}) {
    HeadlessUi screen(ThemeName::kDark, scale, {600.0 * scale, 400.0 * scale});
    SortedRuns table;
    screen.wait(2, drawing(table));
    for (const RunRow& run : table.runs) {
      for (const char* const column : {"Run", "Error"}) {
        const Rect cell = screen.at("Runs/" + run.name + "/" + column).rect;
        const Rect head = screen.at(std::string("Runs/") + column).rect;
        EXPECT_EQ(cell.left, head.left);
        EXPECT_EQ(cell.right(), head.right());
        EXPECT_GE(cell.top, head.bottom() - 1.0);
      }
      const Rect row = screen.at("Runs/" + run.name).rect;
      EXPECT_NEAR(row.height, 28.0 * scale, 1.0);
      EXPECT_LE(screen.at("Runs/" + run.name + "/Error").rect.right(), row.right());
    }
  }
}

TEST(Cells, ThatAreCutSayAllInTheirTooltip) {
  HeadlessUi screen(ThemeName::kDark, 1.0, {260.0, 400.0});
  SortedRuns table;
  table.runs[0].name = "a run with a name that is far too long for its column";
  screen.hover("Runs/" + table.runs[0].name + "/Run", drawing(table));
  EXPECT_EQ(screen.tooltip(), table.runs[0].name);
}

TEST(Headers, TellWhatTheirColumnsAre) {
  HeadlessUi screen;
  SortedRuns table;
  screen.hover("Runs/Error", drawing(table));
  EXPECT_EQ(screen.tooltip(), "Mean · m");
  table.options.has_header = false;
  screen.wait(2, drawing(table));
  EXPECT_FALSE(screen.has("Runs/Error"));
  EXPECT_TRUE(screen.has("Runs/alpha/Error"));
}

TEST(ScrolledTables, KeepTheirHeaderInSight) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    TableOptions options;
    options.height = 200.0;
    const std::vector<Column> columns = {{"Step"}};
    const auto table = ui.table("Steps", columns, options);
    ui.clipped_table_rows(100, [&](std::size_t i) {
      (void)ui.row(std::to_string(i));
      ui.cell("step " + std::to_string(i));
    });
  };
  screen.wait(3, draw);
  const double head = screen.at("Steps/Step").rect.top;
  screen.scroll("Steps", -20.0, draw);
  screen.wait(2, draw);
  EXPECT_EQ(screen.at("Steps/Step").rect.top, head);
  EXPECT_TRUE(screen.at("Steps/Step").is_visible);
  EXPECT_FALSE(screen.has("Steps/0")) << "out of sight is not drawn";
}

TEST(ScrolledTables, AreAsHighAsTheyWereAskedToBe) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    TableOptions options;
    options.height = 150.0;
    const std::vector<Column> columns = {{"Step"}};
    {
      const auto table = ui.table("Steps", columns, options);
      for (int i = 0; i < 30; ++i) {
        (void)ui.row(std::to_string(i));
        ui.cell("step");
      }
    }
    (void)ui.button("After");
  };
  screen.wait(3, draw);
  EXPECT_NEAR(screen.at("After").rect.top, 12.0 + 150.0, 2.0);
}

TEST(TwoTables, OnOneScreenKnowTheirRowsApart) {
  HeadlessUi screen;
  SortedRuns first, second;
  const auto draw = [&](Ui& ui) {
    {
      const auto scope = ui.scope("First");
      first(ui);
    }
    const auto scope = ui.scope("Second");
    second(ui);
  };
  screen.click("Second/Runs/alpha", draw);
  EXPECT_EQ(first.chosen, "");
  EXPECT_EQ(second.chosen, "alpha");
  screen.click("First/Runs/Run", draw);
  screen.wait(1, draw);
  EXPECT_EQ(first.runs[0].name, "alpha");
  EXPECT_EQ(second.runs[0].name, "beta") << "not sorted by the other's header";
}

}  // namespace sorted_tables_test
}  // namespace nadir::kit
