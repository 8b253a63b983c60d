// SPDX-License-Identifier: Apache-2.0
// The keyboard in several lists of one window, in long ones, and where its frame is drawn.
#include <gmock/gmock.h>
#include <imgui.h>

#include "tests/widgets/kit/keyed_window.h"
#include "widgets/kit/ui_look.h"

namespace nadir::kit {
namespace focus_lists_test {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(FocusedRows, OfSeveralListsAreAStopEach) {
  KeyedWindow window;
  window.content = [](Ui& ui) {
    for (const char* const list : {"Runs", "Moments"}) {
      const auto section = ui.section(list);
      for (const char* const row : {"1", "2", "3"}) {
        const auto scope = ui.scope(row);  // rows whose words are drawn beside them
        (void)ui.list_row("##go");
      }
    }
    const auto places = ui.scope("Places");
    for (const char* const row : {"Home", "Maps"}) (void)ui.list_row(row);
    const auto recent = ui.scope("Recent");
    for (const char* const row : {"loop", "town"}) (void)ui.list_row(row);
  };
  std::vector<std::string> way;
  window.press("Shift+Tab");
  for (int i = 0; i < 6; ++i) {
    way.push_back(focused(window.screen));
    window.press("Tab");
  }
  EXPECT_THAT(way, ElementsAre("Runs", "Runs/1/##go", "Moments", "Moments/1/##go", "Places/Home",
                               "Places/Recent/loop"));
  window.press_all({"Tab", "Down", "Down", "Down", "Down"});
  EXPECT_EQ(focused(window.screen), "Runs/3/##go") << "arrows stay within a list";
}

TEST(FocusedRows, ThatAreOnlyReadAreGoneThroughAndNotPressed) {
  bool was_pressed = false;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    const std::vector<Column> columns = {{.title = "Name"}};
    const auto table =
        ui.table("Shares", columns, {.height = 100.0, .has_header = false, .is_only_read = true});
    if (!table) return;
    for (int i = 0; i < 20; ++i) {
      was_pressed = ui.row(std::to_string(i)).was_clicked || was_pressed;
      ui.cell("share");
    }
  };
  window.press("Shift+Tab");
  for (int i = 0; i < 12; ++i) window.press("Down");
  EXPECT_TRUE(window.screen.at("Shares/12").is_visible) << "that is how they come into sight";
  window.press_all({"Space", "Enter"});
  EXPECT_FALSE(was_pressed);
  EXPECT_THAT(window.shortcuts, ElementsAre("Space", "Enter"));
}

TEST(FocusedRows, OfAListWithKeysOfItsOwnAreNoStops) {
  int clicks = 0;
  KeyedWindow window;
  window.content = [&](Ui& ui) {
    (void)ui.button("Before");
    for (const char* const row : {"one", "two"})
      clicks += ui.list_row(row, {.is_stop = false}).was_clicked ? 1 : 0;
    (void)ui.button("After");
  };
  window.press_all({"Shift+Tab", "Tab"});
  EXPECT_EQ(focused(window.screen), "After");
  window.screen.click("two", window);
  EXPECT_EQ(clicks, 1) << "the mouse has them still";
}

TEST(FocusedRows, AreGoneThroughFromEndToEnd) {
  for (const bool is_table : {true, false}) {
    std::size_t chosen = 0;
    KeyedWindow window;
    window.content = [&](Ui& ui) {
      const auto draw_row = [&](std::size_t i) {
        const std::string name = std::to_string(i);
        const RowInput row =
            is_table ? ui.row(name, i == chosen) : ui.list_row(name, {.is_selected = i == chosen});
        if (row) chosen = i;
        if (is_table) ui.cell(name);
      };
      const std::vector<Column> columns = {{.title = "Name"}};
      if (is_table) {
        const auto table = ui.table("Names", columns, {.height = 200.0});
        if (table) ui.clipped_table_rows(500, draw_row);
      } else {
        const auto area = ui.scroll_area("Lines", 200.0);
        ui.clipped_rows(500, 28.0, draw_row);
      }
    };
    const std::string path = is_table ? "Names/" : "";
    window.press_all({"Shift+Tab", "End"});
    window.screen.wait(3, window);
    EXPECT_EQ(focused(window.screen), path + "499");
    EXPECT_TRUE(window.screen.at(path + "499").is_visible);
    window.press("Enter");
    EXPECT_EQ(chosen, 499U);
    window.press_all({"Up", "Up", "Home"});
    window.screen.wait(3, window);
    EXPECT_EQ(focused(window.screen), path + "0");
    window.press("Enter");
    EXPECT_EQ(chosen, 0U);
    window.press_all({"End", "Up", "Enter"});
    EXPECT_EQ(chosen, 498U);
    EXPECT_THAT(window.shortcuts, IsEmpty());
  }
}

/// Whether anything in the accent's colour could show below a line of the screen.
bool has_accent_below(double line) {
  const ImDrawData& drawn = *ImGui::GetDrawData();
  const ImU32 accent = look_of(theme(ThemeName::kDark)).accent;
  for (int l = 0; l < drawn.CmdListsCount; ++l) {
    const ImDrawList& list = *drawn.CmdLists[l];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.ClipRect.w <= line) continue;
      for (unsigned i = 0; i < command.ElemCount; ++i) {
        const ImDrawVert& corner =
            list.VtxBuffer[static_cast<int>(command.VtxOffset) +
                           list.IdxBuffer[static_cast<int>(command.IdxOffset + i)]];
        if (corner.col == accent && corner.pos.y > line) return true;
      }
    }
  }
  return false;
}

