// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "widgets/canvas/canvas.h"
#include "widgets/figures/page.h"
#include "widgets/views/legend.h"

namespace nadir {

/// Rectangles of a page, cut from what is left of it, and the words around its panels.
///
/// A page may be smaller than its words. They give way in this order, and panels last: the foot is cut to the lines that
/// leave three quarters of the page to the rest, then to none; a legend that would take more than a third of what is left
/// is not drawn; nor are captions of panels lower than 42 points; then panels are left out, the last ones first.

/// The page without its margin of 8 points, or less on the smallest.
[[nodiscard]] PageRect page_inside(const PageFormat& format);
/// Cuts a strip off, no higher than what is left; `rest` shrinks by it and by the gap below or above the strip.
[[nodiscard]] PageRect take_top(PageRect& rest, double height, double gap = 0.0);
[[nodiscard]] PageRect take_bottom(PageRect& rest, double height, double gap = 0.0);
/// Side by side from the left, or one below the other from the top, with widths or heights in the given proportions.
[[nodiscard]] std::vector<PageRect> columns(const PageRect& whole,
                                            const std::vector<double>& shares,
                                            double gap);
[[nodiscard]] std::vector<PageRect> rows(const PageRect& whole,
                                         const std::vector<double>& shares,
                                         double gap);

[[nodiscard]] bool overlap(const PageRect& a, const PageRect& b);
/// The largest rectangle of a picture's shape inside of another, in its middle.
[[nodiscard]] PageRect fitted(double width, double height, const PageRect& inside);

/// Smallest size of a panel that says anything, pixels.
struct LeastRoom {
  double width = 0.0, height = 0.0;
  [[nodiscard]] bool fits_in(const PageRect& panel) const {
    return panel.width >= width && panel.height >= height;
  }
};
[[nodiscard]] LeastRoom least_map(const PageFormat& format);
[[nodiscard]] LeastRoom least_chart(const PageFormat& format);
[[nodiscard]] LeastRoom least_picture(const PageFormat& format);

/// As columns() or rows(), with the last ones left out until the others have room: they are empty, 0 wide and high. All
/// are where not even the first one has.
[[nodiscard]] std::vector<PageRect> fitting_columns(const PageRect& whole,
                                                    const std::vector<double>& shares,
                                                    double gap,
                                                    const LeastRoom& least);
[[nodiscard]] std::vector<PageRect> fitting_rows(const PageRect& whole,
                                                 const std::vector<double>& shares,
                                                 double gap,
                                                 const LeastRoom& least);
/// Small muted lines below everything: cuts their strip off `rest`. Words are parted by " · " and " | ", which are left out
/// where a line breaks.
void draw_foot(Canvas& canvas, const PageFormat& format, PageRect& rest, const std::string& text);
/// What a caption takes of its panel's height.
inline constexpr double kCaptionPt = 14.0;
/// "(a) east error" above a panel: cuts its strip off the panel's top.
void draw_caption(Canvas& canvas,
                  const PageFormat& format,
                  PageRect& panel,
                  const std::string& text);
/// A legend on top of the page: cuts its strip off `rest`.
void draw_page_legend(Canvas& canvas,
                      const PageFormat& format,
                      PageRect& rest,
                      std::span<const LegendEntry> entries);
/// A thin line around a panel.
void draw_frame(Canvas& canvas, const PageFormat& format, const PageRect& panel);
/// What a panel says when it has nothing to show: centred, muted, broken to its width, cut to its height.
void draw_message(Canvas& canvas,
                  const PageFormat& format,
                  const PageRect& panel,
                  const std::string& text);

/// Breaks at spaces so that no line is wider than `width_px`; a single longer word stays whole. Words that are only "·" or
/// "|" neither begin nor end a line.
[[nodiscard]] std::vector<std::string> broken_to(const std::string& text,
                                                 const TextStyle& style,
                                                 double width_px);
/// The text, or its beginning with an ellipsis, no wider than that; empty where not even the ellipsis has room.
[[nodiscard]] std::string shortened_to(const std::string& text,
                                       const TextStyle& style,
                                       double width_px);

}  // namespace nadir
