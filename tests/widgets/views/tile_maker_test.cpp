// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/tile_maker.h"

#include <gmock/gmock.h>

#include <atomic>
#include <set>
#include <stdexcept>

namespace nadir {
namespace tile_maker_test {

/// Tiles of one pixel that says which they are.
class NumberedTiles final : public TilePictures {
 public:
  NumberedTiles() : TilePictures(LabelGrid{1.0, {0.0, 0.0}, 512 * 200, 512}) {}
  [[nodiscard]] bool is_smooth() const override { return false; }
  [[nodiscard]] Result<Raster<Rgba>> picture(const TileAddress& tile) const override {
    ++made;
    if (tile.column == 13) return fail(ErrorCode::kMalformed, "tile 13 is damaged");
    if (tile.column == 14) throw std::runtime_error("no memory");
    return Raster<Rgba>(1, 1, Rgba{static_cast<std::uint8_t>(tile.column), 0, 0});
  }
  mutable std::atomic<int> made = 0;
};

std::vector<TileMaker::Wish> wishes(const std::shared_ptr<const TilePictures>& from,
                                    int first,
                                    int count,
                                    std::int64_t revision = 1) {
  std::vector<TileMaker::Wish> made;
  for (int i = 0; i < count; ++i) made.push_back({{0, first + i, 0}, from, revision});
  return made;
}

TEST(TileMaker, MakesWhatIsAskedForInThatOrder) {
  const auto tiles = std::make_shared<const NumberedTiles>();
  TileMaker maker;
  maker.ask(wishes(tiles, 20, 7, 5));
  maker.wait();
  EXPECT_EQ(maker.take(2).size(), 2U);
  const auto rest = maker.take(100);
  ASSERT_EQ(rest.size(), 5U);
  for (int i = 0; i < 5; ++i) {
    const TileMaker::Made& made = rest[static_cast<std::size_t>(i)];
    EXPECT_EQ(made.tile, (TileAddress{0, 22 + i, 0}));
    EXPECT_EQ(made.revision, 5);
    EXPECT_EQ(made.pixels.value().at(0, 0).red, 22 + i);
  }
  EXPECT_TRUE(maker.take(100).empty());
}

TEST(TileMaker, HandsOnWhatFailsAndGoesOn) {
  const auto tiles = std::make_shared<const NumberedTiles>();
  TileMaker maker;
  maker.ask(wishes(tiles, 12, 4));
  maker.wait();
  const auto made = maker.take(100);
  ASSERT_EQ(made.size(), 4U);
  EXPECT_TRUE(made[0].pixels);
  EXPECT_EQ(made[1].pixels.error().message, "tile 13 is damaged");
  EXPECT_EQ(made[2].pixels.error().code, ErrorCode::kIo);
  EXPECT_THAT(made[2].pixels.error().message, testing::HasSubstr("no memory"));
  EXPECT_TRUE(made[3].pixels);
}

TEST(TileMaker, HoldsNoMoreThanItMayAndMakesTheRestOnceThereIsRoom) {
  const auto tiles = std::make_shared<const NumberedTiles>();
  TileMaker maker;
  maker.ask(wishes(tiles, 20, 100));
  maker.wait();
  EXPECT_EQ(tiles->made, static_cast<int>(TileMaker::kMostWaiting));
  std::set<TileAddress> seen;
  for (int i = 0; i < 10 && seen.size() < 100; ++i) {
    for (const auto& made : maker.take(30)) seen.insert(made.tile);
    maker.wait();
  }
  EXPECT_EQ(seen.size(), 100U);
  EXPECT_EQ(tiles->made, 100) << "each once";
}

TEST(TileMaker, ForgetsWishesThatAreNotRepeatedAndMakesNoneTwice) {
  const auto tiles = std::make_shared<const NumberedTiles>();
  TileMaker maker;
  maker.ask(wishes(tiles, 20, 32));
  maker.wait();
  // All are made and wait; what is asked for again is there already, but not of another revision.
  maker.ask(wishes(tiles, 20, 32));
  maker.ask(wishes(tiles, 30, 1, 2));
  EXPECT_EQ(maker.take(100).size(), 32U);
  maker.wait();
  const auto again = maker.take(100);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again[0].revision, 2);
  EXPECT_EQ(tiles->made, 33);
  // Nothing is left of a wish that another has replaced.
  maker.ask(wishes(tiles, 20, 32, 3));
  maker.ask({});
  maker.wait();
  EXPECT_LE(maker.take(100).size(), 32U);
  maker.wait();
  EXPECT_TRUE(maker.take(100).empty());
}

TEST(TileMaker, LetsGoOfThePicturesThatItHasMade) {
  auto tiles = std::make_shared<const NumberedTiles>();
  const std::weak_ptr<const TilePictures> kept = tiles;
  TileMaker maker;
  maker.ask(wishes(tiles, 20, 3));
  tiles.reset();
  maker.wait();
  EXPECT_TRUE(kept.expired());
}

}  // namespace tile_maker_test
}  // namespace nadir
