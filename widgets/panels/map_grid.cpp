// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_grid.h"

#include "widgets/panels/map_lines.h"

namespace nadir {

Rgba graticule_colour(bool is_on_picture, const Theme& theme) {
  return is_on_picture ? light_on_imagery(theme) : theme.line;
}

void draw_map_grid(const MapDrawing& drawing, bool is_plain) {
  const Theme& theme = drawing.theme;
  const LayerLook& layer = drawing.model.look.layer(Layer::kGraticule);
  const double opacity = is_plain ? 1.0 : layer.opacity;
  const auto own = layer.colour && !is_plain ? colour_from_hex(*layer.colour) : std::nullopt;
  const bool is_on_picture = !is_plain && has_ground_picture(drawing.model);
  const Rgba line = own.value_or(graticule_colour(is_on_picture, theme));
  const MapGridLook look = is_on_picture ? grid_look_on_imagery(theme, line, opacity)
                                         : MapGridLook{faded(line, opacity),
                                                       {0, 0, 0, 0},
                                                       faded(theme.muted, opacity),
                                                       with_opacity(theme.window, 0.8 * opacity)};
  draw_grid_lines(drawing.canvas, drawing.frame, look);
}

}  // namespace nadir
