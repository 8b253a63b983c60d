// SPDX-License-Identifier: Apache-2.0
// What is opened by what somebody names, when a file is made, and who else is there.
#include <unistd.h>

#include "core/desk/label_place.h"
#include "tests/core/desk/desk_at_work.h"
#include "tests/core/label/other_program.h"
#include "tests/core/map/raster_files.h"

namespace nadir {
namespace label_desk_open_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> titles(const LabelDesk& desk) {
  std::vector<std::string> all;
  const auto steps = desk.sheet().history(1, 100);
  for (const LabelStep& step : *steps) all.push_back(step.title);
  return all;
}

TEST(LabelDeskOpen, LookingAtAPackageWritesNothing) {
  const ScratchFolder scratch;
  const fs::path package = half_a_road(scratch.path());
  {
    const LabelDesk desk = opened_desk(package);
    EXPECT_EQ(desk.sheet().path(), package / "labels.gpkg");
    EXPECT_FALSE(desk.sheet().is_on_disk());
    EXPECT_EQ(desk.under({10.5, -10.5}).class_id, kRoad);
    EXPECT_EQ(desk.under({200.5, -10.5}).class_id, kUnclassified);
    EXPECT_FALSE(desk.undo_title());
    EXPECT_THAT(titles(desk), IsEmpty());
  }
  EXPECT_FALSE(fs::exists(package / "labels.gpkg"));
}

TEST(LabelDeskOpen, TheWayToAStepShowsWhatWasWithoutGoingThere) {
  const ScratchFolder scratch;
  LabelDesk desk = opened_desk(half_a_road(scratch.path()));
  const LabelSheet& sheet = desk.sheet();
  EXPECT_TRUE(sheet.way(sheet.now(), 0, 0)->empty()) << "there is no file yet";
  EXPECT_FALSE(sheet.way(sheet.now(), 0, 1));
  const LabelDocument first = sheet.now();
  ASSERT_THAT(desk.stroke({{250.5, -50.5}}, 3.0, kTerrain), Succeeds());
  const LabelDocument second = sheet.now();
  const auto way = sheet.way(second, 2, 1);
  ASSERT_TRUE(way) << error_text(way);
  LabelDocument shown = second;
  for (const LabelEdit& edit : *way) shown.apply(edit);
  EXPECT_TRUE(shown == first);
  EXPECT_EQ(sheet.step(), 2);
  EXPECT_TRUE(sheet.now() == second);
}

TEST(LabelDeskOpen, TheFirstEditMakesTheFileAndTakesTheLabelsOver) {
  const ScratchFolder scratch;
  const fs::path package = half_a_road(scratch.path());
  const Raster<ClassId> labels = read_overhead_map(package)->labels;
  {
    LabelDesk desk = opened_desk(package);
    EXPECT_EQ(rasterise(desk.sheet().now()), labels);
    ASSERT_THAT(desk.stroke({{250.5, -50.5}}, 3.0, kTerrain), Succeeds());
    EXPECT_TRUE(desk.sheet().is_on_disk());
    EXPECT_TRUE(fs::exists(package / "labels.gpkg"));
    EXPECT_THAT(titles(desk), ElementsAre("Take over labels.tif", "Paint terrain"));
    ASSERT_THAT(desk.undo(), Succeeds());
    EXPECT_EQ(rasterise(desk.sheet().now()), labels);
  }
  const LabelDesk again = opened_desk(package);
  EXPECT_EQ(rasterise(again.sheet().now()), labels);
  EXPECT_EQ(again.undo_title(), "Take over labels.tif");
  EXPECT_EQ(again.redo_title(), "Paint terrain");
}

TEST(LabelDeskOpen, AnEditThatIsRefusedMakesNoFile) {
  const ScratchFolder scratch;
  const fs::path package = half_a_road(scratch.path());
  LabelDesk desk = opened_desk(package);
  const std::int64_t revision = desk.sheet().revision();
  EXPECT_FALSE(desk.draw({ObjectKind::kArea, kRoad, 0.0}, ring({{1, 1}, {2, 2}})));
  EXPECT_FALSE(desk.sheet().is_on_disk());
  EXPECT_FALSE(fs::exists(package / "labels.gpkg"));
  EXPECT_EQ(desk.sheet().revision(), revision);
}

TEST(LabelDeskOpen, APictureInAPackageMeansThePackage) {
  const ScratchFolder scratch;
  const fs::path package = half_a_road(scratch.path(), true);
  const LabelDesk desk = opened_desk(package / "image.tif");
  EXPECT_EQ(desk.sheet().path(), package / "labels.gpkg");
  EXPECT_EQ(desk.sheet().image(), package / "image.tif");
}

TEST(LabelDeskOpen, APackageWithAPictureAloneBeginsEmpty) {
  const ScratchFolder scratch;
  const fs::path package = half_a_road(scratch.path(), true);
  fs::remove(package / "labels.tif");
  const LabelDesk desk = opened_desk(package);
  EXPECT_EQ(desk.sheet().now().grid(), test_grid(300, 200));
  EXPECT_THAT(desk.sheet().now().paint(), IsEmpty());
}

TEST(LabelDeskOpen, AnImageGetsItsLabelsBesideItOnItsOwnCells) {
  const ScratchFolder scratch;
  const fs::path package = half_a_road(scratch.path(), true);
  const fs::path image = scratch.path() / "from above.tif";
  fs::copy_file(package / "image.tif", image);
  LabelDesk desk = opened_desk(image);
  EXPECT_EQ(desk.sheet().path(), scratch.path() / "from above.labels.gpkg");
  EXPECT_EQ(desk.sheet().now().grid(), test_grid(300, 200));
  ASSERT_THAT(desk.draw({ObjectKind::kArea, kRoad, 0.0}, box(10, 10, 20, 20)), Succeeds());
  EXPECT_THAT(titles(desk), ElementsAre(HasSubstr("road")));
  EXPECT_TRUE(fs::exists(scratch.path() / "from above.labels.gpkg"));
}

TEST(LabelDeskOpen, LabelsNamedAloneFindTheImageBesideThem) {
  const ScratchFolder scratch;
  const fs::path package = half_a_road(scratch.path(), true);
  const fs::path labels = scratch.path() / "from.above.labels.gpkg";
  const fs::path plain = scratch.path() / "from.above.gpkg";
  for (const fs::path& path : {labels, plain}) {
    ASSERT_TRUE(LabelStore::create(path, test_plane(), test_grid(300, 200), "ada"));
  }
  EXPECT_EQ(find_label_place(labels)->image, "");
  for (const char* const ending : {".mbtiles", ".jpeg", ".JPG", ".png", ".tif"}) {
    const fs::path image = scratch.file(std::string("from.above") + ending, "");
    EXPECT_EQ(find_label_place(labels)->image, image) << "before those of lesser formats";
  }
  EXPECT_EQ(find_label_place(plain)->image, "") << "is the document of nothing";
  fs::copy_file(package / "image.tif", scratch.path() / "from.above.tif",
                fs::copy_options::overwrite_existing);
  EXPECT_EQ(opened_desk(labels).sheet().image(), scratch.path() / "from.above.tif");
}

TEST(LabelDeskOpen, AnImageInAnotherReferenceSystemLiesOnAPlaneOfItsOwn) {
  const ScratchFolder scratch;
  RasterFile file{.ids = patchwork(60, 45), .crs = "EPSG:32617"};
  Affine2 crs_from_pixel;
  crs_from_pixel.linear << 0.5, 0.0, 0.0, -0.5;
  crs_from_pixel.offset = {230000.0, 3705000.0};
  file.crs_from_pixel = crs_from_pixel;
  const fs::path image = scratch.path() / "photo.tif";
  write_raster(file, image);
  const LabelDesk desk = opened_desk(image);
  const LabelDocument& document = desk.sheet().now();
  // The image's own corner, by way of latitude and longitude, is the corner of the grid but for its slight turn.
  const Eigen::Vector2d lon_lat = lon_lat_from_crs("EPSG:32617", crs_from_pixel.offset);
  const Eigen::Vector2d corner = document.plane().enu_from_geodetic({lon_lat.y(), lon_lat.x()});
  EXPECT_NEAR((document.grid().top_left_in_enu_m - corner).norm(), 0.0, 1.5);
  EXPECT_NEAR(document.grid().metres_per_cell, 0.5, 1e-3);
}

TEST(LabelDeskOpen, WhatHasNoPlaceIsRefusedUnlessSomebodySaysIt) {
  const ScratchFolder scratch;
  const fs::path image = scratch.path() / "photo.png";
  write_raster({.ids = patchwork(20, 20), .driver = "PNG"}, image);
  EXPECT_THAT(error_text(LabelDesk::open(image, "ada")), HasSubstr("has no georeference"));
  Affine2 enu_from_pixels;
  enu_from_pixels.linear << 0.5, 0.0, 0.0, -0.5;
  enu_from_pixels.offset = {-5.0, 5.0};
  const LabelOpening by_hand{.image = {.plane = test_plane(), .enu_from_pixels = enu_from_pixels}};
  const LabelDesk desk = opened_desk(image, "ada", by_hand);
  EXPECT_EQ(desk.sheet().now().grid(), (LabelGrid{0.5, {-5.0, 5.0}, 20, 20}));
  EXPECT_THAT(error_text(LabelDesk::open(scratch.path() / "none.gpkg", "ada")),
              HasSubstr("no such file"));
  EXPECT_THAT(error_text(LabelDesk::open(scratch.file("words.txt", "hello"), "ada")),
              HasSubstr("words.txt"));
  fs::create_directory(scratch.path() / "empty");
  EXPECT_THAT(error_text(LabelDesk::open(scratch.path() / "empty", "ada")), HasSubstr("empty"));
}

TEST(LabelDeskOpen, ForReadingAloneRefusesEditsInASentence) {
  const ScratchFolder scratch;
  const fs::path package = half_a_road(scratch.path());
  LabelDesk desk = opened_desk(package, "ada", {.access = LabelAccess::kRead});
  const auto refused = desk.stroke({{10.0, -10.0}}, 3.0, kTerrain);
  EXPECT_THAT(error_text(refused), HasSubstr("was opened for reading"));
  EXPECT_FALSE(fs::exists(package / "labels.gpkg"));
}

TEST(LabelDeskOpen, AFolderThatCannotBeWrittenIsToldBeforeAnybodyDraws) {
  if (::geteuid() == 0) GTEST_SKIP() << "root writes everywhere";
  const ScratchFolder scratch;
  const fs::path package = half_a_road(scratch.path());
  fs::permissions(package, fs::perms::owner_read | fs::perms::owner_exec);
  const LabelDesk desk = opened_desk(package);
  EXPECT_THAT(desk.sheet().why_read_only(), HasSubstr("cannot be made"));
  fs::permissions(package, fs::perms::owner_all);
}

TEST_F(DeskAtWork, TheSecondProgramReadsFollowsAndMayGoOn) {
  LabelDesk reader = opened_desk(path(), "bob");
  EXPECT_THAT(reader.sheet().why_read_only(), HasSubstr("ada"));
  EXPECT_FALSE(reader.undo_title());
  EXPECT_THAT(*reader.poll(), IsEmpty());
  drawn_box(10, 10, 20, 20);
  ASSERT_THAT(desk.stroke({{50.5, -50.5}}, 3.0, kTerrain), Succeeds());
  const std::int64_t revision = reader.sheet().revision();
  EXPECT_THAT(*reader.poll(), ElementsAre(HasSubstr("another program has changed it")));
  EXPECT_TRUE(reader.sheet().now() == now());
  EXPECT_FALSE(reader.sheet().changed_since(revision).empty());
  EXPECT_THAT(error_text(reader.stroke({{1.0, -1.0}}, 3.0, kRoad)), HasSubstr("ada"));
  desk = opened_desk(half_a_road(scratch.path()));  // Ada turns to something else.
  EXPECT_THAT(*reader.poll(), testing::Contains(HasSubstr("can be edited now")));
  EXPECT_THAT(reader.stroke({{1.0, -1.0}}, 3.0, kRoad), Succeeds());
  EXPECT_THAT(*reader.poll(), IsEmpty());
}

TEST_F(DeskAtWork, WhatAnotherProgramWritesIsTakenOverAndCanBeUndone) {
  const ObjectId object = drawn_box(10, 10, 20, 20);
  const LabelDocument before = now();
  OtherProgram(path()).run("UPDATE area SET class = 'terrain'");
  EXPECT_THAT(*desk.poll(), ElementsAre(HasSubstr("took over 1 object that")));
  EXPECT_EQ(now().object(object)->class_id, kTerrain);
  EXPECT_THAT(*desk.poll(), IsEmpty());
  EXPECT_THAT(desk.selection().ids(), ElementsAre(object));
  ASSERT_THAT(desk.undo(), Succeeds());
  EXPECT_TRUE(now() == before);
}

TEST(LabelDeskOpen, AFileThatAnotherProgramHasMadeMeanwhileIsOpened) {
  const ScratchFolder scratch;
  const fs::path package = half_a_road(scratch.path());
  LabelDesk late = opened_desk(package, "bob");
  {
    LabelDesk early = opened_desk(package, "ada");
    ASSERT_THAT(early.stroke({{250.5, -50.5}}, 3.0, kTerrain), Succeeds());
    EXPECT_THAT(error_text(late.stroke({{9.0, -9.0}}, 3.0, kTerrain)), HasSubstr("there already"));
    EXPECT_TRUE(fs::exists(package / "labels.gpkg"));
  }
  EXPECT_THAT(*late.poll(), testing::Contains(HasSubstr("made by another program")));
  EXPECT_EQ(late.under({250.5, -50.5}).class_id, kTerrain);
  EXPECT_THAT(late.stroke({{9.0, -9.0}}, 3.0, kTerrain), Succeeds());
}

TEST(LabelPlace, PaintOfCellsGivesTheCellsAgain) {
  Raster<ClassId> cells(700, 300, kUnclassified);
  for (int i = 0; i < 300; ++i) {
    cells.at(i * 2, i) = kRoad;
    cells.at(699 - i, i) = kPole;
  }
  LabelDocument document = test_document(700, 300);
  document.apply(paint_of_cells(document, cells));
  EXPECT_EQ(rasterise(document), cells);
  EXPECT_TRUE(paint_of_cells(document, Raster<ClassId>(700, 300, kUnclassified)).empty());
}

}  // namespace label_desk_open_test
}  // namespace nadir
