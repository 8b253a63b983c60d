// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <utility>

#include "core/exchange/osm_elements.h"
#include "core/exchange/ring_assembly.h"
#include "core/exchange/source_features.h"

namespace nadir {
namespace {

/// A ring whose ends are nearer than this was meant to be closed.
constexpr double kClosingGapM = 1.0;

double metres_between(const Eigen::Vector2d& a_deg, const Eigen::Vector2d& b_deg) {
  constexpr double kMetresPerDegree = 111'320.0;
  constexpr double kRadians = 0.017453292519943295;
  const Eigen::Vector2d apart = (b_deg - a_deg) * kMetresPerDegree;
  return std::hypot(apart.x() * std::cos(a_deg.y() * kRadians), apart.y());
}

/// Makes features of elements.
class OsmFeatures {
 public:
  OsmFeatures(const OsmElements& elements, const WorkContext& context)
      : elements_(elements), context_(context) {
    for (std::size_t i = 0; i < elements.ways.size(); ++i) way_of_[elements.ways[i].id] = i;
  }

  /// @errors kCancelled.
  Result<SourceFeatures> make() {
    made_.layers.emplace_back();
    made_.kind = SourceKind::kOpenStreetMap;
    made_.bounds_deg = elements_.bounds_deg;
    made_.faults.add("element has no number or no place on the Earth and was left out",
                     "elements have no number or no place on the Earth and were left out",
                     elements_.unsound);
    for (const OsmRelation& relation : elements_.relations) {
      if (const auto goes_on = look_up(); !goes_on) return forward_error(goes_on);
      const auto type = relation.tags.find("type");
      if (type == relation.tags.end()) continue;
      if (type->second == "multipolygon") {
        const auto added = add_multipolygon(relation);
        if (!added) return forward_error(added);
      }
      if (type->second == "lanelet") add_lanelet(relation);
    }
    for (const OsmWay& way : elements_.ways) {
      if (const auto goes_on = look_up(); !goes_on) return forward_error(goes_on);
      if (!way.tags.empty() && told_by_relation_.count(way.id) == 0) add_way(way);
    }
    for (const auto& [id, tags] : elements_.tagged_nodes) {
      if (const auto goes_on = look_up(); !goes_on) return forward_error(goes_on);
      add({fmt::format("node {}", id), tags, SourceForm::kPlace, {{elements_.nodes.at(id)}}});
    }
    made_.faults.add("way misses nodes and was taken without them",
                     "ways miss nodes and were taken without them", missing_nodes_.size());
    return std::move(made_);
  }

 private:
  struct Line {
    Ring places;
    bool is_closed = false;  ///< Then its first place is not repeated.
  };

  /// Before each element: whether to go on, and how far this is.
  Result<void> look_up() {
    if (done_++ % 256 != 0) return {};
    if (context_.is_stopped()) return fail(ErrorCode::kCancelled, "cancelled");
    const std::size_t all =
        1 + elements_.relations.size() + elements_.ways.size() + elements_.tagged_nodes.size();
    context_.report(static_cast<double>(done_) / static_cast<double>(all), "joining");
    return {};
  }

  void add(SourceFeature feature) { made_.layers.front().features.push_back(std::move(feature)); }

  /// Without what is missing, which is noted.
  Ring places_of(const NodeChain& nodes, std::int64_t way) {
    Ring places;
    for (const std::int64_t id : nodes) {
      const auto found = elements_.nodes.find(id);
      if (found == elements_.nodes.end()) {
        missing_nodes_.insert(way);
      } else if (places.empty() || places.back() != found->second) {
        places.push_back(found->second);
      }
    }
    return places;
  }

  /// Of a way that is part of something larger.
  NodeChain known_nodes(const OsmWay& way) {
    NodeChain known;
    for (const std::int64_t id : way.nodes) {
      if (elements_.nodes.count(id) > 0) known.push_back(id);
    }
    if (known.size() < way.nodes.size()) missing_nodes_.insert(way.id);
    return known;
  }

  static Line closed_if_meant(Ring places) {
    Line line{std::move(places), false};
    if (line.places.size() < 4) return line;
    const double gap_m = metres_between(line.places.front(), line.places.back());
    line.is_closed = gap_m < kClosingGapM;
    if (line.places.front() == line.places.back()) line.places.pop_back();
    return line;
  }

  void add_way(const OsmWay& way) {
    const Line line = closed_if_meant(places_of(way.nodes, way.id));
    if (line.places.size() < 2) {
      made_.faults.add("way has fewer than two places and was left out",
                       "ways have fewer than two places and were left out");
      return;
    }
    add({fmt::format("way {}", way.id),
         way.tags,
         line.is_closed ? SourceForm::kClosedLine : SourceForm::kOpenLine,
         {line.places}});
  }

  /// Of those members of a relation that are there. @param role  Empty: any.
  std::vector<const OsmWay*> ways_of(const OsmRelation& relation,
                                     std::string_view role,
                                     bool& lacks_one) const {
    std::vector<const OsmWay*> ways;
    for (const OsmMember& member : relation.members) {
      if (member.type != OsmMember::Type::kWay || (!role.empty() && member.role != role)) continue;
      const auto found = way_of_.find(member.id);
      if (found == way_of_.end()) {
        lacks_one = true;
      } else {
        ways.push_back(&elements_.ways[found->second]);
      }
    }
    return ways;
  }

