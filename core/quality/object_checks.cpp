// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/edit/edge_tree.h"
#include "core/edit/polygon_algebra.h"
#include "core/quality/check_parts.h"

namespace nadir {
namespace {

Finding finding_about(const PlacedObject& placed, FindingKind kind) {
  Finding finding;
  finding.kind = kind;
  finding.severity = FindingSeverity::kMistake;
  finding.class_id = placed.object->class_id;
  finding.objects = {placed.object->id};
  finding.bounds = placed.bounds;
  finding.place_in_enu_m = placed.object->rings.front().front();
  return finding;
}

/// Whether it crosses itself, which is then told.
bool find_crossing(const PlacedObject& placed, std::vector<Finding>& findings) {
  const auto crossing = new_crossing(nullptr, *placed.object);
  if (crossing && !*crossing) return false;
  Finding finding = finding_about(placed, FindingKind::kSelfCrossing);
  finding.sentence = fmt::format("{} crosses itself", named(*placed.object));
  if (crossing) {
    finding.place_in_enu_m = **crossing;
  } else {
    finding.sentence += " more often than can be counted";
    finding.why_not_fix = crossing.error().message;
  }
  findings.push_back(std::move(finding));
  return true;
}

/// What an area covers, told from its rings where they are in order.
double covered_m2(const LabelObject& object, double least_m2) {
  double area = std::abs(signed_area_m2(object.rings.front()));
  for (std::size_t i = 1; i < object.rings.size(); ++i) {
    area -= std::abs(signed_area_m2(object.rings[i]));
  }
  if (object.rings.size() == 1 || area >= least_m2) return area;
  // Holes that lie outside, or in each other, cover something too.
  const auto region = region_of(object);
  return region ? area_m2(*region) : std::abs(area);
}

void find_degenerate(const PlacedObject& placed, double least_m, std::vector<Finding>& findings) {
  const LabelObject& object = *placed.object;
  Finding finding = finding_about(placed, FindingKind::kDegenerate);
  if (object.kind == ObjectKind::kLine) {
    finding.size = length_m(object.rings.front());
    if (!(finding.size < least_m)) return;
    finding.sentence = fmt::format("{} is {} m long", named(object), size_text(finding.size));
  } else {
    finding.size = covered_m2(object, least_m * least_m);
    finding.has_area = true;
    if (!(finding.size < least_m * least_m)) return;
    finding.sentence = fmt::format("{} covers {} m2", named(object), size_text(finding.size));
  }
  findings.push_back(std::move(finding));
}

/// How far a place lies out of a rectangle; 0 inside.
double distance_out_m(const PlaneBounds& image, const Eigen::Vector2d& place) {
  const Eigen::Vector2d inside = place.cwiseMax(image.low).cwiseMin(image.high);
  return (place - inside).norm();
}

void find_outside(const PlacedObject& placed,
                  const PlaneBounds& image,
                  double reach_m,
                  std::vector<Finding>& findings) {
  PlaneBounds allowed = image;
  allowed.grow(reach_m);
  const PlaneBounds& bounds = placed.bounds;
  if ((bounds.low.array() >= allowed.low.array()).all() &&
      (bounds.high.array() <= allowed.high.array()).all()) {
    return;
  }
  Finding finding = finding_about(placed, FindingKind::kFarOutside);
  for (const Ring& ring : placed.object->rings) {
    for (const Eigen::Vector2d& place : ring) {
      const double distance = distance_out_m(image, place);
      if (distance <= finding.size) continue;
      finding.size = distance;
      finding.place_in_enu_m = place;
    }
  }
  if (!(finding.size > reach_m)) return;
  finding.sentence =
      fmt::format("{} {} {} m {} the image", named(*placed.object),
                  do_meet(bounds, image) ? "reaches" : "lies up to", size_text(finding.size),
                  do_meet(bounds, image) ? "out of" : "outside of");
  finding.why_not_fix = "whether it belongs elsewhere or nowhere is not known";
  findings.push_back(std::move(finding));
}

bool are_near(const PlaneBounds& a, const PlaneBounds& b, double reach_m) {
  return (a.low - b.low).cwiseAbs().maxCoeff() <= reach_m &&
         (a.high - b.high).cwiseAbs().maxCoeff() <= reach_m;
}

/// Whether all places of some rings lie within reach of the rings of a tree.
bool do_follow(const std::vector<Ring>& rings, const EdgeTree& tree, double reach_m) {
  for (const Ring& ring : rings) {
    for (const Eigen::Vector2d& place : ring) {
      bool is_near = false;
      tree.visit(box_around(place, place, reach_m), [&](const EdgeTree::Edge& edge) {
        is_near = is_near || (nearest_on_edge(edge.from, edge.to, place) - place).norm() <= reach_m;
      });
      if (!is_near) return false;
    }
  }
  return true;
}

bool are_same(const LabelObject& a, const LabelObject& b, double reach_m) {
  if (a.kind != b.kind || a.class_id != b.class_id || a.rings.size() != b.rings.size() ||
      std::abs(a.width_m - b.width_m) > reach_m) {
    return false;
  }
  if (a.rings == b.rings) return true;
  const EdgeTree tree_a(a.rings, is_closed(a.kind));
  const EdgeTree tree_b(b.rings, is_closed(b.kind));
  return do_follow(a.rings, tree_b, reach_m) && do_follow(b.rings, tree_a, reach_m);
}

}  // namespace

Result<void> check_shapes(const CheckInput& input, std::vector<Finding>& findings) {
  const PlaneBounds image = bounds_of_cells(input.grid, input.grid.whole());
  std::size_t count = 0;
  for (const auto& [id, placed] : input.document.objects()) {
    if (++count % 256 == 0 && input.work.is_stopped()) {
      return fail(ErrorCode::kCancelled, "the check was stopped");
    }
    if (!is_asked_for(input, placed.bounds)) continue;
    find_outside(placed, image, input.settings.outside_m, findings);
    if (is_closed(placed.object->kind) && find_crossing(placed, findings)) continue;
    find_degenerate(placed, input.settings.degenerate_m, findings);
  }
  return {};
}

void check_duplicates(const CheckInput& input, std::vector<Finding>& findings) {
  const double reach_m = input.settings.duplicate_m;
  std::vector<const PlacedObject*> objects;
  for (const auto& [id, placed] : input.document.objects()) {
    PlaneBounds bounds = placed.bounds;
    bounds.grow(reach_m);  // What is the same as an object that is asked for may lie beside it.
    if (is_asked_for(input, bounds)) objects.push_back(&placed);
  }
  std::stable_sort(objects.begin(), objects.end(), [](const auto* a, const auto* b) {
    return lies_before(a->bounds.low, b->bounds.low);
  });
  std::vector<const PlacedObject*> kept;  // One of each.
  for (const PlacedObject* const placed : objects) {
    const PlacedObject* twin = nullptr;
    for (std::size_t i = kept.size(); i-- > 0 && twin == nullptr;) {
      if (placed->bounds.low.x() - kept[i]->bounds.low.x() > reach_m) break;
      if (!are_near(placed->bounds, kept[i]->bounds, reach_m)) continue;
      if (are_same(*placed->object, *kept[i]->object, reach_m)) twin = kept[i];
    }
    if (twin == nullptr) {
      kept.push_back(placed);
      continue;
    }
    const auto height = [](const PlacedObject* one) {
      return std::make_pair(one->object->order, one->object->id);
    };
    const PlacedObject* const lower = height(placed) < height(twin) ? placed : twin;
    const PlacedObject* const upper = lower == placed ? twin : placed;
    if (!is_asked_for(input, lower->bounds)) continue;
    Finding finding = finding_about(*lower, FindingKind::kDuplicate);
    finding.objects.push_back(upper->object->id);
    finding.has_area = is_closed(lower->object->kind);
    finding.size =
        finding.has_area ? covered_m2(*lower->object, 0.0) : length_m(lower->object->rings.front());
    finding.sentence =
        fmt::format("{} {} {} and {} are the same", class_info(lower->object->class_id).name,
                    enum_name(lower->object->kind), lower->object->id, upper->object->id);
    findings.push_back(std::move(finding));
  }
}

}  // namespace nadir
