// SPDX-License-Identifier: Apache-2.0
#include "core/base/durability.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace nadir::detail {
namespace fs = std::filesystem;
namespace {

/// Opens, calls `wait(descriptor)` and closes.
template <typename Wait>
Result<void> wait_with(const fs::path& path, Wait wait) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  // A folder may be writable and not readable; then there is nothing to wait with.
  if (descriptor < 0 && errno == EACCES) return {};
  int reason = descriptor < 0 || wait(descriptor) != 0 ? errno : 0;
  if (descriptor >= 0) ::close(descriptor);
  if (reason == EINVAL || reason == ENOSYS || reason == EOPNOTSUPP || reason == EROFS) reason = 0;
  if (reason == 0) return {};
  return fail(ErrorCode::kIo, "{}: cannot be written: {}", path.string(),
              std::generic_category().message(reason));
}

}  // namespace

Result<void> wait_for_disk(const fs::path& path) {
  std::error_code error;
  return wait_with(path, fs::is_directory(path, error) ? ::syncfs : ::fsync);
}

Result<void> wait_for_name(const fs::path& path) {
  return wait_with(path.has_parent_path() ? path.parent_path() : fs::path("."), ::fsync);
}

bool exchange_names(const fs::path& a, const fs::path& b) {
  return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

Result<void> rename_without_replacing(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return {};
  int reason = errno;
  if (reason == EINVAL || reason == ENOSYS) {
    // A second name of the same file, which cannot replace anything either; then the first one goes.
    reason = ::link(from.c_str(), to.c_str()) == 0 ? 0 : errno;
    if (reason == 0) ::unlink(from.c_str());
  }
  if (reason == EPERM || reason == EOPNOTSUPP || reason == ENOSYS) {  // There are no second names.
    std::error_code error;
    reason = fs::exists(fs::symlink_status(to, error)) ? EEXIST : 0;
    if (reason == 0 && ::rename(from.c_str(), to.c_str()) != 0) reason = errno;
  }
  if (reason == 0) return {};
  if (reason == EEXIST) return fail(ErrorCode::kIo, "{}: is there already", to.string());
  return fail(ErrorCode::kIo, "{}: {}", to.string(), std::generic_category().message(reason));
}

Result<fs::path> replace_in_two_steps(const fs::path& fresh,
                                      const fs::path& target,
                                      const fs::path& aside) {
  std::error_code error;
  fs::path old = aside;
  for (int count = 2; fs::exists(fs::symlink_status(old, error)); ++count) {
    old = aside;
    old += "-" + std::to_string(count);
  }
  fs::rename(target, old, error);
  if (error) return fail(ErrorCode::kIo, "{}: {}", target.string(), error.message());
  fs::rename(fresh, target, error);
  if (!error) return old;
  const std::string reason = error.message();
  fs::rename(old, target, error);
  return fail(ErrorCode::kIo, "{}: {}{}", target.string(), reason,
              error ? "; what was there is now called " + old.string() : "");
}

}  // namespace nadir::detail
