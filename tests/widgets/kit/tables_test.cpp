// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace tables_test {

const std::vector<Column>& columns() {
  static const std::vector<Column> made = {
      {"Run"},
      {"Error", Align::kDecimal, 90.0, 2, {"Mean position error", "", "m"}},
      {"Use", Align::kLeft, 60.0}};
  return made;
}

/// Draws three runs; notes which row was clicked.
struct RunTable {
  TableOptions options;
  std::string clicked, double_clicked, right_clicked, used;
  std::optional<Ui::Sorting> sorting;

  void operator()(Ui& ui) {
    if (const auto table = ui.table("Runs", columns(), options)) {
      for (const char* const name : {"alpha", "beta", "gamma"}) {
        const RowInput row = ui.row(name, std::string(name) == "beta");
        if (row) clicked = name;
        if (row.was_double_clicked) double_clicked = name;
        if (row.was_right_clicked) right_clicked = name;
        ui.cell(name);
        ui.number_cell("12.5");
        ui.control_cell();
        if (ui.button("Open")) used = name;
      }
      if (const auto now = ui.sorting()) sorting = now;
    }
  }
};

TEST(Tables, NoteTheirColumnsRowsAndCells) {
  HeadlessUi screen;
  RunTable table;
  screen.frame(table);
  EXPECT_EQ(screen.at("Runs/Error").kind, ControlKind::kColumn);
  EXPECT_EQ(screen.at("Runs/Error").tooltip, "Mean position error [m]");
  EXPECT_EQ(screen.at("Runs/beta").kind, ControlKind::kRow);
  EXPECT_TRUE(screen.at("Runs/beta").is_selected);
  EXPECT_EQ(screen.at("Runs/gamma/Error").value, "12.5");
  EXPECT_TRUE(screen.has("Runs/gamma/Open"));
}

TEST(Tables, HaveRowsThatAreClickedAnywhereButOnTheirControls) {
  HeadlessUi screen;
  RunTable table;
  const auto draw = [&table](Ui& ui) { table(ui); };
  screen.click("Runs/alpha", draw);
  EXPECT_EQ(table.clicked, "alpha");
  screen.click("Runs/gamma/Run", draw);
  EXPECT_EQ(table.clicked, "gamma");
  screen.double_click("Runs/beta", draw);
  EXPECT_EQ(table.double_clicked, "beta");
  screen.right_click("Runs/alpha", draw);
  EXPECT_EQ(table.right_clicked, "alpha");
  table.clicked.clear();
  screen.click("Runs/alpha/Open", draw);
  EXPECT_EQ(table.used, "alpha");
  EXPECT_EQ(table.clicked, "");
}

TEST(Tables, AreSortedByAClickOnAColumnAndBackwardsByTheNext) {
  HeadlessUi screen;
  RunTable table;
  table.options.is_sortable = true;
  const auto draw = [&table](Ui& ui) { table(ui); };
  screen.click("Runs/Error", draw);
  ASSERT_TRUE(table.sorting);
  EXPECT_EQ(table.sorting->column, 1U);
  EXPECT_FALSE(table.sorting->is_descending);
  screen.click("Runs/Error", draw);
  EXPECT_TRUE(table.sorting->is_descending);
}

TEST(Tables, OfManyRowsDrawOnlyThoseInSight) {
  HeadlessUi screen;
  TableOptions options;
  options.height = 200.0;
  std::size_t drawn = 0;
  std::size_t last = 0;
  const auto draw = [&](Ui& ui) {
    drawn = 0;
    if (const auto table = ui.table("Steps", columns(), options)) {
      ui.clipped_table_rows(4541, [&](std::size_t i) {
        ++drawn;
        last = i;
        (void)ui.row(std::to_string(i));
        ui.cell("step");
      });
    }
  };
  screen.wait(3, draw);
  EXPECT_LT(drawn, 12U);
  screen.scroll("Steps", -40.0, draw);
  screen.wait(2, draw);
  EXPECT_GT(last, 50U);
}

