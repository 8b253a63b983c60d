// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "core/mcl/pose_estimate.h"
#include "core/run/sqlite_database.h"

namespace nadir::detail {

/// A row of a run file as somebody else may have written or edited it: takes values out and keeps
/// the first that is none, so that a whole row is read before it is asked for its fault.
class RunRow {
 public:
  /// @param where  "R.nadir: table step, row 7", which begins every message.
  RunRow(const SqliteStatement& row, std::string where) : row_(row), where_(std::move(where)) {}

  /// A finite number.
  double number(int column);
  /// Not negative where it is known; NaN where it is NULL.
  double amount_if_known(int column);
  /// In [0, 1]; NULL only where `may_be_unknown`.
  double share(int column, bool may_be_unknown);
  /// A whole number that fits an int and is not negative.
  int count(int column);
  /// Three columns: a place within 10^8 m of the plane's origin, twice around the Earth, and an
  /// angle.
  Rigid2 pose(int column);
  /// The same, or NULL in all three.
  std::optional<Rigid2> pose_if_known(int column);
  /// A pose and the six covariances after it. Those may be NULL or infinite, which is "not known"; what
  /// is known must be variances that are not negative and correlations of at most 1 (to 1e-6, for a
  /// filter that has collapsed rounds).
  PoseMoments moments(int column);

  /// Notes a fault, unless there is one already: "WHERE: WHAT".
  void refuse(const std::string& what);
  /// The fault if there was one. @errors kMalformed.
  [[nodiscard]] Result<void> checked() const;

 private:
  /// NaN for NULL; anything else that is no number is noted.
  double number_or_null(int column);
  void refuse(int column, const char* what);
  void check(const Eigen::Matrix3d& covariance, int first_column);

  const SqliteStatement& row_;
  std::string where_;
  std::string fault_;
};

}  // namespace nadir::detail
