// SPDX-License-Identifier: Apache-2.0
// What OpenGL draws of the window: the grounds below the map's lines, and the scene in space.
#include <algorithm>
#include <cmath>

#include "app/gui/gui_window.h"
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
  if (path != map_path_) {
    map_path_ = path;
    grounds_.clear();
    scene_.reset();
  }
  const int runs = static_cast<int>(session_.runs().size());
  std::erase_if(grounds_, [runs](const auto& entry) { return entry.first > runs; });
  const OpenRun* const active = session_.active_run();
  const auto index = session_.step_index();
  if (session_.view().map.layer(Layer::kReconstruction).is_visible && active != nullptr &&
      active->document && index) {
    reconstruction_.ask({active->document, *index, session_.view().map.topview_at});
  }
  if (const std::string fault = reconstruction_.take_error(); !fault.empty()) {
    session_.notify(Notice::Kind::kError, fault);
  }
}

void GuiWindow::complain_once(const Error& error) {
  if (error.message == last_complaint_) return;
  last_complaint_ = error.message;
  session_.notify(Notice::Kind::kError, error.message);
}

kit::TextureId GuiWindow::draw_ground(const MapGround& wanted, const kit::Ui& ui) {
  if (map_path_.empty()) return 0;
  auto& ground = grounds_[wanted.run];
  if (ground == nullptr) {
    auto opened = GroundPicture::open(map_path_);
    if (!opened) {
      complain_once(opened.error());
      return 0;
    }
    ground = std::move(*opened);
  }
  GroundContents contents;
  contents.look = session_.resolved_map_look();
  contents.step = step_of(session_, wanted.run);
  contents.theme = ui.theme_name();
  if (const OpenMap* const map = session_.map(); map != nullptr && map->index) {
    contents.labels = std::shared_ptr<const OverheadMap>(map->index, &map->index->map());
  }
  if (wanted.run == session_.view().active_run) {
    contents.reconstruction = reconstruction_.answer();
    const auto answer = inquiry_.answer();
    if (answer && answer->surface && answer->step == session_.step()) {
      contents.surface = std::shared_ptr<const MomentSurface>(answer, &*answer->surface);
    }
  }
  ground->show(contents);
  constexpr double kPointPx = 96.0 / 72.0;
  if (const auto drawn = ground->draw(wanted.camera, pixels(wanted.width_px),
                                      pixels(wanted.height_px), ui.px(kPointPx));
      !drawn) {
    complain_once(drawn.error());
  }
  wants_more_ |= ground->wants_more();
  return ground->texture();
}

kit::TextureId GuiWindow::draw_scene(const SceneWish& wanted, const kit::Ui& ui) {
  if (map_path_.empty()) return 0;
  if (scene_ == nullptr) {
    auto opened = FlightScene::open(map_path_);
    if (!opened) {
      complain_once(opened.error());
      return 0;
    }
    scene_ = std::move(*opened);
  }
  const OpenRun* const run = session_.active_run();
  const auto index = session_.step_index();
  const auto camera = run != nullptr && run->cache && index ? run->cache->camera(*index) : nullptr;
  const auto flight = session_.flight();
  if (const auto shown =
          scene_->show(session_.step(), camera, flight.get(), session_.view().map.topview_at);
      !shown) {
    complain_once(shown.error());
  }
  constexpr double kPointPx = 96.0 / 72.0;
  const auto drawn = scene_->draw(wanted.camera, ui.theme_name(), pixels(wanted.width_px),
                                  pixels(wanted.height_px), ui.px(kPointPx));
  if (!drawn) complain_once(drawn.error());
  return scene_->texture();
}

}  // namespace nadir
