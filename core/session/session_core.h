// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/session/session.h"
#include "core/session/session_state.h"

namespace nadir {

struct ImportedLabels;

/// All of a session, by what it remembers (session_state.h). Its functions stand in session_*.cpp, by what they are about; perform() does what an action asks for and
/// may leave things half done where it fails, for apply() then takes everything back.
struct Session::Implementation : SessionState {
  explicit Implementation(SessionPlaces where) : SessionState(std::move(where)) {}
  ~Implementation();
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  // session.cpp
  Result<void> apply(const Action& action);
  /// The words of an action; of a stroke, whose places come one by one, nothing until it is finished, and then all of it.
  [[nodiscard]] std::string words_for_log(const Action& action) const;
  [[nodiscard]] Standing standing() const;
  void put_back(Standing before);
  void poll(double elapsed_s);
  void settle(const KeptState& before, std::string title, std::string merge_key);
  void add_log(std::string line, std::string key);
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
  /// @param since  Number of a change: states from before it stay.
  template <typename Change>
  void amend(const Change& change, std::uint64_t since = 0) {
    change(kept);
    history.amend(change, kept, since);
  }

  // session_jobs.cpp
  Result<void> perform(const actions::CancelJob& action);
  [[nodiscard]] std::vector<JobStatus> jobs() const;
  [[nodiscard]] bool is_busy() const;

  // session_notices.cpp
  Result<void> perform(const actions::DismissNotice& action);
  void add_notice(const Notice& notice);
  void add_notice(Notice::Kind kind, std::string text, std::string details = {});
  void forget_notices(const std::function<bool(const Notice&)>& is_one);
  void age_notices(double elapsed_s);
  /// A run that was offered was opened, or nobody wants it.
  void settle_unfinished(const std::string& run);

  // session_files.cpp
  Result<void> perform(const actions::OpenFile& action);
  Result<void> perform(const actions::OpenDemo& action);
  Result<void> perform(const actions::CloseRun& action);
  Result<void> perform(const actions::SaveNow& action);
  Result<void> perform(const actions::Quit& action);
  Result<void> perform(const actions::ActivateRun& action);
  Result<void> perform(const actions::ShowRun& action);
  /// Somebody goes to a run before the one that is coming is shown; that one is watched all the same if it is the one.
  void go_to_run_instead(const std::string& path);
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
  /// The cursor keeps to the end of a run only while that grows, then it is where it was before.
  void end_following(std::size_t run, const LiveRun& ended);
  void poll_reading(double elapsed_s);
  /// Reads a run again whose file somebody has written into: of one that may grow now and then, else when it is opened again.
  void look_at_file(std::size_t run);
  void drop_run(const std::string& path);
  [[nodiscard]] bool is_being_written(const std::filesystem::path& run) const;

  // session_steps.cpp
  void share_memory();
  void request_steps();

  // session_inputs.cpp
  void reconcile_map();
  void find_inputs(std::size_t run);
  void take_map();
  void take_map_of(std::size_t run);
  void begin_flight(const std::string& path);
  void take_flights();
  void offer_localising();
  /// Path of the flight that the active run was made from; without a run, of the one that was opened by itself. May be empty.
  [[nodiscard]] const std::string& flight_path() const;
  /// A flight by its path; null where it is not there or not read yet.
  [[nodiscard]] std::shared_ptr<const FlightRecording> flight_of(const std::string& path) const;

  // session_playback.cpp
  Result<void> perform(const actions::Seek& action);
  Result<void> perform(const actions::GoToMoment& action);
  Result<void> perform(const actions::StepBy& action);
  Result<void> perform(const actions::GoTo& action);
  Result<void> perform(const actions::Play& action);
  Result<void> perform(const actions::SetSpeed& action);
  Result<void> perform(const actions::SetLoop& action);
  Result<void> perform(const actions::GoToDivergence& action);
  void seek(double time_s);
  /// Somebody wants the cursor elsewhere than at the end of a run that grows.
  void stop_following();
  void move_on(double elapsed_s);

  // session_map.cpp
  Result<void> perform(const actions::LookAt& action);
  Result<void> perform(const actions::Zoom& action);
  Result<void> perform(const actions::Rotate& action);
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
  [[nodiscard]] Result<ProjectPlane> plane() const;
  /// A particle is selected for one step only.
  void let_go_of_particle();

