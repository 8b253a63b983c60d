// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/desk/label_desk.h"
#include "core/session/label_view.h"
#include "core/session/shared_ground.h"
#include "widgets/panels/map_view.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

MapRun map_run(const Session& session, std::size_t index) {
  const OpenRun& open = session.runs()[index];
  MapRun run;
  run.number = static_cast<int>(index) + 1;
  run.name = open.name;
  run.colour = static_cast<std::size_t>(std::max(0, session.view().runs[index].colour));
  run.is_active = run.number == session.view().active_run;
  run.document = open.document;
  if (!open.document) return run;
  run.step = run.is_active ? session.step_index() : session.step_index_of(run.number);
  if (run.step && *run.step >= open.document->steps.size()) run.step.reset();
  if (!run.is_active) return run;
  for (const Bookmark& bookmark : open.bookmarks) {
    const auto step = open.document->index_at(bookmark.time_s);
    if (!step) continue;
    run.bookmarks_in_enu_m.push_back(
        open.document->steps[*step].estimate.moments.mean.translation_m());
    run.bookmark_notes.push_back(bookmark.note);
  }
  return run;
}

/// Takes out what would be drawn where it was not: coordinates of another map's.
void set_apart(MapViewModel& model, const RunDocument& active) {
  model.is_map_foreign = model.map && !is_on_plane(active.header, model.map->map().plane);
  std::erase_if(model.runs, [&](const MapRun& run) {
    if (!run.document) return false;
    const RunHeader& header = run.document->header;
    if (!model.is_map_foreign && share_ground(active.header, header)) return false;
    model.apart.push_back({run.number, run.name, header.map});
    return true;
  });
  if (!model.is_map_foreign) return;
  model.step.reset();
  model.selected_particle.reset();
}

}  // namespace

std::optional<ProjectPlane> plane_of(const Session& session) {
  if (const OpenMap* const map = session.map(); map != nullptr && map->index) {
    return map->index->map().plane;
  }
  const OpenRun* const run = session.active_run();
  if (run == nullptr || !run->document) return std::nullopt;
  const RunHeader& header = run->document->header;
  const auto plane = ProjectPlane::create({header.plane_latitude_deg, header.plane_longitude_deg});
  if (!plane) return std::nullopt;
  return *plane;
}

MapViewModel map_view_model(const Session& session) {
  MapViewModel model;
  model.look = session.resolved_map_look();
  if (session.label_view().workspace == Workspace::kLabel) {
    model.labels = session.label_desk();
    model.takes_keys = session.overlay() == Overlay::kNone;
    if (model.labels == nullptr) model.reading = name_of(session.label_view().path);
    if (model.labels != nullptr) model.plane = model.labels->sheet().now().plane();
    return model;
  }
  for (std::size_t i = 0; i < session.runs().size(); ++i) {
    const bool is_active = static_cast<int>(i) + 1 == session.view().active_run;
    if (is_active || session.view().runs[i].is_shown) model.runs.push_back(map_run(session, i));
  }
  std::stable_partition(model.runs.begin(), model.runs.end(),
                        [](const MapRun& run) { return !run.is_active; });
  model.step = session.step();
  model.plane = plane_of(session);
  if (const OpenMap* const map = session.map()) {
    model.map = map->index;
    if (!map->index) model.reading = map->path.filename().string();
  }
  for (const MapRun& run : model.runs) {
    if (run.document) continue;
    const bool is_made = session.runs()[static_cast<std::size_t>(run.number) - 1].is_live;
    (is_made ? model.coming : model.reading) = run.name;
  }
  for (const JobStatus& job : session.jobs()) {
    if (job.will_be_shown) model.work = job;
  }
  model.selected_particle = session.view().selected_particle;
  model.takes_keys = session.overlay() == Overlay::kNone;
  const OpenRun* const active = session.active_run();
  if (active != nullptr && active->document) set_apart(model, *active->document);
  return model;
}

}  // namespace nadir
