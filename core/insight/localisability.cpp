// SPDX-License-Identifier: Apache-2.0
#include "core/insight/localisability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "core/base/parallel.h"
#include "core/base/require.h"
#include "core/insight/label_ground.h"
#include "core/insight/view_matcher.h"
#include "core/label/label_raster.h"

namespace nadir {
namespace {

constexpr int kTileSide = 8;
constexpr double kMostViews = 10'000'000.0;

int tiles_across(int places) { return (places + kTileSide - 1) / kTileSide; }

/// Places of a tile: columns [left, right), rows [top, bottom).
CellRect places_of(int tile, int columns, int rows) {
  const int across = tiles_across(columns);
  const std::int64_t left = std::int64_t{tile % across} * kTileSide;
  const std::int64_t top = std::int64_t{tile / across} * kTileSide;
  return {left, top, std::min<std::int64_t>(left + kTileSide, columns),
          std::min<std::int64_t>(top + kTileSide, rows)};
}

bool has_tall(const Raster<ClassId>& labels, const CellRect& cells) {
  for (auto row = static_cast<int>(cells.top); row < cells.bottom; ++row) {
    const auto first = labels.row(row).begin();
    if (std::any_of(first + cells.left, first + cells.right,
                    [](ClassId id) { return class_height_m(id) > 0.0; })) {
      return true;
    }
  }
  return false;
}

float measure_of(const ViewInformation& view, LocalisabilityMeasure measure) {
  switch (measure) {
    case LocalisabilityMeasure::kStdMajor:
      return view.std_major_m;
    case LocalisabilityMeasure::kStdMinor:
      return view.std_minor_m;
    case LocalisabilityMeasure::kStdHeading:
      return view.std_heading_rad;
    case LocalisabilityMeasure::kAmbiguity:
      break;
  }
  return view.ambiguity;
}

}  // namespace

LocalisabilityMap::LocalisabilityMap(MatchGround ground,
                                     ViewFootprint footprint,
                                     LocalisabilityOptions options)
    : ground_(std::move(ground)),
      footprint_(std::move(footprint)),
      options_(options),
      columns_(static_cast<int>(std::ceil(ground_.map().width_m() / options_.spacing_m - 1e-9))),
      rows_(static_cast<int>(std::ceil(ground_.map().height_m() / options_.spacing_m - 1e-9))) {
  const auto views = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) *
                     static_cast<std::size_t>(options_.headings);
  views_.resize(views);
  seen_reach_m_.resize(views);
  margin_m_.resize(views);
  forget_all();
}

Result<LocalisabilityMap> LocalisabilityMap::create(OverheadMap map,
                                                    const LocaliserOptions& localiser,
                                                    const LocalisabilityOptions& options) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  auto footprint = ViewFootprint::create(options.camera, options.camera_height_m, options.topview,
                                         map.metres_per_cell);
  if (!footprint) return forward_error(footprint);
  const double views = std::ceil(map.width_m() / options.spacing_m) *
                       std::ceil(map.height_m() / options.spacing_m) * options.headings;
  if (!(views <= kMostViews)) {
    return fail(ErrorCode::kInvalidOptions,
                "map '{}': {:.0f} views are more than {:.0f}; take places farther apart", map.name,
                views, kMostViews);
  }
  auto ground = MatchGround::create(std::move(map), localiser, options.weight_tolerance);
  if (!ground) return forward_error(ground);
  return LocalisabilityMap(std::move(*ground), std::move(*footprint), options);
}

std::size_t LocalisabilityMap::index_of(int column, int row, int heading) const {
  NADIR_REQUIRE(column >= 0 && column < columns_ && row >= 0 && row < rows_ && heading >= 0 &&
                heading < options_.headings);
  return (static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
          static_cast<std::size_t>(column)) *
             static_cast<std::size_t>(options_.headings) +
         static_cast<std::size_t>(heading);
}

Eigen::Vector2d LocalisabilityMap::place_in_enu_m(int column, int row) const {
  return ground_.map().top_left_in_enu_m +
         options_.spacing_m * Eigen::Vector2d(column + 0.5, -row - 0.5);
}

double LocalisabilityMap::heading_rad(int heading) const {
  return wrap_rad(2.0 * std::numbers::pi * heading / options_.headings);
}

void LocalisabilityMap::forget_all() {
  std::fill(seen_reach_m_.begin(), seen_reach_m_.end(), -1.0F);
  missing_ = static_cast<std::int64_t>(views_.size());
}

void LocalisabilityMap::forget(const PlaneBounds& bounds) { forget(bounds, true); }

void LocalisabilityMap::forget(const PlaneBounds& bounds, bool has_tall) {
  const double range_m = has_tall ? footprint_.reach_m() : footprint_.ground_reach_m();
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector2d place = place_in_enu_m(column, row);
      for (int heading = 0; heading < options_.headings; ++heading) {
        const std::size_t view = index_of(column, row, heading);
        const Rigid2 pose{place.x(), place.y(), heading_rad(heading)};
        const double seen_m = static_cast<double>(seen_reach_m_[view]);
        const double margin_m = static_cast<double>(margin_m_[view]) + ground_.reach_m();
        if (!is_known(view) || (!footprint_.may_reach(bounds, pose, range_m, 0.0) &&
                                !footprint_.may_reach(bounds, pose, seen_m, margin_m))) {
          continue;
        }
        seen_reach_m_[view] = -1.0F;
        ++missing_;
      }
    }
  }
}

void LocalisabilityMap::redraw(const LabelDocument& document, const PlaneBounds& changed) {
  const LabelGrid grid = grid_of(ground_.map());
  const CellRect cells = grid.cells_of(changed, 1).cut_to(grid.whole());
  if (!cells.empty()) redraw(cells, rasterise(document, grid, cells));
}