  Result<void> add_multipolygon(const OsmRelation& relation) {
    bool lacks_one = false;
    const std::vector<const OsmWay*> ways = ways_of(relation, "", lacks_one);
    std::vector<NodeChain> chains;
    chains.reserve(ways.size());
    for (const OsmWay* way : ways) chains.push_back(known_nodes(*way));
    std::vector<Ring> rings;
    std::size_t open = 0;
    for (const NodeChain& chain : join_ways(std::move(chains))) {
      Line line = closed_if_meant(places_of(chain, relation.id));
      if (line.is_closed)
        rings.push_back(std::move(line.places));
      else
        ++open;
    }
    if (open > 0 || lacks_one) {
      made_.faults.add("multipolygon has open rings or lacks members and was taken without them",
                       "multipolygons have open rings or lack members and were taken without them");
    }
    if (rings.empty()) return {};
    const ImportTags tags = tags_of_multipolygon(relation, ways);
    auto areas = areas_of(std::move(rings), context_);
    if (!areas) return forward_error(areas);
    for (std::vector<Ring>& area : *areas) {
      add({fmt::format("relation {}", relation.id), tags, SourceForm::kArea, std::move(area)});
    }
    return {};
  }

  /// Those of its outer ways where it has none of its own, as was usual once. Ways that say nothing else are told by it.
  ImportTags tags_of_multipolygon(const OsmRelation& relation,
                                  const std::vector<const OsmWay*>& ways) {
    ImportTags tags = relation.tags;
    tags.erase("type");
    const bool has_own = std::any_of(tags.begin(), tags.end(), [](const auto& tag) {
      return tag.first != "name" && tag.first != "source" && tag.first != "note";
    });
    if (!has_own) {
      std::set<std::int64_t> inner;
      for (const OsmMember& member : relation.members) {
        if (member.role == "inner") inner.insert(member.id);
      }
      for (const OsmWay* way : ways) {
        if (inner.count(way->id) == 0) tags.insert(way->tags.begin(), way->tags.end());
      }
    }
    for (const OsmWay* way : ways) {
      const bool is_told = !way->tags.empty() &&
                           std::all_of(way->tags.begin(), way->tags.end(), [&](const auto& tag) {
                             const auto found = tags.find(tag.first);
                             return found != tags.end() && found->second == tag.second;
                           });
      if (is_told) told_by_relation_.insert(way->id);
    }
    tags.insert(relation.tags.begin(), relation.tags.end());
    return tags;
  }

  /// The ways of one bound in a row. Empty where there are none.
  Ring bound_of(const OsmRelation& relation, std::string_view role) {
    bool lacks_one = false;
    std::vector<NodeChain> chains;
    for (const OsmWay* way : ways_of(relation, role, lacks_one))
      chains.push_back(known_nodes(*way));
    chains = join_ways(std::move(chains));
    if (chains.size() != 1 || lacks_one) return {};
    return places_of(chains.front(), relation.id);
  }

  void add_lanelet(const OsmRelation& relation) {
    made_.kind = SourceKind::kLanelet2;
    Ring border = bound_of(relation, "left");
    Ring right = bound_of(relation, "right");
    if (border.size() < 2 || right.size() < 2) {
      made_.faults.add("lanelet lacks a bound and was left out",
                       "lanelets lack a bound and were left out");
      return;
    }
    // Around: along the left one and back along the right one, whichever way that was drawn.
    const double same_way_m =
        metres_between(border.front(), right.front()) + metres_between(border.back(), right.back());
    const double other_way_m =
        metres_between(border.front(), right.back()) + metres_between(border.back(), right.front());
    if (same_way_m <= other_way_m) std::reverse(right.begin(), right.end());
    for (const Eigen::Vector2d& place : right) {
      if (place != border.back()) border.push_back(place);
    }
    if (border.front() == border.back()) border.pop_back();
    if (border.size() < 3) return;
    add({fmt::format("lanelet {}", relation.id), relation.tags, SourceForm::kArea, {border}});
  }

  const OsmElements& elements_;
  const WorkContext& context_;
  std::size_t done_ = 0;
  std::unordered_map<std::int64_t, std::size_t> way_of_;
  std::set<std::int64_t> told_by_relation_;
  std::set<std::int64_t> missing_nodes_;  ///< Ways that miss some.
  SourceFeatures made_;
};

}  // namespace

Result<SourceFeatures> read_osm_features(const std::filesystem::path& path,
                                         const WorkContext& context) {
  const auto elements = read_osm_elements(path, context);
  if (!elements) return forward_error(elements);
  auto features = OsmFeatures(*elements, context).make();
  if (!features) return forward_error(features, path.string());
  return features;
}

Result<SourceFeatures> parse_osm_features(std::string_view text, const std::string& name) {
  const auto elements = parse_osm_elements(text, name);
  if (!elements) return forward_error(elements);
  const WorkContext alone;
  return OsmFeatures(*elements, alone).make();
}

}  // namespace nadir
