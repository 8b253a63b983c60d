// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "core/base/raster.h"
#include "core/map/semantic_classes.h"

namespace nadir {

/// Which of the 256 possible ids are meant.
using IdSet = std::array<bool, 256>;

/// Exact squared Euclidean distances, in cells, from each cell centre to the nearest cell centre
/// whose id is in `targets`.
///
/// `visit` gets every row once, from several threads and in any order; it must write to that row's
/// own place only. Distances of `cap` cells and more, or to no target at all, come out as some
/// number of at least cap^2. Whole numbers throughout, so the result is the same everywhere.
/// O(cells) (Meijster, Roerdink & Hesselink, A general algorithm for computing distance transforms
/// in linear time, 2000). `cap` is in [1, 65535].
void visit_squared_distances(
    const Raster<ClassId>& labels,
    const IdSet& targets,
    int cap,
    const std::function<void(int row, std::span<const std::int64_t> squared)>& visit);

}  // namespace nadir