TEST(FocusFrames, EndWhereTheirListEnds) {
  KeyedWindow window;
  window.content = [](Ui& ui) {
    const std::vector<Column> columns = {{.title = "Name"}};
    const auto table = ui.table("Names", columns, {.height = 200.0, .has_header = false});
    for (int i = 0; table && i < 30; ++i) ui.row(std::to_string(i));
    ui.space(300.0);
  };
  window.press("Shift+Tab");
  for (int i = 0; i < 15; ++i) window.press("Down");
  const Rect table = window.screen.at("Names").rect;
  const Rect row = window.screen.at("Names/15").rect;
  ASSERT_LT(row.bottom(), table.bottom());
  EXPECT_TRUE(has_accent_below(row.top));
  // The wheel takes the row out of sight, over the lower end of its table.
  bool was_cut = false;
  for (int i = 0; i < 20; ++i) {
    window.screen.scroll("Names", 0.15, window);
    EXPECT_FALSE(has_accent_below(table.bottom() + 1.0)) << i;
    const Rect now = window.screen.at("Names/15").rect;
    was_cut = was_cut || (now.top < table.bottom() - 4.0 && now.bottom() > table.bottom() + 4.0);
  }
  EXPECT_TRUE(was_cut);
}

TEST(FocusFrames, StandOutOnWhatHasTheirColour) {
  for (const ThemeName name : {ThemeName::kLight, ThemeName::kDark}) {
    const Look look = look_of(theme(name));
    const auto colour = [](std::uint32_t packed_colour) {
      const auto channel = [packed_colour](unsigned shift) {
        return static_cast<std::uint8_t>((packed_colour >> shift) & 0xFFU);
      };
      return Rgba{channel(0), channel(8), channel(16)};
    };
    for (const std::uint32_t ground : {look.accent, look.accent_hovered})
      EXPECT_GE(contrast(colour(look.on_accent), colour(ground)), 3.0);
    // What is chosen is filled with the accent that lets the ground through.
    const double share = (look.accent_soft >> 24U) / 255.0;
    for (const std::uint32_t ground : {look.panel, look.raised}) {
      const Rgba soft = mixed(colour(ground), colour(look.accent_soft), share);
      EXPECT_GE(contrast(colour(look.accent), soft), 3.0);
    }
  }
}

}  // namespace focus_lists_test
}  // namespace nadir::kit
