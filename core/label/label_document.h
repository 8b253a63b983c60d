// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geo/project_plane.h"
#include "core/label/label_edit.h"
#include "core/label/label_grid.h"

namespace nadir {

/// An object with what is asked of it most often.
struct PlacedObject {
  std::shared_ptr<const LabelObject> object;  ///< Never null.
  PlaneBounds bounds;                         ///< drawn_bounds() of it.
};

/// Labels of an overhead as they were drawn: objects on a project plane, and paint on cells. A raster is made of it by
/// rasterise(). A copy shares all objects and tiles, which never change, so that a thread may keep one.
class LabelDocument {
 public:
  /// @param grid  Cells of the paint, and of the label raster unless another is asked for. Its resolution is > 0.
  LabelDocument(const ProjectPlane& plane, const LabelGrid& grid) : plane_(plane), grid_(grid) {}

  [[nodiscard]] const ProjectPlane& plane() const { return plane_; }
  [[nodiscard]] const LabelGrid& grid() const { return grid_; }
  [[nodiscard]] const std::map<ObjectId, PlacedObject>& objects() const { return objects_; }
  [[nodiscard]] const std::map<PaintAddress, std::shared_ptr<const PaintTile>>& paint() const {
    return paint_;
  }
  [[nodiscard]] const std::map<std::string, std::shared_ptr<const std::string>>& values() const {
    return values_;
  }
  /// Null where there is none.
  [[nodiscard]] std::shared_ptr<const LabelObject> object(ObjectId id) const;
  [[nodiscard]] std::shared_ptr<const PaintTile> tile(const PaintAddress& address) const;
  [[nodiscard]] std::shared_ptr<const std::string> value(const std::string& key) const;
  /// What a cell of the document's grid was painted with, inside or outside of it.
  [[nodiscard]] PaintValue paint_at(std::int64_t column, std::int64_t row) const;

  /// That no object has, nor ever had.
  [[nodiscard]] ObjectId next_id() const { return next_id_; }
  /// Above all objects in the level of a class.
  [[nodiscard]] std::int64_t next_order(ClassId id) const;

  /// Whether an edit fits: all that it changes is now what it says was before, and what it makes is sound.
  /// @errors kInvalidOptions: it was made of another state; those of check_object().
  [[nodiscard]] Result<void> check(const LabelEdit& edit) const;
  /// @param edit  That fits.
  void apply(const LabelEdit& edit);
  /// For ids that are in the history only. @param id  The lowest that may be given.
  void reserve_ids(ObjectId id);

  /// The same plane, grid, objects, paint and values; which ids were ever given does not count.
  friend bool operator==(const LabelDocument& a, const LabelDocument& b);

 private:
  ProjectPlane plane_;
  LabelGrid grid_;
  std::map<ObjectId, PlacedObject> objects_;
  std::map<PaintAddress, std::shared_ptr<const PaintTile>> paint_;
  std::map<std::string, std::shared_ptr<const std::string>> values_;
  ObjectId next_id_ = 1;
};

/// What makes `to` of `from`; both on the same plane and grid. O(all).
[[nodiscard]] LabelEdit difference(const LabelDocument& from,
                                   const LabelDocument& to,
                                   std::string title);

}  // namespace nadir
