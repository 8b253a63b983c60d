// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/graticule_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/views/chart_axis.h"

namespace nadir {
namespace {

constexpr double kNumberPt = 7.0;
constexpr double kBetweenNumbersPt = 6.0;  ///< Side by side.
constexpr double kBetweenLinesPt = 3.0;    ///< One above the other.

/// Whether so many digits as doubles have are enough to tell places along a border apart.
bool has_distinct_places(double low, double high) {
  constexpr double kLeastShare = 1e-9;
  return is_drawable(low) && is_drawable(high) &&
         high - low > kLeastShare * std::max(std::abs(low), std::abs(high));
}

/// @param length_of  Of a number along the border, pixels. @param room_px  For a number across it.
std::vector<GraticuleMark> marks_of(const GraticuleBorder& border,
                                    const std::function<double(const std::string&)>& length_of,
                                    const std::function<double(const std::string&)>& breadth_of,
                                    double gap_px,
                                    double room_px) {
  if (!has_distinct_places(border.low_m, border.high_m) ||
      !has_distinct_places(border.low_value, border.high_value)) {
    return {};
  }
  const auto fits_alone = [&](const std::string& label) {
    return breadth_of(label) <= room_px && length_of(label) <= border.high_px - border.low_px;
  };
  const auto marks_from = [&](const Ticks& ticks) {
    std::vector<GraticuleMark> marks;
    for (std::size_t i = 0; i < ticks.at.size(); ++i) {
      const double at_m = std::clamp(border.metres_from(ticks.at[i]), border.low_m, border.high_m);
      marks.push_back({ticks.at[i], at_m, ticks.labels[i] + border.unit});
    }
    return marks;
  };
  const auto fit = [&](const Ticks& ticks) {
    double free_from = -std::numeric_limits<double>::infinity();
    for (const GraticuleMark& mark : marks_from(ticks)) {
      if (!fits_alone(mark.label)) return false;
      const double length = length_of(mark.label);
      const double start = number_middle(border, mark.at_m, length) - length / 2.0;
      if (start < free_from) return false;
      free_from = start + length + gap_px;
    }
    return true;
  };
  std::vector<GraticuleMark> marks =
      marks_from(round_ticks({border.low_value, border.high_value}, false, fit));
  // A single one is given also where it does not fit.
  std::erase_if(marks, [&](const GraticuleMark& mark) { return !fits_alone(mark.label); });
  return marks;
}

}  // namespace

TextStyle graticule_number_style(const Theme& theme, double px_per_pt) {
  TextStyle style;
  style.face = FontFace::kNumbers;
  style.size_px = kNumberPt * px_per_pt;
  style.colour = theme.muted;
  return style;
}

double number_middle(const GraticuleBorder& border, double at_m, double length_px) {
  return std::clamp(border.px_from(at_m), border.low_px + length_px / 2.0,
                    border.high_px - length_px / 2.0);
}

Eigen::Vector2d where_crossing(const ProjectPlane& plane,
                               const Eigen::Vector2d& near_m,
                               bool is_longitude,
                               double value_deg) {
  Eigen::Vector2d point = near_m;
  for (int i = 0; i < 4; ++i) {
    Geodetic place = plane.geodetic_from_enu(point);
    (is_longitude ? place.longitude_deg : place.latitude_deg) = value_deg;
    const Eigen::Vector2d found = plane.enu_from_geodetic(place);
    if (is_longitude) {
      point.x() = found.x();
    } else {
      point.y() = found.y();
    }
  }
  return point;
}

GraticuleMarks graticule_marks(const MapFrame& frame,
                               Graticule kind,
                               const ProjectPlane& plane,
                               const Theme& theme) {
  const PageRect& where = frame.where;
  const Eigen::Vector2d low = frame.camera.enu_from_page({where.left, where.bottom}, where);
  const Eigen::Vector2d high = frame.camera.enu_from_page({where.right(), where.top()}, where);
  GraticuleMarks marks;
  marks.lower = {low.x(), high.x(), where.left, where.right(), low.x(), high.x(), {}, {}};
  marks.left = {low.y(), high.y(), where.bottom, where.top(), low.y(), high.y(), {}, {}};
  marks.lower.metres_from = marks.left.metres_from = [](double value) { return value; };
  if (kind == Graticule::kNone || !low.allFinite() || !high.allFinite()) return marks;
  if (kind == Graticule::kDegrees) {
    const Geodetic corner = plane.geodetic_from_enu(low);
    marks.lower.low_value = corner.longitude_deg;
    marks.lower.high_value = plane.geodetic_from_enu({high.x(), low.y()}).longitude_deg;
    marks.left.low_value = corner.latitude_deg;
    marks.left.high_value = plane.geodetic_from_enu({low.x(), high.y()}).latitude_deg;
    marks.lower.metres_from = [&plane, low](double value) {
      return where_crossing(plane, low, true, value).x();
    };
    marks.left.metres_from = [&plane, low](double value) {
      return where_crossing(plane, low, false, value).y();
    };
    marks.lower.unit = marks.left.unit = "°";
  }
  const double px = frame.px_per_pt;
  const TextStyle style = graticule_number_style(theme, px);
  const Eigen::Vector2d room =
      graticule_margin_px(kind, px) - Eigen::Vector2d::Constant(kGraticuleNumberGapPt * px);
  const auto width = [&style](const std::string& label) {
    return measure_text(label, style).width;
  };
  const auto height = [&style](const std::string& label) {
    return measure_text(label, style).cap_height;
  };
  marks.along_lower = marks_of(marks.lower, width, height, kBetweenNumbersPt * px, room.y());
  marks.along_left = marks_of(marks.left, height, width, kBetweenLinesPt * px, room.x());
  return marks;
}

}  // namespace nadir
