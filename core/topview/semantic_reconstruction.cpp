// SPDX-License-Identifier: Apache-2.0
#include "core/topview/semantic_reconstruction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/require.h"
#include "core/topview/cell_placement.h"

namespace nadir {
namespace {

constexpr std::uint16_t kMostVotes = std::numeric_limits<std::uint16_t>::max();
/// No cell of a topview is farther from the body: its indices have 16 bits.
constexpr double kReachCells = 65'536.0;

}  // namespace

SemanticReconstruction::SemanticReconstruction(double metres_per_cell)
    : metres_per_cell_(metres_per_cell) {
  NADIR_REQUIRE(metres_per_cell > 0.0 && std::isfinite(metres_per_cell));
}

void SemanticReconstruction::add(const SemanticTopview& seen, const Rigid2& enu_from_body) {
  NADIR_REQUIRE(seen.metres_per_cell > 0.0);
  const double reach_m = kReachCells * seen.metres_per_cell;
  const double farthest_m = kFarthestCell * metres_per_cell_;
  NADIR_REQUIRE(std::isfinite(enu_from_body.yaw_rad));
  NADIR_REQUIRE(std::abs(enu_from_body.x_m) + reach_m <= farthest_m);
  NADIR_REQUIRE(std::abs(enu_from_body.y_m) + reach_m <= farthest_m);
  const CellPlacement placement(enu_from_body, seen.metres_per_cell);
  Block* block = nullptr;
  BlockIndex index_of_block;
  for (ClassId id = 0; id < kClassCount; ++id) {
    for (const TopviewCell& cell : seen.of_class(id)) {
      const Eigen::Vector2d centre_in_enu_m = placement.centre_in_enu_m(cell);
      const int i = static_cast<int>(std::floor(centre_in_enu_m.x() / metres_per_cell_));
      const int j = static_cast<int>(std::floor(centre_in_enu_m.y() / metres_per_cell_));
      if (blocks_.empty()) {
        west_ = east_ = i;
        south_ = north_ = j;
      }
      west_ = std::min(west_, i);
      east_ = std::max(east_, i);
      south_ = std::min(south_, j);
      north_ = std::max(north_, j);
      // Neighbours in the list are mostly neighbours on the ground.
      const BlockIndex index{j >> kBlockBits, i >> kBlockBits};
      if (block == nullptr || index != index_of_block) {
        block = &blocks_[index];
        index_of_block = index;
      }
      const int within = ((j & (kBlockSide - 1)) << kBlockBits) | (i & (kBlockSide - 1));
      vote(*block, static_cast<std::size_t>(within), id);
    }
  }
}

void SemanticReconstruction::vote(Block& block, std::size_t cell, ClassId id) {
  std::vector<std::uint16_t>& votes = block[id];
  if (votes.empty()) votes.assign(kBlockCells, 0);
  if (votes[cell] < kMostVotes) ++votes[cell];
}

Eigen::Vector2d SemanticReconstruction::top_left_in_enu_m() const {
  NADIR_REQUIRE(!empty());
  return {west_ * metres_per_cell_, (north_ + 1) * metres_per_cell_};
}

std::size_t SemanticReconstruction::bytes() const {
  std::size_t sum = 0;
  for (const auto& [index, block] : blocks_) {
    sum += sizeof(block) + sizeof(index);
    for (const auto& votes : block) sum += votes.size() * sizeof(votes[0]);
  }
  return sum;
}

template <typename T, typename Decide>
Result<Raster<T>> SemanticReconstruction::assemble(T nothing, Decide&& decide) const {
  if (empty()) return Raster<T>();
  const std::int64_t width = std::int64_t{east_} - west_ + 1;
  const std::int64_t height = std::int64_t{north_} - south_ + 1;
  if (width * height > kMostCells) {
    return fail(ErrorCode::kUnsupported,
                "reconstruction: {} x {} cells of {} m are more than the {} that can be drawn",
                width, height, metres_per_cell_, kMostCells);
  }
  Raster<T> raster(static_cast<int>(width), static_cast<int>(height), nothing);
  std::array<T, kBlockCells> decided;
  for (const auto& [index, block] : blocks_) {
    decide(block, decided);
    // Cells of a block beyond the outermost votes have none, and no place on the raster.
    const int block_south = index.first * kBlockSide;
    const int block_west = index.second * kBlockSide;
    const int west = std::max(west_, block_west);
    const int east = std::min(east_, block_west + kBlockSide - 1);
    const int south = std::max(south_, block_south);
    const int north = std::min(north_, block_south + kBlockSide - 1);
    for (int j = south; j <= north; ++j) {
      const auto* const from = decided.data() + (j - block_south) * kBlockSide;
      std::copy(from + (west - block_west), from + (east - block_west + 1),
                raster.row(north_ - j).begin() + (west - west_));
    }
  }
  return raster;
}

Result<Raster<ClassId>> SemanticReconstruction::labels(int min_votes) const {
  NADIR_REQUIRE(min_votes >= 1);
  using Winners = std::array<ClassId, kBlockCells>;
  const auto elect = [min_votes](const Block& block, Winners& winners) {
    std::array<std::uint16_t, kBlockCells> most{};
    winners.fill(kUnclassified);
    for (ClassId id = 0; id < kClassCount; ++id) {
      const std::vector<std::uint16_t>& votes = block[id];
      for (std::size_t cell = 0; cell < votes.size(); ++cell) {
        if (votes[cell] <= most[cell]) continue;
        most[cell] = votes[cell];
        if (votes[cell] >= min_votes) winners[cell] = id;
      }
    }
  };
  return assemble<ClassId>(kUnclassified, elect);
}

Result<Raster<std::uint16_t>> SemanticReconstruction::votes() const {
  using Sums = std::array<std::uint16_t, kBlockCells>;
  const auto add_up = [](const Block& block, Sums& sums) {
    sums.fill(0);
    for (const std::vector<std::uint16_t>& votes : block) {
      for (std::size_t cell = 0; cell < votes.size(); ++cell) {
        const int both = sums[cell] + votes[cell];
        sums[cell] = static_cast<std::uint16_t>(std::min<int>(both, kMostVotes));
      }
    }
  };
  return assemble<std::uint16_t>(0, add_up);
}

void SemanticReconstruction::visit_cells(
    const std::function<void(int i, int j, const CellVotes& votes)>& visit) const {
  for (const auto& [index, block] : blocks_) {
    for (std::size_t cell = 0; cell < kBlockCells; ++cell) {
      CellVotes votes{};
      bool has_any = false;
      for (std::size_t id = 0; id < block.size(); ++id) {
        if (block[id].empty()) continue;
        votes[id] = block[id][cell];
        has_any = has_any || votes[id] > 0;
      }
      if (!has_any) continue;
      const auto within = static_cast<int>(cell);
      visit(index.second * kBlockSide + (within & (kBlockSide - 1)),
            index.first * kBlockSide + (within >> kBlockBits), votes);
    }
  }
}

}  // namespace nadir
