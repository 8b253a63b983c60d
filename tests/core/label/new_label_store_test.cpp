// SPDX-License-Identifier: Apache-2.0
// How a document comes into being: whole, or not at all.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>

#include "tests/core/label/label_file.h"

namespace nadir {
namespace new_label_store_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class NewLabelStoreTest : public LabelFile {
 protected:
  /// Made with what somebody takes over, and a first gesture.
  [[nodiscard]] Result<LabelStore> make(const std::string& who) const {
    const LabelDocument empty = test_document(600, 400);
    std::array<LabelEdit, 2> first{painting(empty, {0, 0, 600, 400}, kRoad), {}};
    first[0].title = "Take over";
    first[1] = adding({area(kTerrain, {box(0, 0, 2, 2)})}, "Draw by " + who);
    return LabelStore::create(path_, empty, first, who);
  }
  static void expect_begun(const LabelStore& store) {
    ASSERT_TRUE(store.undo_step());
    EXPECT_EQ(store.undo_step()->number, 2);
    EXPECT_EQ(store.document().paint_at(599, 399), kRoad);
    EXPECT_EQ(store.document().objects().size(), 1U);
  }
};

TEST_F(NewLabelStoreTest, BeginsWithItsFirstSteps) {
  std::optional<LabelDocument> made;
  {
    const auto store = make("ada");
    ASSERT_TRUE(store) << error_text(store);
    expect_begun(*store);
    made = store->document();
    EXPECT_EQ((*store->history(1, 10))[0].title, "Take over");
  }
  EXPECT_EQ(scratch_.entries(), 1);
  LabelStore store = opened();
  EXPECT_TRUE(store.document() == *made);
  EXPECT_EQ(store.document().next_id(), made->next_id());
  expect_begun(store);
  ASSERT_TRUE(store.undo());
  ASSERT_TRUE(store.undo());
  EXPECT_TRUE(store.document() == test_document(600, 400));
  EXPECT_EQ(store.redo_step()->title, "Take over");
}

TEST_F(NewLabelStoreTest, AStepThatDoesNotFitLeavesNoFile) {
  const LabelDocument empty = test_document();
  const std::array<LabelEdit, 2> first{adding({area(kRoad, {box(0, 0, 2, 2)})}),
                                       adding({area(kRoad, {box(0, 0, 2, 2)})})};
  EXPECT_THAT(error_text(LabelStore::create(path_, empty, first, "ada")),
              HasSubstr("has changed since"));
  EXPECT_EQ(scratch_.entries(), 0);
}

TEST_F(NewLabelStoreTest, KilledAtAnyMomentThereIsNoFileOrAWholeOne) {
  int made = 0;
  constexpr int kKills = 60;
  for (std::uint32_t kill = 0; kill < kKills; ++kill) {
    const pid_t child = ::fork();
    if (child == 0) {
      [[maybe_unused]] const auto store = make("eve");
      for (;;) ::pause();
    }
    // From at once to some milliseconds after it was made.
    const int spins = static_cast<int>(random_words({61, 0, kill, 0, 0})[0] % 6'000'000);
    for (std::atomic<int> turns = 0; turns < spins; ++turns) {
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    if (fs::exists(path_)) {
      ++made;
      expect_begun(opened());
      fs::remove(path_);
    }
  }
  RecordProperty("made", made);
  const auto store = make("ada");
  ASSERT_TRUE(store) << error_text(store);
  for (const auto& entry : fs::directory_iterator(scratch_.path())) {
    EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr(".partial-")));
  }
}

