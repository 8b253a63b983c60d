// SPDX-License-Identifier: Apache-2.0
// What OpenGL draws of the window: the grounds below the map's lines, and the scene in space.
#include <algorithm>
#include <cmath>

#include "app/gui/gui_window.h"
#include "core/session/step_pose.h"
#include "widgets/gl/offscreen_renderer.h"

namespace nadir {
namespace {

const OpenRun* run_of(const Session& session, int number) {
  const auto runs = session.runs();
  return number >= 1 && static_cast<std::size_t>(number) <= runs.size()
             ? &runs[static_cast<std::size_t>(number - 1)]
             : nullptr;
}

/// The decoded step of a run at the cursor, or the one nearest to it until that is there.
std::shared_ptr<const RunStep> step_of(const Session& session, int number) {
  if (number == session.view().active_run && session.step()) return session.step();
  const OpenRun* const run = run_of(session, number);
  const auto index =
      number == session.view().active_run ? session.step_index() : session.step_index_of(number);
  return run != nullptr && run->cache && index ? run->cache->nearest_step(*index) : nullptr;
}

int pixels(double length_px) {
  return std::clamp(static_cast<int>(std::lround(length_px)), 1, OffscreenRenderer::kMostSide);
}

}  // namespace

void GuiWindow::follow_map() {
  const OpenMap* const map = session_.map();
  const std::filesystem::path path = map != nullptr ? map->path : std::filesystem::path();
  const auto index_now = map != nullptr ? map->index : nullptr;
  // A map that could not be drawn may have been mended when it is read anew; till then it is not tried again.
  const bool is_read_anew = index_now != map_index_ && !can_map_be_drawn_;
  map_index_ = index_now;
  if (path != map_path_ || is_read_anew) {
    map_path_ = path;
    can_map_be_drawn_ = true;
    complaints_.clear();
    grounds_ = {};
    scene_.reset();
  }
  const OpenRun* const active = session_.active_run();
  const auto index = session_.step_index();
  if (session_.view().map.layer(Layer::kReconstruction).is_visible && active != nullptr &&
      active->document && index) {
    reconstruction_.ask({active->document, *index, session_.view().map.topview_at});
  }
  // The surface is computed for the tab that explains, and for its layer.
  if (session_.view().map.layer(Layer::kErrorSurface).is_visible) {
    (void)why_model(session_, inquiry_);
  }
  if (const std::string fault = reconstruction_.take_error(); !fault.empty()) {
    session_.notify(Notice::Kind::kError, fault);
  }
}

std::shared_ptr<const MomentSurface> GuiWindow::surface_now() const {
  const auto answer = inquiry_.answer();
  if (!answer || !answer->surface || answer->step != session_.step()) return nullptr;
  return {answer, &*answer->surface};
}

void GuiWindow::complain_once(const Error& error) {
  if (complaints_.insert(error.message).second) {
    session_.notify(Notice::Kind::kError, error.message);
  }
}

GroundPicture& GuiWindow::ground_of(const MapGround& wanted) {
  PaneGround& pane = grounds_.at(wanted.is_second ? 1 : 0);
  const bool has_map = !map_path_.empty() && can_map_be_drawn_;
  // Without a map the ground has its origin near the run.
  if (!has_map && pane.run != wanted.run) pane.picture.reset();
  pane.run = wanted.run;
  pane.is_drawn = true;
  if (pane.picture == nullptr && has_map) {
    auto opened = GroundPicture::open(map_path_, tiles_);
    if (opened) {
      pane.picture = std::move(*opened);
    } else {
      can_map_be_drawn_ = false;
      complain_once(opened.error());
    }
  }
  if (pane.picture == nullptr) {
    pane.picture = GroundPicture::without_map(wanted.camera.centre_in_enu_m);
  }
  return *pane.picture;
}

void GuiWindow::forget_unseen() {
  for (PaneGround& pane : grounds_) {
    if (!pane.is_drawn) pane = {};
    pane.is_drawn = false;
  }
  if (session_.label_desk() == nullptr) label_ground_.reset();
  textures_.end_frame();
}

std::size_t GuiWindow::drawn_bytes() const {
  return tiles_->used_bytes() + textures_.bytes() + (scene_ ? scene_->tile_bytes() : 0);
}

kit::TextureId GuiWindow::draw_ground(const MapGround& wanted, const kit::Ui& ui) {
  if (wanted.is_of_labels) return draw_label_ground(wanted, ui);
  GroundPicture& ground = ground_of(wanted);
  GroundContents contents;
  contents.look = session_.resolved_map_look();
  contents.step = step_of(session_, wanted.run);
  contents.theme = ui.theme_name();
  if (const OpenMap* const map = session_.map(); map != nullptr && map->index) {
    contents.labels = std::shared_ptr<const OverheadMap>(map->index, &map->index->map());
  }
  if (wanted.run == session_.view().active_run) {
    contents.reconstruction = reconstruction_.answer();
    contents.surface = surface_now();
    contents.shows_best_turn = why_.shows_best_turn;
  }
  ground.show(contents);
  constexpr double kPointPx = 96.0 / 72.0;
  const GroundPart part{wanted.layers, wanted.part, wanted.part_count, wanted.is_lowest};
  if (const auto drawn = ground.draw(wanted.camera, pixels(wanted.width_px),
                                     pixels(wanted.height_px), ui.px(kPointPx), part);
      !drawn) {
    complain_once(drawn.error());
  }
  wants_more_ |= ground.wants_more();
  return ground.texture(wanted.part);
}

kit::TextureId GuiWindow::draw_scene(const SceneWish& wanted, const kit::Ui& ui) {
  if (map_path_.empty() || !can_map_be_drawn_) return 0;
  if (scene_ == nullptr) {
    auto opened = FlightScene::open(map_path_);
    if (!opened) {
      can_map_be_drawn_ = false;
      complain_once(opened.error());
      return 0;
    }
    scene_ = std::move(*opened);
  }
  const OpenRun* const run = session_.active_run();
  const auto index = session_.step_index();
  const bool has_frame = run != nullptr && run->cache && index && run->cache->frame_of(*index);
  const auto camera = has_frame ? run->cache->camera(*index) : nullptr;
  // While a frame is decoded the last one stays where it was seen, so that nothing jumps.
  const bool is_on_its_way = has_frame && !camera && !run->cache->is_cursor_ready();
  if (!is_on_its_way) {
    const bool has_step = run != nullptr && run->document && index;
    const auto pose = has_step
                          ? pose_of(run->document->steps[*index], session_.view().map.topview_at)
                          : std::nullopt;
    const auto flight = session_.flight();
    if (const auto shown = scene_->show(pose, camera, flight.get()); !shown) {
      complain_once(shown.error());
    }
  }
  constexpr double kPointPx = 96.0 / 72.0;
  const auto drawn = scene_->draw(wanted.camera, ui.theme_name(), pixels(wanted.width_px),
                                  pixels(wanted.height_px), ui.px(kPointPx));
  if (!drawn) complain_once(drawn.error());
  return scene_->texture();
}

}  // namespace nadir
