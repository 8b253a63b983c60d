// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figure_sources.h"

#include <gmock/gmock.h>

#include "core/base/hash.h"
#include "core/base/staged_output.h"
#include "core/map/overhead_map_file.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/run_on_map.h"

namespace nadir {
namespace figure_sources_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Sources : public ::testing::Test {
 protected:
  Sources() { write_street(map()); }
  [[nodiscard]] std::filesystem::path map() const { return scratch_.path() / "map"; }
  std::string drive(const std::string& name, const RunFaults& faults = {}) {
    write_drive(scratch_.path() / name, map(), 10, faults);
    return (scratch_.path() / name).string();
  }
  /// The only remark on a run once it is laid on the map, or the error.
  std::string remark_on(const std::string& run_path) {
    auto run = sources_.run(run_path, {});
    const auto facts = sources_.map(map());
    const auto laid = lay_on_map(*run, map(), *facts);
    if (!laid) return error_text(laid);
    return run->remarks.empty() ? "none" : run->remarks.front();
  }

  ScratchFolder scratch_;
  FigureSources sources_;
};

TEST_F(Sources, HashAFileOfAnySizeAsIfItWereRead) {
  std::string bytes;
  for (int i = 0; i < 200'000; ++i) bytes += static_cast<char>(i % 251);  // more than one chunk
  const auto path = scratch_.file("big", bytes);
  EXPECT_EQ(sources_.file_hash(path, {}).value(), Hash().add(bytes).text());
  EXPECT_EQ(sources_.file_hash(scratch_.file("empty", ""), {}).value(), Hash().text());
  EXPECT_THAT(error_text(sources_.file_hash(scratch_.path() / "none", {})),
              HasSubstr("none: does not exist"));
  EXPECT_EQ(error_code(sources_.file_hash(scratch_.path(), {})), ErrorCode::kIo);
}

TEST_F(Sources, StopWhileTheyHash) {
  std::stop_source stop;
  stop.request_stop();
  const auto hash = sources_.file_hash(scratch_.file("a", "text"), {stop.get_token(), {}});
  ASSERT_FALSE(hash);
  EXPECT_EQ(hash.error().code, ErrorCode::kCancelled);
}

TEST_F(Sources, ReadEachFileOnce) {
  const std::string run = drive("a.nadir");
  const auto hash = sources_.file_hash(run, {});
  ASSERT_TRUE(sources_.run(run, {}) && sources_.map(map()) && hash);
  std::filesystem::remove(run);
  std::filesystem::remove_all(map());
  const auto again = sources_.run(run, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->steps.size(), 10U);
  EXPECT_TRUE(again->reader->step(3).has_value());  // the copy reads the same open file
  EXPECT_TRUE(sources_.map(map()).has_value());
  EXPECT_EQ(sources_.file_hash(run, {}).value(), *hash);
  FigureOptions later;
  later.from_s = 2.0;
  EXPECT_FALSE(sources_.run(run, later).has_value());  // other steps: opened anew
}

TEST_F(Sources, KnowWhereAMapLiesAndWhetherItIsTheSame) {
  const auto facts = sources_.map(map());
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->bounds_in_enu_m.min(), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(facts->bounds_in_enu_m.max(), Eigen::Vector2d(60.0, 40.0));
  EXPECT_EQ(facts->hash, content_hash(read_overhead_map(map()).value()));
}

TEST_F(Sources, RefuseARunOfAnotherPlane) {
  const std::string run = drive("a.nadir", {.plane_latitude_deg = 33.5});
  EXPECT_EQ(remark_on(run), run + ": was localised on another plane than " + map().string() +
                                ": its origin is 33.5, -83.9 and not 33.45, -83.9");
  FigureRecipe recipe;
  recipe.runs = {drive("b.nadir"), run};
  for (const char* figure : {"trajectories", "compare"}) {
    recipe.figure = figure;
    EXPECT_THAT(error_text(make_figure(recipe)), HasSubstr("another plane than"));
  }
  recipe.figure = "cdf";  // no map, so any plane will do
  EXPECT_TRUE(make_figure(recipe).has_value());
  recipe.figure = "labels";  // the run only names its map
  recipe.runs = {run};
  EXPECT_TRUE(make_figure(recipe).has_value());
}

TEST_F(Sources, RemarkOnAMapThatIsNotTheRunsAnyMore) {
  const std::string hash = sources_.map(map())->hash;
  EXPECT_EQ(remark_on(drive("same.nadir", {.map_hash = hash})), "none");
  EXPECT_EQ(remark_on(drive("unknown.nadir")), "none");
  EXPECT_EQ(remark_on(drive("old.nadir", {.map_hash = "00"})), "the map has changed since the run");
  const std::filesystem::path elsewhere = scratch_.path() / "elsewhere";
  write_drive(scratch_.path() / "other.nadir", elsewhere, 10, {.map_hash = "00"});
  EXPECT_EQ(remark_on((scratch_.path() / "other.nadir").string()),
            "drawn on another map than the run's, or a changed one");
}

TEST_F(Sources, RemarkOnARunOutsideTheMap) {
  EXPECT_EQ(remark_on(drive("far.nadir", {.shift_m = 500.0})), "the run lies outside the map");
  EXPECT_EQ(remark_on(drive("edge.nadir", {.shift_m = 45.0})), "none");  // its first steps do not
}

TEST_F(Sources, SayTheRemarksInTheFoot) {
  auto run = sources_.run(drive("a.nadir"), {});
  ASSERT_TRUE(run);
  const std::string before = foot_of(*run);
  run->remarks = {"the map has changed since the run"};
  EXPECT_THAT(foot_of(*run), HasSubstr(" · the map has changed since the run · "));
  EXPECT_GT(foot_of(*run).size(), before.size());
}

TEST_F(Sources, RemarkOnRunsOfDifferentFlights) {
  std::vector<FigureRun> runs;
  for (const auto& [name, flight] : {std::pair("a.nadir", "1"), std::pair("b.nadir", "2")}) {
    runs.push_back(sources_.run(drive(name, {.flight_hash = flight}), {}).value());
  }
  remark_on_flights(std::span(runs).first(1), true);
  EXPECT_THAT(runs[0].remarks, IsEmpty());
  remark_on_flights(runs, true);
  EXPECT_THAT(runs[0].remarks,
              ElementsAre("the runs are of different flights, truth and odometry are those of a"));
  EXPECT_THAT(runs[1].remarks, IsEmpty());
}

TEST_F(Sources, HashTheInputsThatAFigureHas) {
  FigureRecipe recipe;
  recipe.runs = {drive("a.nadir")};
  recipe.figure = "cdf";
  auto hashes = hash_inputs(recipe, sources_, {});
  ASSERT_TRUE(hashes);
  EXPECT_THAT(hashes->runs, ElementsAre(sources_.file_hash(recipe.runs[0], {}).value()));
  EXPECT_EQ(hashes->map, "");
  recipe.figure = "route";
  recipe.route = scratch_.file("r.toml", "x").string();
  hashes = hash_inputs(recipe, sources_, {});
  ASSERT_TRUE(hashes);
  EXPECT_EQ(hashes->map, sources_.map(map())->hash);
  EXPECT_EQ(hashes->route, Hash().add("x").text());
  recipe.route.clear();
  EXPECT_EQ(route_of_recipe(recipe, map()), map() / "routes" / "loop.toml");
}

TEST_F(Sources, HashTheMapsPictureWhereTheFigureShowsIt) {
  FigureRecipe recipe;
  recipe.runs = {drive("a.nadir")};
  const auto picture = [this, &recipe](std::string_view figure) {
    recipe.figure = figure;
    const auto hashes = hash_inputs(recipe, sources_, {});
    return hashes ? hashes->picture : hashes.error().message;
  };
  const std::string bytes = read_text_file(map() / "image.tif").value();
  EXPECT_EQ(picture("trajectories"), Hash().add(bytes).text());
  EXPECT_EQ(picture("overhead-pair"), Hash().add(bytes).text());
  EXPECT_EQ(picture("labels"), "");
  EXPECT_EQ(picture("cdf"), "");
  recipe.options.layers.set(FigureLayer::kPicture, false);
  EXPECT_EQ(picture("trajectories"), "");
}

}  // namespace figure_sources_test
}  // namespace nadir
