// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/run/run_options.h"
#include "core/session/action.h"
#include "core/session/effect.h"
#include "core/session/notice.h"
#include "core/session/open_run.h"
#include "core/session/view_state.h"

namespace nadir {

class LabelDesk;
struct LabelView;

/// Where a session finds and keeps things.
struct SessionPlaces {
  std::filesystem::path
      config;  ///< Folder of preferences and of the last session; made when first written.
  std::filesystem::path
      data;  ///< Folder for the demo and for new runs whose flight's folder cannot be written.
  std::filesystem::path bundled_map;  ///< The demo's map.
  std::filesystem::path resources =
      {};  ///< Folder with street profiles (profiles) and rules of imports (rules).
  std::string author = "unknown";  ///< Who draws labels, for their history.
  /// The recipe that a PNG or SVG carries, as text; called from a job's thread. Empty: figures cannot be opened.
  std::function<Result<std::string>(const std::filesystem::path& figure)> recipe_in_figure = {};
  /// What is open is kept for the next start; else what was open last stays there, whatever is opened now. Preferences are
  /// kept in any case.
  bool keeps_session = true;
};

/// What the map's view has for things that are fitted into it.
struct MapRoom {
  double aspect = 1.5;  ///< Width by height of the whole view.
  /// What controls cover along its sides, in shares of its width (left, right) and height (bottom, top).
  double left = 0.0, right = 0.0, bottom = 0.0, top = 0.0;
  friend bool operator==(const MapRoom&, const MapRoom&) = default;
};

/// What is open, how it is looked at and what is being done: the only writer. One thread; nothing in here waits for a disk
/// or for work, but for files of a few kilobytes. Every change comes by apply(), or by poll() from work that has gone on.
/// What it hands out by reference, pointer or span stays until the next call of either.
class Session {
 public:
  /// Runs that a killed program was writing are offered by notices, at every start until they are opened or dismissed.
  explicit Session(SessionPlaces places);
  ~Session();  ///< Stops all work; what a rerun has recorded stays.
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Does what was asked, or says why not; then nothing has changed. Errors become notices too, so that callers other than
  /// scripts and tests need not look. Logged by its words.
  Result<void> apply(const Action& action);
  /// Call once a frame: takes over what jobs have finished, moves playback on, saves what has changed.
  /// @param elapsed_s  Since the last call.
  void poll(double elapsed_s);
  /// Whether anything moves by itself (playing, jobs), so that the window must draw again soon.
  [[nodiscard]] bool is_busy() const;

  [[nodiscard]] const ViewState& view() const;
  [[nodiscard]] const Playback& playback() const;
  [[nodiscard]] Overlay overlay() const;
  [[nodiscard]] std::span<const OpenRun> runs() const;  ///< As view().runs.
  [[nodiscard]] const OpenRun* active_run() const;      ///< Null: none.
  [[nodiscard]] const OpenMap* map() const;             ///< Null: none.
  /// Flight of the active run, without a run the one opened by itself; null where it is not there or not read yet.
  [[nodiscard]] std::shared_ptr<const FlightRecording> flight() const;
  /// The run that a rerun goes by, from its flight to its start: until the run that was begun last is seen, one from the start
  /// goes by that. Null: none, the flight that was opened by itself is localised.
  [[nodiscard]] const OpenRun* run_to_rerun(RerunFrom from) const;
  /// The flight that a rerun would localise. @errors kInvalidOptions: it is not there, or not read yet, in a sentence.
  [[nodiscard]] Result<std::shared_ptr<const FlightRecording>> flight_to_rerun(
      RerunFrom from) const;
  /// Index of the active run's step at the moment; nothing without a run or before it is read.
  [[nodiscard]] std::optional<std::size_t> step_index() const;
  /// The same with particles and topview; null until it has been decoded.
  [[nodiscard]] std::shared_ptr<const RunStep> step() const;
  /// Index of the step of another open run at the same time. @param run  Number.
  [[nodiscard]] std::optional<std::size_t> step_index_of(int run) const;
  /// Camera of the window: centre, width and up as they are to be drawn now, following and heading resolved.
  [[nodiscard]] MapLook resolved_map_look() const;

  /// Options of the next run: the active run's, or a preset's, with changes. @errors kInvalidOptions, where a kept change no
  /// longer fits; as draft_base().
  [[nodiscard]] Result<RunOptions> draft_options() const;
  /// The same without the changes. @errors kInvalidOptions: no such preset, or the active run is still being read;
  /// kMalformed: what the run recorded is none.
  [[nodiscard]] Result<RunOptions> draft_base() const;
  /// How the next run from the start begins, as a run's header has it; empty: not known. That too goes by the run that was
  /// begun last until it is seen, else by the active one.
  [[nodiscard]] std::string draft_prior() const;
  /// Which workspace is in front, what is labelled and with what.
  [[nodiscard]] const LabelView& label_view() const;
  /// The labels that are open; null: none, or they are still being opened.
  [[nodiscard]] const LabelDesk* label_desk() const;
  [[nodiscard]] std::span<const Notice> notices() const;
  [[nodiscard]] std::vector<JobStatus> jobs() const;
  [[nodiscard]] std::span<const std::string> log()
      const;  ///< Words of all that was done, oldest first.
  [[nodiscard]] std::span<const std::string> recents() const;  ///< Paths, newest first.
  /// Commands chosen by hand, by their words, newest first; kept as a preference.
  [[nodiscard]] std::span<const std::string> recent_commands() const;
  void remember_command(const std::string& text);
  /// Sections of panels that are folded, or open, unlike at first: their paths, kept as a preference.
  [[nodiscard]] std::span<const std::string> turned_sections() const;
  void keep_turned_sections(std::vector<std::string> paths);
  /// Maps that may belong to the flight that was opened by itself: those beside it first.
  [[nodiscard]] std::span<const std::string> maps_for_flight() const;
  /// Why session or preferences could not be written last; empty: they are kept.
  [[nodiscard]] const std::string& saving_fault() const;
  /// Whether the next start shows what is open now; see SessionPlaces.
  [[nodiscard]] bool keeps_session() const;
  [[nodiscard]] std::vector<std::string> layout_names() const;
  [[nodiscard]] std::optional<std::string> undo_title() const;
  [[nodiscard]] std::optional<std::string> redo_title() const;
  [[nodiscard]] std::size_t memory_used_bytes() const;
  [[nodiscard]] int memory_budget_megabytes() const;

  [[nodiscard]] std::vector<Effect> take_effects();
  /// @param error     Empty: done; the file that came of it is `made`.
  /// @param warnings  What its user should know of that file, each half a sentence.
  void finish_effect(int job,
                     const std::string& error,
                     const std::string& made,
                     const std::vector<std::string>& warnings = {});
  void report_effect(int job, double fraction, const std::string& activity);
  /// Jobs of effects that the user has cancelled since the last call: the shell stops them.
  [[nodiscard]] std::vector<int> take_cancelled_effects();
  /// Width by height of the map's view, for what is fitted into it. Changes nothing else.
  void set_map_aspect(double width_by_height);
  /// The same with what is covered. What is no number, or leaves nothing, is passed over.
  void set_map_room(const MapRoom& room);
  /// A change by drag or typing is over: the next one is a step of its own.
  void seal_history();
  /// For what the shell has to say: a file that could not be dropped, a message of VTK.
  void notify(Notice::Kind kind, std::string text, std::string details = {});

  /// Opens what was open when the program was last left, or killed.
  void restore();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir
