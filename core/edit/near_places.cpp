// SPDX-License-Identifier: Apache-2.0
#include "core/edit/near_places.h"

#include <algorithm>
#include <utility>

#include "core/edit/edge_tree.h"

namespace nadir {
namespace {

std::vector<Eigen::Vector2d> each_once(std::vector<Eigen::Vector2d> places) {
  std::sort(places.begin(), places.end(), lies_before);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

std::vector<PlaneBounds> boxes_of(const std::vector<Eigen::Vector2d>& places) {
  std::vector<PlaneBounds> boxes;
  boxes.reserve(places.size());
  for (const Eigen::Vector2d& place : places) boxes.push_back(box_around(place, place));
  return boxes;
}

}  // namespace

NearPlaces::NearPlaces(std::vector<Eigen::Vector2d> places)
    : places_(each_once(std::move(places))), tree_(boxes_of(places_)), bounds_(tree_.bounds()) {
  bounds_.grow(kTouchM);
}

std::optional<Eigen::Vector2d> NearPlaces::nearest(const Eigen::Vector2d& place) const {
  std::optional<Eigen::Vector2d> found;
  double least = kTouchM;
  visit(box_around(place, place, kTouchM), [&](const Eigen::Vector2d& candidate) {
    const double distance = (candidate - place).norm();
    if (distance > least || (found && distance == least && lies_before(*found, candidate))) return;
    least = distance;
    found = candidate;
  });
  return found;
}

std::optional<Eigen::Vector2d> NearPlaces::first_near(const Eigen::Vector2d& place) const {
  std::optional<Eigen::Vector2d> found;
  visit(box_around(place, place, kTouchM), [&](const Eigen::Vector2d& candidate) {
    if ((candidate - place).norm() > kTouchM) return;
    if (!found || lies_before(candidate, *found)) found = candidate;
  });
  return found;
}

}  // namespace nadir
