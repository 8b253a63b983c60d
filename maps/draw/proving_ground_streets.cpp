// SPDX-License-Identifier: Apache-2.0
#include "maps/draw/town_layout.h"

namespace nadir::town {
namespace {

enum StreetIndex : int { kMain, kRange, kWest, kNorth, kSecond, kCourt, kThird, kEast, kAlley };

Polyline north_lane() {
  Polyline line{{{-89.0, 66.0}}};
  append_arc(line, {64.0, 26.0}, 40.0, 90.0, 0.0);  // the curved street
  line.points.emplace_back(104.0, -2.0);
  return line;
}

std::vector<Street> streets() {
  // On a crossing the street that comes first runs through.
  // No two streets share width, sidewalks, centre line and dash phase: corners should look alike in
  // places, not everywhere.
  return {
      {.centre = {{{-130.0, -6.0}, {130.0, -6.0}}},
       .half_width_m = 4.5,
       .sidewalk_left_m = 2.0,
       .sidewalk_right_m = 2.0,
       .first_dash_m = 1.5},
      {.centre = {{{-130.0, -72.0}, {130.0, -72.0}}},
       .half_width_m = 3.6,
       .surface = Surface::kOldAsphalt,
       .curbs = false,
       .dash_m = 3.0,
       .gap_m = 9.0,
       .first_dash_m = 5.0,
       .edge_lines = true},
      {.centre = {{{-92.0, -105.0}, {-92.0, 105.0}}},
       .half_width_m = 4.0,
       .surface = Surface::kOldAsphalt,
       .sidewalk_right_m = 1.8,
       .dash_m = 4.0,
       .gap_m = 8.0,
       .first_dash_m = 2.0},
      {.centre = north_lane(),
       .half_width_m = 3.5,
       .surface = Surface::kNewAsphalt,
       .sidewalk_right_m = 1.6,
       .verge_m = 1.2,
       .centre_line = CentreLine::kDouble},
      {.centre = {{{-38.0, -69.0}, {-38.0, 63.0}}},
       .half_width_m = 4.0,
       .sidewalk_left_m = 1.8,
       .sidewalk_right_m = 1.8,
       .dash_m = 2.0,
       .gap_m = 4.0,
       .first_dash_m = 0.7},
      {.centre = {{{22.0, -2.0}, {22.0, 38.0}}},
       .half_width_m = 3.2,
       .sidewalk_right_m = 1.5,
       .centre_line = CentreLine::kNone},
      {.centre = {{{36.0, -69.0}, {36.0, -10.0}}},
       .half_width_m = 3.5,
       .sidewalk_left_m = 1.6,
       .centre_line = CentreLine::kSolid},
      {.centre = {{{80.0, -105.0}, {80.0, -10.0}}},
       .half_width_m = 4.0,
       .surface = Surface::kOldAsphalt,
       .sidewalk_left_m = 1.8,
       .verge_m = 0.8,
       .dash_m = 3.0,
       .gap_m = 9.0,
       .first_dash_m = 4.0},
      {.centre = {{{-8.0, -69.0}, {-8.0, -50.4}}},
       .half_width_m = 2.4,
       .surface = Surface::kOldAsphalt,
       .curbs = false,
       .centre_line = CentreLine::kNone},
  };
}

void add_crossings(TownLayout& town) {
  town.crossings = {
      {{-58.0, -6.0}, 0.0, 9.0},   {{-38.0, 13.0}, 90.0, 8.0}, {{-38.0, 56.5}, 90.0, 8.0},
      {{10.5, -6.0}, 0.0, 9.0},    {{36.0, -17.5}, 90.0, 7.0}, {{93.5, -6.0}, 0.0, 9.0},
      {{-92.0, -18.0}, 90.0, 8.0}, {{104.0, 26.0}, 90.0, 7.0}, {{64.0, 66.0}, 0.0, 7.0}};
  town.stop_lines = {
      {{-90.0, -21.5}, 90.0, 3.4}, {{-94.0, 3.6}, 90.0, 3.4},   {{-101.5, -8.2}, 0.0, 3.8},
      {{-82.5, -3.8}, 0.0, 3.8},   {{-36.0, 53.5}, 90.0, 3.4},  {{20.4, 2.6}, 90.0, 2.8},
      {{37.8, -20.8}, 90.0, 2.8},  {{82.0, -15.5}, 90.0, 3.4},  {{102.2, 4.4}, 90.0, 2.8},
      {{-84.6, 67.8}, 0.0, 2.8},   {{-90.0, -80.5}, 90.0, 3.4}, {{-94.0, -63.5}, 90.0, 3.4},
      {{-40.0, -63.8}, 90.0, 3.4}, {{34.2, -63.8}, 90.0, 2.8},  {{78.0, -62.5}, 90.0, 3.4},
      {{82.0, -81.5}, 90.0, 3.4}};
  town.arrows = {{{-110.0, -8.2}, 0.0, Arrow::kAhead},  {{-66.0, -8.2}, 0.0, Arrow::kAhead},
                 {{-36.0, 42.0}, 90.0, Arrow::kRight},  {{-36.0, 30.0}, 90.0, Arrow::kLeft},
                 {{102.2, 14.0}, -90.0, Arrow::kRight}, {{82.0, -26.0}, 90.0, Arrow::kLeft},
                 {{60.0, -3.8}, 180.0, Arrow::kAhead},  {{-78.0, 67.8}, 180.0, Arrow::kLeft},
                 {{37.8, -31.0}, 90.0, Arrow::kRight},  {{-2.0, -8.2}, 0.0, Arrow::kAhead}};
}

void add_car_parks(TownLayout& town) {
  const double turn = 180.0;
  town.bay_rows = {
      {{-26.0, -47.6}, 0.0, 5, 2.6, 5.0, 0.0, 0.6}, {{-4.6, -47.6}, 0.0, 3, 2.6, 5.0, 0.0, 0.7},
      {{3.2, -28.4}, turn, 11, 2.6, 5.0, 0.0, 0.5}, {{96.6, 6.4}, 90.0, 4, 2.7, 5.2, 0.0, 0.5},
      {{96.6, 22.8}, 90.0, 4, 2.7, 5.2, 0.0, 0.8},  {{82.0, 33.6}, -90.0, 10, 2.7, 5.2, 0.0, 0.6},
      {{-12.0, -1.5}, 0.0, 3, 6.0, 2.2, 0.0, 0.7},  {{39.0, -1.5}, 0.0, 6, 6.0, 2.2, 0.0, 0.6},
      {{4.0, -10.5}, turn, 3, 6.0, 2.2, 0.0, 0.5},  {{-59.0, 62.5}, turn, 7, 3.0, 4.6, 1.6, 0.5},
  };
  town.lay_bys = {
      {{{{-12.6, -3.0}, {6.6, -3.0}, {6.0, 0.7}, {-12.0, 0.7}}}},
      {{{{38.4, -3.0}, {75.6, -3.0}, {75.0, 0.7}, {39.0, 0.7}}}},
      {{{{4.6, -9.0}, {4.0, -12.7}, {-14.0, -12.7}, {-14.6, -9.0}}}},
      {{{{-58.6, 64.0}, {-60.2, 57.9}, {-81.6, 57.9}, {-80.4, 64.0}}}, Surface::kNewAsphalt}};
}

}  // namespace

void add_streets(TownLayout& town) {
  town.streets = streets();
  town.junctions = {
      {kMain, kWest, {-92.0, -6.0}, 5.0, 10.5},    {kMain, kCourt, {22.0, -6.0}, 4.0, 9.5},
      {kMain, kThird, {36.0, -6.0}, 5.5, 10.5},    {kMain, kEast, {80.0, -6.0}, 5.0, 10.5},
      {kMain, kNorth, {104.0, -6.0}, 5.5, 11.0},   {kNorth, kWest, {-92.0, 66.0}, 4.5, 9.0},
      {kNorth, kSecond, {-38.0, 66.0}, 5.0, 10.0}, {kRange, kWest, {-92.0, -72.0}, 5.0, 9.5},
      {kRange, kSecond, {-38.0, -72.0}, 4.0, 9.0}, {kRange, kThird, {36.0, -72.0}, 4.5, 9.0},
      {kRange, kEast, {80.0, -72.0}, 6.0, 10.5},   {kRange, kAlley, {-8.0, -72.0}, 3.0, 5.0},
  };
  town.circles = {{{-38.0, -6.0}, 14.0, 6.0, 3.0, 2.0, {kMain, kSecond}},
                  {{22.0, 38.0}, 9.5, 0.0, 5.0, 1.5, {kCourt}}};
  // Teardrops that split the lanes of the roundabout's arms, and an island before the east
  // junction.
  town.islands = {
      {{{{-55.0, -6.0}, {-51.2, -7.2}, {-50.6, -6.0}, {-51.2, -4.8}}}, Surface::kConcrete},
      {{{{-20.6, -6.0}, {-24.8, -4.8}, {-25.4, -6.0}, {-24.8, -7.2}}}, Surface::kConcrete},
      {{{{-38.0, 11.0}, {-39.0, 7.4}, {-38.0, 6.8}, {-37.0, 7.4}}}, Surface::kConcrete},
      {{{{-38.0, -23.4}, {-37.0, -19.4}, {-38.0, -18.8}, {-39.0, -19.4}}}, Surface::kConcrete}};
  add_crossings(town);
  add_car_parks(town);
}

}  // namespace nadir::town
