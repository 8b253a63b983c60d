// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "widgets/kit/frame_input.h"
#include "widgets/kit/ui.h"
#include "widgets/views/theme.h"

namespace nadir::kit {

/// A user interface between frames: one context of Dear ImGui with its fonts and its look, without a window and without
/// OpenGL. Several may exist; the thread that uses one may use another in between, but not within a frame.
///
/// A frame: `Ui& ui = context.begin_frame(input); draw_everything(ui); context.end_frame();` and then UiRenderer, if anybody
/// is to see it. Reads and writes no file but those of the fonts.
class UiContext {
 public:
  static constexpr double kLeastScale = 0.75, kMostScale = 3.0;

  explicit UiContext(ThemeName theme = ThemeName::kDark, double scale = 1.0);
  ~UiContext();
  UiContext(const UiContext&) = delete;
  UiContext& operator=(const UiContext&) = delete;

  /// Takes effect with the next begin_frame(); cheap where nothing changed. Not within a frame.
  /// @param scale  Of all sizes and texts; clamped to [kLeastScale, kMostScale].
  void set_look(ThemeName theme, double scale);
  [[nodiscard]] ThemeName theme_name() const;
  [[nodiscard]] double scale() const;
  /// No transitions, no blinking: for those who are disturbed by motion, and for pictures that must be the same each time.
  void set_motion_reduced(bool is_reduced);

  /// The Ui is valid until end_frame(). Frames do not nest.
  Ui& begin_frame(const FrameInput& input);
  /// Closes what is still open and makes the list of triangles. Nothing is drawn on any screen.
  void end_frame();
  /// Ends a frame in which something was thrown, after its scopes were closed; nothing of it is shown. Without one it does nothing.
  void abandon_frame();

  /// Controls of the last finished frame, in the order in which they were drawn.
  [[nodiscard]] const std::vector<Control>& controls() const;
  /// Brings the control with this path into sight in the next frame that draws it, by scrolling what it lies in.
  void scroll_to(const std::string& path);

  /// The shape the mouse pointer should have now, of the last frame: "arrow", "text", "resize ew", "resize ns", "move",
  /// "hand", "not allowed", "none".
  [[nodiscard]] std::string cursor_name() const;
  /// A text or a number takes what is typed in the next frame.
  [[nodiscard]] bool is_typing() const;
  /// Something moves or blinks or will be shown after a delay: the next frame should come by itself within this many seconds;
  /// infinity where nothing changes without input.
  [[nodiscard]] double next_frame_within_s() const;

  /// The clipboard: of the desktop where DesktopInput is connected, else one of our own.
  [[nodiscard]] std::string clipboard() const;
  void set_clipboard(const std::string& text);

  /// What kit's own sources share; not for panels.
  struct State;
  [[nodiscard]] State& state() { return *state_; }
  [[nodiscard]] const State& state() const { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

}  // namespace nadir::kit
