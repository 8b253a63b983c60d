// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "core/base/staged_output.h"
#include "core/flight/flight_writer.h"
#include "core/map/overhead_map_file.h"
#include "core/run/run_file.h"
#include "tests/app/short_flight.h"

namespace nadir {
namespace localise_command_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

class LocaliseCommand : public ShortFlight {};

TEST_F(LocaliseCommand, PrintsTheTableAndWritesARunThatEvaluatesToTheSameJson) {
  const auto localised = run_program(localise({"--out", path("run.nadir"), "--json"}));
  ASSERT_EQ(localised.status, 0) << localised.err;
  const auto evaluated = run_program({"evaluate", path("run.nadir"), "--json"});
  EXPECT_EQ(evaluated.status, 0);
  EXPECT_EQ(evaluated.out, localised.out);
  const auto json = nlohmann::json::parse(localised.out)["runs"][0];
  EXPECT_EQ(json["preset"], "default");
  EXPECT_EQ(json["alignment"], "none");
  EXPECT_GT(json["matched_pairs"], 50);
  EXPECT_LT(json["estimate"]["position_rmse_m"], json["odometry"]["position_rmse_m"]);
  EXPECT_LT(json["estimate"]["position_rmse_m"], 2.0);
  const auto table = run_program({"evaluate", path("run.nadir")});
  EXPECT_THAT(table.out, AllOf(HasSubstr("crossing"), HasSubstr("alignment"), HasSubstr("pairs")));
}

TEST_F(LocaliseCommand, GivesTheSameJsonOnOneAndOnTwoThreads) {
  const auto one = run_program(localise({"--json", "--threads", "1"}));
  const auto two = run_program(localise({"--json", "--threads", "2"}));
  EXPECT_EQ(one.status, 0);
  EXPECT_EQ(one.out, two.out);
  EXPECT_NE(run_program(localise({"--json", "--seed", "2"})).out, one.out);
}

TEST_F(LocaliseCommand, MakesTheSameFlightOnOneAndOnTwoThreads) {
  for (const char* threads : {"1", "2"}) {
    ASSERT_EQ(run_program({"simulate", path("map"), "--route", path("route.toml"), "--out",
                           path(std::string("flight-") + threads), "--image-width", "64",
                           "--image-height", "48", "--frame-rate", "1", "--threads", threads})
                  .status,
              0);
  }
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(path("flight-1"))) {
    if (!entry.is_regular_file()) continue;
    const auto other = path("flight-2") / fs::relative(entry.path(), path("flight-1"));
    EXPECT_EQ(read_text_file(entry.path()).value(), read_text_file(other).value()) << other;
    ++files;
  }
  EXPECT_GT(files, 20);
}

TEST_F(LocaliseCommand, TakesARecipeAndLetsFlagsWin) {
  scratch_->file("recipe.toml", "preset = \"thesis\"\n[options]\nparticles = 500\nmin-votes = 2\n");
  ASSERT_EQ(run_program(localise({"--recipe", path("recipe.toml"), "--particles", "700", "--out",
                                  path("recipe.nadir")}))
                .status,
            0);
  const auto run = RunReader::open(path("recipe.nadir")).value();
  EXPECT_EQ(run.header().preset, "thesis");
  EXPECT_EQ(run.header().options.at("particles"), "700");
  EXPECT_EQ(run.header().options.at("min-votes"), "2");
  EXPECT_EQ(run.header().options.at("likelihood"), "thesis");
}

TEST_F(LocaliseCommand, RunsEveryPreset) {
  for (const char* preset : {"thesis", "thesis-literal-alpha", "thesis-hard"}) {
    const auto run = run_program(localise({"--preset", preset, "--particles", "300", "--json"}));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(nlohmann::json::parse(run.out)["runs"][0]["preset"], preset);
  }
}

TEST_F(LocaliseCommand, SaysWhereTheFlightEnds) {
  const auto localised = run_program(localise({}));
  EXPECT_THAT(localised.out,
              AllOf(HasSubstr("ends at "), HasSubstr("standard deviations"), HasSubstr(" N ")));
}

TEST_F(LocaliseCommand, StartsWhereItIsToldOrAnywhere) {
  const auto given =
      run_program(localise({"--prior", "8,28,0", "--prior-sigma", "1,10", "--json"}));
  EXPECT_EQ(given.status, 0) << given.err;
  const auto global =
      run_program(localise({"--global", "--particles", "20000", "--frames", "8", "--json"}));
  EXPECT_EQ(global.status, 0) << global.err;
}

TEST_F(LocaliseCommand, RefusesValuesThatMakeNoSense) {
  expect_refused(localise({"--particles", "0"}), "--particles: 0 is not in [1, 1000000]", 1);
  expect_refused(localise({"--particles", "1000000000"}), "--particles", 1);
  expect_refused(localise({"--temperature", "nan"}), "--temperature", 1);
  expect_refused(localise({"--frames", "-2"}), "--frames: '-2' is not a whole number from 1 on", 1);
  expect_refused(localise({"--preset", "thesys"}), "did you mean thesis?", 1);
  expect_refused(localise({"--prior", "1,nan,2"}), "--prior: '1,nan,2' is not 3 numbers", 1);
  expect_refused(localise({"--prior", "8,28,0", "--prior-sigma", "1,-1"}),
                 "--prior-sigma: '1,-1' holds a negative deviation", 1);
  EXPECT_EQ(run_program(localise({"--particles", "50", "--frames", "3"})).status, 0);
}

