// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace nadir {

/// The tables of labels.gpkg. Private to this module; core/label/README.md explains them.

/// Rises when a reader of the old format could misread the new one.
inline constexpr std::int64_t kLabelFormat = 1;
/// "GPKG" in ASCII, at byte 68 of the file; version 1.3.
inline constexpr std::int32_t kGeoPackageId = 0x47504B47;
inline constexpr int kGeoPackageVersion = 10300;
/// Of the project plane. Numbers from 100000 on are nobody's.
inline constexpr std::int32_t kPlaneSrsId = 100000;

/// OGC 12-128r17, table by table; then those that a GIS shows, then ours. The comments stay in the file.
inline constexpr std::string_view kLabelSchema = R"(
CREATE TABLE gpkg_spatial_ref_sys (
  srs_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL PRIMARY KEY,
  organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL,
  definition TEXT NOT NULL,
  description TEXT
);
CREATE TABLE gpkg_contents (
  table_name TEXT NOT NULL PRIMARY KEY,
  data_type TEXT NOT NULL,
  identifier TEXT UNIQUE,
  description TEXT DEFAULT '',
  last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')),
  min_x DOUBLE,
  min_y DOUBLE,
  max_x DOUBLE,
  max_y DOUBLE,
  srs_id INTEGER,
  CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id)
);
CREATE TABLE gpkg_geometry_columns (
  table_name TEXT NOT NULL,
  column_name TEXT NOT NULL,
  geometry_type_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL,
  z TINYINT NOT NULL,
  m TINYINT NOT NULL,
  CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name),
  CONSTRAINT uk_gc_table_name UNIQUE (table_name),
  CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name),
  CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id)
);
CREATE TABLE area (
  fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL,
  geom POLYGON,
  class TEXT,
  drawing_order INTEGER,
  note TEXT
);
CREATE TABLE line (
  fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL,
  geom LINESTRING,
  class TEXT,
  width_m REAL,
  drawing_order INTEGER,
  note TEXT
);
CREATE TABLE outline (
  fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL,
  geom POLYGON,
  class TEXT,
  thickness_m REAL,
  drawing_order INTEGER,
  note TEXT
);
CREATE TABLE nadir_about (  -- Format, plane and grid of the document
  fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL,
  key TEXT NOT NULL UNIQUE,
  value TEXT NOT NULL
);
CREATE TABLE nadir_value (  -- What the document knows beside what is drawn
  key TEXT PRIMARY KEY,
  value TEXT NOT NULL
);
CREATE TABLE nadir_object (  -- Each object as Nadir last wrote it, to find what others have changed
  object INTEGER PRIMARY KEY,
  image BLOB NOT NULL
);
CREATE TABLE nadir_tile (  -- zstd of 256 x 256 painted cells
  tile_column INTEGER NOT NULL,
  tile_row INTEGER NOT NULL,
  data BLOB NOT NULL,
  PRIMARY KEY (tile_column, tile_row)
);
CREATE TABLE nadir_step (  -- Edits: a tree, for what comes after undo begins a branch
  step INTEGER PRIMARY KEY,
  parent INTEGER NOT NULL,  -- 0: the empty document
  time TEXT NOT NULL,
  author TEXT NOT NULL,
  title TEXT NOT NULL
);
CREATE INDEX nadir_step_parent ON nadir_step (parent);
CREATE TABLE nadir_object_change (  -- What differs between an object's images
  step INTEGER NOT NULL,
  object INTEGER NOT NULL,
  delta BLOB NOT NULL,
  PRIMARY KEY (step, object)
);
CREATE TABLE nadir_tile_change (  -- zstd of the cells before XOR after; 254 is nothing
  step INTEGER NOT NULL,
  tile_column INTEGER NOT NULL,
  tile_row INTEGER NOT NULL,
  delta BLOB NOT NULL,
  PRIMARY KEY (step, tile_column, tile_row)
);
CREATE TABLE nadir_value_change (
  step INTEGER NOT NULL,
  key TEXT NOT NULL,
  before TEXT,
  after TEXT,
  PRIMARY KEY (step, key)
);
CREATE TABLE nadir_head (  -- The step that all tables stand at
  one INTEGER PRIMARY KEY CHECK (one = 1),
  step INTEGER NOT NULL
);
INSERT INTO nadir_head VALUES (1, 0);
INSERT INTO gpkg_spatial_ref_sys VALUES
  ('Undefined cartesian SRS', -1, 'NONE', -1, 'undefined', 'undefined cartesian coordinate reference system'),
  ('Undefined geographic SRS', 0, 'NONE', 0, 'undefined', 'undefined geographic coordinate reference system'),
  ('WGS 84 geodetic', 4326, 'EPSG', 4326, 'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AXIS["Latitude",NORTH],AXIS["Longitude",EAST],AUTHORITY["EPSG","4326"]]', 'longitude/latitude coordinates in decimal degrees on the WGS 84 spheroid');
)";

/// Run once the plane is known: layers, and nadir_about, which being listed keeps the tables of ours out of sight.
inline constexpr std::string_view kLabelContents = R"(
INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('area', 'features', 'area', 'Areas of a class', 100000),
  ('line', 'features', 'line', 'Lines of a class with their width', 100000),
  ('outline', 'features', 'outline', 'Outlines of a class with their thickness', 100000),
  ('nadir_about', 'attributes', 'nadir_about', 'What Nadir knows of this document', NULL);
INSERT INTO gpkg_geometry_columns VALUES
  ('area', 'geom', 'POLYGON', 100000, 0, 0),
  ('line', 'geom', 'LINESTRING', 100000, 0, 0),
  ('outline', 'geom', 'POLYGON', 100000, 0, 0);
)";

}  // namespace nadir
