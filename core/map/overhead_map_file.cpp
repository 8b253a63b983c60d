// SPDX-License-Identifier: Apache-2.0
#include "core/map/overhead_map_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/durability.h"
#include "core/base/require.h"
#include "core/base/settings.h"
#include "core/base/staged_output.h"
#include "core/map/label_tiff.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

constexpr int kFormat = 1;
constexpr const char* kSettingsFile = "map.toml";
constexpr const char* kLabelsFile = "labels.tif";
constexpr const char* kImageFile = "image.tif";
constexpr const char* kLabelNotesFile = "labels.tif.aux.xml";
constexpr const char* kImageNotesFile = "image.tif.aux.xml";
/// Everything that write_overhead_map makes, in the order in which it is replaced; other files of a package are not its own.
/// The labels last: until then it is the old map.
constexpr std::array<std::string_view, 5> kOwnFiles{kSettingsFile, kImageNotesFile, kImageFile,
                                                    kLabelNotesFile, kLabelsFile};

Result<Settings> read_settings(const fs::path& package) {
  std::error_code error;
  if (!fs::exists(package, error)) {
    return fail(ErrorCode::kNotFound, "{}: no such map package", package.string());
  }
  if (!fs::is_directory(package, error)) {
    return fail(ErrorCode::kMalformed,
                "{}: is no map package, which is a folder with map.toml and labels.tif",
                package.string());
  }
  auto settings = Settings::read(package / kSettingsFile);
  if (!settings) return forward_error(settings);
  const auto format = settings->integer("format");
  if (!format) return forward_error(format);
  if (*format != kFormat) {
    return fail(ErrorCode::kUnsupported, "{}: is of map format {}, this program knows {}",
                settings->name(), *format, kFormat);
  }
  return settings;
}

/// The list of class names, where there is one, must be ours. @errors kUnsupported.
Result<void> check_classes(const Settings& settings) {
  if (!settings.has("classes")) return {};
  const auto names = settings.texts("classes");
  if (!names) return forward_error(names);
  for (std::size_t id = 0; id < names->size(); ++id) {
    const auto known = class_from_name((*names)[id]);
    if (!known || *known != id) {
      return fail(ErrorCode::kUnsupported,
                  "{}: class {} is \"{}\" there but \"{}\" here; import it with a remap file",
                  settings.name(), id, (*names)[id],
                  class_info(static_cast<ClassId>(std::min<std::size_t>(id, 255))).name);
    }
  }
  return {};
}

Result<ProjectPlane> read_plane(const Settings& settings) {
  const auto latitude_deg = settings.number("plane.latitude_deg");
  if (!latitude_deg) return forward_error(latitude_deg);
  const auto longitude_deg = settings.number("plane.longitude_deg");
  if (!longitude_deg) return forward_error(longitude_deg);
  auto plane = ProjectPlane::create({*latitude_deg, *longitude_deg});
  if (!plane) {
    return fail(ErrorCode::kMalformed, "{}: {}", settings.name(), plane.error().message);
  }
  return plane;
}

std::string settings_text(const std::string& name,
                          const ProjectPlane& plane,
                          const MapProvenance& provenance) {
  std::string classes;
  for (int id = 0; id < kClassCount; ++id) {
    classes += fmt::format("{}{}", id == 0 ? "" : ", ",
                           toml_quoted(class_info(static_cast<ClassId>(id)).name));
  }
  // {:#.17g} gives the same double again when read.
  return fmt::format(
      "# A map package of Nadir: labels.tif holds the class ids, image.tif the picture if there is "
      "one.\n"
      "format = {}\n"
      "name = {}\n"
      "source = {}\n"
      "licence = {}\n"
      "date = {}\n"
      "# Names of the ids 0, 1, 2, ... of labels.tif; 255 is unclassified.\n"
      "classes = [{}]\n"
      "\n"
      "# Origin of the plane that labels.tif lies on: transverse Mercator, scale 1, WGS 84.\n"
      "[plane]\n"
      "latitude_deg = {:#.17g}\n"
      "longitude_deg = {:#.17g}\n",
      kFormat, toml_quoted(provenance.name.empty() ? name : provenance.name),
      toml_quoted(provenance.source), toml_quoted(provenance.licence), toml_quoted(provenance.date),
      classes, plane.origin().latitude_deg, plane.origin().longitude_deg);
}

