// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <utility>

namespace nadir {

/// Which file it is, whatever it is called. Private to this module.
struct FileIdentity {
  dev_t device = 0;
  ino_t number = 0;
  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;

  /// Of what a name stands for now, behind links; nothing where it stands for nothing.
  [[nodiscard]] static std::optional<FileIdentity> of(const std::filesystem::path& path);
  [[nodiscard]] static std::optional<FileIdentity> of(int descriptor);
};

/// A file that is open, and its name, which others may give to another file meanwhile. As long as it is open, no other file
/// gets its identity. Private to this module.
class NamedFile {
 public:
  /// What the name stands for now.
  explicit NamedFile(const std::filesystem::path& path) : NamedFile(path, FileIdentity::of(path)) {}
  NamedFile(std::filesystem::path path, std::optional<FileIdentity> identity)
      : path_(std::move(path)), identity_(identity) {}

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] bool was_there() const { return identity_.has_value(); }
  /// Whether the name still stands for it.
  [[nodiscard]] bool has_its_name() const {
    return was_there() && FileIdentity::of(path_) == identity_;
  }

 private:
  std::filesystem::path path_;
  std::optional<FileIdentity> identity_;
};

}  // namespace nadir
