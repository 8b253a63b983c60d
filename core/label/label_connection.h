// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/label/label_database.h"

namespace nadir {

/// An open labels.gpkg, and the way around what a killed writer has left in a folder that cannot be written. Private to this
/// module.
class LabelConnection {
 public:
  /// A killed writer's last edits lie in NAME-wal, and SQLite must write beside the file to read them. Where it may not, file
  /// and edits are read from a copy in a temporary folder, which lives as long as this object.
  /// @param name  Stands for the file in messages. @param is_for_reading  Nothing is written, whatever could be.
  /// @errors kMalformed: no database; kIo, also where the name has come to stand for another file meanwhile.
  [[nodiscard]] static Result<LabelConnection> open(const std::filesystem::path& path,
                                                    const std::string& name,
                                                    bool is_for_reading);

  [[nodiscard]] const SqliteDatabase& database() const { return database_; }
  /// What would be written would be lost.
  [[nodiscard]] bool is_copy() const { return copy_ != nullptr; }
  /// For a file that has lost its name: what lies in its file of changes is carried over where that is possible, and closing
  /// leaves alone what its name stands for now.
  void let_go(bool has_changes);

 private:
  struct TemporaryFolder {
    std::filesystem::path path;
    explicit TemporaryFolder(std::filesystem::path folder) : path(std::move(folder)) {}
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();
  };

  LabelConnection(std::unique_ptr<TemporaryFolder> copy, SqliteDatabase database)
      : copy_(std::move(copy)), database_(std::move(database)) {}
  [[nodiscard]] static Result<LabelConnection> open_copy(const std::filesystem::path& path,
                                                         const std::string& name);

  std::unique_ptr<TemporaryFolder> copy_;  ///< Null: none. Goes after the database.
  SqliteDatabase database_;
};

}  // namespace nadir
