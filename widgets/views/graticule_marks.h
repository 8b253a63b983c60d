// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "widgets/views/graticule.h"

namespace nadir {

/// Where the numbers and lines of a graticule are; how they are drawn is graticule.cpp's.

/// A round coordinate where its line meets a border of the map.
struct GraticuleMark {
  double value = 0.0;
  double at_m = 0.0;  ///< East along the lower border, north along the left one.
  std::string label;
};

/// One border, from its west or south end.
struct GraticuleBorder {
  double low_m = 0.0, high_m = 0.0;
  double low_px = 0.0, high_px = 0.0;
  double low_value = 0.0, high_value = 0.0;         ///< The coordinate at its ends.
  std::string unit;                                 ///< Behind every number.
  std::function<double(double value)> metres_from;  ///< Along the border.

  [[nodiscard]] double px_from(double at_m) const {
    return low_px + (at_m - low_m) / (high_m - low_m) * (high_px - low_px);
  }
};

/// The two borders and what is written along them.
struct GraticuleMarks {
  GraticuleBorder lower, left;
  std::vector<GraticuleMark> along_lower, along_left;
};

/// None along a border whose coordinates are not finite, or are lost in rounding. @param frame  Not turned. @param plane  Must
/// outlive the borders, whose metres_from() asks it.
[[nodiscard]] GraticuleMarks graticule_marks(const MapFrame& frame,
                                             Graticule kind,
                                             const ProjectPlane& plane,
                                             const Theme& theme);

/// A place on the plane whose latitude or longitude is known, and either its north or its east: found by going back and
/// forth, for meridians and parallels are nearly straight.
[[nodiscard]] Eigen::Vector2d where_crossing(const ProjectPlane& plane,
                                             const Eigen::Vector2d& near_m,
                                             bool is_longitude,
                                             double value_deg);

/// Middle of a number of some length: at its tick, but inside of the border.
[[nodiscard]] double number_middle(const GraticuleBorder& border, double at_m, double length_px);

/// Of the numbers.
[[nodiscard]] TextStyle graticule_number_style(const Theme& theme, double px_per_pt);
inline constexpr double kGraticuleNumberGapPt = 4.5;

}  // namespace nadir
