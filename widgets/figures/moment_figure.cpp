// SPDX-License-Identifier: Apache-2.0
// One instant of a run: what the filter knew, what the camera saw, and how that fits the map.
#include <fmt/format.h>

#include <algorithm>

#include "core/map/overhead_map_file.h"
#include "widgets/figures/chart_panel.h"
#include "widgets/figures/moment_map.h"
#include "widgets/figures/moment_panels.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"
#include "widgets/figures/run_on_map.h"
#include "widgets/figures/timed_figure.h"
#include "widgets/views/agreement_view.h"

namespace nadir {
namespace {

constexpr double kGapPt = 10.0;

class MomentFigure : public TimedFigure {
 public:
  MomentFigure(std::unique_ptr<MomentMap> map, OverheadMap labels, FigureInputs inputs)
      : TimedFigure(std::move(inputs)),
        map_(std::move(map)),
        labels_(std::move(labels)),
        camera_(run()) {}

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    if (theme_ != format.theme) step_.reset();  // what is laid on the map has the theme's colours
    theme_ = format.theme;
    if (auto read = read_shown_step(); !read) return read;
    const RunStep& step = *step_;
    const double px = format.px_per_pt();
    const auto bars = agreement_ ? agreement_bars(*agreement_, format.colours(),
                                                  map_->run_colour(format.colours()))
                                 : std::optional<ChartSpec>();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, words(step));
    draw_page_legend(canvas, format, rest, legend(format.colours(), step, bars.has_value()));
    constexpr double kBesidePt = 320.0;
    const bool is_wide = rest.width >= kBesidePt * px;
    constexpr double kBarsPt = 80.0;  // with the names of classes below
    PageRect bottom =
        take_bottom(rest, std::min(0.35 * rest.height, std::max(0.22 * rest.height, kBarsPt * px)),
                    kGapPt * px);
    if (is_wide) {
      auto sides = columns(rest, {1.25, 1.0}, 12.0 * px);
      if (auto drawn = draw_map(canvas, context, sides[0], step); !drawn) return drawn;
      draw_seen(canvas, format, sides[1], step);
    } else {
      auto parts = fitting_rows(rest, {1.0, 1.0}, kGapPt * px, least_map(format));
      if (auto drawn = draw_map(canvas, context, parts[0], step); !drawn) return drawn;
      draw_seen(canvas, format, parts[1], step);
    }
    draw_bars(canvas, format, bottom, bars);
    return {};
  }

 private:
  /// Reads the step that is shown and lays it on the map, once for all frames of a film that show it.
  Result<void> read_shown_step() {
    if (step_ && shown_index_ == index()) return {};
    auto step = read_step();
    if (!step) return forward_error(step);
    step_ = std::move(*step);
    shown_index_ = index();
    agreement_ = moment_agreement(*step_, labels_);
    classes_ = patch_legend(*step_, labels_, theme(theme_));
    bars_.reset();
    map_->show(*step_, labels_, theme(theme_));
    return {};
  }

  Result<void> draw_map(Canvas& canvas,
                        FigureContext& context,
                        PageRect panel,
                        const RunStep& step) {
    const PageFormat& format = context.format();
    if (!least_map(format).fits_in(panel)) return {};
    draw_caption(canvas, format, panel, "(a) over the overhead");
    return map_->draw(canvas, context, panel, run(), index() + 1, step);
  }

  /// The camera's picture above the topview and what the map has in its place.
  void draw_seen(Canvas& canvas,
                 const PageFormat& format,
                 const PageRect& panel,
                 const RunStep& step) {
    if (!least_picture(format).fits_in(panel)) return;
    auto parts = fitting_rows(panel, {1.2, 1.0}, 8.0 * format.px_per_pt(), least_picture(format));
    draw_caption(canvas, format, parts[0], "(b) camera");
    const auto picture = camera_.at(step.time_s);
    if (picture) {
      canvas.image(fitted((*picture)->width(), (*picture)->height(), parts[0]), **picture);
    } else {
      draw_message(canvas, format, parts[0], picture.error().message);
    }
    draw_patches(canvas, format, parts[1], step, labels_, agreement_);
  }

