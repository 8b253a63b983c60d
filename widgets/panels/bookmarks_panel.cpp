// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/bookmarks_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/session/session.h"
#include "widgets/panels/empty_state.h"
#include "widgets/panels/moment_kinds.h"
#include "widgets/panels/shortcut_hint.h"
#include "widgets/panels/time_axis.h"

namespace nadir {
namespace {

constexpr double kSameMomentS = 1e-3;  ///< The cursor stands on it.

bool is_at(double cursor_s, double moment_s) {
  return std::abs(cursor_s - moment_s) < kSameMomentS;
}

/// One line for a list; the rest of a note of several lines is in its tooltip.
std::string first_line(const std::string& note) { return note.substr(0, note.find('\n')); }

void draw_new(kit::Ui& ui, BookmarksState& state, Actions& asked) {
  const double button = ui.px(28.0), gap = ui.px(4.0);
  const auto no_label = ui.label_width(0.0);
  kit::TextOptions options;
  options.placeholder = "note for this moment";
  options.width = std::max(ui.px(40.0), ui.room().width - button - gap);
  options.hint = {"Enter marks this moment with the note", ""};
  const auto typed = ui.text_input("##Note", state.note, options);
  if (typed.is_changed || typed.was_committed) state.note = typed.value;
  ui.same_line(gap);
  const bool is_clicked =
      ui.icon_button("Mark this moment", kit::Icon::kBookmark,
                     hint_for("Mark this moment", actions::ShowOverlay{Overlay::kBookmark}));
  if (!is_clicked && !typed.was_entered) return;
  const auto note = state.note.empty() ? std::nullopt : std::optional(state.note);
  asked.emplace_back(actions::AddBookmark{note});
  state.note.clear();
}

/// The note as an input; done with Enter or by a click elsewhere.
void draw_edited(
    kit::Ui& ui, const Bookmark& bookmark, int number, BookmarksState& state, Actions& asked) {
  kit::TextOptions options;
  options.takes_focus = true;
  options.placeholder = "note";
  const auto no_label = ui.label_width(0.0);
  const auto typed = ui.text_input("##Note", bookmark.note, options);
  if (typed.was_committed && typed.value != bookmark.note) {
    asked.emplace_back(actions::EditBookmark{number, typed.value});
  }
  if (!typed.is_editing) state.edited_s.reset();
}

void draw_bookmark(kit::Ui& ui,
                   const BookmarksModel& model,
                   std::size_t index,
                   BookmarksState& state,
                   Actions& asked) {
  const Bookmark& bookmark = model.bookmarks[index];
  const int number = static_cast<int>(index) + 1;
  const std::string label = fmt::format("{}", number);
  if (state.edited_s == bookmark.time_s) {
    const auto scope = ui.scope(label);
    draw_edited(ui, bookmark, number, state, asked);
    return;
  }
  const auto scope = ui.scope(label);
  const double button = ui.px(28.0);
  const double inside = ui.room().width - ui.px(8.0);
  kit::ListRow row;
  row.is_selected = is_at(model.time_s, bookmark.time_s);
  row.hint = {bookmark.note.empty() ? "Go there" : bookmark.note, ""};
  const auto input = ui.list_row("##go", row);
  ui.same_line(0.0);
  ui.right_align(inside);
  ui.text(clock_text(bookmark.time_s), kit::TextLook::kNumber);
  ui.same_line(ui.px(10.0));
  const bool has_note = !bookmark.note.empty();
  ui.cut_text(has_note ? first_line(bookmark.note) : "without a note",
              has_note ? kit::TextLook::kNormal : kit::TextLook::kMuted, 2.0 * button);
  ui.same_line(0.0);
  ui.right_align(2.0 * button);
  const bool wants_edit = ui.icon_button("Edit", kit::Icon::kPencil, {"Change the note", ""});
  ui.same_line(0.0);
  const bool wants_remove =
      ui.icon_button("Remove", kit::Icon::kTrash, {"Take this bookmark away", ""});
  if (wants_edit || input.was_double_clicked) {
    state.edited_s = bookmark.time_s;
  } else if (wants_remove) {
    asked.emplace_back(actions::RemoveBookmark{number});
  } else if (input.was_clicked) {
    asked.emplace_back(actions::GoToMoment{bookmark.time_s});
  }
}

/// A row of the list: when, what and how much, the last at the right edge.
void draw_moment(kit::Ui& ui,
                 const BookmarksModel& model,
                 std::size_t index,
                 std::size_t row_number,
                 Actions& asked) {
  const WorstMoment& moment = model.moments[index];
  const MomentValue value = index < model.values.size() ? model.values[index] : MomentValue{};
  const MomentKindLook& look = moment_kind_look(moment.kind);
  const auto scope = ui.scope(fmt::format("{}", row_number));
  const double inside = ui.room().width - ui.px(8.0);
  kit::ListRow row;
  row.is_selected = is_at(model.time_s, moment.time_s);
  const std::string severity = severity_words(moment);
  row.hint = {
      moment_words(moment), "", "",
      severity.empty() ? std::string(look.meaning) : fmt::format("{}; {}", look.meaning, severity)};
  if (ui.list_row("##go", row).was_clicked) asked.emplace_back(actions::GoToMoment{moment.time_s});
  ui.same_line(0.0);
  ui.right_align(inside);
  ui.icon(look.icon, moment_look(moment));
  ui.same_line(ui.px(8.0));
  ui.text(clock_text(moment.time_s), kit::TextLook::kNumber);
  ui.same_line(ui.px(10.0));
  const double gap = ui.px(4.0), edge = ui.px(8.0);
  const double unit = value.unit.empty() ? 0.0 : gap + ui.text_width(value.unit);
  const double digits = ui.text_width(value.digits, kit::TextLook::kNumber);
  const double taken = digits + unit + edge;
  // In a narrow panel the kind matters more than the number, which is in the tooltip.
  const bool has_number = !value.digits.empty() && ui.room().width > taken + ui.px(32.0);
  ui.cut_text(std::string(look.name), moment_look(moment), has_number ? taken + ui.px(8.0) : edge);
  if (!has_number) return;
  ui.same_line(0.0);
  ui.right_align(taken);
  ui.number(value.digits, value.unit);
}

void draw_moments(kit::Ui& ui, const BookmarksModel& model, BookmarksState& state, Actions& asked) {
  const auto section = ui.section("Worst moments", true, fmt::format("{}", model.moments.size()));
  if (!section) return;
  if (model.moments.empty()) {
    ui.wrapped("Nothing in this run asks for a look: no large error, no breach, no gap.",
               kit::TextLook::kMuted);
    return;
  }
  static constexpr std::array<const char*, 2> kOrders = {"worst first", "by time"};
  const std::array<std::string, 2> orders = {kOrders[0], kOrders[1]};
  const auto chosen =
      ui.choice("##Order", orders, state.is_by_time ? 1 : 0,
                {"How they are sorted: by how much more each is than what is worth a look in its "
                 "kind, or by when it was",
                 ""});
  if (chosen) state.is_by_time = *chosen == 1;
  std::vector<std::size_t> order = by_severity(model.moments);
  if (state.is_by_time) std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) draw_moment(ui, model, order[i], i + 1, asked);
}

}  // namespace

