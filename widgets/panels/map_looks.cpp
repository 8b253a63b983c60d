// SPDX-License-Identifier: Apache-2.0
#include "core/session/map_parts.h"
#include "widgets/panels/map_lines.h"

namespace nadir {

Layer layer_of_source(PoseSource source) {
  switch (source) {
    case PoseSource::kTruth:
      return Layer::kTruth;
    case PoseSource::kOdometry:
      return Layer::kOdometry;
    case PoseSource::kEstimate:
      break;
  }
  return Layer::kEstimate;
}

bool has_ground_picture(const MapLook& look, bool has_map) {
  return has_map && is_ground_below_lines(look);
}

bool has_ground_picture(const MapViewModel& model) {
  return has_ground_picture(model.look, model.map != nullptr);
}

Rgba particle_casing(const Theme& theme, bool is_on_picture) {
  return is_on_picture ? with_opacity(theme.casing_on_imagery, 0.85)
                       : with_opacity(theme.window, 0.85);
}

PathLook run_path_look(const MapViewModel& model,
                       const MapRun& run,
                       PoseSource source,
                       const Theme& theme) {
  const bool is_on_picture = has_ground_picture(model);
  PathLook look;
  look.casing = with_opacity(theme.window, 0.8);
  look.casing_pt = 0.7;
  look.width_pt = 1.5;
  switch (source) {
    case PoseSource::kTruth:
      look.colour = is_on_picture ? theme.truth_on_imagery : theme.truth;
      break;
    case PoseSource::kOdometry:
      look.colour = is_on_picture ? theme.odometry_on_imagery : theme.odometry;
      look.is_dashed = true;
      break;
    case PoseSource::kEstimate:
      look.colour =
          is_on_picture ? run_colour_on_imagery(theme, run.colour) : run_colour(theme, run.colour);
      look.is_dashed = is_run_dashed(run.colour);
      look.width_pt = 1.9;
      break;
  }
  const LayerLook& layer = model.look.layer(layer_of_source(source));
  const auto own = layer.colour ? colour_from_hex(*layer.colour) : std::nullopt;
  // A colour of the user's own is that of the active run: the others keep theirs, or nobody could tell them apart.
  if (own && (source != PoseSource::kEstimate || run.is_active)) look.colour = *own;
  if (is_on_picture) look.casing = casing_over_imagery(theme, look.colour);
  look.colour = faded(look.colour, layer.opacity);
  look.casing = faded(look.casing, layer.opacity);
  return look;
}

}  // namespace nadir
