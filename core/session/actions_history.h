// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/session/action_fields.h"

/// Bookmarks, notices, undo.
namespace nadir::actions {

struct AddBookmark {
  static constexpr std::string_view kForm = "bookmark [NOTE]";
  static constexpr std::string_view kHelp = "Mark this moment of the active run, with a note";
  std::optional<std::string> note;
  NADIR_ACTION_FIELDS(note)
  friend bool operator==(const AddBookmark&, const AddBookmark&) = default;
};

struct EditBookmark {
  static constexpr std::string_view kForm = "bookmark-note NUMBER NOTE";
  static constexpr std::string_view kHelp = "Change the note of a bookmark";
  int bookmark = 1;
  std::string note;
  NADIR_ACTION_FIELDS(bookmark, note)
  friend bool operator==(const EditBookmark&, const EditBookmark&) = default;
};

struct RemoveBookmark {
  static constexpr std::string_view kForm = "bookmark-remove NUMBER";
  static constexpr std::string_view kHelp = "Take a bookmark away";
  int bookmark = 1;
  NADIR_ACTION_FIELDS(bookmark)
  friend bool operator==(const RemoveBookmark&, const RemoveBookmark&) = default;
};

struct DismissNotice {
  static constexpr std::string_view kForm = "dismiss [NOTICE]";
  static constexpr std::string_view kHelp = "Put a notice away as read; without a number, all";
  std::optional<int> notice;
  NADIR_ACTION_FIELDS(notice)
  friend bool operator==(const DismissNotice&, const DismissNotice&) = default;
};

struct Undo {
  static constexpr std::string_view kForm = "undo";
  static constexpr std::string_view kHelp = "Take the last change back";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const Undo&, const Undo&) = default;
};

struct Redo {
  static constexpr std::string_view kForm = "redo";
  static constexpr std::string_view kHelp = "Do again what was taken back";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const Redo&, const Redo&) = default;
};

}  // namespace nadir::actions
