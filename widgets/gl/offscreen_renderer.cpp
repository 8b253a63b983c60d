// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/offscreen_renderer.h"

#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstring>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/require.h"

namespace nadir {
namespace {

/// Colours apart from opacity again: drawing onto nothing multiplies them, and averaging must see them so.
void divide_by_alpha(Raster<Rgba>& pixels) {
  for (Rgba& pixel : pixels.values()) {
    if (pixel.alpha == 255) continue;
    const auto divided = [alpha = int{pixel.alpha}](int channel) {
      return alpha == 0
                 ? std::uint8_t{0}
                 : static_cast<std::uint8_t>(std::min(255, (channel * 255 + alpha / 2) / alpha));
    };
    pixel = {divided(pixel.red), divided(pixel.green), divided(pixel.blue), pixel.alpha};
  }
}

}  // namespace

Result<std::unique_ptr<OffscreenRenderer>> OffscreenRenderer::create() {
  auto context = OffscreenContext::create();
  if (!context) return forward_error(context);
  return std::unique_ptr<OffscreenRenderer>(new OffscreenRenderer(std::move(*context)));
}

OffscreenRenderer::OffscreenRenderer(std::unique_ptr<OffscreenContext> context)
    : context_(std::move(context)) {
  window_->SetAlphaBitPlanes(1);
}

OffscreenRenderer::~OffscreenRenderer() {
  context_->make_current();
  for (vtkRenderer* const scene : attached_) window_->RemoveRenderer(scene);
  window_->Finalize();
}

void OffscreenRenderer::attach(vtkRenderer& scene) {
  constexpr std::size_t kMostAttached = 4;
  const auto known = std::find(attached_.begin(), attached_.end(), &scene);
  if (known != attached_.end()) {
    std::rotate(known, known + 1, attached_.end());
  } else {
    if (attached_.size() == kMostAttached) {
      window_->RemoveRenderer(attached_.front());
      attached_.erase(attached_.begin());
    }
    window_->AddRenderer(&scene);
    attached_.push_back(&scene);
  }
  for (vtkRenderer* const each : attached_) each->SetDraw(each == &scene ? 1 : 0);
}

Result<Raster<Rgba>> OffscreenRenderer::render(vtkRenderer& scene,
                                               int width,
                                               int height,
                                               int supersampling) {
  NADIR_REQUIRE(width > 0 && height > 0 && supersampling > 0);
  context_->make_current();
  const int fine_width = width * supersampling;
  const int fine_height = height * supersampling;
  if (fine_width > kMostSide || fine_height > kMostSide) {
    return fail(ErrorCode::kUnsupported, "{} x {} pixels are more than OpenGL can draw at once",
                fine_width, fine_height);
  }
  attach(scene);
  window_->SetSize(fine_width, fine_height);
  window_->Render();
  vtkNew<vtkUnsignedCharArray> read;
  window_->GetRGBACharPixelData(0, 0, fine_width - 1, fine_height - 1, 0, read);
  if (read->GetNumberOfValues() != vtkIdType{4} * fine_width * fine_height) {
    return fail(ErrorCode::kUnsupported, "OpenGL gave no pixels back of {} x {}", fine_width,
                fine_height);
  }
  const cv::Mat drawn(fine_height, fine_width, CV_8UC4, read->GetPointer(0));
  Raster<Rgba> pixels(width, height);
  cv::Mat out(height, width, CV_8UC4, pixels.data());
  cv::Mat small;
  if (supersampling > 1) {
    cv::resize(drawn, small, out.size(), 0.0, 0.0, cv::INTER_AREA);
  } else {
    small = drawn;
  }
  cv::flip(small, out, 0);  // OpenGL's rows begin at the bottom
  divide_by_alpha(pixels);
  return pixels;
}

}  // namespace nadir
