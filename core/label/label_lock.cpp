// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace nadir {
namespace {

constexpr int kAttempts = 20;
constexpr std::size_t kMostHolderBytes = 300;

/// Whether the open file is the one that has this name now.
bool has_name(int descriptor, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

/// A lock of the open file, not of the process, so that two writers of one process are two.
/// @returns false where somebody else has it.
bool lock(int descriptor) {
  struct flock all {};
  all.l_type = F_WRLCK;
  all.l_whence = SEEK_SET;
  return ::fcntl(descriptor, F_OFD_SETLK, &all) == 0 || (errno != EAGAIN && errno != EACCES);
}

std::string first_line(int descriptor) {
  std::array<char, kMostHolderBytes> bytes{};
  const auto count = ::pread(descriptor, bytes.data(), bytes.size(), 0);
  const std::string text(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
  return text.substr(0, text.find('\n'));
}

void write_line(int descriptor, const std::string& line) {
  const std::string text = line.substr(0, kMostHolderBytes - 1) + "\n";
  // Where it cannot be written, others are told that somebody has the document, but not who.
  if (::ftruncate(descriptor, 0) == 0) {
    [[maybe_unused]] const auto written = ::pwrite(descriptor, text.data(), text.size(), 0);
  }
}

}  // namespace

Result<LabelLock::Outcome> LabelLock::take(const std::filesystem::path& document,
                                           const std::string& holder) {
  std::filesystem::path path = document;
  path += ".lock";
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor < 0) {
      return fail(ErrorCode::kIo, "{}: {}", path.string(), std::generic_category().message(errno));
    }
    const bool is_locked = lock(descriptor);
    if (!is_locked) {
      Outcome outcome{std::nullopt, first_line(descriptor)};
      ::close(descriptor);
      return outcome;
    }
    // Between opening and locking, whoever had it may have removed it.
    if (has_name(descriptor, path)) {
      write_line(descriptor, holder);
      return Outcome{LabelLock(descriptor, std::move(path)), {}};
    }
    ::close(descriptor);
  }
  return fail(ErrorCode::kIo, "{}: others come and go", path.string());
}

LabelLock::LabelLock(LabelLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::move(other.path_)) {}

LabelLock& LabelLock::operator=(LabelLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(path_, other.path_);
  return *this;
}

LabelLock::~LabelLock() {
  if (descriptor_ < 0) return;
  if (has_name(descriptor_, path_)) ::unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace nadir
