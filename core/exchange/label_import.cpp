// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/label_import.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <utility>

#include "core/exchange/object_maker.h"
#include "core/exchange/source_features.h"
#include "core/map/crs.h"
#include "core/map/gdal_raster.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

constexpr double kUsualMetresPerCell = 0.1;
constexpr std::int64_t kUsualMostCells = 100'000'000;
constexpr double kMostSpanM = 100'000.0;

bool is_on_earth(const Eigen::Vector2d& lon_lat_deg) {
  return std::abs(lon_lat_deg.x()) <= 180.0 && std::abs(lon_lat_deg.y()) <= 90.0;
}

/// @errors kUnsupported.
Result<EnuFromLayer> enu_from(const SourceLayer& layer, const ProjectPlane& plane) {
  if (layer.crs_wkt.empty()) {
    return [plane](const Eigen::Vector2d& at) -> std::optional<Eigen::Vector2d> {
      if (!is_on_earth(at)) return std::nullopt;
      return plane.enu_from_geodetic({at.y(), at.x()});
    };
  }
  const OGRSpatialReference crs = crs_from_wkt(layer.crs_wkt);
  auto transform = CrsTransform::create(crs, crs_from_wkt(plane.wkt()));
  if (!transform) return forward_error(transform);
  const auto shared = std::make_shared<const CrsTransform>(std::move(*transform));
  const bool is_in_degrees = crs.IsGeographic() != 0;
  return [shared, is_in_degrees](const Eigen::Vector2d& at) -> std::optional<Eigen::Vector2d> {
    if (is_in_degrees && !is_on_earth(at)) return std::nullopt;
    return (*shared)(at);
  };
}

/// Longitude and latitude of a layer's places. @errors kUnsupported.
Result<EnuFromLayer> geodetic_from(const SourceLayer& layer) {
  if (layer.crs_wkt.empty()) {
    return [](const Eigen::Vector2d& at) {
      return is_on_earth(at) ? std::optional(at) : std::nullopt;
    };
  }
  auto transform = CrsTransform::create(crs_from_wkt(layer.crs_wkt), wgs84());
  if (!transform) return forward_error(transform);
  const auto shared = std::make_shared<const CrsTransform>(std::move(*transform));
  return [shared](const Eigen::Vector2d& at) -> std::optional<Eigen::Vector2d> {
    const auto place = (*shared)(at);
    return place && is_on_earth(*place) ? place : std::nullopt;
  };
}

/// Of whatever the rules take. @errors kUnsupported.
Result<PlaneBounds> bounds_of_taken(const SourceFeatures& features, const ImportRules& rules) {
  PlaneBounds bounds;
  for (const SourceLayer& layer : features.layers) {
    const auto to_geodetic = geodetic_from(layer);
    if (!to_geodetic) return forward_error(to_geodetic);
    for (const SourceFeature& feature : layer.features) {
      const auto drawn = rules.apply(feature.tags, feature.form);
      if (!drawn || drawn->kind == ImportKind::kNothing) continue;
      for (const Ring& ring : feature.rings) {
        for (const Eigen::Vector2d& place : ring) {
          if (const auto at = (*to_geodetic)(place)) bounds.include(*at);
        }
      }
    }
  }
  return bounds;
}

Result<LabelGrid> grid_over(const PlaneBounds& bounds,
                            std::optional<double> asked,
                            const std::string& name) {
  const Eigen::Vector2d span = bounds.high - bounds.low;
  if (!(span.maxCoeff() <= kMostSpanM)) {
    return fail(ErrorCode::kUnsupported,
                "{}: reaches over {:.0f} km, which is no map; cut it to its place first", name,
                span.maxCoeff() / 1000.0);
  }
  LabelGrid grid;
  const auto cells = [&](int axis) {
    return static_cast<std::int64_t>(std::max(1.0, std::ceil(span[axis] / grid.metres_per_cell)));
  };
  grid.metres_per_cell = asked.value_or(kUsualMetresPerCell);
  if (!asked) {
    constexpr std::array kSteps{0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0};
    for (const double step : kSteps) {
      grid.metres_per_cell = step;
      if (cells(0) * cells(1) <= kUsualMostCells) break;
    }
  }
  if (cells(0) > kMaxMapCells || cells(1) > kMaxMapCells || cells(0) * cells(1) > kMaxMapCells) {
    return fail(ErrorCode::kUnsupported,
                "{}: cells of {} m are more than {} over {:.0f} x {:.0f} m; take larger ones", name,
                grid.metres_per_cell, kMaxMapCells, span.x(), span.y());
  }
  grid.width = static_cast<int>(cells(0));
  grid.height = static_cast<int>(cells(1));
  grid.top_left_in_enu_m = {bounds.low.x(), bounds.high.y()};
  return grid;
}

