// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace nadir {

/// Runs SQL on a file as any other program would; the text of the first value, if any.
inline std::string run_sql(const std::filesystem::path& path, const std::string& sql) {
  sqlite3* database = nullptr;
  sqlite3_open(path.c_str(), &database);
  std::string answer;
  const auto take = [](void* into, int columns, char** values, char**) {
    auto& text = *static_cast<std::string*>(into);
    for (int i = 0; i < columns; ++i)
      text += (text.empty() ? "" : " ") + std::string(values[i] != nullptr ? values[i] : "NULL");
    return 0;
  };
  char* message = nullptr;
  sqlite3_exec(database, sql.c_str(), take, &answer, &message);
  if (message != nullptr) answer = message;
  sqlite3_free(message);
  sqlite3_close(database);
  return answer;
}

[[nodiscard]] inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace nadir
