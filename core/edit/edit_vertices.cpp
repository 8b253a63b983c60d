// SPDX-License-Identifier: Apache-2.0
#include "core/edit/edit_vertices.h"

#include <functional>
#include <set>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/near_places.h"

namespace nadir {
namespace {

Result<Eigen::Vector2d> place_of(const LabelDocument& document, const VertexRef& vertex) {
  const auto object = document.object(vertex.object);
  if (object == nullptr) {
    return fail(ErrorCode::kInvalidOptions, "there is no object {}", vertex.object);
  }
  if (vertex.ring >= object->rings.size() || vertex.place >= object->rings[vertex.ring].size()) {
    return fail(ErrorCode::kInvalidOptions, "{} has no such place", object_name(*object));
  }
  return object->rings[vertex.ring][vertex.place];
}

bool do_touch(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a - b).norm() <= kTouchM;
}

/// Calls `visit(object)` for all that may have something within some bounds.
template <typename Visit>
void visit_objects_in(const LabelDocument& document, const PlaneBounds& box, const Visit& visit) {
  for (const auto& [id, placed] : document.objects()) {
    if (do_meet(placed.bounds, box)) visit(*placed.object);
  }
}

void leave_out(EditBuilder& builder,
               const LabelObject& object,
               const std::function<bool(const VertexRef&)>& goes) {
  std::vector<Ring> rings;
  bool has_changed = false;
  for (std::size_t ring = 0; ring < object.rings.size(); ++ring) {
    Ring kept;
    for (std::size_t place = 0; place < object.rings[ring].size(); ++place) {
      if (!goes({object.id, ring, place})) kept.push_back(object.rings[ring][place]);
    }
    has_changed = has_changed || kept.size() < object.rings[ring].size();
    rings.push_back(without_repeats(std::move(kept), is_closed(object.kind)));
  }
  if (!has_changed) return;
  if (rings.front().size() < (is_closed(object.kind) ? 3U : 2U)) {
    builder.remove(object.id);
  } else {
    builder.change(object.id).rings = std::move(rings);
  }
}

/// Moves some places, and if asked what lies where they do.
/// @param new_place  Where one of them goes.
Result<LabelEdit> moved(const LabelDocument& document,
                        std::span<const VertexRef> vertices,
                        SharedBorders shared,
                        const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& new_place) {
  EditBuilder builder(document, vertices.size() == 1 ? "Move vertex" : "Move vertices");
  std::vector<Eigen::Vector2d> from;
  from.reserve(vertices.size());
  for (const VertexRef& vertex : vertices) {
    const auto place = place_of(document, vertex);
    if (!place) return forward_error(place);
    from.push_back(*place);
    if (shared == SharedBorders::kAlone) {
      builder.change(vertex.object).rings[vertex.ring][vertex.place] = new_place(*place);
    }
  }
  if (shared == SharedBorders::kAlone) return builder.edit();
  const NearPlaces places(std::move(from));
  visit_objects_in(document, places.bounds(), [&](const LabelObject& object) {
    for (std::size_t ring = 0; ring < object.rings.size(); ++ring) {
      for (std::size_t place = 0; place < object.rings[ring].size(); ++place) {
        const auto found = places.first_near(object.rings[ring][place]);
        if (found) builder.change(object.id).rings[ring][place] = new_place(*found);
      }
    }
  });
  return builder.edit();
}

}  // namespace

Result<LabelEdit> move_vertex(const LabelDocument& document,
                              const VertexRef& vertex,
                              const Eigen::Vector2d& to_in_enu_m,
                              SharedBorders shared) {
  Eigen::Vector2d to = on_lattice(to_in_enu_m);
  return moved(document, std::span(&vertex, 1), shared,
               [&](const Eigen::Vector2d& /*from*/) { return to; });
}

Result<LabelEdit> move_vertices(const LabelDocument& document,
                                std::span<const VertexRef> vertices,
                                const Eigen::Vector2d& by_m,
                                SharedBorders shared) {
  return moved(document, vertices, shared,
               [&](const Eigen::Vector2d& from) { return on_lattice(from + by_m); });
}

Result<LabelEdit> add_vertex(const LabelDocument& document,
                             const VertexRef& before,
                             const Eigen::Vector2d& at_in_enu_m,
                             SharedBorders shared) {
  const auto from = place_of(document, before);
  if (!from) return forward_error(from);
  const auto object = document.object(before.object);
  const Ring& of_ring = object->rings[before.ring];
  if (!is_closed(object->kind) && before.place + 1 == of_ring.size()) {
    return fail(ErrorCode::kInvalidOptions, "{} ends there", object_name(*object));
  }
  const Eigen::Vector2d to = of_ring[(before.place + 1) % of_ring.size()];
  const Eigen::Vector2d place = on_lattice(at_in_enu_m);
  EditBuilder builder(document, "Add vertex");
  const auto insert = [&](ObjectId id, std::size_t ring, std::size_t after) {
    Ring& places = builder.change(id).rings[ring];
    places.insert(places.begin() + static_cast<std::ptrdiff_t>(after) + 1, place);
  };
  if (shared == SharedBorders::kAlone) {
    insert(before.object, before.ring, before.place);
    return builder.edit();
  }
  visit_objects_in(document, box_around(*from, *from, kTouchM), [&](const LabelObject& other) {
    for (std::size_t ring = 0; ring < other.rings.size(); ++ring) {
      const Ring& places = other.rings[ring];
      // From the end, so that what was inserted does not shift what comes.
      for (std::size_t i = is_closed(other.kind) ? places.size() : places.size() - 1; i-- > 0;) {
        const Eigen::Vector2d& next = places[(i + 1) % places.size()];
        const bool is_same = (do_touch(places[i], *from) && do_touch(next, to)) ||
                             (do_touch(places[i], to) && do_touch(next, *from));
        if (is_same) insert(other.id, ring, i);
      }
    }
  });
  return builder.edit();
}

Result<LabelEdit> remove_vertices(const LabelDocument& document,
                                  std::span<const VertexRef> vertices,
                                  SharedBorders shared) {
  std::vector<Eigen::Vector2d> taken;
  taken.reserve(vertices.size());
  for (const VertexRef& vertex : vertices) {
    const auto place = place_of(document, vertex);
    if (!place) return forward_error(place);
    taken.push_back(*place);
  }
  const NearPlaces places(std::move(taken));
  EditBuilder builder(document, vertices.size() == 1 ? "Delete vertex" : "Delete vertices");
  const std::set<VertexRef> alone(vertices.begin(), vertices.end());
  visit_objects_in(document, places.bounds(), [&](const LabelObject& object) {
    leave_out(builder, object, [&](const VertexRef& vertex) {
      if (shared == SharedBorders::kAlone) return alone.count(vertex) > 0;
      return places.nearest(object.rings[vertex.ring][vertex.place]).has_value();
    });
  });
  return builder.edit();
}

Result<LabelEdit> move_objects(const LabelDocument& document,
                               std::span<const ObjectId> objects,
                               const Eigen::Vector2d& by_m) {
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  EditBuilder builder(document, "Move");
  if (by_m.isZero(0.0)) return builder.edit();
  for (const LabelObject* const object : *selected) {
    for (Ring& ring : builder.change(object->id).rings) {
      for (Eigen::Vector2d& place : ring) place = on_lattice(place + by_m);
    }
  }
  return builder.edit();
}

}  // namespace nadir
