// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <system_error>
#include <utility>

namespace nadir::detail {
namespace {

Error being_written(const std::filesystem::path& path) {
  return {ErrorCode::kIo, path.string() + ": is being written by another run"};
}

/// Whether the open file is the one that has this name now.
bool has_name(int descriptor, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

Result<RunLock> RunLock::make(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor < 0) {
    if (errno == EEXIST) return tl::unexpected(being_written(path));
    return fail(ErrorCode::kIo, "{}: {}", path.string(), std::generic_category().message(errno));
  }
  auto made = lock(descriptor, path);
  // Before it was locked, another writer may have taken the empty file for an old run and put it aside.
  if (made && !has_name(descriptor, path)) return tl::unexpected(being_written(path));
  return made;
}

Result<RunLock> RunLock::hold(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return RunLock(descriptor);
  auto held = lock(descriptor, path);
  // Between opening and locking, another writer may have put that file aside and begun its own.
  if (held && !has_name(descriptor, path)) return tl::unexpected(being_written(path));
  return held;
}

/// A lock of the open file, not of the process, so that two writers of one process are two. A file
/// system without such locks is used without.
Result<RunLock> RunLock::lock(int descriptor, const std::filesystem::path& path) {
  RunLock held(descriptor);
  struct flock byte {};
  byte.l_type = F_WRLCK;
  byte.l_whence = SEEK_SET;
  byte.l_start = std::numeric_limits<off_t>::max() - 1;
  byte.l_len = 1;
  if (::fcntl(descriptor, F_OFD_SETLK, &byte) != 0 && (errno == EAGAIN || errno == EACCES)) {
    return tl::unexpected(being_written(path));
  }
  return held;
}

RunLock::RunLock(RunLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

RunLock::~RunLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace nadir::detail