BookmarksModel bookmarks_model(const Session& session) {
  BookmarksModel model;
  const OpenRun* const run = session.active_run();
  if (run == nullptr) return model;
  if (run->document == nullptr) {
    model.reading = run->name;
    return model;
  }
  model.has_run = true;
  model.time_s = session.playback().time_s;
  model.bookmarks = run->bookmarks;
  model.moments = run->moments;
  model.values.reserve(run->moments.size());
  for (const WorstMoment& moment : run->moments) {
    model.values.push_back(moment_value(*run->document, moment));
  }
  return model;
}

Actions draw_bookmarks(kit::Ui& ui, const BookmarksModel& model, BookmarksState& state) {
  const auto scope = ui.scope("Bookmarks");
  if (!model.reading.empty()) return draw_empty_state(ui, reading_state(model.reading));
  if (!model.has_run)
    return draw_empty_state(ui, no_run_state("its worst moments and your bookmarks"));
  Actions asked;
  const auto is_edited = [&state](const Bookmark& bookmark) {
    return state.edited_s == bookmark.time_s;
  };
  if (std::none_of(model.bookmarks.begin(), model.bookmarks.end(), is_edited)) {
    state.edited_s.reset();
  }
  draw_new(ui, state, asked);
  ui.space();
  const auto area = ui.scroll_area("Bookmarks area");
  for (std::size_t i = 0; i < model.bookmarks.size(); ++i)
    draw_bookmark(ui, model, i, state, asked);
  if (model.bookmarks.empty()) ui.text("No bookmarks yet", kit::TextLook::kMuted);
  ui.space();
  draw_moments(ui, model, state, asked);
  return asked;
}

}  // namespace nadir
