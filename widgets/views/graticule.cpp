// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/graticule.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "widgets/views/chart_axis.h"

namespace nadir {
namespace {

constexpr double kNumberPt = 7.0;
constexpr double kTickPt = 3.0;
constexpr double kNumberFromMapPt = 4.5;
constexpr double kBetweenNumbersPt = 6.0;  ///< Side by side.
constexpr double kBetweenLinesPt = 3.0;    ///< One above the other.
constexpr double kBetweenNamesPt = 2.0;    ///< Between the name of an axis and its numbers.

TextStyle number_style(const Theme& theme, double px_per_pt) {
  TextStyle style;
  style.face = FontFace::kNumbers;
  style.size_px = kNumberPt * px_per_pt;
  style.colour = theme.muted;
  return style;
}

/// A round coordinate where its line meets a border of the map.
struct Mark {
  double value = 0.0;
  double at_m = 0.0;  ///< East along the lower border, north along the left one.
  std::string label;
};

/// One border, from its west or south end.
struct Border {
  double low_m = 0.0, high_m = 0.0;
  double low_px = 0.0, high_px = 0.0;
  double low_value = 0.0, high_value = 0.0;         ///< The coordinate at its ends.
  std::string unit;                                 ///< Behind every number.
  std::function<double(double value)> metres_from;  ///< Along the border.

  [[nodiscard]] double px_from(double at_m) const {
    return low_px + (at_m - low_m) / (high_m - low_m) * (high_px - low_px);
  }
};

/// Whether so many digits as doubles have are enough to tell places along a border apart.
bool has_distinct_places(double low, double high) {
  constexpr double kLeastShare = 1e-9;
  return is_drawable(low) && is_drawable(high) &&
         high - low > kLeastShare * std::max(std::abs(low), std::abs(high));
}

/// Middle of a number of some length: at its tick, but inside of the border.
double number_middle(const Border& border, double at_m, double length_px) {
  return std::clamp(border.px_from(at_m), border.low_px + length_px / 2.0,
                    border.high_px - length_px / 2.0);
}

/// @param length_of  Of a number along the border, pixels. @param room_px  For a number across it.
std::vector<Mark> marks_of(const Border& border,
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
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < ticks.at.size(); ++i) {
      const double at_m = std::clamp(border.metres_from(ticks.at[i]), border.low_m, border.high_m);
      marks.push_back({ticks.at[i], at_m, ticks.labels[i] + border.unit});
    }
    return marks;
  };
  const auto fit = [&](const Ticks& ticks) {
    double free_from = -std::numeric_limits<double>::infinity();
    for (const Mark& mark : marks_from(ticks)) {
      if (!fits_alone(mark.label)) return false;
      const double length = length_of(mark.label);
      const double start = number_middle(border, mark.at_m, length) - length / 2.0;
      if (start < free_from) return false;
      free_from = start + length + gap_px;
    }
    return true;
  };
  std::vector<Mark> marks =
      marks_from(round_ticks({border.low_value, border.high_value}, false, fit));
  // A single one is given also where it does not fit.
  std::erase_if(marks, [&](const Mark& mark) { return !fits_alone(mark.label); });
  return marks;
}

/// The two borders and what is written along them.
struct Marks {
  Border lower, left;
  std::vector<Mark> along_lower, along_left;
};

/// A place on the plane whose latitude or longitude is known, and either its north or its east: found by going back and
/// forth, for meridians and parallels are nearly straight.
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

Marks marks_around(const MapFrame& frame,
                   Graticule kind,
                   const ProjectPlane& plane,
                   const Theme& theme) {
  const PageRect& where = frame.where;
  const Eigen::Vector2d low = frame.camera.enu_from_page({where.left, where.bottom}, where);
  const Eigen::Vector2d high = frame.camera.enu_from_page({where.right(), where.top()}, where);
  Marks marks;
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
  const TextStyle style = number_style(theme, px);
  const Eigen::Vector2d room =
      graticule_margin_px(kind, px) - Eigen::Vector2d::Constant(kNumberFromMapPt * px);
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

struct AxisName {
  const char* along_lower;
  const char* along_left;
};

AxisName names_of(Graticule kind) {
  return kind == Graticule::kDegrees ? AxisName{"longitude", "latitude"}
                                     : AxisName{"east [m]", "north [m]"};
}

/// The name of the lower border's coordinate in the corner where the borders meet, that of the left one beside its numbers,
/// each where it has numbers and room.
void draw_axis_names(Canvas& canvas,
                     const MapFrame& frame,
                     Graticule kind,
                     const Marks& marks,
                     const TextStyle& numbers) {
  const double px = frame.px_per_pt;
  const PageRect& where = frame.where;
  const Eigen::Vector2d margin = graticule_margin_px(kind, px);
  const AxisName names = names_of(kind);
  const double gap = kBetweenNamesPt * px;
  TextStyle style = numbers;
  style.face = FontFace::kText;
  style.align = TextAlign::kLeft;
  const double digit_height = measure_text("0", numbers).cap_height;
  const TextExtent lower = measure_text(names.along_lower, style);
  const double baseline = where.bottom - kNumberFromMapPt * px - digit_height;
  if (!marks.along_lower.empty() && lower.width + gap <= margin.x() &&
      baseline - lower.descent >= where.bottom - margin.y()) {
    const double away = std::clamp(margin.x() - lower.width, gap, kNumberFromMapPt * px);
    canvas.text({where.left - away - lower.width, baseline}, names.along_lower, style);
  }
  double widest = 0.0;
  for (const Mark& mark : marks.along_left) {
    widest = std::max(widest, measure_text(mark.label, numbers).width);
  }
  style.rotation_deg = 90.0;
  const TextExtent left = measure_text(names.along_left, style);
  const double right_edge = where.left - kNumberFromMapPt * px - widest - gap;
  const bool has_room = right_edge - left.descent - left.cap_height >= where.left - margin.x();
  if (marks.along_left.empty() || !has_room || left.width > where.height) return;
  // Turned to the left: what is below the baseline lies to its right.
  canvas.text({right_edge - left.descent, where.centre().y() - left.width / 2.0}, names.along_left,
              style);
}

bool is_turned(const MapFrame& frame) {
  return !(std::abs(frame.camera.up_rad - std::numbers::pi / 2.0) <= 1e-9);
}

}  // namespace

