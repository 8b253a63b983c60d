// SPDX-License-Identifier: Apache-2.0
// Figures of a map alone: overhead-pair, labels.
#include <fmt/format.h>

#include <algorithm>

#include "core/map/class_statistics.h"
#include "core/map/overhead_map_file.h"
#include "widgets/figures/figure_sources.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/map_panel.h"
#include "widgets/figures/page_layout.h"

namespace nadir {
namespace {

/// Classes that a map holds, by falling share, with the share in words; then what has no class.
std::vector<LegendEntry> class_legend(const OverheadMap& map, bool with_shares) {
  const ClassStatistics statistics = class_statistics(map.labels);
  std::vector<ClassId> ids;
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (statistics.cells[id] > 0) ids.push_back(id);
  }
  std::sort(ids.begin(), ids.end(), [&](ClassId a, ClassId b) {
    return statistics.cells[a] != statistics.cells[b] ? statistics.cells[a] > statistics.cells[b]
                                                      : a < b;
  });
  std::vector<LegendEntry> entries;
  for (const ClassId id : ids) {
    std::string name(class_info(id).name);
    if (with_shares) name += fmt::format(" {:.1f} %", 100.0 * statistics.share_of_all(id));
    entries.push_back({name, class_colour(id), LegendEntry::Kind::kBar});
  }
  const std::int64_t rest = statistics.all_cells - statistics.classified_cells;
  if (rest > 0) {
    std::string name = "unclassified";
    if (with_shares) {
      name += fmt::format(" {:.1f} %", 100.0 * static_cast<double>(rest) /
                                           static_cast<double>(statistics.all_cells));
    }
    entries.push_back({name, class_colour(kUnclassified), LegendEntry::Kind::kOutlinedBar});
  }
  return entries;
}

/// Cells without a class are not drawn, so that the page is seen: their sample is of its colour. Classes can be told from it.
std::vector<LegendEntry> on_page(std::vector<LegendEntry> entries, const PageFormat& format) {
  for (LegendEntry& entry : entries) {
    if (entry.kind != LegendEntry::Kind::kOutlinedBar) {
      entry = legible_entry(std::move(entry), format.colours());
      continue;
    }
    if (!format.is_transparent) entry.colour = format.colours().page;
    entry.casing = format.colours().muted;
  }
  return entries;
}

std::string provenance_text(const MapProvenance& provenance) {
  std::string text = provenance.name;
  if (!provenance.date.empty()) text += " · " + provenance.date;
  if (!provenance.licence.empty()) text += " · " + provenance.licence;
  return text;
}

/// Picture and labels side by side; the labels alone where there is no picture to be shown.
class OverheadPair : public Figure {
 public:
  OverheadPair(std::unique_ptr<MapPanel> picture,
               std::unique_ptr<MapPanel> labels,
               std::vector<LegendEntry> legend,
               std::string foot)
      : picture_(std::move(picture)),
        labels_(std::move(labels)),
        legend_(std::move(legend)),
        foot_(std::move(foot)) {
    picture_->include_map();
    labels_->include_map();
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, foot_);
    draw_page_legend(canvas, format, rest, on_page(legend_, format));
    if (!picture_->shows_picture()) return draw_panel(canvas, context, *labels_, "", rest);
    const std::vector<PageRect> panels = arranged(rest, format);
    auto drawn = draw_panel(canvas, context, *picture_, "(a) overhead picture", panels[0]);
    if (drawn) drawn = draw_panel(canvas, context, *labels_, "(b) labels", panels[1]);
    return drawn;
  }

 private:
  static Result<void> draw_panel(Canvas& canvas,
                                 FigureContext& context,
                                 MapPanel& map,
                                 const std::string& caption,
                                 const PageRect& whole) {
    const PageFormat& format = context.format();
    if (!least_map(format).fits_in(whole)) return {};
    const double above_px = caption.empty() ? 0.0 : kCaptionPt * format.px_per_pt();
    PageRect panel = map.part_filled(whole, above_px, format);
    if (!caption.empty()) draw_caption(canvas, format, panel, caption);
    const auto frame = map.draw_ground(canvas, context, panel);
    if (!frame) return forward_error(frame);
    map.draw_furniture(canvas, format, *frame);
    return {};
  }

