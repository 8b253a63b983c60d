// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "core/base/field.h"

namespace nadir {

/// What labels are written as for other programs.
enum class LabelFormat {
  kMapPackage,   ///< A folder with labels.tif and map.toml (core/map/README.md).
  kGeoJson,      ///< One file: all objects, in longitude and latitude.
  kShapefile,    ///< A folder: area.shp, line.shp, outline.shp, on the project plane.
  kClassImages,  ///< A folder: a black-and-white PNG a class with world file, and scale.toml.
  kIndexedPng,   ///< A PNG with palette, its world file and what GIS programs read beside it.
  kCoco,         ///< One JSON file: a region of one class is one annotation.
};
template <>
struct EnumNames<LabelFormat> {
  static constexpr std::array<std::string_view, 6> kNames = {
      "package", "geojson", "shapefile", "class-images", "indexed-png", "coco"};
};

}  // namespace nadir
