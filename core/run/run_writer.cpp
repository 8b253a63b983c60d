// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <array>
#include <cmath>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/base/bystanders.h"
#include "core/base/require.h"
#include "core/eval/evaluated_step.h"
#include "core/run/run_blobs.h"
#include "core/run/run_file.h"
#include "core/run/run_lock.h"
#include "core/run/run_schema.h"
#include "core/run/sqlite_database.h"

namespace nadir {
namespace fs = std::filesystem;
using detail::RunLock;
using detail::SqliteAccess;
using detail::SqliteDatabase;
using detail::SqliteStatement;
using detail::SqliteTransaction;

namespace {

/// Empty files count as run files: a writer killed before its first transaction leaves one.
bool is_run_file(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  if (fs::file_size(path, error) == 0) return true;
  std::array<char, 72> head{};  // Read without SQLite, so that a damaged run can be replaced too.
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(head.data(), head.size())) return false;
  std::uint32_t id = 0;
  for (std::size_t i = 68; i < 72; ++i) id = id << 8U | static_cast<std::uint8_t>(head.at(i));
  return std::string_view(head.data(), 15) == "SQLite format 3" && id == detail::kRunApplicationId;
}

/// Runs that a program put aside as `NAME.earlier-PID` when it began a new one, and that nobody
/// brought back since it was killed. Where NAME is there, they were outlived by another run already.
/// Where it is not, one of them may be all that is left of somebody's work, so none is outdated.
std::vector<fs::path> outdated_runs(const fs::path& path) {
  constexpr std::string_view kEarlier = ".earlier-";
  std::error_code error;
  const bool was_there = fs::exists(path, error) || fs::exists(bystander_of(path, kEarlier), error);
  return was_there ? abandoned_bystanders(path, kEarlier) : std::vector<fs::path>();
}

Result<void> make_room(const fs::path& path) {
  const std::string name = path.string();
  if (path.empty()) return fail(ErrorCode::kInvalidOptions, "run file: its name is empty");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return fail(ErrorCode::kIo, "{}: folder {} does not exist", name, folder.string());
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    return fail(ErrorCode::kIo, "{}: folder {} is not writable", name, folder.string());
  }
  if (fs::is_directory(path, error))
    return fail(ErrorCode::kIo, "{}: is a folder, not a file", name);
  if (fs::exists(path, error) && !is_run_file(path)) {
    return fail(ErrorCode::kIo, "{}: exists and is not a run file, so it is left alone", name);
  }
  const auto old_run = RunLock::hold(path);
  if (!old_run) return forward_error(old_run);
  // The journal first: one that outlives its run would be rolled back into the new file.
  fs::remove(name + "-journal", error);
  if (!error) fs::remove(path, error);
  if (error) return fail(ErrorCode::kIo, "{}: {}", name, error.message());
  return {};
}

Result<void> write_about(const SqliteDatabase& database, const RunHeader& header) {
  std::map<std::string, std::string> about = {
      {"program_version", header.program_version},
      {"flight", header.flight},
      {"map", header.map},
      {"preset", header.preset},
      {"flight_path", header.flight_path},
      {"map_path", header.map_path},
      {"flight_hash", header.flight_hash},
      {"map_hash", header.map_hash},
      {"seed", std::to_string(header.seed)},
      {"plane_latitude_deg", fmt::format("{}", header.plane_latitude_deg)},
      {"plane_longitude_deg", fmt::format("{}", header.plane_longitude_deg)},
      {"is_complete", "0"}};
  for (const auto& [option, value] : header.options) about["option." + option] = value;
  auto insert = database.prepare("INSERT INTO about VALUES (?, ?)");
  if (!insert) return forward_error(insert);
  for (const auto& [key, value] : about) {
    const auto done = insert->add(std::string_view(key)).add(std::string_view(value)).next();
    if (!done) return forward_error(done);
  }
  return {};
}

