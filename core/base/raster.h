// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/base/require.h"

namespace nadir {

/// A rectangle of values, row by row from the top, without gaps: images, label rasters, depth maps,
/// topviews.
template <typename T>
class Raster {
 public:
  Raster() = default;
  Raster(int width, int height, T value = T{})
      : width_(width), height_(height), values_(count(width, height), value) {}
  /// Takes `values` over; there must be width x height of them.
  Raster(int width, int height, std::vector<T> values)
      : width_(width), height_(height), values_(std::move(values)) {
    NADIR_REQUIRE(values_.size() == count(width, height));
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < width_ && row < height_;
  }

  /// No bounds check: ask contains() where the indices come from outside.
  [[nodiscard]] T& at(int column, int row) { return values_[index(column, row)]; }
  [[nodiscard]] const T& at(int column, int row) const { return values_[index(column, row)]; }

  [[nodiscard]] std::span<T> row(int row) {
    return {values_.data() + index(0, row), static_cast<std::size_t>(width_)};
  }
  [[nodiscard]] std::span<const T> row(int row) const {
    return {values_.data() + index(0, row), static_cast<std::size_t>(width_)};
  }
  [[nodiscard]] std::vector<T>& values() { return values_; }
  [[nodiscard]] const std::vector<T>& values() const { return values_; }
  [[nodiscard]] T* data() { return values_.data(); }
  [[nodiscard]] const T* data() const { return values_.data(); }

  friend bool operator==(const Raster&, const Raster&) = default;

 private:
  static std::size_t count(int width, int height) {
    NADIR_REQUIRE(width >= 0 && height >= 0);
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<T> values_;
};

}  // namespace nadir
