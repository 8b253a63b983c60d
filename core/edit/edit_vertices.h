// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/base/angle.h"
#include "core/edit/snapping.h"

namespace nadir {

// Gestures on the places of objects. Each gives the edit of one step, which is empty where nothing changes; none changes
// anything itself. New places lie on the lattice of polygon_algebra.h. Borders are shared where their places are equal to the
// last bit; what is shared stays so. Places within two micrometres of each other, as other programs' rounding leaves them, are
// taken for shared by whatever moves, adds or removes vertices, and those that move are equal afterwards. All fail with kInvalidOptions where an object or a place is not there, or where an area
// would cross itself or lose its inside, and with the errors of check_object() of what would come out.

/// Whether what shares a border moves with it.
enum class SharedBorders { kTogether, kAlone };

[[nodiscard]] Result<LabelEdit> move_vertex(const LabelDocument& document,
                                            const VertexRef& vertex,
                                            const Eigen::Vector2d& to_in_enu_m,
                                            SharedBorders shared);
/// Several at once, all by the same shift, as one step: one that is shared with another, or given twice, moves once.
[[nodiscard]] Result<LabelEdit> move_vertices(const LabelDocument& document,
                                              std::span<const VertexRef> vertices,
                                              const Eigen::Vector2d& by_m,
                                              SharedBorders shared);
/// @param before  The place after which it comes.
[[nodiscard]] Result<LabelEdit> add_vertex(const LabelDocument& document,
                                           const VertexRef& before,
                                           const Eigen::Vector2d& at_in_enu_m,
                                           SharedBorders shared);
/// A hole that is left with two places goes, and so does an object whose border is.
[[nodiscard]] Result<LabelEdit> remove_vertices(const LabelDocument& document,
                                                std::span<const VertexRef> vertices,
                                                SharedBorders shared);
[[nodiscard]] Result<LabelEdit> move_objects(const LabelDocument& document,
                                             std::span<const ObjectId> objects,
                                             const Eigen::Vector2d& by_m);

/// Corners become two places, a quarter of each side away (Chaikin). Ends of lines stay, and places where borders part; what
/// shares a border becomes smooth with it.
[[nodiscard]] Result<LabelEdit> smooth(const LabelDocument& document,
                                       std::span<const ObjectId> objects);
/// Leaves out places, so that none lies farther than the tolerance from the border that remains (Douglas-Peucker). Shared
/// borders lose the same places everywhere, and keep those where they part. What would cross itself loses fewer.
[[nodiscard]] Result<LabelEdit> simplify(const LabelDocument& document,
                                         std::span<const ObjectId> objects,
                                         double tolerance_m);
/// Edges within the tolerance of two directions at right angles get them exactly: those that most of the length of what
/// hangs together has already. Places move as little as they can (least squares), and their middle stays.
/// @param tolerance  At most 45 degrees.
[[nodiscard]] Result<LabelEdit> orthogonalise(const LabelDocument& document,
                                              std::span<const ObjectId> objects,
                                              Angle tolerance);
/// Places of different objects within reach of each other become one, and edges get the places of others that lie on them
/// within reach: so borders of other programs' objects are shared. What is too small for that stays as it is.
[[nodiscard]] Result<LabelEdit> join_borders(const LabelDocument& document,
                                             std::span<const ObjectId> objects,
                                             double reach_m);

}  // namespace nadir
