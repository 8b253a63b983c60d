// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/label/label_store.h"

namespace nadir {

/// Tells whether a labelling document was written, replaced or let go by who writes it, without opening it. Private to this
/// module.
struct FileStamp {
  /// Of one file; nothing where it is not there.
  struct State {
    dev_t device = 0;
    ino_t number = 0;
    off_t bytes = 0;
    std::int64_t seconds = 0, nanoseconds = 0;  ///< Of the last change.
    friend bool operator==(const State&, const State&) = default;
  };
  std::optional<State> document, changes;
  std::optional<std::string> writer;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

[[nodiscard]] inline FileStamp stamp_of(const std::filesystem::path& path) {
  const auto state_of = [](const std::string& name) -> std::optional<FileStamp::State> {
    struct stat found {};
    if (::stat(name.c_str(), &found) != 0) return std::nullopt;
    return FileStamp::State{found.st_dev, found.st_ino, found.st_size, found.st_mtim.tv_sec,
                            found.st_mtim.tv_nsec};
  };
  std::error_code ignored;
  const std::filesystem::path real = std::filesystem::weakly_canonical(path, ignored);
  return {state_of(path.string()), state_of(real.string() + "-wal"), LabelStore::writer(path)};
}

}  // namespace nadir
