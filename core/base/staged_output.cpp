// SPDX-License-Identifier: Apache-2.0
#include "core/base/staged_output.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/base/bystanders.h"
#include "core/base/durability.h"
#include "core/base/require.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

fs::path without_trailing_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

constexpr std::string_view kPartial = ".partial-";

/// Takes away what killed programs have left of the same output, and of an earlier process with
/// this one's number.
void clear_partials(const fs::path& target) {
  std::error_code ignored;
  for (const fs::path& partial : abandoned_bystanders(target, kPartial)) {
    fs::remove_all(partial, ignored);
  }
  fs::remove_all(bystander_of(target, kPartial), ignored);
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

}  // namespace

Result<StagedOutput> StagedOutput::file(const fs::path& target) {
  if (target.empty()) return fail(ErrorCode::kInvalidOptions, "output file: its name is empty");
  std::error_code error;
  if (fs::is_directory(target, error)) {
    return fail(ErrorCode::kIo, "{}: is a folder, not a file", target.string());
  }
  if (const auto parent = check_parent(target); !parent) return forward_error(parent);
  clear_partials(target);
  StagedOutput output(target, std::nullopt);
  output.staged_ = bystander_of(target, kPartial);
  return output;
}

Result<StagedOutput> StagedOutput::folder(const fs::path& given,
                                          std::string_view marker,
                                          std::span<const std::string_view> own_entries,
                                          FolderCheck check) {
  if (given.empty()) return fail(ErrorCode::kInvalidOptions, "output folder: its name is empty");
  std::error_code error;
  const fs::path target = without_trailing_slash(fs::absolute(given, error).lexically_normal());
  StagedOutput output(target, FolderRule{given.string(),
                                         std::string(marker),
                                         {own_entries.begin(), own_entries.end()},
                                         std::move(check)});
  if (const auto free = output.check_replaceable(); !free) return forward_error(free);
  if (const auto parent = check_parent(target); !parent) return forward_error(parent);
  clear_partials(target);
  const fs::path staged = bystander_of(target, kPartial);
  if (!fs::create_directory(staged, error)) {
    return fail(ErrorCode::kIo, "{}: {}", staged.string(), error.message());
  }
  output.staged_ = staged;
  return output;
}

StagedOutput::StagedOutput(StagedOutput&& other) noexcept
    : target_(std::move(other.target_)),
      rule_(std::move(other.rule_)),
      staged_(std::exchange(other.staged_, {})) {}

StagedOutput::~StagedOutput() {
  std::error_code error;
  if (!staged_.empty()) fs::remove_all(staged_, error);
}

/// Whether the folder may take its name without losing anything that is not of the same kind.
Result<void> StagedOutput::check_replaceable() const {
  const auto& [name, marker, own_entries, check] = *rule_;
  std::error_code error;
  const fs::file_status status = fs::status(target_, error);
  if (!fs::exists(status)) return {};
  if (!fs::is_directory(status)) {
    return fail(ErrorCode::kIo, "{}: exists and is not a folder", name);
  }
  if (fs::equivalent(target_, fs::current_path(error), error)) {
    return fail(ErrorCode::kIo, "{}: is the folder that you stand in; name a new one", name);
  }
  bool has_marker = false;
  bool is_empty = true;
  fs::directory_iterator entries(target_, error);
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
  if (is_empty) return {};
  if (!has_marker) {
    return fail(ErrorCode::kIo, "{}: exists and holds no {}, so it is left alone", name, marker);
  }
  return check ? check(target_) : Result<void>();
}

/// Whether it is there, on the disk, and may take its name.
Result<void> StagedOutput::check_whole() const {
  std::error_code error;
  if (!fs::exists(staged_, error)) {
    return fail(ErrorCode::kIo, "{}: is gone before it was complete", staged_.string());
  }
  // Before the name, what it stands for: a power cut between the two must not find an empty file.
  if (const auto written = detail::wait_for_disk(staged_); !written) return forward_error(written);
  // Others may have worked there since the output was begun.
  if (rule_) return check_replaceable();
  if (fs::is_directory(target_, error)) {
    return fail(ErrorCode::kIo, "{}: is a folder, not a file", target_.string());
  }
  return {};
}

Result<void> StagedOutput::commit() {
  if (const auto whole = check_whole(); !whole) return forward_error(whole);
  std::error_code error;
  if (rule_ && fs::is_directory(target_, error)) return replace_folder();
  fs::rename(staged_, target_, error);
  if (error) return fail(ErrorCode::kIo, "{}: {}", target_.string(), error.message());
  staged_.clear();
  return detail::wait_for_name(target_);
}

Result<void> StagedOutput::commit_as_new() {
  NADIR_REQUIRE(!rule_);
  if (const auto written = detail::wait_for_disk(staged_); !written) return forward_error(written);
  if (auto named = detail::rename_without_replacing(staged_, target_); !named) return named;
  staged_.clear();
  return detail::wait_for_name(target_);
}

/// Of a file; what was there before keeps the staged name. Whether there was something.
Result<bool> StagedOutput::take_name() {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(target_, error))) {
    fs::rename(staged_, target_, error);
    if (error) return fail(ErrorCode::kIo, "{}: {}", target_.string(), error.message());
    return false;
  }
  if (!detail::exchange_names(staged_, target_)) {
    auto old = detail::replace_in_two_steps(staged_, target_, bystander_of(target_, ".replaced-"));
    if (!old) return forward_error(old);
    staged_ = *std::move(old);
  }
  return true;
}

void StagedOutput::give_name_back(bool has_replaced) {
  std::error_code ignored;
  if (has_replaced) {
    fs::rename(staged_, target_, ignored);
  } else {
    fs::remove(target_, ignored);
  }
}

Result<void> StagedOutput::commit_all(std::span<StagedOutput> files) {
  for (const StagedOutput& file : files) {
    NADIR_REQUIRE(!file.rule_);
    if (const auto whole = file.check_whole(); !whole) return forward_error(whole);
  }
  std::vector<bool> has_replaced;
  for (StagedOutput& file : files) {
    const auto named = file.take_name();
    if (!named) {
      for (std::size_t i = has_replaced.size(); i-- > 0;) files[i].give_name_back(has_replaced[i]);
      return forward_error(named);
    }
    has_replaced.push_back(*named);
  }
  for (StagedOutput& file : files) {
    std::error_code ignored;
    fs::remove(std::exchange(file.staged_, {}), ignored);
    if (auto named = detail::wait_for_name(file.target_); !named) return named;
  }
  return {};
}

/// A folder cannot be renamed over a filled one. The two change names, and the old one, which then
/// has the staged name, goes last.
Result<void> StagedOutput::replace_folder() {
  std::error_code error;
  if (!detail::exchange_names(staged_, target_)) {
    // Nobody ever takes the old one away from beside the new one but the line that ends this
    // function, so that a crash loses neither.
    auto old = detail::replace_in_two_steps(staged_, target_, bystander_of(target_, ".replaced-"));
    if (!old) return forward_error(old);
    staged_ = *std::move(old);
  }
  auto named = detail::wait_for_name(target_);
  fs::remove_all(std::exchange(staged_, {}), error);
  return named;
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
