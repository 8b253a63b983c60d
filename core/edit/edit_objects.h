// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/label/label_document.h"

namespace nadir {

// Gestures that draw, join and cut objects. Each gives the edit of one step, which is empty where nothing changes; none changes
// anything itself. New places lie on the lattice of polygon_algebra.h; objects beside them get them too, so that common
// borders stay equal to the last bit. All fail with kInvalidOptions where an object is not there or of the wrong kind, where
// an area would cross itself or have no inside, and with the errors of check_object() of what would come out.

/// What a tool draws with.
struct DrawnWith {
  ObjectKind kind = ObjectKind::kArea;
  ClassId class_id = kUnclassified;
  double width_m = 0.0;  ///< Of a line, thickness of an outline; 0 of an area.
};
[[nodiscard]] Result<LabelEdit> draw(const LabelDocument& document,
                                     const DrawnWith& with,
                                     Ring places);
/// By its first edge and how far it reaches to the left of it.
[[nodiscard]] Ring rectangle(const Eigen::Vector2d& from,
                             const Eigen::Vector2d& to,
                             double to_the_left_m);
/// On the circle, the first place east of its centre.
[[nodiscard]] Ring circle(const Eigen::Vector2d& centre_in_enu_m, double radius_m, int places = 64);

/// @errors also where the hole reaches out of the area, or into another hole.
[[nodiscard]] Result<LabelEdit> cut_hole(const LabelDocument& document, ObjectId object, Ring hole);
/// Cuts areas, outlines and lines along a line. The parts inherit everything; the largest, of a line the first, keeps the
/// number. @errors also where the line cuts none of them.
[[nodiscard]] Result<LabelEdit> split(const LabelDocument& document,
                                      std::span<const ObjectId> objects,
                                      const Ring& line);
/// Areas, outlines, or lines end to end, into the one with the first of the given numbers, which stays what it is.
/// @errors also where they do not touch each other, or are not all of one kind.
[[nodiscard]] Result<LabelEdit> merge(const LabelDocument& document,
                                      std::span<const ObjectId> objects);
/// Takes from an object what others cover, as region_of() has it: of an outline its inside too, which it draws unclassified
/// over what lies below. One that is covered whole is deleted, one that is cut in two becomes two.
[[nodiscard]] Result<LabelEdit> subtract(const LabelDocument& document,
                                         ObjectId from,
                                         std::span<const ObjectId> cuts);
enum class ClipSide {
  kThis,    ///< Takes from the object what areas and outlines of its level and above cover.
  kOthers,  ///< Takes from areas and outlines of its level and below what the object covers.
};
/// One after the other, each against what those before it have left, as one step. What covers is told as by subtract(); an
/// outline that is cut has its wall along the cut. @errors also where one of them is a line.
[[nodiscard]] Result<LabelEdit> clip(const LabelDocument& document,
                                     std::span<const ObjectId> objects,
                                     ClipSide side);
/// A copy beside it: of a line to its left, of an area around it; negative: to its right, or inside.
[[nodiscard]] Result<LabelEdit> copy_beside(const LabelDocument& document,
                                            ObjectId object,
                                            double by_m);

[[nodiscard]] Result<LabelEdit> remove(const LabelDocument& document,
                                       std::span<const ObjectId> objects);
/// They come to lie on top of the level of their new class, in the order that they have.
[[nodiscard]] Result<LabelEdit> reclass(const LabelDocument& document,
                                        std::span<const ObjectId> objects,
                                        ClassId to);
/// Width of lines, thickness of outlines.
[[nodiscard]] Result<LabelEdit> set_width(const LabelDocument& document,
                                          std::span<const ObjectId> objects,
                                          double width_m);
/// Class A to class B of objects and paint, everywhere or within a ring. There areas and lines are cut at the ring; an outline,
/// which would get walls there, is recoded whole where most of it lies within.
[[nodiscard]] Result<LabelEdit> recode(const LabelDocument& document,
                                       ClassId from,
                                       ClassId to,
                                       const std::optional<Ring>& within);
/// What is moved keeps the order that it has among itself.
enum class OrderMove {
  kUp,    ///< Above the next object that its bounds meet.
  kDown,  ///< Below the next one.
  kTop,
  kBottom,
};
[[nodiscard]] Result<LabelEdit> reorder(const LabelDocument& document,
                                        std::span<const ObjectId> objects,
                                        OrderMove move);

/// GeoJSON in enu, for the clipboard.
[[nodiscard]] Result<std::string> objects_text(const LabelDocument& document,
                                               std::span<const ObjectId> objects);
/// The objects of such a text with new numbers, on top of their levels, moved by so much. @errors also kMalformed: the text is
/// none of objects_text().
[[nodiscard]] Result<LabelEdit> paste(const LabelDocument& document,
                                      std::string_view text,
                                      const Eigen::Vector2d& by_m);
[[nodiscard]] Result<LabelEdit> duplicate(const LabelDocument& document,
                                          std::span<const ObjectId> objects,
                                          const Eigen::Vector2d& by_m);

}  // namespace nadir
