// SPDX-License-Identifier: Apache-2.0
#include "core/session/file_kind.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace file_kind_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Things of every kind, as small as they can be.
struct Things {
  ScratchFolder scratch;
  Things() {
    scratch.file("loop.nadir", std::string("SQLite format 3\0 and so on", 26));
    scratch.file("text.nadir", "this is no run");
    scratch.file("town/map.toml", "name = \"town\"\n");
    scratch.file("loop/flight.toml", "[flight]\n");
    scratch.file("drive/oxts/timestamps.txt", "");
    scratch.file("00/times.txt", "0\n");
    scratch.file("00/poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
    scratch.file("plain/readme.txt", "nothing\n");
    scratch.file("figure.toml", "figure = \"moment\"\n");
    scratch.file("wide.toml", "preset = \"thesis\"\n");
    scratch.file("other.toml", "a = 1\n");
    scratch.file("broken.toml", "a = \n");
    scratch.file("moment.svg", "<svg><metadata># Drawn by Nadir 1.2</metadata></svg>");
    scratch.file("holiday.png", "\x89PNG and a beach");
    scratch.file("track.txt", "0.0 1 2 3 0 0 0 1\n");
    scratch.file("film.mp4", "x");
  }
  [[nodiscard]] fs::path in(const char* name) const { return scratch.path() / name; }
  [[nodiscard]] FileKind seen(const char* name) const {
    return kind_at_a_glance(in(name), fs::is_directory(in(name)));
  }
};

TEST(FileKind, IsToldByWhatIsInIt) {
  const Things things;
  const std::vector<std::pair<const char*, FileKind>> known = {
      {"loop.nadir", FileKind::kRun},
      {"text.nadir", FileKind::kRun},  // what is wrong with it is said when it is opened
      {"town", FileKind::kMap},
      {"loop", FileKind::kFlight},
      {"drive", FileKind::kFlight},
      {"00", FileKind::kFlight},
      {"plain", FileKind::kFolder},
      {"figure.toml", FileKind::kFigureRecipe},
      {"wide.toml", FileKind::kRunRecipe},
      {"other.toml", FileKind::kOther},
      {"broken.toml", FileKind::kOther},
      {"moment.svg", FileKind::kFigure},
      {"holiday.png", FileKind::kOther},
      {"track.txt", FileKind::kFlight},
      {"plain/readme.txt", FileKind::kOther},
      {"film.mp4", FileKind::kOther}};
  for (const auto& [name, kind] : known) {
    EXPECT_EQ(enum_name(things.seen(name)), enum_name(kind)) << name;
  }
}

TEST(FileKind, OfWhatIsOfferedCanBeOpenedAsThatKind) {
  const Things things;
  for (const auto& entry : fs::directory_iterator(things.scratch.path())) {
    const FileKind kind = kind_at_a_glance(entry.path(), entry.is_directory());
    if (!can_be_opened(kind) || entry.path().filename() == "text.nadir") continue;
    const auto opened = file_to_open(entry.path());
    ASSERT_TRUE(opened) << error_text(opened);
    EXPECT_EQ(enum_name(opened->kind), enum_name(kind)) << entry.path();
    EXPECT_EQ(opened->path, entry.path());
  }
}

TEST(FileToOpen, OfTheFileThatDescribesAFolderIsTheFolder) {
  const Things things;
  const auto map = file_to_open(things.in("town/map.toml"));
  ASSERT_TRUE(map) << error_text(map);
  EXPECT_EQ(map->kind, FileKind::kMap);
  EXPECT_EQ(map->path, things.in("town"));
  const auto flight = file_to_open(things.in("loop/flight.toml"));
  ASSERT_TRUE(flight) << error_text(flight);
  EXPECT_EQ(flight->kind, FileKind::kFlight);
  EXPECT_EQ(flight->path, things.in("loop"));
}

TEST(FileToOpen, SaysWhyNot) {
  const Things things;
  EXPECT_THAT(error_text(file_to_open(things.in("none"))), HasSubstr("none: does not exist"));
  EXPECT_THAT(error_text(file_to_open(things.in("text.nadir"))), HasSubstr("is not a run file"));
  EXPECT_THAT(error_text(file_to_open(things.in("other.toml"))), HasSubstr("is no recipe"));
  EXPECT_THAT(error_text(file_to_open(things.in("broken.toml"))), HasSubstr("line 1"));
  EXPECT_THAT(error_text(file_to_open(things.in("film.mp4"))), HasSubstr("only PNG and SVG"));
  const fs::path large = things.scratch.file("large.toml", std::string(kMostRecipeBytes + 1, '#'));
  EXPECT_THAT(error_text(file_to_open(large)), HasSubstr("is too large for a recipe"));
}

}  // namespace file_kind_test
}  // namespace nadir
