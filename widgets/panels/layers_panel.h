// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/map/semantic_classes.h"
#include "core/session/action.h"
#include "core/session/view_state.h"
#include "widgets/kit/ui.h"

namespace nadir {

class Session;

/// What the map is made of, and what of it there is at this moment.
struct LayersModel {
  struct Row {
    Layer layer = Layer::kPicture;
    LayerLook look;
    std::string
        why_empty;  ///< Why it shows nothing at this moment, in a few words; empty: it does.
  };
  struct ClassShare {
    ClassId id = 0;
    double share = 0.0;  ///< Of the map's classified cells, in (0, 1].
  };
  std::vector<Row> rows;  ///< From the top of the map down to its ground.
  PoseSource topview_at = PoseSource::kEstimate;
  std::vector<ClassShare> classes;  ///< Of the open map, the largest first; empty without one.
  bool is_on_picture = false;       ///< Lines lie on picture or labels, and have colours for that.
  std::size_t run_colour = 0;       ///< Of the active run.
};

[[nodiscard]] LayersModel layers_model(const Session& session);

/// Title of a layer for people: "Error surface".
[[nodiscard]] std::string_view layer_title(Layer layer);
/// Whether a layer is lines whose colour can be chosen.
[[nodiscard]] bool has_line_colour(Layer layer);
/// What its lines are drawn in where nobody has chosen a colour.
[[nodiscard]] Rgba usual_line_colour(Layer layer, const LayersModel& model, const Theme& theme);

/// What the panel keeps; nothing so far.
struct LayersState {};

/// Paths, for the layer `estimate`: "Layers/estimate/grip", "/visible", "/opacity" (not of the legend), and "/##colour" where it
/// has lines; a click
/// of the right button on its title, or Shift+F10 on its grip or eye, opens "Layers/estimate/order/Raise", "/Lower", "/To the
/// top", "/To the ground".
/// "Layers/topview at/estimate"; "Layers/Classes/shares/road/share".
[[nodiscard]] Actions draw_layers(kit::Ui& ui, const LayersModel& model, LayersState& state);

}  // namespace nadir
