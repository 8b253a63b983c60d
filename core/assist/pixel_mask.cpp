// SPDX-License-Identifier: Apache-2.0
#include "core/assist/pixel_mask.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/base/require.h"
#include "core/edit/polygon_algebra.h"
#include "core/label/edit_paint.h"
#include "core/label/paint_objects.h"
#include "core/label/tile_painter.h"

namespace nadir {
namespace {

/// What of a piece is large enough, its border on the lattice.
Result<Region> region_of_piece(const CellRegion& piece,
                               const CellMask& found,
                               const LabelGrid& grid,
                               const DrawCellsOptions& options) {
  const Eigen::Vector2d corner(static_cast<double>(found.cells.left),
                               static_cast<double>(found.cells.top));
  std::vector<Ring> rings;
  for (const Ring& in_cells : piece.rings_in_cells) {
    Ring ring;
    ring.reserve(in_cells.size());
    for (const Eigen::Vector2d& place : in_cells) {
      ring.push_back(on_lattice(grid.enu_from_cells(place + corner)));
    }
    Region alone;
    alone.parts.push_back({ring});
    const bool is_small = area_m2(alone) < options.least_area_m2;
    if (is_small && rings.empty()) return Region{};
    if (!is_small) rings.push_back(std::move(ring));
  }
  Region whole;
  whole.parts.push_back(std::move(rings));
  if (options.simplify_m == 0.0) return whole;
  return simplified(whole, options.simplify_m);
}

}  // namespace

PixelMask filled_holes(const PixelMask& mask, int most_pixels, PixelNeighbours of_mask) {
  PixelMask filled = mask;
  if (mask.empty() || most_pixels <= 0) return filled;
  cv::Mat outside(mask.height(), mask.width(), CV_8U);
  for (int row = 0; row < mask.height(); ++row) {
    for (int column = 0; column < mask.width(); ++column) {
      outside.at<std::uint8_t>(row, column) = mask.at(column, row) == 0 ? 1 : 0;
    }
  }
  cv::Mat piece_of, pieces, middles;
  const int count = cv::connectedComponentsWithStats(
      outside, piece_of, pieces, middles, of_mask == PixelNeighbours::kFour ? 8 : 4, CV_32S);
  std::vector<bool> is_filled(static_cast<std::size_t>(count), false);
  for (int piece = 1; piece < count; ++piece) {
    const int left = pieces.at<int>(piece, cv::CC_STAT_LEFT);
    const int top = pieces.at<int>(piece, cv::CC_STAT_TOP);
    const bool is_hole = left > 0 && top > 0 &&
                         left + pieces.at<int>(piece, cv::CC_STAT_WIDTH) < mask.width() &&
                         top + pieces.at<int>(piece, cv::CC_STAT_HEIGHT) < mask.height();
    is_filled[static_cast<std::size_t>(piece)] =
        is_hole && pieces.at<int>(piece, cv::CC_STAT_AREA) <= most_pixels;
  }
  for (int row = 0; row < mask.height(); ++row) {
    for (int column = 0; column < mask.width(); ++column) {
      if (is_filled[static_cast<std::size_t>(piece_of.at<int>(row, column))]) {
        filled.at(column, row) = 1;
      }
    }
  }
  return filled;
}

Result<std::vector<Ring>> borders_in_enu(const AssistWindow& window, const PixelMask& mask) {
  NADIR_REQUIRE(mask.width() == window.width() && mask.height() == window.height());
  const auto pieces = polygonise(mask, 0);
  if (!pieces) return forward_error(pieces);
  std::vector<Ring> borders;
  for (const CellRegion& piece : *pieces) {
    for (const Ring& in_pixels : piece.rings_in_cells) {
      Ring& border = borders.emplace_back();
      border.reserve(in_pixels.size());
      for (const Eigen::Vector2d& place : in_pixels) {
        border.push_back(window.enu_from_pixels() * place);
      }
    }
  }
  return borders;
}

Result<CellMask> cells_of(const AssistWindow& window,
                          const PixelMask& mask,
                          const LabelGrid& grid) {
  NADIR_REQUIRE(mask.width() == window.width() && mask.height() == window.height());
  PlaneBounds bounds;
  for (int row = 0; row < mask.height(); ++row) {
    for (int column = 0; column < mask.width(); ++column) {
      if (mask.at(column, row) == 0) continue;
      for (const Eigen::Vector2d& corner :
           {Eigen::Vector2d(column, row), Eigen::Vector2d(column + 1, row),
            Eigen::Vector2d(column, row + 1), Eigen::Vector2d(column + 1, row + 1)}) {
        bounds.include(window.enu_from_pixels() * corner);
      }
    }
  }
  CellMask found;
  if (bounds.is_empty) return found;
  const CellRect cells = grid.cells_of(bounds, 0).cut_to(grid.whole());
  if (cells.empty()) return found;
  if (cells.width() * cells.height() > kMostFilledCells) {
    return fail(ErrorCode::kInvalidOptions, "there are more than {} cells to look at",
                kMostFilledCells);
  }
  found.cells = cells;
  found.values = {static_cast<int>(cells.width()), static_cast<int>(cells.height())};
  for (int row = 0; row < found.values.height(); ++row) {
    for (int column = 0; column < found.values.width(); ++column) {
      const Eigen::Vector2d centre(static_cast<double>(cells.left + column) + 0.5,
                                   static_cast<double>(cells.top + row) + 0.5);
      const auto pixel = window.pixel_at(grid.enu_from_cells(centre));
      if (pixel) found.values.at(column, row) = mask.at(pixel->column, pixel->row);
    }
  }
  return found;
}

LabelEdit paint_cells(const LabelDocument& document,
                      const CellMask& found,
                      PaintValue value,
                      std::string title) {
  NADIR_REQUIRE(is_paint_value(value));
  TilePainter painter(document);
  for (int row = 0; row < found.values.height(); ++row) {
    const auto cells = found.values.row(row);
    for (auto from = cells.begin(); from != cells.end();) {
      from = std::find(from, cells.end(), std::uint8_t{1});
      const auto to = std::find(from, cells.end(), std::uint8_t{0});
      if (from == to) break;
      painter.put(found.cells.top + row, found.cells.left + (from - cells.begin()),
                  found.cells.left + (to - cells.begin()), value);
      from = to;
    }
  }
  return painter.edit(std::move(title));
}

Result<LabelEdit> draw_cells(const LabelDocument& document,
                             const CellMask& found,
                             ClassId class_id,
                             const DrawCellsOptions& options,
                             std::string title) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  LabelEdit edit{.title = std::move(title), .objects = {}, .tiles = {}, .values = {}};
  const auto pieces = polygonise(found.values, 0);
  if (!pieces) return forward_error(pieces);
  ObjectId next_id = document.next_id();
  for (const CellRegion& piece : *pieces) {
    const auto region = region_of_piece(piece, found, document.grid(), options);
    if (!region) return forward_error(region);
    for (const std::vector<Ring>& part : region->parts) {
      LabelObject object;
      object.id = next_id++;
      object.class_id = class_id;
      object.order = document.next_order(class_id);
      object.rings = part;
      if (auto sound = check_object(object); !sound) return forward_error(sound);
      edit.objects.push_back({nullptr, std::make_shared<const LabelObject>(std::move(object))});
    }
  }
  return edit;
}

}  // namespace nadir
