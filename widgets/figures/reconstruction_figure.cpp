// SPDX-License-Identifier: Apache-2.0
// Every topview at its pose over the overhead, once by the odometry and once by the estimate (thesis 4-12, 4-13).
#include <fmt/format.h>

#include "core/topview/semantic_reconstruction.h"
#include "widgets/figures/class_pictures.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"
#include "widgets/views/raster_view.h"

namespace nadir {
namespace {

/// One side of the figure: a map with what has been seen so far laid on it.
class Side {
 public:
  Side(std::unique_ptr<MapPanel> map, Source source, double metres_per_cell)
      : map_(std::move(map)),
        source_(source),
        seen_(metres_per_cell),
        view_(map_->scene(), MapLayer::kReconstruction) {
    view_.set_visible(false);
  }

  void clear() { seen_ = SemanticReconstruction(seen_.metres_per_cell()); }

  void add(const RunStep& step) {
    const auto pose = pose_of(step, source_);
    if (pose && step.topview) seen_.add(*step.topview, *pose);
  }

  /// Uploads what has been added. @errors as SemanticReconstruction::labels.
  Result<void> refresh() {
    view_.set_visible(!seen_.empty());
    if (seen_.empty()) return {};
    const auto labels = seen_.labels();
    if (!labels) return forward_error(labels);
    const Eigen::Vector2d corner = seen_.top_left_in_enu_m();
    view_.show(class_picture(*labels), {corner.x(), corner.y(), 0.0},
               Eigen::Vector2d::Constant(seen_.metres_per_cell()), false);
    return {};
  }

  [[nodiscard]] MapPanel& map() { return *map_; }
  [[nodiscard]] Source source() const { return source_; }

 private:
  std::unique_ptr<MapPanel> map_;  ///< Before the view, which lies in its scene.
  Source source_;
  SemanticReconstruction seen_;
  RasterView view_;
};

class Reconstruction : public Figure {
 public:
  Reconstruction(std::unique_ptr<Side> odometry,
                 std::unique_ptr<Side> estimate,
                 FigureInputs inputs)
      : sides_{std::move(odometry), std::move(estimate)}, inputs_(std::move(inputs)) {
    for (const auto& side : sides_) include_run(side->map(), run());
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    if (auto added = add_up_to(run().index_at(time_s_)); !added) return added;
    const PageFormat& format = context.format();
    const Theme& theme = format.colours();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest,
              fmt::format("{} topviews, the class with most votes per cell · {}", shown_,
                          foot_of(run())));
    std::vector<LegendEntry> legend = run_legend(inputs_.runs, theme);
    legend.back().name = "estimate";
    draw_page_legend(canvas, format, rest, legend);
    auto panels = columns(rest, {1.0, 1.0}, 10.0 * format.px_per_pt());
    draw_caption(canvas, format, panels[0], "(a) topviews at the odometry's poses");
    draw_caption(canvas, format, panels[1], "(b) topviews at the estimated poses");
    for (std::size_t i = 0; i < 2; ++i) {
      const auto frame = sides_.at(i)->map().draw_ground(canvas, context, panels[i]);
      if (!frame) return forward_error(frame);
      draw_lines(canvas, *frame, sides_.at(i)->source(), theme);
      sides_.at(i)->map().draw_furniture(canvas, format, *frame);
    }
    return {};
  }

  [[nodiscard]] std::optional<FigureTimes> times() const override { return times_of(inputs_.runs); }
  void show_at(double time_s) override { time_s_ = time_s; }

 private:
  [[nodiscard]] const FigureRun& run() const { return inputs_.runs.front(); }

  /// Films go forward, so only what is new is read; going back begins again.
  Result<void> add_up_to(std::size_t last) {
    const std::size_t wanted = last + 1;
    if (wanted < shown_) {
      shown_ = 0;
      for (const auto& side : sides_) side->clear();
    }
    if (wanted == shown_) return {};
    for (; shown_ < wanted; ++shown_) {
      const auto step = run().reader.step(run().steps[shown_].step);
      if (!step) return forward_error(step);
      for (const auto& side : sides_) side->add(*step);
    }
    for (const auto& side : sides_) {
      if (auto refreshed = side->refresh(); !refreshed) return refreshed;
    }
    return {};
  }

  void draw_lines(Canvas& canvas, const MapFrame& frame, Source source, const Theme& theme) const {
    canvas.push_clip(frame.where);
    for (const Source line : {Source::kTruth, source}) {
      std::vector<Eigen::Vector2d> path = path_of(run(), line);
      path.resize(shown_);
      const PathLook look = line == Source::kTruth      ? truth_look(theme)
                            : line == Source::kOdometry ? odometry_look(theme)
                                                        : estimate_look(theme);
      draw_path(canvas, frame, path, look);
    }
    canvas.pop_clip();
  }

  std::array<std::unique_ptr<Side>, 2> sides_;
  FigureInputs inputs_;
  double time_s_ = 1e9;
  std::size_t shown_ = 0;  ///< Steps that the sides hold.
};

}  // namespace

Result<std::unique_ptr<Figure>> make_reconstruction(FigureInputs inputs) {
  const FigureRun& run = inputs.runs.front();
  const auto first = run.reader.step(run.steps.front().step);
  if (!first) return forward_error(first);
  if (!first->topview) {
    return fail(ErrorCode::kMalformed, "{}: holds no topviews, which figure 'reconstruction' needs",
                run.path.string());
  }
  std::array<std::unique_ptr<Side>, 2> sides;
  for (std::size_t i = 0; i < 2; ++i) {
    auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
    if (!panel) return forward_error(panel);
    sides.at(i) =
        std::make_unique<Side>(std::move(*panel), i == 0 ? Source::kOdometry : Source::kEstimate,
                               first->topview->metres_per_cell);
  }
  return std::make_unique<Reconstruction>(std::move(sides[0]), std::move(sides[1]),
                                          std::move(inputs));
}

}  // namespace nadir
