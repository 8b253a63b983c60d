// SPDX-License-Identifier: Apache-2.0
#include "core/desk/label_place.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <string_view>
#include <utility>

#include "core/base/require.h"
#include "core/map/overhead_map_file.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool is_package(const fs::path& folder) { return is_there(folder / "map.toml"); }

/// An empty document over a picture.
Result<LabelDocument> document_over(const fs::path& path,
                                    const ImageOptions& options,
                                    std::vector<std::string>& notices) {
  const auto opened = open_overhead_image(path, options);
  if (!opened) return forward_error(opened);
  const OverheadImage& image = opened->image;
  if (image.place == ImagePlace::kWithoutSystem) {
    return fail(ErrorCode::kMalformed,
                "{}: has coordinates, but nobody says of which reference system", path.string());
  }
  if (image.place == ImagePlace::kNone) {
    return fail(ErrorCode::kMalformed, "{}: has no georeference, so nobody knows where it lies",
                path.string());
  }
  for (const std::string& notice : image.notices)
    notices.push_back(fmt::format("{}: {}", path.string(), notice));
  const OverheadTiles& tiles = opened->tiles;
  return LabelDocument(*image.plane, {tiles.metres_per_cell(), tiles.top_left_in_enu_m(),
                                      tiles.width(), tiles.height()});
}

Result<LabelPlace> place_in_package(const fs::path& package) {
  LabelPlace place;
  place.document = package / "labels.gpkg";
  if (is_there(package / "image.tif")) place.image = package / "image.tif";
  if (is_there(place.document)) return place;
  if (!is_there(package / "labels.tif") && !place.image.empty()) {
    auto empty = document_over(place.image, {}, place.notices);
    if (!empty) return forward_error(empty);
    place.begins_as = std::move(*empty);
    return place;
  }
  const auto map = read_overhead_map(package);
  if (!map) return forward_error(map);
  place.begins_as = LabelDocument(map->plane, {map->metres_per_cell, map->top_left_in_enu_m,
                                               map->labels.width(), map->labels.height()});
  place.takes_over = paint_of_cells(*place.begins_as, map->labels);
  place.takes_over.title = "Take over labels.tif";
  return place;
}

/// The picture beside IMAGE.labels.gpkg; empty where there is none.
fs::path image_of_document(const fs::path& document) {
  constexpr std::string_view kOfImage = ".labels";
  constexpr std::array kEndings{".tif",  ".tiff", ".png", ".jpg",
                                ".jpeg", ".webp", ".jp2", ".mbtiles"};
  const std::string stem = document.stem().string();
  if (stem.size() <= kOfImage.size() || !stem.ends_with(kOfImage)) return {};
  const std::string image = stem.substr(0, stem.size() - kOfImage.size());
  for (const std::string_view ending : kEndings) {
    for (const bool is_upper : {false, true}) {
      std::string name = image + std::string(ending);
      if (is_upper) {
        std::transform(name.begin() + static_cast<std::ptrdiff_t>(image.size()), name.end(),
                       name.begin() + static_cast<std::ptrdiff_t>(image.size()),
                       [](unsigned char letter) { return std::toupper(letter); });
      }
      if (is_there(document.parent_path() / name)) return document.parent_path() / name;
    }
  }
  return {};
}

}  // namespace

Result<LabelPlace> find_label_place(const fs::path& named, const ImageOptions& image) {
  std::error_code ignored;
  const std::string name = named.string();
  const std::string ending = named.extension().string();
  if (!is_there(named)) return fail(ErrorCode::kNotFound, "{}: no such file or folder", name);
  if (fs::is_directory(named, ignored)) return place_in_package(named);
  LabelPlace place;
  if (ending == ".gpkg" || ending == ".GPKG") {
    place.document = named;
    const fs::path below = named.parent_path() / "image.tif";
    if (is_package(named.parent_path()) && is_there(below)) place.image = below;
    if (place.image.empty()) place.image = image_of_document(named);
    return place;
  }
  const fs::path folder = named.has_parent_path() ? named.parent_path() : fs::path(".");
  const bool is_of_package = named.filename() == "image.tif" || named.filename() == "labels.tif";
  if (is_of_package && is_package(folder)) return place_in_package(folder);
  place.document = named.parent_path() / (named.stem().string() + ".labels.gpkg");
  place.image = named;
  if (is_there(place.document)) return place;
  auto empty = document_over(named, image, place.notices);
  if (!empty) return forward_error(empty);
  place.begins_as = std::move(*empty);
  return place;
}

LabelEdit paint_of_cells(const LabelDocument& document, const Raster<ClassId>& cells) {
  NADIR_REQUIRE(cells.width() == document.grid().width && cells.height() == document.grid().height);
  LabelEdit edit;
  for (int top = 0; top < cells.height(); top += kPaintTileSide) {
    for (int left = 0; left < cells.width(); left += kPaintTileSide) {
      const auto width = static_cast<std::size_t>(std::min(kPaintTileSide, cells.width() - left));
      auto tile = std::make_shared<PaintTile>();
      bool is_painted = false;
      for (int row = 0; row < std::min(kPaintTileSide, cells.height() - top); ++row) {
        const auto from = cells.row(top + row).subspan(static_cast<std::size_t>(left), width);
        for (std::size_t column = 0; column < width; ++column) {
          const ClassId id = from[column];
          if (id == kUnclassified) continue;
          tile->at(static_cast<int>(column), row) = id;
          is_painted = true;
        }
      }
      if (!is_painted) continue;
      edit.tiles.push_back(
          {{left / kPaintTileSide, top / kPaintTileSide}, {nullptr, std::move(tile)}});
    }
  }
  return edit;
}

}  // namespace nadir
