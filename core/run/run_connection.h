// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/base/sqlite_database.h"

namespace nadir::detail {

/// An open run file for reading, and the way around a journal that a killed writer left.
///
/// The file is opened read-only. If the writer died between the first and the last byte of a step,
/// SQLite finds its journal and must take the half step back before anybody may read: done in place
/// where file and folder are writable, otherwise on a copy of file and journal in a temporary
/// folder, which lives as long as this object.
class RunConnection {
 public:
  /// @errors kNotFound; kMalformed: empty, not a run file, damaged; kUnsupported: of a newer
  /// version; kIo.
  [[nodiscard]] static Result<RunConnection> open(const std::filesystem::path& path);

  [[nodiscard]] const SqliteDatabase& database() const { return database_; }

  /// Calls `work(database)` inside one read transaction, so that a writer at work cannot show in
  /// half.
  template <typename Work>
  auto read(Work&& work) -> decltype(work(std::declval<const SqliteDatabase&>())) {
    auto transaction = begin();
    if (!transaction) return forward_error(transaction);
    auto outcome = work(static_cast<const SqliteDatabase&>(database_));
    return outcome;
  }

 private:
  struct RemovedFolder {
    std::filesystem::path path;
    explicit RemovedFolder(std::filesystem::path folder) : path(std::move(folder)) {}
    RemovedFolder(const RemovedFolder&) = delete;
    RemovedFolder& operator=(const RemovedFolder&) = delete;
    ~RemovedFolder();
  };

  RunConnection(std::filesystem::path path, SqliteDatabase database)
      : path_(std::move(path)), database_(std::move(database)) {}
  /// A read transaction that holds its lock already.
  [[nodiscard]] Result<SqliteTransaction> begin();
  [[nodiscard]] Result<void> recover();
  [[nodiscard]] Result<void> recover_a_copy();

  std::filesystem::path path_;
  std::unique_ptr<RemovedFolder> copy_;
  SqliteDatabase database_;
};

}  // namespace nadir::detail
