// SPDX-License-Identifier: Apache-2.0
// Figures of runs over the overhead: trajectories.
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"
#include "widgets/figures/timed_figure.h"

namespace nadir {
namespace {

class Trajectories : public TimedFigure {
 public:
  Trajectories(std::unique_ptr<MapPanel> map, FigureInputs inputs)
      : TimedFigure(std::move(inputs)), map_(std::move(map)) {
    for (const FigureRun& each : runs()) include_run(*map_, each);
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    const Theme& theme = format.colours();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, foot_of_all(runs()));
    draw_page_legend(canvas, format, rest, run_legend(runs(), options(), theme));
    if (!least_map(format).fits_in(rest)) return {};
    const auto frame = map_->draw_ground(canvas, context, rest);
    if (!frame) return forward_error(frame);
    canvas.push_clip(frame->where);
    draw_runs(canvas, *frame, runs(), options(), time_s(), theme);
    canvas.pop_clip();
    map_->draw_furniture(canvas, format, *frame);
    return {};
  }

 private:
  std::unique_ptr<MapPanel> map_;
};

}  // namespace

Result<std::unique_ptr<Figure>> make_trajectories(FigureInputs inputs) {
  auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
  if (!panel) return forward_error(panel);
  return std::make_unique<Trajectories>(std::move(*panel), std::move(inputs));
}

}  // namespace nadir
