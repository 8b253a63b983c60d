// SPDX-License-Identifier: Apache-2.0
#include "core/label/cell_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace nadir {
namespace {

/// An edge by its upper end, so that both areas at a border compute the same numbers for it.
struct Edge {
  Eigen::Vector2d upper, lower;
  std::int64_t first_row, end_row;  ///< Rows of the window whose centre it crosses.
};

/// The first row whose centre is at y or below it.
double first_centre_from(double y) { return std::ceil(y - 0.5); }

std::int64_t clamped(double cell, std::int64_t low, std::int64_t high) {
  return static_cast<std::int64_t>(
      std::clamp(cell, static_cast<double>(low), static_cast<double>(high)));
}

Edge edge_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const CellRect& window) {
  Edge edge{a.y() <= b.y() ? a : b, a.y() <= b.y() ? b : a, 0, 0};
  edge.first_row = clamped(first_centre_from(edge.upper.y()), window.top, window.bottom);
  edge.end_row = clamped(first_centre_from(edge.lower.y()), window.top, window.bottom);
  return edge;
}

/// The column where the inside begins, or ends, left of which are all centres left of the edge.
std::int64_t crossing(const Edge& edge, std::int64_t row, const CellRect& window) {
  const double centre = static_cast<double>(row) + 0.5;
  const double x = (centre - edge.upper.y()) * (edge.lower.x() - edge.upper.x()) /
                       (edge.lower.y() - edge.upper.y()) +
                   edge.upper.x();
  return clamped(std::floor(x + 0.5), window.left, window.right);
}

template <typename Visitor>
void visit_edges(const Ring& ring, bool is_closed, Visitor&& visit) {
  if (is_closed && ring.size() > 1) visit(ring.back(), ring.front());
  for (std::size_t i = 1; i < ring.size(); ++i) visit(ring[i - 1], ring[i]);
}

void take_cell(double column, double row, const CellRect& window, const TakeCells& take) {
  const CellRect cell{clamped(column, window.left - 1, window.right),
                      clamped(row, window.top - 1, window.bottom), 0, 0};
  if (cell.left < window.left || cell.left >= window.right) return;
  if (cell.top < window.top || cell.top >= window.bottom) return;
  take(cell.top, cell.left, cell.left + 1);
}

void fill_disc(const Eigen::Vector2d& centre,
               double radius,
               const CellRect& window,
               const TakeCells& take) {
  const auto first = clamped(first_centre_from(centre.y() - radius), window.top, window.bottom);
  const auto end = clamped(first_centre_from(centre.y() + radius), window.top, window.bottom);
  for (std::int64_t row = first; row < end; ++row) {
    const double down = static_cast<double>(row) + 0.5 - centre.y();
    const double half = std::sqrt(std::max(0.0, radius * radius - down * down));
    const auto from = clamped(std::floor(centre.x() - half + 0.5), window.left, window.right);
    const auto to = clamped(std::floor(centre.x() + half + 0.5), window.left, window.right);
    if (from < to) take(row, from, to);
  }
}

/// One cell a column whose centre lies between the ends. Cells are those that a strip of one cell around it would claim.
void fill_flat_segment(const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b,
                       const CellRect& window,
                       const TakeCells& take) {
  const Eigen::Vector2d& left = a.x() <= b.x() ? a : b;
  const Eigen::Vector2d& right = a.x() <= b.x() ? b : a;
  const auto first = clamped(first_centre_from(left.x()), window.left, window.right);
  const auto end = clamped(first_centre_from(right.x()), window.left, window.right);
  for (std::int64_t column = first; column < end; ++column) {
    const double centre = static_cast<double>(column) + 0.5;
    const double y =
        (centre - left.x()) * (right.y() - left.y()) / (right.x() - left.x()) + left.y();
    take_cell(static_cast<double>(column), std::ceil(y) - 1.0, window, take);
  }
}

void fill_steep_segment(const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b,
                        const CellRect& window,
                        const TakeCells& take) {
  const Eigen::Vector2d& upper = a.y() <= b.y() ? a : b;
  const Eigen::Vector2d& lower = a.y() <= b.y() ? b : a;
  const auto first = clamped(first_centre_from(upper.y()), window.top, window.bottom);
  const auto end = clamped(first_centre_from(lower.y()), window.top, window.bottom);
  for (std::int64_t row = first; row < end; ++row) {
    const double centre = static_cast<double>(row) + 0.5;
    const double x =
        (centre - upper.y()) * (lower.x() - upper.x()) / (lower.y() - upper.y()) + upper.x();
    take_cell(std::floor(x), static_cast<double>(row), window, take);
  }
}

}  // namespace

