// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "widgets/kit/ui_context.h"

namespace nadir::kit {

/// A screen that nobody sees, with a hand that finds controls by their path: what panels are tested with. No window, no
/// OpenGL, a few milliseconds.
///
/// `draw` takes a Ui& and draws the panel, in a region of the whole screen that has no name; it is called once a frame, for
/// as many frames as the gesture takes. Each gesture returns what `draw` returned: nothing; of std::vector all that came, in
/// order; of anything else (std::optional, bool) the last that was not empty (true).
/// Gestures throw std::logic_error, with the paths there are, where there is no such control, or it is disabled.
/// Menus on the way to a path are opened: `click("Menu/File/Open…", draw)`. What is scrolled out of sight is scrolled to.
class HeadlessUi {
 public:
  explicit HeadlessUi(ThemeName theme = ThemeName::kDark,
                      double scale = 1.0,
                      const Eigen::Vector2d& size_px = {1280.0, 800.0});

  /// From now on `draw` makes regions of its own: of a whole window.
  void leave_out_region() { has_region_ = false; }

  /// One frame; what it returns.
  template <class Draw>
  auto frame(Draw&& draw) {
    Ui& ui = begin();
    try {
      if constexpr (std::is_void_v<std::invoke_result_t<Draw&, Ui&>>) {
        draw(ui);
        end();
      } else {
        auto drawn = draw(ui);
        end();
        return drawn;
      }
    } catch (...) {
      give_up();
      throw;
    }
  }
  /// So many frames without touching anything.
  template <class Draw>
  auto wait(int frames, Draw&& draw) {
    return play(std::vector<Step>(static_cast<std::size_t>(frames)), draw);
  }

  template <class Draw>
  auto click(const std::string& path, Draw&& draw, Modifiers modifiers = {}) {
    return play(click_steps(path, MouseButton::kLeft, 1, modifiers), draw);
  }
  template <class Draw>
  auto right_click(const std::string& path, Draw&& draw) {
    return play(click_steps(path, MouseButton::kRight, 1, {}), draw);
  }
  template <class Draw>
  auto double_click(const std::string& path, Draw&& draw) {
    return play(click_steps(path, MouseButton::kLeft, 2, {}), draw);
  }
  /// A click in an area (or any control), so far right of and *below* its upper left corner.
  template <class Draw>
  auto click_at(const std::string& path,
                double x,
                double y,
                Draw&& draw,
                MouseButton button = MouseButton::kLeft,
                Modifiers modifiers = {}) {
    return play(click_at_steps(path, {x, y}, button, modifiers), draw);
  }
  /// Double click on a number's label.
  template <class Draw>
  auto reset(const std::string& path, Draw&& draw) {
    return play(reset_steps(path), draw);
  }
  /// From the control's middle, dx to the right and dy *down*, in several frames, then lets go.
  template <class Draw>
  auto drag(const std::string& path,
            double dx,
            double dy,
            Draw&& draw,
            MouseButton button = MouseButton::kLeft,
            Modifiers modifiers = {}) {
    return play(drag_steps(path, {dx, dy}, button, modifiers), draw);
  }
  /// Turns the wheel over a control, notches away from the user.
  template <class Draw>
  auto scroll(const std::string& path, double notches, Draw&& draw, Modifiers modifiers = {}) {
    return play(scroll_steps(path, notches, modifiers), draw);
  }
  /// Replaces what stands in an input or a number ("a/b" or "a/b/value") by the text, and presses Enter unless told not to.
  template <class Draw>
  auto type(const std::string& path, const std::string& text, Draw&& draw, bool with_enter = true) {
    return play(type_steps(path, text, with_enter), draw);
  }
  /// Types into whatever takes text now.
  template <class Draw>
  auto type_here(const std::string& text, Draw&& draw) {
    return play(type_here_steps(text), draw);
  }
  /// Presses and lets go: "Ctrl+P", "Escape", "?".
  template <class Draw>
  auto press(const std::string& chord, Draw&& draw) {
    return play(press_steps(chord), draw);
  }
  /// Moves the mouse over a control and waits for its tooltip, which is then in `tooltip()`.
  template <class Draw>
  auto hover(const std::string& path, Draw&& draw) {
    return play(hover_steps(path), draw);
  }
  /// Moves the mouse off the screen.
  void leave() { input_.mouse_px.reset(); }