void LocalisabilityMap::redraw(const CellRect& cells, const Raster<ClassId>& labels) {
  const LabelGrid grid = grid_of(ground_.map());
  const CellRect inside = cells.cut_to(grid.whole());
  if (inside.empty()) return;
  const bool had_tall = has_tall(ground_.map().labels, inside);
  if (ground_.redraw(cells, labels)) {
    forget_all();
    return;
  }
  PlaneBounds bounds;
  bounds.include(
      grid.enu_from_cells({static_cast<double>(inside.left), static_cast<double>(inside.top)}));
  bounds.include(
      grid.enu_from_cells({static_cast<double>(inside.right), static_cast<double>(inside.bottom)}));
  forget(bounds, had_tall || has_tall(ground_.map().labels, inside));
}

std::vector<int> LocalisabilityMap::missing_tiles(const Eigen::Vector2d& near_in_enu_m) const {
  std::vector<std::tuple<double, int>> found;
  const int tiles = tiles_across(columns_) * tiles_across(rows_);
  for (int tile = 0; tile < tiles; ++tile) {
    const CellRect places = places_of(tile, columns_, rows_);
    bool is_missing = false;
    for (auto row = static_cast<int>(places.top); row < places.bottom && !is_missing; ++row) {
      const auto first = seen_reach_m_.begin() + static_cast<std::ptrdiff_t>(index_of(
                                                     static_cast<int>(places.left), row, 0));
      is_missing = std::any_of(first, first + places.width() * options_.headings,
                               [](float reach_m) { return reach_m < 0.0F; });
    }
    if (!is_missing) continue;
    const Eigen::Vector2d middle =
        ground_.map().top_left_in_enu_m +
        0.5 * options_.spacing_m *
            Eigen::Vector2d(static_cast<double>(places.left + places.right),
                            -static_cast<double>(places.top + places.bottom));
    found.emplace_back((middle - near_in_enu_m).norm(), tile);
  }
  std::sort(found.begin(), found.end());
  std::vector<int> tiles_by_distance;
  tiles_by_distance.reserve(found.size());
  for (const auto& [distance_m, tile] : found) tiles_by_distance.push_back(tile);
  return tiles_by_distance;
}

std::int64_t LocalisabilityMap::compute_tile(int tile) {
  const CellRect places = places_of(tile, columns_, rows_);
  PlaneBounds bounds;
  bounds.include(place_in_enu_m(static_cast<int>(places.left), static_cast<int>(places.top)));
  bounds.include(
      place_in_enu_m(static_cast<int>(places.right) - 1, static_cast<int>(places.bottom) - 1));
  detail::ViewMatcher matcher(ground_, footprint_, options_, bounds);
  std::int64_t computed = 0;
  for (auto row = static_cast<int>(places.top); row < places.bottom; ++row) {
    for (auto column = static_cast<int>(places.left); column < places.right; ++column) {
      const Eigen::Vector2d place = place_in_enu_m(column, row);
      for (int heading = 0; heading < options_.headings; ++heading) {
        const std::size_t index = index_of(column, row, heading);
        if (is_known(index)) continue;
        const detail::MadeView made = matcher.look({place.x(), place.y(), heading_rad(heading)});
        views_[index] = made.information;
        margin_m_[index] = made.margin_m;
        seen_reach_m_[index] = made.seen_reach_m;
        ++computed;
      }
    }
  }
  return computed;
}

Result<bool> LocalisabilityMap::compute_more(std::int64_t most_views,
                                             const Eigen::Vector2d& near_in_enu_m,
                                             const WorkContext& context) {
  const std::vector<int> tiles = missing_tiles(near_in_enu_m);
  const auto round = static_cast<std::size_t>(std::max(1, thread_count()));
  const std::int64_t missing_before = missing_;
  const double wanted = static_cast<double>(std::clamp<std::int64_t>(most_views, 1, missing_ + 1));
  for (std::size_t first = 0; first < tiles.size(); first += round) {
    if (missing_before - missing_ >= most_views) return false;
    if (context.is_stopped()) return fail(ErrorCode::kCancelled, "the localisability was stopped");
    std::vector<std::int64_t> computed(std::min(round, tiles.size() - first));
    parallel_for(computed.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) computed[i] = compute_tile(tiles[first + i]);
    });
    for (const std::int64_t views : computed) missing_ -= views;
    context.report(std::min(1.0, static_cast<double>(missing_before - missing_) / wanted),
                   "localisability");
  }
  return missing_ == 0;
}

std::optional<ViewInformation> LocalisabilityMap::view(int column, int row, int heading) const {
  const std::size_t index = index_of(column, row, heading);
  if (!is_known(index)) return std::nullopt;
  return views_[index];
}

ViewInformation LocalisabilityMap::look_from(const Rigid2& enu_from_body) const {
  PlaneBounds bounds;
  bounds.include(enu_from_body.translation_m());
  return detail::ViewMatcher(ground_, footprint_, options_, bounds).look(enu_from_body).information;
}

Raster<float> LocalisabilityMap::layer(LocalisabilityMeasure measure) const {
  Raster<float> result(columns_, rows_, std::numeric_limits<float>::quiet_NaN());
  const auto headings = static_cast<std::size_t>(options_.headings);
  for (std::size_t place = 0; place < result.size(); ++place) {
    float sum = 0.0F;
    bool is_whole = true;
    for (std::size_t i = place * headings; i < (place + 1) * headings; ++i) {
      is_whole = is_whole && is_known(i);
      sum += measure_of(views_[i], measure);
    }
    if (is_whole) result.values()[place] = sum / static_cast<float>(headings);
  }
  return result;
}

}  // namespace nadir
