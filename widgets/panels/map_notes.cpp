// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_notes.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/session/map_parts.h"
#include "widgets/panels/map_cards.h"
#include "widgets/panels/map_lines.h"
#include "widgets/panels/panel_text.h"
#include "widgets/panels/picture_area.h"
#include "widgets/panels/run_labels.h"

namespace nadir {
namespace {

std::string tool_words(const MapViewModel& model) {
  if (model.look.tool == MapTool::kMeasure) {
    return model.look.measured_in_enu_m.empty()
               ? "Click the first point to measure from; Esc ends"
               : "Click the next point; a double click or Esc ends";
  }
  if (model.look.tool == MapTool::kPick) {
    const bool has_particles =
        model.step && model.step->particles && !model.step->particles->empty();
    return has_particles ? "Click a particle for its weight and errors; Esc ends"
                         : "No particles here to be picked; Esc ends";
  }
  return {};
}

std::string quoted_name(const std::string& name) { return shortened(name, 28); }

/// A run's name without what all runs of the map have in common.
std::string name_among(const MapViewModel& model, const MapRun& run) {
  std::vector<std::string> names;
  std::size_t place = 0;
  for (const MapRun& one : model.runs) {
    if (one.number == run.number) place = names.size();
    names.push_back(one.name);
  }
  return names.empty() ? run.name : told_apart(names).at(place);
}

const ApartRun* active_apart(const MapViewModel& model) {
  // The last one of the model is the active run, so of those that were taken out as well.
  return model.is_map_foreign && !model.apart.empty() ? &model.apart.back() : nullptr;
}

std::string apart_words(const std::vector<ApartRun>& apart) {
  if (apart.size() > 1) {
    return fmt::format("{} runs are not drawn: they were made on other maps", apart.size());
  }
  const ApartRun& run = apart.front();
  return fmt::format("{} is not drawn: it was made on another map, {}", quoted_name(run.name),
                     quoted_name(run.map));
}

}  // namespace

MapNote map_note(const MapViewModel& model) {
  if (std::string words = tool_words(model); !words.empty()) return {std::move(words), {}, {}};
  if (!model.reading.empty()) {
    return {fmt::format("Reading {}…", quoted_name(model.reading)), {}, {}};
  }
  if (!model.coming.empty() && !model.work) {
    return {fmt::format("{} shows here with its first step", quoted_name(model.coming)), {}, {}};
  }
  if (const ApartRun* const run = active_apart(model)) {
    return {fmt::format("{} was made on another map, {}", quoted_name(run->name),
                        quoted_name(run->map)),
            "Show its map", Action(actions::ActivateRun{run->number})};
  }
  if (!model.apart.empty()) return {apart_words(model.apart), {}, {}};
  if (model.look.is_split && model.runs.size() < 2) {
    return {"Open a second run to see two maps", {}, {}};
  }
  if (!model.map) {
    return {"No map is open: open one to see the ground", "Open the map…",
            Action(actions::ShowOverlay{Overlay::kOpen})};
  }
  return {};
}

Actions draw_map_note(kit::Ui& ui, const MapNote& note, const kit::Rect& map) {
  if (note.words.empty()) return {};
  // Between the tools and the north arrow; the button goes below the words where there is no room beside them.
  const double left = beside_map_tools(ui, map).left;
  const double room = map.right() - ui.px(40.0) - left;
  const bool has_button = !note.button.empty();
  const double padding = ui.px(6.0);
  const double words = ui.text_width(note.words) + 2.0 * padding + ui.px(8.0);
  const double button = has_button ? ui.text_width(note.button) + ui.px(44.0) : 0.0;
  const bool is_beside = words + button <= room;
  const double width = is_beside ? words + button : std::max(words, button);
  const double row = ui.px(has_button ? 28.0 : 20.0);
  const double height = (is_beside || !has_button ? row : ui.px(60.0)) + 2.0 * padding;
  if (width > room || height > map.height / 2.0) return {};
  const kit::Rect place{left + (room - width) / 2.0, map.top + ui.px(8.0), width, height};
  Actions asked;
  const auto region = ui.region("Note", place,
                                {.surface = kit::Surface::kPlate,
                                 .padding = padding,
                                 .is_above = true,
                                 .takes_input = has_button});
  ui.text(note.words);
  if (!has_button) return asked;
  if (is_beside) ui.same_line(ui.px(12.0));
  if (ui.button(note.button) && note.action) asked.push_back(*note.action);
  return asked;
}

std::vector<std::string> shown_things(const MapViewModel& model, const MapRun& run) {
  std::vector<std::string> things;
  if (!run.document || !run.step) return things;
  const RunStep& step = run.document->steps[*run.step];
  const auto add = [&](Layer layer, bool is_there, std::string name) {
    if (is_there && is_in_sight(model.look, layer)) things.push_back(std::move(name));
  };
  const bool has_topview =
      step.topview_cells > 0 && pose_of(step, model.look.topview_at).has_value();
  add(Layer::kEstimate, true, "estimate");
  add(Layer::kEllipses, true, "ellipses");
  add(Layer::kParticles, step.particle_count > 0, "particles");
  add(Layer::kTopview, has_topview,
      model.look.topview_at == PoseSource::kEstimate
          ? "topview"
          : fmt::format("topview at the {}", enum_name(model.look.topview_at)));
  add(Layer::kDisagreement, has_topview && model.map, "agreement");
  add(Layer::kErrorSurface, run.is_active && model.surface_costs, "error surface");
  add(Layer::kReconstruction, run.is_active, "reconstruction");
  return things;
}

void draw_pane_name(Canvas& canvas,
                    const MapFrame& frame,
                    const MapViewModel& model,
                    const MapRun& run,
                    const MapRun* other,
                    double aside_px,
                    const Theme& theme) {
  const double px = frame.px_per_pt;
  TextStyle style;
  style.size_px = 9.0 * px;  // sharp: the window's small text
  style.colour = theme.text;
  const double margin = 5.0 * px;
  const double dot = 12.0 * px;
  const double left = frame.where.left + aside_px + margin;
  // The north arrow is at the right.
  const double most = frame.where.right() - 30.0 * px - left - 2.0 * margin - dot;
  const auto fits = [&](const std::string& words) {
    return measure_text(words, style).width <= most;
  };
  std::string words = run.name;
  if (!fits(words)) {
    // What tells it from the others is said as long as there is room for anything.
    words = fitted_name(name_among(model, run), most, [&style](const std::string& line) {
      return measure_text(line, style).width;
    });
  }
  if (!fits(words)) return;
  std::string separator = ": ";
  std::vector<std::string> things = shown_things(model, run);
  if (other != nullptr) {
    const std::vector<std::string> there = shown_things(model, *other);
    std::erase_if(things, [&there](const std::string& thing) {
      return std::find(there.begin(), there.end(), thing) != there.end();
    });
  }
  for (const std::string& thing : things) {
    const std::string more = separator + thing;
    if (!fits(words + more)) break;
    words += more;
    separator = ", ";
  }
  const TextExtent extent = measure_text(words, style);
  const double height = extent.cap_height + 2.0 * margin;
  const PageRect plate{left, frame.where.top() - 4.0 * px - height,
                       dot + extent.width + 2.0 * margin, height};
  canvas.fill(corners_of(plate), with_opacity(theme.page, 0.85));
  const PageRect mark{plate.left + margin, plate.centre().y() - 3.5 * px, 7.0 * px, 7.0 * px};
  canvas.fill(corners_of(mark), has_ground_picture(model) ? run_colour_on_imagery(theme, run.colour)
                                                          : run_colour(theme, run.colour));
  canvas.text({plate.left + margin + dot, plate.bottom + margin}, words, style);
}

std::optional<Action> escape_wish(const MapViewModel& model) {
  const bool is_picking = model.look.tool == MapTool::kPick;
  if (model.look.tool == MapTool::kMeasure) return Action(actions::UseTool{MapTool::kPan});
  if (model.selected_particle) return Action(actions::SelectParticle{});
  if (is_picking) return Action(actions::UseTool{MapTool::kPan});
  if (!model.look.measured_in_enu_m.empty()) return Action(actions::MeasurePoint{});
  return std::nullopt;
}

}  // namespace nadir
