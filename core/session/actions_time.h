// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "core/session/action_fields.h"
#include "core/session/view_state.h"

/// Moments and playing. Times are seconds after the active run's first step.
namespace nadir::actions {

struct Seek {
  static constexpr std::string_view kForm = "seek SECONDS";
  static constexpr std::string_view kHelp = "Go to another time";
  double time_s = 0.0;
  NADIR_ACTION_FIELDS(time_s)
  friend bool operator==(const Seek&, const Seek&) = default;
};

/// What a click on a mark asks for: the moment is to be looked at, so the map comes to it, nearer where it would be tiny.
struct GoToMoment {
  static constexpr std::string_view kForm = "moment SECONDS";
  static constexpr std::string_view kHelp = "Go to a moment and have the map show it";
  double time_s = 0.0;
  NADIR_ACTION_FIELDS(time_s)
  friend bool operator==(const GoToMoment&, const GoToMoment&) = default;
};

struct StepBy {
  static constexpr std::string_view kForm = "step COUNT";
  static constexpr std::string_view kHelp = "Go so many steps of the run on, or back";
  int steps = 1;
  NADIR_ACTION_FIELDS(steps)
  friend bool operator==(const StepBy&, const StepBy&) = default;
};

struct GoTo {
  static constexpr std::string_view kForm = "go PLACE";
  static constexpr std::string_view kHelp =
      "Go to the start, the end, or the next or previous worst moment or bookmark";
  Moment moment = Moment::kStart;
  NADIR_ACTION_FIELDS(moment)
  friend bool operator==(const GoTo&, const GoTo&) = default;
};

struct Play {
  static constexpr std::string_view kForm = "play {on|off|toggle}";
  static constexpr std::string_view kHelp = "Play, pause, or either";
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(to)
  friend bool operator==(const Play&, const Play&) = default;
};

struct SetSpeed {
  static constexpr std::string_view kForm = "speed FACTOR";
  static constexpr std::string_view kHelp = "Flight seconds per second of playing, 0.1 to 20";
  double speed = 1.0;
  NADIR_ACTION_FIELDS(speed)
  friend bool operator==(const SetSpeed&, const SetSpeed&) = default;
};

struct SetLoop {
  static constexpr std::string_view kForm = "loop [FROM TO]";
  static constexpr std::string_view kHelp = "Play this range again and again; without one, all";
  std::optional<double> from_s, to_s;
  NADIR_ACTION_FIELDS(from_s, to_s)
  friend bool operator==(const SetLoop&, const SetLoop&) = default;
};

}  // namespace nadir::actions
