// SPDX-License-Identifier: Apache-2.0
#include "core/session/typed_path.h"

#include <gtest/gtest.h>

namespace nadir {
namespace typed_path_test {

struct Reading {
  const char* typed;
  bool is_path;
  const char* folder;
  const char* last;
};

class TypedPaths : public testing::TestWithParam<Reading> {};

TEST_P(TypedPaths, AreReadFromTheFolderThatIsShown) {
  const Reading& wanted = GetParam();
  const TypedPath read = read_typed_path(wanted.typed, "/data/flights", "/home/ada");
  EXPECT_EQ(read.is_path, wanted.is_path);
  EXPECT_EQ(read.folder.string(), wanted.folder);
  EXPECT_EQ(read.last, wanted.last);
}

INSTANTIATE_TEST_SUITE_P(All,
                         TypedPaths,
                         testing::Values(Reading{"", false, "/data/flights", ""},
                                         Reading{"loop 7", false, "/data/flights", "loop 7"},
                                         Reading{"/", true, "/", ""},
                                         Reading{"/maps/to", true, "/maps", "to"},
                                         Reading{"/maps/town/", true, "/maps/town", ""},
                                         Reading{"../maps/t", true, "/data/maps", "t"},
                                         Reading{"2018/", true, "/data/flights/2018", ""},
                                         Reading{"./a", true, "/data/flights", "a"},
                                         Reading{"~", true, "/home/ada", ""},
                                         Reading{"~/", true, "/home/ada", ""},
                                         Reading{"~/runs/a.nadir", true, "/home/ada/runs",
                                                 "a.nadir"},
                                         Reading{"~ada", false, "/data/flights", "~ada"},
                                         Reading{"/../..", true, "/", ".."}));

TEST(TypedPath, OfAFolderIsTheFolderItself) {
  EXPECT_EQ(read_typed_path("/maps/", "/", "").whole(), "/maps");
  EXPECT_EQ(read_typed_path("/maps/town", "/", "").whole(), "/maps/town");
}

TEST(CompletedName, GoesAsFarAsAllNamesAgree) {
  const std::vector<std::string> names = {"flight-1", "flight-2", "map"};
  EXPECT_EQ(completed_name("f", names), "flight-");
  EXPECT_EQ(completed_name("m", names), "map");
  EXPECT_EQ(completed_name("flight-2", names), "flight-2");
  EXPECT_EQ(completed_name("x", names), "x") << "nothing begins so";
  EXPECT_EQ(completed_name("", names), "") << "they have nothing in common";
  EXPECT_EQ(completed_name("a", {}), "a");
}

TEST(FreeName, CountsUpBeforeTheEnding) {
  EXPECT_EQ(free_name("moment.png", {}), "moment.png");
  EXPECT_EQ(free_name("moment.png", {"moment.png", "moment-2.png"}), "moment-3.png");
  EXPECT_EQ(free_name("report", {"report"}), "report-2");
}

TEST(AsFileName, LeavesNothingThatAShellOrAFolderWouldTakeForItsOwn) {
  EXPECT_EQ(as_file_name("loop medium 7"), "loop-medium-7");
  EXPECT_EQ(as_file_name("a/b\\c: d*"), "a-b-c-d");
  EXPECT_EQ(as_file_name("run_2-moment-12.5s"), "run_2-moment-12.5s");
  EXPECT_EQ(as_file_name("Überflug"), "Überflug");
  EXPECT_EQ(as_file_name("  "), "");
}

}  // namespace typed_path_test
}  // namespace nadir
