// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/command.h"
#include "core/map/overhead_map_file.h"
#include "tests/support/drawn_map.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir::cli {
namespace map_command_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

class MapCommand : public testing::Test {
 protected:
  int run(const std::vector<std::string>& arguments) {
    output.str("");
    errors.str("");
    return run_map(arguments, output, errors);
  }
  /// A package of six cells of 2 m; its lower left corner is at 33.45 N 83.9 W.
  [[nodiscard]] std::string town() const {
    const fs::path package = folder.path() / "town";
    const auto written = write_overhead_map(
        drawn_map(2.0, {"RRT", "RRB"}), {"town", "drawn", "CC0-1.0", "2024-05-01"}, {}, package);
    EXPECT_TRUE(written) << error_text(written);
    return package.string();
  }
  [[nodiscard]] std::string out() const { return output.str(); }
  [[nodiscard]] std::string err() const { return errors.str(); }

  ScratchFolder folder;
  std::ostringstream output, errors;
};

TEST_F(MapCommand, InfoPrintsATableOfClassesAndPlaces) {
  ASSERT_EQ(run({"info", town()}), kDone) << err();
  EXPECT_THAT(out(), HasSubstr("name         town\n"));
  EXPECT_THAT(out(), HasSubstr("licence      CC0-1.0\n"));
  EXPECT_THAT(out(), HasSubstr("3 x 2 cells, 6.00 x 4.00 m"));
  EXPECT_THAT(out(), HasSubstr("33.450000 N 83.900000 W"));
  EXPECT_THAT(out(), HasSubstr("17S "));
  EXPECT_THAT(out(), HasSubstr("  0  road                       4   66.67 %"));
  EXPECT_THAT(err(), IsEmpty());
}

TEST_F(MapCommand, InfoGivesOneJsonObject) {
  ASSERT_EQ(run({"info", town(), "--json"}), kDone) << err();
  const auto json = nlohmann::json::parse(out());
  EXPECT_EQ(json["name"], "town");
  EXPECT_EQ(json["width_m"], 6.0);
  EXPECT_EQ(json["metres_per_cell"], 2.0);
  EXPECT_EQ(json["places"].size(), 5U);
  EXPECT_EQ(json["classes"].size(), 16U);
  EXPECT_EQ(json["classes"][0]["cells"], 4);
  EXPECT_TRUE(json["at"].is_null());
}

TEST_F(MapCommand, InfoTellsAboutAPlace) {
  ASSERT_EQ(run({"info", town(), "--quiet", "--at-enu", "5,1"}), kDone) << err();
  EXPECT_THAT(out(), HasSubstr("class        building\n"));
  ASSERT_EQ(run({"info", town(), "--at=33.45001,-83.89999", "--json"}), kDone) << err();
  const auto json = nlohmann::json::parse(out());
  EXPECT_EQ(json["at"]["class"], "road");
  EXPECT_NEAR(json["at"]["latitude_deg"], 33.45001, 1e-9);
  ASSERT_EQ(run({"info", town(), "--quiet", "--at-enu=-5,1"}), kDone) << err();
  EXPECT_THAT(out(), HasSubstr("outside the map"));
}

TEST_F(MapCommand, RefusesOptionsThatAreWrong) {
  EXPECT_EQ(run({}), kMisused);
  EXPECT_EQ(run({"info"}), kMisused);
  EXPECT_EQ(run({"info", town(), "--at", "north"}), kFailed);
  EXPECT_THAT(err(), HasSubstr("--at: 'north' is not 2 numbers"));
  EXPECT_EQ(run({"info", town(), "--at", "95,0"}), kFailed);
  EXPECT_THAT(err(), HasSubstr("nadir map info: --at: '95,0' is not a latitude from -89 to 89"));
  EXPECT_EQ(run({"info", "no/such/map", "--at", "95,0"}), kFailed) << "before any file is read";
  EXPECT_EQ(run({"import", town(), "--out", "x", "--anchor", "33,-190"}), kFailed);
  EXPECT_THAT(err(), HasSubstr("nadir map import: --anchor: '33,-190' is not a latitude"));
  EXPECT_EQ(run({"import", town(), "--out", "x", "--resolution", "fine"}), kFailed);
  EXPECT_THAT(err(), HasSubstr("--resolution: 'fine' is not a number;"));
  EXPECT_EQ(run({"import", town(), "--out", "x", "--resolution=-1"}), kFailed);
  EXPECT_EQ(run({"import", town(), "--out", "x", "--anchor-at", "top"}), kFailed);
  EXPECT_EQ(run({"import", town(), "--out", "x", "--inside", "3"}), kFailed);
  EXPECT_THAT(out(), IsEmpty());
}

TEST_F(MapCommand, FailsInOneSentenceThatNamesTheFile) {
  EXPECT_EQ(run({"info", "no/such/map"}), kFailed);
  EXPECT_EQ(err(), "nadir: no/such/map: no such map package\n");
  EXPECT_EQ(run({"import", "no/such.tif", "--out", (folder.path() / "map").string()}), kFailed);
  EXPECT_EQ(err(), "nadir: no/such.tif: no such file\n");
  EXPECT_EQ(folder.entries(), 0);
}

TEST_F(MapCommand, HelpNamesEveryOption) {
  EXPECT_EQ(run({"import", "--help"}), kDone);
  for (const char* option :
       {"--out", "--anchor", "--metres-per-pixel", "--flip", "--inside", "--building-contours"}) {
    EXPECT_THAT(out(), HasSubstr(option));
  }
}

TEST_F(MapCommand, ImportMakesAPackageThatInfoReads) {
  const std::string labels = town() + "/labels.tif";
  const std::string copy = (folder.path() / "copy").string();
  ASSERT_EQ(run({"import", labels, "--out", copy, "--name", "copy", "--licence", "CC0-1.0"}), kDone)
      << err();
  EXPECT_THAT(out(), HasSubstr("copy: 3 x 2 cells of 2 m"));
  ASSERT_EQ(run({"info", copy, "--json"}), kDone) << err();
  const auto json = nlohmann::json::parse(out());
  EXPECT_EQ(json["name"], "copy");
  EXPECT_EQ(json["classes"][0]["cells"], 4);
}

}  // namespace map_command_test
}  // namespace nadir::cli
