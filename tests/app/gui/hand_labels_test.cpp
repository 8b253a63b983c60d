// SPDX-License-Identifier: Apache-2.0
// Labels that were read off the picture of the bundled town by eye, drawn by a script in the window, and flown on.
#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/map/overhead_map_file.h"
#include "tests/app/gui/gui_program.h"

namespace nadir {
namespace hand_labels_test {

namespace fs = std::filesystem;

/// Around the demo's flight by its sensor's range: what the script labels.
constexpr double kWestM = -65.0, kSouthM = -33.0, kEastM = 125.0, kNorthM = 95.0;

/// How well two maps of the same cells agree.
struct Agreement {
  std::array<double, kClassCount> in_both{}, in_either{};

  [[nodiscard]] double of(ClassId id) const { return in_both[id] / in_either[id]; }
};

Agreement agreement(const OverheadMap& drawn, const OverheadMap& bundled) {
  Agreement counted;
  for (int row = 0; row < bundled.labels.height(); ++row) {
    for (int column = 0; column < bundled.labels.width(); ++column) {
      const Eigen::Vector2d at_in_enu_m = bundled.enu_from_overhead({column + 0.5, row + 0.5});
      if (at_in_enu_m.x() < kWestM || at_in_enu_m.x() > kEastM) continue;
      if (at_in_enu_m.y() < kSouthM || at_in_enu_m.y() > kNorthM) continue;
      const ClassId mine = drawn.class_at(at_in_enu_m);
      const ClassId theirs = bundled.labels.at(column, row);
      if (mine < kClassCount) counted.in_either[mine] += 1.0;
      if (theirs >= kClassCount) continue;
      (mine == theirs ? counted.in_both : counted.in_either)[theirs] += 1.0;
    }
  }
  return counted;
}

/// The picture of the bundled town as a package without labels, "bare" in the folder "demo", and what the script makes of it.
class HandLabels : public GuiProgram {
 protected:
  HandLabels() : before_(fs::current_path()) {
    fs::current_path(path("demo"));
    fs::create_directory("bare");
    for (const char* const name : {"map.toml", "image.tif"}) {
      fs::copy_file(fs::path(NADIR_PROVING_GROUND) / name, fs::path("bare") / name);
    }
  }
  ~HandLabels() override { fs::current_path(before_); }

  static double position_rmse_m(const std::string& run_file) {
    const Ending told = run({"evaluate", run_file, "--json", "--out", run_file + ".json"});
    EXPECT_EQ(told.status, 0) << told.words;
    return nlohmann::json::parse(std::ifstream(run_file + ".json"))
        .at("runs")
        .at(0)
        .at("estimate")
        .at("position_rmse_m")
        .get<double>();
  }

 private:
  fs::path before_;
};

TEST_F(HandLabels, ReadOffThePictureAloneLocaliseAboutAsWellAsTheBundledOnes) {
  const Ending drawn = gui({"--fresh", "--script", NADIR_HAND_LABELS});
  ASSERT_EQ(drawn.status, 0) << drawn.words;
  ASSERT_FALSE(fs::exists("bare/labels.tif"));

  const auto hand = read_overhead_map("hand");
  const auto bundled = read_overhead_map(NADIR_PROVING_GROUND);
  ASSERT_TRUE(hand) << hand.error().message;
  ASSERT_TRUE(bundled);
  const Agreement agrees = agreement(*hand, *bundled);
  EXPECT_GT(agrees.of(kRoad), 0.9);
  EXPECT_GT(agrees.of(kSidewalk), 0.85);
  EXPECT_GT(agrees.of(kBuilding), 0.8);
  EXPECT_GT(agrees.of(kCurb), 0.55);
  EXPECT_GT(agrees.of(kLaneMarking), 0.55);

  const Ending flown =
      run({"localise", "flight", "--map", "hand", "--out", "by-hand.nadir", "--quiet"});
  ASSERT_EQ(flown.status, 0) << flown.words;
  const double by_hand_m = position_rmse_m("by-hand.nadir");
  const double by_bundled_m = position_rmse_m("run.nadir");
  EXPECT_LE(by_hand_m, 1.5 * by_bundled_m);
  EXPECT_LT(by_bundled_m, 1.5);  // else there is nothing to be measured by
}

}  // namespace hand_labels_test
}  // namespace nadir
