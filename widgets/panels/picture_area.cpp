// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/picture_area.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nadir {
namespace {

constexpr double kMostPictureZoom = 64.0;
constexpr double kZoomPerNotch = 1.25;

/// Shares of the picture, from its upper left corner, that a point of the page shows.
Eigen::Vector2d share_at(const Eigen::Vector2d& on_page, const PageRect& where) {
  return {(on_page.x() - where.left) / where.width, (where.top() - on_page.y()) / where.height};
}

/// The centre that puts a share of the picture at a point of the page.
Eigen::Vector2d centre_with(const Eigen::Vector2d& share,
                            const Eigen::Vector2d& on_page,
                            const PageRect& page,
                            const PageRect& where) {
  const Eigen::Vector2d offset = on_page - page.centre();
  return {share.x() - offset.x() / where.width, share.y() + offset.y() / where.height};
}

void apply_gestures(const kit::AreaInput& area, double width, double height, PictureZoom& zoom) {
  const PageRect page = area.page();
  PageRect where = picture_place(width, height, page, zoom);
  if (area.is_hovered && area.wheel.y() != 0.0) {
    const Eigen::Vector2d middle = middle_of_pixel(area.mouse);
    const Eigen::Vector2d share = share_at(middle, where);
    zoom.factor =
        std::clamp(zoom.factor * std::pow(kZoomPerNotch, area.wheel.y()), 1.0, kMostPictureZoom);
    where = picture_place(width, height, page, zoom);
    zoom.centre = centre_with(share, middle, page, where);
  }
  if (area.drag && area.drag->button == kit::MouseButton::kLeft) {
    if (area.drag->was_started || !zoom.grabbed) zoom.grabbed = share_at(area.drag->start, where);
    zoom.centre = centre_with(*zoom.grabbed, area.mouse, page, where);
  } else {
    zoom.grabbed.reset();
  }
  if (area.double_clicked) zoom = {};
  if (zoom.factor <= 1.0) zoom.centre = {0.5, 0.5};
}

PictureInput show(kit::Ui& ui,
                  const std::string& name,
                  const Picture& picture,
                  const TextureOf& texture_of,
                  PictureZoom* zoom,
                  Eigen::Vector2d size) {
  PictureInput made;
  const double width = picture ? picture.pixels->width() : 4.0;
  const double height = picture ? picture.pixels->height() : 3.0;
  if (size.x() <= 0.0) size.x() = ui.room().width;
  if (size.y() <= 0.0) size.y() = std::min(std::round(size.x() * height / width), 2.0 * size.x());
  made.area = ui.area(name, size, zoom != nullptr ? kit::Wheel::kOwn : kit::Wheel::kScrolls);
  if (zoom != nullptr) apply_gestures(made.area, width, height, *zoom);
  const PageRect page = made.area.page();
  made.where = picture_place(width, height, page, zoom != nullptr ? *zoom : PictureZoom{});
  Canvas& canvas = ui.canvas();
  if (picture) {
    canvas.fill(corners_of(made.where), with_opacity(ui.theme().line, 0.35));
    if (const kit::TextureId texture = texture_of ? texture_of(picture) : 0; texture != 0) {
      ui.image(texture, made.where, false);
    } else {
      canvas.image(made.where, *picture.pixels);
    }
  }
  outline(canvas, made.where, ui.theme().line);
  if (picture && made.area.is_hovered) {
    const Eigen::Vector2d share = share_at(middle_of_pixel(made.area.mouse), made.where);
    const Eigen::Vector2i pixel(static_cast<int>(std::floor(share.x() * width)),
                                static_cast<int>(std::floor(share.y() * height)));
    if (picture.pixels->contains(pixel.x(), pixel.y())) made.pixel = pixel;
  }
  return made;
}

}  // namespace

Eigen::Vector2i pixel_of_other_size(const Eigen::Vector2i& pixel,
                                    const Eigen::Vector2i& size,
                                    const Eigen::Vector2i& other_size) {
  // Its middle, (pixel + 1/2) / size of the way, in whole numbers.
  const auto along = [&](int axis) {
    return (2 * pixel[axis] + 1) * other_size[axis] / (2 * size[axis]);
  };
  return {along(0), along(1)};
}

PageRect picture_place(double width, double height, const PageRect& page, const PictureZoom& zoom) {
  const double scale = std::min(page.width / width, page.height / height) * zoom.factor;
  PageRect where{0.0, 0.0, width * scale, height * scale};
  where.left = page.centre().x() - zoom.centre.x() * where.width;
  where.bottom = page.centre().y() - (1.0 - zoom.centre.y()) * where.height;
  // What is larger than the page covers it; what is smaller lies in its middle.
  const auto settled = [](double low, double length, double page_low, double page_length) {
    if (length <= page_length) return page_low + (page_length - length) / 2.0;
    return std::clamp(low, page_low + page_length - length, page_low);
  };
  where.left = settled(where.left, where.width, page.left, page.width);
  where.bottom = settled(where.bottom, where.height, page.bottom, page.height);
  return where;
}

PictureInput draw_picture(kit::Ui& ui,
                          const std::string& name,
                          const Picture& picture,
                          const TextureOf& texture_of,
                          const Eigen::Vector2d& size) {
  return show(ui, name, picture, texture_of, nullptr, size);
}

PictureInput draw_picture(kit::Ui& ui,
                          const std::string& name,
                          const Picture& picture,
                          const TextureOf& texture_of,
                          PictureZoom& zoom,
                          const Eigen::Vector2d& size) {
  return show(ui, name, picture, texture_of, &zoom, size);
}

std::array<Eigen::Vector2d, 4> corners_of(const PageRect& rect) {
  return {Eigen::Vector2d(rect.left, rect.bottom), Eigen::Vector2d(rect.right(), rect.bottom),
          Eigen::Vector2d(rect.right(), rect.top()), Eigen::Vector2d(rect.left, rect.top())};
}

void outline(Canvas& canvas, const PageRect& rect, Rgba colour, double width_px) {
  const auto corners = corners_of(rect);
  const std::array<Eigen::Vector2d, 6> line = {corners[0], corners[1], corners[2],
                                               corners[3], corners[0], corners[1]};
  canvas.stroke(line, {colour, width_px});
}

}  // namespace nadir
