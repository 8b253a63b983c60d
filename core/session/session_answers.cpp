// SPDX-License-Identifier: Apache-2.0
// What is asked of a session from outside, handed on to the one who knows.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/session/session.h"
#include "core/session/session_core.h"

namespace nadir {

Result<void> Session::apply(const Action& action) { return implementation_->apply(action); }
void Session::poll(double elapsed_s) { implementation_->poll(elapsed_s); }
bool Session::is_busy() const { return implementation_->is_busy(); }
const ViewState& Session::view() const { return implementation_->kept.view; }
const Playback& Session::playback() const { return implementation_->playback; }
Overlay Session::overlay() const { return implementation_->overlay; }
std::span<const OpenRun> Session::runs() const { return implementation_->runs; }
const OpenRun* Session::active_run() const { return implementation_->active(); }
const OpenMap* Session::map() const {
  return implementation_->map ? &*implementation_->map : nullptr;
}
std::shared_ptr<const FlightRecording> Session::flight() const {
  return implementation_->flight_of(implementation_->flight_path());
}
const OpenRun* Session::run_to_rerun(RerunFrom from) const {
  return implementation_->run_to_rerun(from);
}
Result<std::shared_ptr<const FlightRecording>> Session::flight_to_rerun(RerunFrom from) const {
  const auto path = implementation_->flight_to_localise(run_to_rerun(from));
  if (!path) return forward_error(path);
  return implementation_->flight_of(*path);
}

std::optional<std::size_t> Session::step_index() const {
  const RunDocument* const run = implementation_->active_document();
  if (run == nullptr) return std::nullopt;
  return run->index_at(implementation_->playback.time_s);
}

std::shared_ptr<const RunStep> Session::step() const {
  const OpenRun* const run = active_run();
  const auto index = step_index();
  return run != nullptr && run->cache && index ? run->cache->step(*index) : nullptr;
}

std::optional<std::size_t> Session::step_index_of(int run) const {
  const RunDocument* const here = implementation_->active_document();
  const auto index = implementation_->run_of(run);
  if (here == nullptr || !index) return std::nullopt;
  const auto& there = implementation_->runs[*index].document;
  if (!there) return std::nullopt;
  return there->index_at(here->time_in(*there, implementation_->playback.time_s));
}

const LabelView& Session::label_view() const { return implementation_->label; }
const LabelDesk* Session::label_desk() const {
  const std::optional<LabelWork>& labels = implementation_->labels;
  return labels && labels->desk ? &*labels->desk : nullptr;
}
MapLook Session::resolved_map_look() const { return implementation_->resolved_look(); }
Result<RunOptions> Session::draft_options() const { return implementation_->draft_options(); }
Result<RunOptions> Session::draft_base() const {
  const auto base = implementation_->draft_base();
  if (!base) return forward_error(base);
  return base->options;
}
std::string Session::draft_prior() const { return implementation_->draft_prior(); }
std::span<const Notice> Session::notices() const { return implementation_->notices; }
std::vector<JobStatus> Session::jobs() const { return implementation_->jobs(); }
std::span<const std::string> Session::log() const { return implementation_->log; }
std::span<const std::string> Session::recents() const { return implementation_->recents; }

std::span<const std::string> Session::recent_commands() const {
  return implementation_->recent_commands;
}

void Session::remember_command(const std::string& text) {
  std::vector<std::string>& recent = implementation_->recent_commands;
  std::erase(recent, text);
  recent.insert(recent.begin(), text);
  if (recent.size() > kMostRecentCommands) recent.pop_back();
}

std::span<const std::string> Session::maps_for_flight() const {
  const auto found = implementation_->flights.find(implementation_->kept.view.flight_path);
  if (found == implementation_->flights.end()) return {};
  return found->second.maps;
}

const std::string& Session::saving_fault() const { return implementation_->saving_fault; }

bool Session::keeps_session() const {
  return implementation_->places.keeps_session && !implementation_->places.config.empty();
}

std::vector<std::string> Session::layout_names() const {
  std::vector<std::string> names = {"default"};
  for (const auto& [name, layout] : implementation_->kept.layouts) names.push_back(name);
  return names;
}

std::optional<std::string> Session::undo_title() const {
  if (const LabelDesk* const desk = implementation_->desk_in_front()) return desk->undo_title();
  if (!implementation_->history.can_undo()) return std::nullopt;
  return implementation_->history.undo_title();
}

std::optional<std::string> Session::redo_title() const {
  if (const LabelDesk* const desk = implementation_->desk_in_front()) return desk->redo_title();
  if (!implementation_->history.can_redo()) return std::nullopt;
  return implementation_->history.redo_title();
}

std::size_t Session::memory_used_bytes() const {
  std::size_t bytes = 0;
  for (const OpenRun& run : implementation_->runs) bytes += run.cache ? run.cache->used_bytes() : 0;
  return bytes;
}

int Session::memory_budget_megabytes() const { return implementation_->kept.memory_megabytes; }

std::vector<Effect> Session::take_effects() { return std::exchange(implementation_->effects, {}); }

void Session::finish_effect(int job,
                            const std::string& error,
                            const std::string& made,
                            const std::vector<std::string>& warnings) {
  implementation_->finish_effect(job, {error, made, warnings});
}

void Session::report_effect(int job, double fraction, const std::string& activity) {
  implementation_->report_effect(job, fraction, activity);
}

std::vector<int> Session::take_cancelled_effects() {
  return std::exchange(implementation_->cancelled_effects, {});
}

void Session::set_map_aspect(double width_by_height) {
  if (width_by_height > 0.0 && std::isfinite(width_by_height)) {
    implementation_->map_room = {width_by_height, 0.0, 0.0, 0.0, 0.0};
  }
}

void Session::set_map_room(const MapRoom& room) {
  const auto is_share = [](double share) { return share >= 0.0 && share < 1.0; };
  const bool is_room = room.aspect > 0.0 && std::isfinite(room.aspect) && is_share(room.left) &&
                       is_share(room.right) && is_share(room.bottom) && is_share(room.top) &&
                       room.left + room.right < 1.0 && room.bottom + room.top < 1.0;
  if (is_room) implementation_->map_room = room;
}

void Session::seal_history() {
  implementation_->history.seal();
  implementation_->log_key.clear();
}

void Session::notify(Notice::Kind kind, std::string text, std::string details) {
  implementation_->add_notice(kind, std::move(text), std::move(details));
}

void Session::restore() { implementation_->restore(); }

}  // namespace nadir
