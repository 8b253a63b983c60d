// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "widgets/panels/panel_text.h"
#include "widgets/panels/time_axis.h"

namespace nadir {
namespace {

bool parts_words(char sign) {
  return sign == '-' || sign == '_' || sign == ' ' || sign == ',' || sign == '/';
}

}  // namespace

std::string fitted_name(const std::string& name,
                        double room,
                        const std::function<double(const std::string&)>& width_of) {
  if (width_of(name) <= room) return name;
  constexpr std::size_t kLeastCharacters = 3;
  std::size_t least = kLeastCharacters;
  std::size_t most = std::max(kLeastCharacters, name.size());
  while (least < most) {  // the most characters that fit
    const std::size_t middle = (least + most + 1) / 2;
    if (width_of(shortened(name, middle)) <= room) {
      least = middle;
    } else {
      most = middle - 1;
    }
  }
  return shortened(name, least);
}

std::vector<std::string> told_apart(std::span<const std::string> names) {
  std::vector<std::string> told(names.begin(), names.end());
  if (names.size() < 2) return told;
  std::size_t begin = names[0].size();
  std::size_t end = names[0].size();
  std::size_t shortest = names[0].size();
  for (const std::string& name : names) {
    const auto ahead = std::mismatch(name.begin(), name.end(), names[0].begin(), names[0].end());
    const auto behind =
        std::mismatch(name.rbegin(), name.rend(), names[0].rbegin(), names[0].rend());
    begin = std::min(begin, static_cast<std::size_t>(ahead.first - name.begin()));
    end = std::min(end, static_cast<std::size_t>(behind.first - name.rbegin()));
    shortest = std::min(shortest, name.size());
  }
  // Words stay whole: "run-10" and "run-12" differ in a number, not in a digit.
  while (begin > 0 && !parts_words(names[0][begin - 1])) --begin;
  while (end > 0 && !parts_words(names[0][names[0].size() - end])) --end;
  if (begin + end >= shortest) end = 0;
  if (begin >= shortest) begin = 0;
  constexpr std::size_t kWorthIt = 2;  // one sign is no longer than what would stand for it
  if (begin < kWorthIt) begin = 0;
  if (end < kWorthIt) end = 0;
  for (std::string& name : told) {
    name = name.substr(begin, name.size() - begin - end);
    if (begin > 0) name.insert(0, "…");
    if (end > 0) name += "…";
  }
  return told;
}

std::size_t active_colour(const ViewState& view) {
  const auto number = static_cast<std::size_t>(std::max(0, view.active_run));
  if (number == 0 || number > view.runs.size()) return 0;
  return static_cast<std::size_t>(std::max(0, view.runs[number - 1].colour));
}

bool is_incomplete(const RunDocument& run, bool is_live) {
  return !is_live && !run.is_complete && !run.steps.empty();
}

std::string incomplete_words(const RunDocument& run, double flight_end_s) {
  const std::string of = flight_end_s > run.duration_s() ? " of " + clock_text(flight_end_s) : "";
  return fmt::format("stopped at {}{}, after {} {}", clock_text(run.duration_s()), of,
                     run.steps.size(), run.steps.size() == 1 ? "step" : "steps");
}

std::string span_words(const RunComparison& comparison,
                       std::span<const std::string> names,
                       const std::set<std::string>& live) {
  const ComparedSpan& span = comparison.span;
  const std::string each = "each number is over all of its own run, and none is marked as the best";
  if (!comparison.is_same_flight) return "Runs of different flights: " + each;
  if (!span.is_shared) return "These runs share no time of the flight: " + each;
  if (names.empty()) return {};
  const std::string when = fmt::format("{} to {}", clock_text(span.from_s), clock_text(span.to_s));
  if (names.size() == 1) {
    return (live.contains(names[0]) ? "Over the run so far, " : "Over the whole run, ") + when;
  }
  if (!span.begins_last && !span.ends_first) return "Over all of these runs, " + when;
  std::string why;
  if (span.begins_last) why = names[*span.begins_last] + " begins there";
  if (span.ends_first) {
    const std::string& ends_first = names[*span.ends_first];
    why += (why.empty() ? "" : ", ") + ends_first +
           (live.contains(ends_first) ? " has come that far" : " ends there");
  }
  return fmt::format("Only over {}, which all of these runs cover: {}", when, why);
}

std::string copied_words(RunDocuments runs, std::span<const std::string> names) {
  std::string words;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunHeader& header = runs[i]->header;
    if (!header.started_at_s || header.parent_run.empty()) continue;
    const std::filesystem::path folder = runs[i]->path.parent_path(),
                                parent_run = header.parent_run;
    const auto named = (folder / parent_run).lexically_normal();
    const auto beside = folder / parent_run.filename();  // where both were moved
    const auto parent = std::find_if(runs.begin(), runs.end(), [&](const auto& other) {
      return other != runs[i] && (other->path == named || other->path == beside);
    });
    const double until_s = *header.started_at_s - runs.front()->start_clock_s;
    if (parent == runs.end() || !(until_s > 0.0)) continue;
    words += fmt::format("{}p to {} {} has its steps from {}", words.empty() ? "U" : "; u",
                         clock_text(until_s), names[i],
                         names[static_cast<std::size_t>(parent - runs.begin())]);
  }
  return words;
}

}  // namespace nadir