TEST_F(LocaliseCommand, FailsWhereARecipeOrTheMapSaysNoToTheSame) {
  scratch_->file("none.toml", "[options]\nparticles = 0\n");
  scratch_->file("thesys.toml", "preset = \"thesys\"\n");
  expect_refused(localise({"--recipe", path("none.toml")}), "none.toml: --particles: 0 is not in");
  expect_refused(localise({"--recipe", path("thesys.toml")}), "thesys.toml: ");
  expect_refused(localise({"--prior", "-500,0,0", "--out", path("refused.nadir")}),
                 "--prior: -500.0 m east, 0.0 m north is off map 'crossing'");
}

TEST_F(LocaliseCommand, RefusesAMissingMapOrFlightByName) {
  expect_refused({"localise", path("flight"), "--map", path("no-map")}, "--map: " + path("no-map"));
  expect_refused({"localise", path("no-flight"), "--map", path("map")}, "no-flight");
}

TEST_F(LocaliseCommand, RefusesAMapWithoutClassesOrOfOnlyOne) {
  OverheadMap map = street_map(0.2);
  for (const auto& [name, id] : {std::pair("blank", kUnclassified), std::pair("uniform", kRoad)}) {
    map.name = name;
    map.labels = Raster<ClassId>(100, 100, id);
    ASSERT_TRUE(write_overhead_map(map, {.name = name}, std::nullopt, path(name)).has_value());
    expect_refused(
        {"localise", path("flight"), "--map", path(name), "--out", path("refused.nadir")}, name);
  }
}

/// A copy of the flight that a test may damage.
class DamagedFlight : public LocaliseCommand {
 protected:
  void SetUp() override {
    fs::remove_all(path("damaged"));
    fs::remove(path("damaged.nadir"));
    fs::copy(path("flight"), path("damaged"), fs::copy_options::recursive);
  }
  static std::vector<std::string> localise_damaged() {
    return {"localise", path("damaged"),       "--map",  path("map"),
            "--out",    path("damaged.nadir"), "--quiet"};
  }
  static fs::path some_file(const std::string& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(path("damaged") + "/" + folder))
      files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files.at(files.size() / 2);
  }
};

TEST_F(DamagedFlight, IsRefusedWhereAnImageIsTruncatedNamingIt) {
  const fs::path image = some_file("labels");
  const std::string bytes = read_text_file(image).value();
  scratch_->file(fs::relative(image, scratch_->path()).string(), bytes.substr(0, bytes.size() / 2));
  const auto refused = run_program(localise_damaged());
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr(image.filename().string()));
}

TEST_F(DamagedFlight, IsRefusedWhereAnImageIsMissingNamingIt) {
  const fs::path image = some_file("depth");
  fs::remove(image);
  const auto refused = run_program(localise_damaged());
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr(image.filename().string()));
}

TEST_F(DamagedFlight, IsRefusedWhereTimeGoesBackOrAPoseIsNotANumber) {
  const std::string odometry = path("damaged") + "/odometry.txt";
  const std::string good = read_text_file(odometry).value();
  const std::string last_line = good.substr(good.rfind('\n', good.size() - 2) + 1);
  for (const std::string& bad : {good + last_line, good + "99999 nan 0 0 0 0 0 1\n"}) {
    ASSERT_TRUE(write_text_file(odometry, bad).has_value());
    const auto refused = run_program(localise_damaged());
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("odometry.txt"), HasSubstr("line")));
  }
}

TEST_F(DamagedFlight, IsRefusedWhereNoTopviewSaysAnything) {
  SemanticFrame nothing;  // a frame without any depth
  nothing.labels = Raster<ClassId>(160, 120, kRoad);
  nothing.depth_m = Raster<float>(160, 120, 0.0F);
  const auto encoded = encode_frame(nothing).value();
  const std::string blank(encoded.depth_png.begin(), encoded.depth_png.end());
  for (const auto& entry : fs::directory_iterator(path("damaged") + "/depth")) {
    ASSERT_TRUE(write_text_file(entry.path(), blank).has_value());
  }
  const auto refused = run_program(localise_damaged());
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("nothing was localised"));
  EXPECT_FALSE(fs::exists(path("damaged.nadir")));
}

TEST_F(DamagedFlight, LeavesAnEarlierRunAsItWasWhenTheNewOneFailsAtOnce) {
  ASSERT_EQ(run_program(localise_damaged()).status, 0);
  const std::string before = run_program({"evaluate", path("damaged.nadir"), "--json"}).out;
  fs::remove_all(path("damaged") + "/depth");
  const auto refused = run_program(localise_damaged());
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(run_program({"evaluate", path("damaged.nadir"), "--json"}).out, before);
  fs::remove(path("damaged.nadir"));
  EXPECT_EQ(run_program(localise_damaged()).status, 1);
  EXPECT_FALSE(fs::exists(path("damaged.nadir")));
}

TEST_F(DamagedFlight, KeepsTheStepsOfARunThatFailsLaterBesideTheRunBefore) {
  ASSERT_EQ(run_program(localise_damaged()).status, 0);
  const int whole = RunReader::open(path("damaged.nadir")).value().step_count();
  const fs::path image =
      some_file("depth");  // a missing one would be noticed before the first step
  fs::resize_file(image, fs::file_size(image) / 2);
  const auto refused = run_program(localise_damaged());
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr(" steps; they are in " + path("damaged.nadir")));
  const auto now = RunReader::open(path("damaged.nadir")).value();
  EXPECT_FALSE(now.is_complete());
  EXPECT_GT(now.step_count(), 0);
  EXPECT_LT(now.step_count(), whole);
  const std::string kept = path("damaged.nadir.earlier-" + std::to_string(::getpid()));
  EXPECT_THAT(refused.err, HasSubstr("the run that was there before is in " + kept));
  const auto before = RunReader::open(kept).value();
  EXPECT_TRUE(before.is_complete());
  EXPECT_EQ(before.step_count(), whole);
  fs::remove(kept);
}

}  // namespace localise_command_test
}  // namespace nadir
