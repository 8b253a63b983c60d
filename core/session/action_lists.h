// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

/// Arguments of which an action takes any number. Each is the last one of its form.
namespace nadir {

/// Places of the project plane, "12.5,-3 14,-3": east and north in metres.
struct PlaceList {
  std::vector<Eigen::Vector2d> in_enu_m;
  friend bool operator==(const PlaceList&, const PlaceList&) = default;
};

/// Numbers of things, "3 17 4".
struct NumberList {
  std::vector<std::int64_t> numbers;
  friend bool operator==(const NumberList&, const NumberList&) = default;
};

}  // namespace nadir
