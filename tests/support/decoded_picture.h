// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "widgets/canvas/canvas.h"

namespace nadir {

/// Pixels as OpenCV decodes a file of three or four channels.
inline Raster<Rgba> pixels_of_decoded(const cv::Mat& image) {
  Raster<Rgba> pixels(image.cols, image.rows);
  for (int row = 0; row < image.rows; ++row) {
    const unsigned char* in = image.ptr(row);
    for (Rgba& pixel : pixels.row(row)) {
      pixel = {in[2], in[1], in[0], image.channels() == 4 ? in[3] : std::uint8_t{255}};
      in += image.channels();
    }
  }
  return pixels;
}

}  // namespace nadir
