// SPDX-License-Identifier: Apache-2.0
// Every topview at its pose over the overhead: by the odometry, by the estimate, by the truth (thesis 4-12, 4-13).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/map/class_statistics.h"
#include "core/map/overhead_map_file.h"
#include "widgets/figures/chart_panel.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/reconstruction_side.h"
#include "widgets/figures/run_lines.h"
#include "widgets/figures/run_on_map.h"
#include "widgets/figures/timed_figure.h"

namespace nadir {
namespace {

const char* name_of(Source source) {
  constexpr std::array<const char*, 3> kNames = {"truth", "odometry", "estimate"};
  return kNames.at(static_cast<std::size_t>(source));
}

class Reconstruction : public TimedFigure {
 public:
  Reconstruction(std::vector<std::unique_ptr<ReconstructionSide>> sides,
                 double seen_cell_m,
                 OverheadMap labels,
                 FigureInputs inputs)
      : TimedFigure(std::move(inputs)),
        sides_(std::move(sides)),
        seen_cell_m_(seen_cell_m),
        labels_(std::move(labels)),
        held_(class_statistics(labels_.labels)) {
    for (const auto& side : sides_) include_run(side->map(), run());
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    if (auto added = add_up_to(index()); !added) return added;
    const PageFormat& format = context.format();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest,
              fmt::format("{} topview{}, the class with most votes per cell{} · {}", topviews_,
                          topviews_ == 1 ? "" : "s", coarseness(), foot_of(run())));
    draw_page_legend(canvas, format, rest, legend(format.colours()));
    const std::vector<PageRect> panels = arranged(rest, format);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (auto drawn = draw_side(canvas, context, panels[i], i); !drawn) return drawn;
    }
    PageRect last = panels.back();
    if (!least_chart(format).fits_in(last)) return {};
    const std::vector<CaptionedChart> charts = {
        {fmt::format("({}) cells that disagree with the map", letter(sides_.size())),
         disagreement(format.colours())}};
    if (charts.front().chart.bars->groups.empty()) {
      draw_caption(canvas, format, last, charts.front().caption);
      draw_message(canvas, format, last,
                   unlike_.value_or("no cell seen lies on ground that the map knows"));
    } else {
      draw_charts(canvas, format, last, charts, 1);
    }
    return {};
  }

 private:
  /// " of 0.5 m" where cells are larger than what was seen; a run has one size of topview cells.
  [[nodiscard]] std::string coarseness() const {
    const double cell_m = sides_.front()->metres_per_cell();
    return cell_m > seen_cell_m_ ? fmt::format(" of {} m", cell_m) : std::string();
  }

  static char letter(std::size_t panel) { return static_cast<char>('a' + panel); }

  /// Two panels in each row, or one where the page is narrow; the chart is the last one.
  [[nodiscard]] std::vector<PageRect> arranged(const PageRect& whole,
                                               const PageFormat& format) const {
    const double gap = kGapPt * format.px_per_pt();
    const std::size_t count = sides_.size() + 1;
    constexpr double kBesidePt = 200.0;
    if (whole.width < kBesidePt * format.px_per_pt()) {
      return fitting_rows(whole, std::vector<double>(count, 1.0), gap, least_map(format));
    }
    std::vector<PageRect> panels;
    const auto strips =
        fitting_rows(whole, std::vector<double>((count + 1) / 2, 1.0), gap, least_map(format));
    for (const PageRect& strip : strips) {
      const bool is_alone = panels.size() + 1 == count;
      for (const PageRect& panel :
           columns(strip, std::vector<double>(is_alone ? 1 : 2, 1.0), gap)) {
        panels.push_back(panel);
      }
    }
    return panels;
  }

  Result<void> draw_side(Canvas& canvas,
                         FigureContext& context,
                         PageRect panel,
                         std::size_t number) {
    const PageFormat& format = context.format();
    if (!least_map(format).fits_in(panel)) return {};
    ReconstructionSide& side = *sides_.at(number);
    draw_caption(canvas, format, panel,
                 fmt::format("({}) topviews by {}", letter(number), name_of(side.source())));
    const auto frame = side.map().draw_ground(canvas, context, panel);
    if (!frame) return forward_error(frame);
    canvas.push_clip(frame->where);
    for (const Source line : {Source::kTruth, side.source()}) {
      if (!options().layers.has(layer_of(line))) continue;
      std::vector<Eigen::Vector2d> path = path_of(run(), line);
      path.resize(added_);
      PathLook look = look_of(line, format.colours());
      look.width_pt = 0.7;  // what was seen beside the path is narrow on a large map
      look.casing_pt = 0.25;
      draw_path(canvas, *frame, path, look);
      if (line == side.source()) break;
    }
    canvas.pop_clip();
    side.map().draw_furniture(canvas, format, *frame);
    return {};
  }

