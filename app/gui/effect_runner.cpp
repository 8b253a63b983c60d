// SPDX-License-Identifier: Apache-2.0
#include "app/gui/effect_runner.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "core/base/staged_output.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

struct Reported {
  double fraction = 0.0;
  std::string activity;
};

/// A line of a command that was asked for its progress in words: "progress 0.43 drawing flight".
std::optional<Reported> reported_in(std::string_view line) {
  constexpr std::string_view kBegin = "progress ";
  if (line.rfind(kBegin, 0) != 0) return std::nullopt;
  line.remove_prefix(kBegin.size());
  Reported reported;
  const auto [end, error] =
      std::from_chars(line.data(), line.data() + line.size(), reported.fraction);
  if (error != std::errc()) return std::nullopt;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
  reported.activity = line;
  return reported;
}

/// What a command said of its failure, in one line, without its own name before it.
std::string complaint_of(const ChildProcess& process, int status) {
  for (auto line = process.lines().rbegin(); line != process.lines().rend(); ++line) {
    if (line->empty() || reported_in(*line)) continue;
    const std::size_t name_end =
        line->rfind("nadir", 0) == 0 ? line->find(": ") : std::string::npos;
    return name_end == std::string::npos ? *line : line->substr(name_end + 2);
  }
  return fmt::format("the command ended with status {} and said nothing", status);
}

/// What a command that has done its work said beside that: "nadir: DejaVu Sans is missing". Lines of libraries are none.
std::vector<std::string> warnings_of(const ChildProcess& process) {
  constexpr std::string_view kName = "nadir: ";
  constexpr std::string_view kLeftOut = "left out: ";
  std::vector<std::string> warnings;
  for (const std::string& line : process.lines()) {
    if (line.rfind(kName, 0) == 0) warnings.push_back(line.substr(kName.size()));
    if (line.rfind(kLeftOut, 0) == 0) warnings.push_back(line);
  }
  return warnings;
}

/// A file that only this process and the command read.
Result<fs::path> write_recipe(int job, const std::string& text) {
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  if (error) return fail(ErrorCode::kIo, "no folder for temporary files: {}", error.message());
  const fs::path path = folder / fmt::format("nadir-{}-{}.toml", ::getpid(), job);
  if (const auto written = write_text_file(path, text); !written) return forward_error(written);
  return path;
}

}  // namespace

EffectRunner::EffectRunner(fs::path program, std::function<void(const std::string&)> clipboard)
    : program_(std::move(program)), clipboard_(std::move(clipboard)) {}

EffectRunner::~EffectRunner() {
  for (Work& work : works_) work.process.ask_to_stop();  // all at once, then each is waited for
  std::error_code error;
  for (const Work& work : works_) fs::remove(work.recipe, error);
}

void EffectRunner::poll(Session& session) {
  for (const Effect& effect : session.take_effects()) begin(session, effect);
  for (const int job : session.take_cancelled_effects()) {
    for (Work& work : works_) {
      if (work.job == job) work.process.ask_to_stop();
    }
  }
  for (std::size_t i = 0; i < works_.size();) {
    if (!follow(session, works_[i])) {
      ++i;
      continue;
    }
    // ChildProcess can be made but not assigned, so the list is built anew without it.
    std::vector<Work> rest;
    for (std::size_t k = 0; k < works_.size(); ++k) {
      if (k != i) rest.push_back(std::move(works_[k]));
    }
    works_.swap(rest);
  }
}

void EffectRunner::begin(Session& session, const Effect& effect) {
  if (const auto* clipboard = std::get_if<SetClipboardEffect>(&effect)) {
    clipboard_(clipboard->text);
  } else if (std::holds_alternative<QuitEffect>(effect)) {
    wants_to_quit_ = true;
  } else if (const auto* figure = std::get_if<DrawFigureEffect>(&effect)) {
    auto recipe = write_recipe(figure->job, figure->recipe);
    if (!recipe) return session.finish_effect(figure->job, recipe.error().message, {});
    begin(session, figure->job, {"figure", recipe->string(), "--out", figure->file}, figure->file,
          *recipe);
  } else if (const auto* report = std::get_if<WriteReportEffect>(&effect)) {
    std::vector<std::string> arguments = {"report"};
    arguments.insert(arguments.end(), report->runs.begin(), report->runs.end());
    arguments.insert(arguments.end(), {"--out", report->folder});
    if (!report->map.empty()) arguments.insert(arguments.end(), {"--map", report->map});
    begin(session, report->job, arguments, report->folder + "/index.html");
  } else if (const auto* demo = std::get_if<MakeDemoEffect>(&effect)) {
    begin(session, demo->job, {"demo", "--out", demo->folder}, demo->folder + "/run.nadir");
  }
}

void EffectRunner::begin(Session& session,
                         int job,
                         const std::vector<std::string>& arguments,
                         std::string made,
                         fs::path recipe) {
  auto process = ChildProcess::start(program_, arguments, {{"NADIR_PROGRESS", "lines"}});
  if (!process) {
    std::error_code error;
    fs::remove(recipe, error);
    return session.finish_effect(job, process.error().message, {});
  }
  works_.push_back({job, std::move(*process), std::move(made), std::move(recipe)});
}

bool EffectRunner::follow(Session& session, Work& work) {
  const auto status = work.process.poll();
  const auto& lines = work.process.lines();
  for (; work.lines_read < lines.size(); ++work.lines_read) {
    const auto reported = reported_in(lines[work.lines_read]);
    if (reported) session.report_effect(work.job, reported->fraction, reported->activity);
  }
  if (!status) return false;
  std::error_code error;
  if (!work.recipe.empty()) fs::remove(work.recipe, error);
  if (*status == 0) {
    session.finish_effect(work.job, {}, work.made, warnings_of(work.process));
  } else {
    session.finish_effect(
        work.job,
        work.process.was_asked_to_stop() ? "stopped" : complaint_of(work.process, *status), {});
  }
  return true;
}

}  // namespace nadir
