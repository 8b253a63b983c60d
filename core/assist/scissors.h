// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/assist/assist_window.h"
#include "core/label/label_object.h"

namespace nadir {

struct ScissorsOptions {
  double least_edge = 10.0;
  double snap_px = 4.0;
  double simplify_px = 0.3;
  friend bool operator==(const ScissorsOptions&, const ScissorsOptions&) = default;
};
template <typename Options, typename Visitor>
void visit_fields(Options& options, Visitor&& visit) requires
    std::is_same_v<std::remove_const_t<Options>, ScissorsOptions> {
  visit(options.least_edge,
        Field{"scissors-least-edge", "", "Step of one colour channel, of 255, that is an edge", 1.0,
              120.0});
  visit(options.snap_px,
        Field{"scissors-snap", "px", "How far a place is drawn to the strongest edge around it",
              0.0, 50.0});
  visit(options.simplify_px,
        Field{"scissors-simplify", "px",
              "How far the line may run from the edge to have fewer places", 0.0, 20.0});
}

/// Intelligent scissors: lines that run along the edges of a window, from a fixed place to the one under the hand (Mortensen
/// & Barrett, "Intelligent Scissors for Image Composition", SIGGRAPH 1995, by OpenCV). OpenCV goes from pixel to pixel; each of its
/// places is then put where across the edge colours change fastest, which is within a few tenths of a pixel of the edge.
/// Where nothing was seen is an edge too.
class Scissors {
 public:
  /// O(pixels); about 30 ms in 512 x 512. @errors kInvalidOptions: an option out of its range.
  [[nodiscard]] static Result<Scissors> create(const AssistWindow& window,
                                               const ScissorsOptions& options = {});
  Scissors(Scissors&&) noexcept;
  Scissors& operator=(Scissors&&) noexcept;
  ~Scissors();

  /// On the strongest edge within `snap_px` of a place; the place itself where there is none, or outside of the window.
  [[nodiscard]] Eigen::Vector2d snapped(const Eigen::Vector2d& point_in_enu_m) const;
  /// Fixes the place that lines begin at. Weighs all ways from there: O(pixels), about 70 ms in 512 x 512.
  /// @errors kInvalidOptions: the place is outside of the window.
  [[nodiscard]] Result<void> begin_at(const Eigen::Vector2d& point_in_enu_m);
  /// From the place that was fixed, both ends exactly where they were asked for; two places at least, in enu, metres. In
  /// microseconds. @pre begin_at() has succeeded. @errors kInvalidOptions: the place is outside of the window.
  [[nodiscard]] Result<Ring> line_to(const Eigen::Vector2d& point_in_enu_m) const;

 private:
  struct Parts;
  explicit Scissors(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace nadir
