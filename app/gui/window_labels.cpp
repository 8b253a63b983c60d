// SPDX-License-Identifier: Apache-2.0
// The window while labels are drawn: its columns, and the ground below the hand.
#include <algorithm>
#include <cmath>

#include "app/gui/gui_window.h"
#include "core/session/label_view.h"
#include "widgets/gl/offscreen_renderer.h"

namespace nadir {
namespace {

int whole_pixels(double length_px) {
  return std::clamp(static_cast<int>(std::lround(length_px)), 1, OffscreenRenderer::kMostSide);
}

}  // namespace

bool GuiWindow::draws_labels() const {
  return session_.label_view().workspace == Workspace::kLabel;
}

void GuiWindow::draw_label_columns(kit::Ui& ui, const WindowPlaces& places, Actions& asked) {
  const auto take = [&asked](Actions more) {
    for (Action& action : more) asked.push_back(std::move(action));
  };
  if (places.left.width > 0.0) {
    const auto region = ui.region("Left", places.left, {.has_border = true});
    const auto content = ui.scroll_area("Content");
    take(draw_label_tools(ui, label_tools_model(session_)));
  }
  if (places.right.width > 0.0) {
    const auto region = ui.region("Right", places.right, {.has_border = true});
    take(draw_label_side(ui, label_side_model(session_), label_side_));
  }
}

kit::TextureId GuiWindow::draw_label_ground(const MapGround& wanted, const kit::Ui& ui) {
  const LabelDesk* const desk = session_.label_desk();
  if (desk == nullptr) return 0;
  const std::filesystem::path path = session_.label_view().path;
  if (label_ground_ == nullptr || labelled_path_ != path) {
    label_ground_ = std::make_unique<LabelGround>(*desk, path, tiles_);
    labelled_path_ = path;
  }
  const LabelView& view = session_.label_view();
  LabelGroundLook look;
  look.picture_opacity = view.picture_opacity;
  look.labels_opacity = view.labels_opacity;
  look.shows_borders = view.shows_borders;
  look.background = ui.theme().window;
  constexpr double kPointPx = 96.0 / 72.0;
  const auto drawn = label_ground_->draw(*desk, look, wanted.camera, whole_pixels(wanted.width_px),
                                         whole_pixels(wanted.height_px), ui.px(kPointPx));
  if (!drawn) complain_once(drawn.error());
  wants_more_ |= label_ground_->wants_more();
  return label_ground_->texture();
}

}  // namespace nadir
