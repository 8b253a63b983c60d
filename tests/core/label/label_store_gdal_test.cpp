// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include "core/label/label_store.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/core/label/other_program.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace label_store_gdal_test {

using testing::ElementsAre;
using testing::HasSubstr;

struct Closed {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Closed>;

/// What QGIS opens it with.
class LabelStoreInGdal : public testing::Test {
 protected:
  LabelStoreInGdal() {
    GDALAllRegister();
    auto store = LabelStore::create(path_, test_plane(), test_grid(40, 30), "ada");
    EXPECT_TRUE(store) << error_text(store);
    LabelObject road = area(kRoad, {box(0, 0, 9, 5), box(1, 1, 3, 2)}, 1);
    road.note = "main street";
    EXPECT_TRUE(store->commit(adding({road, area(kTerrain, {box(20, 0, 30, 10)}, 2),
                                      line(kLaneMarking, ring({{0.125, 2.5}, {9, 2.5}}), 0.15, 3),
                                      outline(kBuilding, {box(10, 7, 15, 12)}, 0.3, 4)})));
    EXPECT_TRUE(store->commit(painting(store->document(), {0, 0, 5, 5}, kRoad)));
  }
  [[nodiscard]] Dataset open(unsigned flags = GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR) const {
    const std::array<const char*, 2> drivers{"GPKG", nullptr};
    Dataset dataset(GDALDataset::Open(path_.c_str(), flags, drivers.data()));
    if (dataset == nullptr) throw std::runtime_error(CPLGetLastErrorMsg());
    return dataset;
  }
  ScratchFolder scratch_;
  std::filesystem::path path_ = scratch_.path() / "labels.gpkg";
};

TEST_F(LabelStoreInGdal, HasThreeLayersAndNoJournal) {
  CPLErrorReset();
  const Dataset dataset = open();
  std::vector<std::string> names;
  for (auto* layer : dataset->GetLayers()) names.emplace_back(layer->GetName());
  EXPECT_THAT(names, ElementsAre("area", "line", "outline", "nadir_about"));
  EXPECT_EQ(CPLGetLastErrorType(), CE_None) << CPLGetLastErrorMsg();
  EXPECT_EQ(dataset->GetLayerByName("area")->GetFeatureCount(), 2);
  EXPECT_EQ(dataset->GetLayerByName("area")->GetGeomType(), wkbPolygon);
  EXPECT_EQ(dataset->GetLayerByName("line")->GetGeomType(), wkbLineString);
}

TEST_F(LabelStoreInGdal, HasTheSameCornersHolesAndFields) {
  const Dataset dataset = open();
  const std::unique_ptr<OGRFeature> road(dataset->GetLayerByName("area")->GetFeature(1));
  ASSERT_NE(road, nullptr);
  EXPECT_STREQ(road->GetFieldAsString("class"), "road");
  EXPECT_STREQ(road->GetFieldAsString("note"), "main street");
  const auto* polygon = road->GetGeometryRef()->toPolygon();
  EXPECT_EQ(polygon->getNumInteriorRings(), 1);
  EXPECT_DOUBLE_EQ(polygon->get_Area(), 9.0 * 5.0 - 2.0);
  EXPECT_TRUE(polygon->IsValid());
  const std::unique_ptr<OGRFeature> marking(dataset->GetLayerByName("line")->GetFeature(3));
  EXPECT_EQ(marking->GetFieldAsDouble("width_m"), 0.15);
  EXPECT_EQ(marking->GetGeometryRef()->toLineString()->getX(0), 0.125);
  EXPECT_EQ(marking->GetGeometryRef()->toLineString()->getY(0), -2.5);
  const std::unique_ptr<OGRFeature> house(dataset->GetLayerByName("outline")->GetFeature(4));
  EXPECT_EQ(house->GetFieldAsDouble("thickness_m"), 0.3);
}

TEST_F(LabelStoreInGdal, LiesWhereItLies) {
  const Dataset dataset = open();
  const OGRSpatialReference* plane = dataset->GetLayerByName("area")->GetSpatialRef();
  ASSERT_NE(plane, nullptr);
  OGRSpatialReference source = *plane;
  source.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRSpatialReference wgs84;
  wgs84.SetWellKnownGeogCS("WGS84");
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> to_wgs84(
      OGRCreateCoordinateTransformation(&source, &wgs84));
  double x = 1234.5;
  double y = -678.9;
  ASSERT_TRUE(to_wgs84->Transform(1, &x, &y));
  const Geodetic expected = test_plane().geodetic_from_enu({1234.5, -678.9});
  EXPECT_NEAR(x, expected.longitude_deg, 1e-10);
  EXPECT_NEAR(y, expected.latitude_deg, 1e-10);
  OGREnvelope extent;
  ASSERT_EQ(dataset->GetLayerByName("area")->GetExtent(&extent, FALSE), OGRERR_NONE);
  EXPECT_EQ(extent.MaxX, 30.0);
  EXPECT_EQ(extent.MinY, -10.0);
}

TEST_F(LabelStoreInGdal, MayBeChangedThereAndTheChangeIsAStep) {
  {
    const Dataset dataset = open(GDAL_OF_VECTOR | GDAL_OF_UPDATE);
    auto* layer = dataset->GetLayerByName("line");
    const std::unique_ptr<OGRFeature> feature(OGRFeature::CreateFeature(layer->GetLayerDefn()));
    OGRLineString line;
    line.addPoint(1.0, 1.0);
    line.addPoint(5.0, 3.0);
    feature->SetGeometry(&line);
    feature->SetField("class", "curb");
    feature->SetField("width_m", 0.2);
    ASSERT_EQ(layer->CreateFeature(feature.get()), OGRERR_NONE);
    EXPECT_GT(feature->GetFID(), 4);  // No number that an object of any layer has.
  }
  auto store = LabelStore::open(path_, "ada");
  ASSERT_TRUE(store) << error_text(store);
  EXPECT_EQ(store->document().objects().size(), 5U);
  EXPECT_EQ(store->undo_step()->title, "Take over changes of another program");
  EXPECT_TRUE(store->commit(adding({line(kCurb, ring({{0, 0}, {1, 1}}), 1.0, 9)})));
}

TEST_F(LabelStoreInGdal, CanBeIndexedThereAndIsStillWritten) {
  {
    const Dataset dataset = open(GDAL_OF_VECTOR | GDAL_OF_UPDATE);
    OGRLayer* none =
        dataset->ExecuteSQL("SELECT CreateSpatialIndex('area', 'geom')", nullptr, nullptr);
    if (none != nullptr) dataset->ReleaseResultSet(none);
  }
  ASSERT_EQ(OtherProgram(path_).value(
                "SELECT count(*) FROM sqlite_schema WHERE name = 'rtree_area_geom'"),
            "1");
  {
    auto store = LabelStore::open(path_, "ada");
    ASSERT_TRUE(store) << error_text(store);
    const auto done = store->commit(adding({area(kRoad, {box(100, 100, 101, 102)}, 7)}));
    ASSERT_TRUE(done) << error_text(done);
  }
  const Dataset dataset = open();
  auto* layer = dataset->GetLayerByName("area");
  layer->SetSpatialFilterRect(99.0, -103.0, 102.0, -99.0);
  EXPECT_EQ(layer->GetFeatureCount(), 1);
}

TEST_F(LabelStoreInGdal, IsAGeoPackageByItsHeader) {
  const OtherProgram other(path_);
  EXPECT_EQ(other.value("PRAGMA application_id"), std::to_string(0x47504B47));
  EXPECT_EQ(other.value("PRAGMA user_version"), "10300");
  EXPECT_EQ(other.value("PRAGMA foreign_key_check"), "");
  EXPECT_THAT(other.value("SELECT definition FROM gpkg_spatial_ref_sys WHERE srs_id = 100000"),
              HasSubstr("Nadir project plane"));
}

}  // namespace label_store_gdal_test
}  // namespace nadir
