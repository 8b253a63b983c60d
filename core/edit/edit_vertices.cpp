// SPDX-License-Identifier: Apache-2.0
#include "core/edit/edit_vertices.h"

#include <algorithm>
#include <set>

#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/polygon_algebra.h"

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

}  // namespace

Result<LabelEdit> move_vertex(const LabelDocument& document,
                              const VertexRef& vertex,
                              const Eigen::Vector2d& to_in_enu_m,
                              SharedBorders shared) {
  const auto from = place_of(document, vertex);
  if (!from) return forward_error(from);
  const Eigen::Vector2d to = on_lattice(to_in_enu_m);
  EditBuilder builder(document, "Move vertex");
  if (shared == SharedBorders::kAlone) {
    builder.change(vertex.object).rings[vertex.ring][vertex.place] = to;
    return builder.edit();
  }
  visit_objects_in(document, box_around(*from, *from), [&](const LabelObject& object) {
    const auto has_it = [&](const Ring& ring) {
      return std::find(ring.begin(), ring.end(), *from) != ring.end();
    };
    if (std::none_of(object.rings.begin(), object.rings.end(), has_it)) return;
    for (Ring& ring : builder.change(object.id).rings) {
      std::replace(ring.begin(), ring.end(), *from, to);
    }
  });
  return builder.edit();
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
  visit_objects_in(document, box_around(*from, *from), [&](const LabelObject& other) {
    for (std::size_t ring = 0; ring < other.rings.size(); ++ring) {
      const Ring& places = other.rings[ring];
      // From the end, so that what was inserted does not shift what comes.
      for (std::size_t i = is_closed(other.kind) ? places.size() : places.size() - 1; i-- > 0;) {
        const Eigen::Vector2d& next = places[(i + 1) % places.size()];
        const bool is_same =
            (places[i] == *from && next == to) || (places[i] == to && next == *from);
        if (is_same) insert(other.id, ring, i);
      }
    }
  });
  return builder.edit();
}

Result<LabelEdit> remove_vertices(const LabelDocument& document,
                                  std::span<const VertexRef> vertices,
                                  SharedBorders shared) {
  PlaceSet places;
  PlaneBounds bounds;
  for (const VertexRef& vertex : vertices) {
    const auto place = place_of(document, vertex);
    if (!place) return forward_error(place);
    places.insert(*place);
    bounds.include(*place);
  }
  EditBuilder builder(document, vertices.size() == 1 ? "Delete vertex" : "Delete vertices");
  const std::set<VertexRef> alone(vertices.begin(), vertices.end());
  visit_objects_in(document, bounds, [&](const LabelObject& object) {
    leave_out(builder, object, [&](const VertexRef& vertex) {
      if (shared == SharedBorders::kAlone) return alone.count(vertex) > 0;
      return places.count(object.rings[vertex.ring][vertex.place]) > 0;
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
