// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/label_overlay_model.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "core/desk/object_index.h"
#include "core/edit/polygon_algebra.h"
#include "widgets/panels/map_geometry.h"

namespace nadir {
namespace {

/// More legs than these are not named: nobody reads them.
constexpr std::size_t kMostNamedLegs = 100;

std::vector<Ring> rings_of(Region region) {
  std::vector<Ring> rings;
  for (std::vector<Ring>& part : region.parts) {
    rings.insert(rings.end(), std::make_move_iterator(part.begin()),
                 std::make_move_iterator(part.end()));
  }
  return rings;
}

/// Rings that surround what an object covers, odd and even; nothing where that cannot be told.
std::optional<std::vector<Ring>> covered_by(const LabelObject& object) {
  if (object.kind == ObjectKind::kArea) return object.rings;
  auto whole = region_of(object);
  if (!whole) return std::nullopt;
  if (object.kind == ObjectKind::kLine) return rings_of(std::move(*whole));
  auto inside = grown(*whole, -object.width_m);
  std::vector<Ring> rings = rings_of(std::move(*whole));
  if (inside) {
    for (Ring& ring : rings_of(std::move(*inside))) rings.push_back(std::move(ring));
  }
  return rings;
}

std::optional<LabelOverlay::Snapped> snapped_by(const ToolPoint& aim) {
  if (aim.closes) return LabelOverlay::Snapped{SnapMark::kClosing, aim.in_enu_m};
  if (!aim.snap) return std::nullopt;
  constexpr std::array<SnapMark, 4> kMarks = {SnapMark::kCorner, SnapMark::kEdge,
                                              SnapMark::kContinuing, SnapMark::kSquareOn};
  return LabelOverlay::Snapped{kMarks.at(static_cast<std::size_t>(aim.snap->kind)), aim.in_enu_m};
}

std::string leg_words(const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool with_bearing) {
  const std::array<Eigen::Vector2d, 2> ends = {from, to};
  const Measured measured = measure(ends);
  std::string words = distance_text(measured.length_m);
  if (with_bearing && measured.bearing_deg) words += "  " + bearing_text(*measured.bearing_deg);
  return words;
}

void add_words(const ToolPoints& points, LabelOverlay& overlay) {
  const std::vector<Eigen::Vector2d>& places = overlay.places;
  if (places.size() <= kMostNamedLegs) {
    for (std::size_t i = 1; i < places.size(); ++i) {
      overlay.words.push_back(
          {places[i - 1], places[i], leg_words(places[i - 1], places[i], false), false});
    }
  }
  if (!overlay.next || places.empty()) return;
  overlay.words.push_back({places.back(), *overlay.next,
                           leg_words(places.back(), *overlay.next, true), !points.typed().empty()});
}

std::shared_ptr<const LabelObject> object_under(const LabelDesk& desk, const LabelHand& hand) {
  const LabelDocument& document = desk.sheet().now();
  const auto hit = objects_at(document, desk.sheet().objects(), hand.in_enu_m, hand.reach_m);
  if (hit.empty() || desk.selection().contains(hit.front())) return nullptr;
  return document.object(hit.front());
}

}  // namespace

std::vector<LabelOverlay::Coming> coming_shapes(std::span<const LabelObject> objects) {
  std::vector<LabelOverlay::Coming> shapes;
  for (const LabelObject& object : objects) {
    const bool is_guide = object.kind != ObjectKind::kArea && !(object.width_m > 0.0);
    std::optional<std::vector<Ring>> covered;
    if (!is_guide) covered = covered_by(object);
    const bool is_filled = covered.has_value();
    LabelOverlay::Coming shape{object.rings, is_filled, object.class_id};
    if (is_filled) shape.rings = std::move(*covered);
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

LabelOverlay label_overlay_of(const LabelDesk& desk, const std::optional<LabelHand>& hand) {
  LabelOverlay overlay;
  const ToolKind kind = desk.tool().kind;
  const LabelDocument& document = desk.sheet().now();
  for (const ObjectId id : desk.selection().ids()) {
    if (auto object = document.object(id)) overlay.selected.push_back(std::move(object));
  }
  for (const PickedVertex& vertex : desk.picked()) overlay.picked.push_back(vertex.in_enu_m);
  overlay.shows_corners = kind == ToolKind::kVertices;
  if (draws_freely(kind)) {
    if (hand && kind != ToolKind::kFill) {
      overlay.brush = {hand->in_enu_m,
                       brush_radius_m(desk.tool(), document.grid().metres_per_cell)};
    }
    return overlay;
  }
  overlay.places = desk.points().ring();
  if (!hand) return overlay;
  if (kind == ToolKind::kSelect || kind == ToolKind::kVertices) {
    overlay.under_hand = object_under(desk, *hand);
    return overlay;
  }
  const ToolPoint aim = desk.aim(hand->in_enu_m, hand->reach_m);
  overlay.next = aim.in_enu_m;
  overlay.closes = draws_ring(kind) && most_points(kind) == 0;
  overlay.snapped = snapped_by(aim);
  overlay.coming = coming_shapes(desk.coming(hand->in_enu_m, hand->reach_m));
  // What the places themselves show need not be shown twice.
  std::erase_if(overlay.coming, [](const auto& coming) { return !coming.is_filled; });
  add_words(desk.points(), overlay);
  return overlay;
}

}  // namespace nadir
