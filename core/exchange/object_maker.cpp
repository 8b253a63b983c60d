// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/object_maker.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/edit/polygon_algebra.h"
#include "core/map/gdal_raster.h"

namespace nadir {
namespace {

/// A circle's area, as a polygon of the same area would have it.
Ring spot(const Eigen::Vector2d& centre, double diameter_m) {
  constexpr int kCorners = 16;
  constexpr double kTurn = 2.0 * 3.14159265358979323846 / kCorners;
  const double radius_m = diameter_m / 2.0 * std::sqrt(kTurn / std::sin(kTurn));
  Ring ring;
  for (int i = 0; i < kCorners; ++i) {
    ring.push_back(centre + radius_m * Eigen::Vector2d(std::cos(i * kTurn), std::sin(i * kTurn)));
  }
  return ring;
}

bool crosses_itself(const std::vector<Ring>& rings) {
  const GdalMessages quiet;
  OGRPolygon polygon;
  for (const Ring& ring : rings) {
    auto border = std::make_unique<OGRLinearRing>();
    for (const Eigen::Vector2d& point : ring) border->addPoint(point.x(), point.y());
    border->closeRings();
    polygon.addRingDirectly(border.release());
  }
  return polygon.IsValid() == FALSE;
}

/// A feature's rings on the plane; nothing where a place has none there.
std::optional<std::vector<Ring>> rings_on_plane(const SourceFeature& feature,
                                                const EnuFromLayer& to_enu) {
  std::vector<Ring> rings;
  for (const Ring& ring : feature.rings) {
    rings.emplace_back();
    for (const Eigen::Vector2d& place : ring) {
      const auto point = to_enu(place);
      if (!point) return std::nullopt;
      rings.back().push_back(on_lattice(*point));  // so that what snaps to it shares it
    }
  }
  return rings;
}

}  // namespace

ObjectMaker::ObjectMaker(const LabelDocument& document, Tally faults)
    : document_(document), faults_(std::move(faults)), next_id_(document.next_id()) {
  made_.edit.title = "Import";
}

void ObjectMaker::add(const SourceFeature& feature,
                      const ImportRules& rules,
                      const EnuFromLayer& to_enu) {
  ++made_.read;
  const auto drawn = rules.apply(feature.tags, feature.form);
  if (!drawn) {
    ++unknown_;
    return;
  }
  if (drawn->kind == ImportKind::kNothing) return;
  auto rings = rings_on_plane(feature, to_enu);
  if (!rings) {
    faults_.add("thing has coordinates that lie nowhere and was left out",
                "things have coordinates that lie nowhere and were left out");
    return;
  }
  LabelObject object{.id = 0,
                     .kind = ObjectKind::kArea,
                     .class_id = drawn->class_id,
                     .order = 0,
                     .width_m = drawn->width_m,
                     .rings = *std::move(rings),
                     .note = drawn->note.value_or(feature.name)};
  if (drawn->kind == ImportKind::kLine) {
    add_lines(std::move(object), feature.form, *drawn);
    return;
  }
  if (drawn->kind == ImportKind::kOutline) object.kind = ObjectKind::kOutline;
  if (drawn->kind == ImportKind::kSpot) {
    object.rings = {spot(object.rings.front().front(), drawn->width_m)};
    object.width_m = 0.0;
  }
  add_object(std::move(object), *drawn);
}

ImportedLabels ObjectMaker::finish() && {
  faults_.add("thing fits no rule and was left out", "things fit no rule and were left out",
              unknown_);
  faults_.add("object lies outside of the map and was left out",
              "objects lie outside of the map and were left out", outside_);
  made_.taken = made_.edit.objects.size();
  made_.notices = faults_.sentences();
  return std::move(made_);
}

/// One a ring; closed ones come back to their start.
void ObjectMaker::add_lines(LabelObject object, SourceForm form, const ImportRules::Drawn& drawn) {
  const std::vector<Ring> rings = std::move(object.rings);
  object.kind = ObjectKind::kLine;
  for (const Ring& ring : rings) {
    object.rings = {ring};
    if (form != SourceForm::kOpenLine) object.rings.front().push_back(ring.front());
    add_object(object, drawn);
  }
}

void ObjectMaker::add_object(LabelObject object, const ImportRules::Drawn& drawn) {
  object.id = next_id_;
  if (const auto sound = check_object(object); !sound) {
    faults_.add("thing has too few places or lies too far away and was left out",
                "things have too few places or lie too far away and were left out");
    return;
  }
  const CellRect cells = document_.grid().cells_of(drawn_bounds(object), 1);
  if (cells.cut_to(document_.grid().whole()).empty()) {
    ++outside_;
    return;
  }
  if (object.kind != ObjectKind::kLine && crosses_itself(object.rings)) {
    faults_.add("area crosses itself: its inside is what an odd number of its rings surrounds",
                "areas cross themselves: their inside is what an odd number of rings surrounds");
  }
  object.order = drawn.order ? *drawn.order : next_order(drawn.above.value_or(object.class_id));
  ++next_id_;
  made_.edit.objects.push_back({nullptr, std::make_shared<const LabelObject>(std::move(object))});
}

/// On top of what a class's level has.
std::int64_t ObjectMaker::next_order(ClassId id) {
  const std::int64_t level = drawing_level(id);
  auto [found, is_new] = next_orders_.try_emplace(static_cast<int>(level), 0);
  if (is_new) found->second = document_.next_order(id);
  const std::int64_t order = found->second;
  found->second = std::min(order + kOrderStep, (level + 1) * kOrdersPerLevel - 1);
  return order;
}

}  // namespace nadir
