// SPDX-License-Identifier: Apache-2.0
// What others do to the files of an open document: replace, move and remove them.
#include "core/label/label_store_core.h"

namespace nadir {

Result<void> LabelStore::Implementation::check_in_place() {
  if (!file.has_its_name()) return let_go_of_file();
  if (lock && !lock->is_held()) {
    if (auto taken = take_lock_again(); !taken) return taken;
  }
  for (const NamedFile& found : beside) {
    if (!found.has_its_name()) return make_files_beside_again();
  }
  return {};
}

Result<void> LabelStore::Implementation::let_go_of_file() {
  const bool is_there = FileIdentity::of(file.path()).has_value();
  why_read_only = fmt::format(
      "{}: another program has {}, so that what was drawn is no longer in "
      "that file and can only be read; save it under another name",
      path.string(), is_there ? "replaced it" : "deleted or moved it");
  undo_step.reset();
  redo_step.reset();
  sync.reset();
  // Its file of changes may lie beside another document by now, which has nothing to do with it. So what lies there goes into
  // the file that is open, which may have another name; unless others write into it too.
  const auto version = database().whole("PRAGMA data_version");
  connection->let_go(has_written && version && *version == data_version);
  connection.reset();
  beside.clear();
  has_written = false;
  lock.reset();
  return fail(ErrorCode::kIo, "{}", why_read_only);
}

Result<void> LabelStore::Implementation::take_lock_again() {
  auto outcome = LabelLock::take(real, label_holder(author));
  if (!outcome) return fail(ErrorCode::kIo, "{}: {}", path.string(), outcome.error().message);
  if (outcome->lock) {
    lock = std::move(outcome->lock);
    return {};
  }
  why_read_only = fmt::format("{}: is open for {} by now, so it can only be read", path.string(),
                              outcome->holder.empty() ? "somebody" : outcome->holder);
  sync.reset();
  lock.reset();
  beside.clear();
  has_written = false;
  static_cast<void>(database().execute("PRAGMA query_only = ON"));
  return fail(ErrorCode::kIo, "{}", why_read_only);
}

Result<void> LabelStore::Implementation::make_files_beside_again() {
  sync.reset();
  const auto before = database().whole("PRAGMA data_version");
  if (!before) return forward_error(before);
  // All that was committed lies in a file without a name, which would be gone with this program.
  static_cast<void>(database().execute("PRAGMA wal_checkpoint(TRUNCATE)"));
  if (auto single = make_single_file(); !single) {
    return fail(ErrorCode::kIo,
                "{}: its file of changes was removed while another program has it open too; close "
                "it there",
                path.string());
  }
  beside.clear();
  has_written = false;
  const auto after = database().whole("PRAGMA data_version");
  if (!after) return forward_error(after);
  if (*before == data_version) data_version = *after;
  return {};
}

}  // namespace nadir