void fill_rings(std::span<const Ring> rings_in_cells,
                const CellRect& window,
                const TakeCells& take) {
  if (window.empty()) return;
  std::vector<Edge> edges;
  for (const Ring& ring : rings_in_cells) {
    visit_edges(ring, true, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      const Edge edge = edge_of(a, b, window);
      if (edge.first_row < edge.end_row) edges.push_back(edge);
    });
  }
  // Crossings of all rows one after the other: how many there are, where each row's begin, then they themselves.
  std::vector<std::size_t> begin(static_cast<std::size_t>(window.height()) + 1, 0);
  for (const Edge& edge : edges) {
    for (std::int64_t row = edge.first_row; row < edge.end_row; ++row) {
      ++begin[static_cast<std::size_t>(row - window.top) + 1];
    }
  }
  for (std::size_t row = 1; row < begin.size(); ++row) begin[row] += begin[row - 1];
  std::vector<std::int64_t> crossings(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const Edge& edge : edges) {
    for (std::int64_t row = edge.first_row; row < edge.end_row; ++row) {
      crossings[next[static_cast<std::size_t>(row - window.top)]++] = crossing(edge, row, window);
    }
  }
  for (std::int64_t row = window.top; row < window.bottom; ++row) {
    const auto at = static_cast<std::size_t>(row - window.top);
    const std::span of_row(crossings.data() + begin[at], begin[at + 1] - begin[at]);
    std::sort(of_row.begin(), of_row.end());
    for (std::size_t i = 0; i + 1 < of_row.size(); i += 2) {
      if (of_row[i] < of_row[i + 1]) take(row, of_row[i], of_row[i + 1]);
    }
  }
}

void fill_stroke(const Ring& line_in_cells,
                 bool is_closed,
                 double reach,
                 const CellRect& window,
                 const TakeCells& take) {
  visit_edges(line_in_cells, is_closed, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d along = b - a;
    const double length = along.norm();
    if (!(length > 0.0)) return;
    const Eigen::Vector2d aside = Eigen::Vector2d(-along.y(), along.x()) * (reach / length);
    const std::array<Ring, 1> strip{Ring{a + aside, b + aside, b - aside, a - aside}};
    const double low = std::min(a.y(), b.y()) - reach;
    const double high = std::max(a.y(), b.y()) + reach;
    const CellRect rows{window.left, clamped(std::floor(low), window.top, window.bottom),
                        window.right, clamped(std::ceil(high), window.top, window.bottom)};
    fill_rings(strip, rows, take);
  });
  const std::size_t ends = is_closed ? 0 : 1;
  for (std::size_t i = ends; i + ends < line_in_cells.size(); ++i) {
    fill_disc(line_in_cells[i], reach, window, take);
  }
}

void fill_path(const Ring& line_in_cells,
               bool is_closed,
               const CellRect& window,
               const TakeCells& take) {
  visit_edges(line_in_cells, is_closed, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    if (std::abs(b.x() - a.x()) >= std::abs(b.y() - a.y())) {
      fill_flat_segment(a, b, window, take);
    } else {
      fill_steep_segment(a, b, window, take);
    }
  });
  for (const Eigen::Vector2d& place : line_in_cells) {
    take_cell(std::floor(place.x()), std::ceil(place.y()) - 1.0, window, take);
  }
}

double mean_width(std::span<const Ring> rings) {
  double twice_area = 0.0;
  double around = 0.0;
  for (const Ring& ring : rings) {
    double twice = 0.0;
    visit_edges(ring, true, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      // From the ring's first place, because far from 0 products lose their last digits.
      const Eigen::Vector2d from = a - ring.front();
      const Eigen::Vector2d to = b - ring.front();
      twice += from.x() * to.y() - from.y() * to.x();
      around += (b - a).norm();
    });
    twice_area += &ring == &rings.front() ? std::abs(twice) : -std::abs(twice);
  }
  return around > 0.0 ? std::max(0.0, twice_area) / around : 0.0;
}

double path_length(const Ring& line) {
  double length = 0.0;
  visit_edges(line, false, [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    length += (b - a).norm();
  });
  return length;
}

}  // namespace nadir
