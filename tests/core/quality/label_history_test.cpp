// SPDX-License-Identifier: Apache-2.0
#include "core/quality/label_history.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace label_history_test {

using testing::ElementsAre;
using testing::Pair;

/// A file with some steps, branches among them, and what the document was at each.
class History : public testing::Test {
 protected:
  History() {
    auto made =
        LabelStore::create(scratch_.path() / "labels.gpkg", test_plane(), test_grid(40, 30), "ada");
    if (!made) throw std::runtime_error(error_text(made));
    store_ = std::make_unique<LabelStore>(std::move(*made));
    was_.emplace(0, store_->document());
  }
  void work(std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t step = first; step < first + count; ++step) {
      const auto done = store_->commit(random_edit(store_->document(), 21, step));
      ASSERT_TRUE(done) << error_text(done);
      was_.emplace(store_->undo_step()->number, store_->document());
    }
  }
  void undo(int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(store_->undo());
  }
  [[nodiscard]] LabelReplay replay() const {
    const auto& step = store_->undo_step();
    return {store_->document(), step ? step->number : 0,
            [this](const LabelDocument& document, std::int64_t from, std::int64_t to) {
              return store_->way(document, from, to);
            }};
  }

  ScratchFolder scratch_;
  std::unique_ptr<LabelStore> store_;
  std::map<std::int64_t, LabelDocument> was_;  ///< By step.
};

TEST_F(History, ReplayShowsTheDocumentAtAnyStepOfAnyBranch) {
  work(0, 12);
  undo(5);
  work(100, 6);
  undo(9);
  work(200, 4);
  const LabelDocument now = store_->document();
  LabelReplay replay = this->replay();
  ASSERT_EQ(was_.size(), 23U);
  for (std::int64_t i = 0; i < 46; ++i) {
    const std::int64_t step = i * 7 % 23;
    const auto gone = replay.go_to(step);
    ASSERT_TRUE(gone) << error_text(gone);
    EXPECT_EQ(replay.step(), step);
    EXPECT_TRUE(replay.document() == was_.at(step)) << step;
  }
  EXPECT_TRUE(store_->document() == now);
  EXPECT_EQ(store_->undo_step()->number, 22);
}

TEST_F(History, ReplayToAStepThatIsNotThereStays) {
  work(0, 3);
  LabelReplay replay = this->replay();
  for (const std::int64_t step : {std::int64_t{9}, std::int64_t{-1}}) {
    const auto gone = replay.go_to(step);
    ASSERT_FALSE(gone);
    EXPECT_EQ(gone.error().code, ErrorCode::kInvalidOptions);
    EXPECT_EQ(replay.step(), 3);
    EXPECT_TRUE(replay.document() == was_.at(3));
  }
}

TEST_F(History, EntriesSayWhatEachStepTouched) {
  ASSERT_TRUE(store_->commit(adding({area(kRoad, {box(2, 2, 12, 12)}, 1)}, "Draw road")));
  ASSERT_TRUE(store_->commit(painting(store_->document(), {20, 20, 24, 22}, kTerrain)));
  ASSERT_TRUE(store_->commit(
      {"Set", {}, {}, {{"offset", {nullptr, std::make_shared<const std::string>("1")}}}}));
  ASSERT_TRUE(store_->undo());
  ASSERT_TRUE(store_->undo());
  ASSERT_TRUE(store_->commit({"Delete", {{store_->document().object(1), nullptr}}, {}, {}}));
  const auto steps = store_->history(1, 100);
  ASSERT_TRUE(steps);
  LabelReplay replay = this->replay();
  const auto entries = history_entries(*steps, replay);
  ASSERT_TRUE(entries) << error_text(entries);
  ASSERT_EQ(entries->size(), 4U);
  EXPECT_EQ(entries->at(0).step.title, "Draw road");
  EXPECT_EQ(entries->at(0).objects, 1);
  EXPECT_EQ(entries->at(0).bounds.low, Eigen::Vector2d(2, -12));
  EXPECT_EQ(entries->at(1).tiles, 1);
  EXPECT_LE(entries->at(1).bounds.low.x(), 20.0);
  EXPECT_GE(entries->at(1).bounds.low.x(), 18.0);
  EXPECT_GE(entries->at(1).bounds.high.x(), 24.0);
  EXPECT_LE(entries->at(1).bounds.high.x(), 26.0);
  EXPECT_TRUE(entries->at(2).bounds.is_empty);
  EXPECT_EQ(entries->at(3).bounds.high, Eigen::Vector2d(12, -2));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(history_entries(*steps, replay, {stop.get_token(), {}}).error().code,
            ErrorCode::kCancelled);
}

HistoryEntry entry(const std::string& author, const std::string& time, const std::string& title) {
  HistoryEntry made;
  made.step.author = author;
  made.step.time = time;
  made.step.title = title;
  return made;
}

std::vector<std::vector<std::size_t>> entries_of(const std::vector<HistoryGroup>& groups) {
  std::vector<std::vector<std::size_t>> entries;
  for (const HistoryGroup& group : groups) entries.push_back(group.entries);
  return entries;
}

TEST(GroupedHistory, BySessionDayAndAuthor) {
  const std::vector<HistoryEntry> entries{entry("ada", "2026-11-22T23:40:00Z", "Draw road"),
                                          entry("bob", "2026-11-22T23:45:00Z", "Draw curb"),
                                          entry("ada", "2026-11-23T00:05:00Z", "Draw road"),
                                          entry("ada", "2026-11-23T00:40:00Z", "Delete"),
                                          entry("ada", "2026-11-23T00:50:00Z", "Draw road"),
                                          entry("ada", "sometime", "Draw road")};
  using Entries = std::vector<std::size_t>;
  const auto sessions = grouped(entries, HistoryGrouping::kSession);
  EXPECT_THAT(entries_of(sessions),
              ElementsAre(Entries{0, 2}, Entries{1}, Entries{3, 4}, Entries{5}));
  EXPECT_EQ(sessions[0].from_time, "2026-11-22T23:40:00Z");
  EXPECT_EQ(sessions[0].to_time, "2026-11-23T00:05:00Z");
  EXPECT_THAT(entries_of(grouped(entries, HistoryGrouping::kSession, 60.0)),
              ElementsAre(Entries{0, 2, 3, 4}, Entries{1}, Entries{5}));
  const auto days = grouped(entries, HistoryGrouping::kDay);
  EXPECT_THAT(entries_of(days), ElementsAre(Entries{0, 1}, Entries{2, 3, 4}, Entries{5}));
  EXPECT_THAT(days[0].authors, ElementsAre("ada", "bob"));
  const auto authors = grouped(entries, HistoryGrouping::kAuthor);
  EXPECT_THAT(entries_of(authors), ElementsAre(Entries{0, 2, 3, 4, 5}, Entries{1}));
  EXPECT_THAT(authors[0].titles, ElementsAre(Pair("Draw road", 4), Pair("Delete", 1)));
}

TEST(GroupedHistory, HoldsWhatItsStepsTouched) {
  std::vector<HistoryEntry> entries(3, entry("ada", "2026-11-22T23:40:00Z", "Draw"));
  entries[0].bounds.include({1, 2});
  entries[2].bounds.include({-3, 5});
  const auto groups = grouped(entries, HistoryGrouping::kDay);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].bounds.low, Eigen::Vector2d(-3, 2));
  EXPECT_EQ(groups[0].bounds.high, Eigen::Vector2d(1, 5));
}

}  // namespace label_history_test
}  // namespace nadir
