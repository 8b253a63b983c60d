// SPDX-License-Identifier: Apache-2.0
#include "core/base/durability.h"

#include <fcntl.h>
#include <gmock/gmock.h>

#include <cstdio>

#include "core/base/staged_output.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir::detail {
namespace durability_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

// That the bytes survive a power cut cannot be shown here; that every way of waiting is taken without
// a fault, and that faults are told, can.
TEST(WaitForDisk, TakesFilesFoldersAndNames) {
  const ScratchFolder folder;
  const fs::path file = folder.file("flight/depth/0.png", "depth");
  for (const auto& waited :
       {wait_for_disk(file), wait_for_disk(folder.path() / "flight"), wait_for_name(file)}) {
    EXPECT_TRUE(waited) << error_text(waited);
  }
}

TEST(WaitForDisk, WaitsForWhatCannotWaitWithoutAFault) {
  // A device and the kernel's own tree have no disk behind them.
  for (const char* path : {"/dev/null", "/proc/self/stat"}) {
    if (!fs::exists(path)) continue;
    const auto waited = wait_for_disk(path);
    EXPECT_TRUE(waited) << error_text(waited);
  }
}

TEST(WaitForDisk, SaysWhatIsNotThere) {
  const ScratchFolder folder;
  const auto waited = wait_for_disk(folder.path() / "none");
  EXPECT_EQ(error_code(waited), ErrorCode::kIo);
  EXPECT_THAT(error_text(waited), HasSubstr("none: cannot be written: No such file"));
  EXPECT_FALSE(wait_for_name(folder.path() / "none" / "run.nadir"));
}

TEST(RenameWithoutReplacing, GivesTheNameOnlyWhereItIsFree) {
  const ScratchFolder folder;
  const fs::path mine = folder.file("mine", "mine");
  const fs::path other = folder.file("other", "other");
  const auto refused = rename_without_replacing(mine, other);
  EXPECT_EQ(error_text(refused), other.string() + ": is there already");
  EXPECT_EQ(read_text_file(other).value(), "other");
  EXPECT_EQ(read_text_file(mine).value(), "mine");
  fs::create_symlink("nowhere", folder.path() / "link");
  EXPECT_FALSE(rename_without_replacing(mine, folder.path() / "link"));
  const auto done = rename_without_replacing(mine, folder.path() / "free");
  EXPECT_TRUE(done) << error_text(done);
  EXPECT_FALSE(fs::exists(mine));
  EXPECT_EQ(read_text_file(folder.path() / "free").value(), "mine");
  EXPECT_EQ(error_code(rename_without_replacing(mine, folder.path() / "no" / "folder")),
            ErrorCode::kIo);
}

/// Two filled folders, "old" and "new", whose file says which is which.
class TwoFolders : public testing::Test {
 protected:
  TwoFolders() {
    (void)folder.file("old/a", "old");
    (void)folder.file("new/a", "new");
  }
  [[nodiscard]] static std::string content(const fs::path& named) {
    return read_text_file(named / "a").value_or("(nothing)");
  }

  const ScratchFolder folder;
  const fs::path old_folder = folder.path() / "old";
  const fs::path new_folder = folder.path() / "new";
  const fs::path aside = folder.path() / "old.replaced-7";
};

TEST_F(TwoFolders, ExchangeNamesWhereTheFileSystemCan) {
  const ScratchFolder probe;  // In the same place, so on the same file system.
  fs::create_directory(probe.path() / "a");
  fs::create_directory(probe.path() / "b");
  if (::renameat2(AT_FDCWD, (probe.path() / "a").c_str(), AT_FDCWD, (probe.path() / "b").c_str(),
                  RENAME_EXCHANGE) != 0) {
    EXPECT_FALSE(exchange_names(new_folder, old_folder));
    EXPECT_EQ(content(old_folder), "old");
    GTEST_SKIP() << "this file system cannot exchange names";
  }
  EXPECT_TRUE(exchange_names(new_folder, old_folder));
  EXPECT_EQ(content(old_folder), "new");
  EXPECT_EQ(content(new_folder), "old");
  EXPECT_EQ(folder.entries(), 2);
}

TEST_F(TwoFolders, StayAsTheyAreWhereOneOfTwoNamesIsNobodys) {
  EXPECT_FALSE(exchange_names(new_folder, folder.path() / "none"));
  EXPECT_EQ(content(new_folder), "new");
  EXPECT_EQ(folder.entries(), 2);
}

TEST_F(TwoFolders, TakePlacesInTwoStepsAndBothAreStillThere) {
  const auto replaced = replace_in_two_steps(new_folder, old_folder, aside);
  ASSERT_TRUE(replaced) << error_text(replaced);
  EXPECT_EQ(*replaced, aside);
  EXPECT_EQ(content(old_folder), "new");
  EXPECT_EQ(content(aside), "old");
  EXPECT_EQ(folder.entries(), 2);
}

TEST_F(TwoFolders, TheOldOneGetsItsNameBackWhereTheNewOneCannotFollow) {
  const auto replaced = replace_in_two_steps(folder.path() / "none", old_folder, aside);
  EXPECT_EQ(error_code(replaced), ErrorCode::kIo);
  EXPECT_EQ(error_text(replaced), old_folder.string() + ": No such file or directory");
  EXPECT_EQ(content(old_folder), "old");
  EXPECT_EQ(folder.entries(), 2) << "nothing is left aside";
}

TEST_F(TwoFolders, AreLeftAloneWhereTheOldOneCannotStepAside) {
  const auto replaced = replace_in_two_steps(new_folder, folder.path() / "none", aside);
  EXPECT_THAT(error_text(replaced), HasSubstr("none: No such file"));
  EXPECT_EQ(content(new_folder), "new");
  EXPECT_EQ(folder.entries(), 2);
}

TEST_F(TwoFolders, WhatACrashLeftAsideIsNeitherReplacedNorInTheWay) {
  (void)folder.file("old.replaced-7/a", "older");
  (void)folder.file("old.replaced-7-2/a", "oldest");
  const auto replaced = replace_in_two_steps(new_folder, old_folder, aside);
  ASSERT_TRUE(replaced) << error_text(replaced);
  EXPECT_EQ(replaced->filename(), "old.replaced-7-3");
  EXPECT_EQ(content(*replaced), "old");
  EXPECT_EQ(content(aside), "older");
  EXPECT_EQ(content(old_folder), "new");
}

}  // namespace durability_test
}  // namespace nadir::detail
