// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/graticule.h"

#include <algorithm>
#include <vector>

#include "widgets/views/graticule_marks.h"

namespace nadir {
namespace {

constexpr double kTickPt = 3.0;
constexpr double kBetweenNamesPt = 2.0;  ///< Between the name of an axis and its numbers.

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
                     const GraticuleMarks& marks,
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
  const double baseline = where.bottom - kGraticuleNumberGapPt * px - digit_height;
  if (!marks.along_lower.empty() && lower.width + gap <= margin.x() &&
      baseline - lower.descent >= where.bottom - margin.y()) {
    const double away = std::clamp(margin.x() - lower.width, gap, kGraticuleNumberGapPt * px);
    canvas.text({where.left - away - lower.width, baseline}, names.along_lower, style);
  }
  double widest = 0.0;
  for (const GraticuleMark& mark : marks.along_left) {
    widest = std::max(widest, measure_text(mark.label, numbers).width);
  }
  style.rotation_deg = 90.0;
  const TextExtent left = measure_text(names.along_left, style);
  const double right_edge = where.left - kGraticuleNumberGapPt * px - widest - gap;
  const bool has_room = right_edge - left.descent - left.cap_height >= where.left - margin.x();
  if (marks.along_left.empty() || !has_room || left.width > where.height) return;
  // Turned to the left: what is below the baseline lies to its right.
  canvas.text({right_edge - left.descent, where.centre().y() - left.width / 2.0}, names.along_left,
              style);
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
  if (kind == Graticule::kNone || frame.camera.is_turned()) return;
  const double px = frame.px_per_pt;
  const PageRect& where = frame.where;
  const GraticuleMarks marks = graticule_marks(frame, kind, plane, theme);
  TextStyle style = graticule_number_style(theme, px);
  const StrokeStyle tick_line{theme.muted, 0.75 * px};
  style.align = TextAlign::kCentre;
  const double cap_height = measure_text("0", style).cap_height;
  for (const GraticuleMark& mark : marks.along_lower) {
    const double x = marks.lower.px_from(mark.at_m);
    const std::array<Eigen::Vector2d, 2> ends = {Eigen::Vector2d(x, where.bottom),
                                                 Eigen::Vector2d(x, where.bottom - kTickPt * px)};
    canvas.stroke(ends, tick_line);
    const double width = measure_text(mark.label, style).width;
    canvas.text({number_middle(marks.lower, mark.at_m, width),
                 where.bottom - kGraticuleNumberGapPt * px - cap_height},
                mark.label, style);
  }
  style.align = TextAlign::kRight;
  for (const GraticuleMark& mark : marks.along_left) {
    const double y = marks.left.px_from(mark.at_m);
    const std::array<Eigen::Vector2d, 2> ends = {Eigen::Vector2d(where.left, y),
                                                 Eigen::Vector2d(where.left - kTickPt * px, y)};
    canvas.stroke(ends, tick_line);
    canvas.text({where.left - kGraticuleNumberGapPt * px,
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
  if (kind == Graticule::kNone || frame.camera.is_turned()) return;
  constexpr int kPieces = 16;  ///< Of a meridian across the map; it bends by less than a pixel.
  const GraticuleMarks marks = graticule_marks(frame, kind, plane, theme);
  const PathLook look{with_opacity(theme.page, 0.75), 0.4, false, with_opacity(theme.text, 0.3),
                      0.25};
  canvas.push_clip(frame.where);
  const auto draw = [&](const std::vector<GraticuleMark>& along, bool is_upward) {
    const GraticuleBorder& across = is_upward ? marks.left : marks.lower;
    for (const GraticuleMark& mark : along) {
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
