// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_store.h"

#include <unistd.h>

#include <array>
#include <utility>

#include "core/base/require.h"
#include "core/base/staged_output.h"
#include "core/label/label_store_core.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

std::string holder_of(const std::string& author) {
  std::array<char, 256> host{};
  const bool is_known = ::gethostname(host.data(), host.size() - 1) == 0 && host.front() != 0;
  return fmt::format("{} on {} since {} (process {})", author.empty() ? "somebody" : author,
                     is_known ? host.data() : "this machine", label_time_now(), ::getpid());
}

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
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  return ::access(path.c_str(), W_OK) == 0 && ::access(folder.c_str(), W_OK) == 0;
}

}  // namespace

LabelStore::LabelStore(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
LabelStore::LabelStore(LabelStore&& other) noexcept = default;

LabelStore& LabelStore::operator=(LabelStore&& other) noexcept {
  std::swap(implementation_, other.implementation_);
  return *this;
}

LabelStore::~LabelStore() {
  if (implementation_ != nullptr) static_cast<void>(implementation_->close());
}

Result<LabelStore> LabelStore::create(const fs::path& path,
                                      const ProjectPlane& plane,
                                      const LabelGrid& grid,
                                      const std::string& author) {
  const std::string name = path.string();
  if (auto sound = check_grid(grid); !sound) return forward_error(sound, name);
  std::error_code ignored;
  if (fs::exists(path, ignored)) return fail(ErrorCode::kIo, "{}: is there already", name);
  {
    auto staged = StagedOutput::file(path);
    if (!staged) return forward_error(staged);
    {
      auto database = open_label_database(staged->path(), name, SqliteAccess::kCreate);
      if (!database) return forward_error(database);
      auto transaction = SqliteTransaction::begin(*database, "BEGIN IMMEDIATE");
      if (!transaction) return forward_error(transaction);
      if (auto made = create_tables(*database, plane, grid); !made) return forward_error(made);
      if (auto made = transaction->commit(); !made) return forward_error(made);
    }
    if (auto made = staged->commit(); !made) return forward_error(made);
  }
  return open(path, author);
}

Result<LabelStore> LabelStore::create(const fs::path& path,
                                      const LabelDocument& document,
                                      const std::string& author) {
  auto store = create(path, document.plane(), document.grid(), author);
  if (!store) return store;
  const LabelEdit all = difference(store->document(), document, "Copy of another document");
  if (auto copied = store->commit(all); !copied) return forward_error(copied);
  return store;
}

Result<LabelStore> LabelStore::open(const fs::path& path,
                                    const std::string& author,
                                    LabelAccess access) {
  const std::string name = path.string();
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return fail(ErrorCode::kNotFound, "{}: no such file", name);
  std::optional<LabelLock> lock;
  std::string why_read_only;
  if (access == LabelAccess::kRead) {
    why_read_only = fmt::format("{}: was opened for reading", name);
  } else if (!can_be_written(path)) {
    why_read_only = fmt::format("{}: cannot be written, so it was opened for reading", name);
  } else if (auto outcome = LabelLock::take(path, holder_of(author)); !outcome) {
    why_read_only = fmt::format("{}, so it was opened for reading", outcome.error().message);
  } else if (outcome->lock) {
    lock = std::move(outcome->lock);
  } else {
    why_read_only = fmt::format("{}: is open for {}, so it was opened for reading", name,
                                outcome->holder.empty() ? "somebody" : outcome->holder);
  }
  auto connection = LabelConnection::open(path, !why_read_only.empty());
  if (!connection) return forward_error(connection);
  if (connection->is_copy() && why_read_only.empty()) {
    why_read_only =
        fmt::format("{}: only a copy could be opened, so it was opened for reading", name);
  }
  auto document = read_header(connection->database(), name);
  if (!document) return forward_error(document);
  auto implementation =
      std::make_unique<Implementation>(path, author, std::move(*connection), std::move(*document));
  implementation->lock = std::move(lock);
  implementation->why_read_only = std::move(why_read_only);
  if (auto read = implementation->read_all(); !read) return forward_error(read);
  if (auto taken = implementation->take_foreign(); !taken) return forward_error(taken);
  return LabelStore(std::move(implementation));
}

const LabelDocument& LabelStore::document() const { return implementation_->document; }
const std::string& LabelStore::why_read_only() const { return implementation_->why_read_only; }
bool LabelStore::is_damaged() const { return implementation_->is_damaged; }
const std::vector<std::string>& LabelStore::notices() const { return implementation_->notices; }
const std::optional<LabelStep>& LabelStore::undo_step() const { return implementation_->undo_step; }
const std::optional<LabelStep>& LabelStore::redo_step() const { return implementation_->redo_step; }

Result<void> LabelStore::commit(const LabelEdit& edit) {
  if (auto writable = implementation_->check_writable(); !writable) return writable;
  if (edit.empty()) return {};
  return implementation_->commit(edit);
}

Result<LabelEdit> LabelStore::undo() {
  if (auto writable = implementation_->check_writable(); !writable) return forward_error(writable);
  const auto step = implementation_->undo_step;
  if (!step) return fail(ErrorCode::kInvalidOptions, "there is nothing to undo");
  return implementation_->go(*step, StepDirection::kUndo);
}

Result<LabelEdit> LabelStore::redo() {
  if (auto writable = implementation_->check_writable(); !writable) return forward_error(writable);
  const auto step = implementation_->redo_step;
  if (!step) return fail(ErrorCode::kInvalidOptions, "there is nothing to do again");
  return implementation_->go(*step, StepDirection::kRedo);
}

Result<LabelEdit> LabelStore::go_to(std::int64_t step) {
  if (auto writable = implementation_->check_writable(); !writable) return forward_error(writable);
  const LabelDocument before = implementation_->document;
  if (auto gone = implementation_->go_to(step); !gone) return forward_error(gone);
  return difference(before, implementation_->document, "Go to another step");
}

Result<std::vector<LabelStep>> LabelStore::history(std::int64_t first, int count) const {
  return read_steps(implementation_->database(), first, count);
}

Result<LabelEdit> LabelStore::take_foreign_changes() {
  Implementation& all = *implementation_;
  NADIR_REQUIRE(!all.is_closed);
  const auto version = all.database().whole("PRAGMA data_version");
  if (!version) return forward_error(version);
  if (*version == all.data_version) return LabelEdit{};
  return all.take_foreign();
}

Result<void> LabelStore::flush() {
  NADIR_REQUIRE(!implementation_->is_closed);
  if (implementation_->sync == nullptr) return {};
  return implementation_->sync->flush();
}

Result<void> LabelStore::close() { return implementation_->close(); }

}  // namespace nadir
