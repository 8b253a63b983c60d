// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nadir {

/// What the tiles of several views may take together. Where they take more, tiles that no page shows go, the one that was
/// looked at longest ago first, whichever view it is of. One thread, as the views.
class TileBudget {
 public:
  /// About 128 tiles of 512 x 512 pixels: more than a page of 2560 x 1440 shows of one layer.
  static constexpr std::size_t kUsualBytes = std::size_t{256} << 20U;

  /// @param most_bytes  In main memory, and once more as textures of the graphics card.
  explicit TileBudget(std::size_t most_bytes = kUsualBytes) : most_bytes_(most_bytes) {}

  /// Of all views, also what goes beyond the budget because pages show it.
  [[nodiscard]] std::size_t used_bytes() const { return used_bytes_; }

  /// A view whose tiles are counted. It joins and leaves by itself.
  class Holder {
   public:
    virtual ~Holder() = default;
    /// When that of its tiles that is not shown was looked at which was so longest ago; kNever where all are shown.
    [[nodiscard]] virtual std::uint64_t longest_unused() const = 0;
    /// Lets go of that tile, and says so by gave_back().
    virtual void forget_longest_unused() = 0;
  };
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};

  void join(Holder& holder);
  void leave(Holder& holder);
  /// A moment later than all before, for what is looked at now.
  [[nodiscard]] std::uint64_t next_moment() { return ++moment_; }
  void took(std::size_t bytes) { used_bytes_ += bytes; }
  void gave_back(std::size_t bytes) { used_bytes_ -= bytes; }
  /// Makes holders forget until all fits, or until nothing is left that is not shown.
  void keep();

 private:
  std::size_t most_bytes_;
  std::size_t used_bytes_ = 0;
  std::uint64_t moment_ = 0;
  std::vector<Holder*> holders_;
};

}  // namespace nadir
