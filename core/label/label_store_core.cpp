// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_store_core.h"

#include <fmt/chrono.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>

#include "core/base/require.h"

namespace nadir {

std::string label_time_now() {
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

std::string label_holder(const std::string& author) {
  std::array<char, 256> host{};
  const bool is_known = ::gethostname(host.data(), host.size() - 1) == 0 && host.front() != 0;
  return fmt::format("{} on {} since {} (process {})", author.empty() ? "somebody" : author,
                     is_known ? host.data() : "this machine", label_time_now(), ::getpid());
}

LabelStore::Implementation::Implementation(Opening opening,
                                           LabelConnection opened,
                                           LabelDocument empty)
    : path(std::move(opening.path)),
      real(std::move(opening.real)),
      author(std::move(opening.author)),
      file(std::filesystem::absolute(path)),
      lock(std::move(opening.lock)),
      connection(std::move(opened)),
      document(std::move(empty)),
      why_read_only(std::move(opening.why_read_only)) {}

Result<void> LabelStore::Implementation::check_writable() const {
  NADIR_REQUIRE(!is_closed);
  if (why_read_only.empty()) return {};
  return fail(ErrorCode::kInvalidOptions, "{}", why_read_only);
}

Result<void> LabelStore::Implementation::read_all() {
  auto transaction = SqliteTransaction::begin(database(), "BEGIN");
  if (!transaction) return forward_error(transaction);
  const auto contents = read_contents(database(), document);
  if (!contents) return forward_error(contents);
  notices.insert(notices.end(), contents->notices.begin(), contents->notices.end());
  if (!contents->is_whole) {
    take_as_damaged();
    return {};
  }
  return read_history();
}

Result<void> LabelStore::Implementation::read_history() {
  const auto at = read_head(database());
  if (!at) return forward_error(at);
  auto undone = read_step(database(), *at);
  if (!undone) return forward_error(undone);
  auto redone = youngest_after(database(), *at);
  if (!redone) return forward_error(redone);
  const auto version = database().whole("PRAGMA data_version");
  if (!version) return forward_error(version);
  head = *at;
  undo_step = std::move(*undone);
  redo_step = std::move(*redone);
  data_version = *version;
  return {};
}

void LabelStore::Implementation::take_as_damaged() {
  if (is_damaged) return;
  is_damaged = true;
  why_read_only = fmt::format("{}: is damaged, so what could be read of it was opened for reading",
                              path.string());
  notices.push_back(why_read_only);
  undo_step.reset();
  redo_step.reset();
}

Result<void> LabelStore::Implementation::commit(const LabelEdit& edit) {
  if (auto fits = document.check(edit); !fits) return fits;
  return add(edit, {});
}

Result<void> LabelStore::Implementation::prepare_writing() {
  if (has_written) return {};
  const auto before = database().whole("PRAGMA data_version");
  if (!before) return forward_error(before);
  static_cast<void>(database().execute("PRAGMA journal_mode = WAL"));
  static_cast<void>(database().execute("PRAGMA synchronous = NORMAL"));
  static_cast<void>(database().execute("PRAGMA wal_autocheckpoint = 0"));
  const auto after = database().whole("PRAGMA data_version");
  if (!after) return forward_error(after);
  // Changing the mode counts as a change by somebody else.
  if (*before == data_version) data_version = *after;
  has_written = true;
  sync = std::make_unique<LabelSync>(NamedFile(real));
  return {};
}

Result<void> LabelStore::Implementation::write(bool expects_own,
                                               const std::function<Result<void>()>& change) {
  if (auto in_place = check_in_place(); !in_place) return in_place;
  if (auto prepared = prepare_writing(); !prepared) return prepared;
  auto transaction = SqliteTransaction::begin(database(), "BEGIN IMMEDIATE");
  if (!transaction) return forward_error(transaction);
  const auto version = database().whole("PRAGMA data_version");
  if (!version) return forward_error(version);
  if (expects_own && *version != data_version) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: another program has changed it; take its changes over first", path.string());
  }
  if (beside.empty()) {
    for (const char* const ending : {"-wal", "-shm"}) {
      NamedFile found(real.string() + ending);
      if (found.was_there()) beside.push_back(std::move(found));
    }
  }
  if (auto changed = change(); !changed) return changed;
  if (auto committed = transaction->commit(); !committed) return committed;
  // Where the file has lost its name just now, what was written into it would not be found again.
  if (!file.has_its_name()) return let_go_of_file();
  sync->note_commit();
  return {};
}

Result<void> LabelStore::Implementation::add(
    const LabelEdit& edit, const std::vector<std::pair<ObjectKind, ObjectId>>& strays) {
  LabelStep step{0, head, label_time_now(), author, edit.title};
  auto written = write(true, [&]() -> Result<void> {
    for (const auto& [kind, id] : strays) {
      if (auto removed = remove_row(database(), kind, id); !removed) return removed;
    }
    if (auto changed = write_edit(database(), edit); !changed) return changed;
    const auto number = add_step(database(), step, edit);
    if (!number) return forward_error(number);
    step.number = *number;
    return write_head(database(), step.number);
  });
  if (!written) return written;
  document.apply(edit);
  head = step.number;
  undo_step = std::move(step);
  redo_step.reset();
  return {};
}

Result<LabelEdit> LabelStore::Implementation::go(const LabelStep& step, StepDirection direction) {
  auto edit = edit_of_step(database(), step, direction, document);
  if (!edit) return forward_error(edit, path.string());
  if (auto fits = document.check(*edit); !fits) return forward_error(fits, path.string());
  const std::int64_t to = direction == StepDirection::kUndo ? step.parent : step.number;
  std::optional<LabelStep> undone, redone;
  auto written = write(true, [&]() -> Result<void> {
    if (auto changed = write_edit(database(), *edit); !changed) return changed;
    auto before = read_step(database(), to);
    if (!before) return forward_error(before);
    auto after = youngest_after(database(), to);
    if (!after) return forward_error(after);
    undone = std::move(*before);
    redone = std::move(*after);
    return write_head(database(), to);
  });
  if (!written) return forward_error(written);
  document.apply(*edit);
  head = to;
  undo_step = std::move(undone);
  redo_step = std::move(redone);
  return edit;
}

Result<LabelStep> LabelStore::Implementation::sound_step(std::int64_t number,
                                                         ErrorCode if_missing) const {
  auto step = read_step(database(), number);
  if (!step) return forward_error(step);
  if (!*step) {
    return fail(if_missing, "{}: its history has no step {}", path.string(), number);
  }
  // Parents are older than what follows them; where they are not, the way up has no end.
  if ((*step)->parent >= number || (*step)->parent < 0) {
    return fail(ErrorCode::kMalformed, "{}: step {} of its history follows none", path.string(),
                number);
  }
  return std::move(**step);
}

Result<void> LabelStore::Implementation::go_to(std::int64_t number) {
  std::vector<LabelStep> way;  // From the step wanted up to the beginning.
  for (std::int64_t at = number; at != 0; at = way.back().parent) {
    auto step = sound_step(at, way.empty() ? ErrorCode::kInvalidOptions : ErrorCode::kMalformed);
    if (!step) return forward_error(step);
    way.push_back(std::move(*step));
  }
  const auto is_on_way = [&](std::int64_t step) {
    return step == 0 || std::any_of(way.begin(), way.end(),
                                    [&](const LabelStep& one) { return one.number == step; });
  };
  while (!is_on_way(head)) {
    NADIR_REQUIRE(undo_step.has_value());
    if (auto gone = go(LabelStep(*undo_step), StepDirection::kUndo); !gone)
      return forward_error(gone);
  }
  for (auto step = way.rbegin(); step != way.rend(); ++step) {
    if (step->number <= head) continue;
    if (auto gone = go(*step, StepDirection::kRedo); !gone) return forward_error(gone);
  }
  return {};
}

Result<std::vector<LabelEdit>> LabelStore::Implementation::way(const LabelDocument& start,
                                                               std::int64_t from,
                                                               std::int64_t to) const {
  if (const auto oldest = std::min(from, to); oldest < 0) {
    return fail(ErrorCode::kInvalidOptions, "{}: its history has no step {}", path.string(),
                oldest);
  }
  // The younger of two ends is never before the older one, so that both come to where the branches part.
  std::vector<std::pair<LabelStep, StepDirection>> steps, forth;
  while (from != to) {
    const bool is_end = from > to ? steps.empty() : forth.empty();
    auto step =
        sound_step(std::max(from, to), is_end ? ErrorCode::kInvalidOptions : ErrorCode::kMalformed);
    if (!step) return forward_error(step);
    const bool goes_back = from > to;
    (goes_back ? from : to) = step->parent;
    (goes_back ? steps : forth)
        .emplace_back(std::move(*step), goes_back ? StepDirection::kUndo : StepDirection::kRedo);
  }
  steps.insert(steps.end(), forth.rbegin(), forth.rend());
  std::vector<LabelEdit> edits;
  edits.reserve(steps.size());
  std::optional<LabelDocument>
      after;  // From the second step on, so that one costs what its edit does.
  for (const auto& [step, direction] : steps) {
    if (!edits.empty()) {
      if (!after) after = start;
      after->apply(edits.back());
    }
    const LabelDocument& at = after ? *after : start;
    auto edit = edit_of_step(database(), step, direction, at);
    if (!edit) return forward_error(edit, path.string());
    if (auto fits = at.check(*edit); !fits) return forward_error(fits, path.string());
    edits.push_back(std::move(*edit));
  }
  return edits;
}

Result<ForeignChanges> LabelStore::Implementation::find_foreign() {
  auto transaction = SqliteTransaction::begin(database(), "BEGIN");
  if (!transaction) return forward_error(transaction);
  auto changes = find_foreign_changes(database(), document, !is_damaged);
  if (!changes) return changes;
  const auto version = database().whole("PRAGMA data_version");
  if (!version) return forward_error(version);
  data_version = *version;
  return changes;
}

Result<void> LabelStore::Implementation::read_again() {
  LabelDocument before(document.plane(), document.grid());
  std::swap(before, document);
  auto read = read_all();
  if (!read || is_damaged) std::swap(before, document);
  return read;
}

Result<LabelEdit> LabelStore::Implementation::take_foreign() {
  if (is_damaged) return take_foreign_objects();
  const auto at = read_head(database());
  if (!at) return forward_error(at);
  if (*at == head) return take_foreign_objects();
  // A program that knows steps: it may have changed paint, values and history too.
  const LabelDocument before = document;
  if (auto read = read_again(); !read) return forward_error(read);
  if (auto taken = take_foreign_objects(); !taken) return taken;
  return difference(before, document, "Follow another program");
}

Result<LabelEdit> LabelStore::Implementation::take_foreign_objects() {
  auto found = find_foreign();
  if (!found) return forward_error(found);
  notices.insert(notices.end(), found->notices.begin(), found->notices.end());
  if (!found->is_whole) take_as_damaged();
  if (found->edit.empty()) return std::move(found->edit);
  if (!why_read_only.empty()) {
    document.apply(found->edit);
  } else if (auto added = add(found->edit, found->strays); !added) {
    return forward_error(added);
  }
  return std::move(found->edit);
}

Result<void> LabelStore::Implementation::close() {
  if (is_closed) return {};
  is_closed = true;
  Result<void> closed;
  if (has_written) {
    closed = write(false, [&] { return write_layer_facts(database(), document); });
    sync.reset();
    if (closed) closed = make_single_file();
  }
  lock.reset();
  return closed;
}

Result<void> LabelStore::Implementation::make_single_file() {
  auto mode = database().prepare("PRAGMA journal_mode = DELETE");
  if (!mode) return forward_error(mode);
  const auto row = mode->next();
  if (!row) return forward_error(row);
  if (*row && mode->text(0) == "delete") return {};
  return fail(ErrorCode::kIo, "{}: another program has it open, so its last changes stay in {}-wal",
              path.string(), path.filename().string());
}

}  // namespace nadir
