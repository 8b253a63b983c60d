// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "core/run/run_blobs.h"
#include "core/run/run_connection.h"
#include "core/run/run_file.h"
#include "core/run/run_limits.h"
#include "core/run/run_row.h"
#include "core/run/run_schema.h"

namespace nadir {
using detail::RunConnection;
using detail::RunRow;

namespace {

constexpr int kMostAboutRows = 10'000;

/// Reads one row of kStepColumns.
Result<RunStep> step_from(const SqliteStatement& row, const std::string& name) {
  RunRow values(row, fmt::format("{}: table step, row {}", name, row.whole(0)));
  RunStep step;
  step.step = values.count(0);
  step.time_s = values.number(1);
  step.odom_from_body = values.pose(2);
  step.odometry_in_enu = values.pose_if_known(5);
  step.truth_in_enu = values.pose_if_known(8);
  step.estimate.moments = values.moments(11);
  step.effective_sample_size = values.number(20);
  step.particle_count = values.count(21);
  step.was_resampled = values.count(22) != 0;
  const double agreement = values.number(23);
  if (!std::isnan(agreement)) step.agreement = agreement;
  step.topview_cells = values.count(24);
  step.update_ms = values.number(25);
  if (const auto checked = values.checked(detail::fault_of(step)); !checked) {
    return forward_error(checked);
  }
  return step;
}

/// Reads a number of table `about`; one that is missing stays as it is. @errors kMalformed.
template <typename Number>
Result<void> take_number(const std::map<std::string, std::string>& about,
                         const std::string& key,
                         const std::string& name,
                         Number least,
                         Number largest,
                         Number& into) {
  const auto found = about.find(key);
  if (found == about.end()) return {};
  const std::string& text = found->second;
  const char* last = text.data() + text.size();
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last || !(value >= least && value <= largest)) {
    return fail(ErrorCode::kMalformed, "{}: table about, row {}: {} is no number from {} to {}",
                name, key, text.empty() ? "an empty text" : text.substr(0, 40), least, largest);
  }
  into = value;
  return {};
}

Result<RunHeader> header_from(std::map<std::string, std::string> about, const std::string& name) {
  RunHeader header;
  header.program_version = about["program_version"];
  header.flight = about["flight"];
  header.map = about["map"];
  header.preset = about["preset"];
  header.flight_path = about["flight_path"];
  header.map_path = about["map_path"];
  header.flight_hash = about["flight_hash"];
  header.map_hash = about["map_hash"];
  constexpr std::uint64_t kLargestSeed = std::numeric_limits<std::uint64_t>::max();
  const auto taken =
      take_number<std::uint64_t>(about, "seed", name, 0, kLargestSeed, header.seed)
          .and_then([&] {
            return take_number(about, "plane_latitude_deg", name, -detail::kLargestLatitudeDeg,
                               detail::kLargestLatitudeDeg, header.plane_latitude_deg);
          })
          .and_then([&] {
            return take_number(about, "plane_longitude_deg", name, -detail::kLargestLongitudeDeg,
                               detail::kLargestLongitudeDeg, header.plane_longitude_deg);
          });
  if (!taken) return forward_error(taken);
  header.parent_run = about["parent_run"];
  if (about.contains("started_at_s")) {
    constexpr double kAnyTime = std::numeric_limits<double>::max();
    const auto time = take_number(about, "started_at_s", name, -kAnyTime, kAnyTime,
                                  header.started_at_s.emplace());
    if (!time) return forward_error(time);
  }
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
  return header_from(std::move(about), name);
}

/// Rows must rise in step, which also ends the walk through a damaged tree that leads in a circle,
/// and in time. @param first  Rows below are left out.
Result<std::vector<RunStep>> read_steps(const SqliteDatabase& database,
                                        const std::string& name,
                                        std::int64_t first) {
  auto rows = database.prepare(
      fmt::format("SELECT {} FROM step WHERE step >= ? ORDER BY step", detail::kStepColumns));
  if (!rows) return forward_error(rows);
  rows->add(first);
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
    if (!steps.empty() && !(step->time_s > steps.back().time_s)) {
      return fail(ErrorCode::kMalformed,
                  "{}: table step, row {}: time_s is {}, not after the {} of row {}", name,
                  step->step, step->time_s, steps.back().time_s, steps.back().step);
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
    const std::string where =
        fmt::format("{}: table mode, row of step {} and rank {}", name, key.first, key.second);
    while (step != steps.end() && step->step < key.first) ++step;
    if (key <= last || step == steps.end() || step->step != key.first) {
      return fail(ErrorCode::kMalformed, "{}: belongs to no step or comes twice", where);
    }
    RunRow values(rows, where);
    const PoseMode mode{.mass = values.number(2), .moments = values.moments(3)};
    if (const auto checked = values.checked(detail::fault_of(mode)); !checked) {
      return forward_error(checked);
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

  [[nodiscard]] Result<std::vector<RunStep>> steps_from(std::int64_t first) const {
    return connection.read([&](const SqliteDatabase& database) -> Result<std::vector<RunStep>> {
      auto numbers = read_steps(database, name, first);
      if (!numbers) return numbers;
      auto rows = database.prepare(fmt::format(
          "SELECT {} FROM mode WHERE step >= ? ORDER BY step, rank", detail::kModeColumns));
      if (!rows) return forward_error(rows);
      rows->add(first);
      if (const auto added = add_modes(*numbers, *rows, name); !added) return forward_error(added);
      return numbers;
    });
  }
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
  return implementation_->steps_from(std::numeric_limits<std::int64_t>::min());
}

Result<std::vector<RunStep>> RunReader::steps_from(int first) const {
  return implementation_->steps_from(first);
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
