// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include "tests/support/page_pixels.h"
#include "widgets/canvas/cairo_canvas.h"
#include "widgets/canvas/canvas_device.h"

namespace nadir {

/// A white page on which VTK's painter draws by way of our device.
struct DevicePage {
  DevicePage(int width, int height) : canvas(CairoCanvas::for_pixels(width, height, kWhite)) {
    device->draw_on(*canvas, width, height);
    painter->Begin(device);
    painter->GetPen()->SetColor(0, 0, 0, 255);
    painter->GetPen()->SetWidth(1.0F);
    painter->GetBrush()->SetColor(0, 0, 0, 255);
  }
  ~DevicePage() { painter->End(); }
  DevicePage(const DevicePage&) = delete;
  DevicePage& operator=(const DevicePage&) = delete;

  [[nodiscard]] Raster<Rgba> pixels() const { return canvas->pixels(); }
  [[nodiscard]] PageRect ink() const { return ink_box(canvas->pixels(), kWhite); }

  std::unique_ptr<CairoCanvas> canvas;
  vtkNew<CanvasDevice> device;
  vtkNew<vtkContext2D> painter;
};

}  // namespace nadir
