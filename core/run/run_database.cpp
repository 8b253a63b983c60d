// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_database.h"

#include <cmath>
#include <map>
#include <string_view>
#include <system_error>

#include "core/run/earlier_run.h"
#include "core/run/run_limits.h"
#include "core/run/run_schema.h"

namespace nadir::detail {
namespace fs = std::filesystem;
namespace {

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
  if (!header.parent_run.empty()) about["parent_run"] = header.parent_run;
  if (header.started_at_s) about["started_at_s"] = fmt::format("{}", *header.started_at_s);
  for (const auto& [option, value] : header.options) about["option." + option] = value;
  auto insert = database.prepare("INSERT INTO about VALUES (?, ?)");
  if (!insert) return forward_error(insert);
  for (const auto& [key, value] : about) {
    const auto done = insert->add(std::string_view(key)).add(std::string_view(value)).next();
    if (!done) return forward_error(done);
  }
  return {};
}

constexpr SqliteFileKind kRunFile{
    .if_not_one = "is not a run file", .patience_ms = 10'000, .most_value_bytes = 256 << 20};

}  // namespace

Result<SqliteDatabase> open_run_database(const fs::path& path,
                                         const std::string& name,
                                         SqliteAccess access) {
  return SqliteDatabase::open(path, name, kRunFile, access);
}

Result<void> check_header(const RunHeader& header, const std::string& name) {
  if (header.started_at_s && !std::isfinite(*header.started_at_s)) {
    return fail(ErrorCode::kMalformed, "{}: the time at which it goes on, {} s, is no time", name,
                *header.started_at_s);
  }
  if (std::abs(header.plane_latitude_deg) <= kLargestLatitudeDeg &&
      std::abs(header.plane_longitude_deg) <= kLargestLongitudeDeg) {
    return {};
  }
  return fail(ErrorCode::kMalformed,
              "{}: the origin of its plane, latitude {} longitude {}, is no place on Earth", name,
              header.plane_latitude_deg, header.plane_longitude_deg);
}

/// Synchronous OFF: what a killed program has handed to the kernel survives, which is all that a
/// kill asks for; only a power failure could damage the last steps, and finish() waits for the
/// disk.
Result<SqliteDatabase> create_run_database(const fs::path& path, const RunHeader& header) {
  std::error_code error;
  fs::remove(journal_of(path), error);
  if (error) return fail(ErrorCode::kIo, "{}: {}", path.string(), error.message());
  auto database = open_run_database(path, path.string(), SqliteAccess::kCreate);
  if (!database) return database;
  for (const char* pragma : {"PRAGMA journal_mode = DELETE", "PRAGMA synchronous = OFF"}) {
    if (const auto set = database->execute(pragma); !set) return forward_error(set);
  }
  auto transaction = SqliteTransaction::begin(*database, "BEGIN IMMEDIATE");
  if (!transaction) return forward_error(transaction);
  const auto made =
      database->execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}; {}",
                                    kRunApplicationId, kRunFormatVersion, kRunSchema));
  if (!made) return forward_error(made);
  if (const auto written = write_about(*database, header); !written) return forward_error(written);
  if (const auto committed = transaction->commit(); !committed) return forward_error(committed);
  return database;
}

}  // namespace nadir::detail
