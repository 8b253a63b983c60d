// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/bookmarks_panel.h"

#include <fmt/format.h>

#include <cmath>

#include "core/session/session.h"
#include "widgets/panels/empty_state.h"
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

kit::Icon icon_of(MomentKind kind) {
  switch (kind) {
    case MomentKind::kLargestError:
      return kit::Icon::kChart;
    case MomentKind::kOverConfident:
      return kit::Icon::kWarning;
    case MomentKind::kLowAgreement:
      return kit::Icon::kLayers;
    case MomentKind::kLost:
      return kit::Icon::kError;
    case MomentKind::kFound:
      return kit::Icon::kCheck;
    case MomentKind::kMissingData:
      return kit::Icon::kClock;
  }
  return kit::Icon::kInfo;
}

kit::TextLook look_of(MomentKind kind) {
  switch (kind) {
    case MomentKind::kLargestError:
    case MomentKind::kOverConfident:
    case MomentKind::kLost:
      return kit::TextLook::kBad;
    case MomentKind::kLowAgreement:
    case MomentKind::kMissingData:
      return kit::TextLook::kWarning;
    case MomentKind::kFound:
      return kit::TextLook::kGood;
  }
  return kit::TextLook::kMuted;
}

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
  if (typed.was_committed || typed.was_entered || typed.was_cancelled) state.edited.reset();
}

void draw_bookmark(kit::Ui& ui,
                   const BookmarksModel& model,
                   std::size_t index,
                   BookmarksState& state,
                   Actions& asked) {
  const Bookmark& bookmark = model.bookmarks[index];
  const int number = static_cast<int>(index) + 1;
  const std::string label = fmt::format("{}", number);
  if (state.edited == index) {
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
    state.edited = index;
  } else if (wants_remove) {
    asked.emplace_back(actions::RemoveBookmark{number});
  } else if (input.was_clicked) {
    asked.emplace_back(actions::Seek{bookmark.time_s});
  }
}

void draw_moment(kit::Ui& ui, const BookmarksModel& model, std::size_t index, Actions& asked) {
  const WorstMoment& moment = model.moments[index];
  const auto scope = ui.scope(fmt::format("{}", index + 1));
  const double inside = ui.room().width - ui.px(8.0);
  kit::ListRow row;
  row.is_selected = is_at(model.time_s, moment.time_s);
  row.hint = {fmt::format("{}: {}", enum_name(moment.kind), moment.words), ""};
  if (ui.list_row("##go", row).was_clicked) asked.emplace_back(actions::Seek{moment.time_s});
  ui.same_line(0.0);
  ui.right_align(inside);
  ui.icon(icon_of(moment.kind), look_of(moment.kind));
  ui.same_line(ui.px(10.0));
  ui.text(clock_text(moment.time_s), kit::TextLook::kNumber);
  ui.same_line(ui.px(10.0));
  ui.cut_text(moment.words);
}

void draw_moments(kit::Ui& ui, const BookmarksModel& model, Actions& asked) {
  const auto section = ui.section("Worst moments", true, fmt::format("{}", model.moments.size()));
  if (!section) return;
  if (model.moments.empty()) {
    ui.wrapped("Nothing in this run asks for a look: no large error, no breach, no gap.",
               kit::TextLook::kMuted);
  }
  for (std::size_t i = 0; i < model.moments.size(); ++i) draw_moment(ui, model, i, asked);
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
  return model;
}

Actions draw_bookmarks(kit::Ui& ui, const BookmarksModel& model, BookmarksState& state) {
  const auto scope = ui.scope("Bookmarks");
  if (!model.reading.empty()) return draw_empty_state(ui, reading_state(model.reading));
  if (!model.has_run)
    return draw_empty_state(ui, no_run_state("its worst moments and your bookmarks"));
  Actions asked;
  if (state.edited && *state.edited >= model.bookmarks.size()) state.edited.reset();
  draw_new(ui, state, asked);
  ui.space();
  const auto area = ui.scroll_area("Bookmarks area");
  for (std::size_t i = 0; i < model.bookmarks.size(); ++i)
    draw_bookmark(ui, model, i, state, asked);
  if (model.bookmarks.empty()) ui.text("No bookmarks yet", kit::TextLook::kMuted);
  ui.space();
  draw_moments(ui, model, asked);
  return asked;
}

}  // namespace nadir
