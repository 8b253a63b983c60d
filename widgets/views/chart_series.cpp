// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_series.h"

#include <algorithm>
#include <cmath>

#include "core/base/require.h"
#include "core/eval/series.h"

namespace nadir {
namespace {

constexpr double kMostPointsPerPx = 4.0;
constexpr double kFarSpans =
    1000.0;  ///< Cairo counts pixels in 24 bits: so many axis lengths away is safe.

double brought_near(double value, const AxisRange& range) {
  return std::clamp(value, range.low - kFarSpans * range.span(),
                    range.high + kFarSpans * range.span());
}

/// Whether a line from one x to another passes over the axis at all.
bool is_over(double from, double to, const AxisRange& range) {
  return std::max(from, to) >= range.low && std::min(from, to) <= range.high;
}

/// Splits 0 .. n-1 into runs of points that can be drawn and that some line in sight touches. A run ends where a point
/// cannot be drawn or no line leads on that is in sight.
template <typename CanDraw>
std::vector<std::pair<std::size_t, std::size_t>> runs_in_sight(const std::vector<double>& x,
                                                               const AxisRange& range,
                                                               CanDraw can_draw) {
  std::vector<std::pair<std::size_t, std::size_t>> runs;
  std::size_t first = 0;
  while (first < x.size()) {
    if (!can_draw(first)) {
      ++first;
      continue;
    }
    std::size_t end = first + 1;
    while (end < x.size() && can_draw(end) && is_over(x[end - 1], x[end], range)) ++end;
    const bool is_alone_outside = end == first + 1 && !is_over(x[first], x[first], range);
    if (!is_alone_outside) runs.emplace_back(first, end);
    // A run that ends out of sight may go on into sight from its last point.
    const bool leads_on = end < x.size() && can_draw(end);
    first = leads_on && !is_over(x[end - 1], x[end], range) ? end : end + 1;
  }
  return runs;
}

/// Pixels that a run covers, at least 1.
std::size_t pixels_of(double from, double to, const ChartFrame& frame) {
  const double low = std::max(from, frame.x.low);
  const double high = std::min(to, frame.x.high);
  const double share = std::clamp((high - low) / frame.x.span(), 0.0, 1.0);
  return static_cast<std::size_t>(std::max(1.0, std::ceil(share * frame.width_px)));
}

bool is_dense(const std::vector<double>& x, const ChartFrame& frame) {
  return static_cast<double>(x.size()) >
             kMostPointsPerPx * static_cast<double>(pixels_of(x.front(), x.back(), frame)) &&
         std::is_sorted(x.begin(), x.end());
}

DrawnLine stepped(const DrawnLine& line) {
  DrawnLine corners;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (i > 0) {
      corners.x.push_back(line.x[i]);
      corners.y.push_back(line.y[i - 1]);
    }
    corners.x.push_back(line.x[i]);
    corners.y.push_back(line.y[i]);
  }
  return corners;
}

/// One point for each pixel of x: the lowest low and the highest high in it.
DrawnBand thinned(const DrawnBand& band, std::size_t pixels) {
  DrawnBand thin;
  const double from = band.x.front();
  const double length = band.x.back() - from;
  std::size_t last_bucket = pixels;
  for (std::size_t i = 0; i < band.x.size(); ++i) {
    const double share = length > 0.0 ? (band.x[i] - from) / length : 0.0;
    const auto bucket =
        std::min(pixels - 1, static_cast<std::size_t>(share * static_cast<double>(pixels)));
    if (bucket != last_bucket) {
      thin.x.push_back(band.x[i]);
      thin.low.push_back(band.low[i]);
      thin.high.push_back(band.high[i]);
      last_bucket = bucket;
    }
    thin.low.back() = std::min(thin.low.back(), band.low[i]);
    thin.high.back() = std::max(thin.high.back(), band.high[i]);
  }
  thin.x.push_back(band.x.back());
  thin.low.push_back(band.low.back());
  thin.high.push_back(band.high.back());
  return thin;
}

}  // namespace

std::vector<DrawnLine> drawn_pieces(const LineSpec& line,
                                    const ChartFrame& frame,
                                    double px_per_pt) {
  NADIR_REQUIRE(line.x.size() == line.y.size());
  std::vector<double> y(line.y.size());
  std::transform(line.y.begin(), line.y.end(), y.begin(),
                 [&frame](double value) { return frame.scale.plotted(value); });
  const auto can_draw = [&](std::size_t i) { return is_drawable(line.x[i]) && is_drawable(y[i]); };
  std::vector<DrawnLine> pieces;
  for (const auto& [first, end] : runs_in_sight(line.x, frame.x, can_draw)) {
    const auto from = static_cast<std::ptrdiff_t>(first);
    const auto to = static_cast<std::ptrdiff_t>(end);
    DrawnLine piece{{line.x.begin() + from, line.x.begin() + to},
                    {y.begin() + from, y.begin() + to}};
    if (piece.x.size() > 1 && is_dense(piece.x, frame)) {
      PointLine thin =
          decimate_min_max(piece.x, piece.y, pixels_of(piece.x.front(), piece.x.back(), frame));
      piece = {std::move(thin.x), std::move(thin.y)};
    }
    if (line.is_stepped) piece = stepped(piece);
    for (double& x : piece.x) x = brought_near(x, frame.x);
    for (double& value : piece.y) value = brought_near(value, frame.y);
    if (piece.x.size() == 1) {
      const double half = 0.5 * line.width_pt * px_per_pt * frame.x.span() / frame.width_px;
      piece = {{piece.x[0] - half, piece.x[0] + half}, {piece.y[0], piece.y[0]}};
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<DrawnBand> drawn_pieces(const BandSpec& band, const ChartFrame& frame) {
  NADIR_REQUIRE(band.x.size() == band.low.size() && band.x.size() == band.high.size());
  const auto can_draw = [&](std::size_t i) {
    return is_drawable(band.x[i]) && is_drawable(frame.scale.plotted(band.low[i])) &&
           is_drawable(frame.scale.plotted(band.high[i]));
  };
  std::vector<DrawnBand> pieces;
  for (const auto& [first, end] : runs_in_sight(band.x, frame.x, can_draw)) {
    if (end - first < 2) continue;
    DrawnBand piece;
    for (std::size_t i = first; i < end; ++i) {
      piece.x.push_back(band.x[i]);
      piece.low.push_back(brought_near(frame.scale.plotted(band.low[i]), frame.y));
      piece.high.push_back(brought_near(frame.scale.plotted(band.high[i]), frame.y));
    }
    if (is_dense(piece.x, frame)) {
      piece = thinned(piece, pixels_of(piece.x.front(), piece.x.back(), frame));
    }
    for (double& x : piece.x) x = brought_near(x, frame.x);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace nadir
