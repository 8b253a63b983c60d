// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "widgets/canvas/canvas.h"
#include "widgets/kit/control.h"
#include "widgets/kit/frame_input.h"
#include "widgets/kit/icons.h"

/// What the calls of Ui take and give back. Lengths are pixels of the window; Ui::px() makes them from those of the design.
namespace nadir::kit {

enum class TextLook {
  kNormal,
  kMuted,
  kHeading,
  kNumber,
  kMutedNumber,
  kGood,
  kWarning,
  kBad,
  kAccent
};
enum class ButtonLook { kNormal, kPrimary, kQuiet };
enum class Surface {
  kNone,
  kWindow,
  kPanel,
  kRaised,
  kPlate
};  ///< kPlate: the panel's colour at 85 %, over the map.
enum class Axis { kHorizontal, kVertical };
enum class Level { kInfo, kGood, kWarning, kBad };
enum class Align {
  kLeft,
  kCentre,
  kRight,
  kDecimal
};  ///< kDecimal: numbers one above the other at their point.

/// What a tooltip says. Empty parts are left out.
struct Hint {
  std::string text = {};  ///< Name or action, in plain case, without a full stop: "Play or pause".
  std::string shortcut = {};  ///< "Space".
  std::string unit = {};      ///< "m".
  std::string source = {};    ///< Where the value comes from: "recorded by the filter".
};

/// Closes in its destructor what a call of Ui opened. `if (const auto menu = ui.menu("File")) { … }`: false where what was
/// opened does not show, and then nothing should be drawn inside. Scopes are closed in reverse order.
class [[nodiscard]] Scope {
 public:
  Scope() = default;
  Scope(bool is_open, std::function<void()> close) : is_open_(is_open), close_(std::move(close)) {}
  ~Scope() {
    if (close_) close_();
  }
  Scope(Scope&& other) noexcept : is_open_(other.is_open_), close_(std::move(other.close_)) {
    other.close_ = nullptr;
  }
  Scope& operator=(Scope&&) = delete;
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;
  explicit operator bool() const { return is_open_; }

 private:
  bool is_open_ = false;
  std::function<void()> close_;
};

/// A value that is being changed. While the user drags or types, `value` runs ahead of what the panel's model says, whether
/// or not the model follows; `was_committed` is true in one frame, when the user lets go or is done, and only if the value
/// is another one than before. Who wants one undo step takes that; who wants to see it live takes `is_changed` as well.
template <class T>
struct Edit {
  T value = {};
  bool is_changed = false;  ///< In this frame.
  bool is_editing = false;  ///< Held by the mouse, or being typed.
  bool was_committed = false;
  bool was_reset =
      false;  ///< Committed by a double click on the label: `value` is then the default.
  bool was_ended = false;  ///< Typing or dragging ended in this frame, whatever came of it.
  std::string refused =
      {};  ///< Typed into a number that `refuses`, and not taken; in the frame in which typing ended.
};

struct NumberOptions {
  double least = -std::numeric_limits<double>::infinity(),
         most = std::numeric_limits<double>::infinity();
  int decimals = 2;       ///< Digits after the point, shown and kept.
  std::string unit = {};  ///< In muted text after it.
  double step = 0.0;  ///< Of an arrow key, ten times with Shift; 0: one of the last digit shown.
  double per_pixel =
      0.0;  ///< Of a drag, for numbers; 0: `step`, or a hundredth of the range where that is finite.
  std::optional<double>
      reset;  ///< What a double click on the label gives; a value that differs is marked.
  bool is_logarithmic = false;  ///< Of sliders with 0 < least.
  bool refuses =
      false;  ///< What is typed and is no number within the range is not brought into it but given back as `refused`.
  std::string refused =
      {};  ///< What was: shown in place of the value and marked; typing goes on from it.
  Hint hint = {};
};

struct TextOptions {
  std::string placeholder = {};  ///< In muted text while it is empty.
  bool takes_focus = false;      ///< In the first frame in which it shows; the palette's input.
  bool takes_focus_now =
      false;  ///< In this frame: the text given takes the place of what is typed, which goes on at its end.
  bool takes_tab = false;  ///< Tab completes what is typed (wants_completion); Shift+Tab goes on.
  bool is_multiline = false;
  double width = 0.0;  ///< 0: all there is.
  Hint hint = {};
};

struct TextEdit : Edit<std::string> {
  bool was_entered =
      false;  ///< Enter was pressed in this frame; for searches and palettes also without a change.
  bool was_cancelled = false;     ///< Escape was pressed in it; `value` is then what it was before.
  bool wants_completion = false;  ///< Tab was pressed in it.
  bool went_back = false;         ///< Backspace was pressed while it was empty.
};

struct Column {
  std::string title;
  Align align = Align::kLeft;
  double width = 0.0;  ///< 0: shares what is left with the others of width 0.
  int decimals = 0;    ///< kDecimal: the most digits after the point that the column holds.
  Hint hint = {};
};

struct TableOptions {
  double height = 0.0;  ///< 0: as high as its rows; more: scrolls inside.
  bool has_header = true;
  bool is_sortable = false;
  bool is_dense = false;      ///< Half the room between columns: many numbers in a narrow panel.
  bool is_only_read = false;  ///< Its rows do nothing: keys go through them and press none.
};

/// What the user did to a row, a list's or a table's.
struct RowInput {
  bool was_clicked = false, was_double_clicked = false, was_right_clicked = false,
       is_hovered = false;
  Modifiers modifiers = {};  ///< Of the click.
  [[nodiscard]] explicit operator bool() const { return was_clicked; }
};

struct ListRow {
  std::string detail = {};  ///< In muted text at the right.
  Icon icon = Icon::kNone;
  std::optional<Rgba> colour = {};  ///< A dot in front of the text.
  bool is_selected = false;
  TextLook look = TextLook::kNormal;
  bool is_detail_number = false;  ///< The detail is written in the face for numbers.
  bool is_stop = true;            ///< False: of a list that has keys of its own.
  Hint hint = {};
};

struct MenuItem {
  std::string shortcut = {};
  Icon icon = Icon::kNone;
  bool is_checked = false;
  std::string disabled_because = {};  ///< Not empty: cannot be chosen, and its tooltip says this.
  std::string hint = {};
};

/// One of a column of icons that do something.
struct Tool {
  std::string name;
  Icon icon = Icon::kNone;
  Hint hint = {};  ///< With a text.
  bool is_on = false;
  std::string disabled_because = {};  ///< Not empty: cannot be used now.
  bool begins_group = false;          ///< A thin line parts it from those above.
};

struct RegionStyle {
  Surface surface = Surface::kPanel;
  double padding = -1.0;    ///< < 0: 12 of the design.
  bool has_scroll = false;  ///< Down, where the content is longer.
  bool has_border = false;  ///< One pixel around it.
  bool is_above = false;    ///< Over regions that are not: read-outs over the map.
  bool takes_input = true;  ///< False: the mouse goes through to what lies under it.
};

enum class OverlayPlace { kCentre, kUpperThird };
struct OverlayStyle {
  double width = 560.0;
  double height = 0.0;  ///< 0: as high as its content.
  OverlayPlace place = OverlayPlace::kCentre;
  bool dims_rest = true;
};

/// An overlay: true while it shows. Nothing closes by itself.
class [[nodiscard]] Overlay : public Scope {
 public:
  Overlay(Scope scope, bool wants_close) : Scope(std::move(scope)), wants_close_(wants_close) {}
  /// Escape, or a click outside of it, in this frame.
  [[nodiscard]] bool wants_close() const { return wants_close_; }

