// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "widgets/views/tile_pictures.h"

namespace nadir {

/// Makes pictures of tiles in a thread of its own, for frames that never wait. What it holds is bounded: the tiles that were
/// asked for last, and those that nobody has taken yet, at most kMostWaiting.
class TileMaker {
 public:
  static constexpr std::size_t kMostWaiting = 32;  ///< 32 MB.

  struct Wish {
    TileAddress tile;
    std::shared_ptr<const TilePictures> from;
    std::int64_t revision = 0;  ///< Comes back as it is.
  };
  struct Made {
    TileAddress tile;
    std::int64_t revision = 0;
    Result<Raster<Rgba>> pixels;
  };

  TileMaker();
  ~TileMaker();  ///< Waits for the tile that is being made.
  TileMaker(const TileMaker&) = delete;
  TileMaker& operator=(const TileMaker&) = delete;

  /// In place of all wishes before that were not begun; the most urgent first. A tile that is being made from the same
  /// revision is not made twice.
  void ask(std::vector<Wish> wishes);
  /// What was made since, the first first, at most so many.
  [[nodiscard]] std::vector<Made> take(std::size_t most);
  /// Waits until all that was asked for is made, or no more can be kept: for tests, and pictures that nobody waits for.
  void wait();

 private:
  void work(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Wish> wishes_;
  std::deque<Made> made_;
  bool is_making_ = false;
  TileAddress making_;
  std::int64_t making_revision_ = 0;
  std::jthread thread_;  ///< Ends before all else goes.
};

}  // namespace nadir
