// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/flight/flight_recording.h"
#include "core/map/overhead_map.h"
#include "core/mcl/cell_agreement.h"
#include "widgets/figures/figure_run.h"
#include "widgets/figures/page.h"
#include "widgets/views/chart_spec.h"

namespace nadir {

/// The panels of figure 'moment' beside its map.

/// The camera's pictures of a run's flight, where they are still there or beside the run.
class CameraPictures {
 public:
  explicit CameraPictures(const FigureRun& run);
  /// The picture of that time, as nearest_frame(); read once while it stays the same. @errors what to say in its place.
  [[nodiscard]] Result<const Raster<Rgba>*> at(double time_s);

 private:
  std::unique_ptr<FlightRecording> flight_;
  std::string why_not_;
  std::filesystem::path shown_file_;
  Raster<Rgba> shown_;
};

/// How a step's topview fits the map.
struct MomentAgreement {
  CellAgreement at_estimate;
  std::optional<CellAgreement> at_truth;
};
/// Nothing for a step without topview cells, or with cells of another size than the map's.
[[nodiscard]] std::optional<MomentAgreement> moment_agreement(const RunStep& step,
                                                              const OverheadMap& map);

/// The topview as seen, the map's patch at the estimate and at the truth, and the cells that agree at the estimate; all
/// with the heading up. As many as have room, from the left.
void draw_patches(Canvas& canvas,
                  const PageFormat& format,
                  const PageRect& panel,
                  const RunStep& step,
                  const OverheadMap& map,
                  const std::optional<MomentAgreement>& agreement);

/// Share of the cells of each class that agree with the map. Nothing where the map knows none of them.
/// @param estimate  Colour of what is at the estimate.
[[nodiscard]] std::optional<ChartSpec> agreement_bars(const MomentAgreement& agreement,
                                                      const Theme& theme,
                                                      Rgba estimate);

/// Classes of the topview and of the map under it.
[[nodiscard]] std::vector<LegendEntry> patch_legend(const RunStep& step,
                                                    const OverheadMap& map,
                                                    const Theme& theme);

/// ", 0.21 m from the truth · spread ... · 1 mode · effective sample size 60 of 100 particles": what a step says of the
/// filter's belief, without what the run does not know.
[[nodiscard]] std::string belief_words(const RunStep& step);

}  // namespace nadir
