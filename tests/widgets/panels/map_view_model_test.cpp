// SPDX-License-Identifier: Apache-2.0
// Which runs the map shows together.
#include <gmock/gmock.h>

#include "tests/core/session/session_fixture.h"
#include "widgets/panels/map_view.h"
#include "widgets/panels/status_bar.h"

namespace nadir {
namespace map_view_model_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class MapViewModelTest : public SessionTest {
 protected:
  /// A run with the header of the small world's, changed, and its steps.
  std::string run_with(const std::string& name,
                       const std::function<void(RunHeader& header)>& change) {
    const auto source = RunReader::open(run_);
    EXPECT_TRUE(source) << error_text(source);
    RunHeader header = source->header();
    change(header);
    const std::filesystem::path file = scratch_.path() / name;
    auto writer = RunWriter::create(file, header);
    EXPECT_TRUE(writer) << error_text(writer);
    const auto steps = source->steps();
    EXPECT_TRUE(writer->copy_steps(run_, *steps));
    EXPECT_TRUE(writer->finish());
    return file.string();
  }
  void open(const std::string& file) {
    act("open \"" + file + "\"");
    settle();
  }
  [[nodiscard]] std::vector<int> numbers() const {
    std::vector<int> all;
    for (const MapRun& run : map_view_model(*session_).runs) all.push_back(run.number);
    return all;
  }
};

TEST_F(MapViewModelTest, RunsOfOneMapAreDrawnTogetherTheActiveOneOnTop) {
  open_run();
  open(copy_run("second.nadir").string());
  EXPECT_THAT(numbers(), ElementsAre(1, 2));
  act("run 1");
  EXPECT_THAT(numbers(), ElementsAre(2, 1));
  EXPECT_THAT(map_view_model(*session_).apart, IsEmpty());
}

TEST_F(MapViewModelTest, OfARunThatIsBegunBesideAnotherSaysThatItComes) {
  open_run();
  ask_for_a_slow_run(*session_);
  act("rerun start");
  const MapViewModel model = map_view_model(*session_);
  EXPECT_EQ(model.coming, "loop-2");
  EXPECT_EQ(model.reading, "") << "it is made and not read";
  EXPECT_FALSE(model.work) << "there is something else to see";
  poll_until(*session_, [&] { return session_->view().active_run == 2; });
  EXPECT_EQ(map_view_model(*session_).coming, "");
  act("cancel");
  settle();
}

TEST_F(MapViewModelTest, OfAFirstRunShowsHowFarItIs) {
  act(SessionTest::open(SmallWorld::get().flight));
  act(SessionTest::open(SmallWorld::get().map));
  settle();
  ask_for_a_slow_run(*session_);
  act("rerun flight");
  const MapViewModel model = map_view_model(*session_);
  ASSERT_TRUE(model.work);
  EXPECT_THAT(model.work->title, HasSubstr("localising"));
  poll_until(*session_, [&] { return session_->active_run()->document != nullptr; });
  EXPECT_FALSE(map_view_model(*session_).work) << "then it is seen";
  act("cancel");
  settle();
}

TEST_F(MapViewModelTest, ARunOfAnotherPlaceIsSetApart) {
  const std::string harbour = run_with("harbour.nadir", [](RunHeader& header) {
    header.plane_latitude_deg += 1.0;
    header.map = "port";
    header.map_hash = "0123";
    header.map_path = "/nowhere/port";
  });
  open_run();
  open(harbour);
  act("run 1");
  settle();
  EXPECT_THAT(numbers(), ElementsAre(1));
  const MapViewModel model = map_view_model(*session_);
  ASSERT_THAT(model.apart, SizeIs(1));
  EXPECT_EQ(model.apart[0].number, 2);
  EXPECT_EQ(model.apart[0].name, "harbour");
  EXPECT_EQ(model.apart[0].map, "port");
  EXPECT_FALSE(model.is_map_foreign);
  EXPECT_NE(model.step, nullptr);
}

TEST_F(MapViewModelTest, OnAMapOfAnotherPlaceNoRunIsDrawnWhereItWasNot) {
  const std::string harbour = run_with("harbour.nadir", [](RunHeader& header) {
    header.plane_latitude_deg += 1.0;
    header.map = "port";
    header.map_hash = "0123";
    header.map_path = "/nowhere/port";
  });
  open(SmallWorld::get().map.string());
  open(harbour);
  const MapViewModel model = map_view_model(*session_);
  EXPECT_TRUE(model.is_map_foreign);
  EXPECT_THAT(model.runs, IsEmpty());
  ASSERT_THAT(model.apart, SizeIs(1));
  EXPECT_EQ(model.step, nullptr) << "its particles are not drawn either";
  // What is fitted is the map, for the flight is not on it.
  act("fit flight");
  EXPECT_LT((session_->view().map.centre_in_enu_m - Eigen::Vector2d(40.0, 30.0)).norm(), 1e-9);
}

TEST_F(MapViewModelTest, AMapThatWasLabelledAgainIsStillTheGroundOfBoth) {
  const std::string again = run_with("again.nadir", [](RunHeader& header) {
    header.map = "street by hand";
    header.map_hash = "0123";
  });
  open_run();
  open(again);
  EXPECT_THAT(numbers(), ElementsAre(1, 2));
}

TEST_F(MapViewModelTest, WithoutItsMapARunIsThereAndTheStatusSaysSo) {
  open(run_with("alone.nadir", [](RunHeader& header) { header.map_path = "/nowhere/none"; }));
  ASSERT_EQ(session_->map(), nullptr);
  EXPECT_THAT(numbers(), ElementsAre(1));
  const MapViewModel model = map_view_model(*session_);
  EXPECT_TRUE(model.plane) << "coordinates are those of the run";
  EXPECT_THAT(status_bar_model(*session_, {}).hint,
              HasSubstr("alone is open, but no map: open one to see the ground"));
  const auto place = status_bar_model(*session_, Eigen::Vector2d(12.0, 34.0)).place;
  ASSERT_TRUE(place);
  EXPECT_EQ(place->class_name, "no map is open");
  EXPECT_EQ(place->east_m, 12.0);
  EXPECT_EQ(place->geodetic, geodetic_text(model.plane->geodetic_from_enu({12.0, 34.0})));
}

}  // namespace map_view_model_test
}  // namespace nadir
