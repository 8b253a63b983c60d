// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "core/base/sqlite_database.h"
#include "core/mcl/pose_estimate.h"
#include "core/run/run_limits.h"

namespace nadir::detail {

/// A row of a run file as somebody else may have written or edited it: takes values out, which need
/// only be of the right kind, and keeps the first that is not, so that a whole row is read before it is
/// asked for its fault. Whether the values make sense is for run_limits.h.
class RunRow {
 public:
  /// @param where  "R.nadir: table step, row 7", which begins every message.
  RunRow(const SqliteStatement& row, std::string where) : row_(row), where_(std::move(where)) {}

  /// NaN for NULL; text and blobs are noted.
  double number(int column);
  /// A whole number that fits an int and is not negative.
  int count(int column);
  /// Three columns.
  Rigid2 pose(int column);
  /// The same, or NULL in all three.
  std::optional<Rigid2> pose_if_known(int column);
  /// A pose and the six covariances after it.
  PoseMoments moments(int column);

  /// The fault if there was one: of kind, or else `of_value`, what run_limits.h says of the values.
  /// @errors kMalformed: "WHERE: COLUMN is VALUE, WHAT".
  [[nodiscard]] Result<void> checked(const std::optional<RunFault>& of_value);

 private:
  void refuse(int column, const char* what);

  const SqliteStatement& row_;
  std::string where_;
  std::string fault_;
};

}  // namespace nadir::detail
