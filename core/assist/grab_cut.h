// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/assist/pixel_mask.h"
#include "core/base/progress.h"

namespace nadir {

struct GrabCutOptions {
  int iterations = 4;
  double stroke_px = 3.0;
  friend bool operator==(const GrabCutOptions&, const GrabCutOptions&) = default;
};
template <typename Options, typename Visitor>
void visit_fields(Options& options, Visitor&& visit) requires
    std::is_same_v<std::remove_const_t<Options>, GrabCutOptions> {
  visit(options.iterations, Field{"grab-cut-iterations", "",
                                  "Times that the colours of both sides are learnt again", 1, 20});
  visit(options.stroke_px,
        Field{"grab-cut-stroke", "px", "Radius of strokes on the image", 0.5, 100.0});
}

/// What somebody has said about what is wanted, in enu, metres. A place, stroke or ring may reach out of the window.
struct GrabCutMarks {
  Ring around{};  ///< Rectangle or lasso: outside of it nothing is wanted. Empty: anything may be.
  std::vector<Ring> wanted{};    ///< Strokes on what is wanted; a place alone is a dot.
  std::vector<Ring> unwanted{};  ///< Strokes on what is not; where both are it is not wanted.
  [[nodiscard]] bool empty() const { return around.empty() && wanted.empty() && unwanted.empty(); }
};

/// What is wanted by the colours of both sides and the edges between them (Rother, Kolmogorov & Blake, "GrabCut", SIGGRAPH
/// 2004, by OpenCV). Learnt on at most 160 pixels on a side, then drawn along the edges of the window's own pixels. More marks
/// refine it: the same marks always give the same, on any number of threads, so that taking a stroke back takes its effect back. In
/// 512 x 512 pixels about 150 ms, in 1024 x 1024 half a second. What is at most a few pixels wide and has no stroke may be lost.
/// @errors kInvalidOptions: an option out of its range; the marks leave nothing that could be wanted, or nothing that could be
/// unwanted; kCancelled.
[[nodiscard]] Result<PixelMask> grab_cut(const AssistWindow& window,
                                         const GrabCutMarks& marks,
                                         const GrabCutOptions& options = {},
                                         const WorkContext& context = {});

}  // namespace nadir
