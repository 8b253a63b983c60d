// SPDX-License-Identifier: Apache-2.0
#include "core/quality/cell_codes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "core/label/label_raster.h"
#include "core/map/squared_distances.h"

namespace nadir {
namespace {

constexpr double kRoundingCells = 1e-6;

/// Cells of which a rectangle has more than rounding.
CellRect cells_touched(const LabelGrid& grid, const PlaneBounds& bounds) {
  const Eigen::Vector2d upper_left = grid.cells_from_enu({bounds.low.x(), bounds.high.y()});
  const Eigen::Vector2d lower_right = grid.cells_from_enu({bounds.high.x(), bounds.low.y()});
  const auto whole = [](double cell) {
    return static_cast<std::int64_t>(std::clamp(cell, -1e12, 1e12));
  };
  const std::int64_t left = whole(std::floor(upper_left.x() + kRoundingCells));
  const std::int64_t top = whole(std::floor(upper_left.y() + kRoundingCells));
  return {left, top, std::max(left + 1, whole(std::ceil(lower_right.x() - kRoundingCells))),
          std::max(top + 1, whole(std::ceil(lower_right.y() - kRoundingCells)))};
}

/// Where a tile is painted with a class, within some cells of the document's grid.
CellRect painted_part(const PaintAddress& address, const PaintTile& tile, const CellRect& within) {
  const std::int64_t left_of_tile = std::int64_t{address.column} * kPaintTileSide;
  const std::int64_t top_of_tile = std::int64_t{address.row} * kPaintTileSide;
  const auto is_painted = [&](std::int64_t column, std::int64_t row) {
    const PaintValue value =
        tile.at(static_cast<int>(column - left_of_tile), static_cast<int>(row - top_of_tile));
    return value != kNoPaint && value != kUnclassified;
  };
  const CellRect cells = CellRect{left_of_tile, top_of_tile, left_of_tile + kPaintTileSide,
                                  top_of_tile + kPaintTileSide}
                             .cut_to(within);
  CellRect part;
  for (std::int64_t row = cells.top; row < cells.bottom; ++row) {
    std::int64_t left = cells.left;
    std::int64_t right = cells.right;
    while (left < right && !is_painted(left, row)) ++left;
    while (left < right && !is_painted(right - 1, row)) --right;
    part = part.joined({left, row, right, row + 1});
  }
  return part;
}

/// What leaves ground unclassified on purpose: insides of outlines, and objects without a class.
LabelDocument document_of_left_out(const LabelDocument& document) {
  LabelEdit edit;
  for (const auto& [id, placed] : document.objects()) {
    const LabelObject& object = *placed.object;
    if (object.kind != ObjectKind::kOutline && object.class_id != kUnclassified) continue;
    auto shown = std::make_shared<LabelObject>(object);
    shown->class_id = kTerrain;
    if (shown->kind == ObjectKind::kOutline) {
      shown->kind = ObjectKind::kArea;
      shown->width_m = 0.0;
    }
    edit.objects.push_back({nullptr, std::move(shown)});
  }
  LabelDocument left_out(document.plane(), document.grid());
  left_out.apply(edit);
  return left_out;
}

bool is_bound(CellCode code) { return code != kBeyondLabels && code < kOpenGround; }

/// How many cells of open ground come before each in a direction, itself too; too many where no label comes before them.
class GroundRuns {
 public:
  GroundRuns(const Raster<CellCode>& codes, int across, int down)
      : codes_(codes), across_(across), down_(down) {}

  [[nodiscard]] std::uint16_t next(int column,
                                   int row,
                                   std::span<const std::uint16_t> before) const {
    if (codes_.at(column, row) != kOpenGround) return 0;
    const int x = column - across_;
    const int y = row - down_;
    if (!codes_.contains(x, y)) return kTooMany;
    const CellCode code = codes_.at(x, y);
    if (code != kOpenGround) return is_bound(code) ? 1 : kTooMany;
    return static_cast<std::uint16_t>(
        std::min<int>(kTooMany, before[static_cast<std::size_t>(x)] + 1));
  }
  static constexpr std::uint16_t kTooMany = 0x7FFF;

