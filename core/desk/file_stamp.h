// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace nadir {

/// Tells whether a labelling document was written, or let go by who writes it, without opening it. Private to this module.
struct FileStamp {
  std::uintmax_t bytes = 0, bytes_of_changes = 0;
  std::filesystem::file_time_type time, time_of_changes;
  bool is_locked = false;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

[[nodiscard]] inline FileStamp stamp_of(const std::filesystem::path& path) {
  FileStamp stamp;
  const std::filesystem::path changes = path.string() + "-wal";
  std::error_code error;
  stamp.bytes = std::filesystem::file_size(path, error);
  if (error) stamp.bytes = 0;
  stamp.time = std::filesystem::last_write_time(path, error);
  stamp.bytes_of_changes = std::filesystem::file_size(changes, error);
  if (error) stamp.bytes_of_changes = 0;
  stamp.time_of_changes = std::filesystem::last_write_time(changes, error);
  stamp.is_locked = std::filesystem::exists(path.string() + ".lock", error);
  return stamp;
}

}  // namespace nadir
