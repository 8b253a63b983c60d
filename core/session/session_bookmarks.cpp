// SPDX-License-Identifier: Apache-2.0
// Bookmarks and the way back.
#include <algorithm>
#include <utility>

#include "core/session/session_core.h"

namespace nadir {

Result<void> Session::Implementation::keep_bookmarks(const std::string& run,
                                                     const Bookmarks& wanted) {
  const auto known = kept.bookmarks.find(run);
  auto written =
      write_bookmarks(run, wanted, known != kept.bookmarks.end() ? known->second : Bookmarks());
  if (!written) return forward_error(written);
  if (*written != wanted) foreign_bookmarks.push_back({run, wanted, *written});
  kept.bookmarks[run] = std::move(*written);
  return {};
}

void Session::Implementation::take_foreign(const ForeignBookmarks& foreign, const KeptState& last) {
  if (foreign.expected == foreign.found) return;
  history.amend(
      [&foreign](KeptState& state) {
        const auto known = state.bookmarks.find(foreign.run);
        if (known == state.bookmarks.end()) return;
        known->second = with_changes(known->second, foreign.expected, foreign.found);
      },
      last);
}

Result<void> Session::Implementation::perform(const actions::AddBookmark& action) {
  const auto run = need_run();
  if (!run) return forward_error(run);
  const std::string path = (*run)->path.string();
  Bookmark bookmark{playback.time_s, action.note.value_or(""), std::nullopt};
  return keep_bookmarks(path, with_bookmark((*run)->bookmarks, bookmark));
}

Result<void> Session::Implementation::perform(const actions::EditBookmark& action) {
  const auto run = need_run();
  if (!run) return forward_error(run);
  const Bookmarks& now = (*run)->bookmarks;
  if (action.bookmark < 1 || static_cast<std::size_t>(action.bookmark) > now.size()) {
    return fail(ErrorCode::kInvalidOptions, "there is no bookmark {}: {} has {}", action.bookmark,
                (*run)->name, now.size());
  }
  const auto index = static_cast<std::size_t>(action.bookmark) - 1;
  Bookmark changed = now[index];
  changed.note = action.note;
  return keep_bookmarks((*run)->path.string(), with_bookmark_changed(now, index, changed));
}

Result<void> Session::Implementation::perform(const actions::RemoveBookmark& action) {
  const auto run = need_run();
  if (!run) return forward_error(run);
  const Bookmarks& now = (*run)->bookmarks;
  if (action.bookmark < 1 || static_cast<std::size_t>(action.bookmark) > now.size()) {
    return fail(ErrorCode::kInvalidOptions, "there is no bookmark {}: {} has {}", action.bookmark,
                (*run)->name, now.size());
  }
  return keep_bookmarks((*run)->path.string(),
                        without_bookmark(now, static_cast<std::size_t>(action.bookmark) - 1));
}

Result<void> Session::Implementation::go_to_state(KeptState state) {
  // Bookmarks are files: those of the other state are written first, for that may fail. Those of runs that have been read
  // since then stay.
  std::map<std::string, Bookmarks> bookmarks = kept.bookmarks;
  std::vector<std::string> done;
  for (const auto& [run, wanted] : state.bookmarks) {
    const auto now = kept.bookmarks.find(run);
    if (now == kept.bookmarks.end() || now->second == wanted) continue;
    auto written = write_bookmarks(run, wanted, now->second);
    if (!written) {  // all or none
      for (const std::string& other : done) {
        static_cast<void>(write_bookmarks(other, kept.bookmarks[other], bookmarks[other]));
      }
      return forward_error(written);
    }
    if (*written != wanted) foreign_bookmarks.push_back({run, wanted, *written});
    bookmarks[run] = std::move(*written);
    done.push_back(run);
  }
  // Where the same panels are shown, the tabs in front stay there.
  const WindowLayout now = kept.view.layout;
  kept = std::move(state);
  kept.bookmarks = std::move(bookmarks);
  WindowLayout& layout = kept.view.layout;
  if (layout.is_shown == now.is_shown) {
    layout.left_tab = now.left_tab;
    layout.right_tab = now.right_tab;
  }
  return {};
}

Result<void> Session::Implementation::perform(const actions::Undo& /*action*/) {
  if (LabelDesk* const desk = desk_in_front()) return desk->undo();
  if (!history.can_undo()) {
    return fail(ErrorCode::kInvalidOptions, "there is nothing to take back");
  }
  KeptState before = history.undo(kept);
  auto gone = go_to_state(before);
  if (!gone) static_cast<void>(history.redo(std::move(before)));  // so that it can be tried again
  return gone;
}

Result<void> Session::Implementation::perform(const actions::Redo& /*action*/) {
  if (LabelDesk* const desk = desk_in_front()) return desk->redo();
  if (!history.can_redo()) {
    return fail(ErrorCode::kInvalidOptions, "there is nothing to do again");
  }
  KeptState after = history.redo(kept);
  auto gone = go_to_state(after);
  if (!gone) static_cast<void>(history.undo(std::move(after)));
  return gone;
}

}  // namespace nadir
