// SPDX-License-Identifier: Apache-2.0
#include "core/session/bookmarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <system_error>
#include <tuple>
#include <utility>

#include "core/base/require.h"
#include "core/base/settings.h"
#include "core/base/staged_output.h"
#include "core/run/run_file.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

constexpr std::int64_t kFormatVersion = 1;

bool comes_before(const Bookmark& a, const Bookmark& b) {
  const auto key = [](const Bookmark& bookmark) {
    constexpr double kNone = -std::numeric_limits<double>::infinity();
    return std::tuple(bookmark.time_s, bookmark.until_s.value_or(kNone), bookmark.note);
  };
  return key(a) < key(b);
}

bool has_sound_times(const Bookmark& bookmark) {
  return std::isfinite(bookmark.time_s) &&
         (!bookmark.until_s ||
          (std::isfinite(*bookmark.until_s) && *bookmark.until_s > bookmark.time_s));
}

/// In order, each once.
Bookmarks sorted(Bookmarks bookmarks) {
  std::sort(bookmarks.begin(), bookmarks.end(), comes_before);
  bookmarks.erase(std::unique(bookmarks.begin(), bookmarks.end()), bookmarks.end());
  return bookmarks;
}

Result<Bookmark> bookmark_from(const Settings& table) {
  if (const auto known = table.refuse_unknown({"time_s", "until_s", "note"}); !known) {
    return forward_error(known);
  }
  const auto time_s = table.number("time_s");
  if (!time_s) return forward_error(time_s);
  auto note = table.text_or("note", "");
  if (!note) return forward_error(note);
  Bookmark bookmark{*time_s, std::move(*note), {}};
  if (table.has("until_s")) {
    const auto until_s = table.number("until_s");
    if (!until_s) return forward_error(until_s);
    bookmark.until_s = *until_s;
  }
  if (!has_sound_times(bookmark)) {
    return fail(ErrorCode::kMalformed, "{}: until_s is {}, not after time_s {}", table.name(),
                *bookmark.until_s, bookmark.time_s);
  }
  return bookmark;
}

Result<Bookmarks> bookmarks_from(const Settings& settings) {
  const auto version = settings.integer("version");
  if (!version) return forward_error(version);
  if (*version > kFormatVersion) {
    return fail(
        ErrorCode::kUnsupported,
        "{}: was written by a newer version of Nadir (bookmarks {}, this one reads up to {})",
        settings.name(), *version, kFormatVersion);
  }
  if (const auto known = settings.refuse_unknown({"version", "bookmark"}); !known) {
    return forward_error(known);
  }
  Bookmarks bookmarks;
  if (!settings.has("bookmark")) return bookmarks;
  const auto tables = settings.tables("bookmark");
  if (!tables) return forward_error(tables);
  for (const Settings& table : *tables) {
    auto bookmark = bookmark_from(table);
    if (!bookmark) return forward_error(bookmark);
    bookmarks.push_back(std::move(*bookmark));
  }
  return sorted(std::move(bookmarks));
}

std::string text_of(const Bookmarks& bookmarks) {
  std::string text = fmt::format(
      "# Bookmarks of a Nadir run; times are seconds after its first step.\nversion = {}\n",
      kFormatVersion);
  for (const Bookmark& bookmark : bookmarks) {
    text += fmt::format("\n[[bookmark]]\ntime_s = {}\n", bookmark.time_s);
    if (bookmark.until_s) text += fmt::format("until_s = {}\n", *bookmark.until_s);
    if (!bookmark.note.empty()) text += fmt::format("note = {}\n", toml_quoted(bookmark.note));
  }
  return text;
}

Result<void> remove_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) {
    return fail(ErrorCode::kIo, "{}: cannot be removed: {}", path.string(), error.message());
  }
  return {};
}

/// What is in `a` and not in `b`; both in order.
Bookmarks without(const Bookmarks& a, const Bookmarks& b) {
  Bookmarks rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest),
                      comes_before);
  return rest;
}

}  // namespace

Bookmarks with_bookmark(Bookmarks bookmarks, const Bookmark& bookmark) {
  NADIR_REQUIRE(has_sound_times(bookmark));
  bookmarks.push_back(bookmark);
  return sorted(std::move(bookmarks));
}

Bookmarks with_bookmark_changed(Bookmarks bookmarks, std::size_t index, const Bookmark& bookmark) {
  return with_bookmark(without_bookmark(std::move(bookmarks), index), bookmark);
}

Bookmarks without_bookmark(Bookmarks bookmarks, std::size_t index) {
  NADIR_REQUIRE(index < bookmarks.size());
  bookmarks.erase(bookmarks.begin() + static_cast<std::ptrdiff_t>(index));
  return bookmarks;
}

Bookmarks with_changes(const Bookmarks& bookmarks, const Bookmarks& from, const Bookmarks& to) {
  const Bookmarks before = sorted(from), after = sorted(to);
  Bookmarks changed = without(sorted(bookmarks), without(before, after));
  const Bookmarks added = without(after, before);
  changed.insert(changed.end(), added.begin(), added.end());
  return sorted(std::move(changed));
}

std::optional<std::size_t> next_bookmark(std::span<const Bookmark> bookmarks, double time_s) {
  for (std::size_t i = 0; i < bookmarks.size(); ++i) {
    if (bookmarks[i].time_s > time_s + kSameTimeS) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> previous_bookmark(std::span<const Bookmark> bookmarks, double time_s) {
  for (std::size_t i = bookmarks.size(); i-- > 0;) {
    if (bookmarks[i].time_s < time_s - kSameTimeS) return i;
  }
  return std::nullopt;
}

fs::path bookmarks_file(const fs::path& run) { return run.string() + ".bookmarks.toml"; }

Result<Bookmarks> read_bookmarks(const fs::path& run) {
  const auto settings = Settings::read(bookmarks_file(run));
  if (!settings) {
    if (settings.error().code == ErrorCode::kNotFound) return Bookmarks{};
    return forward_error(settings);
  }
  return bookmarks_from(*settings);
}

Result<Bookmarks> write_bookmarks(const fs::path& run,
                                  const Bookmarks& wanted,
                                  const Bookmarks& known) {
  const fs::path path = bookmarks_file(run);
  const Bookmarks before = sorted(known);
  const Bookmarks after = sorted(wanted);
  for (const Bookmark& bookmark : after) {
    if (has_sound_times(bookmark)) continue;
    return fail(ErrorCode::kInvalidOptions, "{}: a bookmark from {} s to {} s is no time span",
                path.string(), bookmark.time_s, bookmark.until_s.value_or(bookmark.time_s));
  }
  auto there = read_bookmarks(run);
  if (!there) return there;
  Bookmarks merged = with_changes(*there, before, after);
  if (merged == *there) return merged;
  if (merged.empty()) {
    const auto removed = remove_file(path);
    if (!removed) return forward_error(removed);
    return merged;
  }
  const auto written = write_text_file(path, text_of(merged));
  if (!written) return forward_error(written);
  return merged;
}

}  // namespace nadir
