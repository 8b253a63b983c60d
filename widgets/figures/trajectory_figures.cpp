// SPDX-License-Identifier: Apache-2.0
// Figures of runs over the overhead: trajectories.
#include "widgets/figures/figures.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"

namespace nadir {
namespace {

class Trajectories : public Figure {
 public:
  Trajectories(std::unique_ptr<MapPanel> map, FigureInputs inputs)
      : map_(std::move(map)), inputs_(std::move(inputs)) {
    for (const FigureRun& run : inputs_.runs) include_run(*map_, run);
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, foot_of_all(inputs_.runs));
    draw_page_legend(canvas, format, rest, run_legend(inputs_.runs, format.colours()));
    const auto frame = map_->draw_ground(canvas, context, rest);
    if (!frame) return forward_error(frame);
    canvas.push_clip(frame->where);
    draw_runs(canvas, *frame, inputs_.runs, inputs_.options, time_s_, format.colours());
    canvas.pop_clip();
    map_->draw_furniture(canvas, format, *frame);
    return {};
  }

  [[nodiscard]] std::optional<FigureTimes> times() const override { return times_of(inputs_.runs); }
  void show_at(double time_s) override { time_s_ = time_s; }

 private:
  std::unique_ptr<MapPanel> map_;
  FigureInputs inputs_;
  double time_s_ = 1e9;  ///< The whole flight, unless a film asks for less.
};

}  // namespace

Result<std::unique_ptr<Figure>> make_trajectories(FigureInputs inputs) {
  auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
  if (!panel) return forward_error(panel);
  return std::make_unique<Trajectories>(std::move(*panel), std::move(inputs));
}

}  // namespace nadir
