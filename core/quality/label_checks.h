// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/field.h"
#include "core/base/progress.h"
#include "core/label/label_document.h"

namespace nadir {

/// What may be wrong with labels, as a list of places to look at.

enum class FindingKind {
  kSelfCrossing,  ///< An area or outline whose rings cross.
  kDegenerate,    ///< An object without extent.
  kDuplicate,     ///< The same object twice.
  kFarOutside,    ///< An object that lies, or reaches, far out of the image.
  kOpenOutline,   ///< Ends of lines that nearly meet; a building's contour that is not closed.
  kOverlap,       ///< Areas of one level of which one hides a part of the other.
  kGap,           ///< A sliver of unlabelled ground between labels.
  kStrayCurb,     ///< A piece of curb that has no road on one side, or nothing else on the other.
  kUnlabelled,    ///< Unlabelled ground within the labelled extent.
  kIsland,        ///< A few cells of a class that covers ground.
};
template <>
struct EnumNames<FindingKind> {
  static constexpr std::array<std::string_view, 10> kNames = {
      "self-crossing", "degenerate", "duplicate",  "outside",    "open outline",
      "overlap",       "gap",        "stray curb", "unlabelled", "island"};
};

enum class FindingSeverity { kMistake, kDoubt, kHint };
template <>
struct EnumNames<FindingSeverity> {
  static constexpr std::array<std::string_view, 3> kNames = {"mistake", "doubt", "hint"};
};

struct Finding {
  FindingKind kind = FindingKind::kUnlabelled;
  FindingSeverity severity = FindingSeverity::kHint;
  ClassId class_id = kUnclassified;  ///< Of what was found; of a gap and unlabelled ground none.
  std::vector<ObjectId> objects;     ///< That it is about; of two the one that fix() changes first.
  PlaneBounds bounds;
  Eigen::Vector2d place_in_enu_m = Eigen::Vector2d::Zero();  ///< To look at: on it, not just near.
  double size =
      0.0;  ///< m2 where has_area, else m: of a gap its width, of what is open the distance.
  bool has_area = false;
  std::string sentence;     ///< "road island of 0.4 m2 in terrain", without full stop.
  std::string why_not_fix;  ///< Why fix() cannot mend it; empty where it can.
  friend bool operator==(const Finding& a, const Finding& b);
};

struct CheckSettings {
  double unlabelled_m2 = 1.0;
  double island_m2 = 0.5;
  double gap_width_m = 0.5;
  double gap_m2 = 0.1;
  double overlap_m2 = 0.5;
  double overlap_width_m = 0.2;
  double end_gap_m = 0.5;
  double curb_reach_m = 1.0;
  double curb_length_m = 2.0;
  double outside_m = 20.0;
  double degenerate_m = 0.01;
  double duplicate_m = 0.01;
};
template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, CheckSettings>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.unlabelled_m2,
        Field{"unlabelled-area", "m2", "Unlabelled ground is told from this size on", 0, 1e6});
  visit(options.island_m2,
        Field{"island-area", "m2", "Cells of one class that hang together are told below this size",
              0, 1e6});
  visit(
      options.gap_width_m,
      Field{"gap-width", "m", "Unlabelled ground up to this wide between labels is a gap", 0, 10});
  visit(options.gap_m2, Field{"gap-area", "m2", "Gaps are told from this size on", 0, 1e6});
  visit(options.overlap_m2,
        Field{"overlap-area", "m2", "Overlaps are told from this size on", 0, 1e6});
  visit(options.overlap_width_m,
        Field{"overlap-width", "m", "Overlaps narrower than this are borders drawn twice", 0, 100});
  visit(options.end_gap_m,
        Field{"end-gap", "m", "Ends of lines this near were meant to meet", 0, 10});
  visit(options.curb_reach_m,
        Field{"curb-reach", "m", "A curb this far from any road's border follows none", 0.01, 20});
  visit(options.curb_length_m,
        Field{"curb-length", "m", "Pieces of curb without a road are told from this length on", 0,
              1e4});
  visit(options.outside_m,
        Field{"outside", "m", "Objects may reach this far out of the image", 0, 1e6});
  visit(options.degenerate_m,
        Field{"degenerate", "m", "Lines shorter than this, and areas below its square, are nothing",
              0, 1});
  visit(options.duplicate_m,
        Field{"duplicate", "m", "Objects whose borders are nowhere farther apart are the same", 0,
              1});
}

/// Looks for everything in FindingKind, in objects and in the cells of the document's raster.
///
/// Cells are looked at strip by strip, so that memory grows with the width of the grid only. What lies within outlines, and what
/// somebody has made unclassified by an object or by paint, is not unlabelled. Gaps, islands, stray curbs and overlaps are seen
/// as the grid's cells have them: what is smaller than a cell is not. Same input, same findings on any number of threads.
/// @param grid    On the document's plane; mostly its own.
/// @param within  Only what touches this part of the plane: regions with a cell in it, objects whose bounds meet it. It is
///                found as a check of everything finds it, in milliseconds where what touches it is small.
/// @returns       Most severe first; equally severe ones from north to south, then west to east.
/// @errors kInvalidOptions: a setting out of its range; kCancelled.
[[nodiscard]] Result<std::vector<Finding>> check_labels(
    const LabelDocument& document,
    const LabelGrid& grid,
    const CheckSettings& settings = {},
    const std::optional<PlaneBounds>& within = std::nullopt,
    const WorkContext& work = {});

/// Mends a finding, where it is clear how: an island takes the class around it and a gap that of its longest neighbour (by
/// paint; a gap between areas whose borders can be joined without changing other cells is closed so), an open outline is
/// closed and ends that nearly meet are joined, of an overlap the lower area is clipped, what is degenerate goes, and so does the
/// lower of two that are the same; what crosses itself becomes the areas that it surrounds.
/// @param grid, settings  With which it was found.
/// @errors kInvalidOptions: why_not_fix; the document has changed since, and there is no such finding any more; those of the
/// tools in core/edit.
[[nodiscard]] Result<LabelEdit> fix(const LabelDocument& document,
                                    const LabelGrid& grid,
                                    const Finding& finding,
                                    const CheckSettings& settings = {});

}  // namespace nadir
