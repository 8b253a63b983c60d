// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/job.h"
#include "core/session/history.h"
#include "core/session/rerun.h"
#include "core/session/session.h"

namespace nadir {

/// What undo takes back: the view, and what is kept beside it.
struct KeptState {
  ViewState view = default_view_state();
  std::map<std::string, Bookmarks> bookmarks;  ///< By the run's path; only of runs that were read.
  std::map<std::string, WindowLayout> layouts;
  int memory_megabytes = 256;
  friend bool operator==(const KeptState&, const KeptState&) = default;
};

/// What reading a run gives.
struct ReadRun {
  std::shared_ptr<const RunDocument> document;
  Bookmarks bookmarks;  ///< Read only the first time.
  std::optional<Error> bookmarks_fault;
};
/// What reading a map gives; the index is never null.
struct ReadMap {
  MapProvenance provenance;
  std::shared_ptr<const MapIndex> index;
};
template <typename Value>
using ReadingJob = std::optional<Job<int, Value>>;

/// What belongs to an open run beside OpenRun.
struct RunWork {
  int number = 0;  ///< As a job.
  ReadingJob<ReadRun> reading;
  std::string flight_path, map_path;  ///< Empty: not known yet, or not there.
  double since_reading_s = 1e9;       ///< Of a run that grows.
  bool is_last_reading_due = false;   ///< It has ended and may have grown since it was read.
};

struct FlightWork {
  std::shared_ptr<const FlightRecording> recording;
  ReadingJob<std::shared_ptr<const FlightRecording>> reading;
  bool has_failed = false;
};

struct RerunWork {
  int number = 0;
  std::string name;
  std::filesystem::path run;
  std::string flight_path, map_path;  ///< What it is made from.
  Job<RerunProgress, RerunOutcome> job;
  bool is_cancelled = false;
};

/// Small work with one result: a table that is written, a figure whose recipe is read.
struct SmallWork {
  int number = 0;
  std::string title;
  Job<int, std::string> job;
  std::function<void(std::string)> when_done;  ///< Takes the result; called from poll().
  bool is_cancelled = false;
};

/// Work of the shell.
struct EffectWork {
  int number = 0;
  std::string title;
  double fraction = 0.0;
  std::string activity;
  std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();
  bool is_cancelled = false;
  bool opens_result = false;  ///< What was made is opened.
};

/// All of a session. Its functions stand in session_*.cpp, by what they are about; perform() does what an action asks for and
/// may leave things half done where it fails, for apply() then takes everything back.
struct Session::Implementation {
  explicit Implementation(SessionPlaces where) : places(std::move(where)) {}
  ~Implementation();
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  SessionPlaces places;
  KeptState kept;
  History<KeptState> history;
  Playback playback;
  Overlay overlay = Overlay::kNone;
  std::vector<OpenRun> runs;   ///< As kept.view.runs.
  std::vector<RunWork> works;  ///< Beside each run.
  std::optional<OpenMap> map;
  ReadingJob<ReadMap> map_reading;
  std::string last_good_map;                  ///< Path of the last one that could be read.
  std::map<std::string, FlightWork> flights;  ///< By path.
  std::vector<RerunWork> reruns;
  std::vector<SmallWork> small_works;
  std::vector<EffectWork> effect_works;
  std::vector<std::function<bool()>> leaving;  ///< What was asked to stop; true once it has.
  std::vector<Effect> effects;
  std::vector<int> cancelled_effects;
  std::vector<Notice> notices;
  std::vector<std::string> log;
  std::string log_key;  ///< Of the last line, while a drag goes on.
  std::vector<std::string> recents;
  int last_number = 0;  ///< Of jobs and notices.
  double map_aspect = 1.5;
  int direction = 1;  ///< In which time went last.

