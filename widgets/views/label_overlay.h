// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/label/label_object.h"

namespace nadir {

/// What a place of a tool holds on to; each has a mark of its own form.
enum class SnapMark { kCorner, kEdge, kContinuing, kSquareOn, kClosing };

/// What a labelling editor draws over the map, as a plain value: all places in enu, metres.
struct LabelOverlay {
  std::vector<std::shared_ptr<const LabelObject>> selected;  ///< None of them null.
  std::vector<Eigen::Vector2d> picked;                       ///< Corners that were picked.
  bool shows_corners = false;                     ///< Of what is selected, where they lie apart.
  std::shared_ptr<const LabelObject> under_hand;  ///< Null: none, or it is selected.

  /// What finishing would draw.
  struct Coming {
    std::vector<Ring> rings;  ///< Rings of what is filled; or lines, which are not.
    bool is_filled = true;
    ClassId class_id = kUnclassified;
  };
  std::vector<Coming> coming;

  std::vector<Eigen::Vector2d> places;  ///< Of the tool at work.
  std::optional<Eigen::Vector2d> next;  ///< Where the next one would come.
  bool closes = false;  ///< The places surround something: its last side is shown too.
  /// On the middle of a leg: its length, or what was typed.
  struct Words {
    Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
    std::string line;
    bool is_typed = false;  ///< Emphasised, and shown however short the leg is.
  };
  std::vector<Words> words;

  struct Snapped {
    SnapMark mark = SnapMark::kCorner;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
  };
  std::optional<Snapped> snapped;

  struct Brush {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius_m = 1.0;
  };
  std::optional<Brush> brush;
};

}  // namespace nadir
