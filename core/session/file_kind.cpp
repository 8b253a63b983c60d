// SPDX-License-Identifier: Apache-2.0
#include "core/session/file_kind.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "core/base/settings.h"
#include "core/flight/flight_formats.h"
#include "core/run/run_schema.h"
#include "core/session/file_looks.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

std::string lower_case_ending(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

/// The first bytes of a file; empty where it cannot be read.
std::string beginning_of(const fs::path& path, std::size_t most_bytes) {
  std::string begin(most_bytes, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  return begin;
}

bool begins_like_sqlite(const fs::path& path) {
  constexpr std::string_view kMagic = "SQLite format 3";
  return beginning_of(path, kMagic.size()) == kMagic;
}

/// Those of Nadir carry their recipe before their pixels or lines.
bool carries_recipe(const fs::path& path) {
  constexpr std::size_t kFarEnough = 8192;
  return beginning_of(path, kFarEnough).find("Drawn by Nadir") != std::string::npos;
}

/// Whether it is something that labels are drawn on: PNG and JPEG where a file beside them says where they lie.
bool is_labelled_or_image(const fs::path& path) {
  const std::string ending = lower_case_ending(path);
  if (ending == ".gpkg" || ending == ".tif" || ending == ".tiff" || ending == ".mbtiles")
    return true;
  if (ending != ".png" && ending != ".jpg" && ending != ".jpeg") return false;
  std::error_code error;
  fs::path beside = path;
  for (const char* const world : {".pgw", ".pngw", ".jgw", ".jpgw", ".jpegw", ".wld"}) {
    if (fs::exists(beside.replace_extension(world), error)) return true;
  }
  return fs::exists(path.string() + ".aux.xml", error);
}

constexpr std::string_view kWhatOpens =
    "Nadir opens runs, flights, maps, overhead images, labels, recipes and figures that it has "
    "drawn";

/// Of a database with a header of its own: every SQLite file holds there whose it is.
bool is_foreign_database(const fs::path& path) {
  constexpr std::size_t kIdAt = 68;
  constexpr std::size_t kIdBytes = 4;
  const std::string header = beginning_of(path, kIdAt + kIdBytes);
  if (header.size() < kIdAt + kIdBytes)
    return false;  // what is wrong with it is said by its reader
  std::uint32_t id = 0;
  for (std::size_t i = kIdAt; i < header.size(); ++i) {
    id = (id << 8U) | static_cast<unsigned char>(header[i]);
  }
  return id != static_cast<std::uint32_t>(detail::kRunApplicationId);
}

bool is_flight_folder(const fs::path& folder) {
  return is_native_flight(folder) || is_kitti_raw_flight(folder) ||
         is_kitti_odometry_flight(folder);
}

Result<FileKind> kind_of_toml(const fs::path& path) {
  std::error_code error;
  if (fs::file_size(path, error) > kMostRecipeBytes) {
    return fail(ErrorCode::kUnsupported, "{}: is too large for a recipe", path.string());
  }
  const auto settings = Settings::read(path);
  if (!settings) return forward_error(settings);
  if (settings->has("figure")) return FileKind::kFigureRecipe;
  if (settings->has("preset") || settings->has("options")) return FileKind::kRunRecipe;
  return fail(ErrorCode::kUnsupported,
              "{}: is no recipe: it names neither a figure nor a preset or options", path.string());
}

/// Name of the first run in a folder by the alphabet; empty: none, or the folder is too large to look.
std::string first_run_in(const fs::path& folder) {
  constexpr int kMostEntries = 1000;
  std::error_code error;
  std::string first;
  int seen = 0;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (++seen > kMostEntries) return {};
    const fs::path& found = entry->path();
    if (found.extension() != ".nadir" || !begins_like_sqlite(found)) continue;
    if (first.empty() || found.filename().string() < first) first = found.filename().string();
  }
  return first;
}

}  // namespace

Result<FileToOpen> file_to_open(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    return fail(ErrorCode::kNotFound, "{}: does not exist", path.string());
  }
  if (fs::is_directory(path, error)) {
    if (fs::exists(path / "map.toml", error)) return FileToOpen{FileKind::kMap, path};
    if (is_flight_folder(path)) return FileToOpen{FileKind::kFlight, path};
    if (const std::string run = first_run_in(path); !run.empty()) {
      return fail(ErrorCode::kUnsupported, "{}: is a folder with a run in it; open {}",
                  path.string(), (path / run).string());
    }
    return fail(ErrorCode::kUnsupported,
                "{}: is a folder that holds neither a map nor a flight (no map.toml, flight.toml "
                "or KITTI files); {}",
                path.string(), kWhatOpens);
  }
  if (!std::ifstream(path)) {
    return fail(ErrorCode::kIo, "{}: cannot be read: {}", path.string(),
                std::generic_category().message(errno));
  }
  if (path.filename() == "map.toml") return FileToOpen{FileKind::kMap, path.parent_path()};
  if (path.filename() == "flight.toml") return FileToOpen{FileKind::kFlight, path.parent_path()};
  if (is_labelled_or_image(path) && !carries_recipe(path)) {
    return FileToOpen{FileKind::kLabels, path};
  }
  if (begins_like_sqlite(path)) {
    if (!is_foreign_database(path)) return FileToOpen{FileKind::kRun, path};
    return fail(ErrorCode::kUnsupported, "{}: is an SQLite database, but no run; {}", path.string(),
                kWhatOpens);
  }
  const std::string ending = lower_case_ending(path);
  if (ending == ".nadir") {
    return fail(ErrorCode::kMalformed, "{}: is not a run file, for it is {}; {}", path.string(),
                looks_of_file(path), kWhatOpens);
  }
  if (ending == ".toml") {
    const auto kind = kind_of_toml(path);
    if (!kind) return forward_error(kind);
    return FileToOpen{*kind, path};
  }
  if (ending == ".png" || ending == ".svg") return FileToOpen{FileKind::kFigure, path};
  if (ending == ".pdf" || ending == ".mp4") {
    return fail(ErrorCode::kUnsupported, "{}: only PNG and SVG figures carry what they show",
                path.string());
  }
  if (is_trajectory_file(path)) return FileToOpen{FileKind::kFlight, path};
  const std::string looks = looks_of_file(path);
  return fail(
      ErrorCode::kUnsupported, "{}: is {}{}; {}", path.string(), looks,
      looks == "a text" ? " whose first line is no pose of a trajectory (8 or 12 numbers)" : "",
      kWhatOpens);
}

FileKind kind_at_a_glance(const fs::path& path, bool is_folder) {
  std::error_code error;
  if (is_folder) {
    if (fs::exists(path / "map.toml", error)) return FileKind::kMap;
    return is_flight_folder(path) ? FileKind::kFlight : FileKind::kFolder;
  }
  const std::string ending = lower_case_ending(path);
  if (ending == ".nadir") return FileKind::kRun;
  if (ending == ".toml") return kind_of_toml(path).value_or(FileKind::kOther);
  if (is_labelled_or_image(path) && !carries_recipe(path)) return FileKind::kLabels;
  if (ending == ".png" || ending == ".svg") {
    return carries_recipe(path) ? FileKind::kFigure : FileKind::kOther;
  }
  if (ending == ".txt" || ending == ".tum") {
    return is_trajectory_file(path) ? FileKind::kFlight : FileKind::kOther;
  }
  return FileKind::kOther;
}

}  // namespace nadir
