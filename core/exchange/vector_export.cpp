// SPDX-License-Identifier: Apache-2.0
#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <functional>
#include <memory>
#include <utility>

#include "core/base/staged_output.h"
#include "core/exchange/export_writers.h"
#include "core/label/paint_objects.h"
#include "core/map/crs.h"
#include "core/map/gdal_raster.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

/// From the plane to the coordinates of a file.
using ToFile = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

/// A document's objects, and its paint as areas.
Result<LabelDocument> without_paint(const LabelDocument& document) {
  const auto edit = paint_to_objects(document);
  if (!edit) return forward_error(edit);
  LabelDocument made = document;
  made.apply(*edit);
  return made;
}

template <typename Line>
std::unique_ptr<Line> line_of(const Ring& places, const ToFile& to_file) {
  auto line = std::make_unique<Line>();
  for (const Eigen::Vector2d& place : places) {
    const Eigen::Vector2d at = to_file(place);
    line->addPoint(at.x(), at.y());
  }
  return line;
}

std::unique_ptr<OGRGeometry> geometry_of(const LabelObject& object, const ToFile& to_file) {
  if (object.kind == ObjectKind::kLine) {
    return line_of<OGRLineString>(object.rings.front(), to_file);
  }
  auto polygon = std::make_unique<OGRPolygon>();
  for (const Ring& ring : object.rings) {
    auto border = line_of<OGRLinearRing>(ring, to_file);
    border->closeRings();
    polygon->addRingDirectly(border.release());
  }
  return polygon;
}

/// A layer for objects of some kind, or of all.
class ObjectLayer {
 public:
  ObjectLayer(GDALDataset& dataset,
              const char* name,
              OGRSpatialReference crs,
              OGRwkbGeometryType type,
              CPLStringList options)
      : layer_(dataset.CreateLayer(name, &crs, type, options.List())) {
    if (layer_ == nullptr) return;
    add_field("class", OFTString, 16);
    add_field("kind", OFTString, 8);
    add_field("width_m", OFTReal, 26, 20);  // A dbf's numbers have as many digits as are asked for.
    add_field("order", OFTInteger64, 0);
    add_field("note", OFTString, 254);
  }

  [[nodiscard]] bool add(const LabelObject& object, const ToFile& to_file) {
    if (layer_ == nullptr) return false;
    OGRFeature feature(layer_->GetLayerDefn());
    feature.SetField("class", std::string(class_info(object.class_id).name).c_str());
    feature.SetField("kind", std::string(enum_name(object.kind)).c_str());
    if (object.kind != ObjectKind::kArea) feature.SetField("width_m", object.width_m);
    feature.SetField("order", static_cast<GIntBig>(object.order));
    if (!object.note.empty()) feature.SetField("note", object.note.c_str());
    feature.SetGeometryDirectly(geometry_of(object, to_file).release());
    return layer_->CreateFeature(&feature) == OGRERR_NONE;
  }

 private:
  void add_field(const char* name, OGRFieldType type, int width, int decimals = 0) {
    OGRFieldDefn field(name, type);
    field.SetWidth(width);
    field.SetPrecision(decimals);
    layer_->CreateField(&field);
  }
  OGRLayer* layer_;
};

GdalDataset created(const char* driver_name, const fs::path& path) {
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  return GdalDataset(driver != nullptr ? driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr)
                                       : nullptr);
}

tl::unexpected<Error> unwritable(const fs::path& target, const GdalMessages& messages) {
  return fail(ErrorCode::kIo, "{}: cannot be written ({})", target.string(), messages.text());
}

}  // namespace

Result<void> export_geojson(const ExportTask& task, const fs::path& target) {
  const auto document = without_paint(task.document);
  if (!document) return forward_error(document, target.string());
  auto staged = StagedOutput::file(target);
  if (!staged) return forward_error(staged);
  const GdalMessages messages;
  {
    const GdalDataset dataset = created("GeoJSON", staged->path());
    if (dataset == nullptr) return unwritable(target, messages);
    CPLStringList options;
    // 1e-13 degrees are a hundredth of a micrometre.
    for (const char* option :
         {"RFC7946=YES", "COORDINATE_PRECISION=13", "SIGNIFICANT_FIGURES=17"}) {
      options.AddString(option);
    }
    ObjectLayer layer(*dataset, "labels", wgs84(), wkbUnknown, options);
    const ToFile to_file = [&](const Eigen::Vector2d& place) {
      const Geodetic at = document->plane().geodetic_from_enu(place);
      return Eigen::Vector2d(at.longitude_deg, at.latitude_deg);
    };
    for (const auto& [id, placed] : document->objects()) {
      if (task.context.is_stopped()) return fail(ErrorCode::kCancelled, "export: cancelled");
      if (!layer.add(*placed.object, to_file)) return unwritable(target, messages);
    }
  }
  if (messages.has_failed()) return unwritable(target, messages);
  return staged->commit();
}

Result<void> export_shapefile(const ExportTask& task, const fs::path& target) {
  constexpr std::array<std::string_view, 15> kOwn{
      "area.shp",    "area.shx",    "area.dbf",    "area.prj",    "area.cpg",
      "line.shp",    "line.shx",    "line.dbf",    "line.prj",    "line.cpg",
      "outline.shp", "outline.shx", "outline.dbf", "outline.prj", "outline.cpg"};
  const auto document = without_paint(task.document);
  if (!document) return forward_error(document, target.string());
  auto staged = StagedOutput::folder(target, kOwn.front(), kOwn);
  if (!staged) return forward_error(staged);
  const GdalMessages messages;
  {
    const GdalDataset dataset = created("ESRI Shapefile", staged->path());
    if (dataset == nullptr) return unwritable(target, messages);
    const OGRSpatialReference plane = crs_from_wkt(document->plane().wkt());
    CPLStringList options;
    options.AddString("ENCODING=UTF-8");
    std::array<ObjectLayer, 3> layers{ObjectLayer(*dataset, "area", plane, wkbPolygon, options),
                                      ObjectLayer(*dataset, "line", plane, wkbLineString, options),
                                      ObjectLayer(*dataset, "outline", plane, wkbPolygon, options)};
    const ToFile as_it_is = [](const Eigen::Vector2d& place) { return place; };
    for (const auto& [id, placed] : document->objects()) {
      if (task.context.is_stopped()) return fail(ErrorCode::kCancelled, "export: cancelled");
      ObjectLayer& layer = layers.at(static_cast<std::size_t>(placed.object->kind));
      if (!layer.add(*placed.object, as_it_is)) return unwritable(target, messages);
    }
  }
  if (messages.has_failed()) return unwritable(target, messages);
  return staged->commit();
}

}  // namespace nadir
