// SPDX-License-Identifier: Apache-2.0
// How a document comes into being, and how it is opened.
#include <unistd.h>

#include <system_error>
#include <utility>

#include "core/base/durability.h"
#include "core/base/staged_output.h"
#include "core/label/label_store_core.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

Result<void> check_grid(const LabelGrid& grid) {
  if (grid.metres_per_cell > 0.0 && grid.metres_per_cell <= 1e4 && grid.width > 0 &&
      grid.height > 0 && grid.top_left_in_enu_m.cwiseAbs().maxCoeff() <= kMostObjectCoordinateM) {
    return {};
  }
  return fail(ErrorCode::kInvalidOptions, "{} x {} cells of {} m are no grid for labels",
              grid.width, grid.height, grid.metres_per_cell);
}

/// The file, and the folder, in which a file of changes comes and goes.
bool can_be_written(const fs::path& path) {
  return ::access(path.c_str(), W_OK) == 0 && ::access(path.parent_path().c_str(), W_OK) == 0;
}

/// Behind all links, so that whoever comes by another way meets the same lock and the same file of changes. Of a file that is
/// not there, its folder.
fs::path behind_links(const fs::path& path) {
  std::error_code error;
  fs::path real = fs::weakly_canonical(path, error);
  return error ? fs::absolute(path, error) : real;
}

/// SQLite would take what a killed program has left beside a document that is gone for the changes of a new one. It is the
/// last of somebody's work, so it gets another name. @returns what to tell, or nothing.
Result<std::optional<std::string>> set_aside(const fs::path& changes) {
  std::error_code error;
  const auto bytes = fs::file_size(changes, error);
  if (error) return std::optional<std::string>();
  if (bytes == 0) {
    fs::remove(changes, error);
    return std::optional<std::string>();
  }
  for (int number = 1;; ++number) {
    const fs::path aside = fmt::format("{}.left-{}", changes.string(), number);
    if (fs::exists(fs::symlink_status(aside, error))) continue;
    if (auto named = detail::rename_without_replacing(changes, aside); !named) {
      return forward_error(named);
    }
    return fmt::format("{}: holds changes of a document that is gone, and is called {} now",
                       changes.string(), aside.filename().string());
  }
}

/// Writes a document and its first steps into a file that nobody knows yet. @returns what it holds.
Result<LabelDocument> write_whole(const fs::path& staged,
                                  const std::string& name,
                                  const LabelDocument& empty,
                                  std::span<const LabelEdit> first,
                                  const std::string& author) {
  const auto database = open_label_database(staged, name, SqliteAccess::kCreate);
  if (!database) return forward_error(database);
  // Whatever happens, the file goes or is waited for as a whole.
  if (auto quick = database->execute("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF");
      !quick) {
    return forward_error(quick);
  }
  auto transaction = SqliteTransaction::begin(*database, "BEGIN IMMEDIATE");
  if (!transaction) return forward_error(transaction);
  LabelDocument document(empty.plane(), empty.grid());
  if (auto made = create_tables(*database, document.plane(), document.grid()); !made) {
    return forward_error(made);
  }
  std::int64_t head = 0;
  for (const LabelEdit& edit : first) {
    if (edit.empty()) continue;
    if (auto fits = document.check(edit); !fits) return forward_error(fits);
    if (auto written = write_edit(*database, edit); !written) return forward_error(written);
    const auto step = add_step(*database, {0, head, label_time_now(), author, edit.title}, edit);
    if (!step) return forward_error(step);
    head = *step;
    document.apply(edit);
  }
  if (auto written = write_head(*database, head); !written) return forward_error(written);
  if (auto written = write_layer_facts(*database, document); !written) {
    return forward_error(written);
  }
  if (auto made = transaction->commit(); !made) return forward_error(made);
  return document;
}

std::string words_of_holder(const std::string& holder) {
  return holder.empty() ? "somebody" : holder;
}

}  // namespace

std::optional<std::string> LabelStore::writer(const fs::path& path) {
  auto holder = LabelLock::holder(behind_links(path));
  if (holder) *holder = words_of_holder(*holder);
  return holder;
}

Result<LabelStore> LabelStore::create(const fs::path& path,
                                      const ProjectPlane& plane,
                                      const LabelGrid& grid,
                                      const std::string& author) {
  return create(path, LabelDocument(plane, grid), std::span<const LabelEdit>(), author);
}