  /// Films go forward, so only what is new is read; going back begins again.
  Result<void> add_up_to(std::size_t last) {
    const std::size_t wanted = last + 1;
    if (wanted < added_) {
      added_ = 0;
      topviews_ = 0;
      for (const auto& side : sides_) side->clear();
    }
    for (; added_ < wanted; ++added_) {
      const auto step = run().reader->step(run().steps[added_].step);
      if (!step) return forward_error(step);
      if (step->topview) {
        ++topviews_;
        unlike_ = unlike_cells(*step->topview, labels_);
      }
      for (const auto& side : sides_) {
        auto added = side->add(*step, labels_);
        if (!added) return forward_error(added, run().path.string());
      }
    }
    for (const auto& side : sides_) {
      if (auto refreshed = side->refresh(); !refreshed) return refreshed;
    }
    return {};
  }

  /// Share of the cells seen of each class that the map contradicts, for each source of poses.
  [[nodiscard]] ChartSpec disagreement(const Theme& theme) const {
    ChartSpec spec;
    spec.y = {"disagreeing [%]", 0.0, 100.0};
    BarsSpec bars;
    const std::vector<ClassId> classes = classes_known();
    for (const ClassId id : classes) bars.groups.emplace_back(class_info(id).name);
    for (const auto& side : sides_) {
      BarsSpec::Series series{std::string("poses of ") + name_of(side->source()),
                              {},
                              bar_colour(side->source(), theme)};
      for (const ClassId id : classes) {
        const auto agreeing = side->counts().at(id).share();
        series.heights.push_back(agreeing ? 100.0 * (1.0 - *agreeing) : std::nan(""));
      }
      bars.series.push_back(std::move(series));
    }
    spec.bars = std::move(bars);
    return spec;
  }

  /// Classes that the map holds and some topview saw on ground that it knows: the others always disagree.
  [[nodiscard]] std::vector<ClassId> classes_known() const {
    std::vector<ClassId> classes;
    for (ClassId id = 0; id < kClassCount; ++id) {
      if (held_.cells.at(id) == 0) continue;
      for (const auto& side : sides_) {
        if (!side->counts().at(id).share()) continue;
        classes.push_back(id);
        break;
      }
    }
    return classes;
  }

  static Rgba bar_colour(Source source, const Theme& theme) {
    if (source == Source::kOdometry) return theme.odometry;
    return source == Source::kEstimate ? theme.estimate : theme.muted;
  }

  [[nodiscard]] std::vector<LegendEntry> legend(const Theme& theme) const {
    std::vector<LegendEntry> entries = source_legend(run(), options(), theme);
    const ReconstructionSide::ClassCounts& counts = sides_.front()->counts();
    for (ClassId id = 0; id < kClassCount; ++id) {
      const CellAgreement::Count& count = counts.at(id);
      if (count.agreeing + count.disagreeing + count.unknown == 0) continue;
      entries.push_back(legible_entry(
          {std::string(class_info(id).name), class_colour(id), LegendEntry::Kind::kBar}, theme));
    }
    for (const auto& side : sides_) {
      entries.push_back({std::string("poses of ") + name_of(side->source()),
                         bar_colour(side->source(), theme), LegendEntry::Kind::kBar});
    }
    return entries;
  }

  static constexpr double kGapPt = 10.0;
  std::vector<std::unique_ptr<ReconstructionSide>> sides_;
  double seen_cell_m_;
  std::optional<std::string> unlike_;  ///< Why cells were not compared with the map.
  OverheadMap labels_;
  ClassStatistics held_;      ///< By the map.
  std::size_t added_ = 0;     ///< Steps that the sides hold.
  std::size_t topviews_ = 0;  ///< Of these steps.
};

}  // namespace

Result<std::unique_ptr<Figure>> make_reconstruction(FigureInputs inputs) {
  const FigureRun& run = inputs.runs.front();
  std::optional<double> metres_per_cell;
  for (std::size_t i = 0; i < run.steps.size() && !metres_per_cell; ++i) {
    const auto step = run.reader->step(run.steps[i].step);
    if (!step) return forward_error(step);
    if (step->topview) metres_per_cell = step->topview->metres_per_cell;
  }
  if (!metres_per_cell) {
    return fail(ErrorCode::kMalformed, "{}: holds no topviews, which figure 'reconstruction' needs",
                run.path.string());
  }
  auto labels = read_overhead_map(inputs.map);
  if (!labels) return forward_error(labels);
  constexpr std::array kSources = {Source::kOdometry, Source::kEstimate, Source::kTruth};
  PoseReach reach;
  for (const RunStep& step : run.steps) {
    for (const Source source : kSources) {
      if (const auto pose = pose_of(step, source)) reach.include(pose->translation_m());
    }
  }
  const double cell_m = reconstruction_cell_m(reach, *metres_per_cell);
  std::vector<std::unique_ptr<ReconstructionSide>> sides;
  for (const Source source : kSources) {
    const bool is_known =
        std::any_of(run.steps.begin(), run.steps.end(),
                    [source](const RunStep& step) { return pose_of(step, source).has_value(); });
    if (!is_known && source != Source::kEstimate) continue;
    auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
    if (!panel) return forward_error(panel);
    sides.push_back(std::make_unique<ReconstructionSide>(std::move(*panel), source, cell_m));
  }
  return std::make_unique<Reconstruction>(std::move(sides), *metres_per_cell, std::move(*labels),
                                          std::move(inputs));
}

}  // namespace nadir
