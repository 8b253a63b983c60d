// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "widgets/canvas/canvas.h"
#include "widgets/gl/offscreen_renderer.h"
#include "widgets/views/theme.h"

namespace nadir {

/// The paper that a figure is drawn on.
struct PageFormat {
  int width = 1600, height = 1000;  ///< Pixels.
  double dpi = 200.0;               ///< Text is 9 points of 1/72 inch, whatever the size.
  ThemeName theme = ThemeName::kLight;
  bool is_transparent = false;

  [[nodiscard]] double px_per_pt() const { return dpi / 72.0; }
  [[nodiscard]] const Theme& colours() const { return nadir::theme(theme); }
};

/// What figures draw with: one page after another of a film or of a report.
class FigureContext {
 public:
  explicit FigureContext(const PageFormat& format) { set_format(format); }
  [[nodiscard]] const PageFormat& format() const { return format_; }
  /// The next pages are of this format; sets `supersampling` to what suits a still picture.
  void set_format(const PageFormat& format);
  /// Made when it is first asked for, because a chart needs none. @errors kUnsupported: no OpenGL on this machine.
  [[nodiscard]] Result<OffscreenRenderer*> renderer();
  /// 2 for a still picture, 1 for the frames of a film and where the page is too large for more.
  int supersampling = 2;

 private:
  PageFormat format_;
  std::unique_ptr<OffscreenRenderer> renderer_;
};

struct FigureTimes {
  double first_s = 0.0, last_s = 0.0;  ///< Seconds after the first step of the run.
};

/// A figure that is ready to be drawn: its data are loaded.
class Figure {
 public:
  virtual ~Figure() = default;
  /// Draws the whole page. @errors as the figure's files and OffscreenRenderer.
  [[nodiscard]] virtual Result<void> draw(Canvas& canvas, FigureContext& context) = 0;
  /// The times that can be shown one by one, for a film; nothing where the figure has no time.
  [[nodiscard]] virtual std::optional<FigureTimes> times() const { return std::nullopt; }
  /// Shows the moment so many seconds after the first step from the next draw() on.
  virtual void show_at(double /*time_s*/) {}
};

/// Facts that go into the file beside the picture.
struct PageFacts {
  std::string title;   ///< Of the document.
  std::string recipe;  ///< TOML that draws the figure again; see figure_recipe.h.
};

/// The figure as pixels. @errors as Figure::draw.
[[nodiscard]] Result<Raster<Rgba>> draw_pixels(Figure& figure, FigureContext& context);

enum class PageFile { kPng, kSvg, kPdf };
/// The whole file as bytes. @errors as Figure::draw.
[[nodiscard]] Result<std::string> draw_file(Figure& figure,
                                            FigureContext& context,
                                            PageFile kind,
                                            const PageFacts& facts);

}  // namespace nadir
