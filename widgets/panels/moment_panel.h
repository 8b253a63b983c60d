// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/action.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/moment_model.h"
#include "widgets/panels/picture_area.h"
#include "widgets/panels/seen_moment.h"

namespace nadir {

/// What the camera control keeps: how frames are shown, and the pictures made of them.
struct CameraViewState {
  CameraKind kind = CameraKind::kImage;
  double label_opacity = 0.35;
  CameraPictureCache pictures;
  PictureZoom zoom;
};

struct MomentPanelState {
  TextureOf texture_of;
  CameraViewState camera;
  SeenMomentCache seen;
};

/// Everything about the moment at the cursor in one column: numbers, camera, topview beside the map, agreement by class.
[[nodiscard]] Actions draw_moment_panel(kit::Ui& ui,
                                        const MomentModel& model,
                                        MomentPanelState& state);

/// One of the pictures of what was seen; the cell under the mouse is said in a tooltip.
/// @param size  Pixels; 0: what is left, or as high as the picture's shape wants.
void draw_seen_picture(kit::Ui& ui,
                       const std::string& name,
                       const Picture& picture,
                       const SeenMoment& moment,
                       const TextureOf& texture_of,
                       const Eigen::Vector2d& size);

/// Bars of the share of cells that agree, a class a row, at the estimate and at the truth: the classes that were seen on
/// known ground.
/// @param estimate  Colour of the run.
void draw_agreement_table(kit::Ui& ui, const SeenMoment& moment, Rgba estimate);

/// Image with labels over it as strong as wished, labels, depth or confidence; or what is missing. @param is_large  It fills
/// the room, and can be magnified.
void draw_camera_view(kit::Ui& ui,
                      const MomentModel& model,
                      CameraViewState& state,
                      const TextureOf& texture_of,
                      bool is_large);

}  // namespace nadir