  // session_sight.cpp
  Result<void> perform(const actions::Fit& action);
  [[nodiscard]] MapLook resolved_look() const;
  [[nodiscard]] MapLook fitted(MapLook look, FitTo to) const;
  [[nodiscard]] std::vector<Eigen::Vector2d> corners_of_labels() const;
  /// What shows all of a run, or of the map, stays as it is when this run begins, which is small at first.
  [[nodiscard]] std::optional<HeldView> hold_view_for(const std::string& run);
  /// The map fits itself again, unless somebody has moved it since.
  void let_go_of_view(const HeldView& held);
  /// The same where nobody would see a difference.
  void let_go_of_view_unseen(const HeldView& held);
  /// Has the map show estimate, truth and particles of the moment: moved where they are not in view, nearer where they would be
  /// tiny. It belongs to time, which is not undone.
  void bring_moment_into_view();
  /// Where the vehicle is thought to be at the cursor; nothing where nobody knows, or the map is of another place.
  [[nodiscard]] std::optional<Eigen::Vector2d> vehicle_in_enu_m() const;
  /// Whether where the vehicle is thought to be lies on the map's page, as the window has it. True where nobody knows.
  [[nodiscard]] bool is_vehicle_in_view() const;
  /// Moves the map, as large as it is, where the vehicle has left it: that comes into the middle of what controls leave. For time
  /// that jumps: who has looked elsewhere before is not taken away from there.
  void keep_vehicle_in_view();
  /// The map's centre, where nobody minds: no step of the history.
  void move_view_to(const Eigen::Vector2d& centre_in_enu_m);

  // session_labels.cpp
  Result<void> perform(const actions::OpenLabels& action);
  Result<void> perform(const actions::CloseLabels& action);
  Result<void> perform(const actions::SetWorkspace& action);
  Result<void> perform(const actions::ShowLabelTab& action);
  Result<void> perform(const actions::ShowBorders& action);
  Result<void> perform(const actions::SetLabelOpacity& action);
  Result<void> perform(const actions::SetLabelOption& action);
  Result<void> perform(const actions::LastClass& action);
  Result<void> perform(const actions::AddPlace& action);
  Result<void> perform(const actions::TraceTo& action);
  Result<void> perform(const actions::TypeLeg& action);
  Result<void> perform(const actions::FinishTool& action);
  Result<void> perform(const actions::CancelTool& action);
  Result<void> perform(const actions::SelectLabels& action);
  Result<void> perform(const actions::SelectBox& action);
  /// @errors kInvalidOptions: no labels are open, or not yet.
  [[nodiscard]] Result<LabelDesk*> need_desk();
  /// The one that undo is about; null: the view is.
  [[nodiscard]] LabelDesk* desk_in_front();
  [[nodiscard]] Result<void> use_tool(const LabelTool& tool);
  /// Whether the map shows labels of another place than that of map and runs: then it has a sight of its own.
  [[nodiscard]] bool labels_elsewhere() const;
  void set_sight(const GroundSight& sight);
  void reconcile_labels();
  void take_labels();
  void poll_labels(double elapsed_s);

  // session_label_edits.cpp
  Result<void> perform(const actions::GoToLabelStep& action);
  Result<void> perform(const actions::DrawArea& action);
  Result<void> perform(const actions::DrawLine& action);
  Result<void> perform(const actions::DrawOutline& action);
  Result<void> perform(const actions::DrawStreet& action);
  Result<void> perform(const actions::CutHole& action);
  Result<void> perform(const actions::StrokeLabels& action);
  Result<void> perform(const actions::FillLabels& action);
  Result<void> perform(const actions::RecodeLabels& action);
  Result<void> perform(const actions::MoveVertex& action);
  Result<void> perform(const actions::AddVertex& action);
  Result<void> perform(const actions::MoveLabels& action);
  Result<void> perform(const actions::DuplicateLabels& action);
  Result<void> perform(const actions::CopyBeside& action);
  Result<void> perform(const actions::EditLabels& action);
  Result<void> perform(const actions::SetLabel& action);
  Result<void> perform(const actions::JoinBorders& action);
  Result<void> perform(const actions::SplitLabels& action);
  Result<void> perform(const actions::PasteLabels& action);
  Result<void> draw(ObjectKind kind,
                    const std::string& class_name,
                    double width_m,
                    const PlaceList& through);
  Result<void> copy_labels(LabelDesk& desk);

