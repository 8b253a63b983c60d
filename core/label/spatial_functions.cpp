// SPDX-License-Identifier: Apache-2.0
#include "core/label/spatial_functions.h"

#include <sqlite3.h>

#include <array>
#include <cstdint>
#include <new>
#include <optional>
#include <span>

#include "core/label/label_blobs.h"

namespace nadir {
namespace {

/// Bounds of a geometry; empty ones where it has no places, nothing where it is none.
std::optional<PlaneBounds> bounds_of(sqlite3_value* value) {
  const auto* const bytes = static_cast<const std::uint8_t*>(sqlite3_value_blob(value));
  if (bytes == nullptr) return std::nullopt;
  const auto parts =
      parts_of_geometry({bytes, static_cast<std::size_t>(sqlite3_value_bytes(value))});
  if (!parts) return std::nullopt;
  PlaneBounds bounds;
  for (const GeometryPart& part : *parts) {
    for (const Ring& ring : part.rings) {
      for (const Eigen::Vector2d& point : ring) bounds.include(point);
    }
  }
  return bounds;
}

template <typename Answer>
void answer(sqlite3_context* context, sqlite3_value* value, Answer&& of_bounds) {
  try {
    const auto bounds = bounds_of(value);
    if (bounds) {
      of_bounds(*bounds);
    } else {
      sqlite3_result_null(context);
    }
  } catch (const std::bad_alloc&) {
    sqlite3_result_error_nomem(context);
  }
}

void is_empty(sqlite3_context* context, int, sqlite3_value** values) {
  answer(context, *values,
         [&](const PlaneBounds& bounds) { sqlite3_result_int(context, bounds.is_empty ? 1 : 0); });
}

/// Least or greatest coordinate along an axis: 0 is x, 1 is y.
template <bool is_high, int axis>
void limit(sqlite3_context* context, int, sqlite3_value** values) {
  answer(context, *values, [&](const PlaneBounds& bounds) {
    if (bounds.is_empty) {
      sqlite3_result_null(context);
    } else {
      sqlite3_result_double(context, (is_high ? bounds.high : bounds.low)(axis));
    }
  });
}

}  // namespace

int add_spatial_functions(sqlite3* database) {
  struct Function {
    const char* name;
    void (*call)(sqlite3_context*, int, sqlite3_value**);
  };
  constexpr std::array<Function, 5> kFunctions{{{"ST_IsEmpty", is_empty},
                                                {"ST_MinX", limit<false, 0>},
                                                {"ST_MaxX", limit<true, 0>},
                                                {"ST_MinY", limit<false, 1>},
                                                {"ST_MaxY", limit<true, 1>}}};
  for (const Function& function : kFunctions) {
    const int code = sqlite3_create_function_v2(
        database, function.name, 1, SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_INNOCUOUS, nullptr,
        function.call, nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) return code;
  }
  return SQLITE_OK;
}

}  // namespace nadir
