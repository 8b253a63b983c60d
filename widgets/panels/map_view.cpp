// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_view.h"

#include <algorithm>
#include <cmath>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/map_cards.h"
#include "widgets/panels/map_notes.h"
#include "widgets/panels/map_pane.h"
#include "widgets/panels/map_vehicle.h"
#include "widgets/panels/work_card.h"

namespace nadir {

Actions draw_map_view(kit::Ui& ui, const MapViewModel& model, MapViewState& state) {
  const auto scope = ui.scope("Map");
  state.readout.reset();
  state.legend_height_px = 0.0;
  state.away.reset();
  const auto active = std::find_if(model.runs.begin(), model.runs.end(),
                                   [](const MapRun& run) { return run.is_active; });
  if (model.step && active != model.runs.end() && active->document) {
    state.seen_classes.add(active->document->path.string(), *model.step);
  }
  std::vector<std::shared_ptr<const RunDocument>> documents;
  for (const MapRun& run : model.runs) documents.push_back(run.document);
  state.paths.keep_only(documents);
  const bool has_something =
      model.labels != nullptr || model.map || !model.apart.empty() ||
      std::any_of(documents.begin(), documents.end(), [](const auto& d) { return d != nullptr; });
  if (!has_something) {
    if (model.work) return draw_work_card(ui, *model.work, ui.room());
    if (!model.reading.empty()) return draw_empty_state(ui, reading_state(model.reading));
    return draw_empty_state(ui,
                            {kit::Icon::kMap,
                             "No map is open",
                             "Drop a run, a map or a flight on the window, or begin with the demo.",
                             "Open the demo",
                             {},
                             actions::OpenDemo{}});
  }
  Actions asked;
  const auto join = [&asked](Actions more) {
    for (Action& action : more) asked.push_back(std::move(action));
  };
  const kit::Rect room = ui.room();
  std::vector<int> all;
  for (const MapRun& run : model.runs) all.push_back(run.number);
  if (model.look.is_split && all.size() >= 2 && model.labels == nullptr) {
    const double half = std::floor((room.width - ui.px(2.0)) / 2.0);
    const Eigen::Vector2d size(half, room.height);
    asked = MapPaneView(ui, model, state, {"Ground", {all.back()}, size, true, true}).draw();
    ui.same_line(ui.px(2.0));
    join(MapPaneView(ui, model, state, {"Second ground", {all[all.size() - 2]}, size, false, true})
             .draw());
  } else {
    asked = MapPaneView(ui, model, state, {"Ground", all, {room.width, room.height}, true}).draw();
  }
  join(draw_map_tools(ui, model, room));
  if (state.away) {
    const kit::Rect page{room.left, room.top, state.where.width, state.where.top()};
    join(draw_vehicle_plate(ui, *state.away, page));
  }
  join(draw_map_cards(ui, model, room));
  if (model.labels == nullptr) join(draw_map_note(ui, map_note(model), room));
  if (model.work) join(draw_work_card(ui, *model.work, room));
  if (model.takes_keys && model.labels == nullptr && ui.is_pressed("Escape")) {
    if (auto wish = escape_wish(model)) asked.push_back(std::move(*wish));
  }
  return asked;
}

}  // namespace nadir
