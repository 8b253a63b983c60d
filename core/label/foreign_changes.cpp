// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/label/label_blobs.h"
#include "core/label/label_tables.h"
#include "core/label/row_walk.h"

namespace nadir {
namespace {

/// Reads the tables of objects and compares them with a document.
class ForeignFinder {
 public:
  ForeignFinder(const SqliteDatabase& database,
                const LabelDocument& document,
                bool is_document_whole)
      : database_(database),
        document_(document),
        is_document_whole_(is_document_whole),
        next_id_(document.next_id()) {}

  Result<ForeignChanges> find() {
    constexpr std::array<const char*, 3> kColumns{"geom, class, drawing_order, note, 0.0",
                                                  "geom, class, drawing_order, note, width_m",
                                                  "geom, class, drawing_order, note, thickness_m"};
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      const auto kind = static_cast<ObjectKind>(i);
      const auto is_whole = visit_rows(database_, std::string(enum_name(kind)), kColumns.at(i),
                                       [&](const SqliteStatement& row) { take(row, kind); });
      if (!is_whole) return forward_error(is_whole);
      found_.is_whole = found_.is_whole && *is_whole;
    }
    for (const auto& [id, placed] : document_.objects()) {
      if (found_.is_whole && seen_.count(id) == 0) {
        found_.edit.objects.push_back({placed.object, nullptr});
      }
    }
    for (LabelObject& object : later_) {
      object.id = next_id_++;
      add(nullptr, object);
    }
    return std::move(found_);
  }

 private:
  void take(const SqliteStatement& row, ObjectKind kind) {
    const ObjectId id = row.whole(0);
    const auto known = document_.object(id);
    const bool is_ours = known != nullptr && known->kind == kind;
    if (is_ours) seen_.insert(id);
    auto objects = objects_of(row, kind, is_ours ? known.get() : nullptr);
    if (!objects) {
      found_.notices.push_back(fmt::format("{} {}: {}{}", enum_name(kind), id,
                                           objects.error().message,
                                           is_ours ? ", so it stays as it was" : ""));
      return;
    }
    // A row under a number that was given already is no longer one once its object has another number.
    const bool was_given = is_document_whole_ ? id < document_.next_id() : known != nullptr;
    const bool is_stray = !is_ours && (was_given || taken_.count(id) > 0);
    if (is_stray) found_.strays.emplace_back(kind, id);
    const auto first_later = objects->begin() + (is_stray ? 0 : 1);
    later_.insert(later_.end(), first_later, objects->end());
    if (is_stray) return;
    taken_.insert(id);
    next_id_ = std::max(next_id_, id + 1);
    if (is_ours && objects->front() == *known) return;
    add(is_ours ? known : nullptr, objects->front());
  }

  void add(std::shared_ptr<const LabelObject> before, const LabelObject& after) {
    found_.edit.objects.push_back({std::move(before), std::make_shared<const LabelObject>(after)});
  }

  /// The first has the row's number; further parts of what a GIS has joined have none yet.
  Result<std::vector<LabelObject>> objects_of(const SqliteStatement& row,
                                              ObjectKind kind,
                                              const LabelObject* known) const {
    LabelObject object;
    object.id = row.whole(0);
    object.kind = kind;
    const auto class_id = class_of(row.text(2));
    if (!class_id) return fail(ErrorCode::kMalformed, "\"{}\" is no class", row.text(2));
    object.class_id = *class_id;
    object.order = !row.is_null(3) ? row.whole(3)
                   : known != nullptr && known->class_id == *class_id
                       ? known->order
                       : document_.next_order(*class_id);
    object.note = row.text(4);
    object.width_m = row.is_null(5) ? 0.0 : row.number(5);
    auto parts = parts_of_geometry(row.blob(1));
    if (!parts) return forward_error(parts);
    if (parts->empty()) return fail(ErrorCode::kMalformed, "it has no places");
    std::vector<LabelObject> objects;
    for (GeometryPart& part : *parts) {
      if (part.is_polygon == (kind == ObjectKind::kLine)) {
        return fail(ErrorCode::kMalformed, "its geometry is of another kind");
      }
      object.rings = std::move(part.rings);
      if (const auto sound = check_object(object); !sound) {
        const std::string& message =
            sound.error().message;  // After kind and number, which the caller says.
        return fail(ErrorCode::kMalformed, "{}", message.substr(message.find(": ") + 2));
      }
      objects.push_back(object);
    }
    return objects;
  }

  static std::optional<ClassId> class_of(const std::string& name) {
    if (plain_class_name(name) == plain_class_name(class_info(kUnclassified).name)) {
      return ClassId{kUnclassified};
    }
    return class_from_name(name);
  }

  const SqliteDatabase& database_;
  const LabelDocument& document_;
  bool is_document_whole_;
  ObjectId next_id_;
  std::set<ObjectId> seen_;         ///< Of the document, that have a row.
  std::set<ObjectId> taken_;        ///< That rows keep.
  std::vector<LabelObject> later_;  ///< Get their numbers when all rows have kept theirs.
  ForeignChanges found_;
};

}  // namespace

Result<ForeignChanges> find_foreign_changes(const SqliteDatabase& database,
                                            const LabelDocument& document,
                                            bool is_document_whole) {
  auto found = ForeignFinder(database, document, is_document_whole).find();
  if (!found) return forward_error(found);
  found->edit.title = "Take over changes of another program";
  return found;
}

}  // namespace nadir
