// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mcl/particle_set.h"
#include "core/mcl/pose_estimate.h"
#include "core/topview/semantic_topview.h"

namespace nadir {

/// Times that differ by less are the same: in seconds since 1970 a double's step is 2.4e-7 s.
inline constexpr double kSameTimeS = 1e-6;

/// What was run, on what, with which settings: enough to run it again. Stored as rows of table
/// `about`.
struct RunHeader {
  std::string program_version;
  std::string flight, map, preset;  ///< Names for people.
  std::string flight_path, map_path;
  std::string flight_hash, map_hash;  ///< Of the inputs, hexadecimal.
  std::uint64_t seed = 0;
  double plane_latitude_deg = 0.0,
         plane_longitude_deg = 0.0;            ///< Origin of the project plane of all poses.
  std::map<std::string, std::string> options;  ///< Every option of the localiser by name, as text.
  /// Of a run that goes on from a moment of an earlier one: that run's file, and the time (as in RunStep::time_s) of the step it
  /// went on from. Steps up to that time are copies of the earlier run's. Empty and nothing for any other run.
  std::string parent_run;
  std::optional<double> started_at_s;
  friend bool operator==(const RunHeader&, const RunHeader&) = default;
};

/// One update of the localiser, as recorded.
struct RunStep {
  int step = 0;
  double time_s = 0.0;
  Rigid2 odom_from_body;  ///< Odometry input.
  /// The same, laid at the start: what dead reckoning alone would have said. Absent where the start is not known, neither
  /// from the truth nor from the prior.
  std::optional<Rigid2> odometry_in_enu;
  std::optional<Rigid2> truth_in_enu;  ///< Where the flight knows it.
  PoseEstimate estimate;
  double effective_sample_size = 0.0;
  int particle_count = 0;
  bool was_resampled = false;
  std::optional<double>
      agreement;  ///< Share of known topview cells whose class is the map's at the estimate.
  int topview_cells = 0;
  double update_ms = 0.0;                ///< Whole update: load not included, topview included.
  std::optional<ParticleSet> particles;  ///< Absent where not recorded.
  std::optional<SemanticTopview> topview;
};

/// Writes a run as it happens: each step is one transaction of SQLite in WAL-free journal mode, so
/// that a run that is killed is readable up to its last step. The format and its tables are
/// described in core/run/README.md.
///
/// A run of the same name waits beside it as `NAME.earlier-PID` until finish(), stop() or discard()
/// says what becomes of the two. A writer that is destroyed before, or killed, leaves both.
class RunWriter {
 public:
  /// Whether create() would take this name: asked before long work begins. @errors as create().
  [[nodiscard]] static Result<void> check_output(const std::filesystem::path& path);
  /// @errors kIo: not writable, being written by another run, or there is a file of this name that is
  /// no run; kUnsupported: a run that a newer version wrote; kMalformed: an origin that is no place on
  /// Earth. What was there is then as it was.
  [[nodiscard]] static Result<RunWriter> create(const std::filesystem::path& path,
                                                const RunHeader& header);
  RunWriter(RunWriter&&) noexcept;
  ~RunWriter();
  /// Steps and times must rise. @errors kMalformed: names a value that RunReader would refuse; the
  /// writer can be used on. kIo.
  [[nodiscard]] Result<void> write(const RunStep& step);
  /// Takes over steps of another run file as they are stored there, with particles and topviews where it has them: the file
  /// of a run that goes on from a moment then holds the whole flight and compares with its parent over the same time.
  /// All or none. @param steps  As RunReader::steps() of `run` gives them, or the first of them.
  /// @errors as write(); kCancelled; those of reading `run`; kInvalidOptions: `run` is the file being written.
  [[nodiscard]] Result<void> copy_steps(const std::filesystem::path& run,
                                        std::span<const RunStep> steps,
                                        const WorkContext& context = {});
  /// Marks the run as complete. A run without this mark was killed or stopped. Takes the run before
  /// away, and what killed programs have put aside from this name; where there was none before, those
  /// stay, for one may be all that is left of somebody's work. @errors kIo: all is as it was.
  [[nodiscard]] Result<void> finish();
  /// Ends a run that was stopped before its end: its steps stay, without the mark. The run before stays
  /// too where it is complete or holds more steps, until a run of this name is complete; else it goes.
  /// @returns where the run before is; empty where there is none.
  [[nodiscard]] std::filesystem::path stop();
  /// Takes this run away and gives the run before its name back.
  void discard();

 private:
  struct Implementation;
  explicit RunWriter(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

/// Reads a run file, also one that is still being written or was killed.
class RunReader {
 public:
  /// @errors kNotFound, kMalformed (not a run file, truncated), kUnsupported ("was written by a
  /// newer version").
  [[nodiscard]] static Result<RunReader> open(const std::filesystem::path& path);
  RunReader(RunReader&&) noexcept;
  ~RunReader();
  [[nodiscard]] const RunHeader& header() const;
  [[nodiscard]] bool is_complete() const;
  [[nodiscard]] int step_count() const;
  /// All steps without particles and topviews. Times rise.
  /// @errors kMalformed: names table, row and column of a value that is missing or impossible, such
  /// as text for a number, a time that repeats or goes back, or a negative variance.
  [[nodiscard]] Result<std::vector<RunStep>> steps() const;
  /// The same of the steps whose number is `first` or more, for a run that has grown: the others are not read.
  [[nodiscard]] Result<std::vector<RunStep>> steps_from(int first) const;
  /// One step with its particles and topview where recorded.
  [[nodiscard]] Result<RunStep> step(int step) const;

 private:
  struct Implementation;
  explicit RunReader(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir
