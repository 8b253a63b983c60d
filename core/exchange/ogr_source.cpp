// SPDX-License-Identifier: Apache-2.0
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

#include "core/exchange/source_features.h"
#include "core/map/crs.h"
#include "core/map/gdal_raster.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

/// None of them asks the network.
constexpr std::array kDrivers{"GeoJSON",    "GeoJSONSeq", "GPKG", "ESRI Shapefile",
                              "FlatGeobuf", "KML",        "GML",  "OSM"};

/// As GDAL's own it would take some tags for fields, drop others and guess which closed ways are areas: our rules do that.
constexpr std::string_view kOsmSettings =
    "closed_ways_are_polygons=\n"
    "report_all_nodes=no\nreport_all_ways=no\n"
    "[points]\nosm_id=yes\nattributes=\nunsignificant=\nignore=\nother_tags=no\nall_tags=yes\n"
    "[lines]\nosm_id=yes\nattributes=\nignore=\nother_tags=no\nall_tags=yes\n"
    "[multipolygons]\nosm_id=yes\nattributes=type\nignore=\nother_tags=no\nall_tags=yes\n"
    "[multilinestrings]\nosm_id=yes\nattributes=type\nignore=\nother_tags=no\nall_tags=yes\n"
    "[other_relations]\nosm_id=yes\nattributes=type\nignore=\nother_tags=no\nall_tags=yes\n";

/// A text as a file of GDAL's memory, as long as it lives.
class FileInMemory {
 public:
  explicit FileInMemory(std::string_view text) : text_(text) {
    name_ = fmt::format("/vsimem/nadir-{}.ini", static_cast<const void*>(this));
    VSILFILE* const file = VSIFileFromMemBuffer(
        name_.c_str(), reinterpret_cast<GByte*>(text_.data()), text_.size(), FALSE);
    if (file != nullptr) VSIFCloseL(file);
  }
  ~FileInMemory() { VSIUnlink(name_.c_str()); }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string text_, name_;
};

/// Tags as GDAL packs them: "highway"=>"residential","name"=>"the \"ring\"".
ImportTags tags_from_pairs(std::string_view text) {
  ImportTags tags;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '"') continue;
    std::string word;
    for (++i; i < text.size() && text[i] != '"'; ++i) {
      if (text[i] == '\\' && i + 1 < text.size()) ++i;
      word += text[i];
    }
    words.push_back(std::move(word));
  }
  for (std::size_t i = 0; i + 1 < words.size(); i += 2) tags[words[i]] = words[i + 1];
  return tags;
}

/// With all of its digits, which GDAL's own text has not.
std::string text_of(double number) {
  std::array<char, 400> digits{};
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::fixed);
  return {digits.data(), error == std::errc() ? end : digits.data()};
}

ImportTags tags_of(const OGRFeature& feature) {
  ImportTags tags;
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    if (!feature.IsFieldSetAndNotNull(i)) continue;
    const std::string name = feature.GetFieldDefnRef(i)->GetNameRef();
    if (name == "all_tags") {
      tags.merge(tags_from_pairs(feature.GetFieldAsString(i)));
    } else if (feature.GetFieldDefnRef(i)->GetType() == OFTReal) {
      tags[name] = text_of(feature.GetFieldAsDouble(i));
    } else {
      tags[name] = feature.GetFieldAsString(i);
    }
  }
  return tags;
}

/// Reads one file.
class OgrReader {
 public:
  OgrReader(fs::path path, std::string crs) : path_(std::move(path)), crs_(std::move(crs)) {}

  Result<SourceFeatures> read(const WorkContext& context) {
    const GdalMessages messages;
    std::error_code error;
    if (!fs::exists(path_, error)) {
      return fail(ErrorCode::kNotFound, "{}: no such file", path_.string());
    }
    const FileInMemory osm_settings(kOsmSettings);
    CPLStringList drivers;
    for (const char* driver : kDrivers) drivers.AddString(driver);
    CPLStringList options;
    if (is_osm_name()) options.SetNameValue("CONFIG_FILE", osm_settings.name().c_str());
    // Notes that happen to be dates stay as they are written.
    if (is_geojson_name()) options.SetNameValue("DATE_AS_STRING", "YES");
    const GdalDataset dataset(
        static_cast<GDALDataset*>(GDALOpenEx(path_.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                             drivers.List(), options.List(), nullptr)));
    if (dataset == nullptr) {
      return fail(ErrorCode::kMalformed, "{}: is no file of vectors that can be read{}",
                  path_.string(),
                  messages.has_failed() ? fmt::format(" ({})", messages.text()) : "");
    }
    if (std::string_view(dataset->GetDriverName()) == "OSM") {
      made_.kind = SourceKind::kOpenStreetMap;
    }
    OGRLayer* layer = nullptr;
    double done = 0.0;
    for (std::size_t count = 0;; ++count) {
      const std::unique_ptr<OGRFeature> feature(
          dataset->GetNextFeature(&layer, &done, nullptr, nullptr));
      if (feature == nullptr) break;
      if (count % 256 == 0) {
        if (context.is_stopped())
          return fail(ErrorCode::kCancelled, "{}: cancelled", path_.string());
        context.report(std::clamp(done, 0.0, 1.0), "reading");
      }
      if (const auto taken = take(*feature, *layer, messages); !taken) return forward_error(taken);
    }
    if (messages.has_failed()) {
      return fail(ErrorCode::kMalformed, "{}: cannot be read whole ({})", path_.string(),
                  messages.text());
    }
    for (auto& [ignored, entry] : layers_) made_.layers.push_back(std::move(entry.layer));
    return std::move(made_);
  }

 private:
  struct Layer {
    SourceLayer layer;
    bool is_latitude_first = false;
  };

  [[nodiscard]] bool is_osm_name() const {
    const std::string extension = path_.extension().string();
    return extension == ".pbf" || extension == ".osm";
  }

  [[nodiscard]] bool is_geojson_name() const {
    const std::string extension = path_.extension().string();
    return extension == ".geojson" || extension == ".json";
  }

  /// Where a layer's coordinates are. @errors kMalformed: it does not say; kInvalidOptions: --crs is none.
  Result<Layer*> layer_of(OGRLayer& layer, const GdalMessages& messages) {
    const auto known = layers_.find(&layer);
    if (known != layers_.end()) return &known->second;
    Layer& made = layers_[&layer];
    const OGRSpatialReference* const own = layer.GetSpatialRef();
    if (own != nullptr) {
      made.layer.crs_wkt = wkt_of(*own);
      made.is_latitude_first = own->EPSGTreatsAsLatLong() != 0 &&
                               own->GetDataAxisToSRSAxisMapping() == std::vector<int>{1, 2};
    } else if (crs_.empty()) {
      return fail(ErrorCode::kMalformed,
                  "{}: does not say which coordinate reference system it has; name it with --crs",
                  path_.string());
    } else {
      const auto given = crs_from_text(crs_, messages);
      if (!given) return forward_error(given);
      made.layer.crs_wkt = wkt_of(*given);
    }
    return &made;
  }

  Result<void> take(const OGRFeature& feature, OGRLayer& ogr_layer, const GdalMessages& messages) {
    if (ogr_layer.GetGeomType() == wkbNone) return {};  // A plain table.
    const OGRGeometry* const geometry = feature.GetGeometryRef();
    if (geometry == nullptr || geometry->IsEmpty()) {
      made_.faults.add("feature has no geometry and was left out",
                       "features have no geometry and were left out");
      return {};
    }
    const auto layer = layer_of(ogr_layer, messages);
    if (!layer) return forward_error(layer);
    const std::string name = fmt::format("{} {}", ogr_layer.GetName(), feature.GetFID());
    add_geometry(*geometry, name, tags_of(feature), **layer);
    return {};
  }

  void add(const std::string& name,
           const ImportTags& tags,
           SourceForm form,
           std::vector<Ring> rings,
           Layer& layer) {
    const std::size_t least = form == SourceForm::kPlace ? 1 : form == SourceForm::kArea ? 3 : 2;
    const auto is_unfit = [&](const Ring& ring) { return ring.size() < least; };
    if (rings.empty() || is_unfit(rings.front())) {
      made_.faults.add("geometry has too few places and was left out",
                       "geometries have too few places and were left out");
      return;
    }
    rings.erase(std::remove_if(rings.begin() + 1, rings.end(), is_unfit), rings.end());
    layer.layer.features.push_back({name, tags, form, std::move(rings)});
  }

  /// Places without those that are not finite; a closed ring does not repeat its first.
  Ring places_of(const OGRSimpleCurve& curve, bool is_ring, const Layer& layer) {
    Ring places;
    for (int i = 0; i < curve.getNumPoints(); ++i) {
      Eigen::Vector2d place(curve.getX(i), curve.getY(i));
      if (layer.is_latitude_first) std::swap(place.x(), place.y());
      if (!place.allFinite()) {
        made_.faults.add("place is not a number and was left out",
                         "places are not numbers and were left out");
      } else if (places.empty() || places.back() != place) {
        places.push_back(place);
      }
    }
    if (is_ring && places.size() > 1 && places.front() == places.back()) places.pop_back();
    return places;
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the collections are.
  void add_geometry(const OGRGeometry& given,
                    const std::string& name,
                    const ImportTags& tags,
                    Layer& layer) {
    if (given.IsEmpty()) return;
    if (given.hasCurveGeometry() != 0) {
      const std::unique_ptr<OGRGeometry> straight(given.getLinearGeometry());
      if (straight != nullptr && straight->hasCurveGeometry() == 0) {
        add_geometry(*straight, name, tags, layer);
      }
      return;
    }
    switch (wkbFlatten(given.getGeometryType())) {
      case wkbPoint: {
        const OGRPoint& point = *given.toPoint();
        Eigen::Vector2d place(point.getX(), point.getY());
        if (layer.is_latitude_first) std::swap(place.x(), place.y());
        if (place.allFinite()) add(name, tags, SourceForm::kPlace, {{place}}, layer);
        break;
      }
      case wkbLineString: {
        const OGRLineString& line = *given.toLineString();
        const bool is_closed = line.get_IsClosed() != 0 && line.getNumPoints() > 3;
        add(name, tags, is_closed ? SourceForm::kClosedLine : SourceForm::kOpenLine,
            {places_of(line, is_closed, layer)}, layer);
        break;
      }
      case wkbPolygon:
      case wkbTriangle: {
        std::vector<Ring> rings;
        for (const OGRLinearRing* ring : *given.toPolygon()) {
          rings.push_back(places_of(*ring, true, layer));
        }
        add(name, tags, SourceForm::kArea, std::move(rings), layer);
        break;
      }
      case wkbMultiPoint:
      case wkbMultiLineString:
      case wkbMultiPolygon:
      case wkbGeometryCollection:
        for (const OGRGeometry* part : *given.toGeometryCollection()) {
          add_geometry(*part, name, tags, layer);
        }
        break;
      default:
        made_.faults.add("geometry is of an unknown kind and was left out",
                         "geometries are of an unknown kind and were left out");
    }
  }

  fs::path path_;
  std::string crs_;
  std::map<const OGRLayer*, Layer> layers_;
  SourceFeatures made_;
};

}  // namespace

Result<SourceFeatures> read_ogr_features(const fs::path& path,
                                         const std::string& crs,
                                         const WorkContext& context) {
  return OgrReader(path, crs).read(context);
}

}  // namespace nadir
