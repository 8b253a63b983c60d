// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/label_objects_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "widgets/views/label_marks.h"

namespace nadir {
namespace {

constexpr double kLeastPlaceStepPx = 0.5;
constexpr double kLeastWidthPx = 5.0;       ///< From here on both sides of a line are shown.
constexpr double kLeastCornerStepPx = 9.0;  ///< Corners that lie closer are passed over.
constexpr double kFillOpacity = 0.35;
constexpr double kUnderHandOpacity = 0.14;
/// More borders than these in sight are drawn as plain lines: a casing is for telling a few from the ground.
constexpr std::size_t kMostCased = 400;

/// The places of a line moved to its left. Where it bends sharply the corner is cut off.
Ring moved_beside(const Ring& line, double to_the_left_m) {
  Ring beside;
  const auto normal = [&](std::size_t i) -> Eigen::Vector2d {
    const Eigen::Vector2d along = line[i + 1] - line[i];
    const double length = along.norm();
    return length > 0.0 ? Eigen::Vector2d(-along.y() / length, along.x() / length)
                        : Eigen::Vector2d::Zero();
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector2d in = i > 0 ? normal(i - 1) : normal(i);
    const Eigen::Vector2d out = i + 1 < line.size() ? normal(i) : in;
    const double share = 1.0 + in.dot(out);  // 2 where it goes straight on
    if (share > 0.5) {
      beside.emplace_back(line[i] + to_the_left_m * (in + out) / share);
    } else {
      beside.emplace_back(line[i] + to_the_left_m * in);
      beside.emplace_back(line[i] + to_the_left_m * out);
    }
  }
  return beside;
}

/// What of the ground is on the page, for telling what is out of sight.
PlaneBounds ground_in_sight(const MapFrame& frame) {
  PlaneBounds bounds;
  for (const double x : {frame.where.left, frame.where.right()}) {
    for (const double y : {frame.where.bottom, frame.where.top()}) {
      bounds.include(frame.camera.enu_from_page({x, y}, frame.where));
    }
  }
  return bounds;
}

bool do_meet(const PlaneBounds& a, const PlaneBounds& b) {
  return !a.is_empty && (a.low.array() <= b.high.array()).all() &&
         (b.low.array() <= a.high.array()).all();
}

class LabelDrawing {
 public:
  LabelDrawing(Canvas& canvas,
               const MapFrame& frame,
               const LabelOverlay& overlay,
               const Theme& theme)
      : canvas_(canvas),
        frame_(frame),
        overlay_(overlay),
        theme_(theme),
        px_(frame.px_per_pt),
        sight_(ground_in_sight(frame)),
        casing_(with_opacity(theme.page, 0.9)) {}

  void draw() {
    draw_coming();
    draw_under_hand();
    draw_selected();
    draw_picked();
    draw_places();
    draw_brush();
    if (overlay_.snapped) {
      draw_snap_mark(canvas_, frame_.page(overlay_.snapped->at), overlay_.snapped->mark,
                     last_leg_direction(), {theme_.warning, casing_, px_});
    }
    draw_words();
  }

 private:
  [[nodiscard]] bool is_seen(const LabelObject& object) const {
    const PlaneBounds bounds = drawn_bounds(object);
    return do_meet(bounds, sight_) &&
           (bounds.high - bounds.low).maxCoeff() >= kLeastObjectPx * frame_.camera.metres_per_px;
  }
  void stroke(const std::vector<Eigen::Vector2d>& line, const PathLook& look) {
    if (line.size() < 2) return;
    if (look.casing.alpha > 0) {
      canvas_.stroke(line, {look.casing, (look.width_pt + 2.0 * look.casing_pt) * px_});
    }
    StrokeStyle style{look.colour, look.width_pt * px_};
    if (look.is_dashed) style.dashes_px = {4.0 * px_, 3.0 * px_};
    canvas_.stroke(line, style);
  }
  void stroke_border(const LabelObject& object, const PathLook& look) {
    for (const Ring& ring : border_of(object, frame_.camera.metres_per_px)) {
      stroke(page_line(frame_, ring, kLeastPlaceStepPx), look);
    }
  }
  void fill(const std::vector<Ring>& rings, Rgba colour) {
    canvas_.fill(keyholed(frame_, rings), colour);
  }

  /// A class without colour takes away: it is shown in the colour of words.
  void draw_coming() {
    for (const LabelOverlay::Coming& coming : overlay_.coming) {
      const bool takes_away = coming.class_id == kUnclassified;
      const Rgba colour = takes_away ? theme_.text : class_colour(coming.class_id);
      if (coming.is_filled) fill(coming.rings, with_opacity(colour, kFillOpacity));
      for (Ring ring : coming.rings) {
        if (coming.is_filled && !ring.empty()) ring.push_back(ring.front());
        stroke(page_line(frame_, ring, kLeastPlaceStepPx), {colour, 1.5, true, casing_, 0.6});
      }
    }
  }
  void draw_under_hand() {
    if (overlay_.under_hand == nullptr || !is_seen(*overlay_.under_hand)) return;
    const LabelObject& object = *overlay_.under_hand;
    if (object.kind != ObjectKind::kLine) {
      fill(object.rings, with_opacity(theme_.text, kUnderHandOpacity));
    }
    stroke_border(object, {theme_.text, 1.0, false, casing_, 0.6});
  }
  void draw_selected() {
    std::vector<const LabelObject*> seen;
    for (const auto& object : overlay_.selected) {
      if (is_seen(*object)) seen.push_back(object.get());
    }
    PathLook look{theme_.accent, 1.8, false, casing_, 0.8};
    if (seen.size() > kMostCased) look = {theme_.accent, 1.0, false, {0, 0, 0, 0}, 0.0};
    for (const LabelObject* const object : seen) stroke_border(*object, look);
    if (!overlay_.shows_corners || seen.size() > kMostCased) return;
    for (const LabelObject* const object : seen) draw_corners(*object);
  }
  void draw_corners(const LabelObject& object) {
    for (const Ring& ring : object.rings) {
      std::optional<Eigen::Vector2d> last;
      for (const Eigen::Vector2d& place : ring) {
        const Eigen::Vector2d at = frame_.page(place);
        if (!is_on_page(at) || (last && (at - *last).norm() < kLeastCornerStepPx * px_)) continue;
        last = at;
        draw_corner(canvas_, at, false, {theme_.accent, casing_, px_});
      }
    }
  }
  void draw_picked() {
    for (const Eigen::Vector2d& place : overlay_.picked) {
      const Eigen::Vector2d at = frame_.page(place);
      if (is_on_page(at)) draw_corner(canvas_, at, true, {theme_.warning, casing_, px_});
    }
  }
  [[nodiscard]] bool is_on_page(const Eigen::Vector2d& at) const {
    const double room = 8.0 * px_;
    return at.x() > frame_.where.left - room && at.x() < frame_.where.right() + room &&
           at.y() > frame_.where.bottom - room && at.y() < frame_.where.top() + room;
  }

