// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// Asks for the note of a new bookmark.
struct BookmarkNoteModel {
  bool is_open = false;
  std::string run;      ///< Name; empty: none is open.
  double time_s = 0.0;  ///< After the run's first step.
};

struct BookmarkNoteState {
  std::string note = {};
  bool is_open = false;
};

[[nodiscard]] BookmarkNoteModel bookmark_note_model(const Session& session);

/// Lies over the window where the model says so; call it in every frame. Enter marks the moment, also without a note.
[[nodiscard]] Actions draw_bookmark_note(kit::Ui& ui,
                                         const BookmarkNoteModel& model,
                                         BookmarkNoteState& state);

}  // namespace nadir
