// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/ui_camera.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// A panel, or what lies over the window, with something in it: to be looked at.
struct PanelScene {
  std::string name;                 ///< Letters, digits and hyphens: "layers", "layers-empty".
  std::vector<std::string> panels;  ///< Headers of widgets/panels that it shows, without ending.
  Eigen::Vector2d size_pt;          ///< Of the window that it fills, at interface scale 1.
  std::function<void(kit::Ui&)> draw;
  std::string pressed = {};     ///< Path of a control that is clicked before; empty: none.
  bool is_over_window = false;  ///< The picture is of the overlay or the notices alone.
  bool is_variant = false;  ///< Another scene shows more of its panel; looked at in fewer looks.
  bool is_without_data = false;  ///< Says what is missing; likewise.
};

/// All of them. Their state lives in them: each is drawn many times in one look only. Pictures that OpenGL holds are made in
/// the context that is current when a scene is drawn first.
[[nodiscard]] std::vector<PanelScene> panel_scenes();

/// How the window looks.
struct PanelLook {
  ThemeName theme = ThemeName::kDark;
  double scale = 1.0;
};
/// Both themes at interface scale 1 and 1.5.
[[nodiscard]] std::vector<PanelLook> panel_looks();

/// A scene after it has come to rest.
struct SeenScene {
  Raster<Rgba> picture;                ///< Of the whole window.
  std::vector<kit::Control> controls;  ///< Of its last frame.
  Raster<Rgba> cut_out;                ///< What the scene is of.
};
[[nodiscard]] SeenScene see(const PanelScene& scene, const PanelLook& look, UiCamera& camera);

}  // namespace nadir
