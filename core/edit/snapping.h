// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/base/angle.h"
#include "core/label/label_document.h"

namespace nadir {

class EdgeTree;

/// One place of an object.
struct VertexRef {
  ObjectId object = 0;
  std::size_t ring = 0, place = 0;
  friend auto operator<=>(const VertexRef&, const VertexRef&) = default;
};

enum class SnapKind {
  kVertex,
  kEdge,
  kAlong,   ///< On what continues the last leg.
  kSquare,  ///< On what stands square on it.
};
struct Snap {
  SnapKind kind = SnapKind::kVertex;
  Eigen::Vector2d in_enu_m = Eigen::Vector2d::Zero();  ///< On the lattice, or exactly a vertex.
  VertexRef at;  ///< The vertex, or that before the edge; of neither nothing.
};

/// Finds what is near a place, among 20,000 objects in some ten microseconds. Follows a document by its edits.
class SnapIndex {
 public:
  explicit SnapIndex(const LabelDocument& document);
  SnapIndex(SnapIndex&&) noexcept;
  SnapIndex& operator=(SnapIndex&&) noexcept;
  ~SnapIndex();

  /// O(places of the objects that change).
  void apply(const LabelEdit& edit);

  /// The nearest vertex within the reach, else the nearest edge; nothing where there is neither. Of equally near ones the
  /// first by object, ring and place. @param without  Objects that are passed over: what is being moved.
  [[nodiscard]] std::optional<Snap> nearest(const Eigen::Vector2d& point_in_enu_m,
                                            double reach_m,
                                            std::span<const ObjectId> without = {}) const;
  /// All vertices that lie there, within two micrometres: those that move together. In order.
  [[nodiscard]] std::vector<VertexRef> at(const Eigen::Vector2d& point_in_enu_m) const;
  /// All edges on which a place lies, within two micrometres, by the vertex before. In order.
  [[nodiscard]] std::vector<VertexRef> edges_at(const Eigen::Vector2d& point_in_enu_m) const;

 private:
  struct Entry;
  void add(const std::shared_ptr<const LabelObject>& object);
  void remove(ObjectId id);

  // Side by side, for a look at all bounds takes microseconds.
  std::vector<PlaneBounds> bounds_;
  std::vector<Entry> entries_;
  std::unordered_map<ObjectId, std::size_t> where_;
};

/// What continues the last leg, or stands square on it, if that is within reach: for drawing by eye.
[[nodiscard]] std::optional<Snap> snap_to_direction(const Ring& drawn,
                                                    const Eigen::Vector2d& point_in_enu_m,
                                                    double reach_m);

/// Where the next place goes when somebody has typed its distance from the last one, its direction, or both: as near to the
/// pointer as that lets it. @param yaw  Counter-clockwise from east.
[[nodiscard]] Eigen::Vector2d typed_place(const Eigen::Vector2d& last_in_enu_m,
                                          const Eigen::Vector2d& pointer_in_enu_m,
                                          std::optional<double> length_m,
                                          std::optional<Angle> yaw);

/// The way along a ring (or line) from one snapped place to another: the shorter, or the other. Places are copied bit by bit,
/// so that the border is shared. @param beside_m  To its left; not 0 gives a parallel.
/// @errors kInvalidOptions: both are not of one border, a line has no other way, the parallel falls apart.
[[nodiscard]] Result<Ring> traced(const LabelObject& object,
                                  const Snap& from,
                                  const Snap& to,
                                  bool takes_other_way,
                                  double beside_m);

}  // namespace nadir
