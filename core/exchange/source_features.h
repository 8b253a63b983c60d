// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/exchange/import_rules.h"
#include "core/label/label_object.h"

namespace nadir {

/// What the readers of vector files give to the import. Private to this module.

/// A thing of a source before rules say what it is. Coordinates are the layer's, x before y and longitude before latitude.
struct SourceFeature {
  std::string name;  ///< "way 12".
  ImportTags tags;
  SourceForm form = SourceForm::kOpenLine;
  std::vector<Ring>
      rings;  ///< A place, a line, or a border and its holes; closed ones do not repeat their first place.
};

struct SourceLayer {
  std::string crs_wkt;  ///< Empty: WGS 84, degrees.
  std::vector<SourceFeature> features;
};

/// Faults that were met, counted by kind.
class Tally {
 public:
  /// @param one, many  "way misses nodes", "ways miss nodes".
  void add(const std::string& one, const std::string& many, std::size_t count = 1) {
    if (count > 0) counts_[{one, many}] += count;
  }
  /// "1 way misses nodes", "3 ways miss nodes".
  [[nodiscard]] std::vector<std::string> sentences() const {
    std::vector<std::string> sentences;
    for (const auto& [words, count] : counts_) {
      sentences.push_back(fmt::format("{} {}", count, count == 1 ? words.first : words.second));
    }
    return sentences;
  }

 private:
  std::map<std::pair<std::string, std::string>, std::size_t> counts_;
};

enum class SourceKind { kOpenStreetMap, kLanelet2, kOther };

struct SourceFeatures {
  SourceKind kind = SourceKind::kOther;
  std::vector<SourceLayer> layers;
  std::optional<PlaneBounds> bounds_deg;  ///< What the source says it covers: longitude, latitude.
  Tally faults;
};

/// Whether a file begins as OpenStreetMap's XML does, packed by gzip or not.
[[nodiscard]] bool looks_like_osm_xml(const std::filesystem::path& path);

/// OpenStreetMap XML, also what JOSM has not uploaded yet, and Lanelet2 maps, which are the same. Lanelets become areas
/// with the relation's tags. @errors kNotFound, kIo, kMalformed (no XML, truncated), kCancelled.
[[nodiscard]] Result<SourceFeatures> read_osm_features(const std::filesystem::path& path,
                                                       const WorkContext& context);
/// The same of a text; `name` stands for the file in messages.
[[nodiscard]] Result<SourceFeatures> parse_osm_features(std::string_view text,
                                                        const std::string& name);

/// What OGR reads: GeoJSON, GeoPackage, Shapefile, FlatGeobuf, KML, GML, OpenStreetMap PBF.
/// @param crs  Of layers that name none, such as "EPSG:25832"; empty otherwise.
/// @errors kNotFound, kMalformed (no such file, truncated, without reference system), kInvalidOptions (`crs`), kCancelled.
[[nodiscard]] Result<SourceFeatures> read_ogr_features(const std::filesystem::path& path,
                                                       const std::string& crs,
                                                       const WorkContext& context);

}  // namespace nadir
