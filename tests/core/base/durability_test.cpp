// SPDX-License-Identifier: Apache-2.0
#include "core/base/durability.h"

#include <gmock/gmock.h>

#include "core/base/staged_output.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir::detail {
namespace {

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

TEST(ExchangeNames, GivesFoldersEachOthersNameOrLeavesThemAlone) {
  const ScratchFolder folder;
  (void)folder.file("old/a", "old");
  (void)folder.file("new/a", "new");
  const fs::path old_folder = folder.path() / "old";
  const fs::path new_folder = folder.path() / "new";
  const bool is_exchanged = exchange_names(new_folder, old_folder);
  EXPECT_EQ(read_text_file(old_folder / "a").value(), is_exchanged ? "new" : "old");
  EXPECT_EQ(read_text_file(new_folder / "a").value(), is_exchanged ? "old" : "new");
  EXPECT_FALSE(exchange_names(new_folder, folder.path() / "none"));
  EXPECT_EQ(folder.entries(), 2);
}

}  // namespace
}  // namespace nadir::detail
