// SPDX-License-Identifier: Apache-2.0
// What a hand does while a slow frame is drawn, in a whole interface.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/widgets/kit/queued_frames.h"
#include "widgets/kit/ui_context.h"

namespace nadir::kit {
namespace slow_windows_test {

/// A window whose frames are so slow that all of a gesture came before the next one.
class SlowWindow {
 public:
  template <class Draw>
  void play(const Hand& hand, const Draw& draw) {
    queue_.add(hand.events);
    for (int i = 0; i < 2 || queue_.is_waiting(); ++i) {
      const FrameInput input = queue_.next(context.is_typing());
      Ui& ui = context.begin_frame(input);
      {
        const auto region = ui.region("", ui.screen());
        draw(ui);
      }
      context.end_frame();
    }
  }
  [[nodiscard]] Rect rect_of(const std::string& path) const {
    for (const Control& control : context.controls()) {
      if (control.path == path) return control.rect;
    }
    return {};
  }
  UiContext context;

 private:
  InputQueue queue_;
};

TEST(SlowWindows, ClickWhatIsPressedAndLetGoBetweenTwoFrames) {
  SlowWindow window;
  int clicks = 0, picked = 0;
  const auto draw = [&](Ui& ui) {
    clicks += ui.button("Go") ? 1 : 0;
    picked += ui.list_row("row").was_double_clicked ? 1 : 0;
  };
  window.play({}, draw);
  const Eigen::Vector2d go = window.rect_of("Go").centre();
  const Eigen::Vector2d row = window.rect_of("row").centre();
  window.play(Hand().move(go.x(), go.y()).click().click().click(), draw);
  EXPECT_EQ(clicks, 3);
  window.play(Hand().move(row.x(), row.y()).click().click(), draw);
  EXPECT_EQ(picked, 1);
}

TEST(SlowWindows, DragASliderToWhereItWasLetGo) {
  SlowWindow window;
  double value = 5.0;
  NumberOptions options;
  options.least = 0.0;
  options.most = 10.0;
  const auto draw = [&](Ui& ui) {
    const auto edit = ui.slider("Noise", value, options);
    if (edit.is_changed || edit.was_committed) value = edit.value;
  };
  window.play({}, draw);
  const Rect track = window.rect_of("Noise");
  window.play(Hand()
                  .move(track.centre().x(), track.centre().y())
                  .press()
                  .move(track.right() + 50.0, track.centre().y())
                  .release()
                  .move(0, 0),
              draw);
  EXPECT_EQ(value, 10.0);
}

TEST(SlowWindows, TypeIntoWhatAShortcutOpens) {
  SlowWindow window;
  bool is_open = false;
  std::string typed, entered;
  const auto draw = [&](Ui& ui) {
    if (!is_open) {
      if (ui.is_pressed("Ctrl+P")) is_open = true;
      return;
    }
    TextOptions options;
    options.takes_focus = true;
    const TextEdit edit = ui.text_input("Command", typed, options);
    typed = edit.value;
    if (edit.was_entered) entered = edit.value;
  };
  window.play(Hand().chord(Key::kP).type("open the demo").tap(Key::kEnter), draw);
  EXPECT_EQ(entered, "open the demo");
}

TEST(SlowWindows, TypeIntoANumberThatWasDoubleClicked) {
  SlowWindow window;
  double value = 5.0;
  const auto draw = [&](Ui& ui) {
    const auto edit = ui.number_input("Noise", value, {});
    if (edit.was_committed) value = edit.value;
  };
  window.play({}, draw);
  const Eigen::Vector2d at = window.rect_of("Noise").centre();
  window.play(Hand().move(at.x(), at.y()).click().click().type("12").tap(Key::kEnter), draw);
  EXPECT_EQ(value, 12.0);
}

}  // namespace slow_windows_test
}  // namespace nadir::kit
