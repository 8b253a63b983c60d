// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "core/eval/evaluated_step.h"
#include "core/run/run_blobs.h"
#include "core/run/run_connection.h"
#include "core/run/run_file.h"
#include "core/run/run_schema.h"

namespace nadir {
using detail::RunConnection;
using detail::SqliteDatabase;
using detail::SqliteStatement;
using detail::SqliteTransaction;

namespace {

constexpr int kMostAboutRows = 10'000;

Rigid2 pose_at(const SqliteStatement& row, int column) {
  return {row.number(column), row.number(column + 1), row.number(column + 2)};
}

PoseMoments moments_at(const SqliteStatement& row, int column) {
  PoseMoments moments{.mean = pose_at(row, column)};
  int next = column + 3;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      moments.covariance(i, j) = row.number(next++);
      moments.covariance(j, i) = moments.covariance(i, j);
    }
  }
  return moments;
}

bool fits_int(std::int64_t value) { return value >= 0 && value <= std::numeric_limits<int>::max(); }

/// Reads one row of kStepColumns.
Result<RunStep> step_from(const SqliteStatement& row, const std::string& name) {
  const std::int64_t number = row.whole(0);
  RunStep step;
  step.time_s = row.number(1);
  step.odom_from_body = pose_at(row, 2);
  step.odometry_in_enu = pose_at(row, 5);
  if (!row.is_null(8)) step.truth_in_enu = pose_at(row, 8);
  step.estimate.moments = moments_at(row, 11);
  step.effective_sample_size = row.number(20);
  if (!row.is_null(23)) step.agreement = row.number(23);
  step.was_resampled = row.whole(22) != 0;
  step.update_ms = row.number(25);
  const bool counts_fit = fits_int(number) && fits_int(row.whole(21)) && fits_int(row.whole(24));
  if (!counts_fit || !std::isfinite(step.time_s) || !is_finite(step.odom_from_body) ||
      !is_finite(step.odometry_in_enu) || !is_finite(step.estimate.moments.mean) ||
      (step.truth_in_enu && !is_finite(*step.truth_in_enu))) {
    return fail(ErrorCode::kMalformed, "{}: step {} is damaged (a value is missing or no number)",
                name, number);
  }
  step.step = static_cast<int>(number);
  step.particle_count = static_cast<int>(row.whole(21));
  step.topview_cells = static_cast<int>(row.whole(24));
  return step;
}

template <typename Number>
Number number_from(const std::map<std::string, std::string>& about, const std::string& key) {
  Number value{};
  const auto found = about.find(key);
  if (found != about.end()) {
    const char* begin = found->second.data();
    std::from_chars(begin, begin + found->second.size(), value);
  }
  return value;
}

RunHeader header_from(std::map<std::string, std::string> about) {
  RunHeader header;
  header.program_version = about["program_version"];
  header.flight = about["flight"];
  header.map = about["map"];
  header.preset = about["preset"];
  header.flight_path = about["flight_path"];
  header.map_path = about["map_path"];
  header.flight_hash = about["flight_hash"];
  header.map_hash = about["map_hash"];
  header.seed = number_from<std::uint64_t>(about, "seed");
  header.plane_latitude_deg = number_from<double>(about, "plane_latitude_deg");
  header.plane_longitude_deg = number_from<double>(about, "plane_longitude_deg");
  for (const auto& [key, value] : about) {
    if (key.starts_with("option.")) header.options[key.substr(7)] = value;
  }
  return header;
}

Result<RunHeader> read_header(const SqliteDatabase& database, const std::string& name) {
  auto rows = database.prepare("SELECT key, value FROM about");
  if (!rows) return forward_error(rows);
  std::map<std::string, std::string> about;
  for (int count = 0;; ++count) {
    const auto row = rows->next();
    if (!row) return forward_error(row);
    if (!*row) break;
    if (count == kMostAboutRows) {
      return fail(ErrorCode::kMalformed, "{}: is damaged (table about does not end)", name);
    }
    about[rows->text(0)] = rows->text(1);
  }
  return header_from(std::move(about));
}

/// Rows must rise in step, which also ends the walk through a damaged tree that leads in a circle.
Result<std::vector<RunStep>> read_steps(const SqliteDatabase& database, const std::string& name) {
  auto rows =
      database.prepare(fmt::format("SELECT {} FROM step ORDER BY step", detail::kStepColumns));
  if (!rows) return forward_error(rows);
  std::vector<RunStep> steps;
  for (;;) {
    const auto row = rows->next();
    if (!row) return forward_error(row);
    if (!*row) break;
    auto step = step_from(*rows, name);
    if (!step) return forward_error(step);
    if (!steps.empty() && step->step <= steps.back().step) {
      return fail(ErrorCode::kMalformed, "{}: is damaged (step {} comes twice)", name, step->step);
    }
    steps.push_back(std::move(*step));
  }
  return steps;
}

