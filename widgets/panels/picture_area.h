// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "widgets/kit/ui.h"
#include "widgets/panels/picture.h"

namespace nadir {

/// How far a picture is magnified, and which of its places is in the middle of the area.
struct PictureZoom {
  double factor = 1.0;               ///< 1: all of it fits; up to 64.
  Eigen::Vector2d centre{0.5, 0.5};  ///< Shares of width and height, from the upper left corner.
  std::optional<Eigen::Vector2d>
      grabbed;  ///< Place of the picture that a drag holds, in the same shares.
  friend bool operator==(const PictureZoom&, const PictureZoom&) = default;
};

/// Where all of a picture lies on its area's page: as large as it fits, times the factor. A magnified picture leaves no
/// border empty that it could fill.
[[nodiscard]] PageRect picture_place(double width,
                                     double height,
                                     const PageRect& page,
                                     const PictureZoom& zoom);

/// The middle of the pixel that the mouse is on, on an area's page. The mouse is told by the pixel's upper left corner, and what is
/// drawn there is what lies at its middle.
[[nodiscard]] inline Eigen::Vector2d middle_of_pixel(const Eigen::Vector2d& mouse) {
  return mouse + Eigen::Vector2d(0.5, -0.5);
}

/// The pixel of a raster of another size that shows the middle of a pixel.
[[nodiscard]] Eigen::Vector2i pixel_of_other_size(const Eigen::Vector2i& pixel,
                                                  const Eigen::Vector2i& size,
                                                  const Eigen::Vector2i& other_size);

struct PictureInput {
  kit::AreaInput area;
  PageRect where;                        ///< Of the whole picture, on the area's page.
  std::optional<Eigen::Vector2i> pixel;  ///< Column and row that the mouse's pixel shows.
};

/// A picture in an area of the given size. @param size  Pixels; 0: what is left, or as high as the picture's shape wants.
[[nodiscard]] PictureInput draw_picture(kit::Ui& ui,
                                        const std::string& name,
                                        const Picture& picture,
                                        const TextureOf& texture_of,
                                        const Eigen::Vector2d& size = Eigen::Vector2d::Zero());
/// The same, which the wheel magnifies at the mouse, a drag moves and a double click shows whole again.
[[nodiscard]] PictureInput draw_picture(kit::Ui& ui,
                                        const std::string& name,
                                        const Picture& picture,
                                        const TextureOf& texture_of,
                                        PictureZoom& zoom,
                                        const Eigen::Vector2d& size = Eigen::Vector2d::Zero());

/// The corners of a rectangle, for Canvas::fill.
[[nodiscard]] std::array<Eigen::Vector2d, 4> corners_of(const PageRect& rect);
/// A line of one pixel around a rectangle.
void outline(Canvas& canvas, const PageRect& rect, Rgba colour, double width_px = 1.0);

}  // namespace nadir
