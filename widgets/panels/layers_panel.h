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
};

[[nodiscard]] LayersModel layers_model(const Session& session);

/// Title of a layer for people: "Error surface".
[[nodiscard]] std::string_view layer_title(Layer layer);
/// Whether a layer is lines whose colour can be chosen.
[[nodiscard]] bool has_line_colour(Layer layer);

/// What the panel keeps; nothing so far.
struct LayersState {};

/// Paths, for the layer `estimate`: "Layers/estimate/grip", "/visible", "/opacity", and "/##colour" where it has lines;
/// "Layers/topview at/estimate"; "Layers/Classes/shares/road/share".
[[nodiscard]] Actions draw_layers(kit::Ui& ui, const LayersModel& model, LayersState& state);

}  // namespace nadir
