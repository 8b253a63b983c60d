// SPDX-License-Identifier: Apache-2.0
#include "core/assist/joined_pieces.h"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

namespace nadir {
namespace {

struct Piece {
  double lightness = 0.0, a = 0.0, b = 0.0;  ///< Sums.
  int pixels = 0;
  int joined_to = -1;  ///< Another piece, or -1.
  std::vector<int>
      beside{};  ///< Pieces that share a side with it, also twice, also such as have joined others.
};

void add_pixel(Piece& piece, const LabColour& colour) {
  piece.lightness += colour.lightness;
  piece.a += colour.a;
  piece.b += colour.b;
  ++piece.pixels;
}

LabColour mean_of(const Piece& piece) {
  return {static_cast<float>(piece.lightness / piece.pixels),
          static_cast<float>(piece.a / piece.pixels), static_cast<float>(piece.b / piece.pixels)};
}

/// Numbers what hangs together by sides, in the order of first pixels.
std::vector<Piece> found_pieces(const AssistWindow& window,
                                const Raster<SuperpixelId>& values,
                                Raster<SuperpixelId>& piece_of) {
  std::vector<Piece> pieces;
  std::vector<PixelPlace> waiting;
  for (int row = 0; row < values.height(); ++row) {
    for (int column = 0; column < values.width(); ++column) {
      const SuperpixelId value = values.at(column, row);
      if (value == kNoSuperpixel || piece_of.at(column, row) != kNoSuperpixel) continue;
      const auto number = static_cast<SuperpixelId>(pieces.size());
      Piece& piece = pieces.emplace_back();
      const auto take = [&](int x, int y) {
        if (!values.contains(x, y) || values.at(x, y) != value ||
            piece_of.at(x, y) != kNoSuperpixel) {
          return;
        }
        piece_of.at(x, y) = number;
        add_pixel(piece, window.colours().at(x, y));
        waiting.push_back({x, y});
      };
      take(column, row);
      while (!waiting.empty()) {
        const PixelPlace at = waiting.back();
        waiting.pop_back();
        take(at.column - 1, at.row);
        take(at.column + 1, at.row);
        take(at.column, at.row - 1);
        take(at.column, at.row + 1);
      }
    }
  }
  return pieces;
}

void find_neighbours(const Raster<SuperpixelId>& piece_of, std::vector<Piece>& pieces) {
  const auto meet = [&](SuperpixelId one, SuperpixelId other) {
    if (one == other || one == kNoSuperpixel || other == kNoSuperpixel) return;
    pieces[static_cast<std::size_t>(one)].beside.push_back(other);
    pieces[static_cast<std::size_t>(other)].beside.push_back(one);
  };
  for (int row = 0; row < piece_of.height(); ++row) {
    for (int column = 0; column < piece_of.width(); ++column) {
      const SuperpixelId here = piece_of.at(column, row);
      if (column > 0) meet(piece_of.at(column - 1, row), here);
      if (row > 0) meet(piece_of.at(column, row - 1), here);
    }
  }
}

/// Shortens the way there for the next time.
int last_of(std::vector<Piece>& pieces, int number) {
  const auto next = [&](int one) -> int& {
    return pieces[static_cast<std::size_t>(one)].joined_to;
  };
  while (next(number) >= 0) {
    if (next(next(number)) >= 0) next(number) = next(next(number));
    number = next(number);
  }
  return number;
}

/// The neighbour of the nearest colour, of equal ones the lowest number; -1 where it has none.
int nearest_neighbour(std::vector<Piece>& pieces, int number) {
  const LabColour colour = mean_of(pieces[static_cast<std::size_t>(number)]);
  int best = -1;
  float least = std::numeric_limits<float>::max();
  for (const int one : pieces[static_cast<std::size_t>(number)].beside) {
    const int beside = last_of(pieces, one);
    if (beside == number) continue;
    const float distance =
        colour_difference(colour, mean_of(pieces[static_cast<std::size_t>(beside)]));
    if (distance < least || (distance == least && beside < best)) {
      least = distance;
      best = beside;
    }
  }
  return best;
}

void join_small(std::vector<Piece>& pieces, int least_pixels) {
  std::set<std::pair<int, int>> small;  // Size and number.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].pixels < least_pixels) small.emplace(pieces[i].pixels, static_cast<int>(i));
  }
  while (!small.empty()) {
    const int number = small.begin()->second;
    small.erase(small.begin());
    const int into = nearest_neighbour(pieces, number);
    if (into < 0) continue;  // An island among what nobody has seen.
    Piece& gone = pieces[static_cast<std::size_t>(number)];
    Piece& grown = pieces[static_cast<std::size_t>(into)];
    small.erase({grown.pixels, into});
    grown.lightness += gone.lightness;
    grown.a += gone.a;
    grown.b += gone.b;
    grown.pixels += gone.pixels;
    grown.beside.insert(grown.beside.end(), gone.beside.begin(), gone.beside.end());
    gone.beside.clear();
    gone.joined_to = into;
    if (grown.pixels < least_pixels) small.emplace(grown.pixels, into);
  }
}

}  // namespace

Superpixels joined_pieces(const AssistWindow& window,
                          const Raster<SuperpixelId>& values,
                          int least_pixels) {
  Superpixels joined{{values.width(), values.height(), kNoSuperpixel}, 0};
  std::vector<Piece> pieces = found_pieces(window, values, joined.of_pixel);
  find_neighbours(joined.of_pixel, pieces);
  join_small(pieces, least_pixels);
  std::vector<SuperpixelId> number_of(pieces.size(), kNoSuperpixel);
  for (SuperpixelId& piece : joined.of_pixel.values()) {
    if (piece == kNoSuperpixel) continue;
    SuperpixelId& number = number_of[static_cast<std::size_t>(last_of(pieces, piece))];
    if (number == kNoSuperpixel) number = joined.count++;
    piece = number;
  }
  return joined;
}

}  // namespace nadir
