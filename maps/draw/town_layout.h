// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/map/semantic_classes.h"
#include "maps/draw/shapes.h"

namespace nadir::town {

/// What the ground is made of; each surface has one semantic class.
enum class Surface : std::uint8_t {
  kGrass,
  kDirt,
  kGravel,
  kWoods,
  kShrubs,
  kAsphalt,
  kNewAsphalt,
  kOldAsphalt,
  kConcrete,
  kSidewalk,
  kCurb,
  kWhitePaint,
  kYellowPaint,
  kFence,
  kWall,
  kIndoors,
};
[[nodiscard]] ClassId class_of(Surface surface);

enum class CentreLine : std::uint8_t { kNone, kDashed, kSolid, kDouble };

struct Street {
  Polyline centre = {};
  double half_width_m = 3.5;
  Surface surface = Surface::kAsphalt;
  bool curbs = true;
  double sidewalk_left_m = 0.0, sidewalk_right_m = 0.0;  ///< Widths; 0 where there is none.
  double verge_m = 0.0;                                  ///< Grass between curb and sidewalk.
  CentreLine centre_line = CentreLine::kDashed;
  double dash_m = 3.0, gap_m = 6.0, first_dash_m = 0.0;
  bool edge_lines = false;
};

/// Where two streets meet: their corners are rounded, and their lines stop `clear_m` from the
/// centre.
struct Junction {
  int first = 0, second = 0;  ///< Indices of streets.
  Point centre = Point::Zero();
  double radius_m = 5.0;
  double clear_m = 9.0;
};

/// A disc of road: a roundabout with its island, or a turning circle without.
struct Circle {
  Point centre = Point::Zero();
  double radius_m = 14.0, island_m = 0.0;
  double fillet_m = 6.0;
  double sidewalk_m = 0.0;
  std::vector<int> streets;
};

struct Pad {
  Polygon outline;
  Surface surface = Surface::kAsphalt;
};

struct Crossing {
  Point centre = Point::Zero();
  double road_heading_deg = 0.0, road_width_m = 8.0;
};
struct StopLine {
  Point centre = Point::Zero();
  double road_heading_deg = 0.0, length_m = 3.5;
};
struct Arrow {
  enum Kind : std::uint8_t { kAhead, kLeft, kRight };
  Point tail = Point::Zero();
  double heading_deg = 0.0;
  Kind kind = kAhead;
};
/// Parking bays side by side; a line leads from each corner of a bay into it.
struct BayRow {
  Point start = Point::Zero();
  double row_heading_deg = 0.0;  ///< The bays lie to the left of the row.
  int count = 0;
  double bay_width_m = 2.6, bay_depth_m = 5.0, lean_m = 0.0;
  double filled = 0.6;  ///< Share of bays with a car in the picture.
};
struct Painted {
  Polygon outline;
  bool yellow = false;
};

struct Wall {
  Polyline line;
  double width_m = 0.2, height_m = 1.6;
};

enum class Roof : std::uint8_t { kFlat, kHip, kGable };
enum class RoofCover : std::uint8_t {
  kDarkShingle,
  kBrownShingle,
  kRedTile,
  kWhiteMetal,
  kGreenMetal,
  kRustMetal,
  kGravelFlat,
  kWhiteFlat,
  kTarFlat,
};
struct Building {
  Polygon footprint = {};
  Roof roof = Roof::kHip;
  RoofCover cover = RoofCover::kDarkShingle;
  double eave_m = 3.0;
  double ridge_heading_deg = 0.0;  ///< Gables only.
  double pitch = 0.5;
};

struct Tree {
  Point centre = Point::Zero();
  double radius_m = 3.0;
};
struct Car {
  Point centre = Point::Zero();
  double heading_deg = 0.0;
  bool truck = false;
};
/// A box that stands about: a container, an air conditioner, a bin.
struct Crate {
  Polygon outline;
  double height_m = 2.5;
  int colour = 0;
};

/// The made town. Streets, pads, fences, buildings and vegetation reach the labels; the rest only
/// the picture.
struct TownLayout {
  double width_m = 250.0, height_m = 200.0, metres_per_cell = 0.1;
  std::vector<Street> streets = {};
  std::vector<Junction> junctions = {};
  std::vector<Circle> circles = {};
  std::vector<Pad> areas = {};      ///< Under the streets: yards, woods, car parks, paths.
  std::vector<Pad> lay_bys = {};    ///< Join the streets; the curb goes around them.
  std::vector<Pad> driveways = {};  ///< Over curbs and sidewalks.
  std::vector<Pad> islands = {};    ///< In the road, with a curb of their own.
  std::vector<Crossing> crossings = {};
  std::vector<StopLine> stop_lines = {};
  std::vector<Arrow> arrows = {};
  std::vector<BayRow> bay_rows = {};
  std::vector<Painted> painted = {};
  std::vector<Wall> fences = {}, hedges = {};
  std::vector<Building> buildings = {};
  std::vector<Tree> trees = {};
  std::vector<Car> cars = {};
  std::vector<Crate> crates = {};
  std::vector<Point> poles = {};
};

/// The proving ground, all of it data; the parts add themselves to one layout.
[[nodiscard]] TownLayout proving_ground_layout();
void add_streets(TownLayout& town);
void add_buildings(TownLayout& town);
void add_scenery(TownLayout& town);

}  // namespace nadir::town