  /// Of the last frame; nullptr where there is none.
  [[nodiscard]] const Control* find(const std::string& path) const;
  /// The same; throws where there is none.
  [[nodiscard]] const Control& at(const std::string& path) const;
  [[nodiscard]] bool has(const std::string& path) const { return find(path) != nullptr; }
  [[nodiscard]] const std::vector<Control>& controls() const { return context_.controls(); }
  /// Some label or value of the last frame has this in it.
  [[nodiscard]] bool shows(const std::string& words) const;
  /// All words of the last frame, one control a line; for messages of tests.
  [[nodiscard]] std::string words() const;
  /// What the tooltip says that shows now; empty where none does.
  [[nodiscard]] std::string tooltip() const;

  /// For those that want another size, modifiers held down, or raw input; used by the next frame.
  [[nodiscard]] FrameInput& input() { return input_; }
  [[nodiscard]] UiContext& context() { return context_; }

  /// What is done before one frame.
  using Step = std::function<void(HeadlessUi&)>;
  template <class Draw>
  auto play(const std::vector<Step>& steps, Draw&& draw) {
    using Drawn = std::invoke_result_t<Draw&, Ui&>;
    if constexpr (std::is_void_v<Drawn>) {
      settle([&] { frame(draw); });
      for (const Step& step : steps) {
        prepare(step);
        frame(draw);
      }
    } else {
      Drawn all{};
      const auto take = [&all](Drawn drawn) { join(all, std::move(drawn)); };
      settle([&] { take(frame(draw)); });
      for (const Step& step : steps) {
        prepare(step);
        take(frame(draw));
      }
      return all;
    }
  }

 private:
  template <class Drawn>
  static void join(Drawn& all, Drawn drawn) {
    if constexpr (requires { all.insert(all.end(), drawn.begin(), drawn.end()); }) {
      for (auto& one : drawn) all.push_back(std::move(one));
    } else if (static_cast<bool>(drawn)) {
      all = std::move(drawn);
    }
  }
  Ui& begin();
  void end();
  void give_up();
  /// Frames without input until layout rests: windows take two to know their size.
  void settle(const std::function<void()>& draw_frame);
  void prepare(const Step& step);
  [[nodiscard]] const Control& target(const std::string& path) const;

  [[nodiscard]] static std::vector<Step> way_to(const std::string& path);
  [[nodiscard]] static std::vector<Step> clicks_here(MouseButton button, int clicks);
  [[nodiscard]] static std::vector<Step> click_steps(const std::string& path,
                                                     MouseButton button,
                                                     int clicks,
                                                     Modifiers modifiers);
  [[nodiscard]] static std::vector<Step> click_at_steps(const std::string& path,
                                                        const Eigen::Vector2d& at,
                                                        MouseButton button,
                                                        Modifiers modifiers);
  [[nodiscard]] static std::vector<Step> reset_steps(const std::string& path);
  [[nodiscard]] static std::vector<Step> drag_steps(const std::string& path,
                                                    const Eigen::Vector2d& by,
                                                    MouseButton button,
                                                    Modifiers modifiers);
  [[nodiscard]] static std::vector<Step> scroll_steps(const std::string& path,
                                                      double notches,
                                                      Modifiers modifiers);
  [[nodiscard]] static std::vector<Step> type_steps(const std::string& path,
                                                    const std::string& text,
                                                    bool with_enter);
  [[nodiscard]] static std::vector<Step> type_here_steps(const std::string& text);
  [[nodiscard]] static std::vector<Step> press_steps(const std::string& chord);
  [[nodiscard]] static std::vector<Step> hover_steps(const std::string& path);

  UiContext context_;
  FrameInput input_;
  std::optional<Scope> region_;
  bool has_region_ = true;
  bool is_opening_ = false;  ///< A menu on the way.
};

}  // namespace nadir::kit
