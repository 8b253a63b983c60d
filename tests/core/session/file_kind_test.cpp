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
  EXPECT_THAT(error_text(file_to_open(things.in("plain"))),
              HasSubstr("plain: is a folder that holds neither a map"));
  for (const char* const run : {"made/run.nadir", "made/other.nadir"}) {
    things.scratch.file(run, std::string("SQLite format 3\0 and so on", 26));
  }
  things.scratch.file("made/a.nadir", "this is no run");
  EXPECT_THAT(
      error_text(file_to_open(things.in("made"))),
      HasSubstr("is a folder with a run in it; open " + things.in("made/other.nadir").string()));
  const fs::path large = things.scratch.file("large.toml", std::string(kMostRecipeBytes + 1, '#'));
  EXPECT_THAT(error_text(file_to_open(large)), HasSubstr("is too large for a recipe"));
}

TEST(FileToOpen, TakesOverheadImagesAndLabelsForWhatIsLabelled) {
  const ScratchFolder scratch;
  const auto kind_of = [&](const std::string& name) {
    const auto found = file_to_open(scratch.file(name, "II*"));
    return found ? std::string(enum_name(found->kind)) : found.error().message;
  };
  for (const char* const name : {"aerial.tif", "AERIAL.TIFF", "tiles.mbtiles", "labels.gpkg"}) {
    EXPECT_EQ(kind_of(name), "image") << name;
    EXPECT_EQ(kind_at_a_glance(scratch.path() / name, false), FileKind::kLabels) << name;
  }
  // Of a picture of any kind only a file beside it says that it lies somewhere.
  EXPECT_NE(kind_of("beach.jpg"), "image");
  scratch.file("beach.jgw", "0.1\n0\n0\n-0.1\n0\n0\n");
  EXPECT_EQ(kind_of("beach.jpg"), "image");
}

TEST(FileToOpen, OfAForeignKindSaysWhatItLooksLikeAndWhatCanBeOpened) {
  const ScratchFolder scratch;
  std::string database("SQLite format 3\0", 16);
  database.resize(100, '\0');
  const std::vector<std::pair<fs::path, const char*>> foreign = {
      {scratch.file("beach.jpg", "\xFF\xD8\xFF\xE0 and a beach"), "is a JPEG picture"},
      {scratch.file("beach", "\xFF\xD8\xFF\xE0 without an ending"), "is a JPEG picture"},
      {scratch.file("notes.txt", "Fly at noon.\n"), "is a text whose first line is no pose"},
      {scratch.file("page.html", "\n<!DOCTYPE html>"), "is an XML or HTML text"},
      {scratch.file("data.json", "{}"), "is a JSON text"},
      {scratch.file("drive.bag", "#ROSBAG V2.0\n"), "is a ROS bag"},
      {scratch.file("all.zip", "PK\x03\x04"), "is a ZIP archive"},
      {scratch.file("noise.bin", std::string("\x01\x02\x00\x03", 4)), "is data of a kind"},
      {scratch.file("nothing.txt", ""), "is empty"},
      {scratch.file("poses.db", database), "is an SQLite database, but no run"}};
  for (const auto& [path, looks] : foreign) {
    const auto refused = file_to_open(path);
    ASSERT_FALSE(refused) << path;
    EXPECT_EQ(refused.error().code, ErrorCode::kUnsupported);
    EXPECT_THAT(refused.error().message, testing::StartsWith(path.string() + ": " + looks));
    for (const char* kind : {"runs", "flights", "maps", "figures", "recipes"}) {
      EXPECT_THAT(refused.error().message, HasSubstr(kind)) << path;
    }
  }
}

}  // namespace file_kind_test
}  // namespace nadir