/// Whether there is anything in a package that is not the map's own, such as a labelling document.
bool has_other_files(const fs::path& package) {
  std::error_code error;
  for (fs::directory_iterator entry(package, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (std::find(kOwnFiles.begin(), kOwnFiles.end(), name) == kOwnFiles.end()) return true;
  }
  return false;
}

/// Whether labels may be written into a package that is there. @errors kIo: they do not belong to it.
Result<void> check_same_map(const LabelStrips& labels, const fs::path& package) {
  const auto plane = read_map_plane(package);
  if (!plane) return forward_error(plane);
  if (!(*plane == labels.plane)) {
    return fail(ErrorCode::kIo, "{}: is a map on another plane, which is left alone",
                package.string());
  }
  std::error_code error;
  const fs::path image_path = package / kImageFile;
  if (!fs::exists(image_path, error)) return {};
  const auto image = read_tiff_place(image_path, *plane);
  if (!image) return forward_error(image);
  if (image->width != labels.width || image->height != labels.height ||
      std::abs(image->metres_per_cell - labels.metres_per_cell) * labels.width >
          0.01 * labels.metres_per_cell ||
      (image->top_left_in_enu_m - labels.top_left_in_enu_m).norm() >
          0.01 * labels.metres_per_cell) {
    return fail(ErrorCode::kIo,
                "{}: its picture of {} x {} cells of {:.6g} m is not where the labels of {} x {} "
                "cells of {:.6g} m are; write them elsewhere",
                package.string(), image->width, image->height, image->metres_per_cell, labels.width,
                labels.height, labels.metres_per_cell);
  }
  return {};
}

/// Puts the files of a staged folder in the place of those of a package, each by itself, so that whoever has others open there
/// may go on. @param is_whole  What is not staged goes: the picture of the map before.
Result<void> replace_files(const fs::path& staged, const fs::path& package, bool is_whole) {
  if (const auto safe = detail::wait_for_disk(staged); !safe) return forward_error(safe);
  for (const std::string_view name : kOwnFiles) {
    std::error_code error;
    if (fs::exists(staged / name, error)) {
      fs::rename(staged / name, package / name, error);
    } else if (is_whole) {
      fs::remove(package / name, error);
    }
    if (error) {
      return fail(ErrorCode::kIo, "{}: cannot be replaced ({})", (package / name).string(),
                  error.message());
    }
  }
  return detail::wait_for_name(package / kLabelsFile);
}

/// Until a package is complete, any map may be in its place; a folder that others have put more into is not exchanged.
StagedOutput::FolderCheck lets_go_of_maps(const bool& is_complete) {
  return [&is_complete](const fs::path& folder) -> Result<void> {
    if (!is_complete || !has_other_files(folder)) return {};
    return fail(ErrorCode::kIo, "{}: others are writing into it; try again", folder.string());
  };
}

}  // namespace

Result<MapProvenance> read_map_provenance(const fs::path& package) {
  const auto settings = read_settings(package);
  if (!settings) return forward_error(settings);
  const fs::path folder = package.has_filename() ? package : package.parent_path();
  MapProvenance provenance;
  const std::array<std::pair<std::string_view, std::string*>, 4> fields{
      {{"name", &provenance.name},
       {"source", &provenance.source},
       {"licence", &provenance.licence},
       {"date", &provenance.date}}};
  for (const auto& [key, text] : fields) {
    auto value = settings->text_or(key, "");
    if (!value) return forward_error(value);
    *text = std::move(*value);
  }
  if (provenance.name.empty()) provenance.name = folder.filename().string();
  return provenance;
}

Result<ProjectPlane> read_map_plane(const fs::path& package) {
  const auto settings = read_settings(package);
  if (!settings) return forward_error(settings);
  return read_plane(*settings);
}

