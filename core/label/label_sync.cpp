// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_sync.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

#include "core/label/label_database.h"

namespace nadir {
namespace {

/// Gestures that follow each other faster are brought together.
constexpr std::chrono::milliseconds kPause(50);
/// Of the file of changes. After they were all carried over, the next commit begins the file anew and waits for the disk
/// once, so that this is not done after every gesture.
constexpr std::uintmax_t kMostChangeBytes = std::uintmax_t{8} << 20U;

}  // namespace

LabelSync::LabelSync(NamedFile document)
    : document_(std::move(document)), changes_(document_.path()) {
  changes_ += "-wal";
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

LabelSync::~LabelSync() = default;

void LabelSync::note_commit() {
  {
    const std::lock_guard lock(mutex_);
    ++noted_;
  }
  changed_.notify_all();
}

Result<void> LabelSync::flush() {
  std::unique_lock lock(mutex_);
  is_awaited_ = true;
  changed_.notify_all();
  const std::int64_t wanted = noted_;
  changed_.wait(lock, [&] { return brought_ >= wanted; });
  return outcome_;
}

void LabelSync::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [&] { return noted_ > brought_; })) {
    changed_.wait_for(lock, stop, kPause, [&] { return is_awaited_; });
    if (stop.stop_requested()) return;
    const std::int64_t until = noted_;
    lock.unlock();
    Result<void> outcome = bring();
    lock.lock();
    outcome_ = std::move(outcome);
    brought_ = until;
    is_awaited_ = is_awaited_ && noted_ > brought_;
    changed_.notify_all();
  }
}

Result<void> LabelSync::bring() const {
  const auto check_name = [&]() -> Result<void> {
    if (document_.has_its_name()) return {};
    return fail(ErrorCode::kIo, "{}: is not the file any more that was opened",
                document_.path().string());
  };
  if (auto named = check_name(); !named) return named;
  // SQLite's locks lie on the document and on NAME-shm; closing this file takes none of them away.
  const int descriptor = ::open(changes_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    if (errno == ENOENT) return {};  // Somebody has carried all over already.
    return fail(ErrorCode::kIo, "{}: {}", changes_.string(),
                std::generic_category().message(errno));
  }
  const int failure = ::fdatasync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (failure != 0 && failure != EINVAL && failure != ENOSYS) {
    return fail(ErrorCode::kIo, "{}: {}", changes_.string(),
                std::generic_category().message(failure));
  }
  std::error_code ignored;
  const std::uintmax_t bytes = std::filesystem::file_size(changes_, ignored);
  if (ignored || bytes < kMostChangeBytes) return {};
  auto database =
      open_label_database(document_.path(), document_.path().string(), SqliteAccess::kWrite);
  if (!database) return forward_error(database);
  sqlite3_db_config(database->handle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  if (auto named = check_name(); !named) return named;
  // Without waiting for readers or writers: what they hold up is carried over the next time.
  return database->execute("PRAGMA wal_checkpoint(PASSIVE)");
}

}  // namespace nadir
