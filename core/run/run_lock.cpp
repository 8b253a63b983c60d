// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_lock.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <system_error>
#include <utility>

namespace nadir::detail {

Result<RunLock> RunLock::make(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor < 0) {
    return fail(ErrorCode::kIo, "{}: {}", path.string(), std::generic_category().message(errno));
  }
  return lock(descriptor, path);
}

Result<RunLock> RunLock::hold(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  return descriptor < 0 ? RunLock(descriptor) : lock(descriptor, path);
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
    return fail(ErrorCode::kIo, "{}: is being written by another run", path.string());
  }
  return held;
}

RunLock::RunLock(RunLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

RunLock::~RunLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace nadir::detail
