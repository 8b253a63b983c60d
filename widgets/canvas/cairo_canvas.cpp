// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/cairo_canvas.h"

#include <cairo/cairo-pdf.h>
#include <cairo/cairo.h>

#include <numbers>
#include <stdexcept>

#include "core/base/require.h"
#include "widgets/canvas/fonts.h"
#include "widgets/canvas/page_lines.h"
#include "widgets/canvas/printable.h"

namespace nadir {
namespace {

constexpr double kPointsPerInch = 72.0;
constexpr double kRadPerDeg = std::numbers::pi / 180.0;

struct FreeSurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct FreeContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
struct FreeOptions {
  void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
using Surface = std::unique_ptr<cairo_surface_t, FreeSurface>;
using Context = std::unique_ptr<cairo_t, FreeContext>;

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

Context context_on(const Surface& surface) {
  check(cairo_surface_status(surface.get()));
  Context context(cairo_create(surface.get()));
  check(cairo_status(context.get()));
  // Unhinted, so that a line of text is as long on paper as on the screen and layouts agree.
  const std::unique_ptr<cairo_font_options_t, FreeOptions> options(cairo_font_options_create());
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(context.get(), options.get());
  cairo_set_fill_rule(context.get(), CAIRO_FILL_RULE_EVEN_ODD);
  cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
  return context;
}

void set_colour(cairo_t* context, Rgba colour) {
  cairo_set_source_rgba(context, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0,
                        colour.alpha / 255.0);
}

void set_font(cairo_t* context, const TextStyle& style) {
  cairo_select_font_face(context, font_family(style.face), CAIRO_FONT_SLANT_NORMAL,
                         style.is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size_px);
}

double advance_px(cairo_t* context, const std::string& line) {
  cairo_text_extents_t extents{};
  cairo_text_extents(context, line.c_str(), &extents);
  return extents.x_advance;
}

/// Cairo's pixels: premultiplied, native 32-bit words 0xAARRGGBB.
std::uint32_t premultiplied(Rgba colour) {
  if (colour.alpha == 255) {
    return 0xFF000000U | (std::uint32_t{colour.red} << 16U) | (std::uint32_t{colour.green} << 8U) |
           colour.blue;
  }
  const auto scaled = [alpha = std::uint32_t{colour.alpha}](std::uint32_t channel) {
    return (channel * alpha + 127U) / 255U;
  };
  return (std::uint32_t{colour.alpha} << 24U) | (scaled(colour.red) << 16U) |
         (scaled(colour.green) << 8U) | scaled(colour.blue);
}

Rgba straight(std::uint32_t word) {
  const std::uint32_t alpha = word >> 24U;
  if (alpha == 0) return {0, 0, 0, 0};
  if (alpha == 255) {  // nearly always, and then there is nothing to divide
    return {static_cast<std::uint8_t>(word >> 16U), static_cast<std::uint8_t>(word >> 8U),
            static_cast<std::uint8_t>(word)};
  }
  const auto scaled = [alpha](std::uint32_t channel) {
    return static_cast<std::uint8_t>(((channel & 0xFFU) * 255U + alpha / 2U) / alpha);
  };
  return {scaled(word >> 16U), scaled(word >> 8U), scaled(word), static_cast<std::uint8_t>(alpha)};
}

cairo_status_t append(void* closure, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

TextExtent measure_text(const std::string& line, const TextStyle& style) {
  // Nothing is drawn on it, but fonts are measured by a context, and a context needs a surface.
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const Context context = context_on(surface);
  set_font(context.get(), style);
  cairo_text_extents_t capital{};
  cairo_text_extents_t hanging{};
  cairo_text_extents(context.get(), "H", &capital);
  cairo_text_extents(context.get(), "g", &hanging);
  return {advance_px(context.get(), printable(line)), -capital.y_bearing,
          hanging.height + hanging.y_bearing};
}

struct CairoCanvas::Implementation {
  int width = 0, height = 0;
  std::string document;  ///< Before the surface, which writes to it until it is finished.
  Surface surface;
  Context context;

  [[nodiscard]] cairo_t* page() const { return context.get(); }
  [[nodiscard]] double flipped(double y_up) const { return height - y_up; }
  [[nodiscard]] Eigen::AlignedBox2d surroundings() const {
    return surroundings_of_page(width, height);
  }

  void trace(std::span<const Eigen::Vector2d> points) const {
    cairo_new_path(page());
    for (const Eigen::Vector2d& point : points)
      cairo_line_to(page(), point.x(), flipped(point.y()));
  }
};

CairoCanvas::CairoCanvas(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
CairoCanvas::~CairoCanvas() = default;

std::unique_ptr<CairoCanvas> CairoCanvas::for_pixels(int width, int height, Rgba background) {
  auto made = std::make_unique<Implementation>();
  made->width = width;
  made->height = height;
  made->surface.reset(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  made->context = context_on(made->surface);
  set_colour(made->page(), background);
  cairo_paint(made->page());
  return std::unique_ptr<CairoCanvas>(new CairoCanvas(std::move(made)));
}

std::unique_ptr<CairoCanvas> CairoCanvas::for_pdf(
    int width, int height, double dpi, const std::string& title, const std::string& subject) {
  auto made = std::make_unique<Implementation>();
  made->width = width;
  made->height = height;
  const double points_per_px = kPointsPerInch / dpi;
  made->surface.reset(cairo_pdf_surface_create_for_stream(
      append, &made->document, width * points_per_px, height * points_per_px));
  made->context = context_on(made->surface);
  cairo_surface_t* const surface = made->surface.get();
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, printable(title).c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, printable(subject).c_str());
  // The same figure is the same file whenever it is drawn, so no clock is asked.
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  cairo_scale(made->page(), points_per_px, points_per_px);
  return std::unique_ptr<CairoCanvas>(new CairoCanvas(std::move(made)));
}

void CairoCanvas::stroke(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) {
  cairo_t* const page = implementation_->page();
  set_colour(page, style.colour);
  cairo_set_line_width(page, style.width_px);
  for (const LinePiece& piece : line_inside(points, implementation_->surroundings())) {
    implementation_->trace(piece.points);
    cairo_set_dash(page, style.dashes_px.data(), static_cast<int>(style.dashes_px.size()),
                   piece.begin);
    cairo_stroke(page);
  }
}

void CairoCanvas::fill(std::span<const Eigen::Vector2d> outline, Rgba colour) {
  const auto area = area_inside(outline, implementation_->surroundings());
  if (area.empty()) return;
  cairo_t* const page = implementation_->page();
  implementation_->trace(area);
  cairo_close_path(page);
  set_colour(page, colour);
  cairo_fill(page);
}

void CairoCanvas::text(const Eigen::Vector2d& point,
                       const std::string& raw_line,
                       const TextStyle& style) {
  const std::string line = printable(raw_line);
  cairo_t* const page = implementation_->page();
  cairo_save(page);
  set_font(page, style);
  set_colour(page, style.colour);
  cairo_translate(page, point.x(), implementation_->flipped(point.y()));
  cairo_rotate(page, -style.rotation_deg * kRadPerDeg);
  double shift_px = 0.0;
  if (style.align == TextAlign::kCentre) shift_px = advance_px(page, line) / 2.0;
  if (style.align == TextAlign::kRight) shift_px = advance_px(page, line);
  cairo_move_to(page, -shift_px, 0.0);
  cairo_show_text(page, line.c_str());
  cairo_restore(page);
}

void CairoCanvas::image(const PageRect& where, const Raster<Rgba>& pixels) {
  if (pixels.empty() || where.width <= 0.0 || where.height <= 0.0) return;
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, pixels.width(), pixels.height()));
  check(cairo_surface_status(surface.get()));
  cairo_surface_flush(surface.get());
  unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < pixels.height(); ++row) {
    auto* const words =
        reinterpret_cast<std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(row) * stride);
    for (int column = 0; column < pixels.width(); ++column) {
      words[column] = premultiplied(pixels.at(column, row));
    }
  }
  cairo_surface_mark_dirty(surface.get());
  cairo_t* const page = implementation_->page();
  cairo_save(page);
  cairo_translate(page, where.left, implementation_->flipped(where.top()));
  cairo_scale(page, where.width / pixels.width(), where.height / pixels.height());
  cairo_set_source_surface(page, surface.get(), 0.0, 0.0);
  const bool is_enlarged = where.width > pixels.width() || where.height > pixels.height();
  cairo_pattern_set_filter(cairo_get_source(page),
                           is_enlarged ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD);
  cairo_pattern_set_extend(cairo_get_source(page), CAIRO_EXTEND_PAD);
  cairo_rectangle(page, 0.0, 0.0, pixels.width(), pixels.height());
  cairo_fill(page);
  cairo_restore(page);
}

void CairoCanvas::push_clip(const PageRect& inside) {
  cairo_t* const page = implementation_->page();
  cairo_save(page);
  cairo_rectangle(page, inside.left, implementation_->flipped(inside.top()), inside.width,
                  inside.height);
  cairo_clip(page);
}

void CairoCanvas::pop_clip() { cairo_restore(implementation_->page()); }

Raster<Rgba> CairoCanvas::pixels() const {
  cairo_surface_t* const surface = implementation_->surface.get();
  NADIR_REQUIRE(cairo_surface_get_type(surface) == CAIRO_SURFACE_TYPE_IMAGE);
  cairo_surface_flush(surface);
  Raster<Rgba> pixels(implementation_->width, implementation_->height);
  const unsigned char* const bytes = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int row = 0; row < pixels.height(); ++row) {
    const auto* const words =
        reinterpret_cast<const std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(row) * stride);
    for (int column = 0; column < pixels.width(); ++column) {
      pixels.at(column, row) = straight(words[column]);
    }
  }
  return pixels;
}

std::string CairoCanvas::finish_pdf() {
  cairo_surface_t* const surface = implementation_->surface.get();
  NADIR_REQUIRE(cairo_surface_get_type(surface) == CAIRO_SURFACE_TYPE_PDF);
  cairo_show_page(implementation_->page());
  cairo_surface_finish(surface);
  check(cairo_surface_status(surface));
  return std::move(implementation_->document);
}

}  // namespace nadir
