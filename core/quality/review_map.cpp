// SPDX-License-Identifier: Apache-2.0
#include "core/quality/review_map.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/hash.h"
#include "core/label/label_raster.h"
#include "core/quality/check_parts.h"

namespace nadir {
namespace {

constexpr std::string_view kReviewKey = "review";
constexpr double kLeastSideM = 1.0;
constexpr double kMostSideM = 10'000.0;
/// More tiles than these are not gone through.
constexpr std::int64_t kMostTiles = 1'000'000;

std::string key_of(const ReviewAddress& tile) {
  return fmt::format("{} {} {}", kReviewKey, tile.column, tile.row);
}

std::shared_ptr<const std::string> shared(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

std::int64_t edge_of(int tile, double side_m, const LabelGrid& grid) {
  return std::llround(static_cast<double>(tile) * side_m / grid.metres_per_cell);
}

/// The tile that holds a column or row of cells.
int tile_of(std::int64_t cell, double side_m, const LabelGrid& grid) {
  const double cells = side_m / grid.metres_per_cell;
  int tile = static_cast<int>(std::floor((static_cast<double>(cell) + 0.5) / cells));
  while (edge_of(tile + 1, side_m, grid) <= cell) ++tile;
  while (edge_of(tile, side_m, grid) > cell) --tile;
  return tile;
}

CellRect cells_of(const ReviewAddress& tile, double side_m, const LabelGrid& grid) {
  return CellRect{edge_of(tile.column, side_m, grid), edge_of(tile.row, side_m, grid),
                  edge_of(tile.column + 1, side_m, grid), edge_of(tile.row + 1, side_m, grid)}
      .cut_to(grid.whole());
}

std::string digest_of(const LabelDocument& document, const CellRect& cells) {
  const Raster<ClassId> labels = rasterise(document, document.grid(), cells);
  return Hash().add_number(cells.width()).add(labels.data(), labels.size()).text();
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// Cuts off the first line.
std::optional<std::string> take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  std::string line(text.substr(0, end));
  text.remove_prefix(end + 1);
  return line;
}

ReviewMark mark_of(const LabelDocument& document, const ReviewAddress& tile) {
  const auto text = document.value(key_of(tile));
  return text != nullptr ? review_mark_from(*text).value_or(ReviewMark{}) : ReviewMark{};
}

double distance_m(const PlaneBounds& bounds, const Eigen::Vector2d& place) {
  return (place - place.cwiseMax(bounds.low).cwiseMin(bounds.high)).norm();
}

}  // namespace

std::string review_text(const ReviewMark& mark) {
  return fmt::format("{}\n{}\n{}\n{}\n{}", enum_name(mark.state), one_line(mark.author),
                     one_line(mark.time), mark.digest, mark.note);
}

std::optional<ReviewMark> review_mark_from(const std::string& text) {
  std::string_view rest = text;
  const auto state = take_line(rest);
  const auto author = take_line(rest);
  const auto time = take_line(rest);
  const auto digest = take_line(rest);
  if (!digest) return std::nullopt;
  const auto& names = EnumNames<ReviewState>::kNames;
  const auto* const found = std::find(names.begin(), names.end(), *state);
  if (found == names.end()) return std::nullopt;
  return ReviewMark{static_cast<ReviewState>(found - names.begin()), *author, *time, *digest,
                    std::string(rest)};
}

std::optional<double> review_side_m(const LabelDocument& document) {
  const auto text = document.value(std::string(kReviewKey));
  if (text == nullptr) return std::nullopt;
  double side_m = 0.0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), side_m);
  const bool is_number = error == std::errc() && end == text->data() + text->size();
  if (!is_number || !(side_m >= kLeastSideM && side_m <= kMostSideM)) return std::nullopt;
  return side_m;
}

Result<LabelEdit> begin_review(const LabelDocument& document, double side_m) {
  if (!(side_m >= kLeastSideM && side_m <= kMostSideM)) {
    return fail(ErrorCode::kInvalidOptions, "review tiles of {} m are not in [{:.0f}, {:.0f}]",
                side_m, kLeastSideM, kMostSideM);
  }
  LabelEdit edit{.title = "Begin review", .objects = {}, .tiles = {}, .values = {}};
  if (review_side_m(document) == side_m) return edit;
  const std::string key(kReviewKey);
  const std::string of_tiles = key + " ";
  edit.values.push_back({key, {document.value(key), shared(fmt::format("{}", side_m))}});
  for (const auto& [name, value] : document.values()) {
    if (name.starts_with(of_tiles)) edit.values.push_back({name, {value, nullptr}});
  }
  return edit;
}

