// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/page.h"

#include <algorithm>

#include "widgets/canvas/cairo_canvas.h"
#include "widgets/canvas/png_file.h"
#include "widgets/canvas/svg_canvas.h"
#include "widgets/gl/vtk_messages.h"

namespace nadir {
namespace {

void fill_background(Canvas& canvas, const PageFormat& format) {
  if (format.is_transparent) return;
  const double width = format.width;
  const double height = format.height;
  const std::array<Eigen::Vector2d, 4> corners = {
      Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(width, 0.0), Eigen::Vector2d(width, height),
      Eigen::Vector2d(0.0, height)};
  canvas.fill(corners, format.colours().page);
}

Result<void> draw_page(Figure& figure, FigureContext& context, Canvas& canvas) {
  send_vtk_messages_to_log();  // charts need no OpenGL, and may complain too
  fill_background(canvas, context.format());
  return figure.draw(canvas, context);
}

}  // namespace

void FigureContext::set_format(const PageFormat& format) {
  constexpr int kFine = 2;
  const bool has_room =
      kFine * std::max(format.width, format.height) <= OffscreenRenderer::kMostSide;
  format_ = format;
  supersampling = has_room ? kFine : 1;
}

Result<OffscreenRenderer*> FigureContext::renderer() {
  if (!renderer_) {
    auto made = OffscreenRenderer::create();
    if (!made) return forward_error(made);
    renderer_ = std::move(*made);
  }
  return renderer_.get();
}

Result<Raster<Rgba>> draw_pixels(Figure& figure, FigureContext& context) {
  const PageFormat& format = context.format();
  const auto canvas = CairoCanvas::for_pixels(format.width, format.height, {0, 0, 0, 0});
  if (auto drawn = draw_page(figure, context, *canvas); !drawn) return forward_error(drawn);
  return canvas->pixels();
}

Result<std::string> draw_file(Figure& figure,
                              FigureContext& context,
                              PageFile kind,
                              const PageFacts& facts) {
  const PageFormat& format = context.format();
  switch (kind) {
    case PageFile::kPng: {
      const auto pixels = draw_pixels(figure, context);
      if (!pixels) return forward_error(pixels);
      return encode_png(*pixels,
                        {format.dpi, {{"Title", facts.title}, {"nadir-recipe", facts.recipe}}});
    }
    case PageFile::kSvg: {
      SvgCanvas canvas(format.width, format.height, format.dpi, facts.title, facts.recipe);
      if (auto drawn = draw_page(figure, context, canvas); !drawn) return forward_error(drawn);
      return canvas.finish();
    }
    case PageFile::kPdf:
      break;
  }
  const auto canvas =
      CairoCanvas::for_pdf(format.width, format.height, format.dpi, facts.title, facts.recipe);
  if (auto drawn = draw_page(figure, context, *canvas); !drawn) return forward_error(drawn);
  return canvas->finish_pdf();
}

}  // namespace nadir
