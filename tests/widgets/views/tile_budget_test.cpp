// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/tile_budget.h"

#include <gmock/gmock.h>

#include <map>

namespace nadir {
namespace tile_budget_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Tiles of 10 bytes, each with the moment at which it was looked at last.
class Pile : public TileBudget::Holder {
 public:
  explicit Pile(TileBudget& budget) : budget_(budget) { budget_.join(*this); }
  ~Pile() override {
    budget_.leave(*this);
    budget_.gave_back(10 * unused_.size() + 10 * shown);
  }
  Pile(const Pile&) = delete;
  Pile& operator=(const Pile&) = delete;
  void add() {
    unused_.push_back(budget_.next_moment());
    budget_.took(10);
  }
  void show_one_more() {
    ++shown;
    budget_.took(10);
  }
  [[nodiscard]] const std::vector<std::uint64_t>& moments() const { return unused_; }
  [[nodiscard]] std::uint64_t longest_unused() const override {
    return unused_.empty() ? TileBudget::kNever : unused_.front();
  }
  void forget_longest_unused() override {
    unused_.erase(unused_.begin());
    budget_.gave_back(10);
  }
  std::size_t shown = 0;

 private:
  TileBudget& budget_;
  std::vector<std::uint64_t> unused_;
};

TEST(TileBudget, LetsGoOfWhatWasLookedAtLongestAgoWhosever) {
  TileBudget budget(40);
  Pile one(budget);
  Pile other(budget);
  for (int i = 0; i < 3; ++i) {
    one.add();
    other.add();
  }
  EXPECT_EQ(budget.used_bytes(), 60U);
  budget.keep();
  EXPECT_EQ(budget.used_bytes(), 40U);
  EXPECT_THAT(one.moments(), ElementsAre(3U, 5U));
  EXPECT_THAT(other.moments(), ElementsAre(4U, 6U));
}

TEST(TileBudget, KeepsWhatFits) {
  TileBudget budget(40);
  Pile pile(budget);
  for (int i = 0; i < 4; ++i) pile.add();
  budget.keep();
  EXPECT_EQ(pile.moments().size(), 4U);
}

TEST(TileBudget, NeverTakesWhatIsShown) {
  TileBudget budget(40);
  Pile shown(budget);
  Pile hidden(budget);
  for (int i = 0; i < 6; ++i) shown.show_one_more();
  hidden.add();
  budget.keep();
  EXPECT_EQ(shown.shown, 6U);
  EXPECT_THAT(hidden.moments(), IsEmpty());
  EXPECT_EQ(budget.used_bytes(), 60U) << "and counts it";
}

TEST(TileBudget, IsFreeAgainWhenAViewGoes) {
  TileBudget budget(40);
  {
    Pile gone(budget);
    for (int i = 0; i < 4; ++i) gone.add();
  }
  EXPECT_EQ(budget.used_bytes(), 0U);
  Pile next(budget);
  for (int i = 0; i < 5; ++i) next.add();
  budget.keep();
  EXPECT_EQ(next.moments().size(), 4U);
}

}  // namespace tile_budget_test
}  // namespace nadir
