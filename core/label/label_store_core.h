// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/label/label_connection.h"
#include "core/label/label_journal.h"
#include "core/label/label_lock.h"
#include "core/label/label_store.h"
#include "core/label/label_sync.h"
#include "core/label/label_tables.h"
#include "core/label/named_file.h"

namespace nadir {

/// What is settled before a document is opened.
struct LabelStore::Opening {
  std::filesystem::path path;  ///< As somebody has named it.
  std::filesystem::path real;  ///< Behind all links: beside this lie lock and file of changes.
  std::string author;
  std::optional<LabelLock> lock;
  std::string why_read_only;
};

/// All of a labelling document in its file. Private to this module. What changes both changes the file first, and then the
/// document in a way that cannot fail.
struct LabelStore::Implementation {
  Implementation(Opening opening, LabelConnection opened, LabelDocument empty);

  std::filesystem::path path;  ///< For messages.
  std::filesystem::path real;
  std::string author;
  NamedFile file;                             ///< By the name that somebody has used.
  std::optional<LabelLock> lock;              ///< Goes after the database.
  std::optional<LabelConnection> connection;  ///< Nothing once the file has lost its name.
  LabelDocument document;
  std::string why_read_only;
  std::vector<std::string> notices;
  std::optional<LabelStep> undo_step, redo_step;
  std::int64_t head = 0;          ///< The step that the document stands at.
  std::int64_t data_version = 0;  ///< Of what was read; changes when another program writes.
  bool has_written = false;
  std::vector<NamedFile> beside;    ///< Files of changes, from the first write on.
  std::unique_ptr<LabelSync> sync;  ///< From the first write on.
  bool is_damaged = false;
  bool is_closed = false;

  [[nodiscard]] const SqliteDatabase& database() const { return connection->database(); }
  [[nodiscard]] Result<void> check_writable() const;
  [[nodiscard]] Result<void> read_all();
  [[nodiscard]] Result<void> read_history();
  [[nodiscard]] Result<void> commit(const LabelEdit& edit);
  [[nodiscard]] Result<LabelEdit> go(const LabelStep& step, StepDirection direction);
  /// Over as many steps as it takes, each by itself. @param number  0: the empty document.
  [[nodiscard]] Result<void> go_to(std::int64_t number);
  /// As LabelStore::way().
  [[nodiscard]] Result<std::vector<LabelEdit>> way(const LabelDocument& start,
                                                   std::int64_t from,
                                                   std::int64_t to) const;
  [[nodiscard]] Result<LabelEdit> take_foreign();
  /// Whether what is written would be found again (label_store_guard.cpp): the names of document, lock and files of changes
  /// still stand for what is open. What others have removed beside the document is made again.
  /// @errors kIo: the document itself is another file, or somebody else has the lock by now; from then on it is only read.
  [[nodiscard]] Result<void> check_in_place();
  [[nodiscard]] Result<void> close();

 private:
  /// @errors `if_missing`; kMalformed: it comes before the one that it follows.
  [[nodiscard]] Result<LabelStep> sound_step(std::int64_t number, ErrorCode if_missing) const;
  /// From now on it is only read, and has no history.
  void take_as_damaged();
  /// With the first write the file keeps its changes in a second one, so that a commit waits for no disk: the system has
  /// them as soon as it returns. Where another program has the file open that may fail, and commits are slower.
  [[nodiscard]] Result<void> prepare_writing();
  /// Changes the tables, or leaves them as they were. @errors kInvalidOptions: `expects_own`, and another program has
  /// written since the tables were read; those of `change`.
  [[nodiscard]] Result<void> write(bool expects_own, const std::function<Result<void>()>& change);
  /// An edit that fits becomes the youngest step.
  [[nodiscard]] Result<void> add(const LabelEdit& edit,
                                 const std::vector<std::pair<ObjectKind, ObjectId>>& strays);
  /// What the tables have that the document has not. Within a transaction of its own.
  [[nodiscard]] Result<ForeignChanges> find_foreign();
  [[nodiscard]] Result<LabelEdit> take_foreign_objects();
  /// Reads all anew, where another Nadir has written; where it is damaged, the document stays.
  [[nodiscard]] Result<void> read_again();
  [[nodiscard]] Result<void> make_single_file();
  /// The document in memory is all that is left. @returns why, as an error.
  [[nodiscard]] Result<void> let_go_of_file();
  [[nodiscard]] Result<void> take_lock_again();
  [[nodiscard]] Result<void> make_files_beside_again();
};

/// Now, UTC, ISO 8601.
[[nodiscard]] std::string label_time_now();
/// What others are told of who has a document.
[[nodiscard]] std::string label_holder(const std::string& author);

}  // namespace nadir
