// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "widgets/canvas/canvas.h"
#include "widgets/figures/page.h"
#include "widgets/views/legend.h"

namespace nadir {

/// Rectangles of a page, cut from what is left of it.

/// The page without its margin of 8 points.
[[nodiscard]] PageRect page_inside(const PageFormat& format);
/// Cuts a strip off; `rest` shrinks by it and by the gap below or above the strip.
[[nodiscard]] PageRect take_top(PageRect& rest, double height, double gap = 0.0);
[[nodiscard]] PageRect take_bottom(PageRect& rest, double height, double gap = 0.0);
/// Side by side from the left, or one below the other from the top, with widths or heights in the given proportions.
[[nodiscard]] std::vector<PageRect> columns(const PageRect& whole,
                                            const std::vector<double>& shares,
                                            double gap);
[[nodiscard]] std::vector<PageRect> rows(const PageRect& whole,
                                         const std::vector<double>& shares,
                                         double gap);

/// One line of small muted text below everything: cuts its strip off `rest`. A line too long for the page is broken.
void draw_foot(Canvas& canvas, const PageFormat& format, PageRect& rest, const std::string& text);
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
/// What a panel says when it has nothing to show: centred, muted, broken to its width.
void draw_message(Canvas& canvas,
                  const PageFormat& format,
                  const PageRect& panel,
                  const std::string& text);

/// Breaks at spaces so that no line is wider than `width_px`; a single longer word stays whole.
[[nodiscard]] std::vector<std::string> broken_to(const std::string& text,
                                                 const TextStyle& style,
                                                 double width_px);

}  // namespace nadir
