// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/edit/polygon_algebra.h"
#include "core/quality/check_parts.h"

namespace nadir {
namespace {

/// Nearer ends are one.
constexpr double kOnePlaceM = 2.0 * kLatticeM;
/// Lines that run beside each other end beside each other; cosine between their directions.
constexpr double kMostAlike = 0.7;
/// A line that is not much longer than the distance between its ends was not meant to be closed; a contour that lacks one wall
/// of four is three times as long.
constexpr double kLeastAround = 4.0;
constexpr double kLeastContour = 2.0;

struct LineEnd {
  const LabelObject* object = nullptr;
  bool is_first = false;
  Eigen::Vector2d place, outward;  ///< Where the line would go on, a unit vector.
  bool is_joined = false;          ///< Another end of its class lies there too.
};

LineEnd end_of(const LabelObject& line, bool is_first) {
  const Ring& places = line.rings.front();
  const Eigen::Vector2d place = is_first ? places.front() : places.back();
  Eigen::Vector2d outward = Eigen::Vector2d::Zero();
  for (std::size_t i = 1; i < places.size() && outward.isZero(0.0); ++i) {
    outward = place - (is_first ? places[i] : places[places.size() - 1 - i]);
  }
  return {&line, is_first, place, outward.normalized(), false};
}

bool is_closed_line(const LabelObject& line) {
  const Ring& places = line.rings.front();
  return (places.front() - places.back()).norm() <= kOnePlaceM;
}

/// Ends of lines of one class, to be found by place.
class EndsByX {
 public:
  explicit EndsByX(std::vector<LineEnd> ends) : ends_(std::move(ends)) {
    std::sort(ends_.begin(), ends_.end(), [](const LineEnd& a, const LineEnd& b) {
      if (a.place != b.place) return lies_before(a.place, b.place);
      return std::make_pair(a.object->id, a.is_first) < std::make_pair(b.object->id, b.is_first);
    });
    for (LineEnd& end : ends_) {
      visit(end.place, kOnePlaceM,
            [&](const LineEnd& other) { end.is_joined = end.is_joined || &other != &end; });
    }
  }
  [[nodiscard]] const std::vector<LineEnd>& ends() const { return ends_; }
  /// Calls `visit(end)` for all within reach.
  template <typename Visit>
  void visit(const Eigen::Vector2d& place, double reach_m, const Visit& visit) const {
    const auto is_left = [](const LineEnd& end, double x) { return end.place.x() < x; };
    for (auto at = std::lower_bound(ends_.begin(), ends_.end(), place.x() - reach_m, is_left);
         at != ends_.end() && at->place.x() <= place.x() + reach_m; ++at) {
      if ((at->place - place).norm() <= reach_m) visit(*at);
    }
  }

 private:
  std::vector<LineEnd> ends_;
};

Finding finding_between(const LabelObject& line,
                        const Eigen::Vector2d& from,
                        const Eigen::Vector2d& to) {
  Finding finding;
  finding.kind = FindingKind::kOpenOutline;
  finding.severity = FindingSeverity::kDoubt;
  finding.class_id = line.class_id;
  finding.objects = {line.id};
  finding.bounds = box_around(from, to);
  finding.place_in_enu_m = from;
  finding.size = (from - to).norm();
  return finding;
}

/// Whether its own ends nearly meet, which is then told.
bool find_open_line(const CheckInput& input,
                    const LabelObject& line,
                    const EndsByX& ends,
                    std::vector<Finding>& findings) {
  const Ring& places = line.rings.front();
  Finding finding = finding_between(line, places.back(), places.front());
  const double reach_m = input.settings.end_gap_m;
  const double length = length_m(places);
  const bool nearly_meets = places.size() >= 3 && finding.size <= reach_m &&
                            length >= kLeastAround * std::max(reach_m, finding.size);
  if (!nearly_meets) {
    const bool is_contour =
        line.class_id == kBuilding && places.size() >= 3 && length >= kLeastContour * finding.size;
    bool goes_on = false;
    for (const Eigen::Vector2d& place : {places.front(), places.back()}) {
      ends.visit(place, reach_m,
                 [&](const LineEnd& end) { goes_on = goes_on || end.object != &line; });
    }
    if (!is_contour || goes_on) return false;
    finding.why_not_fix = "what is missing of it is seen in the image only";
  }
  finding.sentence = fmt::format("{} is open by {} m", named(line), size_text(finding.size));
  if (is_asked_for(input, finding.bounds)) findings.push_back(std::move(finding));
  return true;
}

/// The nearest end of another line that goes on where this one ends; null where there is none.
const LineEnd* continuation_of(const LineEnd& end, const EndsByX& ends, double reach_m) {
  const LineEnd* nearest = nullptr;
  double least = reach_m;
  ends.visit(end.place, reach_m, [&](const LineEnd& other) {
    const double distance = (other.place - end.place).norm();
    if (other.object == end.object || distance <= kOnePlaceM || distance > least) return;
    if (nearest != nullptr && distance == least) return;
    if (other.outward.dot(end.outward) >= kMostAlike) return;
    least = distance;
    nearest = &other;
  });
  return nearest;
}

void find_ends_apart(const CheckInput& input, const EndsByX& ends, std::vector<Finding>& findings) {
  std::set<std::pair<const LineEnd*, const LineEnd*>> told;
  for (const LineEnd& end : ends.ends()) {
    if (end.is_joined) continue;
    const LineEnd* const other = continuation_of(end, ends, input.settings.end_gap_m);
    if (other == nullptr || !told.insert(std::minmax(&end, other)).second) continue;
    Finding finding = finding_between(*end.object, end.place, other->place);
    finding.objects.push_back(other->object->id);
    finding.sentence =
        fmt::format("ends of {} lines {} and {} are {} m apart", class_info(finding.class_id).name,
                    end.object->id, other->object->id, size_text(finding.size));
    if (is_asked_for(input, finding.bounds)) findings.push_back(std::move(finding));
  }
}

}  // namespace

void check_ends(const CheckInput& input, std::vector<Finding>& findings) {
  std::map<ClassId, std::vector<const LabelObject*>> lines;
  for (const auto& [id, placed] : input.document.objects()) {
    const LabelObject& object = *placed.object;
    if (object.kind != ObjectKind::kLine || is_closed_line(object)) continue;
    // What ends here may nearly meet what ends there, and both may have ends further on that are nearer.
    PlaneBounds bounds = placed.bounds;
    bounds.grow(2.0 * input.settings.end_gap_m);
    if (is_asked_for(input, bounds)) lines[object.class_id].push_back(&object);
  }
  for (const auto& [id, of_class] : lines) {
    std::vector<LineEnd> all;
    all.reserve(2 * of_class.size());
    for (const LabelObject* const line : of_class) {
      all.push_back(end_of(*line, true));
      all.push_back(end_of(*line, false));
    }
    const EndsByX every_end(all);
    std::set<const LabelObject*> open;
    for (const LabelObject* const line : of_class) {
      if (find_open_line(input, *line, every_end, findings)) open.insert(line);
    }
    std::erase_if(all, [&](const LineEnd& end) { return open.count(end.object) > 0; });
    find_ends_apart(input, EndsByX(std::move(all)), findings);
  }
}

}  // namespace nadir
