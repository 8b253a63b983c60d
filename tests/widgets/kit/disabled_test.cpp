// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <functional>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace disabled_test {

const std::vector<std::string>& three() {
  static const std::vector<std::string> names = {"x-y", "yaw", "all"};
  return names;
}

NumberOptions range() {
  NumberOptions options;
  options.least = 0.0;
  options.most = 10.0;
  options.reset = 1.0;
  return options;
}

/// One kind of control: draws it and says whether it did anything.
struct Kind {
  std::string path;  ///< Where a click would do something.
  std::function<bool(Ui&)> draw;
};

std::vector<Kind> all_kinds() {
  const auto number = [](const Edit<double>& edit) {
    return edit.is_changed || edit.is_editing || edit.was_committed;
  };
  return {
      {"Go", [](Ui& ui) { return ui.button("Go"); }},
      {"Play",
       [](Ui& ui) {
         return ui.icon_button("Play", Icon::kPlay, {"Play", ""});
       }},
      {"more", [](Ui& ui) { return ui.link("more"); }},
      {"Trails", [](Ui& ui) { return ui.checkbox("Trails", true).has_value(); }},
      {"Show", [](Ui& ui) { return ui.eye("Show", true).has_value(); }},
      {"Slices/yaw", [](Ui& ui) { return ui.choice("Slices", three(), 0).has_value(); }},
      {"Slices/yaw", [](Ui& ui) { return ui.radio("Slices", three(), 0).has_value(); }},
      {"Preset", [](Ui& ui) { return ui.combo("Preset", three(), 0).has_value(); }},
      {"Side/yaw", [](Ui& ui) { return ui.tabs("Side", three(), 0).has_value(); }},
      {"Label",
       [](Ui& ui) {
         return ui.rail_button("Label", Icon::kPencil, {"Label", ""}, false);
       }},
      {"Noise", [number](Ui& ui) { return number(ui.slider("Noise", 5.0, range())); }},
      {"Noise", [number](Ui& ui) { return number(ui.number_input("Noise", 5.0, range())); }},
      {"Noise/value", [number](Ui& ui) { return number(ui.slider("Noise", 5.0, range())); }},
      {"Opacity", [number](Ui& ui) { return number(ui.small_slider("Opacity", 5.0, range())); }},
      {"Name", [](Ui& ui) { return ui.text_input("Name", "loop").is_editing; }},
      {"Find", [](Ui& ui) { return ui.search_input("Find", "").is_editing; }},
      {"Estimate",
       [](Ui& ui) {
         return ui.colour("Estimate", {1, 2, 3}).is_changed || ui.wants_text();
       }},
      {"alpha", [](Ui& ui) { return ui.list_row("alpha").was_clicked; }},
      {"Runs/beta",
       [](Ui& ui) {
         const std::vector<Column> columns = {{"Run"}};
         const auto table = ui.table("Runs", columns);
         const RowInput row = ui.row("beta");
         ui.cell("beta");
         return row.was_clicked || row.was_double_clicked;
       }},
      {"map",
       [](Ui& ui) {
         const AreaInput input = ui.area("map", {200.0, 100.0});
         return input.clicked.has_value() || input.drag.has_value() || input.is_hovered;
       }},
      {"Move", [](Ui& ui) { return ui.grip("Move", 1, 3, 28.0).is_changed; }},
      {"Strip", [](Ui& ui) { return ui.splitter("Strip", 100.0, 40.0, 200.0).is_changed; }},
  };
}

/// Presses, drags and turns the wheel over a place, without asking whether it may.
template <class Draw>
bool poke(HeadlessUi& screen,
          Rect rect,
          const Draw& draw) {  // its own: controls go with their frame
  bool did_anything = false;
  const auto frame = [&] { did_anything = screen.frame(draw) || did_anything; };
  screen.input().mouse_px = rect.centre();
  frame();
  frame();
  for (const double moved : {0.0, 30.0}) {
    screen.input().buttons[0] = true;
    frame();
    screen.input().mouse_px = rect.centre() + Eigen::Vector2d(moved, moved);
    frame();
    frame();
    screen.input().buttons[0] = false;
    frame();
    screen.input().mouse_px = rect.centre();
    frame();
  }
  screen.input().wheel.y() = 1.0;
  frame();
  for (const Key key : {Key::kUp, Key::kEnter}) {
    screen.input().keys = {key};
    frame();
    screen.input().keys.clear();
    frame();
  }
  screen.input().characters = "7";
  frame();
  return did_anything;
}

