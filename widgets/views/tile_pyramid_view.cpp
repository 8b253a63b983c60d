// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/tile_pyramid_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/require.h"

namespace nadir {

TilePyramidView::TilePyramidView(MapScene& scene,
                                 MapLayer layer,
                                 std::shared_ptr<const TilePictures> pictures,
                                 std::shared_ptr<TileBudget> budget,
                                 TileMaking making)
    : scene_(scene),
      layer_(layer),
      pictures_(std::move(pictures)),
      budget_(budget != nullptr ? std::move(budget) : std::make_shared<TileBudget>()) {
  NADIR_REQUIRE(pictures_ != nullptr);
  if (making == TileMaking::kInThread) maker_ = std::make_unique<TileMaker>();
  budget_->join(*this);
}

TilePyramidView::~TilePyramidView() {
  budget_->leave(*this);
  drop_all();
}

void TilePyramidView::drop_all() {
  for (const auto& [tile, shown] : shown_) budget_->gave_back(shown.bytes);
  shown_.clear();
  stand_ins_.clear();
}

int TilePyramidView::level_for(double metres_per_px) const {
  const double cells_per_px = metres_per_px / pictures_->grid().metres_per_cell;
  const int level = static_cast<int>(std::floor(std::log2(std::max(1.0, cells_per_px)) + 1e-9));
  return std::min(level, pictures_->level_count() - 1);
}

std::vector<TileAddress> TilePyramidView::in_sight(const MapCamera& camera,
                                                   double width_px,
                                                   double height_px,
                                                   int level) const {
  // The map's cells under the corners of the page; with a turned camera, the box around them.
  const PageRect page{0.0, 0.0, width_px, height_px};
  Eigen::AlignedBox2d cells;
  for (const double x : {0.0, width_px}) {
    for (const double y : {0.0, height_px}) {
      cells.extend(pictures_->grid().cells_from_enu(camera.enu_from_page({x, y}, page)));
    }
  }
  const double side = std::ldexp(kTileSide, level);
  const auto index = [side](double cell, int count) {
    return static_cast<int>(std::clamp(std::floor(cell / side), -1.0, static_cast<double>(count)));
  };
  std::vector<TileAddress> found;
  const int columns = pictures_->columns(level);
  const int rows = pictures_->rows(level);
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

void TilePyramidView::place(const TileAddress& tile, const Shown& shown) const {
  const LabelGrid& grid = pictures_->grid();
  const CellRect cells = pictures_->cells_of(tile);
  const Eigen::Vector2d corner_m =
      grid.enu_from_cells({static_cast<double>(cells.left), static_cast<double>(cells.top)});
  const Eigen::Vector2d share(
      static_cast<double>(cells.width()) / static_cast<double>(shown.size.width()),
      static_cast<double>(cells.height()) / static_cast<double>(shown.size.height()));
  shown.view->place({corner_m.x(), corner_m.y(), 0.0}, grid.metres_per_cell * share);
}

void TilePyramidView::put(const TileAddress& tile,
                          const Raster<Rgba>& pixels,
                          std::int64_t revision) {
  Shown& shown = shown_[tile];
  const bool is_new = shown.view == nullptr;
  if (is_new) shown.view = std::make_unique<RasterView>(scene_, layer_);
  shown.last_used = clock_;
  shown.size = {0, 0, pixels.width(), pixels.height()};
  shown.stale = {};
  shown.revision = revision;
  budget_->gave_back(shown.bytes);
  shown.bytes = 2 * pixels.size() * sizeof(Rgba);  // and the texture
  budget_->took(shown.bytes);
  // Tiles are drawn at half their size at least, but for the coarsest one.
  shown.view->show(pixels, {}, Eigen::Vector2d::Ones(), pictures_->is_smooth(),
                   tile.level + 1 == pictures_->level_count());
  place(tile, shown);
  shown.view->set_opacity(opacity_);
  if (is_new) shown.view->set_visible(false);
}

bool TilePyramidView::show_if_there(const TileAddress& tile) {
  const auto found = shown_.find(tile);
  if (found == shown_.end()) return false;
  found->second.last_used = clock_;
  found->second.view->set_visible(true);
  return true;
}

std::optional<TileAddress> TilePyramidView::readable(TileAddress tile) const {
  while (damaged_.count(tile) > 0) {
    if (tile.level + 1 >= pictures_->level_count()) return std::nullopt;
    tile = {tile.level + 1, tile.column / 2, tile.row / 2};
  }
  return tile;
}

bool TilePyramidView::is_to_come(const TileAddress& missing) const {
  const auto tile = readable(missing);
  return tile && shown_.count(*tile) == 0;
}

void TilePyramidView::show_stand_in(const TileAddress& missing) {
  TileAddress coarser = missing;
  while (shown_.count(coarser) == 0) {
    if (coarser.level + 1 >= pictures_->level_count()) return;  // nothing is there at all
    coarser = {coarser.level + 1, coarser.column / 2, coarser.row / 2};
  }
  Shown& source = shown_.at(coarser);
  source.last_used = clock_;
  StandIn& made = stand_ins_[missing];
  if (made.view != nullptr && made.cut_from == coarser) return;
  const CellRect whole = pictures_->cells_of(coarser);
  const CellRect part = pictures_->cells_of(missing);
  const auto share = [&](std::int64_t column, std::int64_t row) {
    return Eigen::Vector2d(
        static_cast<double>(column - whole.left) / static_cast<double>(whole.width()),
        static_cast<double>(row - whole.top) / static_cast<double>(whole.height()));
  };
  made = {coarser, std::make_unique<RasterView>(scene_, layer_)};
  made.view->show_part_of(*source.view,
                          {share(part.left, part.top), share(part.right, part.bottom)});
  made.view->set_opacity(opacity_);
}

void TilePyramidView::note_damage(const TileAddress& tile, const Error& fault) {
  if (damaged_.empty()) first_fault_ = fault;
  damaged_.insert(tile);
}

void TilePyramidView::make_now(const std::vector<TileAddress>& wanted) {
  for (const TileAddress& tile : wanted) {
    if (shown_.count(tile) > 0 || damaged_.count(tile) > 0) continue;
    if (const auto pixels = pictures_->picture(tile)) {
      put(tile, *pixels, revision_);
    } else {
      note_damage(tile, pixels.error());
    }
  }
}

Result<bool> TilePyramidView::update(const MapCamera& camera,
                                     double width_px,
                                     double height_px,
                                     int most_new_tiles) {
  clock_ = budget_->next_moment();
  first_fault_.reset();
  for (auto& [tile, shown] : shown_) shown.view->set_visible(false);
  if (!is_visible_) {
    stand_ins_.clear();
    if (maker_ != nullptr) maker_->ask({});
    return true;
  }
  if (maker_ != nullptr) take_made(most_new_tiles);
  const std::vector<TileAddress> seen =
      in_sight(camera, width_px, height_px, level_for(camera.metres_per_px));
  std::vector<TileAddress> missing = seen;
  std::erase_if(missing, [this](const TileAddress& tile) { return show_if_there(tile); });
  std::vector<TileAddress> wanted;
  for (const TileAddress& tile : missing) {
    if (is_to_come(tile)) wanted.push_back(*readable(tile));
  }
  const auto most = static_cast<std::size_t>(std::max(0, most_new_tiles));
  if (wanted.size() > most || maker_ != nullptr) {
    const TileAddress all{pictures_->level_count() - 1, 0, 0};
    if (!wanted.empty() && is_to_come(all)) wanted.insert(wanted.begin(), all);
  }
  if (maker_ == nullptr) {
    wanted.resize(std::min(wanted.size(), most));
    make_now(wanted);
  }
  redo_stale(seen, most_new_tiles);
  if (maker_ != nullptr) ask_for(wanted, seen);
  std::erase_if(missing, [this](const TileAddress& tile) { return show_if_there(tile); });
  std::erase_if(stand_ins_, [&](const auto& stand_in) {
    return std::find(missing.begin(), missing.end(), stand_in.first) == missing.end();
  });
  for (const TileAddress& tile : missing) show_stand_in(tile);
  budget_->keep();
  if (first_fault_) return tl::unexpected(*first_fault_);
  const auto is_stale = [this](const TileAddress& tile) {
    const auto found = shown_.find(tile);
    return found != shown_.end() && !found->second.stale.empty();
  };
  return std::none_of(missing.begin(), missing.end(),
                      [this](const TileAddress& tile) { return is_to_come(tile); }) &&
         std::none_of(seen.begin(), seen.end(), is_stale);
}

std::map<TileAddress, TilePyramidView::Shown>::const_iterator TilePyramidView::least_used() const {
  return std::min_element(shown_.begin(), shown_.end(), [](const auto& a, const auto& b) {
    return a.second.last_used < b.second.last_used;
  });
}

std::uint64_t TilePyramidView::longest_unused() const {
  const auto oldest = least_used();
  if (oldest == shown_.end()) return TileBudget::kNever;
  const bool is_shown = is_visible_ && oldest->second.last_used == clock_;
  return is_shown ? TileBudget::kNever : oldest->second.last_used;
}

void TilePyramidView::forget_longest_unused() {
  const auto oldest = least_used();
  budget_->gave_back(oldest->second.bytes);
  shown_.erase(oldest);
}

void TilePyramidView::set_opacity(double opacity) {
  opacity_ = opacity;
  for (auto& [tile, shown] : shown_) shown.view->set_opacity(opacity);
  for (auto& [tile, stand_in] : stand_ins_) stand_in.view->set_opacity(opacity);
}

void TilePyramidView::set_visible(bool visible) {
  is_visible_ = visible;
  if (visible) return;  // update() shows them again
  for (auto& [tile, shown] : shown_) shown.view->set_visible(false);
  stand_ins_.clear();
}

}  // namespace nadir