/// Synchronous OFF: what a killed program has handed to the kernel survives, which is all that a
/// kill asks for; only a power failure could damage the last steps, and finish() waits for the
/// disk.
Result<SqliteDatabase> create_database(const fs::path& path, const RunHeader& header) {
  auto database = SqliteDatabase::open(path, path.string(), SqliteAccess::kCreate);
  if (!database) return database;
  for (const char* pragma : {"PRAGMA journal_mode = DELETE", "PRAGMA synchronous = OFF"}) {
    if (const auto set = database->execute(pragma); !set) return forward_error(set);
  }
  auto transaction = SqliteTransaction::begin(*database, "BEGIN IMMEDIATE");
  if (!transaction) return forward_error(transaction);
  const auto made = database->execute(
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}; {}",
                  detail::kRunApplicationId, detail::kRunFormatVersion, detail::kRunSchema));
  if (!made) return forward_error(made);
  if (const auto written = write_about(*database, header); !written) return forward_error(written);
  if (const auto committed = transaction->commit(); !committed) return forward_error(committed);
  return database;
}

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
  std::string name;
  RunLock lock;  ///< Outlives the connection: closing a file takes away the locks of SQLite.
  SqliteDatabase database;
  std::optional<SqliteStatement> insert_step, insert_mode, insert_particles, insert_topview;
  std::vector<fs::path> outdated;  ///< Gone when this run is complete.
  std::optional<double> last_time_s;

  [[nodiscard]] Result<void> prepare();
  [[nodiscard]] Result<void> check(const RunStep& step) const;
  [[nodiscard]] Result<void> write_numbers(const RunStep& step);
  [[nodiscard]] Result<void> write_modes(const RunStep& step);
  [[nodiscard]] Result<void> write_blobs(const RunStep& step);
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

Result<void> RunWriter::Implementation::check(const RunStep& step) const {
  if (!std::isfinite(step.time_s) || !is_finite(step.odom_from_body) ||
      (step.odometry_in_enu && !is_finite(*step.odometry_in_enu)) ||
      !is_finite(step.estimate.moments.mean) ||
      (step.truth_in_enu && !is_finite(*step.truth_in_enu))) {
    return fail(ErrorCode::kMalformed, "{}: step {} has a time or pose that is not finite", name,
                step.step);
  }
  if (last_time_s && step.time_s < *last_time_s) {
    return fail(ErrorCode::kMalformed, "{}: time goes back from {} s to {} s at step {}", name,
                *last_time_s, step.time_s, step.step);
  }
  if (last_time_s == step.time_s) {
    return fail(ErrorCode::kMalformed, "{}: time {} s of step {} is that of the step before", name,
                step.time_s, step.step);
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

RunWriter::RunWriter(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
RunWriter::RunWriter(RunWriter&&) noexcept = default;
RunWriter::~RunWriter() = default;

Result<RunWriter> RunWriter::create(const fs::path& path, const RunHeader& header) {
  const auto outdated = outdated_runs(path);
  if (const auto room = make_room(path); !room) return forward_error(room);
  auto lock = RunLock::make(path);
  if (!lock) return forward_error(lock);
  auto database = create_database(path, header);
  if (!database) {
    std::error_code ignored;
    fs::remove(path, ignored);
    fs::remove(path.string() + "-journal", ignored);
    return forward_error(database);
  }
  auto implementation = std::unique_ptr<Implementation>(new Implementation{
      path.string(), std::move(*lock), std::move(*database), {}, {}, {}, {}, outdated, {}});
  if (const auto prepared = implementation->prepare(); !prepared) return forward_error(prepared);
  return RunWriter(std::move(implementation));
}

Result<void> RunWriter::write(const RunStep& step) {
  Implementation& run = *implementation_;
  if (auto checked = run.check(step); !checked) return checked;
  auto transaction = SqliteTransaction::begin(run.database, "BEGIN IMMEDIATE");
  if (!transaction) return forward_error(transaction);
  auto written = run.write_numbers(step)
                     .and_then([&] { return run.write_modes(step); })
                     .and_then([&] { return run.write_blobs(step); })
                     .and_then([&] { return transaction->commit(); });
  if (written) run.last_time_s = step.time_s;
  return written;
}

Result<void> RunWriter::finish() {
  const SqliteDatabase& database = implementation_->database;
  auto finished = database.execute("PRAGMA synchronous = FULL").and_then([&] {
    return database.execute("UPDATE about SET value = '1' WHERE key = 'is_complete'");
  });
  if (!finished) return finished;
  std::error_code ignored;
  for (const fs::path& run : std::exchange(implementation_->outdated, {})) fs::remove(run, ignored);
  return {};
}

}  // namespace nadir