  void draw_places() {
    const PathLook line{theme_.text, 1.5, false, casing_, 0.8};
    PathLook dashed = line;
    dashed.is_dashed = true;
    const std::vector<Eigen::Vector2d>& places = overlay_.places;
    if (places.size() > 1) stroke(page_line(frame_, places, kLeastPlaceStepPx), line);
    if (!places.empty() && overlay_.next) {
      stroke({frame_.page(places.back()), frame_.page(*overlay_.next)}, dashed);
    }
    const Eigen::Vector2d* const end =
        overlay_.next ? &*overlay_.next : (places.empty() ? nullptr : &places.back());
    if (overlay_.closes && places.size() > 1) {
      PathLook faint = dashed;
      faint.colour = with_opacity(faint.colour, 0.6);
      faint.casing = with_opacity(faint.casing, 0.4);
      stroke({frame_.page(*end), frame_.page(places.front())}, faint);
    }
    for (const Eigen::Vector2d& place : places) {
      draw_corner(canvas_, frame_.page(place), false, {theme_.text, casing_, px_});
    }
  }
  [[nodiscard]] Eigen::Vector2d last_leg_direction() const {
    const auto& places = overlay_.places;
    if (places.empty() || !overlay_.snapped) return {1.0, 0.0};
    const Eigen::Vector2d along = frame_.page(overlay_.snapped->at) - frame_.page(places.back());
    return along.norm() > 1e-9 ? Eigen::Vector2d(along.normalized()) : Eigen::Vector2d(1.0, 0.0);
  }

  void draw_brush() {
    if (!overlay_.brush) return;
    draw_brush_circle(canvas_, frame_.page(overlay_.brush->centre),
                      overlay_.brush->radius_m / frame_.camera.metres_per_px,
                      {theme_.text, casing_, px_});
  }

  void draw_words() {
    TextStyle style;
    style.face = FontFace::kNumbers;
    style.size_px = 8.5 * px_;
    for (const LabelOverlay::Words& words : overlay_.words) {
      const Eigen::Vector2d from = frame_.page(words.from), to = frame_.page(words.to);
      const Eigen::Vector2d middle = (from + to) / 2.0;
      style.is_bold = words.is_typed;
      style.colour = words.is_typed ? theme_.accent : theme_.text;
      const PageRect plate = plate_at(middle, words.line, style, px_);
      if (!words.is_typed && (to - from).norm() < plate.width) continue;
      draw_plate(canvas_, middle, words.line, style, with_opacity(theme_.page, 0.9), px_);
    }
  }

  Canvas& canvas_;
  const MapFrame& frame_;
  const LabelOverlay& overlay_;
  const Theme& theme_;
  double px_;
  PlaneBounds sight_;
  Rgba casing_;
};

}  // namespace

void draw_label_overlay(Canvas& canvas,
                        const MapFrame& frame,
                        const LabelOverlay& overlay,
                        const Theme& theme) {
  LabelDrawing(canvas, frame, overlay, theme).draw();
}

std::vector<Ring> border_of(const LabelObject& object, double metres_per_px) {
  std::vector<Ring> border;
  if (object.kind == ObjectKind::kLine) {
    const Ring& line = object.rings.front();
    if (object.width_m < kLeastWidthPx * metres_per_px) return {line};
    // Once around: to its end on one side, and back on the other.
    Ring around = moved_beside(line, object.width_m / 2.0);
    const Ring right = moved_beside(line, -object.width_m / 2.0);
    around.insert(around.end(), right.rbegin(), right.rend());
    around.push_back(around.front());
    border.push_back(std::move(around));
    return border;
  }
  for (Ring ring : object.rings) {
    if (!ring.empty()) ring.push_back(ring.front());
    border.push_back(std::move(ring));
  }
  return border;
}

std::vector<Eigen::Vector2d> page_line(const MapFrame& frame,
                                       const Ring& places_in_enu_m,
                                       double least_px) {
  std::vector<Eigen::Vector2d> line;
  line.reserve(places_in_enu_m.size());
  for (std::size_t i = 0; i < places_in_enu_m.size(); ++i) {
    const Eigen::Vector2d point = frame.page(places_in_enu_m[i]);
    const bool is_last = i + 1 == places_in_enu_m.size();
    if (!line.empty() && (point - line.back()).norm() < least_px) {
      if (is_last && line.size() > 1) line.back() = point;
      continue;
    }
    line.push_back(point);
  }
  return line;
}

}  // namespace nadir
