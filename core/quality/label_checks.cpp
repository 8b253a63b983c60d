// SPDX-License-Identifier: Apache-2.0
#include "core/quality/label_checks.h"

#include <algorithm>
#include <tuple>

#include "core/base/require.h"
#include "core/edit/edge_tree.h"
#include "core/quality/check_parts.h"

namespace nadir {
namespace {

bool is_same_box(const PlaneBounds& a, const PlaneBounds& b) {
  return a.is_empty == b.is_empty && a.low == b.low && a.high == b.high;
}

/// Most severe first, then from north to south, from west to east.
bool comes_before(const Finding& a, const Finding& b) {
  const auto rank = [](const Finding& finding) {
    return std::make_tuple(finding.severity, -finding.place_in_enu_m.y(),
                           finding.place_in_enu_m.x(), finding.kind);
  };
  return std::make_tuple(rank(a), std::cref(a.objects)) <
         std::make_tuple(rank(b), std::cref(b.objects));
}

}  // namespace

bool operator==(const Finding& a, const Finding& b) {
  return a.kind == b.kind && a.severity == b.severity && a.class_id == b.class_id &&
         a.objects == b.objects && is_same_box(a.bounds, b.bounds) &&
         a.place_in_enu_m == b.place_in_enu_m && a.size == b.size && a.has_area == b.has_area &&
         a.sentence == b.sentence && a.why_not_fix == b.why_not_fix;
}

bool is_asked_for(const CheckInput& input, const PlaneBounds& bounds) {
  return !input.within || do_meet(*input.within, bounds);
}

CellRect cells_asked_for(const CheckInput& input) {
  const CellRect whole = input.grid.whole();
  return input.within ? input.grid.cells_of(*input.within, 0).cut_to(whole) : whole;
}

std::string size_text(double size) {
  std::string text = size >= 10.0   ? fmt::format("{:.0f}", size)
                     : size >= 1.0  ? fmt::format("{:.1f}", size)
                     : size >= 0.01 ? fmt::format("{:.2f}", size)
                                    : fmt::format("{:.5f}", size);
  if (text.find('.') == std::string::npos) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string named(const LabelObject& object) {
  return fmt::format("{} {} {}", class_info(object.class_id).name, enum_name(object.kind),
                     object.id);
}

PlaneBounds bounds_of_cells(const LabelGrid& grid, const CellRect& cells) {
  PlaneBounds bounds;
  bounds.include(
      grid.enu_from_cells({static_cast<double>(cells.left), static_cast<double>(cells.top)}));
  bounds.include(
      grid.enu_from_cells({static_cast<double>(cells.right), static_cast<double>(cells.bottom)}));
  return bounds;
}

Eigen::Vector2d centre_of_cell(const LabelGrid& grid, std::int64_t column, std::int64_t row) {
  return grid.enu_from_cells({static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5});
}

double length_m(const Ring& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

Result<std::vector<Finding>> check_labels(const LabelDocument& document,
                                          const LabelGrid& grid,
                                          const CheckSettings& settings,
                                          const std::optional<PlaneBounds>& within,
                                          const WorkContext& work) {
  NADIR_REQUIRE(grid.metres_per_cell > 0.0);
  if (const auto sound = validate(settings); !sound) return forward_error(sound);
  const CheckInput input{document, grid, settings, within, work};
  std::vector<Finding> findings;
  if (within && within->is_empty) return findings;
  work.report(0.0, "Looking at objects");
  if (const auto done = check_shapes(input, findings); !done) return forward_error(done);
  check_duplicates(input, findings);
  check_ends(input, findings);
  if (const auto done = check_overlaps(input, findings); !done) return forward_error(done);
  if (const auto done = check_regions(input, findings); !done) return forward_error(done);
  std::stable_sort(findings.begin(), findings.end(), comes_before);
  return findings;
}

}  // namespace nadir
