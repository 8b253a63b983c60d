// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/field.h"
#include "core/base/raster.h"
#include "core/map/semantic_classes.h"

namespace nadir {

/// How much of a map each class covers.
struct ClassStatistics {
  std::array<std::int64_t, kClassCount> cells{};
  std::int64_t classified_cells = 0;  ///< Sum of `cells`.
  std::int64_t all_cells = 0;         ///< With the unclassified ones.

  /// In [0, 1]; the shares of all classes sum to 1 unless no cell has a class.
  [[nodiscard]] double share_of_classified(ClassId id) const;
  /// In [0, 1]; the rest of the map is unclassified.
  [[nodiscard]] double share_of_all(ClassId id) const;
  [[nodiscard]] int present_classes() const;
};

/// Counts cells; ids that are no class count as unclassified. O(cells), same result on any number
/// of threads.
[[nodiscard]] ClassStatistics class_statistics(const Raster<ClassId>& labels);

/// Readings of the importance weight alpha_k (Rouben 2018, section 3.5). The text says that rare
/// classes are the stronger signal, yet equation 3.6 as printed gives the share itself.
enum class ImportanceReading {
  kInverseShare,      ///< 1 / share: the text, and what preset `thesis` uses.
  kShare,             ///< share: equation 3.6 to the letter.
  kInverseRootShare,  ///< 1 / sqrt(share): between the text and uniform; preset `default`.
  kUniform,           ///< The same for every class that the map holds.
};

template <>
struct EnumNames<ImportanceReading> {
  static constexpr std::array<std::string_view, 4> kNames{"inverse-share", "share",
                                                          "inverse-root-share", "uniform"};
};

using ClassWeights = std::array<double, kClassCount>;

/// alpha_k of each class. A class that the map does not hold has weight 0.
///
/// Normalised so that the mean over the classified cells, sum over k of share_of_classified(k) *
/// alpha_k, is 1: a cell drawn from the map at random has weight 1 on average in every reading, so
/// that errors of different readings and different maps are of one size. All are 0 where no cell
/// has a class.
[[nodiscard]] ClassWeights importance_weights(const ClassStatistics& statistics,
                                              ImportanceReading reading);

}  // namespace nadir
