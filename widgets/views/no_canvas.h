// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/canvas/canvas.h"

namespace nadir {

/// Takes a drawing that nobody sees: what it would need can be learnt from it.
class NoCanvas : public Canvas {
 public:
  void stroke(std::span<const Eigen::Vector2d> /*points*/, const StrokeStyle& /*style*/) override {}
  void fill(std::span<const Eigen::Vector2d> /*outline*/, Rgba /*colour*/) override {}
  void text(const Eigen::Vector2d& /*point*/,
            const std::string& /*line*/,
            const TextStyle& /*style*/) override {}
  void image(const PageRect& /*where*/, const Raster<Rgba>& /*pixels*/) override {}
  void push_clip(const PageRect& /*inside*/) override {}
  void pop_clip() override {}
};

}  // namespace nadir
