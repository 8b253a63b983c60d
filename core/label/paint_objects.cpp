// SPDX-License-Identifier: Apache-2.0
#include "core/label/paint_objects.h"

#include <cpl_error.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <set>
#include <utility>

#include "core/label/label_raster.h"
#include "core/label/tile_painter.h"

namespace nadir {
namespace {

/// Paint that hangs together over more cells than this is cut at the borders of its tiles.
constexpr std::int64_t kMostCellsAtOnce = 64'000'000;

struct Closed {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Closed>;

/// While it lives, GDAL prints nothing from this thread.
class QuietGdal {
 public:
  QuietGdal() {
    static std::once_flag once;
    std::call_once(once, GDALAllRegister);
    CPLPushErrorHandler(CPLQuietErrorHandler);
  }
  ~QuietGdal() { CPLPopErrorHandler(); }
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
};

Dataset made(const char* driver, int width, int height, int bands) {
  GDALDriver* const found = GetGDALDriverManager()->GetDriverByName(driver);
  return Dataset(found != nullptr ? found->Create("", width, height, bands, GDT_Byte, nullptr)
                                  : nullptr);
}

bool write_band(GDALDataset& dataset, int band, const Raster<std::uint8_t>& values) {
  // GDAL only reads what it is given to write.
  return dataset.GetRasterBand(band)->RasterIO(GF_Write, 0, 0, values.width(), values.height(),
                                               const_cast<std::uint8_t*>(values.data()),
                                               values.width(), values.height(), GDT_Byte, 0, 0,
                                               nullptr) == CE_None;
}

Ring ring_of(const OGRLinearRing& places) {
  Ring ring;
  for (int i = 0; i + 1 < places.getNumPoints(); ++i)
    ring.emplace_back(places.getX(i), places.getY(i));
  return ring;
}

/// Tiles that have a common side, one group after the other.
std::vector<std::vector<PaintAddress>> groups_of(std::set<PaintAddress> tiles) {
  std::vector<std::vector<PaintAddress>> groups;
  while (!tiles.empty()) {
    std::vector<PaintAddress> group{*tiles.begin()};
    tiles.erase(tiles.begin());
    for (std::size_t i = 0; i < group.size(); ++i) {
      const auto [column, row] = group[i];
      for (const PaintAddress& next :
           {PaintAddress{column - 1, row}, PaintAddress{column + 1, row},
            PaintAddress{column, row - 1}, PaintAddress{column, row + 1}}) {
        if (tiles.erase(next) > 0) group.push_back(next);
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

CellRect cells_of(std::span<const PaintAddress> tiles) {
  CellRect cells;
  for (const PaintAddress& tile : tiles) {
    const std::int64_t left = std::int64_t{tile.column} * kPaintTileSide;
    const std::int64_t top = std::int64_t{tile.row} * kPaintTileSide;
    cells = cells.joined({left, top, left + kPaintTileSide, top + kPaintTileSide});
  }
  return cells;
}

/// An area in place of painted cells, without number and order.
LabelObject area_of(const CellRegion& region, const CellRect& cells, const LabelGrid& grid) {
  LabelObject object;
  object.kind = ObjectKind::kArea;
  object.class_id = painted_class(region.value);
  object.rings = region.rings_in_cells;
  const Eigen::Vector2d corner(static_cast<double>(cells.left), static_cast<double>(cells.top));
  for (Ring& ring : object.rings) {
    for (Eigen::Vector2d& point : ring) point = grid.enu_from_cells(point + corner);
  }
  return object;
}

/// Above all objects: where paint lies that covers everything.
std::int64_t order_above_all(const LabelDocument& document) {
  std::int64_t order = document.next_order(kUnclassified);
  for (const auto& [id, placed] : document.objects()) {
    order = std::max(order, placed.object->order + 1);
  }
  return order;
}

}  // namespace

Result<std::vector<CellRegion>> polygonise(const Raster<std::uint8_t>& values,
                                           std::uint8_t left_out) {
  std::vector<CellRegion> regions;
  if (values.empty()) return regions;
  const QuietGdal quiet;
  const Dataset raster = made("MEM", values.width(), values.height(), 2);
  const Dataset vectors = made("Memory", 0, 0, 0);
  OGRLayer* const layer =
      vectors != nullptr ? vectors->CreateLayer("regions", nullptr, wkbPolygon, nullptr) : nullptr;
  OGRFieldDefn field("value", OFTInteger);
  Raster<std::uint8_t> mask = values;
  for (std::uint8_t& cell : mask.values()) cell = cell == left_out ? 0 : 1;
  // Sides only: regions that also hung together by corners would have borders that cross themselves.
  if (raster == nullptr || layer == nullptr || layer->CreateField(&field) != OGRERR_NONE ||
      !write_band(*raster, 1, values) || !write_band(*raster, 2, mask) ||
      GDALPolygonize(raster->GetRasterBand(1), raster->GetRasterBand(2), layer, 0, nullptr, nullptr,
                     nullptr) != CE_None) {
    return fail(ErrorCode::kIo, "cells cannot be made into areas ({})", CPLGetLastErrorMsg());
  }
  for (const auto& feature : *layer) {
    const OGRPolygon* const polygon = feature->GetGeometryRef()->toPolygon();
    CellRegion region{static_cast<std::uint8_t>(feature->GetFieldAsInteger(0)), {}};
    region.rings_in_cells.push_back(ring_of(*polygon->getExteriorRing()));
    for (int i = 0; i < polygon->getNumInteriorRings(); ++i) {
      region.rings_in_cells.push_back(ring_of(*polygon->getInteriorRing(i)));
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

Result<LabelEdit> paint_to_objects(const LabelDocument& document) {
  LabelEdit edit{.title = "Paint to objects", .objects = {}, .tiles = {}, .values = {}};
  std::set<PaintAddress> painted;
  for (const auto& [address, tile] : document.paint()) {
    painted.insert(painted.end(), address);
    edit.tiles.push_back({address, {tile, nullptr}});
  }
  std::vector<std::vector<PaintAddress>> groups;
  for (std::vector<PaintAddress>& group : groups_of(std::move(painted))) {
    const CellRect cells = cells_of(group);
    if (cells.width() * cells.height() <= kMostCellsAtOnce) {
      groups.push_back(std::move(group));
    } else {
      for (const PaintAddress& tile : group) groups.push_back({tile});
    }
  }
  const std::int64_t above_all = order_above_all(document);
  ObjectId next_id = document.next_id();
  for (const std::vector<PaintAddress>& group : groups) {
    const CellRect cells = cells_of(group);
    Raster<std::uint8_t> values(static_cast<int>(cells.width()), static_cast<int>(cells.height()),
                                kNoPaint);
    for (const PaintAddress& address : group) {
      const PaintTile& tile = *document.tile(address);
      const auto left = std::int64_t{address.column} * kPaintTileSide - cells.left;
      const auto top = std::int64_t{address.row} * kPaintTileSide - cells.top;
      for (int row = 0; row < kPaintTileSide; ++row) {
        const auto* const from = &tile.values[static_cast<std::size_t>(row) * kPaintTileSide];
        std::copy(from, from + kPaintTileSide,
                  &values.at(static_cast<int>(left), static_cast<int>(top) + row));
      }
    }
    const auto regions = polygonise(values, kNoPaint);
    if (!regions) return forward_error(regions);
    for (const CellRegion& region : *regions) {
      LabelObject object = area_of(region, cells, document.grid());
      object.id = next_id++;
      object.order =
          covers_everything(region.value) ? above_all : document.next_order(object.class_id);
      edit.objects.push_back({nullptr, std::make_shared<const LabelObject>(std::move(object))});
    }
  }
  return edit;
}

Result<LabelEdit> objects_to_paint(const LabelDocument& document,
                                   std::span<const ObjectId> objects) {
  LabelEdit edit{.title = "Objects to paint", .objects = {}, .tiles = {}, .values = {}};
  const LabelGrid& grid = document.grid();
  CellRect cells;
  for (const ObjectId id : std::set<ObjectId>(objects.begin(), objects.end())) {
    const auto object = document.object(id);
    if (object == nullptr) return fail(ErrorCode::kInvalidOptions, "there is no object {}", id);
    edit.objects.push_back({object, nullptr});
    cells = cells.joined(grid.cells_of(drawn_bounds(*object), 1));
  }
  cells = cells.cut_to(grid.whole());
  const Raster<ClassId> wanted = rasterise(document, grid, cells);
  // In the levels of classes first; what then is still covered, over everything.
  LabelDocument without = document;
  without.apply(edit);
  TilePainter painter(document);
  for (const PaintValue over : {PaintValue{0}, kPaintOver}) {
    const Raster<ClassId> found = rasterise(without, grid, cells);
    for (int row = 0; row < wanted.height(); ++row) {
      for (int column = 0; column < wanted.width(); ++column) {
        const ClassId id = wanted.at(column, row);
        if (found.at(column, row) == id) continue;
        const PaintValue value = id == kUnclassified ? id : static_cast<PaintValue>(id + over);
        painter.put(cells.top + row, cells.left + column, cells.left + column + 1, value);
      }
    }
    edit.tiles = painter.edit({}).tiles;
    without = document;
    without.apply(edit);
  }
  return edit;
}

}  // namespace nadir
