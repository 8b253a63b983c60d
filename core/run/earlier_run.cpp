// SPDX-License-Identifier: Apache-2.0
#include "core/run/earlier_run.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string_view>
#include <system_error>

#include "core/base/bystanders.h"
#include "core/base/sqlite_database.h"
#include "core/run/run_database.h"
#include "core/run/run_file.h"
#include "core/run/run_lock.h"
#include "core/run/run_schema.h"

namespace nadir::detail {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kEarlier = ".earlier-";
constexpr int kMostNumbers = 1000;

/// Whether anything has this name, be it a link that leads nowhere.
bool is_taken(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

Result<void> check_folder(const fs::path& path) {
  const std::string name = path.string();
  if (path.empty()) return fail(ErrorCode::kInvalidOptions, "run file: its name is empty");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return fail(ErrorCode::kIo, "{}: folder {} does not exist", name, folder.string());
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    return fail(ErrorCode::kIo, "{}: folder {} is not writable", name, folder.string());
  }
  if (fs::is_directory(path, error))
    return fail(ErrorCode::kIo, "{}: is a folder, not a file", name);
  return {};
}

/// Read without SQLite, so that a damaged run can be replaced too. The numbers are those of SQLite's
/// file header: the version of the format at byte 60, the mark of the program at byte 68.
Result<void> check_is_run(const fs::path& path) {
  const auto kept = [&path](ErrorCode code, const std::string& reason) {
    return fail(code, "{}: will not be overwritten: {}", path.string(), reason);
  };
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return kept(ErrorCode::kIo, "it is no run file");
  if (fs::file_size(path, error) == 0 && !error) return {};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return kept(ErrorCode::kIo, "it cannot be read");
  std::array<char, 72> head{};
  stream.read(head.data(), head.size());
  const auto number_at = [&head](std::size_t byte) {
    std::uint32_t number = 0;
    for (std::size_t i = byte; i < byte + 4; ++i) {
      number = number << 8U | static_cast<std::uint8_t>(head.at(i));
    }
    return number;
  };
  if (!stream || std::string_view(head.data(), 15) != "SQLite format 3" ||
      number_at(68) != static_cast<std::uint32_t>(kRunApplicationId)) {
    return kept(ErrorCode::kIo, "it is no run file");
  }
  if (number_at(60) > static_cast<std::uint32_t>(kRunFormatVersion)) {
    return kept(ErrorCode::kUnsupported,
                fmt::format("it was written by a newer version of Nadir (run format {}, this one "
                            "writes {})",
                            number_at(60), kRunFormatVersion));
  }
  return {};
}

/// Takes back the half step that a killed writer left, where that can be done.
void recover(const fs::path& path) {
  if (!is_taken(journal_of(path))) return;
  const auto database = open_run_database(path, path.string(), SqliteAccess::kWrite);
  if (database) static_cast<void>(database->whole("SELECT count(*) FROM sqlite_schema"));
}

/// An empty file under a name that nobody has had.
Result<fs::path> free_name(const fs::path& path) {
  for (int number = 1; number <= kMostNumbers; ++number) {
    fs::path name = bystander_of(path, kEarlier, number);
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (descriptor >= 0) {
      ::close(descriptor);
      return name;
    }
    if (errno != EEXIST) {
      return fail(ErrorCode::kIo, "{}: {}", name.string(), std::generic_category().message(errno));
    }
  }
  return fail(ErrorCode::kIo, "{}: too many runs of this name were put aside, the first as {}",
              path.string(), bystander_of(path, kEarlier).string());
}

/// @returns whether it was done. A name that is taken stays with who has it.
bool rename_if_free(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if ((errno != EINVAL && errno != ENOSYS) || is_taken(to)) return false;
  std::error_code error;  // A file system that cannot do both in one step.
  fs::rename(from, to, error);
  return !error;
}

}  // namespace

void remove_run(const fs::path& run) {
  std::error_code ignored;
  fs::remove(journal_of(run), ignored);
  fs::remove(run, ignored);
}

Result<void> check_run_output(const fs::path& path) {
  auto checked = check_folder(path);
  if (!checked || !is_taken(path)) return checked;
  const auto lock = RunLock::hold(path);
  if (!lock) return forward_error(lock);
  return check_is_run(path);
}

Result<EarlierRun> EarlierRun::put_aside(const fs::path& path) {
  if (const auto checked = check_folder(path); !checked) return forward_error(checked);
  if (!is_taken(path)) return EarlierRun(path, {});
  const auto lock = RunLock::hold(path);
  if (!lock) return forward_error(lock);
  if (const auto checked = check_is_run(path); !checked) return forward_error(checked);
  recover(path);
  auto kept = free_name(path);
  if (!kept) return forward_error(kept);
  std::error_code error;
  fs::remove(journal_of(*kept), error);
  if (is_taken(journal_of(path))) fs::rename(journal_of(path), journal_of(*kept), error);
  if (!error) fs::rename(path, *kept, error);
  if (error) {
    std::error_code ignored;
    fs::rename(journal_of(*kept), journal_of(path), ignored);
    fs::remove(*kept, ignored);
    return fail(ErrorCode::kIo, "{}: {}", path.string(), error.message());
  }
  return EarlierRun(path, std::move(*kept));
}

bool EarlierRun::is_worth_more_than(int steps) const {
  if (!is_there()) return false;
  const auto run = RunReader::open(kept_);
  return run && (run->is_complete() || run->step_count() > steps);
}

void EarlierRun::remove() {
  if (is_there()) remove_run(std::exchange(kept_, {}));
}

void EarlierRun::remove_with_abandoned() {
  if (!is_there()) return;
  remove();
  for (const fs::path& run : abandoned_bystanders(name_, kEarlier)) remove_run(run);
}

void EarlierRun::bring_back() {
  if (!is_there() || !rename_if_free(kept_, name_)) return;
  std::error_code ignored;
  if (is_taken(journal_of(kept_))) fs::rename(journal_of(kept_), journal_of(name_), ignored);
  kept_.clear();
}

}  // namespace nadir::detail