TEST(Disabled, ControlsDoNothingWhateverAHandDoes) {
  for (const Kind& kind : all_kinds()) {
    HeadlessUi screen;
    const auto draw = [&kind](Ui& ui) {
      const auto off = ui.disabled(true, "running");
      return kind.draw(ui);
    };
    screen.wait(2, draw);
    EXPECT_FALSE(screen.at(kind.path).is_enabled) << kind.path;
    EXPECT_THAT(screen.at(kind.path).tooltip, testing::HasSubstr("running")) << kind.path;
    EXPECT_FALSE(poke(screen, screen.at(kind.path).rect, draw)) << kind.path;
  }
}

TEST(Disabled, TheSameHandDoesSomethingToControlsThatAreNot) {
  for (const Kind& kind : all_kinds()) {
    HeadlessUi screen;
    const auto draw = [&kind](Ui& ui) { return kind.draw(ui); };
    screen.wait(2, draw);
    EXPECT_TRUE(screen.at(kind.path).is_enabled) << kind.path;
    if (kind.path == "Preset" || kind.path == "Estimate") continue;  // they open first
    EXPECT_TRUE(poke(screen, screen.at(kind.path).rect, draw)) << kind.path;
  }
}

TEST(Disabled, ControlsAreAsLargeAsOthers) {
  for (const Kind& kind : all_kinds()) {
    HeadlessUi screen;
    bool is_off = false;
    const auto draw = [&](Ui& ui) {
      const auto off = ui.disabled(is_off, "running");
      return kind.draw(ui);
    };
    screen.wait(2, draw);
    const Rect on = screen.at(kind.path).rect;
    is_off = true;
    screen.wait(2, draw);
    EXPECT_EQ(screen.at(kind.path).rect, on) << kind.path << " must not jump";
  }
}

TEST(Disabled, ScopesNestAndEnd) {
  HeadlessUi screen;
  screen.frame([](Ui& ui) {
    {
      const auto outer = ui.disabled(true, "running");
      (void)ui.button("One");
      {
        const auto inner = ui.disabled(false, "never said");
        (void)ui.button("Two");
      }
      (void)ui.button("Three");
    }
    (void)ui.button("Four");
  });
  EXPECT_FALSE(screen.at("One").is_enabled);
  EXPECT_FALSE(screen.at("Two").is_enabled) << "nothing within is enabled again";
  EXPECT_EQ(screen.at("Two").tooltip, "running");
  EXPECT_FALSE(screen.at("Three").is_enabled);
  EXPECT_TRUE(screen.at("Four").is_enabled);
}

TEST(Disabled, WhatIsBeingChangedIsLetGoWhenItBecomesSo) {
  HeadlessUi screen;
  bool is_off = false;
  double value = 5.0;
  int changes = 0;
  const auto draw = [&](Ui& ui) {
    const auto off = ui.disabled(is_off, "running");
    const auto edit = ui.slider("Noise", value, range());
    if (edit.is_changed) {
      value = edit.value;
      ++changes;
    }
  };
  screen.wait(2, draw);
  screen.input().mouse_px = screen.at("Noise").rect.centre();
  screen.frame(draw);
  screen.input().buttons[0] = true;
  screen.frame(draw);
  is_off = true;
  screen.frame(draw);
  screen.frame(draw);
  const int before = changes;
  *screen.input().mouse_px += Eigen::Vector2d(40.0, 0.0);
  screen.frame(draw);
  screen.frame(draw);
  EXPECT_EQ(changes, before);
}

}  // namespace disabled_test
}  // namespace nadir::kit
