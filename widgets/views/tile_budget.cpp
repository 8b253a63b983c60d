// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/tile_budget.h"

#include <algorithm>

namespace nadir {

void TileBudget::join(Holder& holder) { holders_.push_back(&holder); }

void TileBudget::leave(Holder& holder) { std::erase(holders_, &holder); }

void TileBudget::keep() {
  while (used_bytes_ > most_bytes_) {
    const auto oldest = std::min_element(
        holders_.begin(), holders_.end(),
        [](const Holder* a, const Holder* b) { return a->longest_unused() < b->longest_unused(); });
    if (oldest == holders_.end() || (*oldest)->longest_unused() == kNever) return;
    (*oldest)->forget_longest_unused();
  }
}

}  // namespace nadir
