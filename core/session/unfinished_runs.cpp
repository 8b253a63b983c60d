// SPDX-License-Identifier: Apache-2.0
#include "core/session/unfinished_runs.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "core/base/bystanders.h"
#include "core/base/settings.h"
#include "core/base/staged_output.h"
#include "core/run/run_file.h"
#include "core/session/settings_values.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

constexpr const char* kListsBeside = "session.toml";
constexpr std::string_view kListInfix = ".writing-";

std::vector<fs::path> lists_in(const fs::path& folder) {
  const std::string begin = kListsBeside + std::string(kListInfix);
  std::vector<fs::path> lists;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    const bool is_half_written = name.find(".partial-") != std::string::npos;
    if (name.rfind(begin, 0) == 0 && !is_half_written) lists.push_back(at->path());
  }
  std::sort(lists.begin(), lists.end());
  return lists;
}

/// Nothing where it cannot be read.
std::optional<std::vector<std::string>> runs_on(const fs::path& list) {
  constexpr std::uintmax_t kMostListBytes = 1U << 20U;
  const auto text = read_text_file(list, kMostListBytes);
  if (!text) return std::nullopt;
  const auto settings = Settings::parse(*text, list.string());
  if (!settings || !detail::check_version(*settings)) return std::nullopt;
  const auto runs = settings->texts("writing");
  if (!runs) return std::nullopt;
  return *runs;
}

Result<void> write_list(const fs::path& list, const std::vector<std::string>& runs) {
  if (runs.empty()) {
    std::error_code error;
    fs::remove(list, error);
    if (error) return fail(ErrorCode::kIo, "{}: {}", list.string(), error.message());
    return {};
  }
  return write_text_file(list, "# Runs that Nadir is writing, or was when it was ended.\n" +
                                   detail::toml_line("version", detail::kTextVersion) +
                                   detail::toml_line("writing", runs));
}

enum class Left { kNothing, kUnfinished, kBusy, kWhole };

/// What there is of a run that was being written.
Left what_is_left(const fs::path& run) {
  std::error_code error;
  if (!fs::exists(run, error)) return Left::kNothing;
  if (!RunWriter::check_output(run)) return Left::kBusy;
  const auto reader = RunReader::open(run);
  if (reader && reader->is_complete()) return Left::kWhole;
  return reader && reader->step_count() > 0 ? Left::kUnfinished : Left::kNothing;
}

}  // namespace

Result<void> WritingList::keep(const std::vector<std::string>& runs) {
  if (folder_.empty() || runs == kept_) return {};
  if (file_.empty()) {
    std::error_code error;
    fs::create_directories(folder_, error);
    // One of this name may be all that tells of runs which a program of the same process id has left.
    int number = 1;
    do {
      file_ = bystander_of(folder_ / kListsBeside, kListInfix, number++);
    } while (fs::exists(file_, error));
  }
  auto written = write_list(file_, runs);
  if (!written) return written;
  kept_ = runs;
  if (runs.empty()) file_.clear();
  return {};
}

ListedRuns listed_runs(const fs::path& folder) {
  ListedRuns listed;
  if (folder.empty()) return listed;
  const auto abandoned = abandoned_bystanders(folder / kListsBeside, kListInfix);
  for (const fs::path& list : lists_in(folder)) {
    const auto runs = runs_on(list);
    if (!runs) continue;
    bool is_done_with = std::find(abandoned.begin(), abandoned.end(), list) != abandoned.end();
    for (const std::string& run : *runs) {
      const Left left = what_is_left(run);
      if (left != Left::kWhole) listed.incomplete.push_back(run);
      if (left == Left::kUnfinished || left == Left::kBusy) is_done_with = false;
      const bool is_known = std::find(listed.unfinished.begin(), listed.unfinished.end(), run) !=
                            listed.unfinished.end();
      if (left == Left::kUnfinished && !is_known) listed.unfinished.push_back(run);
    }
    if (is_done_with) static_cast<void>(write_list(list, {}));
  }
  return listed;
}

void take_off_lists(const fs::path& folder, const std::string& run) {
  if (folder.empty()) return;
  for (const fs::path& list : lists_in(folder)) {
    auto runs = runs_on(list);
    if (!runs || std::erase(*runs, run) == 0) continue;
    static_cast<void>(write_list(list, *runs));  // it is offered once more, which is no harm
  }
}

}  // namespace nadir
