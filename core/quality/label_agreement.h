// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/raster.h"
#include "core/label/label_document.h"

namespace nadir {

/// How far two people, or two versions of their labels, agree on the same ground, and taking over what the other has. Both
/// documents are on the same plane; cells are those of any grid on it. Rasters are made strip by strip.

/// How many cells have which class in each.
struct ConfusionMatrix {
  static constexpr std::size_t kSide =
      kClassCount + 1;  ///< By class, the last what is unclassified.
  std::array<std::array<std::int64_t, kSide>, kSide> cells{};  ///< [mine][theirs].
  friend bool operator==(const ConfusionMatrix&, const ConfusionMatrix&) = default;
};
/// @param window  Of the grid; what reaches out of it does not count. @errors kCancelled. O(cells).
[[nodiscard]] Result<ConfusionMatrix> confusion_of(const LabelDocument& mine,
                                                   const LabelDocument& theirs,
                                                   const LabelGrid& grid,
                                                   const CellRect& window,
                                                   const WorkContext& work = {});

/// Of one class against all others.
struct ClassAgreement {
  std::int64_t mine = 0, theirs = 0, both = 0;  ///< Cells.
  std::optional<double> iou;  ///< both / (mine + theirs - both); nothing where neither has any.
  std::optional<double>
      kappa;  ///< Cohen's; nothing where chance alone would make them agree everywhere.
};
/// Of the cells that both have labelled, but for those that count what is not.
struct AgreementSummary {
  std::int64_t cells = 0;  ///< That both have labelled.
  std::int64_t only_mine = 0, only_theirs = 0, neither = 0;
  std::optional<double>
      agreement;                ///< Share with the same class; nothing where there are no cells.
  std::optional<double> kappa;  ///< Cohen's, over all classes; as in ClassAgreement.
  std::array<ClassAgreement, kClassCount> classes;
  /// Share of all cells that at least one has not labelled; 0 where there are no cells.
  [[nodiscard]] double unlabelled_share() const;
};
/// Kappa is (observed - expected) / (1 - expected) agreement, the expected one by the shares of classes alone.
/// See Cohen, A coefficient of agreement for nominal scales, 1960.
[[nodiscard]] AgreementSummary summary_of(const ConfusionMatrix& matrix);

enum class CellAgreement : std::uint8_t { kNeither, kAgree, kDiffer, kOnlyMine, kOnlyTheirs };
/// For a layer: what each cell of a window is, row by row. @param window  May reach out of the grid. O(cells).
[[nodiscard]] Raster<CellAgreement> cell_agreement(const LabelDocument& mine,
                                                   const LabelDocument& theirs,
                                                   const LabelGrid& grid,
                                                   const CellRect& window);

/// Cells of one class in mine and of another in theirs that hang together by their sides.
struct DisagreementRegion {
  ClassId mine = kUnclassified, theirs = kUnclassified;
  std::int64_t cells = 0;
  double size_m2 = 0.0;
  PlaneBounds bounds;
  Eigen::Vector2d place_in_enu_m = Eigen::Vector2d::Zero();  ///< Centre of a cell of it.
};
/// @param least_m2  Smaller ones are left out: borders are never drawn the same twice.
/// @returns         The largest first; equally large ones from north to south, then west to east.
/// @errors kCancelled. O(cells).
[[nodiscard]] Result<std::vector<DisagreementRegion>> disagreements(const LabelDocument& mine,
                                                                    const LabelDocument& theirs,
                                                                    const LabelGrid& grid,
                                                                    const CellRect& window,
                                                                    double least_m2,
                                                                    const WorkContext& work = {});

/// Makes a region of mine what it is in theirs: by taking over, replacing or removing one object where that gives all of the
/// region and changes no cell to anything but theirs; else by paint on its cells.
/// @param grid  With which the region was found. @errors kInvalidOptions: the labels have changed since, and there is no such
/// region any more.
[[nodiscard]] Result<LabelEdit> take_theirs(const LabelDocument& mine,
                                            const LabelDocument& theirs,
                                            const LabelGrid& grid,
                                            const DisagreementRegion& region);

}  // namespace nadir