/// Adds the modes that `rows` gives to `steps`, both in order of step.
Result<void> add_modes(std::span<RunStep> steps, SqliteStatement& rows, const std::string& name) {
  std::pair<std::int64_t, std::int64_t> last{-1, -1};
  auto step = steps.begin();
  for (;;) {
    const auto row = rows.next();
    if (!row) return forward_error(row);
    if (!*row) return {};
    const std::pair key{rows.whole(0), rows.whole(1)};
    const PoseMode mode{.mass = rows.number(2), .moments = moments_at(rows, 3)};
    while (step != steps.end() && step->step < key.first) ++step;
    if (key <= last || step == steps.end() || step->step != key.first ||
        !is_finite(mode.moments.mean)) {
      return fail(ErrorCode::kMalformed, "{}: is damaged (a mode of step {} does not fit)", name,
                  key.first);
    }
    last = key;
    step->estimate.modes.push_back(mode);
  }
}

Result<void> add_particles(RunStep& step, const SqliteDatabase& database, const std::string& name) {
  auto rows = database.prepare("SELECT count, data FROM particles WHERE step = ?");
  if (!rows) return forward_error(rows);
  const auto row = rows->add(std::int64_t{step.step}).next();
  if (!row) return forward_error(row);
  if (!*row) return {};
  auto particles =
      detail::decode_particles(rows->blob(1), rows->whole(0), step.estimate.moments.mean);
  if (!particles) {
    return forward_error(particles, fmt::format("{}: particles of step {}", name, step.step));
  }
  step.particles = std::move(*particles);
  return {};
}

Result<void> add_topview(RunStep& step, const SqliteDatabase& database, const std::string& name) {
  auto rows = database.prepare("SELECT metres_per_cell, count, data FROM topview WHERE step = ?");
  if (!rows) return forward_error(rows);
  const auto row = rows->add(std::int64_t{step.step}).next();
  if (!row) return forward_error(row);
  if (!*row) return {};
  auto topview = detail::decode_topview(rows->blob(2), rows->whole(1), rows->number(0));
  if (!topview)
    return forward_error(topview, fmt::format("{}: topview of step {}", name, step.step));
  step.topview = std::move(*topview);
  return {};
}

}  // namespace

struct RunReader::Implementation {
  std::string name;
  mutable RunConnection connection;  ///< Reopened where a killed writer left a journal.
  RunHeader header;
};

RunReader::RunReader(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
RunReader::RunReader(RunReader&&) noexcept = default;
RunReader::~RunReader() = default;

Result<RunReader> RunReader::open(const std::filesystem::path& path) {
  auto connection = RunConnection::open(path);
  if (!connection) return forward_error(connection);
  auto header = read_header(connection->database(), path.string());
  if (!header) return forward_error(header);
  return RunReader(std::unique_ptr<Implementation>(
      new Implementation{path.string(), std::move(*connection), std::move(*header)}));
}

const RunHeader& RunReader::header() const { return implementation_->header; }

bool RunReader::is_complete() const {
  const auto mark = implementation_->connection.read([](const SqliteDatabase& database) {
    return database.whole("SELECT value = '1' FROM about WHERE key = 'is_complete'");
  });
  return mark && *mark != 0;
}

int RunReader::step_count() const {
  const auto count =
      implementation_->connection.read([](const SqliteDatabase& database) -> Result<int> {
        auto rows = database.prepare("SELECT step FROM step ORDER BY step");
        if (!rows) return forward_error(rows);
        int counted = 0;
        std::int64_t last = -1;
        for (auto row = rows->next(); row && *row && rows->whole(0) > last; row = rows->next()) {
          last = rows->whole(0);
          ++counted;
        }
        return counted;
      });
  return count.value_or(0);
}

Result<std::vector<RunStep>> RunReader::steps() const {
  const std::string& name = implementation_->name;
  auto steps = implementation_->connection.read(
      [&](const SqliteDatabase& database) -> Result<std::vector<RunStep>> {
        auto numbers = read_steps(database, name);
        if (!numbers) return numbers;
        auto rows = database.prepare(
            fmt::format("SELECT {} FROM mode ORDER BY step, rank", detail::kModeColumns));
        if (!rows) return forward_error(rows);
        if (const auto added = add_modes(*numbers, *rows, name); !added)
          return forward_error(added);
        return numbers;
      });
  if (steps) {
    std::stable_sort(steps->begin(), steps->end(),
                     [](const RunStep& a, const RunStep& b) { return a.time_s < b.time_s; });
  }
  return steps;
}

Result<RunStep> RunReader::step(int number) const {
  const std::string& name = implementation_->name;
  return implementation_->connection.read([&](const SqliteDatabase& database) -> Result<RunStep> {
    auto rows =
        database.prepare(fmt::format("SELECT {} FROM step WHERE step = ?", detail::kStepColumns));
    if (!rows) return forward_error(rows);
    const auto row = rows->add(std::int64_t{number}).next();
    if (!row) return forward_error(row);
    if (!*row) return fail(ErrorCode::kNotFound, "{}: holds no step {}", name, number);
    auto step = step_from(*rows, name);
    if (!step) return step;
    auto modes = database.prepare(
        fmt::format("SELECT {} FROM mode WHERE step = ? ORDER BY rank", detail::kModeColumns));
    if (!modes) return forward_error(modes);
    modes->add(std::int64_t{number});
    const auto added = add_modes(std::span(&*step, 1), *modes, name)
                           .and_then([&] { return add_particles(*step, database, name); })
                           .and_then([&] { return add_topview(*step, database, name); });
    if (!added) return forward_error(added);
    return step;
  });
}

}  // namespace nadir
