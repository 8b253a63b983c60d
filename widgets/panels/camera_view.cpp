// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/panels/moment_panel.h"

namespace nadir {
namespace {

/// Why there is nothing to see; empty: there is.
std::string why_no_picture(const CameraMoment& camera, CameraKind kind) {
  // Without an image the labels stand in for it.
  const bool is_there = has_kind(camera, kind) ||
                        (kind == CameraKind::kImage && has_kind(camera, CameraKind::kLabels));
  if (is_there) return {};
  if (kind == CameraKind::kConfidence) {
    return "This flight holds no confidence of its labels, so there is none to see.";
  }
  return fmt::format("This frame has no {}.", camera_kind_name(kind));
}

std::vector<std::string> pixel_words(const CameraMoment& camera,
                                     const Eigen::Vector2i& pixel,
                                     const Raster<Rgba>& picture) {
  std::vector<std::string> words;
  const auto scaled_to = [&](int width, int height) {
    return pixel_of_other_size(pixel, {picture.width(), picture.height()}, {width, height});
  };
  if (!camera.labels.empty()) {
    const auto at = scaled_to(camera.labels.width(), camera.labels.height());
    words.emplace_back(class_info(camera.labels.at(at.x(), at.y())).name);
  }
  if (!camera.depth_m.empty()) {
    const auto at = scaled_to(camera.depth_m.width(), camera.depth_m.height());
    const float depth = camera.depth_m.at(at.x(), at.y());
    words.push_back(depth > 0.0F && std::isfinite(depth) ? fmt::format("{:.1f} m away", depth)
                                                         : "no depth here");
  }
  return words;
}

void draw_frame(kit::Ui& ui,
                const MomentModel& model,
                CameraViewState& state,
                const TextureOf& texture_of,
                bool is_large,
                double below) {
  const Picture& picture = state.pictures.of(model.camera, state.kind, state.label_opacity);
  const kit::Rect room = ui.room();
  const Eigen::Vector2d size(room.width,
                             is_large ? std::max(ui.px(80.0), room.height - below) : 0.0);
  const auto input = is_large
                         ? draw_picture(ui, "Camera picture", picture, texture_of, state.zoom, size)
                         : draw_picture(ui, "Camera picture", picture, texture_of, size);
  if (!input.pixel || !model.camera || !picture) return;
  const auto words = pixel_words(*model.camera, *input.pixel, *picture.pixels);
  if (!words.empty()) ui.mouse_tooltip(words);
}

}  // namespace

void draw_camera_view(kit::Ui& ui,
                      const MomentModel& model,
                      CameraViewState& state,
                      const TextureOf& texture_of,
                      bool is_large) {
  if (!model.has_camera_frame) {
    const std::string words =
        model.has_flight
            ? "The flight has no camera frame of this moment."
            : "The flight of this run is not open: its camera frames are read from there.";
    ui.wrapped(words, kit::TextLook::kMuted);
    return;
  }
  const std::array<std::string, 4> kinds = {"Image", "Labels", "Depth", "Confidence"};
  const auto place = static_cast<std::size_t>(state.kind);
  const auto kind = ui.tabs("##Show", kinds, place);  // each as wide as its word is
  if (kind) state.kind = static_cast<CameraKind>(*kind);
  ui.space(ui.px(4.0));
  const bool has_slider = state.kind == CameraKind::kImage && model.camera &&
                          has_kind(*model.camera, CameraKind::kImage) &&
                          has_kind(*model.camera, CameraKind::kLabels);
  const std::string why_not =
      model.camera ? why_no_picture(*model.camera, state.kind) : std::string();
  if (!why_not.empty()) {
    ui.wrapped(why_not, kit::TextLook::kMuted);
    return;
  }
  const bool is_depth = state.kind == CameraKind::kDepth;
  draw_frame(ui, model, state, texture_of, is_large, ui.px(has_slider || is_depth ? 40.0 : 8.0));
  if (!has_slider && !is_depth) return;
  ui.space(ui.px(4.0));
  if (is_depth) return ui.text("light is near, dark is far", kit::TextLook::kMuted);
  ui.text("labels", kit::TextLook::kMuted);
  ui.same_line();
  const auto edit = ui.small_slider("Label opacity", state.label_opacity,
                                    {.least = 0.0,
                                     .most = 1.0,
                                     .decimals = 2,
                                     .reset = 0.35,
                                     .hint = {"How much the labels cover the image", ""}});
  if (edit.is_changed) state.label_opacity = edit.value;
}

}  // namespace nadir
