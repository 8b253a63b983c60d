// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/map/overhead_map.h"
#include "core/run/run_file.h"
#include "core/session/map_parts.h"
#include "widgets/figures/figure_run.h"
#include "widgets/figures/map_panel.h"
#include "widgets/views/agreement_view.h"
#include "widgets/views/mode_marks.h"
#include "widgets/views/particle_view.h"
#include "widgets/views/raster_view.h"

namespace nadir {

/// What a stack of the options says in the words of the others: which layers are shown, the opacity of the labels, whether
/// the graticule has lines. As they are where there is none.
[[nodiscard]] FigureOptions with_stack_applied(FigureOptions options);

/// The layers of a stack that figure 'moment' cannot draw, as words: "reconstruction and error surface"; empty: none.
[[nodiscard]] std::string not_in_moment(const MapStack& stack);

/// The map of figure 'moment': what lies on the ground at a step, and the lines over it, as the options have them. With a
/// stack it looks as the window's map does: in its order, with its opacities and colours.
class MomentMap {
 public:
  /// @param options  With their stack applied. @errors as MapPanel::create.
  [[nodiscard]] static Result<std::unique_ptr<MomentMap>> create(
      const std::filesystem::path& package, const FigureOptions& options);

  /// Lays a step on the ground. @param labels  Of the map.
  void show(const RunStep& step, const OverheadMap& labels, const Theme& theme);
  /// @param steps  Of the run that have been up to now. @errors as MapPanel::draw_ground.
  [[nodiscard]] Result<void> draw(Canvas& canvas,
                                  FigureContext& context,
                                  const PageRect& where,
                                  const FigureRun& run,
                                  std::size_t steps,
                                  const RunStep& step);

  [[nodiscard]] bool shows_particles(const RunStep& step) const;
  /// With the layer of modes all of them, else only the heaviest.
  [[nodiscard]] std::span<const PoseMode> shown_modes(const RunStep& step) const;
  /// Of the estimate, on the bare page: its own colour, else that of the run.
  [[nodiscard]] Rgba run_colour(const Theme& theme) const;
  /// In the colour that the map has it.
  [[nodiscard]] PathLook line_look(Layer layer, const Theme& theme) const;

 private:
  MomentMap(std::unique_ptr<MapPanel> panel, const FigureOptions& options);
  void look_around(const RunStep& step);
  void lay_topview(const RunStep& step, const OverheadMap& labels, const Theme& theme);
  [[nodiscard]] Result<MapFrame> draw_parts(Canvas& canvas,
                                            FigureContext& context,
                                            const PageRect& where,
                                            const FigureRun& run,
                                            std::size_t steps,
                                            const RunStep& step);
  void draw_line_layer(Canvas& canvas,
                       const MapFrame& frame,
                       Layer layer,
                       const FigureRun& run,
                       std::size_t steps,
                       const RunStep& step,
                       const Theme& theme) const;
  void draw_poses(Canvas& canvas,
                  const MapFrame& frame,
                  const RunStep& step,
                  const Theme& theme) const;
  [[nodiscard]] PathLook theme_look(Layer layer, const Theme& theme) const;
  [[nodiscard]] ModeLook mode_look(const Theme& theme) const;
  [[nodiscard]] MapGridLook grid_look(const Theme& theme) const;

  std::unique_ptr<MapPanel> panel_;  ///< Before the views, which lie in its scene.
  FigureOptions options_;
  MapLook look_;  ///< Of the stack, else of the figure itself.
  RasterView topview_;
  AgreementView agreement_;
  ParticleView particles_;
};

}  // namespace nadir
