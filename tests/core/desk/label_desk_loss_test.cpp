// SPDX-License-Identifier: Apache-2.0
// What may happen to a document while somebody draws on it: one sentence, and nothing is lost.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>

#include "tests/core/desk/desk_at_work.h"
#include "tests/core/label/other_program.h"

namespace nadir {
namespace label_desk_loss_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// As long as it lives no file may grow beyond so many bytes: what a full disk says, but by another signal.
class FullDisk {
 public:
  explicit FullDisk(std::uintmax_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &usual_);
    rlimit full = usual_;
    full.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &usual_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit usual_{};
};

/// Runs in a program of its own, which is no longer the administrator after `before`. @returns whether `then` is content.
template <typename Before, typename Then>
bool as_nobody(const Before& before, const Then& then) {
  const pid_t child = ::fork();
  if (child == 0) {
    auto made = before();
    if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(99);
    ::_exit(then(made) ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool is_one_sentence_about(const fs::path& path, const std::string& text) {
  return text.find(path.string()) == 0 && text.find('\n') == std::string::npos &&
         text.back() != '.';
}

class LabelDeskLoss : public DeskAtWork {
 protected:
  void expect_sound(const fs::path& document, const LabelDocument& truth) const {
    const LabelDesk again = opened_desk(document);
    EXPECT_TRUE(again.sheet().now() == truth);
    EXPECT_THAT(again.sheet().why_read_only(), IsEmpty());
    EXPECT_EQ(OtherProgram(document).value("PRAGMA integrity_check"), "ok");
  }
  fs::path copy_ = scratch.path() / "copy.gpkg";
};

TEST_F(LabelDeskLoss, AFullDiskRefusesTheGestureAndKeepsItsPlaces) {
  drawn_box(10, 10, 20, 20);
  take_up(ToolKind::kArea, kTerrain);
  ASSERT_THAT(points({{30, 30}, {40, 30}, {40, 40}}), Succeeds());
  const LabelDocument before = now();
  const std::int64_t revision = desk.sheet().revision();
  {
    const FullDisk full(fs::file_size(path().string() + "-wal"));
    for (const auto& refused : {desk.finish(), desk.set_value("key", "text", "Set")}) {
      EXPECT_TRUE(is_one_sentence_about(path(), error_text(refused))) << error_text(refused);
    }
    EXPECT_FALSE(desk.sheet().save_copy(copy_));
    EXPECT_FALSE(fs::exists(copy_));
    EXPECT_EQ(desk.undo_title(), "Last place") << "the places are still there";
  }
  EXPECT_TRUE(now() == before);
  EXPECT_EQ(desk.sheet().revision(), revision);
  ASSERT_THAT(desk.finish(), Succeeds());  // Somebody has made room.
  EXPECT_EQ(class_at(38, 32), kTerrain);
  const LabelDocument last = now();
  desk = opened_desk(half_a_road(scratch.path()));
  expect_sound(path(), last);
}

TEST_F(LabelDeskLoss, AFullDiskAtTheFirstEditLeavesNoFileAndTheLabels) {
  const fs::path package = half_a_road(scratch.path());
  LabelDesk fresh = opened_desk(package);
  const LabelDocument before = fresh.sheet().now();
  {
    const FullDisk full(20'000);
    const auto refused = fresh.stroke({{250.5, -50.5}}, 3.0, kTerrain);
    EXPECT_TRUE(is_one_sentence_about(package / "labels.gpkg", error_text(refused)));
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(package), fs::directory_iterator()), 3)
      << "map.toml, labels.tif and its notes";
  EXPECT_FALSE(fresh.sheet().is_on_disk());
  EXPECT_TRUE(fresh.sheet().now() == before);
  ASSERT_THAT(fresh.stroke({{250.5, -50.5}}, 3.0, kTerrain), Succeeds());
  EXPECT_TRUE(fresh.sheet().is_on_disk());
}

TEST_F(LabelDeskLoss, AFolderThatMayNoLongerBeWrittenRefusesTheFirstEdit) {
  const fs::path package = half_a_road(scratch.path());
  fs::permissions(scratch.path(), fs::perms(0755));
  const auto open = [&] {
    auto opened = opened_desk(package);
    if (::geteuid() != 0) fs::permissions(package, fs::perms(0555));
    return opened;
  };
  EXPECT_TRUE(as_nobody(open, [&](LabelDesk& fresh) {
    const LabelDocument before = fresh.sheet().now();
    const auto refused = fresh.stroke({{250.5, -50.5}}, 3.0, kTerrain);
    return !refused && is_one_sentence_about(package / "labels.gpkg", error_text(refused)) &&
           fresh.sheet().now() == before && !fresh.sheet().is_on_disk();
  }));
  fs::permissions(package, fs::perms(0755));
  EXPECT_FALSE(fs::exists(package / "labels.gpkg"));
}

TEST_F(LabelDeskLoss, ADocumentInAFolderThatMayNoLongerBeWrittenRefusesEdits) {
  drawn_box(10, 10, 20, 20);
  const LabelDocument before = now();
  desk = opened_desk(half_a_road(scratch.path()));
  fs::permissions(scratch.path(), fs::perms(0755));
  const auto open = [&] {
    auto opened = opened_desk(path());
    if (::geteuid() != 0) fs::permissions(scratch.path(), fs::perms(0555));
    return opened;
  };
  EXPECT_TRUE(as_nobody(open, [&](LabelDesk& reader) {
    const auto refused = reader.stroke({{50.5, -50.5}}, 3.0, kTerrain);
    return !refused && is_one_sentence_about(path(), error_text(refused)) &&
           reader.sheet().now() == before;
  }));
  fs::permissions(scratch.path(), fs::perms(0755));
  expect_sound(path(), before);
}

TEST_F(LabelDeskLoss, OfADocumentDamagedInTheMiddleTheRestIsShownAndCanBeSaved) {
  for (int i = 0; i < 60; ++i) drawn_box(2 * i, 1, 2 * i + 1, 80, i % 2 == 0 ? kRoad : kTerrain);
  ASSERT_THAT(desk.stroke({{50.5, -85.5}}, 3.0, kTerrain), Succeeds());
  const LabelDocument truth = now();
  desk = opened_desk(half_a_road(scratch.path()));
  const auto root = std::stoul(
      OtherProgram(path()).value("SELECT rootpage FROM sqlite_schema WHERE name = 'nadir_object'"));
  {
    std::fstream file(path(), std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>((root - 1) * 4096));
    file << std::string(4096, '\xA5');
  }
  const std::string damaged = bytes_of(path());
  {
    LabelDesk rest = opened_desk(path());
    EXPECT_THAT(rest.sheet().notices(), testing::Contains(HasSubstr("is damaged")));
    const auto refused = rest.stroke({{1.5, -1.5}}, 1.0, kRoad);
    EXPECT_THAT(error_text(refused), HasSubstr("is damaged"));
    EXPECT_TRUE(is_one_sentence_about(path(), error_text(refused)));
    EXPECT_TRUE(rest.sheet().now() == truth) << "the layers still have the objects";
    ASSERT_THAT(rest.sheet().save_copy(copy_), Succeeds());
  }
  EXPECT_EQ(bytes_of(path()), damaged) << "there may be more to be had from it";
  expect_sound(copy_, truth);
}

TEST_F(LabelDeskLoss, DamagedWhileItIsOpenWhatWasDrawnCanBeSaved) {
  for (int i = 0; i < 60; ++i) drawn_box(2 * i, 1, 2 * i + 1, 80);
  const LabelDocument truth = now();
  desk = opened_desk(half_a_road(scratch.path()));  // Into one file.
  LabelDesk again = opened_desk(path());
  {
    std::fstream file(path(), std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(4096);
    for (std::uintmax_t bytes = fs::file_size(path()) - 4096; bytes > 0; --bytes) file.put('\xA5');
  }
  const auto refused = again.stroke({{1.5, -1.5}}, 1.0, kTerrain);
  EXPECT_TRUE(is_one_sentence_about(path(), error_text(refused))) << error_text(refused);
  EXPECT_TRUE(again.sheet().now() == truth);
  ASSERT_THAT(again.sheet().save_copy(copy_), Succeeds());
  expect_sound(copy_, truth);
}

TEST_F(LabelDeskLoss, AReplacedDocumentIsToldOnceAndWhatWasDrawnCanBeSaved) {
  drawn_box(10, 10, 20, 20);
  take_up(ToolKind::kArea, kTerrain);
  ASSERT_THAT(points({{30, 30}, {40, 30}, {40, 40}}), Succeeds());
  const LabelDocument before = now();
  const fs::path other = scratch.path() / "other.gpkg";
  { ASSERT_TRUE(LabelStore::create(other, test_plane(), test_grid(120, 90), "eve")); }
  const std::string others = bytes_of(other);
  fs::rename(other, path());
  const auto refused = desk.finish();
  EXPECT_THAT(error_text(refused), HasSubstr("another program has replaced it"));
  EXPECT_TRUE(is_one_sentence_about(path(), error_text(refused)));
  EXPECT_EQ(desk.sheet().why_read_only(), error_text(refused));
  EXPECT_TRUE(desk.sheet().has_lost_its_file());
  EXPECT_EQ(error_text(desk.poll()), error_text(refused));
  EXPECT_THAT(*desk.poll(), IsEmpty());
  EXPECT_TRUE(now() == before) << "and not what lies there now";
  EXPECT_EQ(desk.undo_title(), "Last place");
  desk.cancel();
  EXPECT_FALSE(desk.undo_title());
  EXPECT_EQ(bytes_of(path()), others);
  EXPECT_THAT(error_text(desk.sheet().save_copy(path())), HasSubstr("is there already"));
  EXPECT_EQ(bytes_of(path()), others);
  ASSERT_THAT(desk.sheet().save_copy(copy_), Succeeds());
  expect_sound(copy_, before);
}

TEST_F(LabelDeskLoss, ADeletedDocumentIsNoticedByPollingAndCanBeSavedWhereItWas) {
  drawn_box(10, 10, 20, 20);
  const LabelDocument before = now();
  fs::remove(path());
  EXPECT_THAT(error_text(desk.poll()), HasSubstr("another program has deleted or moved it"));
  ASSERT_THAT(desk.sheet().save_copy(path()), Succeeds());
  EXPECT_TRUE(now() == before);
  expect_sound(path(), before);
}

TEST_F(LabelDeskLoss, AMapThatIsWrittenAgainLeavesTheDeskAtWork) {
  const fs::path package = half_a_road(scratch.path());
  LabelDesk fresh = opened_desk(package);
  ASSERT_THAT(fresh.stroke({{250.5, -50.5}}, 3.0, kTerrain), Succeeds());
  half_a_road(scratch.path(), true);
  ASSERT_THAT(fresh.stroke({{200.5, -50.5}}, 3.0, kTerrain), Succeeds());
  EXPECT_THAT(*fresh.poll(), IsEmpty());
  const LabelDocument last = fresh.sheet().now();
  desk = std::move(fresh);
  desk = opened_desk(path());
  expect_sound(package / "labels.gpkg", last);
}

TEST_F(LabelDeskLoss, ACopyIsWhatIsSeenAlsoBeforeThereIsAFile) {
  const LabelDesk fresh = opened_desk(half_a_road(scratch.path()));
  ASSERT_THAT(fresh.sheet().save_copy(copy_), Succeeds());
  EXPECT_FALSE(fresh.sheet().is_on_disk());
  expect_sound(copy_, fresh.sheet().now());
}

TEST_F(LabelDeskLoss, KilledInTheFirstEditThereIsNoDocumentOrOneThatHasIt) {
  const fs::path package = half_a_road(scratch.path());
  const Raster<ClassId> labels = read_overhead_map(package)->labels;
  const fs::path document = package / "labels.gpkg";
  int made = 0;
  for (std::uint32_t kill = 0; kill < 40; ++kill) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      LabelDesk fresh = opened_desk(package, "eve");
      if (::write(ends[1], "s", 1) != 1) ::_exit(1);
      [[maybe_unused]] const auto done = fresh.stroke({{250.5, -50.5}}, 3.0, kTerrain);
      for (;;) ::pause();
    }
    char word = 0;
    ASSERT_EQ(::read(ends[0], &word, 1), 1);
    const int spins = static_cast<int>(random_words({71, 0, kill, 0, 0})[0] % 4'000'000);
    for (std::atomic<int> turns = 0; turns < spins; ++turns) {
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ends[0]);
    ::close(ends[1]);
    LabelDesk again = opened_desk(package);
    EXPECT_THAT(again.sheet().why_read_only(), IsEmpty());
    if (again.sheet().is_on_disk()) {
      ++made;
      EXPECT_EQ(again.under({250.5, -50.5}).class_id, kTerrain);
      ASSERT_THAT(again.undo(), Succeeds());
    }
    ASSERT_EQ(rasterise(again.sheet().now()), labels) << "the labels of the map are not hidden";
    desk = std::move(again);
    desk = opened_desk(path());
    fs::remove(document);
  }
  RecordProperty("made", made);
}

TEST_F(LabelDeskLoss, WhoFollowsMayGoOnAfterTheWriterWasKilled) {
  desk = opened_desk(half_a_road(scratch.path()));
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    LabelDesk writer = opened_desk(path(), "eve");
    const auto done = writer.draw({ObjectKind::kArea, kRoad, 0.0}, box(10, 10, 20, 20));
    if (!done || ::write(ends[1], "s", 1) != 1) ::_exit(1);
    for (;;) ::pause();
  }
  char word = 0;
  ASSERT_EQ(::read(ends[0], &word, 1), 1);
  LabelDesk reader = opened_desk(path(), "bob");
  EXPECT_THAT(reader.sheet().why_read_only(), HasSubstr("is open for eve"));
  EXPECT_THAT(*reader.poll(), IsEmpty());
  EXPECT_THAT(*LabelStore::writer(path()), HasSubstr("eve"));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(ends[0]);
  ::close(ends[1]);
  ASSERT_TRUE(fs::exists(path().string() + ".lock")) << "with the name of who is no more";
  EXPECT_FALSE(LabelStore::writer(path()));
  EXPECT_THAT(*reader.poll(), testing::Contains(HasSubstr("can be edited now")));
  EXPECT_EQ(reader.under({15, -15}).class_id, kRoad);
  EXPECT_THAT(reader.stroke({{50.5, -50.5}}, 3.0, kTerrain), Succeeds());
  EXPECT_THAT(*reader.poll(), IsEmpty());
}

}  // namespace label_desk_loss_test
}  // namespace nadir
