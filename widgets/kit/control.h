// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "core/base/field.h"

namespace nadir::kit {

/// A rectangle of the window: pixels, x right, y *down* from the upper left corner. (Canvas and AreaInput count y up.)
struct Rect {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double bottom() const { return top + height; }
  [[nodiscard]] Eigen::Vector2d centre() const { return {left + width / 2.0, top + height / 2.0}; }
  [[nodiscard]] bool contains(const Eigen::Vector2d& point) const {
    return point.x() >= left && point.x() < right() && point.y() >= top && point.y() < bottom();
  }
  /// Without a margin on every side; never of a negative size.
  [[nodiscard]] Rect shrunk_by(double margin) const {
    return {left + margin, top + margin, std::max(0.0, width - 2.0 * margin),
            std::max(0.0, height - 2.0 * margin)};
  }
  friend bool operator==(const Rect&, const Rect&) = default;
};

enum class ControlKind {
  kText,
  kButton,
  kIconButton,
  kCheckbox,
  kEye,
  kChoice,
  kCombo,
  kSlider,
  kNumber,
  kTextInput,
  kColour,
  kTable,
  kColumn,
  kRow,
  kCell,
  kTab,
  kSection,
  kSplitter,
  kProgress,
  kMenu,
  kMenuItem,
  kNotice,
  kArea,
  kRegion,
  kOverlay,
  kGrip,
};

/// What one control of a frame was: what tests and scripts find by its path, and what says where it is.
struct Control {
  std::string path;  ///< Scopes and label, joined by '/': "Layers/particles/opacity".
  ControlKind kind = ControlKind::kText;
  Rect
      rect;  ///< Where a click does what the control is for: of a slider its track, of a number its field.
  Rect
      label_rect;  ///< Of the label beside it; empty where there is none. A double click there resets a number.
  std::string label;
  std::string
      value;  ///< As shown: "0.85", "on"/"off", "open"/"closed", the chosen item, the text typed.
  bool is_enabled = true;
  bool is_visible = true;    ///< At least in part: not scrolled out of sight.
  bool is_selected = false;  ///< Rows, tabs, choices, toggled buttons.
  bool is_hovered = false;
  bool is_focused = false;  ///< The keyboard is with it: a frame is drawn around it.
  std::string
      tooltip;  ///< All that its tooltip says, in one line; why it is disabled, where it is.
};

}  // namespace nadir::kit

namespace nadir {
template <>
struct EnumNames<kit::ControlKind> {
  static constexpr std::array<std::string_view, 26> kNames = {
      "text",   "button", "icon button", "checkbox", "eye",      "choice", "combo",
      "slider", "number", "text input",  "colour",   "table",    "column", "row",
      "cell",   "tab",    "section",     "splitter", "progress", "menu",   "menu item",
      "notice", "area",   "region",      "overlay",  "grip"};
};
}  // namespace nadir
