// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/label_gestures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/edit/snapping.h"
#include "widgets/panels/picture_area.h"

namespace nadir {
namespace {

constexpr double kReachPx = 9.0;     ///< Of the design: how near is near.
constexpr double kBrushStep = 1.25;  ///< Of one press of [ or ].
constexpr double kLeastBrush = 0.01, kLeastBrushCells = 0.5, kMostBrush = 10'000.0;

}  // namespace

std::optional<VertexRef> selected_corner_at(const LabelDesk& desk,
                                            const Eigen::Vector2d& place_in_enu_m,
                                            double reach_m) {
  std::optional<VertexRef> nearest;
  double nearest_m = reach_m;
  for (const ObjectId id : desk.selection().ids()) {
    const auto object = desk.sheet().now().object(id);
    if (object == nullptr) continue;
    for (std::size_t ring = 0; ring < object->rings.size(); ++ring) {
      for (std::size_t place = 0; place < object->rings[ring].size(); ++place) {
        const double away_m = (object->rings[ring][place] - place_in_enu_m).norm();
        if (away_m > nearest_m) continue;
        nearest_m = away_m;
        nearest = VertexRef{id, ring, place};
      }
    }
  }
  return nearest;
}

double LabelGestures::reach_m() const { return ui_.px(kReachPx) * camera_.metres_per_px; }

Eigen::Vector2d LabelGestures::under_mouse() const {
  return camera_.enu_from_page(middle_of_pixel(area_.mouse), where_);
}

std::optional<double> LabelGestures::brush_m() const {
  if (!draws_freely(desk_.tool().kind)) return std::nullopt;
  return brush_radius_m(desk_.tool(), desk_.sheet().now().grid().metres_per_cell);
}

SelectHow LabelGestures::how() const {
  if (area_.modifiers.ctrl) return SelectHow::kToggle;
  return area_.modifiers.shift ? SelectHow::kAdd : SelectHow::kInstead;
}

bool LabelGestures::takes_drags() const {
  const ToolKind kind = desk_.tool().kind;
  return kind == ToolKind::kSelect || kind == ToolKind::kVertices || draws_freely(kind);
}

Actions LabelGestures::handle() {
  if (area_.is_hovered) change_brush();
  drag();
  if (area_.double_clicked == kit::MouseButton::kLeft) {
    double_click();
  } else if (area_.clicked == kit::MouseButton::kLeft) {
    click();
  } else if (area_.clicked == kit::MouseButton::kRight && !desk_.points().empty()) {
    asked_.emplace_back(actions::FinishTool{});
  }
  return std::move(asked_);
}

void LabelGestures::click() {
  const Eigen::Vector2d place = under_mouse();
  if (draws_freely(desk_.tool().kind)) {
    asked_.emplace_back(actions::AddPlace{place.x(), place.y(), {}, {}});
    asked_.emplace_back(actions::FinishTool{});
    return;
  }
  if (area_.modifiers.alt && !desk_.points().empty()) {
    const TraceWay way = area_.modifiers.shift ? TraceWay::kFar : TraceWay::kNear;
    asked_.emplace_back(actions::TraceTo{place.x(), place.y(), reach_m(), way});
    return;
  }
  asked_.emplace_back(actions::AddPlace{place.x(), place.y(), reach_m(), how()});
}

void LabelGestures::double_click() {
  if (!desk_.points().empty()) {  // its first click has set the last place
    asked_.emplace_back(actions::FinishTool{});
    return;
  }
  const ToolKind kind = desk_.tool().kind;
  if (kind == ToolKind::kSelect && !desk_.selection().empty()) {
    asked_.emplace_back(actions::SetLabelOption{"tool", "vertices"});
    return;
  }
  if (kind != ToolKind::kVertices) return;
  const Eigen::Vector2d place = under_mouse();
  const auto snap = desk_.sheet().places().nearest(place, reach_m());
  if (!snap || snap->kind != SnapKind::kEdge || !desk_.selection().contains(snap->at.object))
    return;
  asked_.emplace_back(actions::AddVertex{snap->at.object, static_cast<int>(snap->at.ring),
                                         static_cast<int>(snap->at.place), snap->in_enu_m.x(),
                                         snap->in_enu_m.y()});
}

void LabelGestures::change_brush() {
  if (!brush_m()) return;
  const double factor = ui_.is_pressed("]", true)   ? kBrushStep
                        : ui_.is_pressed("[", true) ? 1.0 / kBrushStep
                                                    : 1.0;
  if (factor == 1.0) return;
  const LabelTool& tool = desk_.tool();
  const bool in_metres = tool.brush_unit == BrushUnit::kMetres;
  const double now = in_metres ? tool.brush_radius_m : tool.brush_radius_cells;
  const double next =
      std::clamp(now * factor, in_metres ? kLeastBrush : kLeastBrushCells, double{kMostBrush});
  asked_.emplace_back(actions::SetLabelOption{in_metres ? "brush-radius" : "brush-cells",
                                              fmt::format("{:.4g}", next)});
}

}  // namespace nadir