  // session_label_files.cpp
  Result<void> perform(const actions::ExportLabels& action);
  Result<void> perform(const actions::ImportLabels& action);
  Result<void> perform(const actions::SaveLabelsCopy& action);
  void take_import(const std::string& file,
                   const ImportedLabels& imported,
                   const std::string& into);

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
  /// The run that the next one goes by, from its options to its start: the one that was begun last until it is seen, else the
  /// active one. Null: none.
  [[nodiscard]] const OpenRun* run_to_repeat() const;
  /// The same for a rerun from somewhere: from the cursor it is the active one, and of the flight opened by itself none.
  [[nodiscard]] const OpenRun* run_to_rerun(RerunFrom from) const;
  [[nodiscard]] Result<RunOptions> draft_options() const;
  /// The same without the changes, and the preset's name. @errors kInvalidOptions: no such preset, or that run is still being
  /// read; kMalformed: what it recorded is none.
  [[nodiscard]] Result<OptionsBase> draft_base() const;
  [[nodiscard]] std::string draft_prior() const;
  /// Null: the run is not made by this program, or all of it has been read.
  [[nodiscard]] const LiveRun* live(const OpenRun& run) const;

  // session_rerun.cpp
  Result<void> perform(const actions::Rerun& action);
  /// @param run  To be run again; null: the flight is what is known.
  [[nodiscard]] Result<std::filesystem::path> name_of_next_run(const FlightDescription& flight,
                                                               const OpenRun* run) const;
  [[nodiscard]] std::string name_without_number(const OpenRun& run) const;
  /// Path of the flight to localise, which is read. @param run  To be run again; null: the one that was opened by itself.
  [[nodiscard]] Result<std::string> flight_to_localise(const OpenRun* run) const;
  /// How the flight of a run began. @errors as recorded_prior().
  [[nodiscard]] Result<std::optional<Prior>> prior_of(const OpenRun& run) const;
  [[nodiscard]] Result<void> set_start(RerunTask& task, RerunFrom from, const OpenRun* run) const;
  void say_what_of_map_changed(const OpenRun& run);
  void poll_reruns();
  void end_rerun(RerunWork& work);
  void show_coming_run();

  // session_export.cpp
  Result<void> perform(const actions::ExportFigure& action);
  Result<void> perform(const actions::ExportTable& action);
  Result<void> perform(const actions::WriteReport& action);
  Result<void> perform(const actions::Copy& action);
  Result<void> perform(const actions::CopyView& action);
  Result<void> perform(const actions::PasteView& action);
  EffectWork& begin_effect(std::string title);
  void report_effect(int job, double fraction, const std::string& activity);
  void finish_effect(int job, const EffectEnd& end);
  void poll_small_works();

  // session_bookmarks.cpp
  Result<void> perform(const actions::AddBookmark& action);
  Result<void> perform(const actions::EditBookmark& action);
  Result<void> perform(const actions::RemoveBookmark& action);
  Result<void> perform(const actions::Undo& action);
  Result<void> perform(const actions::Redo& action);
  Result<void> keep_bookmarks(const std::string& run, const Bookmarks& wanted);
  /// Does to all states of the history what another window has done to a file, so that undo does not take that back.
  /// @param last  The state that followed the newest of them, where that has been done already.
  void take_foreign(const ForeignBookmarks& foreign, const KeptState& last);
  Result<void> go_to_state(KeptState state);

  // session_keeping.cpp
  /// At the start: preferences are read, and what a killed program has left is offered.
  void begin_keeping();
  void read_preferences();
  void restore();
  void poll_saving(double elapsed_s);
  void save_now();
  void save_soon();
  void take_saving(const Result<int>& outcome, const Savings& what);
  /// A file that cannot be used: it is set aside where it is damaged, and left where a newer version wrote it.
  void refuse_file(const std::filesystem::path& file, const Error& error);
  [[nodiscard]] std::string session_text() const;
  [[nodiscard]] Preferences preferences() const;
  [[nodiscard]] Savings changed_since_saving() const;
  void list_what_is_written();
};

/// Takes a run out of a view; the one before it is then active where it was.
void take_run_out(ViewState& view, const std::string& path);

/// The command line calls options by dashes, the window does not.
[[nodiscard]] Error without_dashes(Error error);

/// What a brush or eraser has been drawn along, as one action.
[[nodiscard]] actions::StrokeLabels stroke_of_hand(const LabelDesk& desk);

/// The absolute path of something that a user names.
[[nodiscard]] std::string absolute_path(const std::filesystem::path& path);

}  // namespace nadir
