// SPDX-License-Identifier: Apache-2.0
#include "core/run/place_beside.h"

#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"

namespace nadir {
namespace place_beside_test {

namespace fs = std::filesystem;
using testing::Optional;

/// A folder with maps/town, runs and other, from which `work` is done.
class PlaceBeside : public testing::Test {
 protected:
  PlaceBeside() : before_(fs::current_path()) {
    for (const char* const name : {"maps/town", "runs", "other"}) {
      fs::create_directories(scratch_.path() / name);
    }
    scratch_.file("maps/town/map.toml", "");
    fs::current_path(scratch_.path());
  }
  ~PlaceBeside() override { fs::current_path(before_); }

  ScratchFolder scratch_;

 private:
  fs::path before_;
};

TEST_F(PlaceBeside, FindsFromAnyFolderWhatWasGivenFromAnother) {
  const std::string named = name_from_run("runs/a.nadir", "maps/town");
  EXPECT_EQ(named, "../maps/town");
  fs::current_path(scratch_.path() / "other");
  const auto there = place_beside("../runs/a.nadir", named, "map.toml");
  ASSERT_TRUE(there);
  EXPECT_TRUE(fs::equivalent(*there, scratch_.path() / "maps" / "town"));
}

TEST_F(PlaceBeside, NamesWhatLiesWithTheRunAsItIs) {
  EXPECT_EQ(name_from_run("a.nadir", "town"), "town");
  EXPECT_EQ(name_from_run("runs/a.nadir", "runs/flight"), "flight");
  EXPECT_EQ(name_from_run("runs/a.nadir", ""), "");
}

TEST_F(PlaceBeside, LeavesAbsolutePathsAlone) {
  const std::string map = (scratch_.path() / "maps" / "town").string();
  EXPECT_EQ(name_from_run("runs/a.nadir", map), map);
  EXPECT_THAT(place_beside("runs/a.nadir", map), Optional(fs::path(map)));
}

TEST_F(PlaceBeside, GoesThroughALinkToTheFolderOfRuns) {
  fs::create_directory(scratch_.path() / "disk");
  fs::create_directory_symlink(scratch_.path() / "disk", scratch_.path() / "other" / "link");
  const std::string named = name_from_run("other/link/a.nadir", "maps/town");
  EXPECT_TRUE(place_beside("other/link/a.nadir", named, "map.toml")) << named;
}

TEST_F(PlaceBeside, FindsWhatWasMovedWithTheRun) {
  fs::rename("maps/town", "runs/town");
  EXPECT_THAT(place_beside("runs/a.nadir", "../maps/town", "map.toml"),
              Optional(fs::path("runs/town")));
  EXPECT_FALSE(place_beside("runs/a.nadir", "../maps/village", "map.toml"));
}

}  // namespace place_beside_test
}  // namespace nadir