Result<LabelStore> LabelStore::create(const fs::path& path,
                                      const LabelDocument& document,
                                      const std::string& author) {
  const LabelDocument empty(document.plane(), document.grid());
  const LabelEdit all = difference(empty, document, "Copy of another document");
  return create(path, empty, std::span(&all, 1), author);
}

Result<LabelStore> LabelStore::create(const fs::path& path,
                                      const LabelDocument& empty,
                                      std::span<const LabelEdit> first,
                                      const std::string& author) {
  const std::string name = path.string();
  if (auto sound = check_grid(empty.grid()); !sound) return forward_error(sound, name);
  std::error_code ignored;
  if (fs::exists(path, ignored)) return fail(ErrorCode::kIo, "{}: is there already", name);
  if (fs::is_symlink(path, ignored)) {
    return fail(ErrorCode::kIo, "{}: is a link to a file that is not there", name);
  }
  const fs::path real = behind_links(path);
  auto locked = LabelLock::take(real, label_holder(author));
  if (!locked) {
    return fail(ErrorCode::kIo, "{}: cannot be made ({})", name, locked.error().message);
  }
  if (!locked->lock) {
    return fail(ErrorCode::kIo, "{}: is open for {}", name, words_of_holder(locked->holder));
  }
  auto staged = StagedOutput::file(real);
  if (!staged) return forward_error(staged);
  auto document = write_whole(staged->path(), name, empty, first, author);
  if (!document) return forward_error(document);
  std::vector<std::string> notices;
  for (const char* const ending : {"-wal", "-journal"}) {
    auto told = set_aside(real.string() + ending);
    if (!told) return forward_error(told);
    if (*told) notices.push_back(std::move(**told));
  }
  if (auto made = staged->commit_as_new(); !made) return forward_error(made);
  Opening opening{path, real, author, std::move(locked->lock), {}};
  auto store = open(std::move(opening), std::move(*document));
  if (store) {
    auto& told = store->implementation_->notices;
    told.insert(told.end(), notices.begin(), notices.end());
  }
  return store;
}

Result<LabelStore> LabelStore::open(const fs::path& path,
                                    const std::string& author,
                                    LabelAccess access) {
  auto opening = find(path, author, access);
  if (!opening) return forward_error(opening);
  return open(std::move(*opening), std::nullopt);
}

Result<LabelStore::Opening> LabelStore::find(const fs::path& path,
                                             const std::string& author,
                                             LabelAccess access) {
  const std::string name = path.string();
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return fail(ErrorCode::kNotFound, "{}: no such file", name);
  Opening opening{path, behind_links(path), author, {}, {}};
  if (access == LabelAccess::kRead) {
    opening.why_read_only = fmt::format("{}: was opened for reading", name);
  } else if (!can_be_written(opening.real)) {
    opening.why_read_only =
        fmt::format("{}: cannot be written, so it was opened for reading", name);
  } else if (auto outcome = LabelLock::take(opening.real, label_holder(author)); !outcome) {
    opening.why_read_only =
        fmt::format("{}, so it was opened for reading", outcome.error().message);
  } else if (outcome->lock) {
    opening.lock = std::move(outcome->lock);
  } else {
    opening.why_read_only = fmt::format("{}: is open for {}, so it was opened for reading", name,
                                        words_of_holder(outcome->holder));
  }
  return opening;
}

Result<LabelStore> LabelStore::open(Opening opening, std::optional<LabelDocument> known) {
  const std::string name = opening.path.string();
  auto connection = LabelConnection::open(opening.real, name, !opening.why_read_only.empty());
  if (!connection) return forward_error(connection);
  if (connection->is_copy() && opening.why_read_only.empty()) {
    opening.why_read_only =
        fmt::format("{}: only a copy could be opened, so it was opened for reading", name);
  }
  const bool is_known = known.has_value();
  if (!known) {
    auto empty = read_header(connection->database(), name);
    if (!empty) return forward_error(empty);
    known = std::move(*empty);
  }
  auto all = std::make_unique<Implementation>(std::move(opening), std::move(*connection),
                                              std::move(*known));
  if (auto read = is_known ? all->read_history() : all->read_all(); !read) {
    return forward_error(read);
  }
  if (auto taken = all->take_foreign(); !taken) return forward_error(taken);
  return LabelStore(std::move(all));
}

}  // namespace nadir