/// A GeoPackage may hold rasters alone.
bool holds_layers(const fs::path& path) {
  const GdalMessages quiet;
  const GdalDataset dataset(static_cast<GDALDataset*>(
      GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
  return dataset != nullptr && dataset->GetLayerCount() > 0;
}

}  // namespace

struct ImportSource::Implementation {
  std::string name;
  SourceFeatures features;
};

ImportSource::ImportSource(std::unique_ptr<const Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ImportSource::ImportSource(ImportSource&&) noexcept = default;
ImportSource& ImportSource::operator=(ImportSource&&) noexcept = default;
ImportSource::~ImportSource() = default;

bool ImportSource::holds_vectors(const fs::path& path) {
  constexpr std::array<std::string_view, 10> kEndings{".osm",      ".pbf", ".geojson", ".geojsonl",
                                                      ".geojsons", ".shp", ".fgb",     ".kml",
                                                      ".gml",      ".json"};
  std::error_code error;
  if (fs::is_directory(path, error)) return false;
  const std::string ending = path.extension().string();
  if (ending == ".gpkg") return holds_layers(path);
  if (ending == ".bz2") return path.stem().extension() == ".osm";
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end() ||
         ((ending == ".xml" || ending == ".gz") && looks_like_osm_xml(path));
}

Result<ImportSource> ImportSource::read(const fs::path& path,
                                        const std::string& crs,
                                        const WorkContext& context) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 3> begin{};
  if (file.read(begin.data(), 3) && std::string_view(begin.data(), 3) == "BZh") {
    return fail(ErrorCode::kUnsupported, "{}: is packed by bzip2; unpack it first (bunzip2 -k)",
                path.string());
  }
  const bool is_osm = path.extension() == ".osm" || looks_like_osm_xml(path);
  auto features = is_osm ? read_osm_features(path, context) : read_ogr_features(path, crs, context);
  if (!features) return forward_error(features);
  return ImportSource(
      std::make_unique<const Implementation>(Implementation{path.string(), std::move(*features)}));
}

std::string ImportSource::usual_rules() const {
  switch (implementation_->features.kind) {
    case SourceKind::kOpenStreetMap:
      return "osm.toml";
    case SourceKind::kLanelet2:
      return "lanelet2.toml";
    case SourceKind::kOther:
      break;
  }
  return "classes.toml";
}

Result<LabelDocument> ImportSource::plan_document(const ImportRules& rules,
                                                  std::optional<double> metres_per_cell) const {
  const SourceFeatures& features = implementation_->features;
  const std::string& name = implementation_->name;
  const auto taken = bounds_of_taken(features, rules);
  if (!taken) return forward_error(taken, name);
  if (taken->is_empty) {
    return fail(ErrorCode::kMalformed, "{}: holds nothing that the rules take", name);
  }
  const PlaneBounds around = features.bounds_deg.value_or(*taken);
  const Eigen::Vector2d centre = (around.low + around.high) / 2.0;
  const auto plane = ProjectPlane::create({centre.y(), centre.x()});
  if (!plane) return forward_error(plane, name);
  PlaneBounds bounds;
  for (const double x : {around.low.x(), centre.x(), around.high.x()}) {
    for (const double y : {around.low.y(), centre.y(), around.high.y()}) {
      bounds.include(plane->enu_from_geodetic({y, x}));
    }
  }
  // Up to the next whole cell of any size, and room for the widths of what lies at the edge.
  if (!features.bounds_deg) bounds.grow(5.0);
  bounds.low = bounds.low.array().floor();
  bounds.high = bounds.high.array().ceil();
  const auto grid = grid_over(bounds, metres_per_cell, name);
  if (!grid) return forward_error(grid);
  return LabelDocument(*plane, *grid);
}

Result<ImportedLabels> ImportSource::objects(const ImportRules& rules,
                                             const LabelDocument& document,
                                             const WorkContext& context) const {
  const SourceFeatures& features = implementation_->features;
  ObjectMaker maker(document, features.faults);
  std::size_t all = 1;
  for (const SourceLayer& layer : features.layers) all += layer.features.size();
  std::size_t done = 0;
  for (const SourceLayer& layer : features.layers) {
    const auto to_enu = enu_from(layer, document.plane());
    if (!to_enu) return forward_error(to_enu, implementation_->name);
    for (const SourceFeature& feature : layer.features) {
      if (done++ % 256 == 0) {
        if (context.is_stopped()) {
          return fail(ErrorCode::kCancelled, "{}: cancelled", implementation_->name);
        }
        context.report(static_cast<double>(done) / static_cast<double>(all), "taking over");
      }
      maker.add(feature, rules, *to_enu);
    }
  }
  return std::move(maker).finish();
}

}  // namespace nadir
