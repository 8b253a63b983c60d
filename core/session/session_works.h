// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/desk/label_desk.h"
#include "core/session/open_run.h"
#include "core/session/rerun.h"

// What a session is at work on: things on their way from the disk, and onto it.
namespace nadir {

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
  std::string hash;
};
template <typename Value>
using ReadingJob = std::optional<Job<int, Value>>;

/// Tells whether somebody has written into a file.
struct FileState {
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type written;
  friend bool operator==(const FileState&, const FileState&) = default;
};
[[nodiscard]] FileState file_state(const std::filesystem::path& path);

/// A map that showed all of what was open, and stayed as it was when a run began.
struct HeldView {
  Eigen::Vector2d centre_before_in_enu_m, centre_in_enu_m;
  double width_m = 0.0;
};

/// What a run was made with: from here the options of the next one differ.
struct OptionsBase {
  std::string preset;
  RunOptions options;
};

/// What is known of a run that this program makes before its first step.
struct RerunOrigin {
  OptionsBase base;
  Result<std::optional<Prior>> prior;  ///< Of the flight's start; or why nobody knows it.
  /// Moment that was studied when it was begun: the cursor goes back to it when it has watched the run to its end.
  std::optional<double> studied_clock_s;
};

/// A run from its beginning until all of it has been read.
struct LiveRun {
  enum class Stage { kWritten, kEnded, kReadToItsEnd };
  RerunOrigin origin;
  Stage stage = Stage::kWritten;  ///< kEnded: its last reading is due; kReadToItsEnd: that goes on.
  std::optional<HeldView> held_view = {};  ///< Since its first step was read.
};

/// A run that takes the place of what is seen, with its first step.
struct ComingRun {
  std::string path;
  bool is_followed = false;  ///< The cursor will keep to its end.
};

/// What belongs to an open run beside OpenRun.
struct RunWork {
  int number = 0;  ///< As a job.
  ReadingJob<ReadRun> reading;
  std::string flight_path, map_path;  ///< Empty: not known yet, or not there.
  double since_reading_s = 1e9;       ///< Of a run that grows.
  std::optional<LiveRun> live = {};   ///< As OpenRun::is_live says.
  FileState file;                     ///< When its last reading began.
  double since_look_s = 0.0;          ///< Since the file was compared with that.
  bool is_opened_again = false;       ///< So file, flight and map are to be looked at anew.
};

/// The run whose file names a map that is to be shown, as soon as that is known.
struct MapWish {
  std::uint64_t since = 0;  ///< Number of the change that opened it: what was before keeps its map.
  bool keeps_sight = false;  ///< What of the ground is shown was chosen with it.
};

/// What of an earlier active run tells its time.
struct TimedRun {
  RunHeader header;
  double start_clock_s = 0.0;
};

/// What opening a flight gives; the recording is never null.
struct ReadFlight {
  std::shared_ptr<const FlightRecording> recording;
  std::vector<std::string> maps;  ///< Map packages that may belong to it.
  std::string hash;               ///< flight_hash() of one that was opened by itself.
};
struct FlightWork {
  std::shared_ptr<const FlightRecording> recording;
  std::vector<std::string> maps;
  std::string hash;
  ReadingJob<ReadFlight> reading;
  bool has_failed = false;
};

struct RerunWork {
  int number = 0;
  std::string name;
  std::filesystem::path run;
  std::string flight_path, map_path;  ///< What it is made from.
  RerunOrigin origin;
  Job<RerunProgress, RerunOutcome> job;
  bool is_cancelled = false;
};

/// Labels that are open, or on their way.
struct LabelWork {
  std::string path;  ///< What was named.
  int number = 0;    ///< As a job.
  ReadingJob<LabelDesk> opening;
  std::optional<LabelDesk> desk;
  double since_poll_s = 0.0;
  bool is_counted = false;  ///< Whether the cells of each class are known.
  std::string last_fault;   ///< What was told last of what others do to the file.
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
  std::vector<std::string> warnings =
      {};  ///< To be told with what was made: "it does not show the error surface".
};

/// How it ended.
struct EffectEnd {
  std::string error;  ///< Empty: it is done.
  std::string made;
  std::vector<std::string> warnings;
};

}  // namespace nadir
