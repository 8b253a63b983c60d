// SPDX-License-Identifier: Apache-2.0
#include "core/assist/assist_window.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/base/require.h"

namespace nadir {
namespace {

Raster<LabColour> lab_of(const ImageRaster& pixels) {
  cv::Mat rgb(pixels.height(), pixels.width(), CV_32FC3);
  for (int row = 0; row < pixels.height(); ++row) {
    auto* const to = rgb.ptr<cv::Vec3f>(row);
    for (int column = 0; column < pixels.width(); ++column) {
      const ImagePixel& pixel = pixels.at(column, row);
      to[column] = cv::Vec3f(pixel.red, pixel.green, pixel.blue) / 255.0F;
    }
  }
  cv::Mat lab;
  cv::cvtColor(rgb, lab, cv::COLOR_RGB2Lab);
  Raster<LabColour> colours(pixels.width(), pixels.height());
  for (int row = 0; row < pixels.height(); ++row) {
    const auto* const from = lab.ptr<cv::Vec3f>(row);
    for (int column = 0; column < pixels.width(); ++column) {
      colours.at(column, row) = {from[column][0], from[column][1], from[column][2]};
    }
  }
  return colours;
}

/// Along one axis of a level: which of its pixels are looked at. Pixel i covers cells [i, i + 1) * cells_per_pixel.
struct Span {
  int first = 0, count = 0;
};

Span span_around(
    double at_in_cells, int cells, double radius_in_cells, int cells_per_pixel, int most) {
  const int all = (cells + cells_per_pixel - 1) / cells_per_pixel;
  const double middle = at_in_cells / cells_per_pixel;
  const double reach = std::min(radius_in_cells / cells_per_pixel, most / 2.0);
  const int first = std::clamp(static_cast<int>(std::floor(middle - reach)), 0, all - 1);
  const int end = std::min({static_cast<int>(std::ceil(middle + reach)), first + most, all});
  return {first, std::max(1, end - first)};
}

}  // namespace

float colour_difference(const LabColour& one, const LabColour& other) {
  const float lightness = one.lightness - other.lightness;
  const float a = one.a - other.a;
  const float b = one.b - other.b;
  return std::sqrt(lightness * lightness + a * a + b * b);
}

AssistWindow::AssistWindow(ImageRaster pixels,
                           const Affine2& enu_from_pixels,
                           const Affine2& pixels_from_enu)
    : pixels_(std::move(pixels)),
      colours_(lab_of(pixels_)),
      enu_from_pixels_(enu_from_pixels),
      pixels_from_enu_(pixels_from_enu) {}

Result<AssistWindow> AssistWindow::create(ImageRaster pixels, const Affine2& enu_from_pixels) {
  NADIR_REQUIRE(!pixels.empty() && pixels.width() <= kMostAssistSide &&
                pixels.height() <= kMostAssistSide);
  const auto pixels_from_enu = enu_from_pixels.inverse();
  if (!pixels_from_enu) return forward_error(pixels_from_enu);
  return AssistWindow(std::move(pixels), enu_from_pixels, *pixels_from_enu);
}

double AssistWindow::metres_per_pixel() const {
  return std::sqrt(std::abs(enu_from_pixels_.linear.determinant()));
}

std::optional<PixelPlace> AssistWindow::pixel_at(const Eigen::Vector2d& point_in_enu_m) const {
  const Eigen::Vector2d at = pixels_from_enu_ * point_in_enu_m;
  // Written so that NaN is outside.
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < width() && at.y() < height())) {
    return std::nullopt;
  }
  return PixelPlace{static_cast<int>(at.x()), static_cast<int>(at.y())};
}

Result<PixelPlace> AssistWindow::seen_pixel_at(const Eigen::Vector2d& point_in_enu_m) const {
  const auto pixel = pixel_at(point_in_enu_m);
  if (!pixel) {
    return fail(ErrorCode::kInvalidOptions, "the place is outside of what is looked at");
  }
  if (!is_seen(pixel->column, pixel->row)) {
    return fail(ErrorCode::kInvalidOptions, "the image shows nothing at the place");
  }
  return *pixel;
}

Result<AssistWindow> read_assist_window(const OverheadTiles& tiles,
                                        const Eigen::Vector2d& at_in_enu_m,
                                        const AssistWindowOptions& options) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  const double cell_m = tiles.metres_per_cell();
  const Eigen::Vector2d offset_m = at_in_enu_m - tiles.top_left_in_enu_m();
  const Eigen::Vector2d at(offset_m.x() / cell_m, -offset_m.y() / cell_m);
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < tiles.width() && at.y() < tiles.height())) {
    return fail(ErrorCode::kInvalidOptions, "the place is outside of the image");
  }
  const double radius = options.radius_m / cell_m;
  int level = 0;
  while (level + 1 < tiles.level_count() &&
         2.0 * radius / static_cast<double>(1 << level) > options.most_pixels) {
    ++level;
  }
  const int scale = 1 << level;
  const Span columns = span_around(at.x(), tiles.width(), radius, scale, options.most_pixels);
  const Span rows = span_around(at.y(), tiles.height(), radius, scale, options.most_pixels);
  ImageRaster pixels(columns.count, rows.count, ImagePixel{0, 0, 0, 0});
  const int last_column = (columns.first + columns.count - 1) / kTileSide;
  const int last_row = (rows.first + rows.count - 1) / kTileSide;
  for (int tile_row = rows.first / kTileSide; tile_row <= last_row; ++tile_row) {
    for (int tile_column = columns.first / kTileSide; tile_column <= last_column; ++tile_column) {
      const TileAddress address{level, tile_column, tile_row};
      const auto picture = tiles.picture(address);
      if (!picture) return forward_error(picture);
      const Eigen::Vector4i cells = tiles.cells_of(address);
      // The pixels of a tile at the border need not be of the level's size: the one that holds the centre counts.
      const auto within = [&](int pixel, int axis, int count) {
        const double cell = (pixel + 0.5) * scale - cells[axis];
        return std::min(count - 1, static_cast<int>(cell * count / cells[axis + 2]));
      };
      const int right = std::min(columns.first + columns.count, (tile_column + 1) * kTileSide);
      const int bottom = std::min(rows.first + rows.count, (tile_row + 1) * kTileSide);
      for (int row = std::max(rows.first, tile_row * kTileSide); row < bottom; ++row) {
        const int from_row = within(row, 1, picture->height());
        for (int column = std::max(columns.first, tile_column * kTileSide); column < right;
             ++column) {
          pixels.at(column - columns.first, row - rows.first) =
              picture->at(within(column, 0, picture->width()), from_row);
        }
      }
    }
  }
  Affine2 enu_from_pixels;
  enu_from_pixels.linear << scale * cell_m, 0.0, 0.0, -scale * cell_m;
  enu_from_pixels.offset = tiles.top_left_in_enu_m() +
                           enu_from_pixels.linear * Eigen::Vector2d(columns.first, rows.first);
  return AssistWindow::create(std::move(pixels), enu_from_pixels);
}

}  // namespace nadir
