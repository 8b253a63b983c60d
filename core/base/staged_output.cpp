// SPDX-License-Identifier: Apache-2.0
#include "core/base/staged_output.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

namespace nadir {
namespace fs = std::filesystem;
namespace {

fs::path without_trailing_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

fs::path staged_name(const fs::path& target) {
  fs::path staged = target;
  staged += ".partial-" + std::to_string(::getpid());
  return staged;
}

Result<void> check_parent(const fs::path& target) {
  const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(parent, error)) {
    return fail(ErrorCode::kIo, "{}: folder {} does not exist", target.string(), parent.string());
  }
  if (::access(parent.c_str(), W_OK | X_OK) != 0) {
    return fail(ErrorCode::kIo, "{}: folder {} is not writable", target.string(), parent.string());
  }
  return {};
}

/// Whether a folder may be made under this name without losing anything that is not of the same kind.
Result<void> check_replaceable(const fs::path& target,
                               const std::string& name,
                               std::string_view marker,
                               std::span<const std::string_view> own_entries) {
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (!fs::exists(status)) return {};
  if (!fs::is_directory(status)) {
    return fail(ErrorCode::kIo, "{}: exists and is not a folder", name);
  }
  if (fs::equivalent(target, fs::current_path(error), error)) {
    return fail(ErrorCode::kIo, "{}: is the folder that you stand in; name a new one", name);
  }
  bool has_marker = false;
  bool is_empty = true;
  fs::directory_iterator entries(target, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    const std::string entry = entries->path().filename().string();
    is_empty = false;
    has_marker = has_marker || entry == marker;
    if (own_entries.empty()) continue;
    if (std::find(own_entries.begin(), own_entries.end(), entry) == own_entries.end()) {
      return fail(ErrorCode::kIo, "{}: holds {}, so it is left alone; name a new folder", name,
                  entry);
    }
  }
  if (error) return fail(ErrorCode::kIo, "{}: {}", name, error.message());
  if (is_empty || has_marker) return {};
  return fail(ErrorCode::kIo, "{}: exists and holds no {}, so it is left alone", name, marker);
}

}  // namespace

Result<StagedOutput> StagedOutput::file(const fs::path& target) {
  if (target.empty()) return fail(ErrorCode::kInvalidOptions, "output file: its name is empty");
  std::error_code error;
  if (fs::is_directory(target, error)) {
    return fail(ErrorCode::kIo, "{}: is a folder, not a file", target.string());
  }
  if (const auto parent = check_parent(target); !parent) return forward_error(parent);
  return StagedOutput(target, staged_name(target));
}

Result<StagedOutput> StagedOutput::folder(const fs::path& given,
                                          std::string_view marker,
                                          std::span<const std::string_view> own_entries) {
  if (given.empty()) return fail(ErrorCode::kInvalidOptions, "output folder: its name is empty");
  std::error_code error;
  const fs::path target = without_trailing_slash(fs::absolute(given, error).lexically_normal());
  if (const auto free = check_replaceable(target, given.string(), marker, own_entries); !free) {
    return forward_error(free);
  }
  if (const auto parent = check_parent(target); !parent) return forward_error(parent);
  const fs::path staged = staged_name(target);
  fs::remove_all(staged, error);
  if (!fs::create_directory(staged, error)) {
    return fail(ErrorCode::kIo, "{}: {}", staged.string(), error.message());
  }
  return StagedOutput(target, staged);
}

StagedOutput::StagedOutput(StagedOutput&& other) noexcept
    : target_(std::move(other.target_)), staged_(std::exchange(other.staged_, {})) {}

StagedOutput::~StagedOutput() {
  std::error_code error;
  if (!staged_.empty()) fs::remove_all(staged_, error);
}

Result<void> StagedOutput::commit() {
  std::error_code error;
  // A folder cannot be renamed over a filled one: the old one steps aside first and goes last, so a
  // crash loses neither.
  fs::path old;
  if (fs::is_directory(target_, error)) {
    old = target_;
    old += ".replaced-" + std::to_string(::getpid());
    fs::rename(target_, old, error);
    if (error) return fail(ErrorCode::kIo, "{}: {}", target_.string(), error.message());
  }
  fs::rename(staged_, target_, error);
  if (error) {
    const std::string reason = error.message();
    if (!old.empty()) fs::rename(old, target_, error);
    return fail(ErrorCode::kIo, "{}: {}", target_.string(), reason);
  }
  staged_.clear();
  if (!old.empty()) fs::remove_all(old, error);
  return {};
}

Result<void> write_text_file(const fs::path& path, std::string_view text) {
  auto staged = StagedOutput::file(path);
  if (!staged) return forward_error(staged);
  {
    std::ofstream stream(staged->path(), std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) {
      return fail(ErrorCode::kIo, "{}: cannot be written: {}", path.string(),
                  std::generic_category().message(errno));
    }
  }
  return staged->commit();
}

Result<std::string> read_text_file(const fs::path& path, std::uintmax_t max_bytes) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    return fail(ErrorCode::kNotFound, "{}: does not exist", path.string());
  }
  if (fs::is_directory(path, error)) {
    return fail(ErrorCode::kIo, "{}: is a folder, not a file", path.string());
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    return fail(ErrorCode::kIo, "{}: {}", path.string(), std::generic_category().message(errno));
  std::string text;
  std::array<char, 65536> buffer;
  while (stream.read(buffer.data(), buffer.size()) || stream.gcount() > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > max_bytes) {
      return fail(ErrorCode::kUnsupported, "{}: is larger than {} bytes", path.string(), max_bytes);
    }
  }
  if (stream.bad())
    return fail(ErrorCode::kIo, "{}: {}", path.string(), std::generic_category().message(errno));
  return text;
}

}  // namespace nadir
