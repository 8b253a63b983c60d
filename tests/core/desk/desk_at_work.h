// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "core/desk/label_desk.h"
#include "core/label/label_raster.h"
#include "core/map/overhead_map_file.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {

[[nodiscard]] inline LabelDesk opened_desk(const std::filesystem::path& path,
                                           const std::string& author = "ada",
                                           const LabelOpening& how = {}) {
  auto desk = LabelDesk::open(path, author, how);
  if (!desk) throw std::runtime_error(error_text(desk));
  return std::move(*desk);
}

/// An empty document of 120 x 90 cells of a metre, from the plane's origin to the right and down.
class DeskAtWork : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path() const { return scratch.path() / "labels.gpkg"; }
  [[nodiscard]] const LabelDocument& now() const { return desk.sheet().now(); }
  [[nodiscard]] std::size_t object_count() const { return now().objects().size(); }

  /// A tool of a kind, without snapping.
  void take_up(ToolKind kind, ClassId id = kRoad) {
    LabelTool tool = desk.tool();
    tool.kind = kind;
    tool.snaps = false;
    use_class(tool, id);
    ASSERT_EQ(error_text(desk.set_tool(tool)), "(no error)");
  }
  /// Places in cells, so y counts down.
  [[nodiscard]] Result<void> points(const std::vector<std::pair<double, double>>& places) {
    for (const Eigen::Vector2d& place : ring(places)) {
      if (auto added = desk.add_point(place, 0.1); !added) return added;
    }
    return {};
  }
  /// Draws an area of whole cells.
  ObjectId drawn_box(double left, double top, double right, double bottom, ClassId id = kRoad) {
    const auto done = desk.draw({ObjectKind::kArea, id, 0.0}, box(left, top, right, bottom));
    if (!done) throw std::runtime_error(error_text(done));
    return desk.selection().ids().back();
  }
  [[nodiscard]] ClassId class_at(double x, double y) const { return desk.under({x, -y}).class_id; }

  ScratchFolder scratch;
  LabelDesk desk = opened_desk(make());

 private:
  std::filesystem::path make() {
    // Made once a program, for that waits for the disk.
    static const ScratchFolder once;
    const std::filesystem::path blank = once.path() / "blank.gpkg";
    if (!std::filesystem::exists(blank)) {
      auto made = LabelStore::create(blank, test_plane(), test_grid(120, 90), "ada");
      if (!made) throw std::runtime_error(error_text(made));
    }
    std::filesystem::copy_file(blank, path());
    return path();
  }
};

/// A package whose left half is road, of 300 x 200 cells of a metre.
inline std::filesystem::path half_a_road(const std::filesystem::path& folder,
                                         bool has_image = false) {
  OverheadMap map{"half", test_plane(), 1.0, {0.0, 0.0}, {300, 200, kUnclassified}};
  for (int row = 0; row < 200; ++row) {
    for (int column = 0; column < 150; ++column) map.labels.at(column, row) = kRoad;
  }
  std::optional<ColourRaster> image;
  if (has_image) image = ColourRaster(300, 200, Colour{90, 120, 60});
  const auto written = write_overhead_map(map, {}, image, folder / "half");
  if (!written) throw std::runtime_error(error_text(written));
  return folder / "half";
}

MATCHER(Succeeds, "") {
  *result_listener << error_text(arg);
  return arg.has_value();
}

}  // namespace nadir