Result<OverheadMap> read_overhead_map(const fs::path& package) {
  const auto settings = read_settings(package);
  if (!settings) return forward_error(settings);
  if (const auto classes = check_classes(*settings); !classes) return forward_error(classes);
  const auto plane = read_plane(*settings);
  if (!plane) return forward_error(plane);
  const auto provenance = read_map_provenance(package);
  if (!provenance) return forward_error(provenance);
  auto tiff = read_label_tiff(package / kLabelsFile, *plane);
  if (!tiff) return forward_error(tiff);
  return OverheadMap{provenance->name, *plane, tiff->place.metres_per_cell,
                     tiff->place.top_left_in_enu_m, std::move(tiff->labels)};
}

Result<std::optional<ColourRaster>> read_overhead_image(const fs::path& package) {
  const auto settings = read_settings(package);
  if (!settings) return forward_error(settings);
  const fs::path image_path = package / kImageFile;
  std::error_code error;
  if (!fs::exists(image_path, error)) return std::nullopt;
  const auto plane = read_plane(*settings);
  if (!plane) return forward_error(plane);
  const auto labels = read_tiff_place(package / kLabelsFile, *plane);
  if (!labels) return forward_error(labels);
  const auto image = read_tiff_place(image_path, *plane);
  if (!image) return forward_error(image);
  if (image->width != labels->width || image->height != labels->height) {
    return fail(ErrorCode::kMalformed, "{}: is {} x {} pixels, but the labels are {} x {}",
                image_path.string(), image->width, image->height, labels->width, labels->height);
  }
  const double tolerance_m = 0.01 * labels->metres_per_cell;
  if ((image->top_left_in_enu_m - labels->top_left_in_enu_m).norm() > tolerance_m ||
      std::abs(image->metres_per_cell - labels->metres_per_cell) * image->width > tolerance_m) {
    return fail(ErrorCode::kMalformed, "{}: does not lie where the labels lie",
                image_path.string());
  }
  auto colours = read_image_tiff(image_path);
  if (!colours) return forward_error(colours);
  return std::optional<ColourRaster>(std::move(*colours));
}

Result<void> write_overhead_map(const OverheadMap& map,
                                const MapProvenance& provenance,
                                const std::optional<ColourRaster>& image,
                                const fs::path& package) {
  NADIR_REQUIRE(!map.labels.empty());
  NADIR_REQUIRE(!image ||
                (image->width() == map.labels.width() && image->height() == map.labels.height()));
  bool is_complete = false;
  auto staged = StagedOutput::folder(package, kSettingsFile, {}, lets_go_of_maps(is_complete));
  if (!staged) return forward_error(staged);
  if (const auto done = write_label_tiff(map, staged->path() / kLabelsFile); !done) {
    return forward_error(done);
  }
  if (image) {
    const auto done = write_image_tiff(map, *image, staged->path() / kImageFile);
    if (!done) return forward_error(done);
  }
  const auto done = write_text_file(staged->path() / kSettingsFile,
                                    settings_text(map.name, map.plane, provenance));
  if (!done) return forward_error(done);
  is_complete = true;
  // Asked last: labels take minutes to write, and somebody may begin to draw on the map meanwhile.
  std::error_code error;
  if (fs::exists(package / kSettingsFile, error) && has_other_files(package)) {
    return replace_files(staged->path(), package, true);
  }
  return staged->commit();
}

Result<void> write_labels_of_map(const LabelStrips& labels,
                                 const MapProvenance& provenance,
                                 const fs::path& package) {
  NADIR_REQUIRE(labels.width > 0 && labels.height > 0 && labels.rows != nullptr);
  const auto is_there = [&] {
    std::error_code error;
    return fs::exists(package / kSettingsFile, error);
  };
  if (is_there()) {
    if (const auto same = check_same_map(labels, package); !same) return forward_error(same);
  }
  bool is_complete = false;
  auto staged = StagedOutput::folder(package, kSettingsFile, {}, lets_go_of_maps(is_complete));
  if (!staged) return forward_error(staged);
  if (const auto done = write_label_tiff(labels, staged->path() / kLabelsFile); !done) {
    return forward_error(done);
  }
  const auto done = write_text_file(staged->path() / kSettingsFile,
                                    settings_text(labels.name, labels.plane, provenance));
  if (!done) return forward_error(done);
  is_complete = true;
  if (!is_there()) return staged->commit();
  if (const auto same = check_same_map(labels, package); !same) return forward_error(same);
  return replace_files(staged->path(), package, false);
}

}  // namespace nadir
