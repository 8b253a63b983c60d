// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/edit/edge_tree.h"
#include "core/quality/check_parts.h"

namespace nadir {
namespace {

constexpr std::int64_t kStripRows = 256;
/// How far around what was asked for cells are looked at first.
constexpr std::int64_t kFirstMargin = 64;

/// Whether the rest of a region could make a finding of it, or another one.
bool may_be_found(const RegionOfCells& region, double cell_m2, const CheckSettings& settings) {
  const auto code = static_cast<CellCode>(region.value);
  if (code == kOpenGround || code == kNarrowGround || code == kCurbAstray) return true;
  return covers_ground(code) && static_cast<double>(region.cells) * cell_m2 < settings.island_m2;
}

/// Whether it goes on outside of a window, within the grid.
bool is_cut(const RegionOfCells& region, const CellRect& window, const CellRect& whole) {
  const CellRect& cells = region.bounds;
  return (cells.left == window.left && window.left > whole.left) ||
         (cells.top == window.top && window.top > whole.top) ||
         (cells.right == window.right && window.right < whole.right) ||
         (cells.bottom == window.bottom && window.bottom < whole.bottom);
}

Result<std::vector<RegionOfCells>> regions_of(const CheckInput& input,
                                              const CellCoder& coder,
                                              const CellRect& window) {
  RegionFinder finder(window, cells_asked_for(input),
                      [](CellValue value) { return joins_corners(static_cast<CellCode>(value)); });
  for (std::int64_t top = window.top; top < window.bottom; top += kStripRows) {
    if (input.work.is_stopped()) return fail(ErrorCode::kCancelled, "the check was stopped");
    input.work.report(
        0.2 + 0.8 * static_cast<double>(top - window.top) / static_cast<double>(window.height()),
        "Looking at cells");
    const std::int64_t bottom = std::min(window.bottom, top + kStripRows);
    const Raster<CellCode> codes = coder.codes({window.left, top, window.right, bottom});
    for (int row = 0; row < codes.height(); ++row) finder.add_row(codes.row(row));
  }
  return finder.finish();
}

/// Objects of a class that cover a place, the top-most first.
std::vector<ObjectId> objects_on(const LabelDocument& document,
                                 ClassId id,
                                 const Eigen::Vector2d& place) {
  std::vector<std::pair<std::int64_t, ObjectId>> found;
  const PlaneBounds here = box_around(place, place);
  for (const auto& [number, placed] : document.objects()) {
    const LabelObject& object = *placed.object;
    if (object.class_id != id || !do_meet(placed.bounds, here)) continue;
    bool is_on = false;
    if (object.kind == ObjectKind::kLine) {
      const Ring& line = object.rings.front();
      for (std::size_t i = 1; i < line.size() && !is_on; ++i) {
        is_on =
            (nearest_on_edge(line[i - 1], line[i], place) - place).norm() <= object.width_m / 2.0;
      }
    } else {
      is_on = EdgeTree(object.rings, true).holds(place);
    }
    if (is_on) found.emplace_back(object.order, number);
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<ObjectId> ids;
  ids.reserve(found.size());
  for (const auto& [order, number] : found) ids.push_back(number);
  return ids;
}

/// "road and sidewalk", those with most sides first; "road" where there is only one.
std::string neighbours_text(const RegionOfCells& region) {
  std::vector<std::pair<std::int64_t, ClassId>> classes;
  for (const auto& [value, count] : region.sides) {
    const ClassId id = class_of_code(static_cast<CellCode>(std::min<CellValue>(value, kLeftOut)));
    if (id != kUnclassified) classes.emplace_back(-count, id);
  }
  std::sort(classes.begin(), classes.end());
  std::string text{class_info(classes.front().second).name};
  if (classes.size() > 1) text += fmt::format(" and {}", class_info(classes[1].second).name);
  return text;
}

Finding finding_at(const CheckInput& input, const RegionOfCells& region, FindingKind kind) {
  Finding finding;
  finding.kind = kind;
  finding.severity = FindingSeverity::kDoubt;
  finding.bounds = bounds_of_cells(input.grid, region.bounds);
  finding.place_in_enu_m = centre_of_cell(input.grid, region.column, region.row);
  finding.size =
      static_cast<double>(region.cells) * input.grid.metres_per_cell * input.grid.metres_per_cell;
  finding.has_area = true;
  return finding;
}

void add_unlabelled(const CheckInput& input,
                    const RegionOfCells& region,
                    std::vector<Finding>& findings) {
  Finding finding = finding_at(input, region, FindingKind::kUnlabelled);
  if (finding.size < input.settings.unlabelled_m2) return;
  finding.sentence = fmt::format("unlabelled ground of {} m2", size_text(finding.size));
  if (region.sides_with(kBeyondLabels) + region.sides_with(kBesideWindow) > 0) {
    finding.severity = FindingSeverity::kHint;
    finding.sentence += " at the edge of what is labelled";
  }
  finding.why_not_fix = "what lies there is seen in the image only";
  findings.push_back(std::move(finding));
}

void add_gap(const CheckInput& input, const RegionOfCells& region, std::vector<Finding>& findings) {
  Finding finding = finding_at(input, region, FindingKind::kGap);
  if (finding.size < input.settings.gap_m2 || labelled_sides(region) == 0) return;
  const double area_m2 = finding.size;
  finding.size =
      std::min(region.mean_width() * input.grid.metres_per_cell, input.settings.gap_width_m);
  finding.has_area = false;
  finding.sentence = fmt::format("gap at {}, {} m wide and {} m long", neighbours_text(region),
                                 size_text(finding.size), size_text(area_m2 / finding.size));
  findings.push_back(std::move(finding));
}

void add_island(const CheckInput& input,
                const RegionOfCells& region,
                std::vector<Finding>& findings) {
  Finding finding = finding_at(input, region, FindingKind::kIsland);
  // What the grid's edge cuts may be large beyond it.
  if (!(finding.size < input.settings.island_m2) || region.sides_with(kBesideWindow) > 0) return;
  finding.severity = FindingSeverity::kHint;
  finding.class_id = static_cast<ClassId>(region.value);
  finding.objects = objects_on(input.document, finding.class_id, finding.place_in_enu_m);
  finding.sentence =
      fmt::format("{} island of {} m2", class_info(finding.class_id).name, size_text(finding.size));
  const ClassId around = class_around(region);
  if (2 * labelled_sides(region) < region.all_sides()) {
    finding.sentence += " on unlabelled ground";
    finding.why_not_fix = "most of what surrounds it is unlabelled";
  } else {
    finding.sentence += fmt::format(" in {}", class_info(around).name);
  }
  findings.push_back(std::move(finding));
}

void add_stray_curb(const CheckInput& input,
                    const RegionOfCells& region,
                    std::vector<Finding>& findings) {
  Finding finding = finding_at(input, region, FindingKind::kStrayCurb);
  finding.size /= region.mean_width() * input.grid.metres_per_cell;
  finding.has_area = false;
  if (finding.size < input.settings.curb_length_m) return;
  finding.class_id = kCurb;
  finding.objects = objects_on(input.document, kCurb, finding.place_in_enu_m);
  finding.sentence =
      fmt::format("about {:.0f} m of curb follow no road", std::max(1.0, finding.size));
  finding.why_not_fix = "either a road is missing there, or the curb lies wrong";
  findings.push_back(std::move(finding));
}

}  // namespace

std::int64_t labelled_sides(const RegionOfCells& region) {
  std::int64_t all = 0;
  for (const auto& [value, count] : region.sides) {
    if (value < kClassCount || value == kCurbAstray) all += count;
  }
  return all;
}

ClassId class_around(const RegionOfCells& region) {
  std::array<std::int64_t, kClassCount> sides{};
  std::int64_t at_ground = 0;
  for (const auto& [value, count] : region.sides) {
    if (value >= kClassCount && value != kCurbAstray) continue;
    const ClassId id = class_of_code(static_cast<CellCode>(value));
    sides.at(id) += count;
    if (covers_ground(id)) at_ground += count;
  }
  const bool takes_ground = 3 * at_ground >= labelled_sides(region);
  ClassId found = kUnclassified;
  std::int64_t most = 0;
  for (ClassId id = 0; id < kClassCount; ++id) {
    if ((takes_ground && !covers_ground(id)) || sides.at(id) <= most) continue;
    most = sides.at(id);
    found = id;
  }
  return found;
}

Result<void> check_regions(const CheckInput& input, std::vector<Finding>& findings) {
  const CellRect whole = input.grid.whole();
  const CellRect asked_for = cells_asked_for(input);
  if (asked_for.empty()) return {};
  const CellCoder coder(input.document, input.grid, input.settings);
  if (coder.extent().empty()) return {};
  const double cell_m2 = input.grid.metres_per_cell * input.grid.metres_per_cell;
  for (std::int64_t margin = kFirstMargin;; margin *= 4) {
    const CellRect window = CellRect{asked_for.left - margin, asked_for.top - margin,
                                     asked_for.right + margin, asked_for.bottom + margin}
                                .cut_to(whole);
    auto regions = regions_of(input, coder, window);
    if (!regions) return forward_error(regions);
    std::erase_if(*regions, [](const RegionOfCells& region) { return !region.is_touched; });
    const bool is_known =
        std::none_of(regions->begin(), regions->end(), [&](const RegionOfCells& region) {
          return is_cut(region, window, whole) && may_be_found(region, cell_m2, input.settings);
        });
    if (!is_known) continue;
    for (const RegionOfCells& region : *regions) {
      const auto code = static_cast<CellCode>(region.value);
      if (code == kOpenGround) add_unlabelled(input, region, findings);
      if (code == kNarrowGround) add_gap(input, region, findings);
      if (code == kCurbAstray) add_stray_curb(input, region, findings);
      if (covers_ground(code)) add_island(input, region, findings);
    }
    return {};
  }
}

}  // namespace nadir
