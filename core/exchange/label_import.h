// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/exchange/import_rules.h"
#include "core/label/label_document.h"
#include "core/map/overhead_map.h"

namespace nadir {

/// What an import makes of a source, to be committed as one step.
struct ImportedLabels {
  LabelEdit edit;
  std::vector<std::string> notices;  ///< What was left out or mended, counted: "3 ways miss nodes".
  std::size_t read = 0;              ///< Things of the source that say what they are.
  std::size_t taken = 0;             ///< Objects.
};

/// Things that somebody else has drawn, before rules say what they are: OpenStreetMap (XML, PBF), Lanelet2, GeoJSON,
/// GeoPackage, Shapefile, FlatGeobuf, KML, GML.
class ImportSource {
 public:
  /// Whether a file holds vectors at all, by its name and first bytes; the others are rasters.
  [[nodiscard]] static bool holds_vectors(const std::filesystem::path& path);

  /// @param crs  Of a file that names none, such as "EPSG:25832"; empty otherwise.
  /// @errors kNotFound; kMalformed: truncated, not what it claims to be, no reference system; kUnsupported: packed by bzip2;
  /// kInvalidOptions: `crs`; kIo; kCancelled.
  [[nodiscard]] static Result<ImportSource> read(const std::filesystem::path& path,
                                                 const std::string& crs = {},
                                                 const WorkContext& context = {});
  ImportSource(ImportSource&& other) noexcept;
  ImportSource& operator=(ImportSource&& other) noexcept;
  ~ImportSource();

  /// The file of resources/rules that is made for it: "osm.toml", "lanelet2.toml", else "classes.toml".
  [[nodiscard]] std::string usual_rules() const;

  /// An empty document for what the rules take: its plane is centred there, its grid holds all of it, or what the source
  /// says that it covers.
  /// @param metres_per_cell  Where empty 0.1, or as much more as keeps the grid to 100 million cells.
  /// @errors kMalformed: the rules take nothing, or nothing has a place; kUnsupported: it spans more than 100 km, or has more
  /// than a thousand million cells.
  [[nodiscard]] Result<LabelDocument> plan_document(const ImportRules& rules,
                                                    std::optional<double> metres_per_cell) const;

  /// Its objects on a document's plane, reprojected once; those wholly outside of its grid are left out. Rings that cross
  /// themselves are taken as they are: inside is what an odd number surrounds.
  /// @errors kUnsupported: its reference system has no relation to the Earth; kCancelled.
  [[nodiscard]] Result<ImportedLabels> objects(const ImportRules& rules,
                                               const LabelDocument& document,
                                               const WorkContext& context = {}) const;

 private:
  struct Implementation;
  explicit ImportSource(std::unique_ptr<const Implementation> implementation);
  std::unique_ptr<const Implementation> implementation_;
};

/// How a label raster comes into a document.
enum class RasterAs { kPaint, kAreas };

/// A label raster as paint, or as areas with corners on corners of cells. Taken by nearest neighbour where its cells or its
/// plane are others. Cells without class, and those outside of the grid, change nothing.
[[nodiscard]] Result<ImportedLabels> import_raster(const OverheadMap& raster,
                                                   RasterAs as,
                                                   const LabelDocument& document,
                                                   const WorkContext& context = {});

}  // namespace nadir
