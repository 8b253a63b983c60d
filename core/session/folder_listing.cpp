// SPDX-License-Identifier: Apache-2.0
#include "core/session/folder_listing.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <system_error>

namespace nadir {
namespace fs = std::filesystem;

namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// The digits at the beginning of a text, without leading zeros.
std::string_view number_at(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && is_digit(text[end])) ++end;
  text = text.substr(0, end);
  while (text.size() > 1 && text.front() == '0') text.remove_prefix(1);
  return text;
}

std::size_t digits_at(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end;
}

/// < 0: a first. "loop-2" is before "loop-10".
int compare_names(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view left = number_at(a), right = number_at(b);
      if (left.size() != right.size()) return left.size() < right.size() ? -1 : 1;
      if (const int order = left.compare(right); order != 0) return order;
      a.remove_prefix(digits_at(a));
      b.remove_prefix(digits_at(b));
      continue;
    }
    const int left = std::tolower(static_cast<unsigned char>(a.front()));
    const int right = std::tolower(static_cast<unsigned char>(b.front()));
    if (left != right) return left < right ? -1 : 1;
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() && b.empty()) return 0;
  return a.empty() ? -1 : 1;
}

/// Nothing where it is gone, or a link that leads nowhere.
std::optional<FolderEntry> entry_of(const fs::path& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return std::nullopt;
  FolderEntry entry;
  entry.name = path.filename().string();
  entry.is_folder = S_ISDIR(found.st_mode);
  if (!entry.is_folder && !S_ISREG(found.st_mode)) return std::nullopt;
  entry.bytes = entry.is_folder ? 0 : static_cast<std::uintmax_t>(found.st_size);
  constexpr double kNanosecond = 1e-9;
  entry.changed_s = static_cast<double>(found.st_mtim.tv_sec) +
                    kNanosecond * static_cast<double>(found.st_mtim.tv_nsec);
  entry.kind = kind_at_a_glance(path, entry.is_folder);
  return entry;
}

}  // namespace

const FolderEntry* FolderListing::find(std::string_view name) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [name](const FolderEntry& entry) { return entry.name == name; });
  return found == entries.end() ? nullptr : &*found;
}

Result<FolderListing> list_folder(const fs::path& folder, const WorkContext& context) {
  const auto complain = [&folder](const std::error_code& error) {
    const bool is_gone = error == std::errc::no_such_file_or_directory;
    return fail(is_gone ? ErrorCode::kNotFound : ErrorCode::kIo, "{}: {}", folder.string(),
                is_gone ? "does not exist" : error.message());
  };
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    return fail(ErrorCode::kIo, "{}: is not a folder", folder.string());
  }
  fs::directory_iterator at(folder, error);
  if (error) return complain(error);
  FolderListing listing;
  listing.folder = folder;
  while (at != fs::directory_iterator()) {
    if (context.is_stopped()) {
      return fail(ErrorCode::kCancelled, "{}: listing was stopped", folder.string());
    }
    if (listing.entries.size() == FolderListing::kMostEntries) {
      listing.is_cut_short = true;
      break;
    }
    if (auto entry = entry_of(at->path())) listing.entries.push_back(std::move(*entry));
    at.increment(error);
    if (error) return complain(error);
  }
  std::sort(listing.entries.begin(), listing.entries.end(),
            [](const FolderEntry& a, const FolderEntry& b) {
              return stands_before(a, b, FileOrder::kName);
            });
  return listing;
}

bool stands_before(const FolderEntry& a, const FolderEntry& b, FileOrder order) {
  if (a.is_folder != b.is_folder) return a.is_folder;
  if (order == FileOrder::kKind && a.kind != b.kind) return a.kind < b.kind;
  if (order == FileOrder::kChanged && a.changed_s != b.changed_s) return a.changed_s > b.changed_s;
  const int names = compare_names(a.name, b.name);
  return names != 0 ? names < 0 : a.name < b.name;
}

}  // namespace nadir
