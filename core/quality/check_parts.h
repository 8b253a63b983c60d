// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/quality/cell_codes.h"
#include "core/quality/cell_regions.h"
#include "core/quality/label_checks.h"

namespace nadir {

/// The parts of check_labels(). Private to this module.

struct CheckInput {
  const LabelDocument& document;
  const LabelGrid& grid;
  const CheckSettings& settings;
  const std::optional<PlaneBounds>& within;
  const WorkContext& work;
};
/// Whether bounds meet what was asked for.
[[nodiscard]] bool is_asked_for(const CheckInput& input, const PlaneBounds& bounds);
/// Of the cells, all where everything is asked for.
[[nodiscard]] CellRect cells_asked_for(const CheckInput& input);

[[nodiscard]] Result<void> check_shapes(const CheckInput& input, std::vector<Finding>& findings);
void check_duplicates(const CheckInput& input, std::vector<Finding>& findings);
void check_ends(const CheckInput& input, std::vector<Finding>& findings);
[[nodiscard]] Result<void> check_overlaps(const CheckInput& input, std::vector<Finding>& findings);
[[nodiscard]] Result<void> check_regions(const CheckInput& input, std::vector<Finding>& findings);

/// A number as people write it: "0.04", "1.5", "312".
[[nodiscard]] std::string size_text(double size);
/// "road area 12".
[[nodiscard]] std::string named(const LabelObject& object);
/// Corner to corner of some cells.
[[nodiscard]] PlaneBounds bounds_of_cells(const LabelGrid& grid, const CellRect& cells);
[[nodiscard]] Eigen::Vector2d centre_of_cell(const LabelGrid& grid,
                                             std::int64_t column,
                                             std::int64_t row);
/// The class that most of a region's sides lie at, of those that cover ground where these have a third of the labelled sides;
/// kUnclassified where there is none.
[[nodiscard]] ClassId class_around(const RegionOfCells& region);
/// Sides that lie at anything with a class.
[[nodiscard]] std::int64_t labelled_sides(const RegionOfCells& region);

/// Length of a line, metres.
[[nodiscard]] double length_m(const Ring& line);
/// What an object covers of a window of cells, row by row: areas, and outlines with what they surround.
/// @param take  Gets every row of the window.
void visit_claimed(
    const LabelObject& object,
    const LabelGrid& grid,
    const CellRect& window,
    const std::function<void(std::int64_t row, std::int64_t from, std::int64_t to)>& take);

}  // namespace nadir
