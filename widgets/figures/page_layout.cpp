// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/page_layout.h"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <utility>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr double kMarginPt = 8.0;

std::vector<std::pair<double, double>> cut(double length,
                                           const std::vector<double>& shares,
                                           double gap) {
  NADIR_REQUIRE(!shares.empty());
  const double whole = std::accumulate(shares.begin(), shares.end(), 0.0);
  const double room = length - gap * static_cast<double>(shares.size() - 1);
  std::vector<std::pair<double, double>> pieces;
  double at = 0.0;
  for (const double share : shares) {
    const double piece = std::max(0.0, room) * share / whole;
    pieces.emplace_back(at, piece);
    at += piece + gap;
  }
  return pieces;
}

/// Cuts by `divide` into ever fewer pieces until all have room; the others are empty.
template <typename Divide>
std::vector<PageRect> fitting(const PageRect& whole,
                              std::vector<double> shares,
                              const LeastRoom& least,
                              Divide&& divide) {
  const std::size_t wanted = shares.size();
  for (; !shares.empty(); shares.pop_back()) {
    std::vector<PageRect> made = divide(shares);
    if (std::all_of(made.begin(), made.end(),
                    [&least](const PageRect& panel) { return least.fits_in(panel); })) {
      made.resize(wanted, {whole.left, whole.bottom, 0.0, 0.0});
      return made;
    }
  }
  return std::vector<PageRect>(wanted, {whole.left, whole.bottom, 0.0, 0.0});
}

}  // namespace

PageRect page_inside(const PageFormat& format) {
  constexpr double kMostShare = 0.1;  // of the shorter side
  const double margin =
      std::min(kMarginPt * format.px_per_pt(), kMostShare * std::min(format.width, format.height));
  return {margin, margin, format.width - 2.0 * margin, format.height - 2.0 * margin};
}

PageRect take_top(PageRect& rest, double height, double gap) {
  const double taken = std::clamp(height, 0.0, rest.height);
  const PageRect strip{rest.left, rest.top() - taken, rest.width, taken};
  rest.height = std::max(0.0, rest.height - taken - gap);
  return strip;
}

PageRect take_bottom(PageRect& rest, double height, double gap) {
  const double taken = std::clamp(height, 0.0, rest.height);
  const PageRect strip{rest.left, rest.bottom, rest.width, taken};
  const double shift = std::min(rest.height, taken + gap);
  rest.height -= shift;
  rest.bottom += shift;
  return strip;
}

std::vector<PageRect> columns(const PageRect& whole,
                              const std::vector<double>& shares,
                              double gap) {
  std::vector<PageRect> made;
  for (const auto& [at, width] : cut(whole.width, shares, gap)) {
    made.push_back({whole.left + at, whole.bottom, width, whole.height});
  }
  return made;
}

std::vector<PageRect> rows(const PageRect& whole, const std::vector<double>& shares, double gap) {
  std::vector<PageRect> made;
  for (const auto& [at, height] : cut(whole.height, shares, gap)) {
    made.push_back({whole.left, whole.top() - at - height, whole.width, height});
  }
  return made;
}

bool overlap(const PageRect& a, const PageRect& b) {
  return a.left < b.right() && b.left < a.right() && a.bottom < b.top() && b.bottom < a.top();
}

PageRect fitted(double width, double height, const PageRect& inside) {
  const double scale = std::min(inside.width / width, inside.height / height);
  const double w = width * scale;
  const double h = height * scale;
  return {inside.left + (inside.width - w) / 2.0, inside.bottom + (inside.height - h) / 2.0, w, h};
}

LeastRoom least_map(const PageFormat& format) {
  return {40.0 * format.px_per_pt(), 36.0 * format.px_per_pt()};
}

LeastRoom least_chart(const PageFormat& format) {
  return {60.0 * format.px_per_pt(), 30.0 * format.px_per_pt()};
}

LeastRoom least_picture(const PageFormat& format) {
  return {24.0 * format.px_per_pt(), 24.0 * format.px_per_pt()};
}

std::vector<PageRect> fitting_columns(const PageRect& whole,
                                      const std::vector<double>& shares,
                                      double gap,
                                      const LeastRoom& least) {
  return fitting(whole, shares, least,
                 [&](const std::vector<double>& kept) { return columns(whole, kept, gap); });
}

std::vector<PageRect> fitting_rows(const PageRect& whole,
                                   const std::vector<double>& shares,
                                   double gap,
                                   const LeastRoom& least) {
  return fitting(whole, shares, least,
                 [&](const std::vector<double>& kept) { return rows(whole, kept, gap); });
}

std::vector<std::string> broken_to(const std::string& text,
                                   const TextStyle& style,
                                   double width_px) {
  std::vector<std::string> lines;
  std::string between;  // what parts the next word from the line before
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (word == "·" || word == "|") {
      between = " " + word;
      continue;
    }
    const std::string more = std::exchange(between, "") + " " + word;
    if (!lines.empty() && measure_text(lines.back() + more, style).width <= width_px) {
      lines.back() += more;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

std::string shortened_to(const std::string& text, const TextStyle& style, double width_px) {
  if (measure_text(text, style).width <= width_px) return text;
  std::string kept = text;
  const auto ends_inside_a_letter = [&kept, &text] {
    return (static_cast<unsigned char>(text[kept.size()]) & 0xC0U) == 0x80U;  // UTF-8
  };
  while (!kept.empty()) {
    do {
      kept.pop_back();
    } while (!kept.empty() && ends_inside_a_letter());
    std::string trimmed = kept;
    while (!trimmed.empty() && trimmed.back() == ' ') trimmed.pop_back();
    trimmed += "…";
    if (measure_text(trimmed, style).width <= width_px) return trimmed;
  }
  return {};
}

}  // namespace nadir
