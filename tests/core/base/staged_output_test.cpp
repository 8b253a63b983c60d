// SPDX-License-Identifier: Apache-2.0
#include "core/base/staged_output.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>

#include "tests/support/dead_process.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace staged_output_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

void write(const fs::path& path, std::string_view text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string read(const fs::path& path) { return read_text_file(path).value_or("(unreadable)"); }

TEST(StagedFile, AppearsOnlyOnCommit) {
  const ScratchFolder folder;
  const fs::path target = folder.path() / "run.nadir";
  auto staged = StagedOutput::file(target);
  ASSERT_TRUE(staged) << error_text(staged);
  EXPECT_THAT(staged->path().filename().string(), HasSubstr("run.nadir.partial-"));
  write(staged->path(), "whole");
  EXPECT_FALSE(fs::exists(target));
  EXPECT_TRUE(staged->commit());
  EXPECT_EQ(read(target), "whole");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(StagedFile, WithoutCommitLeavesWhatWasThere) {
  const ScratchFolder folder;
  const fs::path target = folder.file("run.nadir", "old");
  {
    auto staged = StagedOutput::file(target);
    ASSERT_TRUE(staged);
    write(staged->path(), "half");
  }
  EXPECT_EQ(read(target), "old");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(StagedFile, CommitReplacesTheOldFile) {
  const ScratchFolder folder;
  const fs::path target = folder.file("run.nadir", "old");
  EXPECT_TRUE(write_text_file(target, "new"));
  EXPECT_EQ(read(target), "new");
}

TEST(StagedFile, AsANewOneItReplacesNothingThatCameMeanwhile) {
  const ScratchFolder folder;
  const fs::path target = folder.path() / "labels.gpkg";
  for (const bool is_free : {true, false}) {
    auto staged = StagedOutput::file(target);
    ASSERT_TRUE(staged);
    write(staged->path(), is_free ? "mine" : "second");
    const auto done = staged->commit_as_new();
    EXPECT_EQ(done.has_value(), is_free) << error_text(done);
    EXPECT_EQ(read(target), "mine");
  }
  EXPECT_EQ(folder.entries(), 1);
}

TEST(StagedFile, AProcessThatDiesHalfWayLeavesTheOldFileWhole) {
  const ScratchFolder folder;
  const fs::path target = folder.file("run.nadir", "old");
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    auto staged = StagedOutput::file(target);
    if (staged) write(staged->path(), "half");
    ::_exit(0);  // as after SIGKILL: no destructor runs
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(read(target), "old");
  EXPECT_EQ(folder.entries(), 2);
  EXPECT_TRUE(write_text_file(target, "new"));  // what the dead process left is in nobody's way
  EXPECT_EQ(read(target), "new");
  EXPECT_EQ(folder.entries(), 1) << "and goes";
}

TEST(StagedFile, LeavesWhatALivingProcessWritesAndWhatIsNoneOfItsOwn) {
  const ScratchFolder folder;
  const fs::path target = folder.path() / "run.nadir";
  const std::vector<fs::path> others = {
      folder.file("run.nadir.partial-" + std::to_string(::getppid()), "at work"),
      folder.file("run.nadir.partial-notes", "a note"),
      folder.file("run.nadir.earlier-" + std::to_string(dead_process()), "an earlier run"),
      folder.file("other.partial-" + std::to_string(dead_process()), "another output")};
  EXPECT_TRUE(write_text_file(target, "new"));
  for (const fs::path& other : others) EXPECT_TRUE(fs::exists(other)) << other;
}

TEST(StagedFile, ACommitOfWhatWasNeverWrittenSaysSo) {
  const ScratchFolder folder;
  const fs::path target = folder.file("run.nadir", "old");
  auto staged = StagedOutput::file(target);
  ASSERT_TRUE(staged);
  EXPECT_THAT(error_text(staged->commit()), HasSubstr("is gone before it was complete"));
  EXPECT_EQ(read(target), "old");
}

TEST(StagedFile, AMissingParentIsSaidBeforeAnyWork) {
  const ScratchFolder folder;
  const auto staged = StagedOutput::file(folder.path() / "none" / "run.nadir");
  EXPECT_EQ(error_code(staged), ErrorCode::kIo);
  EXPECT_THAT(error_text(staged), HasSubstr("none does not exist"));
  const auto below_a_file = StagedOutput::file(folder.file("plain", "") / "run.nadir");
  EXPECT_THAT(error_text(below_a_file), HasSubstr("does not exist"));
}

TEST(StagedFile, AFolderThatIsNotWritableIsSaidBeforeAnyWork) {
  const ScratchFolder folder;
  const fs::path locked = folder.path() / "locked";
  fs::create_directory(locked);
  fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);
  if (::access(locked.c_str(), W_OK) == 0) GTEST_SKIP() << "root may write everywhere";
  EXPECT_THAT(error_text(StagedOutput::file(locked / "run.nadir")), HasSubstr("is not writable"));
  EXPECT_THAT(error_text(StagedOutput::folder(locked / "flight", "flight.toml")),
              HasSubstr("is not writable"));
}

TEST(StagedFile, AFileSystemThatRefusesWritesIsSaidForRootToo) {
  // The kernel's own tree takes no new files from anybody.
  if (!fs::is_directory("/proc/self")) GTEST_SKIP() << "there is no /proc";
  const auto written = write_text_file("/proc/self/run.nadir", "text");
  EXPECT_EQ(error_code(written), ErrorCode::kIo);
  EXPECT_THAT(error_text(written), HasSubstr("/proc/self/run.nadir: "));
}

TEST(StagedFile, AFolderOrAnEmptyNameIsNoTarget) {
  const ScratchFolder folder;
  EXPECT_THAT(error_text(StagedOutput::file(folder.path())), HasSubstr("is a folder, not a file"));
  EXPECT_EQ(error_code(StagedOutput::file("")), ErrorCode::kInvalidOptions);
  EXPECT_EQ(error_code(StagedOutput::folder("", "flight.toml")), ErrorCode::kInvalidOptions);
}

TEST(StagedFile, AFolderThatCameToStandInItsPlaceStays) {
  const ScratchFolder folder;
  const fs::path target = folder.path() / "run.nadir";
  {
    auto staged = StagedOutput::file(target);
    ASSERT_TRUE(staged);
    write(staged->path(), "whole");
    (void)folder.file("run.nadir/chapter.tex", "three years of work");
    EXPECT_EQ(error_text(staged->commit()), target.string() + ": is a folder, not a file");
  }
  EXPECT_EQ(read(target / "chapter.tex"), "three years of work");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(StagedFile, MovingItMovesTheDutyToCleanUp) {
  const ScratchFolder folder;
  {
    auto staged = StagedOutput::file(folder.path() / "run.nadir");
    ASSERT_TRUE(staged);
    write(staged->path(), "half");
    const StagedOutput moved = std::move(*staged);
    EXPECT_TRUE(fs::exists(moved.path()));
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(StagedFolder, AppearsWholeOnCommit) {
  const ScratchFolder folder;
  const fs::path target = folder.path() / "flight";
  auto staged = StagedOutput::folder(target, "flight.toml");
  ASSERT_TRUE(staged) << error_text(staged);
  write(staged->path() / "flight.toml", "name");
  EXPECT_FALSE(fs::exists(target));
  EXPECT_TRUE(staged->commit());
  EXPECT_EQ(read(target / "flight.toml"), "name");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(StagedFolder, WithoutCommitLeavesNothing) {
  const ScratchFolder folder;
  {
    auto staged = StagedOutput::folder(folder.path() / "flight", "flight.toml");
    ASSERT_TRUE(staged);
    write(staged->path() / "flight.toml", "half");
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(StagedFolder, ReplacesAnEarlierOutputOfTheSameKindWithAllThatWasInIt) {
  const ScratchFolder folder;
  const fs::path target = folder.path() / "flight";
  (void)folder.file("flight/flight.toml", "old");
  (void)folder.file("flight/depth/0.png", "old");
  auto staged = StagedOutput::folder(target, "flight.toml");
  ASSERT_TRUE(staged) << error_text(staged);
  write(staged->path() / "flight.toml", "new");
  EXPECT_EQ(read(target / "flight.toml"), "old");
  EXPECT_TRUE(staged->commit());
  EXPECT_EQ(read(target / "flight.toml"), "new");
  EXPECT_FALSE(fs::exists(target / "depth"));
  EXPECT_EQ(folder.entries(), 1);
}

TEST(StagedFolder, ClearsWhatADeadProcessLeftOfTheSameFolder) {
  const ScratchFolder folder;
  const std::string partial = "flight.partial-" + std::to_string(dead_process());
  const std::string replaced = "flight.replaced-" + std::to_string(dead_process());
  (void)folder.file(partial + "/depth/0.png", "half");
  (void)folder.file(replaced + "/flight.toml", "perhaps all that there is");
  auto staged = StagedOutput::folder(folder.path() / "flight" / "", "flight.toml");
  ASSERT_TRUE(staged) << error_text(staged);
  EXPECT_FALSE(fs::exists(folder.path() / partial));
  EXPECT_TRUE(staged->commit());
  EXPECT_TRUE(fs::exists(folder.path() / replaced)) << "this is never taken away";
  EXPECT_EQ(folder.entries(), 2);
}

TEST(StagedFolder, LeavesAFolderOfOtherThingsAlone) {
  const ScratchFolder folder;
  (void)folder.file("thesis/chapter.tex", "three years of work");
  const auto staged = StagedOutput::folder(folder.path() / "thesis", "flight.toml");
  EXPECT_EQ(error_code(staged), ErrorCode::kIo);
  EXPECT_THAT(error_text(staged), HasSubstr("holds no flight.toml, so it is left alone"));
  EXPECT_EQ(folder.entries(), 1);
}

TEST(StagedFolder, TakesAnEmptyFolderAndASlashAtTheEnd) {
  const ScratchFolder folder;
  fs::create_directory(folder.path() / "flight");
  auto staged = StagedOutput::folder(folder.path() / "flight" / "", "flight.toml");
  ASSERT_TRUE(staged) << error_text(staged);
  EXPECT_EQ(staged->path().parent_path(), folder.path());
  EXPECT_TRUE(staged->commit());
  EXPECT_EQ(folder.entries(), 1);
}

TEST(StagedFolder, AFileInItsPlaceIsAFault) {
  const ScratchFolder folder;
  EXPECT_THAT(error_text(StagedOutput::folder(folder.file("flight", ""), "flight.toml")),
              HasSubstr("exists and is not a folder"));
}

/// Begins a flight, lets `meanwhile` be written into the folder's place, commits, and cleans up.
std::string fault_of_late_commit(const ScratchFolder& folder, const std::string& meanwhile) {
  static constexpr std::array<std::string_view, 2> kEntries = {"flight.toml", "labels"};
  auto staged = StagedOutput::folder(folder.path() / "flight", "flight.toml", kEntries);
  if (!staged) return "cannot be begun: " + error_text(staged);
  write(staged->path() / "flight.toml", "new");
  (void)folder.file(meanwhile, "of somebody else");
  const auto committed = staged->commit();
  return error_text(committed);
}

TEST(StagedFolder, AFolderThatAppearsWhileItIsWrittenStays) {
  const ScratchFolder folder;
  EXPECT_EQ(fault_of_late_commit(folder, "flight/notes.txt"),
            (folder.path() / "flight").string() +
                ": holds notes.txt, so it is left alone; name a new folder");
  EXPECT_EQ(read(folder.path() / "flight" / "notes.txt"), "of somebody else");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(StagedFolder, AFolderThatIsFilledWhileItIsWrittenStays) {
  const ScratchFolder folder;
  fs::create_directory(folder.path() / "flight");
  EXPECT_THAT(fault_of_late_commit(folder, "flight/labels"),
              HasSubstr("holds no flight.toml, so it is left alone"));
  EXPECT_EQ(read(folder.path() / "flight" / "labels"), "of somebody else");

  const ScratchFolder earlier;
  (void)earlier.file("flight/flight.toml", "old");
  EXPECT_THAT(fault_of_late_commit(earlier, "flight/notes.txt"), HasSubstr("holds notes.txt"));
  EXPECT_EQ(read(earlier.path() / "flight" / "flight.toml"), "old");
  EXPECT_EQ(earlier.entries(), 1);
}

TEST(StagedFolder, AFileThatAppearsWhileItIsWrittenStays) {
  const ScratchFolder folder;
  EXPECT_THAT(fault_of_late_commit(folder, "flight"), HasSubstr("exists and is not a folder"));
  EXPECT_EQ(read(folder.path() / "flight"), "of somebody else");
}

TEST(StagedFolder, ACheckHasTheLastWordOnAFilledFolderAtTheStartAndAtTheEnd) {
  const ScratchFolder folder;
  const fs::path target = folder.path() / "flight";
  const auto check = [](const fs::path& found) -> Result<void> {
    if (read(found / "flight.toml") == "mine") return {};
    return fail(ErrorCode::kIo, "not mine");
  };
  fs::create_directory(target);
  EXPECT_TRUE(StagedOutput::folder(target, "flight.toml", {}, check)) << "an empty one may go";
  (void)folder.file("flight/flight.toml", "yours");
  EXPECT_EQ(error_text(StagedOutput::folder(target, "flight.toml", {}, check)), "not mine");
  (void)folder.file("flight/flight.toml", "mine");
  {
    auto staged = StagedOutput::folder(target, "flight.toml", {}, check);
    ASSERT_TRUE(staged) << error_text(staged);
    auto moved = std::move(*staged);
    write(moved.path() / "flight.toml", "mine, too");
    (void)folder.file("flight/flight.toml", "yours");
    EXPECT_EQ(error_text(moved.commit()), "not mine");
    EXPECT_EQ(read(target / "flight.toml"), "yours");
    (void)folder.file("flight/flight.toml", "mine");
    EXPECT_TRUE(moved.commit());
  }
  EXPECT_EQ(read(target / "flight.toml"), "mine, too");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(StagedFolder, ACommitThatFailsKeepsTheOldFolder) {
  const ScratchFolder folder;
  (void)folder.file("flight/flight.toml", "old");
  {
    auto staged = StagedOutput::folder(folder.path() / "flight", "flight.toml");
    ASSERT_TRUE(staged);
    fs::remove_all(staged->path());  // somebody tidied up meanwhile
    EXPECT_EQ(error_code(staged->commit()), ErrorCode::kIo);
  }
  EXPECT_EQ(read(folder.path() / "flight" / "flight.toml"), "old");
  EXPECT_EQ(folder.entries(), 1);
}

/// Lets files grow to a few bytes only while it lives, which is what a full disk looks like, to
/// root too.
class FullDisk {
 public:
  FullDisk() : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_limit_);
    rlimit limit = old_limit_;
    limit.rlim_cur = 4096;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_limit_);
    (void)std::signal(SIGXFSZ, old_handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*old_handler_)(int);
  rlimit old_limit_{};
};

TEST(WriteTextFile, AFullDiskIsAFaultThatLeavesTheOldFile) {
  const ScratchFolder folder;
  const fs::path target = folder.file("table.csv", "old");
  Result<void> written;
  {
    const FullDisk full;
    written = write_text_file(target, std::string(1'000'000, 'x'));
  }
  EXPECT_EQ(error_code(written), ErrorCode::kIo);
  EXPECT_THAT(error_text(written), HasSubstr("table.csv: cannot be written"));
  EXPECT_EQ(read(target), "old");
  EXPECT_EQ(folder.entries(), 1);
}

std::vector<StagedOutput> begun(const ScratchFolder& folder, std::vector<std::string> names) {
  std::vector<StagedOutput> files;
  for (const std::string& name : names) {
    files.push_back(StagedOutput::file(folder.path() / name).value());
    std::ofstream(files.back().path()) << "new " << name;
  }
  return files;
}

TEST(StagedOutput, FilesThatBelongTogetherGetTheirNamesTogether) {
  const ScratchFolder folder;
  folder.file("b", "old b");
  {
    auto files = begun(folder, {"a", "b", "c"});
    ASSERT_TRUE(StagedOutput::commit_all(files));
  }
  EXPECT_EQ(read(folder.path() / "a"), "new a");
  EXPECT_EQ(read(folder.path() / "b"), "new b");
  EXPECT_EQ(read(folder.path() / "c"), "new c");
  EXPECT_EQ(folder.entries(), 3);
}

TEST(StagedOutput, WhereOneOfThemFailsAllAreAsTheyWere) {
  const ScratchFolder folder;
  folder.file("b", "old b");
  {
    auto files = begun(folder, {"a", "b", "c"});
    std::filesystem::create_directory(folder.path() / "c");
    EXPECT_THAT(error_text(StagedOutput::commit_all(files)), HasSubstr("c: is a folder"));
  }
  EXPECT_EQ(read(folder.path() / "b"), "old b");
  EXPECT_EQ(folder.entries(), 2) << "b, and the folder that somebody has put there";
  std::filesystem::remove(folder.path() / "c");
  {
    // One of which nothing is left once the first has its name: the first two go back.
    auto files = begun(folder, {"a", "b", "a"});
    EXPECT_EQ(error_code(StagedOutput::commit_all(files)), ErrorCode::kIo);
  }
  EXPECT_EQ(read(folder.path() / "b"), "old b");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(ReadTextFile, GivesEveryByte) {
  const ScratchFolder folder;
  std::string bytes(200'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 7 % 256);
  EXPECT_EQ(read_text_file(folder.file("a.bin", bytes)).value(), bytes);
  EXPECT_EQ(read_text_file(folder.file("empty", "")).value(), "");
}

TEST(ReadTextFile, EachFaultNamesTheFile) {
  const ScratchFolder folder;
  const auto missing = read_text_file(folder.path() / "none");
  EXPECT_EQ(error_code(missing), ErrorCode::kNotFound);
  EXPECT_THAT(error_text(missing), HasSubstr("none: does not exist"));
  EXPECT_EQ(error_code(read_text_file(folder.path())), ErrorCode::kIo);
  const auto large = read_text_file(folder.file("large", std::string(1001, 'x')), 1000);
  EXPECT_EQ(error_code(large), ErrorCode::kUnsupported);
  EXPECT_THAT(error_text(large), HasSubstr("large: is larger than 1000 bytes"));
  EXPECT_TRUE(read_text_file(folder.path() / "large", 1001));
}

TEST(StagedOutput, LeavesAFolderAloneThatHoldsMoreThanItsOwnEntriesAndNamesIt) {
  const ScratchFolder folder;
  folder.file("flight/flight.toml", "old");
  folder.file("flight/notes.txt", "precious");
  static constexpr std::array<std::string_view, 2> kEntries = {"flight.toml", "labels"};
  EXPECT_THAT(error_text(StagedOutput::folder(folder.path() / "flight", "flight.toml", kEntries)),
              testing::HasSubstr("holds notes.txt"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "flight" / "notes.txt"));
  EXPECT_TRUE(StagedOutput::folder(folder.path() / "flight", "flight.toml").has_value());
}

}  // namespace staged_output_test
}  // namespace nadir
