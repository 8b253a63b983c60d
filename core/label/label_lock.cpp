// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_lock.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace nadir {
namespace {

constexpr int kAttempts = 20;
constexpr std::size_t kMostHolderBytes = 300;

std::filesystem::path lock_of(const std::filesystem::path& document) {
  std::filesystem::path path = document;
  path += ".lock";
  return path;
}

struct flock whole_file() {
  struct flock all {};
  all.l_type = F_WRLCK;
  all.l_whence = SEEK_SET;
  return all;
}

/// A lock of the open file, not of the process, so that two writers of one process are two.
/// @returns false where somebody else has it.
bool lock(int descriptor) {
  struct flock all = whole_file();
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
  const std::filesystem::path path = lock_of(document);
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor < 0 && errno == EACCES && ::access(path.c_str(), F_OK) == 0) {
      // Another user's: that of a program at work, or one that a killed program has left.
      if (auto who = LabelLock::holder(document)) return Outcome{std::nullopt, std::move(*who)};
      if (::unlink(path.c_str()) == 0) continue;
      return fail(ErrorCode::kIo, "{}: belongs to somebody else", path.string());
    }
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
    NamedFile file(path, FileIdentity::of(descriptor));
    if (file.has_its_name()) {
      write_line(descriptor, holder);
      return Outcome{LabelLock(descriptor, std::move(file)), {}};
    }
    ::close(descriptor);
  }
  return fail(ErrorCode::kIo, "{}: others come and go", path.string());
}

std::optional<std::string> LabelLock::holder(const std::filesystem::path& document) {
  const int descriptor = ::open(lock_of(document).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  struct flock all = whole_file();
  std::optional<std::string> holder;
  if (::fcntl(descriptor, F_OFD_GETLK, &all) == 0 && all.l_type != F_UNLCK) {
    holder = first_line(descriptor);
  }
  ::close(descriptor);
  return holder;
}

LabelLock::LabelLock(LabelLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), file_(std::move(other.file_)) {}

LabelLock& LabelLock::operator=(LabelLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(file_, other.file_);
  return *this;
}

LabelLock::~LabelLock() {
  if (descriptor_ < 0) return;
  if (is_held()) ::unlink(file_.path().c_str());
  ::close(descriptor_);
}

}  // namespace nadir
