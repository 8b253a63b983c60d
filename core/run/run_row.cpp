// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_row.h"

#include <limits>

namespace nadir::detail {

void RunRow::refuse(int column, const char* what) {
  if (!fault_.empty()) return;
  const std::string value = row_.is_null(column) ? "NULL" : row_.text(column).substr(0, 40);
  fault_ = fmt::format("{} is {}, {}", row_.column_name(column), value, what);
}

Result<void> RunRow::checked(const std::optional<RunFault>& of_value) {
  if (of_value && of_value->column) refuse(*of_value->column, of_value->what);
  if (of_value && fault_.empty()) fault_ = of_value->what;
  if (fault_.empty()) return {};
  return fail(ErrorCode::kMalformed, "{}: {}", where_, fault_);
}

double RunRow::number(int column) {
  if (!row_.is_null(column) && !row_.is_number(column)) refuse(column, "not a number");
  return row_.number(column);
}

int RunRow::count(int column) {
  const std::int64_t value = row_.whole(column);
  if (!row_.is_whole(column) || value < 0 || value > std::numeric_limits<int>::max()) {
    refuse(column, kNoCount);
    return 0;
  }
  return static_cast<int>(value);
}

Rigid2 RunRow::pose(int column) { return {number(column), number(column + 1), number(column + 2)}; }

std::optional<Rigid2> RunRow::pose_if_known(int column) {
  if (row_.is_null(column) && row_.is_null(column + 1) && row_.is_null(column + 2)) {
    return std::nullopt;
  }
  return pose(column);
}

PoseMoments RunRow::moments(int column) {
  PoseMoments moments{.mean = pose(column)};
  int next = column + 3;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const double value = number(next);
      moments.covariance(i, j) = value;
      moments.covariance(j, i) = value;
      ++next;
    }
  }
  return moments;
}

}  // namespace nadir::detail
