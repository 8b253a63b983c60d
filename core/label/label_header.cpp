// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "core/label/label_schema.h"
#include "core/label/label_tables.h"

namespace nadir {
namespace {

/// The shortest text of the same double.
std::string number_text(double value) { return fmt::format("{}", value); }

std::optional<double> number_of(const std::map<std::string, std::string>& about, const char* key) {
  const auto found = about.find(key);
  if (found == about.end()) return std::nullopt;
  const char* const begin = found->second.data();
  const char* const end = begin + found->second.size();
  double value = 0.0;
  const auto [stopped, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return value;
}

Result<void> add_about(SqliteStatement& insert, std::string_view key, const std::string& value) {
  return insert.add(key).add(value).run();
}

bool is_count(double value) { return value >= 0.0 && value <= 1e9 && value == std::floor(value); }

}  // namespace

Result<void> create_tables(const SqliteDatabase& database,
                           const ProjectPlane& plane,
                           const LabelGrid& grid) {
  if (auto made = database.execute(std::string(kLabelSchema)); !made) return made;
  auto reference = database.prepare(
      "INSERT INTO gpkg_spatial_ref_sys VALUES ('Nadir project plane', ?, 'NONE', ?, ?, "
      "'Transverse Mercator with scale 1 at the middle of the map')");
  if (!reference) return forward_error(reference);
  const std::string wkt = plane.wkt();
  const auto number = std::int64_t{kPlaneSrsId};
  if (auto added = reference->add(number).add(number).add(wkt).run(); !added) return added;
  if (auto made = database.execute(std::string(kLabelContents)); !made) return made;
  auto about = database.prepare("INSERT INTO nadir_about (key, value) VALUES (?, ?)");
  if (!about) return forward_error(about);
  const std::map<std::string, std::string> facts{
      {"format", std::to_string(kLabelFormat)},
      {"plane_latitude_deg", number_text(plane.origin().latitude_deg)},
      {"plane_longitude_deg", number_text(plane.origin().longitude_deg)},
      {"metres_per_cell", number_text(grid.metres_per_cell)},
      {"left_in_enu_m", number_text(grid.top_left_in_enu_m.x())},
      {"top_in_enu_m", number_text(grid.top_left_in_enu_m.y())},
      {"width_cells", std::to_string(grid.width)},
      {"height_cells", std::to_string(grid.height)}};
  for (const auto& [key, value] : facts) {
    if (auto added = add_about(*about, key, value); !added) return added;
  }
  return database.execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}",
                                      kGeoPackageId, kGeoPackageVersion));
}

Result<LabelDocument> read_header(const SqliteDatabase& database, const std::string& name) {
  const auto tables =
      database.whole("SELECT count(*) FROM sqlite_schema WHERE name = 'nadir_about'");
  if (!tables) return forward_error(tables);
  if (*tables == 0) return fail(ErrorCode::kMalformed, "{}: is no labelling document", name);
  auto rows = database.prepare("SELECT key, value FROM nadir_about");
  if (!rows) return forward_error(rows);
  std::map<std::string, std::string> about;
  for (;;) {
    const auto row = rows->next();
    if (!row) return forward_error(row);
    if (!*row) break;
    about[rows->text(0)] = rows->text(1);
  }
  const auto format = number_of(about, "format");
  if (!format) return fail(ErrorCode::kMalformed, "{}: does not say its format", name);
  if (*format != static_cast<double>(kLabelFormat)) {
    return fail(ErrorCode::kUnsupported, "{}: is of label format {}, this program knows {}", name,
                *format, kLabelFormat);
  }
  const auto latitude_deg = number_of(about, "plane_latitude_deg");
  const auto longitude_deg = number_of(about, "plane_longitude_deg");
  const auto left = number_of(about, "left_in_enu_m");
  const auto top = number_of(about, "top_in_enu_m");
  const auto resolution = number_of(about, "metres_per_cell");
  const auto width = number_of(about, "width_cells");
  const auto height = number_of(about, "height_cells");
  if (!latitude_deg || !longitude_deg || !left || !top || !(resolution > 0.0) || !width ||
      !height || !is_count(*width) || !is_count(*height)) {
    return fail(ErrorCode::kMalformed, "{}: does not say where it lies", name);
  }
  const auto plane = ProjectPlane::create({*latitude_deg, *longitude_deg});
  if (!plane) return fail(ErrorCode::kMalformed, "{}: {}", name, plane.error().message);
  return LabelDocument(
      *plane, {*resolution, {*left, *top}, static_cast<int>(*width), static_cast<int>(*height)});
}

}  // namespace nadir