Eigen::Vector2d graticule_margin_px(Graticule kind, double px_per_pt) {
  switch (kind) {
    case Graticule::kMetres:
      return {30.0 * px_per_pt, 14.0 * px_per_pt};
    case Graticule::kDegrees:
      return {50.0 * px_per_pt, 14.0 * px_per_pt};
    case Graticule::kNone:
      break;
  }
  return {0.0, 0.0};
}

void draw_graticule(Canvas& canvas,
                    const MapFrame& frame,
                    Graticule kind,
                    const ProjectPlane& plane,
                    const Theme& theme) {
  if (kind == Graticule::kNone || is_turned(frame)) return;
  const double px = frame.px_per_pt;
  const PageRect& where = frame.where;
  const Marks marks = marks_around(frame, kind, plane, theme);
  TextStyle style = number_style(theme, px);
  const StrokeStyle tick_line{theme.muted, 0.75 * px};
  style.align = TextAlign::kCentre;
  const double cap_height = measure_text("0", style).cap_height;
  for (const Mark& mark : marks.along_lower) {
    const double x = marks.lower.px_from(mark.at_m);
    const std::array<Eigen::Vector2d, 2> ends = {Eigen::Vector2d(x, where.bottom),
                                                 Eigen::Vector2d(x, where.bottom - kTickPt * px)};
    canvas.stroke(ends, tick_line);
    const double width = measure_text(mark.label, style).width;
    canvas.text({number_middle(marks.lower, mark.at_m, width),
                 where.bottom - kNumberFromMapPt * px - cap_height},
                mark.label, style);
  }
  style.align = TextAlign::kRight;
  for (const Mark& mark : marks.along_left) {
    const double y = marks.left.px_from(mark.at_m);
    const std::array<Eigen::Vector2d, 2> ends = {Eigen::Vector2d(where.left, y),
                                                 Eigen::Vector2d(where.left - kTickPt * px, y)};
    canvas.stroke(ends, tick_line);
    canvas.text({where.left - kNumberFromMapPt * px,
                 number_middle(marks.left, mark.at_m, cap_height) - cap_height / 2.0},
                mark.label, style);
  }
  draw_axis_names(canvas, frame, kind, marks, style);
}

void draw_graticule_lines(Canvas& canvas,
                          const MapFrame& frame,
                          Graticule kind,
                          const ProjectPlane& plane,
                          const Theme& theme) {
  if (kind == Graticule::kNone || is_turned(frame)) return;
  constexpr int kPieces = 16;  ///< Of a meridian across the map; it bends by less than a pixel.
  const Marks marks = marks_around(frame, kind, plane, theme);
  const PathLook look{with_opacity(theme.page, 0.75), 0.4, false, with_opacity(theme.text, 0.3),
                      0.25};
  canvas.push_clip(frame.where);
  const auto draw = [&](const std::vector<Mark>& along, bool is_upward) {
    const Border& across = is_upward ? marks.left : marks.lower;
    for (const Mark& mark : along) {
      std::vector<Eigen::Vector2d> line;
      for (int i = 0; i <= kPieces; ++i) {
        const double other_m =
            across.low_m + (across.high_m - across.low_m) * i / static_cast<double>(kPieces);
        const Eigen::Vector2d straight =
            is_upward ? Eigen::Vector2d(mark.at_m, other_m) : Eigen::Vector2d(other_m, mark.at_m);
        line.push_back(kind == Graticule::kDegrees
                           ? where_crossing(plane, straight, is_upward, mark.value)
                           : straight);
      }
      draw_path(canvas, frame, line, look);
    }
  };
  draw(marks.along_lower, true);
  draw(marks.along_left, false);
  canvas.pop_clip();
}

}  // namespace nadir