  void draw_bars(Canvas& canvas,
                 const PageFormat& format,
                 PageRect panel,
                 const std::optional<ChartSpec>& bars) {
    if (!least_chart(format).fits_in(panel)) return;
    const std::string caption = "(g) cells that agree with the map, by class seen";
    if (!bars) {
      draw_caption(canvas, format, panel, caption);
      const auto unlike = step_->topview ? unlike_cells(*step_->topview, labels_) : std::nullopt;
      draw_message(canvas, format, panel,
                   unlike.value_or("no cell of the topview lies on ground that the map knows"));
      return;
    }
    if (!bars_) bars_.emplace(std::vector<CaptionedChart>{{caption, *bars}}, 1);
    bars_->draw(canvas, format, panel);
  }

  [[nodiscard]] std::vector<LegendEntry> legend(const Theme& theme,
                                                const RunStep& step,
                                                bool has_bars) const {
    std::vector<LegendEntry> entries = source_legend(run(), options(), theme);
    for (LegendEntry& entry : entries) {
      const Layer layer = entry.name == "truth"      ? Layer::kTruth
                          : entry.name == "estimate" ? Layer::kEstimate
                                                     : Layer::kOdometry;
      const PathLook look = map_->line_look(layer, theme);
      entry.colour = look.colour;
      entry.casing = look.casing;
    }
    const auto has_ellipses = [](const PoseMode& mode) {
      return mode.moments.covariance.topLeftCorner<2, 2>().allFinite();
    };
    const std::span<const PoseMode> modes = map_->shown_modes(step);
    if (options().layers.has(FigureLayer::kEllipses) &&
        std::any_of(modes.begin(), modes.end(), has_ellipses)) {
      entries.push_back(ellipse_legend("ellipses: 1, 2 and 3 sigma", 1, theme));
      const PathLook look = map_->line_look(Layer::kEllipses, theme);
      entries.back().colour = look.colour;
      entries.back().casing = look.casing;
    }
    if (map_->shows_particles(step)) entries.push_back(particle_legend());
    entries.insert(entries.end(), classes_.begin(), classes_.end());
    if (agreement_) {
      for (const LegendEntry& entry : agreement_legend(agreement_->at_estimate, theme)) {
        entries.push_back(entry);
      }
    }
    if (has_bars) {
      entries.push_back({"share at estimate", map_->run_colour(theme), LegendEntry::Kind::kBar});
      if (agreement_->at_truth) {
        entries.push_back({"at truth", theme.muted, LegendEntry::Kind::kBar});
      }
    }
    return entries;
  }

  [[nodiscard]] std::string words(const RunStep& step) const {
    const std::string missing = not_in_moment(options().stack);
    return fmt::format(
        "{:.1f} s after the start{} · {}{}", run().elapsed_s(step), belief_words(step),
        missing.empty() ? "" : fmt::format("the map is without {} · ", missing), foot_of(run()));
  }

  std::unique_ptr<MomentMap> map_;
  OverheadMap labels_;
  CameraPictures camera_;
  std::optional<RunStep> step_;  ///< The one of shown_index_, as it lies on the map.
  std::size_t shown_index_ = 0;
  std::optional<MomentAgreement> agreement_;
  std::vector<LegendEntry> classes_;
  std::optional<ChartGrid> bars_;  ///< Of the step and this theme.
  ThemeName theme_ = ThemeName::kLight;
};

}  // namespace

Result<std::unique_ptr<Figure>> make_moment(FigureInputs inputs) {
  auto labels = read_overhead_map(inputs.map);
  if (!labels) return forward_error(labels);
  inputs.options = with_stack_applied(std::move(inputs.options));
  auto map = MomentMap::create(inputs.map, inputs.options);
  if (!map) return forward_error(map);
  return std::make_unique<MomentFigure>(std::move(*map), std::move(*labels), std::move(inputs));
}

}  // namespace nadir
