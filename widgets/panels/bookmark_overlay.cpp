// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/bookmark_overlay.h"

#include <fmt/format.h>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/panel_text.h"
#include "widgets/panels/time_axis.h"

namespace nadir {

BookmarkNoteModel bookmark_note_model(const Session& session) {
  BookmarkNoteModel model;
  model.is_open = session.overlay() == Overlay::kBookmark;
  if (const OpenRun* const run = session.active_run(); run != nullptr && run->document) {
    model.run = run->name;
    model.time_s = session.playback().time_s;
  }
  return model;
}

Actions draw_bookmark_note(kit::Ui& ui, const BookmarkNoteModel& model, BookmarkNoteState& state) {
  if (!model.is_open || !state.is_open) state = {.is_open = model.is_open};
  if (!model.is_open) return {};
  const auto overlay =
      ui.overlay("Bookmark", {.width = ui.px(480.0), .place = kit::OverlayPlace::kUpperThird});
  if (!overlay) return {};
  const Actions closed = {actions::ShowOverlay{Overlay::kNone}};
  if (model.run.empty()) {
    Actions asked = draw_empty_state(ui, no_run_state("moments to mark"));
    if (!asked.empty()) asked.insert(asked.begin(), closed.front());
    return overlay.wants_close() ? closed : asked;
  }
  ui.text("Bookmark", kit::TextLook::kHeading);
  ui.same_line();
  ui.text(clock_text(model.time_s), kit::TextLook::kNumber);
  ui.same_line();
  ui.cut_text(fmt::format("of {}", model.run), kit::TextLook::kMuted);
  ui.space();
  const kit::TextEdit edit = ui.text_input(
      "##Note", state.note, {.placeholder = "What is to be seen here?", .takes_focus = true});
  state.note = edit.value;
  ui.space();
  ui.text("Kept in a small file beside the run.", kit::TextLook::kMuted);
  ui.same_line();
  ui.right_align(ui.px(96.0));
  ui.next_width(ui.px(96.0));
  const bool is_clicked = ui.button("Mark", kit::ButtonLook::kPrimary,
                                    {.text = "Mark this moment", .shortcut = "Enter"});
  if (is_clicked || edit.was_entered) {
    std::optional<std::string> note;
    if (!state.note.empty()) note = state.note;
    return {closed.front(), actions::AddBookmark{note}};
  }
  return edit.was_cancelled || overlay.wants_close() ? closed : Actions{};
}

}  // namespace nadir
