// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <cmath>

#include "core/exchange/label_export.h"
#include "core/label/label_raster.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace export_check_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ExportCheckTest : public testing::Test {
 protected:
  /// A block of streets: 90 x 70 m in cells of 0.2 m.
  static LabelDocument town() {
    LabelDocument document(test_plane(), {0.2, {0.0, 0.0}, 450, 350});
    document.apply(adding({area(kTerrain, {box(1, 1, 89, 69)}, 1),
                           area(kVegetation, {ring({{5, 6}, {40, 3}, {43, 28}, {8, 31}})}, 2),
                           line(kRoad, ring({{0, 40}, {90, 47.3}}), 6.5, 3)}));
    return document;
  }
  [[nodiscard]] fs::path written(const LabelDocument& document) const {
    const fs::path package = folder.path() / "town";
    const auto done = export_labels(document, document.grid(), {.name = "town"},
                                    LabelFormat::kMapPackage, package);
    EXPECT_TRUE(done) << error_text(done);
    return package;
  }
  /// Changes the labels of a package behind everybody's back.
  static void spoil(const fs::path& package, const std::function<void(GDALDataset&)>& how) {
    const std::unique_ptr<GDALDataset> dataset(
        GDALDataset::Open((package / "labels.tif").c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE));
    ASSERT_NE(dataset, nullptr);
    how(*dataset);
  }
  static void put(GDALRasterBand& band, int column, int row, std::uint8_t id) {
    ASSERT_EQ(band.RasterIO(GF_Write, column, row, 1, 1, &id, 1, 1, GDT_Byte, 0, 0, nullptr),
              CE_None);
  }
  [[nodiscard]] static std::vector<std::string> faults(const LabelDocument& document,
                                                       const fs::path& package) {
    const auto check = check_export(document, package);
    EXPECT_TRUE(check) << error_text(check);
    return check ? check->faults : std::vector<std::string>{error_text(check)};
  }

  ScratchFolder folder;
};

TEST_F(ExportCheckTest, FindsNothingInWhatWasJustWritten) {
  const auto check = check_export(town(), written(town()));
  ASSERT_TRUE(check) << error_text(check);
  EXPECT_THAT(check->faults, IsEmpty());
  EXPECT_THAT(check->notices, IsEmpty());
  ASSERT_EQ(check->areas.size(), 3U);
  for (const ClassArea& area : check->areas) {
    EXPECT_NEAR(area.exported_m2, area.drawn_m2, 0.001 * area.drawn_m2) << class_info(area.id).name;
  }
  const double length_m = std::hypot(90.0, 7.3);
  EXPECT_NEAR(check->areas[0].drawn_m2, length_m * 6.5, 0.005 * length_m * 6.5) << "road";
  EXPECT_NEAR(check->areas[1].drawn_m2, 35.0 * 25.0 + 3.0 * 3.0, 0.5) << "vegetation";
}

TEST_F(ExportCheckTest, CountsCellsThatAreNotAsDrawn) {
  const fs::path package = written(town());
  spoil(package, [](GDALDataset& labels) { put(*labels.GetRasterBand(1), 7, 9, kBuilding); });
  EXPECT_THAT(faults(town(), package),
              testing::Contains(HasSubstr("1 of 157500 cells are not as they are drawn")));
}

TEST_F(ExportCheckTest, FindsAClassInAnOverviewThatNobodyDrew) {
  const fs::path package = written(town());
  spoil(package, [](GDALDataset& labels) {
    ASSERT_GE(labels.GetRasterBand(1)->GetOverviewCount(), 1);
    put(*labels.GetRasterBand(1)->GetOverview(0), 3, 3, kPole);
    put(*labels.GetRasterBand(1)->GetOverview(0), 4, 3, 99);
  });
  EXPECT_THAT(faults(town(), package),
              ElementsAre(HasSubstr("its overview of 225 x 175 holds pole, which nobody drew"),
                          HasSubstr("holds 99, which is no class")));
}

TEST_F(ExportCheckTest, FindsAShiftOfAThousandthOfACell) {
  const fs::path package = written(town());
  spoil(package, [](GDALDataset& labels) {
    std::array<double, 6> transform{0.0002, 0.2, 0.0, 0.0, 0.0, -0.2};
    ASSERT_EQ(labels.SetGeoTransform(transform.data()), CE_None);
  });
  EXPECT_THAT(faults(town(), package),
              ElementsAre(HasSubstr("a corner is 0.001 cells from where its document has it")));
}

TEST_F(ExportCheckTest, FindsAnotherPaletteAndAnotherPlane) {
  const fs::path package = written(town());
  spoil(package, [](GDALDataset& labels) {
    GDALColorTable table(*labels.GetRasterBand(1)->GetColorTable());
    const GDALColorEntry red{255, 0, 0, 255};
    table.SetColorEntry(kRoad, &red);
    ASSERT_EQ(labels.GetRasterBand(1)->SetColorTable(&table), CE_None);
  });
  EXPECT_THAT(faults(town(), package), ElementsAre(HasSubstr("its palette has no road")));
  const LabelDocument elsewhere(ProjectPlane::create({10.0, 20.0}).value(), town().grid());
  EXPECT_THAT(faults(elsewhere, package), ElementsAre(HasSubstr("lies on another plane")));
}

TEST_F(ExportCheckTest, FindsThatTheDocumentWentOn) {
  const fs::path package = written(town());
  LabelDocument later = town();
  later.apply(adding({area(kBuilding, {box(60, 55, 66, 60)}, 9)}));
  EXPECT_THAT(
      faults(later, package),
      testing::AllOf(testing::Contains(HasSubstr("750 of 157500 cells are not as")),
                     testing::Contains(HasSubstr("building covers 0.0 m2, its objects 30.0"))));
}

TEST_F(ExportCheckTest, TellsWhichClassesAreTooThinForTheCells) {
  LabelDocument document(test_plane(), {0.5, {0.0, 0.0}, 100, 100});
  document.apply(adding({line(kCurb, ring({{3, 3}, {47, 31}}), 0.15, 1)}));
  const auto check = check_export(document, written(document));
  ASSERT_TRUE(check) << error_text(check);
  EXPECT_THAT(check->faults, IsEmpty());
  EXPECT_THAT(check->notices, ElementsAre(HasSubstr("cells of 0.5 m are coarse for it")));
}

TEST_F(ExportCheckTest, ReadsAPackageOfAnotherResolution) {
  const LabelDocument document = town();
  const fs::path package = folder.path() / "fine";
  ASSERT_TRUE(export_labels(document, export_grid(document, 0.15), {.name = "fine"},
                            LabelFormat::kMapPackage, package));
  EXPECT_THAT(faults(document, package), IsEmpty());
}

TEST_F(ExportCheckTest, RefusesWhatIsNoPackage) {
  EXPECT_THAT(error_text(check_export(town(), folder.path() / "none")),
              HasSubstr("none: no such map package"));
}

}  // namespace export_check_test
}  // namespace nadir