TEST(Tables, LeaveTheCellOfAnUnknownShareEmpty) {
  HeadlessUi screen;
  screen.frame([](Ui& ui) {
    if (const auto table = ui.table("Classes", columns())) {
      (void)ui.row("road");
      ui.bar_cell(std::nan(""), {0, 158, 115}, "0 %");
      ui.bar_cell(0.5, {0, 158, 115}, "50 %");
    }
  });
  EXPECT_EQ(screen.at("Classes/road/Run").value, "");
  EXPECT_EQ(screen.at("Classes/road/Error").value, "50 %");
}

TEST(Tables, RefuseMoreCellsThanColumnsAndRowsOutside) {
  HeadlessUi screen;
  EXPECT_THROW(screen.frame([](Ui& ui) { (void)ui.row("alone"); }), std::logic_error);
  EXPECT_THROW(screen.frame([](Ui& ui) { (void)ui.table("T", {}); }), std::logic_error);
  EXPECT_THROW(screen.frame([](Ui& ui) {
    const auto table = ui.table("T", columns());
    (void)ui.row("r");
    for (int i = 0; i < 4; ++i) ui.cell("x");
  }),
               std::logic_error);
  screen.frame([](Ui& ui) { ui.text("still alive"); });
  EXPECT_TRUE(screen.shows("still alive"));
}

TEST(ListRows, AreChosenAndCarryControls) {
  HeadlessUi screen;
  std::vector<std::string> clicked;
  const auto draw = [&clicked](Ui& ui) {
    ListRow look;
    look.is_selected = true;
    look.detail = "12.5";
    look.colour = Rgba{1, 2, 3};
    if (const RowInput row = ui.list_row("alpha", look))
      clicked.push_back(row.modifiers.ctrl ? "ctrl alpha" : "alpha");
    ui.same_line();
    ui.right_align(ui.px(28));
    if (ui.icon_button("Remove", Icon::kTrash, {"Remove", ""})) clicked.push_back("remove");
  };
  screen.click("alpha", draw);
  screen.click("alpha", draw, {true});
  screen.click("Remove", draw);
  EXPECT_THAT(clicked, testing::ElementsAre("alpha", "ctrl alpha", "remove"));
  EXPECT_TRUE(screen.at("alpha").is_selected);
  EXPECT_EQ(screen.at("alpha").value, "12.5");
  EXPECT_EQ(screen.at("Remove").rect.top, screen.at("alpha").rect.top);
}

TEST(Sections, FoldAtAClickAndRememberIt) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    const auto scope = ui.scope("Options");
    if (const auto section = ui.section("Noise", false, "3 changed")) (void)ui.button("Reset all");
  };
  screen.frame(draw);
  EXPECT_FALSE(screen.has("Options/Noise/Reset all"));
  EXPECT_EQ(screen.at("Options/Noise").value, "closed");
  screen.click("Options/Noise", draw);
  screen.wait(1, draw);
  EXPECT_TRUE(screen.has("Options/Noise/Reset all"));
  screen.click("Options/Noise", draw);
  screen.wait(1, draw);
  EXPECT_FALSE(screen.has("Options/Noise/Reset all"));
  screen.click("Options/Noise/Reset all", draw);
  EXPECT_EQ(screen.at("Options/Noise").value, "open") << "opened on the way";
}

TEST(Sections, CanBeFoundAsTheyWereLeftByAnotherWindow) {
  const auto draw = [](Ui& ui) {
    const auto scope = ui.scope("Options");
    if (const auto section = ui.section("Noise", false)) ui.text("noisy");
    if (const auto section = ui.section("Map")) ui.text("mapped");
  };
  HeadlessUi first;
  first.click("Options/Noise", draw);
  first.click("Options/Map", draw);
  const auto turned = first.frame([&draw](Ui& ui) {
    draw(ui);
    return ui.turned_sections();
  });
  EXPECT_THAT(turned, testing::ElementsAre("Options/Map", "Options/Noise"));
  HeadlessUi second;
  second.frame([&](Ui& ui) {
    ui.set_turned_sections(turned);
    draw(ui);
  });
  EXPECT_EQ(second.at("Options/Noise").value, "open");
  EXPECT_EQ(second.at("Options/Map").value, "closed");
  second.click("Options/Map", draw);
  EXPECT_THAT(second.frame([&draw](Ui& ui) {
    draw(ui);
    return ui.turned_sections();
  }),
              testing::ElementsAre("Options/Noise"));
}

}  // namespace tables_test
}  // namespace nadir::kit
