// SPDX-License-Identifier: Apache-2.0
#include "core/session/view_state.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace nadir {
namespace {

double in_range(double value, double least, double most, double otherwise) {
  return std::isfinite(value) ? std::clamp(value, least, most) : otherwise;
}

/// Brings a column's tab to one that is shown, where any is.
void repair_tab(const WindowLayout& layout, Column column, Panel& tab) {
  if (column_of(tab) == column && layout.shows(tab)) return;
  for (std::size_t i = 0; i < kPanelCount; ++i) {
    const auto panel = static_cast<Panel>(i);
    if (column_of(panel) != column || !layout.shows(panel)) continue;
    tab = panel;
    return;
  }
  if (column_of(tab) != column) tab = column == Column::kLeft ? Panel::kLayers : Panel::kMoment;
}

/// Each element once and in its place, what is missing at the end.
template <typename Element, typename Key>
std::vector<Element> each_once(const std::vector<Element>& given,
                               const std::vector<Element>& all,
                               Key key) {
  std::vector<Element> result;
  const auto add = [&](const Element& element) {
    const bool is_there = std::any_of(result.begin(), result.end(), [&](const Element& other) {
      return key(other) == key(element);
    });
    if (!is_there) result.push_back(element);
  };
  for (const Element& element : given) add(element);
  for (const Element& element : all) add(element);
  return result;
}

void repair_map(MapLook& map) {
  const MapLook normal = default_map_look();
  if (!map.centre_in_enu_m.allFinite()) map.centre_in_enu_m.setZero();
  if (!(map.width_m > 0.0) || !std::isfinite(map.width_m)) {
    map.width_m = 0.0;
  } else {
    map.width_m = std::clamp(map.width_m, kLeastMapWidthM, kMostMapWidthM);
  }
  if (!std::isfinite(map.up_rad)) map.up_rad = normal.up_rad;
  std::erase_if(map.measured_in_enu_m,
                [](const Eigen::Vector2d& point) { return !point.allFinite(); });
  for (std::size_t i = 0; i < kLayerCount; ++i) {
    LayerLook& look = map.layers.at(i);
    look.opacity = in_range(look.opacity, 0.0, 1.0, normal.layers.at(i).opacity);
    if (look.colour && !is_colour_text(*look.colour)) look.colour.reset();
  }
  map.order = each_once(map.order, normal.order, [](Layer layer) { return layer; });
  // The legend is no part of the ground: nothing lies on it.
  std::stable_partition(map.order.begin(), map.order.end(),
                        [](Layer layer) { return layer != Layer::kLegend; });
}

}  // namespace

bool is_colour_text(std::string_view text) {
  return text.size() == 7 && text.front() == '#' &&
         std::all_of(text.begin() + 1, text.end(),
                     [](unsigned char letter) { return std::isxdigit(letter) != 0; });
}

std::optional<Column> column_of(Panel panel) {
  switch (panel) {
    case Panel::kLayers:
    case Panel::kRuns:
    case Panel::kBookmarks:
    case Panel::kLog:
      return Column::kLeft;
    case Panel::kMoment:
    case Panel::kWhy:
    case Panel::kSettings:
    case Panel::kScene:
    case Panel::kTopview:
    case Panel::kCamera:
      return Column::kRight;
    case Panel::kTimeline:
    case Panel::kStatus:
      break;
  }
  return std::nullopt;
}

MapLook default_map_look() {
  MapLook map;
  for (std::size_t i = 0; i < kLayerCount; ++i) map.order.push_back(static_cast<Layer>(i));
  for (const Layer hidden : {Layer::kLabels, Layer::kReconstruction, Layer::kErrorSurface,
                             Layer::kDisagreement, Layer::kGraticule}) {
    map.layer(hidden).is_visible = false;
  }
  // What lies on the picture lets it be seen.
  map.layer(Layer::kLabels).opacity = 0.5;
  map.layer(Layer::kReconstruction).opacity = 0.8;
  map.layer(Layer::kErrorSurface).opacity = 0.7;
  map.layer(Layer::kTopview).opacity = 0.8;
  map.layer(Layer::kDisagreement).opacity = 0.8;
  return map;
}

WindowLayout default_layout() {
  WindowLayout layout;
  layout.is_shown.fill(true);
  for (const Panel hidden : {Panel::kScene, Panel::kTopview, Panel::kCamera, Panel::kLog}) {
    layout.is_shown.at(static_cast<std::size_t>(hidden)) = false;
  }
  for (std::size_t i = 0; i < kStripCount; ++i) {
    const auto strip = static_cast<Strip>(i);
    const bool is_visible = strip == Strip::kPositionError || strip == Strip::kSigma ||
                            strip == Strip::kAgreement || strip == Strip::kNees;
    layout.strips.push_back({strip, is_visible, 35.0});
  }
  return layout;
}

ViewState default_view_state() {
  ViewState view;
  view.map = default_map_look();
  view.layout = default_layout();
  return view;
}

WindowLayout repaired(WindowLayout layout) {
  const WindowLayout normal = default_layout();
  layout.left_pt = in_range(layout.left_pt, kLeastColumnPt, kMostColumnPt, normal.left_pt);
  layout.right_pt = in_range(layout.right_pt, kLeastColumnPt, kMostColumnPt, normal.right_pt);
  layout.timeline_pt =
      in_range(layout.timeline_pt, kLeastTimelinePt, kMostTimelinePt, normal.timeline_pt);
  layout.strips =
      each_once(layout.strips, normal.strips, [](const StripLook& look) { return look.strip; });
  for (StripLook& look : layout.strips) {
    look.height_pt = in_range(look.height_pt, kLeastStripPt, kMostStripPt, StripLook{}.height_pt);
  }
  repair_tab(layout, Column::kLeft, layout.left_tab);
  repair_tab(layout, Column::kRight, layout.right_tab);
  return layout;
}

ViewState repaired(ViewState view) {
  repair_map(view.map);
  view.layout = repaired(std::move(view.layout));
  Appearance& appearance = view.appearance;
  if (appearance.scale != 0.0) {
    appearance.scale = in_range(appearance.scale, kLeastScale, kMostScale, 0.0);
  }
  std::set<std::string> paths;
  std::erase_if(view.runs, [&paths](const RunLook& run) {
    return run.path.empty() || !paths.insert(run.path).second;
  });
  for (RunLook& run : view.runs) run.colour = std::max(run.colour, 0);
  const int count = static_cast<int>(view.runs.size());
  view.active_run = std::clamp(view.active_run, std::min(count, 1), count);
  if (view.selected_particle && *view.selected_particle < 0) view.selected_particle.reset();
  if (count < 2) view.map.is_split = false;
  return view;
}

}  // namespace nadir
