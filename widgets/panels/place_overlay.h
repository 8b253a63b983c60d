// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// Asks for coordinates and shows that place on the map.
struct PlaceModel {
  bool is_open = false;
  std::optional<ProjectPlane> plane;  ///< Of map or run; nothing without either.
  Eigen::Vector2d here_in_enu_m = Eigen::Vector2d::Zero();  ///< Middle of the map's view.
};

struct PlaceState {
  std::string typed = {};
  bool is_open = false;
};

[[nodiscard]] PlaceModel place_model(const Session& session);

/// Lies over the window where the model says so; call it in every frame.
[[nodiscard]] Actions draw_place_overlay(kit::Ui& ui, const PlaceModel& model, PlaceState& state);

}  // namespace nadir