  /// Beside or below each other, whichever shows the map larger.
  [[nodiscard]] std::vector<PageRect> arranged(const PageRect& whole,
                                               const PageFormat& format) const {
    const double gap = 10.0 * format.px_per_pt();
    const Eigen::Vector2d size_m = picture_->map_bounds_in_enu_m().sizes();
    const auto scale_in = [&size_m](const std::vector<PageRect>& panels) {
      return std::min(panels[0].width / size_m.x(), panels[0].height / size_m.y());
    };
    auto beside = fitting_columns(whole, {1.0, 1.0}, gap, least_map(format));
    auto below = fitting_rows(whole, {1.0, 1.0}, gap, least_map(format));
    const bool has_both_beside = beside[1].width > 0.0;
    const bool has_both_below = below[1].width > 0.0;
    if (has_both_beside != has_both_below) return has_both_beside ? beside : below;
    return scale_in(beside) >= scale_in(below) ? beside : below;
  }

  std::unique_ptr<MapPanel> picture_, labels_;
  std::vector<LegendEntry> legend_;
  std::string foot_;
};

class LabelsFigure : public Figure {
 public:
  LabelsFigure(std::unique_ptr<MapPanel> map, std::vector<LegendEntry> legend, std::string foot)
      : map_(std::move(map)), legend_(std::move(legend)), foot_(std::move(foot)) {
    map_->include_map();
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, foot_);
    draw_page_legend(canvas, format, rest, on_page(legend_, format));
    if (!least_map(format).fits_in(rest)) return {};
    const auto frame = map_->draw_ground(canvas, context, map_->part_filled(rest, 0.0, format));
    if (!frame) return forward_error(frame);
    map_->draw_furniture(canvas, format, *frame);
    return {};
  }

 private:
  std::unique_ptr<MapPanel> map_;
  std::vector<LegendEntry> legend_;
  std::string foot_;
};

}  // namespace

Result<std::unique_ptr<Figure>> make_overhead_pair(
    FigureInputs inputs) {  // NOLINT(performance-unnecessary-value-param): as all
  const auto map = read_overhead_map(inputs.map);
  if (!map) return forward_error(map);
  const auto provenance = read_map_provenance(inputs.map);
  if (!provenance) return forward_error(provenance);
  auto picture = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
  if (!picture) return forward_error(picture);
  auto labels = MapPanel::create(inputs.map, MapPanel::Ground::kLabels, inputs.options);
  if (!labels) return forward_error(labels);
  std::string foot = provenance_text(*provenance);
  if (!(*picture)->shows_picture()) {
    const bool is_wanted = inputs.options.layers.has(FigureLayer::kPicture);
    foot += is_wanted ? " · the map has no picture" : " · without its picture, as asked";
  }
  return std::make_unique<OverheadPair>(std::move(*picture), std::move(*labels),
                                        class_legend(*map, false), foot);
}

Result<std::unique_ptr<Figure>> make_labels(
    FigureInputs inputs) {  // NOLINT(performance-unnecessary-value-param): as all
  const auto map = read_overhead_map(inputs.map);
  if (!map) return forward_error(map);
  const auto provenance = read_map_provenance(inputs.map);
  if (!provenance) return forward_error(provenance);
  auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kLabels, inputs.options);
  if (!panel) return forward_error(panel);
  const std::string shares = inputs.options.crop.is_all()
                                 ? " · share of all cells"
                                 : " · shares are of the whole map, not of the part shown";
  return std::make_unique<LabelsFigure>(std::move(*panel), class_legend(*map, true),
                                        provenance_text(*provenance) + shares);
}

}  // namespace nadir
