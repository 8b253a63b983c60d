// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/base/field.h"
#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/geo/affine2.h"
#include "core/map/overhead_tiles.h"

namespace nadir {

/// CIE L*a*b* (D65) of an sRGB colour: differences are about as large as people see them.
struct LabColour {
  float lightness = 0.0F, a = 0.0F, b = 0.0F;  ///< Lightness in [0, 100]; a and b within +-128.
};
/// CIE 1976: 2 is just seen, 100 is black against white.
[[nodiscard]] float colour_difference(const LabColour& one, const LabColour& other);

/// The pixel in a column and row of a window.
struct PixelPlace {
  int column = 0, row = 0;
  friend bool operator==(const PixelPlace&, const PixelPlace&) = default;
};

/// More pixels on a side are not looked at at once, so that a tool answers while the hand waits.
inline constexpr int kMostAssistSide = 1024;

struct AssistWindowOptions {
  double radius_m = 25.0;
  int most_pixels = 512;
  friend bool operator==(const AssistWindowOptions&, const AssistWindowOptions&) = default;
};
template <typename Options, typename Visitor>
void visit_fields(Options& options, Visitor&& visit) requires
    std::is_same_v<std::remove_const_t<Options>, AssistWindowOptions> {
  visit(options.radius_m,
        Field{"assist-radius", "m", "How far around the hand the image is looked at", 0.1, 10'000});
  visit(options.most_pixels,
        Field{"assist-pixels", "px",
              "Most pixels on a side that are looked at; a larger window is coarser", 16,
              kMostAssistSide});
}

/// A piece of an overhead image that a tool looks at. A value; nothing of an image's look (brightness, contrast) is in it.
/// Coordinates in pixels are those of Affine2: from the *corner* of the upper-left pixel, whose centre is (0.5, 0.5).
class AssistWindow {
 public:
  /// @param pixels  1 to kMostAssistSide on a side. @param enu_from_pixels  Any: turned, sheared, oblong, south up.
  /// @errors kMalformed: it is singular or not finite.
  [[nodiscard]] static Result<AssistWindow> create(ImageRaster pixels,
                                                   const Affine2& enu_from_pixels);

  [[nodiscard]] int width() const { return pixels_.width(); }
  [[nodiscard]] int height() const { return pixels_.height(); }
  [[nodiscard]] const ImageRaster& pixels() const { return pixels_; }
  [[nodiscard]] const Raster<LabColour>& colours() const { return colours_; }
  [[nodiscard]] const Affine2& enu_from_pixels() const { return enu_from_pixels_; }
  [[nodiscard]] const Affine2& pixels_from_enu() const { return pixels_from_enu_; }
  /// Side of a square that covers as much ground as a pixel.
  [[nodiscard]] double metres_per_pixel() const;

  /// Whether anything was seen there; where not, the pixel belongs to nothing.
  [[nodiscard]] bool is_seen(int column, int row) const {
    return pixels_.at(column, row).alpha != 0;
  }
  /// That holds the place; nothing outside of the window.
  [[nodiscard]] std::optional<PixelPlace> pixel_at(const Eigen::Vector2d& point_in_enu_m) const;
  /// The pixel of a place where something was seen. @errors kInvalidOptions: there is none.
  [[nodiscard]] Result<PixelPlace> seen_pixel_at(const Eigen::Vector2d& point_in_enu_m) const;

 private:
  AssistWindow(ImageRaster pixels, const Affine2& enu_from_pixels, const Affine2& pixels_from_enu);

  ImageRaster pixels_;
  Raster<LabColour> colours_;
  Affine2 enu_from_pixels_, pixels_from_enu_;
};

/// What an image shows within `radius_m` of a place, at the finest of its levels that needs no more than `most_pixels` on a
/// side; less where the image ends. Grey, 16-bit and palette images are as OverheadTiles shows them, clear pixels stay clear.
/// @errors kInvalidOptions: the place is outside of the image, an option out of its range; kMalformed: the file is damaged.
[[nodiscard]] Result<AssistWindow> read_assist_window(const OverheadTiles& tiles,
                                                      const Eigen::Vector2d& at_in_enu_m,
                                                      const AssistWindowOptions& options = {});

}  // namespace nadir
