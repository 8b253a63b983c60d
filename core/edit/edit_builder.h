// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/edit/polygon_algebra.h"
#include "core/label/label_document.h"

namespace nadir {

/// Collects what becomes of a document's objects, as the edit of one gesture. Private to this module.
class EditBuilder {
 public:
  EditBuilder(const LabelDocument& document, std::string title)
      : document_(document), title_(std::move(title)), next_id_(document.next_id()) {}

  [[nodiscard]] const LabelDocument& document() const { return document_; }
  /// The object as it is now; null where there is none. Valid until the object changes.
  [[nodiscard]] const LabelObject* now(ObjectId id) const;
  /// To be changed. @param id  Of an object that there is.
  [[nodiscard]] LabelObject& change(ObjectId id);
  void remove(ObjectId id) { changed_[id] = std::nullopt; }
  /// With the next number, which is returned.
  ObjectId add(LabelObject object);
  /// Above all of a class's level, and above what was given before.
  [[nodiscard]] std::int64_t next_order(ClassId id);
  /// Puts pieces in place of an object: the first keeps its number, others inherit all else; none removes it.
  void replace(ObjectId id, std::vector<std::vector<Ring>> pieces);
  /// What replace() has made beside an object of the document and its pieces.
  [[nodiscard]] std::span<const ObjectId> cut_off(ObjectId id) const;

  /// Gives places that have become new to the objects beside them, wherever those have an edge or a place within two
  /// micrometres, so that borders which were common stay so, to the last bit.
  void share_new_places();
  /// What has changed; places that repeat the one before are left out, and holes that are left with two.
  /// @errors kInvalidOptions: an area that crosses itself, or more than before, or has no inside; those of check_object().
  [[nodiscard]] Result<LabelEdit> edit();

 private:
  [[nodiscard]] std::vector<Eigen::Vector2d> new_places() const;
  [[nodiscard]] Result<void> check(const LabelObject* before, const LabelObject& after) const;

  const LabelDocument& document_;
  std::string title_;
  ObjectId next_id_;
  std::map<ClassId, std::int64_t> orders_;
  std::map<ObjectId, std::optional<LabelObject>> changed_;  ///< Nothing: removed.
  std::map<ObjectId, ObjectId> whole_of_;                   ///< Of pieces.
  std::map<ObjectId, std::vector<ObjectId>> cut_off_;       ///< Of what was whole.
};

/// The objects of some numbers, each once, in their order. @errors kInvalidOptions: one is not there, or there are none.
[[nodiscard]] Result<std::vector<const LabelObject*>> selected_objects(
    const LabelDocument& document, std::span<const ObjectId> ids);
/// Takes a region from an object, of which its pieces remain. Whether it changes anything.
[[nodiscard]] Result<bool> take_from(EditBuilder& builder,
                                     const LabelObject& object,
                                     const Region& region);
/// "area 12".
[[nodiscard]] std::string object_name(const LabelObject& object);

}  // namespace nadir