Result<LabelEdit> mark_tile(const LabelDocument& document,
                            const ReviewAddress& tile,
                            ReviewState state,
                            const std::string& note,
                            const std::string& author,
                            const std::string& time) {
  const auto side_m = review_side_m(document);
  if (!side_m) return fail(ErrorCode::kInvalidOptions, "no review was begun");
  const CellRect cells = cells_of(tile, *side_m, document.grid());
  if (cells.empty()) {
    return fail(ErrorCode::kInvalidOptions, "review tile {}, {} lies outside of the image",
                tile.column, tile.row);
  }
  LabelEdit edit{.title = fmt::format("Review: {}", enum_name(state)),
                 .objects = {},
                 .tiles = {},
                 .values = {}};
  ValueChange change{key_of(tile), {document.value(key_of(tile)), nullptr}};
  if (state != ReviewState::kOpen) {
    change.value.after = shared(
        review_text({state, one_line(author), one_line(time), digest_of(document, cells), note}));
  }
  const bool is_same =
      change.value.before == nullptr
          ? change.value.after == nullptr
          : change.value.after != nullptr && *change.value.before == *change.value.after;
  if (!is_same) edit.values.push_back(std::move(change));
  return edit;
}

double ReviewMap::done_share() const {
  if (tiles.empty()) return 0.0;
  const auto done = std::count_if(tiles.begin(), tiles.end(), [](const ReviewTile& tile) {
    return tile.mark.state == ReviewState::kDone && !tile.is_stale;
  });
  return static_cast<double>(done) / static_cast<double>(tiles.size());
}

const ReviewTile* ReviewMap::tile_at(const Eigen::Vector2d& place_in_enu_m) const {
  const auto found = std::find_if(tiles.begin(), tiles.end(), [&](const ReviewTile& tile) {
    return distance_m(tile.bounds, place_in_enu_m) == 0.0;
  });
  return found == tiles.end() ? nullptr : &*found;
}

const ReviewTile* ReviewMap::next_open(const Eigen::Vector2d& place_in_enu_m) const {
  if (tiles.empty()) return nullptr;
  const auto along = static_cast<std::size_t>(columns);
  // Both ways: the same turns every second row around.
  const auto turned = [along](std::size_t index) {
    const std::size_t row = index / along;
    const std::size_t column = index % along;
    return row * along + (row % 2 == 0 ? column : along - 1 - column);
  };
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const double distance = distance_m(tiles[i].bounds, place_in_enu_m);
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  const std::size_t start = turned(nearest);
  for (std::size_t step = 1; step < tiles.size(); ++step) {
    const ReviewTile& tile = tiles[turned((start + step) % tiles.size())];
    if (tile.is_open()) return &tile;
  }
  return nullptr;
}

Result<ReviewMap> review_map_of(const LabelDocument& document, const WorkContext& work) {
  ReviewMap map;
  const auto side_m = review_side_m(document);
  const LabelGrid& grid = document.grid();
  const CellRect extent = labelled_extent(document, grid);
  if (!side_m || extent.empty()) return map;
  const ReviewAddress first{tile_of(extent.left, *side_m, grid),
                            tile_of(extent.top, *side_m, grid)};
  const ReviewAddress last{tile_of(extent.right - 1, *side_m, grid),
                           tile_of(extent.bottom - 1, *side_m, grid)};
  map.columns = last.column - first.column + 1;
  const std::int64_t count = std::int64_t{map.columns} * (last.row - first.row + 1);
  if (count > kMostTiles) {
    return fail(ErrorCode::kInvalidOptions, "review tiles of {} m are too small for this map",
                *side_m);
  }
  map.tiles.reserve(static_cast<std::size_t>(count));
  for (int row = first.row; row <= last.row; ++row) {
    for (int column = first.column; column <= last.column; ++column) {
      if (work.is_stopped()) return fail(ErrorCode::kCancelled, "the review map was stopped");
      work.report(static_cast<double>(map.tiles.size()) / static_cast<double>(count),
                  "Looking for changes since the review");
      ReviewTile tile;
      tile.address = {column, row};
      const CellRect cells = cells_of(tile.address, *side_m, grid);
      tile.bounds = bounds_of_cells(grid, cells);
      tile.mark = mark_of(document, tile.address);
      tile.is_stale =
          tile.mark.state == ReviewState::kDone && tile.mark.digest != digest_of(document, cells);
      map.tiles.push_back(std::move(tile));
    }
  }
  return map;
}

}  // namespace nadir
