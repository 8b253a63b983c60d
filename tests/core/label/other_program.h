// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace nadir {

/// What somebody else does to a labels.gpkg, with plain SQLite.
class OtherProgram {
 public:
  explicit OtherProgram(const std::filesystem::path& path) {
    if (sqlite3_open(path.c_str(), &database_) != SQLITE_OK) throw std::runtime_error("not opened");
  }
  ~OtherProgram() { sqlite3_close_v2(database_); }
  OtherProgram(const OtherProgram&) = delete;
  OtherProgram& operator=(const OtherProgram&) = delete;

  void run(const std::string& sql) const {
    char* message = nullptr;
    if (sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, &message) == SQLITE_OK) return;
    const std::string text = message != nullptr ? message : "unknown fault";
    sqlite3_free(message);
    throw std::runtime_error(sql + ": " + text);
  }
  /// The first column of the first row; empty without rows.
  [[nodiscard]] std::string value(const std::string& sql) const {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(database_, sql.c_str(), -1, &statement, nullptr) != SQLITE_OK) {
      throw std::runtime_error(sql + ": " + sqlite3_errmsg(database_));
    }
    std::string text;
    if (sqlite3_step(statement) == SQLITE_ROW) {
      const auto* const found = reinterpret_cast<const char*>(sqlite3_column_text(statement, 0));
      text = found != nullptr ? found : "";
    }
    sqlite3_finalize(statement);
    return text;
  }

 private:
  sqlite3* database_ = nullptr;
};

}  // namespace nadir
