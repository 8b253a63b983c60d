// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/exchange/import_rules.h"
#include "core/label/label_grid.h"

namespace nadir {

/// OpenStreetMap data as their XML has them. Private to this module. GDAL's own reader passes over what JOSM has not
/// uploaded yet (negative numbers) and does not say which nodes a way misses, so this is ours.

struct OsmWay {
  std::int64_t id = 0;
  std::vector<std::int64_t> nodes;  ///< Some of which may be missing.
  ImportTags tags;
};

struct OsmMember {
  enum class Type { kNode, kWay, kRelation };
  Type type = Type::kNode;
  std::int64_t id = 0;
  std::string role;
};

struct OsmRelation {
  std::int64_t id = 0;
  std::vector<OsmMember> members;
  ImportTags tags;
};

struct OsmElements {
  std::unordered_map<std::int64_t, Eigen::Vector2d> nodes;  ///< Longitude, latitude, degrees.
  std::vector<std::pair<std::int64_t, ImportTags>> tagged_nodes;
  std::vector<OsmWay> ways;
  std::vector<OsmRelation> relations;
  std::optional<PlaneBounds> bounds_deg;
  std::size_t unsound = 0;  ///< Nodes without a place on the Earth, elements without number.
};

/// Deleted elements are left out. @errors kNotFound, kIo, kMalformed: not XML, not OpenStreetMap's, truncated; kCancelled.
[[nodiscard]] Result<OsmElements> read_osm_elements(const std::filesystem::path& path,
                                                    const WorkContext& context);
[[nodiscard]] Result<OsmElements> parse_osm_elements(std::string_view text,
                                                     const std::string& name);

}  // namespace nadir
