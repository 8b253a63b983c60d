// SPDX-License-Identifier: Apache-2.0
#include "core/quality/label_agreement.h"

#include <algorithm>
#include <functional>
#include <tuple>

#include "core/label/label_raster.h"
#include "core/quality/cell_regions.h"
#include "core/quality/check_parts.h"

namespace nadir {
namespace {

constexpr std::int64_t kStripOfTwo = 256;
constexpr CellValue kSameInBoth = 0xFFF0;

std::size_t counted(ClassId id) { return std::min<std::size_t>(id, kClassCount); }

/// Calls `take(strip, mine, theirs)` for a window from the top.
Result<void> visit_strips(
    const LabelDocument& mine,
    const LabelDocument& theirs,
    const LabelGrid& grid,
    const CellRect& window,
    const WorkContext& work,
    const std::function<void(const Raster<ClassId>&, const Raster<ClassId>&)>& take) {
  for (std::int64_t top = window.top; top < window.bottom; top += kStripOfTwo) {
    if (work.is_stopped()) return fail(ErrorCode::kCancelled, "the comparison was stopped");
    work.report(static_cast<double>(top - window.top) / static_cast<double>(window.height()),
                "Comparing labels");
    const CellRect strip{window.left, top, window.right,
                         std::min(window.bottom, top + kStripOfTwo)};
    take(rasterise(mine, grid, strip), rasterise(theirs, grid, strip));
  }
  return {};
}

/// Nothing where chance alone would make both agree everywhere.
std::optional<double> kappa_of(double observed, double expected) {
  if (!(expected < 1.0)) return std::nullopt;
  return (observed - expected) / (1.0 - expected);
}

ClassAgreement agreement_on(const ConfusionMatrix& matrix, std::size_t id, double all) {
  ClassAgreement agreement;
  agreement.both = matrix.cells.at(id).at(id);
  for (std::size_t other = 0; other < kClassCount; ++other) {
    agreement.mine += matrix.cells.at(id).at(other);
    agreement.theirs += matrix.cells.at(other).at(id);
  }
  const std::int64_t either = agreement.mine + agreement.theirs - agreement.both;
  if (either == 0) return agreement;
  const auto mine = static_cast<double>(agreement.mine) / all;
  const auto theirs = static_cast<double>(agreement.theirs) / all;
  const auto both = static_cast<double>(agreement.both);
  agreement.iou = both / static_cast<double>(either);
  agreement.kappa = kappa_of((all - static_cast<double>(either) + both) / all,
                             mine * theirs + (1.0 - mine) * (1.0 - theirs));
  return agreement;
}

CellAgreement agreement_of(ClassId mine, ClassId theirs) {
  if (mine == kUnclassified && theirs == kUnclassified) return CellAgreement::kNeither;
  if (mine == theirs) return CellAgreement::kAgree;
  if (theirs == kUnclassified) return CellAgreement::kOnlyMine;
  return mine == kUnclassified ? CellAgreement::kOnlyTheirs : CellAgreement::kDiffer;
}

ClassId class_of_count(CellValue id) {
  return id < kClassCount ? static_cast<ClassId>(id) : ClassId{kUnclassified};
}

}  // namespace

double AgreementSummary::unlabelled_share() const {
  const std::int64_t unlabelled = only_mine + only_theirs + neither;
  if (cells + unlabelled == 0) return 0.0;
  return static_cast<double>(unlabelled) / static_cast<double>(cells + unlabelled);
}

Result<ConfusionMatrix> confusion_of(const LabelDocument& mine,
                                     const LabelDocument& theirs,
                                     const LabelGrid& grid,
                                     const CellRect& window,
                                     const WorkContext& work) {
  ConfusionMatrix matrix;
  const auto counted_all =
      visit_strips(mine, theirs, grid, window.cut_to(grid.whole()), work,
                   [&](const Raster<ClassId>& a, const Raster<ClassId>& b) {
                     for (std::size_t i = 0; i < a.size(); ++i) {
                       ++matrix.cells[counted(a.values()[i])][counted(b.values()[i])];
                     }
                   });
  if (!counted_all) return forward_error(counted_all);
  return matrix;
}

AgreementSummary summary_of(const ConfusionMatrix& matrix) {
  AgreementSummary summary;
  std::int64_t same = 0;
  for (std::size_t i = 0; i < kClassCount; ++i) {
    summary.only_mine += matrix.cells.at(i).at(kClassCount);
    summary.only_theirs += matrix.cells.at(kClassCount).at(i);
    same += matrix.cells.at(i).at(i);
    for (std::size_t j = 0; j < kClassCount; ++j) summary.cells += matrix.cells.at(i).at(j);
  }
  summary.neither = matrix.cells.at(kClassCount).at(kClassCount);
  if (summary.cells == 0) return summary;
  const auto all = static_cast<double>(summary.cells);
  double expected = 0.0;
  for (std::size_t id = 0; id < kClassCount; ++id) {
    ClassAgreement& agreement = summary.classes.at(id);
    agreement = agreement_on(matrix, id, all);
    expected +=
        static_cast<double>(agreement.mine) / all * (static_cast<double>(agreement.theirs) / all);
  }
  summary.agreement = static_cast<double>(same) / all;
  summary.kappa = kappa_of(*summary.agreement, expected);
  return summary;
}

Raster<CellAgreement> cell_agreement(const LabelDocument& mine,
                                     const LabelDocument& theirs,
                                     const LabelGrid& grid,
                                     const CellRect& window) {
  const Raster<ClassId> a = rasterise(mine, grid, window);
  const Raster<ClassId> b = rasterise(theirs, grid, window);
  Raster<CellAgreement> agreement(a.width(), a.height());
  std::transform(a.values().begin(), a.values().end(), b.values().begin(),
                 agreement.values().begin(), agreement_of);
  return agreement;
}

Result<std::vector<DisagreementRegion>> disagreements(const LabelDocument& mine,
                                                      const LabelDocument& theirs,
                                                      const LabelGrid& grid,
                                                      const CellRect& window,
                                                      double least_m2,
                                                      const WorkContext& work) {
  const CellRect cells = window.cut_to(grid.whole());
  RegionFinder finder(cells, {}, [](CellValue) { return false; });
  std::vector<CellValue> row;
  const auto found = visit_strips(
      mine, theirs, grid, cells, work, [&](const Raster<ClassId>& a, const Raster<ClassId>& b) {
        for (int y = 0; y < a.height(); ++y) {
          row.clear();
          for (int x = 0; x < a.width(); ++x) {
            const ClassId id = a.at(x, y);
            const ClassId other = b.at(x, y);
            row.push_back(id == other ? kSameInBoth
                                      : static_cast<CellValue>(
                                            counted(id) * ConfusionMatrix::kSide + counted(other)));
          }
          finder.add_row(std::span<const CellValue>(row));
        }
      });
  if (!found) return forward_error(found);
  std::vector<DisagreementRegion> regions;
  for (const RegionOfCells& one : finder.finish()) {
    if (one.value == kSameInBoth) continue;
    const double size_m2 =
        static_cast<double>(one.cells) * grid.metres_per_cell * grid.metres_per_cell;
    if (size_m2 < least_m2) continue;
    regions.push_back({class_of_count(static_cast<CellValue>(one.value / ConfusionMatrix::kSide)),
                       class_of_count(static_cast<CellValue>(one.value % ConfusionMatrix::kSide)),
                       one.cells, size_m2, bounds_of_cells(grid, one.bounds),
                       centre_of_cell(grid, one.column, one.row)});
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [](const DisagreementRegion& a, const DisagreementRegion& b) {
                     return std::make_tuple(-a.cells, -a.place_in_enu_m.y(), a.place_in_enu_m.x()) <
                            std::make_tuple(-b.cells, -b.place_in_enu_m.y(), b.place_in_enu_m.x());
                   });
  return regions;
}

}  // namespace nadir
