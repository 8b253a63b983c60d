// SPDX-License-Identifier: Apache-2.0
#include "core/session/session.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <tuple>
#include <utility>

#include "core/base/log.h"
#include "core/session/change_words.h"
#include "core/session/session_core.h"

namespace nadir {
namespace {

constexpr std::size_t kMostLogLines = 10'000;

/// Whether a user has asked for a moment to look at, rather than for another time.
bool goes_to_moment(const Action& action) {
  if (const auto* const go = std::get_if<actions::GoTo>(&action)) {
    return go->moment != Moment::kStart && go->moment != Moment::kEnd;
  }
  return std::holds_alternative<actions::GoToMoment>(action) ||
         std::holds_alternative<actions::GoToDivergence>(action);
}

/// Whether a user goes to another time by hand.
bool moves_time(const Action& action) {
  return std::holds_alternative<actions::Seek>(action) ||
         std::holds_alternative<actions::StepBy>(action) ||
         std::holds_alternative<actions::GoTo>(action);
}

}  // namespace

Session::Session(SessionPlaces places)
    : implementation_(std::make_unique<Implementation>(std::move(places))) {
  implementation_->begin_keeping();
}

Session::~Session() = default;

Session::Implementation::~Implementation() {
  for (RerunWork& work : reruns) work.job.request_stop();
  for (SmallWork& work : small_works) work.job.request_stop();
  for (RunWork& work : works) {
    if (work.reading) work.reading->request_stop();
  }
  if (map_reading) map_reading->request_stop();
  std::vector<std::string> begun;
  for (const RerunWork& work : reruns) begun.push_back(work.run.string());
  reruns.clear();  // waits until what they have recorded is in the files
  std::error_code error;
  for (const std::string& run : begun) {
    if (!std::filesystem::exists(run, error)) take_run_out(kept.view, run);
  }
  list_what_is_written();
  save_now();
  if (!saving_fault.empty()) {  // there is no window any more to say it in
    write_log(LogLevel::kError,
              (places.keeps_session ? "what was open is not kept for the next start: "
                                    : "preferences are not kept: ") +
                  saving_fault);
  }
}

Result<void> Session::Implementation::apply(const Action& action) {
  Standing before = standing();
  foreign_bookmarks.clear();
  const bool keeps_vehicle = moves_time(action) && is_vehicle_in_view();
  const bool has_own_sight = labels_elsewhere();
  if (has_own_sight) set_sight(label.elsewhere);
  std::string words = words_for_log(action);
  auto done = std::visit([this](const auto& one) { return perform(one); }, action);
  if (!done) {
    put_back(std::move(before));
    add_log(fmt::format("# {}: {}", words, done.error().message), {});
    add_notice(Notice::Kind::kError, done.error().message, words);
    return done;
  }
  if (has_own_sight) {
    if (labels_elsewhere()) label.elsewhere = sight_of(kept.view.map);
    set_sight(sight_of(before.kept.view.map));
  }
  const bool is_history = std::holds_alternative<actions::Undo>(action) ||
                          std::holds_alternative<actions::Redo>(action);
  for (const ForeignBookmarks& foreign : foreign_bookmarks) {
    Bookmarks& bookmarks = before.kept.bookmarks[foreign.run];
    bookmarks = with_changes(bookmarks, foreign.expected, foreign.found);
    // What was done now is no step of the history yet; undo and redo have been to it themselves.
    take_foreign(foreign, is_history ? kept : before.kept);
  }
  const std::string key = merge_key(action);
  // Escape closes what lies over the window, and the shortcut does so again.
  const bool closes_nothing = std::holds_alternative<actions::ShowOverlay>(action) &&
                              before.overlay == Overlay::kNone && overlay == Overlay::kNone;
  if (!closes_nothing && !words.empty()) add_log(std::move(words), key);
  if (is_history) {
    reconcile();
  } else {
    settle(before.kept, change_title(action, kept.view), key);
  }
  if (goes_to_moment(action)) {
    bring_moment_into_view();
  } else if (keeps_vehicle) {
    keep_vehicle_in_view();
  }
  let_go_of_particle();
  request_steps();
  return {};
}

std::string Session::Implementation::words_for_log(const Action& action) const {
  const bool is_place = std::holds_alternative<actions::AddPlace>(action);
  const bool is_end = std::holds_alternative<actions::FinishTool>(action);
  const bool is_drawn_freely =
      (is_place || is_end) && labels && labels->desk && draws_freely(label.tool.kind);
  if (!is_drawn_freely) return action_text(action);
  if (is_place) return {};
  return action_text(stroke_of_hand(*labels->desk));
}

Standing Session::Implementation::standing() const {
  return {kept, playback, label, overlay, followed_run, coming, wanted_time_s, map_wishes};
}

void Session::Implementation::put_back(Standing before) {
  kept = std::move(before.kept);
  playback = before.playback;
  label = std::move(before.label);
  overlay = before.overlay;
  followed_run = std::move(before.followed_run);
  coming = std::move(before.coming);
  wanted_time_s = before.wanted_time_s;
  map_wishes = std::move(before.map_wishes);
}

void Session::Implementation::settle(const KeptState& before,
                                     std::string title,
                                     std::string merge_key) {
  // Looking at another tab changes nothing that anybody would take back.
  WindowLayout& layout = kept.view.layout;
  const WindowLayout& earlier = before.view.layout;
  const std::pair tabs(layout.left_tab, layout.right_tab);
  std::tie(layout.left_tab, layout.right_tab) = std::pair(earlier.left_tab, earlier.right_tab);
  const bool is_changed = !(kept == before);
  std::tie(layout.left_tab, layout.right_tab) = tabs;
  if (is_changed) history.commit(before, std::move(title), std::move(merge_key));
  reconcile();
}

void Session::Implementation::poll(double elapsed_s) {
  poll_reading(elapsed_s);
  poll_reruns();
  offer_localising();
  poll_small_works();
  poll_labels(elapsed_s);
  move_on(elapsed_s);
  let_go_of_particle();
  request_steps();
  show_coming_run();
  for (const OpenRun& run : runs) {
    if (!run.cache) continue;
    for (const Error& error : run.cache->take_errors()) {
      add_notice(Notice::Kind::kWarning, error.message);
    }
  }
  if (playback.is_playing || !is_busy()) age_notices(elapsed_s);  // who waits looks elsewhere
  std::erase_if(leaving, [](const auto& has_left) { return has_left(); });
  poll_saving(elapsed_s);
}

void Session::Implementation::add_log(std::string line, std::string key) {
  if (!key.empty() && key == log_key && !log.empty()) {
    log.back() = std::move(line);
    return;
  }
  log_key = std::move(key);
  log.push_back(std::move(line));
  if (log.size() > kMostLogLines) log.erase(log.begin());
}

const OpenRun* Session::Implementation::active() const {
  const int number = kept.view.active_run;
  return number > 0 && static_cast<std::size_t>(number) <= runs.size()
             ? &runs[static_cast<std::size_t>(number) - 1]
             : nullptr;
}

const RunDocument* Session::Implementation::active_document() const {
  const OpenRun* const run = active();
  return run != nullptr ? run->document.get() : nullptr;
}

Result<const OpenRun*> Session::Implementation::need_run() const {
  const OpenRun* const run = active();
  if (run == nullptr) return fail(ErrorCode::kInvalidOptions, "no run is open: open one first");
  if (!run->document || run->document->steps.empty()) {
    return fail(ErrorCode::kInvalidOptions, "{} is still being read", run->name);
  }
  return run;
}

Result<std::size_t> Session::Implementation::run_of(int number) const {
  if (number < 1 || static_cast<std::size_t>(number) > runs.size()) {
    return fail(ErrorCode::kInvalidOptions, "there is no run {}: {} {} open", number, runs.size(),
                runs.size() == 1 ? "is" : "are");
  }
  return static_cast<std::size_t>(number) - 1;
}

}  // namespace nadir
