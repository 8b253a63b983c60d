// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/edit_objects.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {
namespace {

using Json = nlohmann::json;

constexpr const char* kGeometryNames[] = {"Polygon", "LineString", "Polygon"};  // By kind.

Json text_of_places(const Ring& ring, bool repeats_first) {
  Json places = Json::array();
  for (const Eigen::Vector2d& place : ring) places.push_back({place.x(), place.y()});
  if (repeats_first && !ring.empty()) places.push_back({ring.front().x(), ring.front().y()});
  return places;
}

/// A text member, or empty.
std::string word(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() && found->is_string()
             ? found->get<std::string>()
             : std::string();
}
Json member(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) ? object.at(key) : Json();
}

Result<Ring> places_from(const Json& places, bool repeats_first) {
  Ring ring;
  for (const Json& place : places) {
    const bool is_place =
        place.is_array() && place.size() == 2 && place[0].is_number() && place[1].is_number();
    if (!is_place) return fail(ErrorCode::kMalformed, "a place is not two numbers");
    ring.emplace_back(place[0].get<double>(), place[1].get<double>());
  }
  if (repeats_first && ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

Result<LabelObject> object_from(const Json& feature) {
  LabelObject object;
  const Json properties = member(feature, "properties");
  const auto& kinds = EnumNames<ObjectKind>::kNames;
  const auto* const kind = std::find(kinds.begin(), kinds.end(), word(properties, "kind"));
  if (kind == kinds.end()) return fail(ErrorCode::kMalformed, "an object has no kind");
  object.kind = static_cast<ObjectKind>(kind - kinds.begin());
  const std::string name = word(properties, "class");
  const auto id = name == class_info(kUnclassified).name ? std::optional<ClassId>(kUnclassified)
                                                         : class_from_name(name);
  if (!id) return fail(ErrorCode::kMalformed, "an object has no class");
  object.class_id = *id;
  const Json width = member(properties, "width_m");
  if (width.is_number()) object.width_m = width.get<double>();
  object.note = word(properties, "note");
  const Json coordinates = member(member(feature, "geometry"), "coordinates");
  if (!coordinates.is_array()) return fail(ErrorCode::kMalformed, "an object has no places");
  if (!is_closed(object.kind)) {
    auto line = places_from(coordinates, false);
    if (!line) return forward_error(line);
    object.rings.push_back(std::move(*line));
    return object;
  }
  for (const Json& places : coordinates) {
    if (!places.is_array()) return fail(ErrorCode::kMalformed, "a ring has no places");
    auto ring = places_from(places, true);
    if (!ring) return forward_error(ring);
    object.rings.push_back(std::move(*ring));
  }
  return object;
}

/// Adds copies on top of the levels of their classes.
Result<LabelEdit> adding_copies(const LabelDocument& document,
                                std::vector<LabelObject> objects,
                                const Eigen::Vector2d& by_m,
                                const char* title) {
  EditBuilder builder(document, title);
  for (LabelObject& object : objects) {
    object.order = builder.next_order(object.class_id);
    if (!by_m.isZero(0.0)) {
      for (Ring& ring : object.rings) {
        for (Eigen::Vector2d& place : ring) place = on_lattice(place + by_m);
      }
    }
    builder.add(std::move(object));
  }
  return builder.edit();
}

Result<std::vector<LabelObject>> copies_in_drawing_order(const LabelDocument& document,
                                                         std::span<const ObjectId> objects) {
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  std::vector<LabelObject> copies;
  for (const LabelObject* const object : *selected) copies.push_back(*object);
  std::stable_sort(copies.begin(), copies.end(),
                   [](const LabelObject& a, const LabelObject& b) { return a.order < b.order; });
  return copies;
}

}  // namespace

Result<std::string> objects_text(const LabelDocument& document, std::span<const ObjectId> objects) {
  const auto copies = copies_in_drawing_order(document, objects);
  if (!copies) return forward_error(copies);
  Json features = Json::array();
  for (const LabelObject& object : *copies) {
    Json coordinates = Json::array();
    for (const Ring& ring : object.rings)
      coordinates.push_back(text_of_places(ring, is_closed(object.kind)));
    const Json geometry{{"type", kGeometryNames[static_cast<std::size_t>(object.kind)]},
                        {"coordinates", is_closed(object.kind) ? coordinates : coordinates.at(0)}};
    const Json properties{{"kind", enum_name(object.kind)},
                          {"class", class_info(object.class_id).name},
                          {"width_m", object.width_m},
                          {"note", object.note}};
    features.push_back({{"type", "Feature"}, {"properties", properties}, {"geometry", geometry}});
  }
  const Json all{{"type", "FeatureCollection"}, {"frame", "enu"}, {"features", features}};
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<LabelEdit> paste(const LabelDocument& document,
                        std::string_view text,
                        const Eigen::Vector2d& by_m) {
  const Json all = Json::parse(text, nullptr, false);
  const Json features = member(all, "features");
  if (word(all, "frame") != "enu" || !features.is_array()) {
    return fail(ErrorCode::kMalformed, "the clipboard holds no objects of a label map");
  }
  std::vector<LabelObject> objects;
  for (const Json& feature : features) {
    auto object = object_from(feature);
    if (!object) return forward_error(object, "clipboard");
    objects.push_back(std::move(*object));
  }
  return adding_copies(document, std::move(objects), by_m, "Paste");
}

Result<LabelEdit> duplicate(const LabelDocument& document,
                            std::span<const ObjectId> objects,
                            const Eigen::Vector2d& by_m) {
  auto copies = copies_in_drawing_order(document, objects);
  if (!copies) return forward_error(copies);
  return adding_copies(document, std::move(*copies), by_m, "Duplicate");
}

}  // namespace nadir
