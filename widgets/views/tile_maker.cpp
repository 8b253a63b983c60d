// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/tile_maker.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

namespace nadir {
namespace {

Result<Raster<Rgba>> made_of(const TileMaker::Wish& wish) {
  try {
    return wish.from->picture(wish.tile);
  } catch (const std::exception& error) {
    return fail(ErrorCode::kIo, "a part of the map could not be drawn: {}", error.what());
  }
}

}  // namespace

TileMaker::TileMaker() : thread_([this](const std::stop_token& stop) { work(stop); }) {}
TileMaker::~TileMaker() = default;

void TileMaker::ask(std::vector<Wish> wishes) {
  {
    const std::lock_guard lock(mutex_);
    const auto is_there = [this](const Wish& wish) {
      const auto is_same = [&wish](const TileAddress& tile, std::int64_t revision) {
        return tile == wish.tile && revision == wish.revision;
      };
      return (is_making_ && is_same(making_, making_revision_)) ||
             std::any_of(made_.begin(), made_.end(),
                         [&](const Made& made) { return is_same(made.tile, made.revision); });
    };
    std::erase_if(wishes, is_there);
    wishes_.assign(std::make_move_iterator(wishes.begin()), std::make_move_iterator(wishes.end()));
  }
  changed_.notify_all();
}

std::vector<TileMaker::Made> TileMaker::take(std::size_t most) {
  std::vector<Made> taken;
  {
    const std::lock_guard lock(mutex_);
    while (!made_.empty() && taken.size() < most) {
      taken.push_back(std::move(made_.front()));
      made_.pop_front();
    }
  }
  if (!taken.empty()) changed_.notify_all();
  return taken;
}

void TileMaker::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(
      lock, [this] { return !is_making_ && (wishes_.empty() || made_.size() >= kMostWaiting); });
}

void TileMaker::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop,
                       [this] { return !wishes_.empty() && made_.size() < kMostWaiting; })) {
    if (stop.stop_requested()) return;
    Wish wish = std::move(wishes_.front());
    wishes_.pop_front();
    making_ = wish.tile;
    making_revision_ = wish.revision;
    is_making_ = true;
    lock.unlock();
    Made made{wish.tile, wish.revision, made_of(wish)};
    wish.from.reset();  // the last one to hold a large document lets go of it here, not in a frame
    lock.lock();
    is_making_ = false;
    made_.push_back(std::move(made));
    changed_.notify_all();
  }
}

}  // namespace nadir
