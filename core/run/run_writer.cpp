// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>

#include "core/base/require.h"
#include "core/run/copied_blobs.h"
#include "core/run/earlier_run.h"
#include "core/run/run_blobs.h"
#include "core/run/run_database.h"
#include "core/run/run_file.h"
#include "core/run/run_limits.h"
#include "core/run/run_lock.h"
#include "core/run/run_schema.h"

namespace nadir {
namespace fs = std::filesystem;
using detail::EarlierRun;
using detail::RunLock;

namespace {

std::string insert_into(std::string_view table, std::string_view columns) {
  std::string marks = "?";
  for (const char letter : columns) {
    if (letter == ',') marks += ", ?";
  }
  return fmt::format("INSERT INTO {} ({}) VALUES ({})", table, columns, marks);
}

void add_pose(SqliteStatement& statement, const Rigid2& pose) {
  statement.add(pose.x_m).add(pose.y_m).add(pose.yaw_rad);
}

void add_moments(SqliteStatement& statement, const PoseMoments& moments) {
  add_pose(statement, moments.mean);
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) statement.add(moments.covariance(row, column));
  }
}

}  // namespace

struct RunWriter::Implementation {
  fs::path path;
  std::string name;  ///< The path in messages.
  EarlierRun earlier;
  RunLock lock;  ///< Outlives the connection: closing a file takes away the locks of SQLite.
  SqliteDatabase database;
  std::optional<SqliteStatement> insert_step, insert_mode, insert_particles, insert_topview;
  struct Progress {
    int steps_written = 0, last_step = 0;
    double last_time_s = 0.0;
  } progress;

  [[nodiscard]] Result<void> prepare();
  [[nodiscard]] Result<void> check(const RunStep& step) const;
  [[nodiscard]] Result<void> write_numbers(const RunStep& step);
  [[nodiscard]] Result<void> write_modes(const RunStep& step);
  [[nodiscard]] Result<void> write_blobs(const RunStep& step);
  void close();
  void discard();
};

Result<void> RunWriter::Implementation::prepare() {
  const auto make = [&](std::optional<SqliteStatement>& statement,
                        const std::string& sql) -> Result<void> {
    auto prepared = database.prepare(sql);
    if (!prepared) return forward_error(prepared);
    statement.emplace(std::move(*prepared));
    return {};
  };
  return make(insert_step, insert_into("step", detail::kStepColumns))
      .and_then([&] { return make(insert_mode, insert_into("mode", detail::kModeColumns)); })
      .and_then(
          [&] { return make(insert_particles, insert_into("particles", "step, count, data")); })
      .and_then([&] {
        return make(insert_topview, insert_into("topview", "step, metres_per_cell, count, data"));
      });
}

/// Refuses whatever a reader of the file would refuse. What blobs hold is checked as they are made.
Result<void> RunWriter::Implementation::check(const RunStep& step) const {
  if (const auto fault = detail::fault_of(step)) {
    return fail(ErrorCode::kMalformed, "{}: step {}: {}", name, step.step,
                detail::fault_text(*fault, detail::kStepColumns));
  }
  for (std::size_t rank = 0; rank < step.estimate.modes.size(); ++rank) {
    if (const auto fault = detail::fault_of(step.estimate.modes[rank])) {
      return fail(ErrorCode::kMalformed, "{}: step {}, mode of rank {}: {}", name, step.step, rank,
                  detail::fault_text(*fault, detail::kModeColumns));
    }
  }
  const auto& [steps_written, last_step, last_time_s] = progress;
  if (steps_written == 0) return {};
  if (step.time_s < last_time_s) {
    return fail(ErrorCode::kMalformed, "{}: time goes back from {} s to {} s at step {}", name,
                last_time_s, step.time_s, step.step);
  }
  if (step.time_s == last_time_s) {
    return fail(ErrorCode::kMalformed, "{}: time {} s of step {} is that of the step before", name,
                step.time_s, step.step);
  }
  if (step.step <= last_step) {
    return fail(ErrorCode::kMalformed, "{}: step {} comes after step {}", name, step.step,
                last_step);
  }
  return {};
}

Result<void> RunWriter::Implementation::write_numbers(const RunStep& step) {
  SqliteStatement& insert = *insert_step;
  insert.add(std::int64_t{step.step}).add(step.time_s);
  add_pose(insert, step.odom_from_body);
  const Rigid2 unknown{std::nan(""), std::nan(""), std::nan("")};
  add_pose(insert, step.odometry_in_enu.value_or(unknown));
  add_pose(insert, step.truth_in_enu.value_or(unknown));
  add_moments(insert, step.estimate.moments);
  insert.add(step.effective_sample_size)
      .add(std::int64_t{step.particle_count})
      .add(std::int64_t{step.was_resampled ? 1 : 0})
      .add(step.agreement)
      .add(std::int64_t{step.topview_cells})
      .add(step.update_ms);
  if (const auto done = insert.next(); !done) return forward_error(done);
  return {};
}

Result<void> RunWriter::Implementation::write_modes(const RunStep& step) {
  std::int64_t rank = 0;
  for (const PoseMode& mode : step.estimate.modes) {
    insert_mode->add(std::int64_t{step.step}).add(rank++).add(mode.mass);
    add_moments(*insert_mode, mode.moments);
    if (const auto done = insert_mode->next(); !done) return forward_error(done);
  }
  return {};
}