  // The active run as it was when time was last set, for another one may have other times.
  std::string timed_path;
  std::shared_ptr<const RunDocument> timed_document;
  std::optional<double> wanted_time_s;  ///< To be set once the active run is settled.
  std::string followed_run;  ///< Path of a run that grows, to whose end the cursor keeps; or empty.

  // What is written into the user's folder.
  std::string saved_session, saved_preferences;
  double since_saving_s = 0.0;
  std::optional<Job<int, int>> saving;
  bool has_saving_failed = false;
  bool is_leaving = false;  ///< The session ends in good order.

  // session.cpp
  Result<void> apply(const Action& action);
  void poll(double elapsed_s);
  void settle(const KeptState& before, std::string title, std::string merge_key);
  void add_notice(Notice notice);
  void add_notice(Notice::Kind kind, std::string text, std::string details = {});
  void add_log(std::string line, std::string key);
  [[nodiscard]] std::vector<JobStatus> jobs() const;
  [[nodiscard]] bool is_busy() const;
  [[nodiscard]] const OpenRun* active() const;
  [[nodiscard]] const RunDocument* active_document() const;
  /// The active run with its steps. @errors kInvalidOptions: "open a run first", "R is still being read".
  [[nodiscard]] Result<const OpenRun*> need_run() const;
  /// Index of the run that an action counts from 1. @errors kInvalidOptions: "there is no run 3".
  [[nodiscard]] Result<std::size_t> run_of(int number) const;
  template <typename ADoneJob>
  void let_go(std::optional<ADoneJob>& job) {
    if (!job) return;
    auto ending = std::make_shared<ADoneJob>(std::move(*job));
    job.reset();
    ending->request_stop();
    leaving.emplace_back([ending] { return ending->is_done(); });
  }
  template <typename Change>
  void amend(const Change& change) {
    change(kept);
    history.amend(change, kept);
  }

  // session_files.cpp
  Result<void> perform(const actions::OpenFile& action);
  Result<void> perform(const actions::OpenDemo& action);
  Result<void> perform(const actions::CloseRun& action);
  Result<void> perform(const actions::Quit& action);
  Result<void> perform(const actions::ActivateRun& action);
  Result<void> perform(const actions::ShowRun& action);
  void open_run(const std::string& path);
  Result<void> open_map(const std::filesystem::path& package);
  void remember(const std::string& path);
  void look_at_map(const std::string& path);
  void use_map_of_active_run();

  // session_recipes.cpp
  Result<void> open_recipe(std::string_view text, const std::filesystem::path& file);
  void open_recipe_later(const std::filesystem::path& figure);

  // session_reading.cpp
  void reconcile();
  void reconcile_runs();
  void settle_time();
  void begin_reading(std::size_t run);
  void take_run(std::size_t run);
  void poll_reading(double elapsed_s);
  void drop_run(const std::string& path);
  void share_memory();
  void request_steps();
  [[nodiscard]] bool is_being_written(const std::filesystem::path& run) const;

  // session_inputs.cpp
  void reconcile_map();
  void find_inputs(std::size_t run);
  void take_map();
  void begin_flight(const std::string& path);
  void take_flights();
  [[nodiscard]] std::shared_ptr<const FlightRecording> flight() const;

  // session_playback.cpp
  Result<void> perform(const actions::Seek& action);
  Result<void> perform(const actions::StepBy& action);
  Result<void> perform(const actions::GoTo& action);
  Result<void> perform(const actions::Play& action);
  Result<void> perform(const actions::SetSpeed& action);
  Result<void> perform(const actions::SetLoop& action);
  Result<void> perform(const actions::GoToDivergence& action);
  void seek(double time_s);
  void move_on(double elapsed_s);

  // session_map.cpp
  Result<void> perform(const actions::LookAt& action);
  Result<void> perform(const actions::Zoom& action);
  Result<void> perform(const actions::Rotate& action);
  Result<void> perform(const actions::Fit& action);
  Result<void> perform(const actions::Follow& action);
  Result<void> perform(const actions::SetUp& action);
  Result<void> perform(const actions::GoToPlace& action);
  Result<void> perform(const actions::LayTopview& action);
  Result<void> perform(const actions::SelectParticle& action);
  Result<void> perform(const actions::MeasurePoint& action);
  Result<void> perform(const actions::UseTool& action);
  Result<void> perform(const actions::ShowLayer& action);
  Result<void> perform(const actions::SetLayerOpacity& action);
  Result<void> perform(const actions::SetLayerColour& action);
  Result<void> perform(const actions::MoveLayer& action);
  [[nodiscard]] MapLook resolved_look() const;
  [[nodiscard]] MapLook fitted(MapLook look, FitTo to) const;
  [[nodiscard]] Result<ProjectPlane> plane() const;

  // session_layout.cpp
  Result<void> perform(const actions::ShowPanel& action);
  Result<void> perform(const actions::MoveSplitter& action);
  Result<void> perform(const actions::MapOnly& action);
  Result<void> perform(const actions::SplitView& action);
  Result<void> perform(const actions::SaveLayout& action);
  Result<void> perform(const actions::UseLayout& action);
  Result<void> perform(const actions::SetTheme& action);
  Result<void> perform(const actions::SetScale& action);
  Result<void> perform(const actions::ReduceMotion& action);
  Result<void> perform(const actions::SetMemory& action);
  Result<void> perform(const actions::ShowStrip& action);
  Result<void> perform(const actions::MoveStrip& action);
  Result<void> perform(const actions::SetStripHeight& action);
  Result<void> perform(const actions::ShowOverlay& action);

  // session_options.cpp
  Result<void> perform(const actions::SetOption& action);
  Result<void> perform(const actions::UsePreset& action);
  Result<void> perform(const actions::SavePreset& action);
  [[nodiscard]] Result<RunOptions> draft_options() const;

  // session_rerun.cpp
  Result<void> perform(const actions::Rerun& action);
  Result<void> perform(const actions::CancelJob& action);
  [[nodiscard]] Result<std::filesystem::path> name_of_next_run(
      const FlightDescription& flight) const;
  void poll_reruns();
  void end_rerun(RerunWork& work);

  // session_export.cpp
  Result<void> perform(const actions::ExportFigure& action);
  Result<void> perform(const actions::ExportTable& action);
  Result<void> perform(const actions::WriteReport& action);
  Result<void> perform(const actions::Copy& action);
  Result<void> perform(const actions::CopyView& action);
  Result<void> perform(const actions::PasteView& action);
  [[nodiscard]] int begin_effect(std::string title, bool opens_result = false);
  void report_effect(int job, double fraction, const std::string& activity);
  void finish_effect(int job, const std::string& error, const std::string& made);
  void poll_small_works();

  // session_bookmarks.cpp
  Result<void> perform(const actions::AddBookmark& action);
  Result<void> perform(const actions::EditBookmark& action);
  Result<void> perform(const actions::RemoveBookmark& action);
  Result<void> perform(const actions::DismissNotice& action);
  Result<void> perform(const actions::Undo& action);
  Result<void> perform(const actions::Redo& action);
  Result<void> keep_bookmarks(const std::string& run, const Bookmarks& wanted);
  Result<void> go_to_state(KeptState state);

  // session_keeping.cpp
  void read_preferences();
  void restore();
  void poll_saving(double elapsed_s);
  void save_now();
  void set_damaged_aside(const std::filesystem::path& file, const Error& error);
  [[nodiscard]] std::string session_text() const;
  [[nodiscard]] std::string preferences_text() const;
};

/// Takes a run out of a view; the one before it is then active where it was.
void take_run_out(ViewState& view, const std::string& path);

/// The command line calls options by dashes, the window does not.
[[nodiscard]] Error without_dashes(Error error);

/// The absolute path of something that a user names.
[[nodiscard]] std::string absolute_path(const std::filesystem::path& path);

}  // namespace nadir
