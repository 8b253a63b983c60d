// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/overhead_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "widgets/views/raster_pictures.h"

namespace nadir {

OverheadView::OverheadView(MapScene& scene,
                           OverheadTiles tiles,
                           OverheadTiles::Layer layer,
                           std::shared_ptr<TileBudget> budget)
    : scene_(scene),
      tiles_(std::move(tiles)),
      layer_(layer),
      budget_(budget != nullptr ? std::move(budget) : std::make_shared<TileBudget>()) {
  budget_->join(*this);
}

OverheadView::~OverheadView() {
  budget_->leave(*this);
  for (const auto& [tile, shown] : shown_) budget_->gave_back(shown.bytes);
}

MapLayer OverheadView::map_layer() const {
  return layer_ == OverheadTiles::Layer::kPicture ? MapLayer::kPicture : MapLayer::kLabels;
}

int OverheadView::level_for(double metres_per_px) const {
  const double cells_per_px = metres_per_px / tiles_.metres_per_cell();
  const int level = static_cast<int>(std::floor(std::log2(std::max(1.0, cells_per_px)) + 1e-9));
  return std::min(level, tiles_.level_count() - 1);
}

std::vector<TileAddress> OverheadView::in_sight(const MapCamera& camera,
                                                double width_px,
                                                double height_px,
                                                int level) const {
  // The map's cells under the corners of the page; with a turned camera, the box around them.
  const PageRect page{0.0, 0.0, width_px, height_px};
  Eigen::AlignedBox2d cells;
  for (const double x : {0.0, width_px}) {
    for (const double y : {0.0, height_px}) {
      const Eigen::Vector2d offset_m =
          camera.enu_from_page({x, y}, page) - tiles_.top_left_in_enu_m();
      cells.extend(Eigen::Vector2d(offset_m.x(), -offset_m.y()) / tiles_.metres_per_cell());
    }
  }
  const double side = std::ldexp(kTileSide, level);
  const auto index = [side](double cell, int count) {
    return static_cast<int>(std::clamp(std::floor(cell / side), -1.0, static_cast<double>(count)));
  };
  std::vector<TileAddress> found;
  const int columns = tiles_.columns(level);
  const int rows = tiles_.rows(level);
  const int last_row = std::min(rows - 1, index(cells.max().y(), rows));
  const int last_column = std::min(columns - 1, index(cells.max().x(), columns));
  for (int row = std::max(0, index(cells.min().y(), rows)); row <= last_row; ++row) {
    for (int column = std::max(0, index(cells.min().x(), columns)); column <= last_column;
         ++column) {
      found.push_back({level, column, row});
    }
  }
  const Eigen::Vector2d middle = cells.center();
  const auto distance = [&](const TileAddress& tile) {
    return (side * Eigen::Vector2d(tile.column + 0.5, tile.row + 0.5) - middle).squaredNorm();
  };
  std::stable_sort(found.begin(), found.end(), [&](const TileAddress& a, const TileAddress& b) {
    return distance(a) < distance(b);
  });
  return found;
}

Result<void> OverheadView::load(const TileAddress& tile) {
  Raster<Rgba> pixels;
  if (layer_ == OverheadTiles::Layer::kPicture) {
    const auto picture = tiles_.picture(tile);
    if (!picture) return forward_error(picture);
    pixels = colour_picture(*picture);
  } else {
    const auto labels = tiles_.labels(tile);
    if (!labels) return forward_error(labels);
    pixels = class_picture(*labels);
  }
  const Eigen::Vector4i cells = tiles_.cells_of(tile);
  const Eigen::Vector2d corner_m =
      tiles_.top_left_in_enu_m() + tiles_.metres_per_cell() * Eigen::Vector2d(cells[0], -cells[1]);
  const Eigen::Vector2d metres_per_pixel(tiles_.metres_per_cell() * cells[2] / pixels.width(),
                                         tiles_.metres_per_cell() * cells[3] / pixels.height());
  Shown& shown = shown_[tile];
  shown.view = std::make_unique<RasterView>(scene_, map_layer());
  shown.last_used = clock_;
  shown.bytes = 2 * pixels.size() * sizeof(Rgba);  // and the texture
  budget_->took(shown.bytes);
  // Tiles are drawn at half their size at least, but for the coarsest one.
  shown.view->show(pixels, {corner_m.x(), corner_m.y(), 0.0}, metres_per_pixel,
                   layer_ == OverheadTiles::Layer::kPicture,
                   tile.level + 1 == tiles_.level_count());
  shown.view->set_opacity(opacity_);
  shown.view->set_visible(false);
  return {};
}

std::optional<TileAddress> OverheadView::readable(TileAddress tile) const {
  while (damaged_.count(tile) > 0) {
    if (tile.level + 1 >= tiles_.level_count()) return std::nullopt;
    tile = {tile.level + 1, tile.column / 2, tile.row / 2};
  }
  return tile;
}

bool OverheadView::is_to_come(const TileAddress& missing) const {
  const auto tile = readable(missing);
  return tile && shown_.count(*tile) == 0;
}

void OverheadView::show_stand_in(const TileAddress& missing) {
  TileAddress coarser = missing;
  while (shown_.count(coarser) == 0) {
    if (coarser.level + 1 >= tiles_.level_count()) return;  // nothing is there at all
    coarser = {coarser.level + 1, coarser.column / 2, coarser.row / 2};
  }
  Shown& source = shown_.at(coarser);
  source.last_used = clock_;
  StandIn& made = stand_ins_[missing];
  if (made.view != nullptr && made.cut_from == coarser) return;
  const Eigen::Vector4i whole = tiles_.cells_of(coarser);
  const Eigen::Vector4i part = tiles_.cells_of(missing);
  const auto share = [&](int cell, int axis) {
    return static_cast<double>(cell - whole[axis]) / whole[axis + 2];
  };
  made = {coarser, std::make_unique<RasterView>(scene_, map_layer())};
  made.view->show_part_of(
      *source.view, {Eigen::Vector2d(share(part[0], 0), share(part[1], 1)),
                     Eigen::Vector2d(share(part[0] + part[2], 0), share(part[1] + part[3], 1))});
  made.view->set_opacity(opacity_);
}

Result<bool> OverheadView::update(const MapCamera& camera,
                                  double width_px,
                                  double height_px,
                                  int most_new_tiles) {
  clock_ = budget_->next_moment();
  for (auto& [tile, shown] : shown_) shown.view->set_visible(false);
  if (!is_visible_) {
    stand_ins_.clear();
    return true;
  }
  const auto show_if_there = [this](const TileAddress& tile) {
    const auto found = shown_.find(tile);
    if (found == shown_.end()) return false;
    found->second.last_used = clock_;
    found->second.view->set_visible(true);
    return true;
  };
  std::vector<TileAddress> missing =
      in_sight(camera, width_px, height_px, level_for(camera.metres_per_px));
  std::erase_if(missing, show_if_there);
  std::vector<TileAddress> wanted;
  for (const TileAddress& tile : missing) {
    if (is_to_come(tile)) wanted.push_back(*readable(tile));
  }
  if (wanted.size() > static_cast<std::size_t>(std::max(0, most_new_tiles))) {
    const TileAddress whole_map{tiles_.level_count() - 1, 0, 0};
    if (is_to_come(whole_map)) wanted.insert(wanted.begin(), whole_map);
    wanted.resize(std::min(wanted.size(), static_cast<std::size_t>(std::max(0, most_new_tiles))));
  }
  std::optional<Error> first_fault;
  for (const TileAddress& tile : wanted) {
    if (shown_.count(tile) > 0 || damaged_.count(tile) > 0) continue;
    const auto loaded = load(tile);
    if (loaded) continue;
    if (damaged_.empty()) first_fault = loaded.error();
    damaged_.insert(tile);
  }
  std::erase_if(missing, show_if_there);
  std::erase_if(stand_ins_, [&](const auto& stand_in) {
    return std::find(missing.begin(), missing.end(), stand_in.first) == missing.end();
  });
  for (const TileAddress& tile : missing) show_stand_in(tile);
  budget_->keep();
  if (first_fault) return tl::unexpected(*first_fault);
  return std::none_of(missing.begin(), missing.end(),
                      [this](const TileAddress& tile) { return is_to_come(tile); });
}

std::map<TileAddress, OverheadView::Shown>::const_iterator OverheadView::least_used() const {
  return std::min_element(shown_.begin(), shown_.end(), [](const auto& a, const auto& b) {
    return a.second.last_used < b.second.last_used;
  });
}

std::uint64_t OverheadView::longest_unused() const {
  const auto oldest = least_used();
  if (oldest == shown_.end()) return TileBudget::kNever;
  const bool is_shown = is_visible_ && oldest->second.last_used == clock_;
  return is_shown ? TileBudget::kNever : oldest->second.last_used;
}

void OverheadView::forget_longest_unused() {
  const auto oldest = least_used();
  budget_->gave_back(oldest->second.bytes);
  shown_.erase(oldest);
}

void OverheadView::set_opacity(double opacity) {
  opacity_ = opacity;
  for (auto& [tile, shown] : shown_) shown.view->set_opacity(opacity);
  for (auto& [tile, stand_in] : stand_ins_) stand_in.view->set_opacity(opacity);
}

void OverheadView::set_visible(bool visible) {
  is_visible_ = visible;
  if (visible) return;  // update() shows them again
  for (auto& [tile, shown] : shown_) shown.view->set_visible(false);
  stand_ins_.clear();
}

}  // namespace nadir
