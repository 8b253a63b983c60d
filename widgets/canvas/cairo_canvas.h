// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "widgets/canvas/canvas.h"

namespace nadir {

/// Draws with Cairo: antialiased pixels, or a PDF whose text can be searched and whose fonts are inside.
class CairoCanvas : public Canvas {
 public:
  /// Sides in pixels. @errors of Cairo (out of memory) are std::runtime_error.
  static std::unique_ptr<CairoCanvas> for_pixels(int width, int height, Rgba background);
  /// A page of width x height pixels of 1/dpi inch. @param subject  Kept in the document's properties.
  static std::unique_ptr<CairoCanvas> for_pdf(
      int width, int height, double dpi, const std::string& title, const std::string& subject);

  ~CairoCanvas() override;
  CairoCanvas(const CairoCanvas&) = delete;
  CairoCanvas& operator=(const CairoCanvas&) = delete;

  void stroke(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) override;
  void fill(std::span<const Eigen::Vector2d> outline, Rgba colour) override;
  void text(const Eigen::Vector2d& point, const std::string& line, const TextStyle& style) override;
  void image(const PageRect& where, const Raster<Rgba>& pixels) override;
  void push_clip(const PageRect& inside) override;
  void pop_clip() override;

  /// What has been drawn, not premultiplied; of a canvas made by for_pixels().
  [[nodiscard]] Raster<Rgba> pixels() const;
  /// The whole document; of a canvas made by for_pdf(). Nothing can be drawn afterwards.
  [[nodiscard]] std::string finish_pdf();

 private:
  struct Implementation;
  explicit CairoCanvas(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir
