// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/log_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

/// Lines with all words that are looked for, newest first.
[[nodiscard]] std::vector<std::size_t> found_lines(const LogModel& model,
                                                   const std::string& typed) {
  std::vector<std::size_t> found;
  for (std::size_t i = model.lines.size(); i-- > 0;) {
    if (has_words(model.lines[i], typed)) found.push_back(i);
  }
  return found;
}

[[nodiscard]] bool is_selected_line(const LogState& state, std::size_t line) {
  return std::binary_search(state.selected.begin(), state.selected.end(), line);
}

void select_line(std::size_t line, const kit::Modifiers& modifiers, LogState& state) {
  auto& selected = state.selected;
  if (modifiers.shift && !selected.empty()) {
    const std::size_t first = std::min(selected.front(), line);
    const std::size_t last = std::max(selected.back(), line);
    selected.clear();
    for (std::size_t i = first; i <= last; ++i) selected.push_back(i);
    return;
  }
  const auto place = std::lower_bound(selected.begin(), selected.end(), line);
  const bool was_selected = place != selected.end() && *place == line;
  if (modifiers.ctrl) {
    if (was_selected) {
      selected.erase(place);
    } else {
      selected.insert(place, line);
    }
  } else {
    const bool was_only = was_selected && selected.size() == 1;
    selected.clear();
    if (!was_only) selected.push_back(line);
  }
}

/// Of what is found, the selected lines, or all; oldest first, as a log is read elsewhere.
[[nodiscard]] std::string copied_lines(const LogModel& model,
                                       const LogState& state,
                                       const std::vector<std::size_t>& found) {
  std::string text;
  for (auto line = found.rbegin(); line != found.rend(); ++line) {
    if (state.selected.empty() || is_selected_line(state, *line)) text += model.lines[*line] + "\n";
  }
  return text;
}

}  // namespace

LogModel log_model(const Session& session) { return {session.log()}; }

Actions draw_log(kit::Ui& ui, const LogModel& model, LogState& state) {
  const auto scope = ui.scope("Log");
  if (model.lines.empty()) {
    state.selected.clear();
    return draw_empty_state(
        ui, {kit::Icon::kList,
             "Nothing done yet",
             "Every action and message is listed here, in words that a script can use.",
             {},
             {}});
  }
  while (!state.selected.empty() && state.selected.back() >= model.lines.size()) {
    state.selected.pop_back();
  }
  const double button = ui.px(96.0);
  const kit::TextEdit edit =
      ui.search_input("Search", state.typed,
                      {.placeholder = "Search", .width = ui.room().width - button - ui.px(8.0)});
  if (edit.value != state.typed) state.selected.clear();
  state.typed = edit.value;
  const std::vector<std::size_t> found = found_lines(model, state.typed);
  ui.same_line();
  ui.next_width(button);
  Actions asked;
  {
    const auto pale = ui.disabled(found.empty(), "no line is shown");
    const std::string what = state.selected.empty()
                                 ? fmt::format("Copy all {} lines that are shown", found.size())
                                 : fmt::format("Copy {} selected lines", state.selected.size());
    if (ui.button("Copy", kit::ButtonLook::kNormal, {.text = what, .shortcut = {}},
                  kit::Icon::kCopy)) {
      asked.emplace_back(actions::Copy{copied_lines(model, state, found)});
    }
  }
  if (found.empty()) return draw_empty_state(ui, no_match_state(state.typed));
  ui.space(ui.px(4.0));
  const auto scroll = ui.scroll_area("Lines");
  ui.clipped_rows(found.size(), ui.px(28.0), [&](std::size_t i) {
    const std::size_t line = found[i];
    const kit::ListRow look{.is_selected = is_selected_line(state, line),
                            .look = kit::TextLook::kNumber,
                            .hint = {.text = model.lines[line], .shortcut = {}}};
    const kit::RowInput input =
        ui.list_row(label_of(model.lines[line], std::to_string(line)), look);
    if (input.was_clicked) select_line(line, input.modifiers, state);
  });
  return asked;
}

}  // namespace nadir
