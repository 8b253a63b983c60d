// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/session/action_fields.h"
#include "core/session/view_state.h"

/// Map camera, tools and layers.
namespace nadir::actions {

struct LookAt {
  static constexpr std::string_view kForm = "look EAST NORTH [METRES]";
  static constexpr std::string_view kHelp = "Show a place of the map, so many metres across";
  double east_m = 0.0, north_m = 0.0;
  std::optional<double> width_m;
  NADIR_ACTION_FIELDS(east_m, north_m, width_m)
  friend bool operator==(const LookAt&, const LookAt&) = default;
};

struct Zoom {
  static constexpr std::string_view kForm = "zoom FACTOR [EAST NORTH]";
  static constexpr std::string_view kHelp =
      "Show it so many times larger, around a point that stays";
  double factor = 1.5;
  std::optional<double> east_m, north_m;
  NADIR_ACTION_FIELDS(factor, east_m, north_m)
  friend bool operator==(const Zoom&, const Zoom&) = default;
};

struct Rotate {
  static constexpr std::string_view kForm = "rotate DEGREES";
  static constexpr std::string_view kHelp = "Turn the map counter-clockwise";
  double angle_deg = 0.0;
  NADIR_ACTION_FIELDS(angle_deg)
  friend bool operator==(const Rotate&, const Rotate&) = default;
};

struct Fit {
  static constexpr std::string_view kForm = "fit {flight|map|particles}";
  static constexpr std::string_view kHelp = "Show the whole flight, the whole map or all particles";
  FitTo to = FitTo::kFlight;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const Fit&, const Fit&) = default;
};

struct Follow {
  static constexpr std::string_view kForm = "follow {on|off|toggle}";
  static constexpr std::string_view kHelp = "Keep the estimate in the middle of the map";
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const Follow&, const Follow&) = default;
};

struct SetUp {
  static constexpr std::string_view kForm = "up {north|heading|free}";
  static constexpr std::string_view kHelp = "What is up on the map";
  MapUp up = MapUp::kNorth;
  NADIR_ACTION_FIELDS(up)
  friend bool operator==(const SetUp&, const SetUp&) = default;
};

struct GoToPlace {
  static constexpr std::string_view kForm = "place TEXT";
  static constexpr std::string_view kHelp =
      "Show a place by its coordinates: EAST NORTH in metres, LAT, LON in degrees, or MGRS";
  std::string text;
  NADIR_ACTION_FIELDS(text)
  friend bool operator==(const GoToPlace&, const GoToPlace&) = default;
};

struct LayTopview {
  static constexpr std::string_view kForm = "lay-at {estimate|truth|odometry}";
  static constexpr std::string_view kHelp = "Pose at which the topview lies on the map";
  PoseSource at = PoseSource::kEstimate;
  NADIR_ACTION_FIELDS(at)
  friend bool operator==(const LayTopview&, const LayTopview&) = default;
};

struct SelectParticle {
  static constexpr std::string_view kForm = "select-particle [INDEX]";
  static constexpr std::string_view kHelp =
      "Show pose, weight and errors of a particle; without one, of none";
  std::optional<int> index;
  NADIR_ACTION_FIELDS(index)
  friend bool operator==(const SelectParticle&, const SelectParticle&) = default;
};

struct MeasurePoint {
  static constexpr std::string_view kForm = "measure [EAST NORTH]";
  static constexpr std::string_view kHelp =
      "Add a point to what is measured; without one, measure anew";
  std::optional<double> east_m, north_m;
  NADIR_ACTION_FIELDS(east_m, north_m)
  friend bool operator==(const MeasurePoint&, const MeasurePoint&) = default;
};

struct UseTool {
  static constexpr std::string_view kForm = "tool {pan|measure|pick}";
  static constexpr std::string_view kHelp = "What a click on the map does";
  MapTool tool = MapTool::kPan;
  NADIR_ACTION_FIELDS(tool)
  friend bool operator==(const UseTool&, const UseTool&) = default;
};

struct ShowLayer {
  static constexpr std::string_view kForm = "layer NAME {on|off|toggle}";
  static constexpr std::string_view kHelp = "Show or hide a layer of the map";
  Layer layer = Layer::kPicture;
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(layer, to)
  friend bool operator==(const ShowLayer&, const ShowLayer&) = default;
};

struct SetLayerOpacity {
  static constexpr std::string_view kForm = "layer-opacity NAME SHARE";
  static constexpr std::string_view kHelp = "How much a layer covers what is below it, 0 to 1";
  Layer layer = Layer::kPicture;
  double opacity = 1.0;
  NADIR_ACTION_FIELDS(layer, opacity)
  friend bool operator==(const SetLayerOpacity&, const SetLayerOpacity&) = default;
};

struct SetLayerColour {
  static constexpr std::string_view kForm = "layer-colour NAME [#RRGGBB]";
  static constexpr std::string_view kHelp = "Colour of a layer's lines; without one, the theme's";
  Layer layer = Layer::kEstimate;
  std::optional<std::string> colour;
  NADIR_ACTION_FIELDS(layer, colour)
  friend bool operator==(const SetLayerColour&, const SetLayerColour&) = default;
};

struct MoveLayer {
  static constexpr std::string_view kForm = "layer-move NAME PLACES";
  static constexpr std::string_view kHelp = "Raise a layer over others, or lower it";
  Layer layer = Layer::kPicture;
  int places = 1;
  NADIR_ACTION_FIELDS(layer, places)
  friend bool operator==(const MoveLayer&, const MoveLayer&) = default;
};

}  // namespace nadir::actions
