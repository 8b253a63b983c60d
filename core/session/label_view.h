// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>

#include "core/base/field.h"
#include "core/desk/label_tool.h"
#include "core/session/view_state.h"

namespace nadir {

/// What the window is for at the moment.
enum class Workspace {
  kReplay,  ///< Runs along their time.
  kLabel,   ///< Labels of an overhead image.
};
template <>
struct EnumNames<Workspace> {
  static constexpr std::array<std::string_view, 2> kNames = {"replay", "label"};
};

/// What the column beside the map shows while labels are drawn.
enum class LabelTab { kObjects, kChecks, kReview, kHistory, kImage };
template <>
struct EnumNames<LabelTab> {
  static constexpr std::array<std::string_view, 5> kNames = {"objects", "checks", "review",
                                                             "history", "image"};
};

/// What lies over each other where labels are drawn.
enum class LabelLayer { kLabels, kPicture };
template <>
struct EnumNames<LabelLayer> {
  static constexpr std::array<std::string_view, 2> kNames = {"labels", "picture"};
};

/// Which part of the ground a map shows.
struct GroundSight {
  Eigen::Vector2d centre_in_enu_m = Eigen::Vector2d::Zero();
  double width_m = 0.0;  ///< 0: not chosen yet.
  friend bool operator==(const GroundSight&, const GroundSight&) = default;
};

[[nodiscard]] inline GroundSight sight_of(const MapLook& look) {
  return {look.centre_in_enu_m, look.width_m};
}

/// What is labelled, and with what: not undone, for labels have a history of their own, but kept from one start to the next.
struct LabelView {
  Workspace workspace = Workspace::kReplay;
  std::string path;  ///< What was named: map package, image or labelling document; empty: none.
  LabelTool tool;
  LabelTab tab = LabelTab::kObjects;
  double labels_opacity = 0.6, picture_opacity = 1.0;  ///< In [0, 1].
  bool shows_borders = true;  ///< Of all objects, not only of those that are selected.
  GroundSight elsewhere;      ///< What the other workspace shows, where it is of another place.
  friend bool operator==(const LabelView&, const LabelView&) = default;
};

}  // namespace nadir