 private:
  const Raster<CellCode>& codes_;
  int across_, down_;
};

/// Marks open ground that is at most so many cells long in a direction, with labels at both ends.
void mark_runs(
    const Raster<CellCode>& codes, int across, int down, int most, std::vector<bool>& is_narrow) {
  if (most < 1) return;
  Raster<std::uint16_t> counts(codes.width(), codes.height());
  const GroundRuns forward(codes, across, down);
  for (int row = 0; row < codes.height(); ++row) {
    for (int column = 0; column < codes.width(); ++column) {
      counts.at(column, row) =
          forward.next(column, row, counts.row(down == 0 ? row : std::max(0, row - 1)));
    }
  }
  const GroundRuns backward(codes, -across, -down);
  const auto width = static_cast<std::size_t>(codes.width());
  std::vector<std::uint16_t> below(width), now(width);
  for (int row = codes.height() - 1; row >= 0; --row) {
    for (int i = 0; i < codes.width(); ++i) {
      const int column = down == 0 ? codes.width() - 1 - i : i;
      const auto at = static_cast<std::size_t>(column);
      now[at] = backward.next(column, row, down == 0 ? now : below);
      if (now[at] != 0 && now[at] + counts.at(column, row) - 1 <= most) {
        is_narrow[static_cast<std::size_t>(row) * width + at] = true;
      }
    }
    below.swap(now);
  }
}

}  // namespace

ClassId class_of_code(CellCode code) {
  if (code == kCurbAstray) return kCurb;
  return code < kClassCount ? code : ClassId{kUnclassified};
}

bool covers_ground(ClassId id) {
  return id == kRoad || id == kSidewalk || id == kBuilding || id == kVegetation || id == kTerrain;
}

CellRect labelled_extent(const LabelDocument& document, const LabelGrid& grid) {
  CellRect extent;
  const auto include = [&](const PlaneBounds& bounds) {
    extent = extent.joined(cells_touched(grid, bounds).cut_to(grid.whole()));
  };
  for (const auto& [id, placed] : document.objects()) {
    if (placed.object->class_id != kUnclassified) include(placed.bounds);
  }
  PlaneBounds image;
  image.include(grid.top_left_in_enu_m);
  image.include(
      grid.enu_from_cells({static_cast<double>(grid.width), static_cast<double>(grid.height)}));
  const CellRect within = cells_touched(document.grid(), image);
  for (const auto& [address, tile] : document.paint()) {
    const CellRect cells = painted_part(address, *tile, within);
    if (cells.empty()) continue;
    const auto corner = [&](std::int64_t column, std::int64_t row) {
      return document.grid().enu_from_cells(
          {static_cast<double>(column), static_cast<double>(row)});
    };
    PlaneBounds bounds;
    bounds.include(corner(cells.left, cells.top));
    bounds.include(corner(cells.right, cells.bottom));
    include(bounds);
  }
  return extent;
}

CellCoder::CellCoder(const LabelDocument& document,
                     const LabelGrid& grid,
                     const CheckSettings& settings)
    : document_(document),
      grid_(grid),
      extent_(labelled_extent(document, grid)),
      left_out_(document_of_left_out(document)),
      gap_cells_(std::min(settings.gap_width_m / grid.metres_per_cell + kRoundingCells, 1000.0)),
      curb_cells_(std::min(settings.curb_reach_m / grid.metres_per_cell, 1000.0)) {}

Raster<CellCode> CellCoder::plain_codes(const CellRect& window) const {
  Raster<CellCode> codes = rasterise(document_, grid_, window);
  const Raster<ClassId> left_out =
      left_out_.objects().empty() ? Raster<ClassId>() : rasterise(left_out_, grid_, window);
  const bool is_painted = !document_.paint().empty();
  for (std::int64_t row = window.top; row < window.bottom; ++row) {
    const auto y = static_cast<int>(row - window.top);
    for (std::int64_t column = window.left; column < window.right; ++column) {
      const auto x = static_cast<int>(column - window.left);
      CellCode& code = codes.at(x, y);
      if (code != kUnclassified) continue;
      code = kOpenGround;
      if (CellRect{column, row, column + 1, row + 1}.cut_to(extent_).empty()) {
        code = kBeyondLabels;
      } else if (!left_out.empty() && left_out.at(x, y) != kUnclassified) {
        code = kLeftOut;
      } else if (is_painted) {
        const Eigen::Vector2d centre = document_.grid().cells_from_enu(grid_.enu_from_cells(
            {static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5}));
        const PaintValue value =
            document_.paint_at(static_cast<std::int64_t>(std::floor(centre.x())),
                               static_cast<std::int64_t>(std::floor(centre.y())));
        if (value == kUnclassified) code = kLeftOut;
      }
    }
  }
  return codes;
}

void CellCoder::mark_narrow(Raster<CellCode>& codes) const {
  const auto& values = codes.values();
  if (std::find(values.begin(), values.end(), kOpenGround) == values.end()) return;
  std::vector<bool> is_narrow(codes.size(), false);
  const int straight = static_cast<int>(gap_cells_);
  const int aslant = static_cast<int>(gap_cells_ / std::numbers::sqrt2);
  mark_runs(codes, 1, 0, straight, is_narrow);
  mark_runs(codes, 0, 1, straight, is_narrow);
  mark_runs(codes, 1, 1, aslant, is_narrow);
  mark_runs(codes, -1, 1, aslant, is_narrow);
  for (std::size_t i = 0; i < is_narrow.size(); ++i) {
    if (is_narrow[i]) codes.values()[i] = kNarrowGround;
  }
}

void CellCoder::mark_astray(Raster<CellCode>& codes, const CellRect& window) const {
  const auto& values = codes.values();
  if (std::find(values.begin(), values.end(), kCurb) == values.end()) return;
  IdSet road{};
  for (const ClassId id : {kRoad, kLaneMarking, kCar, kPedestrian}) road.at(id) = true;
  IdSet other{};
  for (std::size_t id = 0; id < other.size(); ++id) other.at(id) = !road.at(id) && id != kCurb;
  const std::int64_t reach = static_cast<std::int64_t>(std::floor(curb_cells_));
  std::vector<std::uint8_t> is_astray(codes.size(), 0);
  const auto look_for = [&](const IdSet& targets) {
    visit_squared_distances(
        codes, targets, static_cast<int>(reach) + 1,
        [&](int row, std::span<const std::int64_t> squared) {
          const std::int64_t down = window.top + row;
          if (down - reach < 0 || down + reach >= grid_.height) return;
          for (std::size_t i = 0; i < squared.size(); ++i) {
            const std::int64_t across = window.left + static_cast<std::int64_t>(i);
            if (across - reach < 0 || across + reach >= grid_.width) continue;
            const bool is_far = static_cast<double>(squared[i]) > curb_cells_ * curb_cells_;
            auto& flag = is_astray[static_cast<std::size_t>(row) * squared.size() + i];
            if (is_far) flag = 1;
          }
        });
  };
  look_for(road);
  look_for(other);
  for (std::size_t i = 0; i < is_astray.size(); ++i) {
    if (is_astray[i] != 0 && values[i] == kCurb) codes.values()[i] = kCurbAstray;
  }
}

Raster<CellCode> CellCoder::codes(const CellRect& window) const {
  const auto margin = static_cast<std::int64_t>(std::ceil(std::max(gap_cells_, curb_cells_))) + 2;
  const CellRect wider = CellRect{window.left - margin, window.top - margin, window.right + margin,
                                  window.bottom + margin}
                             .cut_to(grid_.whole());
  Raster<CellCode> codes = plain_codes(wider);
  mark_astray(codes, wider);
  mark_narrow(codes);
  Raster<CellCode> inner(static_cast<int>(window.width()), static_cast<int>(window.height()));
  for (int row = 0; row < inner.height(); ++row) {
    const auto from = codes.row(row + static_cast<int>(window.top - wider.top))
                          .subspan(static_cast<std::size_t>(window.left - wider.left),
                                   static_cast<std::size_t>(inner.width()));
    std::copy(from.begin(), from.end(), inner.row(row).begin());
  }
  return inner;
}

}  // namespace nadir
