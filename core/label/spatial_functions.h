// SPDX-License-Identifier: Apache-2.0
#pragma once

struct sqlite3;

namespace nadir {

/// Gives a connection the functions ST_IsEmpty, ST_MinX, ST_MaxX, ST_MinY and ST_MaxY of GeoPackage geometries, which the
/// triggers of a spatial index call: without them a table that a GIS has indexed cannot be written. Private to this module.
/// @returns SQLite's code.
[[nodiscard]] int add_spatial_functions(sqlite3* database);

}  // namespace nadir