 private:
  bool wants_close_;
};

struct Notice {
  std::string id;  ///< What tells it from the others; its path is "Notices/ID".
  Level level = Level::kInfo;
  std::string text;          ///< One sentence.
  std::string details = {};  ///< To copy, shown on demand.
  std::string action = {};   ///< Title of its one button; none where empty.
  bool is_brief = false;     ///< The button stands beside the words, which are few.
};
struct NoticeWish {
  enum class Kind { kDismiss, kCopy, kAction };
  std::string id;
  Kind kind = Kind::kDismiss;
};

/// Whose the wheel is over an area: its own, or of what the area lies in, which scrolls.
enum class Wheel { kOwn, kScrolls };

/// A drag that began in an area and may have left it. Points as in AreaInput.
struct AreaDrag {
  MouseButton button = MouseButton::kLeft;
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d delta = Eigen::Vector2d::Zero();  ///< Since the last frame.
  Eigen::Vector2d total = Eigen::Vector2d::Zero();
  bool was_started =
      false;  ///< The first frame of it; `delta` then has all since the button went down.
  bool was_released = false;  ///< The last frame of it.
};

/// What the mouse does in an area. Points are its page's: pixels, x right, y *up* from the area's lower left corner, as Canvas
/// and MapCamera count them.
struct AreaInput {
  Rect rect;                                        ///< Of the area in the window, y down.
  bool is_hovered = false;                          ///< Nothing else lies between it and the mouse.
  Eigen::Vector2d mouse = Eigen::Vector2d::Zero();  ///< Also outside of the area.
  Eigen::Vector2d wheel = Eigen::Vector2d::
      Zero();  ///< Notches, while hovered: right, away from the user; of Wheel::kOwn.
  std::optional<AreaDrag> drag;               ///< Begins after 4 pixels; a shorter one is a click.
  std::optional<MouseButton> pressed;         ///< Went down in this frame.
  std::optional<MouseButton> clicked;         ///< Let go where it was pressed, in this frame.
  std::optional<MouseButton> double_clicked;  ///< The second click, which is in `clicked` too.
  Modifiers modifiers;
  [[nodiscard]] PageRect page() const { return {0.0, 0.0, rect.width, rect.height}; }
};

/// OpenGL's name of a texture.
using TextureId = std::uint32_t;

}  // namespace nadir::kit
