// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr double kToolSide = 28.0, kBetweenTools = 4.0;

/// Of the first `count` tools.
double height_of(const Ui::Frame& frame, std::span<const Tool> tools, std::size_t count) {
  double height = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) height += frame.d(kBetweenTools);
    if (i > 0 && tools[i].begins_group) height += 2.0 * frame.d(kBetweenTools) + 1.0;
    height += frame.d(kToolSide);
  }
  return height;
}

/// How many stand in the column; where they are not all, the button of the menu stands below them.
std::size_t count_in_column(const Ui::Frame& frame, std::span<const Tool> tools, double height) {
  if (height_of(frame, tools, tools.size()) <= height) return tools.size();
  const double menu = frame.d(kBetweenTools) + frame.d(kToolSide);
  std::size_t count = 0;
  while (count < tools.size() && height_of(frame, tools, count + 1) + menu <= height) ++count;
  return count;
}

}  // namespace

double Ui::tool_column_height(std::span<const Tool> tools, double height) const {
  const std::size_t count = count_in_column(*frame_, tools, height);
  const double shown = height_of(*frame_, tools, count);
  if (count == tools.size()) return shown;
  return shown + (count > 0 ? frame_->d(kBetweenTools) : 0.0F) + frame_->d(kToolSide);
}

std::optional<std::size_t> Ui::tool_column(std::span<const Tool> tools, double height) {
  const std::size_t count = count_in_column(*frame_, tools, height);
  std::optional<std::size_t> clicked;
  for (std::size_t i = 0; i < count; ++i) {
    const Tool& tool = tools[i];
    if (i > 0 && tool.begins_group) line();
    const Scope pale = disabled(!tool.disabled_because.empty(), tool.disabled_because);
    if (icon_button(tool.name, tool.icon, tool.hint, tool.is_on)) clicked = i;
  }
  if (count == tools.size()) return clicked;
  const Scope menu = button_menu("More", Icon::kMore, {"More tools", ""});
  if (!menu) return clicked;
  for (std::size_t i = count; i < tools.size(); ++i) {
    const Tool& tool = tools[i];
    if (i > count && tool.begins_group) menu_line();
    const MenuItem item{tool.hint.shortcut, tool.icon, tool.is_on, tool.disabled_because,
                        tool.hint.text};
    if (menu_item(tool.name, item)) clicked = i;
  }
  return clicked;
}

}  // namespace nadir::kit