Result<void> RunWriter::Implementation::write_blobs(const RunStep& step) {
  const std::int64_t number = step.step;
  if (step.particles) {
    const auto blob = detail::encode_particles(*step.particles, step.estimate.moments.mean);
    if (!blob) return forward_error(blob, fmt::format("{}: particles of step {}", name, number));
    insert_particles->add(number).add(static_cast<std::int64_t>(step.particles->size()));
    const auto done = insert_particles->add(std::span(*blob)).next();
    if (!done) return forward_error(done);
  }
  if (step.topview) {
    const auto blob = detail::encode_topview(*step.topview);
    if (!blob) return forward_error(blob, fmt::format("{}: topview of step {}", name, number));
    insert_topview->add(number)
        .add(step.topview->metres_per_cell)
        .add(static_cast<std::int64_t>(step.topview->cells.size()));
    const auto done = insert_topview->add(std::span(*blob)).next();
    if (!done) return forward_error(done);
  }
  return {};
}

void RunWriter::Implementation::close() {
  for (auto* statement : {&insert_step, &insert_mode, &insert_particles, &insert_topview}) {
    statement->reset();
  }
  const SqliteDatabase closed = std::move(database);
}

void RunWriter::Implementation::discard() {
  close();
  detail::remove_run(path);
  earlier.bring_back();
}

RunWriter::RunWriter(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
RunWriter::RunWriter(RunWriter&&) noexcept = default;
RunWriter::~RunWriter() = default;

Result<void> RunWriter::check_output(const fs::path& path) {
  return detail::check_run_output(path);
}

Result<RunWriter> RunWriter::create(const fs::path& path, const RunHeader& header) {
  if (const auto checked = detail::check_header(header, path.string()); !checked) {
    return forward_error(checked);
  }
  auto earlier = EarlierRun::put_aside(path);
  if (!earlier) return forward_error(earlier);
  auto lock = RunLock::make(path);
  if (!lock) {
    earlier->bring_back();
    return forward_error(lock);
  }
  auto database = detail::create_run_database(path, header);
  if (!database) {
    detail::remove_run(path);
    earlier->bring_back();
    return forward_error(database);
  }
  auto implementation = std::unique_ptr<Implementation>(new Implementation{path,
                                                                           path.string(),
                                                                           std::move(*earlier),
                                                                           std::move(*lock),
                                                                           std::move(*database),
                                                                           {},
                                                                           {},
                                                                           {},
                                                                           {},
                                                                           {}});
  if (const auto prepared = implementation->prepare(); !prepared) {
    implementation->discard();
    return forward_error(prepared);
  }
  return RunWriter(std::move(implementation));
}

Result<void> RunWriter::write(const RunStep& step) {
  NADIR_REQUIRE(implementation_ != nullptr);
  Implementation& run = *implementation_;
  if (auto checked = run.check(step); !checked) return checked;
  auto transaction = SqliteTransaction::begin(run.database, "BEGIN IMMEDIATE");
  if (!transaction) return forward_error(transaction);
  auto written = run.write_numbers(step)
                     .and_then([&] { return run.write_modes(step); })
                     .and_then([&] { return run.write_blobs(step); })
                     .and_then([&] { return transaction->commit(); });
  if (!written) return written;
  run.progress = {run.progress.steps_written + 1, step.step, step.time_s};
  return {};
}

Result<void> RunWriter::copy_steps(const fs::path& path,
                                   std::span<const RunStep> steps,
                                   const WorkContext& context) {
  NADIR_REQUIRE(implementation_ != nullptr);
  Implementation& run = *implementation_;
  std::error_code error;
  if (fs::equivalent(path, run.path, error)) {
    return fail(ErrorCode::kInvalidOptions, "{}: cannot go on from itself", run.name);
  }
  const Implementation::Progress before = run.progress;
  auto copied = [&]() -> Result<void> {
    auto transaction = SqliteTransaction::begin(run.database, "BEGIN IMMEDIATE");
    if (!transaction) return forward_error(transaction);
    for (const RunStep& step : steps) {
      auto written =
          run.check(step).and_then([&] { return run.write_numbers(step); }).and_then([&] {
            return run.write_modes(step);
          });
      if (!written) return written;
      run.progress = {run.progress.steps_written + 1, step.step, step.time_s};
    }
    return detail::copy_blobs(path, run.database, steps, context).and_then([&] {
      return transaction->commit();
    });
  }();
  if (!copied) run.progress = before;
  return copied;
}

Result<void> RunWriter::finish() {
  NADIR_REQUIRE(implementation_ != nullptr);
  const SqliteDatabase& database = implementation_->database;
  auto finished = database.execute("PRAGMA synchronous = FULL").and_then([&] {
    return database.execute("UPDATE about SET value = '1' WHERE key = 'is_complete'");
  });
  if (finished) implementation_->earlier.remove_with_abandoned();
  return finished;
}

fs::path RunWriter::stop() {
  NADIR_REQUIRE(implementation_ != nullptr);
  const std::unique_ptr<Implementation> run = std::move(implementation_);
  if (!run->earlier.is_worth_more_than(run->progress.steps_written)) run->earlier.remove();
  return run->earlier.path();
}

void RunWriter::discard() {
  NADIR_REQUIRE(implementation_ != nullptr);
  const std::unique_ptr<Implementation> run = std::move(implementation_);
  run->discard();
}

}  // namespace nadir
