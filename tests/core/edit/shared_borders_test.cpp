// SPDX-License-Identifier: Apache-2.0
// Tools on areas that fill a map without gap or overlap, against rasters: whatever is done, each cell stays in exactly one.
#include <gmock/gmock.h>

#include <numbers>

#include "core/edit/edit_objects.h"
#include "core/edit/edit_vertices.h"
#include "core/edit/polygon_algebra.h"
#include "tests/core/edit/edited_labels.h"

namespace nadir {
namespace shared_borders_test {

constexpr std::uint32_t kSeed = 411;
constexpr double kSideM = 40.0;

class Draws {
 public:
  explicit Draws(std::uint32_t scene) : scene_(scene) {}
  double between(double low, double high) {
    return low + (high - low) * uniforms({kSeed, 0, scene_, 0, number_++})[0];
  }
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(between(0.0, static_cast<double>(count))));
  }
  Eigen::Vector2d place() { return {between(0.0, kSideM), -between(0.0, kSideM)}; }

 private:
  std::uint32_t scene_, number_ = 0;
};

std::vector<ObjectId> all_ids(const LabelDocument& document) {
  std::vector<ObjectId> ids;
  for (const auto& [id, placed] : document.objects()) ids.push_back(id);
  return ids;
}

/// A square cut by lines with corners, and a pond in it.
LabelDocument parcels(Draws& draws) {
  LabelDocument document(test_plane(), test_grid(160, 160, 0.25));
  document.apply(adding({area(kTerrain, {box(0, 0, kSideM, kSideM)}, 1)}));
  for (int i = 0; i < 5; ++i) {
    Ring line{
        {draws.between(0.0, kSideM), 2.0}, draws.place(), {draws.between(0.0, kSideM), -42.0}};
    if (i % 2 == 0) {
      for (Eigen::Vector2d& place : line) place = Eigen::Vector2d(-place.y(), -place.x());
    }
    if (const auto cut = split(document, all_ids(document), line)) document = edited(document, cut);
  }
  return document;
}

VertexRef some_vertex(const LabelDocument& document, Draws& draws) {
  auto found = document.objects().begin();
  std::advance(found, static_cast<std::ptrdiff_t>(draws.below(document.objects().size())));
  const LabelObject& object = *found->second.object;
  const std::size_t ring = draws.below(object.rings.size());
  return {object.id, ring, draws.below(object.rings[ring].size())};
}

bool is_on_rim(const Eigen::Vector2d& place) {
  return place.x() == 0.0 || place.x() == kSideM || place.y() == 0.0 || place.y() == -kSideM;
}

/// Something that somebody might do next, without touching the rim of the map; refused ones change nothing.
Result<LabelEdit> next_edit(const LabelDocument& document, Draws& draws) {
  const VertexRef vertex = some_vertex(document, draws);
  const Ring& ring = object_in(document, vertex.object).rings[vertex.ring];
  const Eigen::Vector2d at = ring[vertex.place];
  const Eigen::Vector2d next = ring[(vertex.place + 1) % ring.size()];
  const std::vector<ObjectId> one{vertex.object};
  const Eigen::Vector2d by(draws.between(-2.0, 2.0), draws.between(-2.0, 2.0));
  switch (draws.below(7)) {
    case 0:
      if (is_on_rim(at)) break;
      return move_vertex(document, vertex, at + by, SharedBorders::kTogether);
    case 1: {
      std::vector<VertexRef> inner;
      for (int i = 0; i < 4; ++i) {
        const VertexRef other = some_vertex(document, draws);
        if (!is_on_rim(object_in(document, other.object).rings[other.ring][other.place]))
          inner.push_back(other);
      }
      return move_vertices(document, inner, by, SharedBorders::kTogether);
    }
    case 2:
      if (is_on_rim(at) || is_on_rim(next)) break;
      return add_vertex(document, vertex, (at + next) / 2.0 + 0.2 * by, SharedBorders::kTogether);
    case 3: {
      Ring line{draws.place(), draws.place(), draws.place()};
      return split(document, all_ids(document), line);
    }
    case 4: {
      std::vector<ObjectId> both = one;
      both.push_back(some_vertex(document, draws).object);
      return merge(document, both);
    }
    case 5:
      if (draws.between(0.0, 1.0) < 0.5) break;
      return simplify(document, one, 0.3);
    case 6:
      // A hole is nobody's, so another area is cut into the neighbours.
      LabelEdit drawn = *draw(document, {ObjectKind::kArea, kTerrain, 0.0},
                              circle({at.x() / 2.0 + 10.0, at.y() / 2.0 - 10.0}, 3.0, 12));
      LabelDocument with = document;
      with.apply(drawn);
      const std::vector<ObjectId> circle_id{drawn.objects.back().after->id};
      const auto cut = clip(with, circle_id, ClipSide::kOthers);
      if (!cut) return forward_error(cut);
      with.apply(*cut);
      return difference(document, with, "Draw and clip");
  }
  return LabelEdit{};
}

/// Whether what was moved has turned an area over, which a tool allows and which lies over others then.
bool turns_over(const LabelEdit& edit) {
  const auto area = [](const Ring& ring) {
    double twice = 0.0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      twice += ring[j].x() * ring[i].y() - ring[i].x() * ring[j].y();
    return twice;
  };
  const bool is_moved = edit.title.starts_with("Move") || edit.title.starts_with("Add");
  return is_moved && std::any_of(edit.objects.begin(), edit.objects.end(), [&](const auto& change) {
           for (std::size_t i = 0; i < change.before->rings.size(); ++i) {
             if (area(change.before->rings[i]) * area(change.after->rings[i]) <= 0.0) return true;
           }
           return false;
         });
}

TEST(SharedBorders, EachCellStaysInExactlyOneAreaWhateverIsDone) {
  std::size_t done = 0;
  for (std::uint32_t scene = 0; scene < 12; ++scene) {
    Draws draws(scene);
    LabelDocument document = parcels(draws);
    for (int step = 0; step < 25; ++step) {
      const auto edit = next_edit(document, draws);
      if (!edit || edit->empty() || turns_over(*edit)) continue;
      ++done;
      document = edited(document, edit);
      const Raster<int> claimed = cells_claimed(document);
      const auto wrong = std::count_if(claimed.values().begin(), claimed.values().end(),
                                       [](int count) { return count != 1; });
      ASSERT_EQ(wrong, 0) << "scene " << scene << ", step " << step << ": " << edit->title;
      // A corner of one that lies on another's border is a corner of that too.
      for (const auto& [id, placed] : document.objects()) {
        EXPECT_TRUE(check_object(*placed.object));
      }
    }
  }
  EXPECT_GT(done, 80U);
}

}  // namespace shared_borders_test
}  // namespace nadir