TEST_F(NewLabelStoreTest, OfManyThatMakeItAtOnceOneDoesAndTheOthersAreTold) {
  constexpr int kPrograms = 8;
  for (int round = 0; round < 10; ++round) {
    std::array<int, 2> start{};
    std::array<int, 2> words{};
    ASSERT_EQ(::pipe(start.data()) + ::pipe(words.data()), 0);
    std::vector<pid_t> children;
    for (int program = 0; program < kPrograms; ++program) {
      children.push_back(::fork());
      if (children.back() != 0) continue;
      ::close(start[1]);
      ::close(words[0]);
      char word = 0;
      [[maybe_unused]] const auto begun = ::read(start[0], &word, 1);  // When all may.
      const auto store = make(std::to_string(program));
      const std::string why = error_text(store);
      const bool is_told = why.find("is there already") != std::string::npos ||
                           why.find("is open for") != std::string::npos;
      word = static_cast<char>(store ? '0' + program : is_told ? '-' : '!');
      ::_exit(::write(words[1], &word, 1) == 1 ? 0 : 1);
    }
    ::close(start[0]);
    ::close(start[1]);
    ::close(words[1]);
    for (const pid_t child : children) ::waitpid(child, nullptr, 0);
    std::string told(kPrograms + 1, ' ');
    told.resize(static_cast<std::size_t>(::read(words[0], told.data(), told.size())));
    ::close(words[0]);
    std::sort(told.begin(), told.end());
    ASSERT_EQ(told.substr(0, kPrograms - 1), std::string(kPrograms - 1, '-')) << told;
    {
      const LabelStore store = opened();
      expect_begun(store);
      EXPECT_EQ(store.undo_step()->title, fmt::format("Draw by {}", told.back()));
    }
    for (const auto& entry : fs::directory_iterator(scratch_.path())) fs::remove(entry.path());
  }
}

TEST_F(NewLabelStoreTest, SomebodyWhoHasTheDeletedOneOpenIsNotSupplanted) {
  LabelStore first = made();
  work(first, 62, 0, 3);
  fs::remove(path_);
  EXPECT_THAT(error_text(make("eve")), HasSubstr("is open for ada"));
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(NewLabelStoreTest, ChangesOfADocumentThatIsGoneAreKeptAndNotTakenForItsOwn) {
  // What a killed program leaves: a document with changes beside it. Then somebody deletes the document.
  const pid_t child = ::fork();
  if (child == 0) {
    auto store = LabelStore::create(path_, test_plane(), test_grid(40, 30), "eve");
    for (std::uint32_t step = 0; step < 9; ++step) {
      if (!store->commit(random_edit(store->document(), 63, step))) ::_exit(1);
    }
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  const auto bytes = fs::file_size(path_.string() + "-wal");
  ASSERT_GT(bytes, 0U);
  fs::remove(path_);
  scratch_.file("labels.gpkg-journal", "the rest of another one");
  const auto store = make("ada");
  ASSERT_TRUE(store) << error_text(store);
  expect_begun(*store);
  EXPECT_THAT(store->notices(), ElementsAre(HasSubstr("labels.gpkg-wal.left-1"),
                                            HasSubstr("labels.gpkg-journal.left-1")));
  EXPECT_EQ(fs::file_size(path_.string() + "-wal.left-1"), bytes);
  EXPECT_EQ(value_elsewhere("PRAGMA integrity_check"), "ok");
}

TEST_F(NewLabelStoreTest, AFullDiskLeavesNothing) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit usual{};
  ::getrlimit(RLIMIT_FSIZE, &usual);
  for (const rlim_t bytes : {0U, 5'000U, 40'000U, 80'000U}) {
    rlimit full = usual;
    full.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &full);
    const auto refused = make("ada");
    ::setrlimit(RLIMIT_FSIZE, &usual);
    ASSERT_FALSE(refused) << bytes;
    EXPECT_EQ(error_code(refused), ErrorCode::kIo);
    EXPECT_THAT(error_text(refused), HasSubstr(path_.string() + ": "));
    EXPECT_EQ(scratch_.entries(), 0) << bytes;
  }
  EXPECT_TRUE(make("ada"));
}

TEST_F(NewLabelStoreTest, IsNotMadeWhereALinkLeadsNowhere) {
  fs::create_symlink(scratch_.path() / "nothing.gpkg", path_);
  EXPECT_EQ(error_text(make("ada")), path_.string() + ": is a link to a file that is not there");
  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_EQ(scratch_.entries(), 1);
}

}  // namespace new_label_store_test
}  // namespace nadir
