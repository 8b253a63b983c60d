// SPDX-License-Identifier: Apache-2.0
// Golden pictures of every panel and of what lies over the window: tests/golden/panels/SCENE-THEME-SCALE.png.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "tests/support/golden_image.h"
#include "tests/support/small_png.h"
#include "tests/widgets/panels/panel_scenes.h"

namespace nadir {
namespace panel_golden_test {

using ::testing::IsEmpty;

/// A scene in a look.
std::string golden_name(const PanelScene& scene, const PanelLook& look) {
  return fmt::format("{}-{}-{}", scene.name, look.theme == ThemeName::kLight ? "light" : "dark",
                     look.scale == 1.0 ? "1x" : "15x");
}

/// Each panel in all looks, other states of it once in each theme and scale, and what says that something is missing once.
bool is_kept(const PanelScene& scene, const PanelLook& look) {
  const bool is_dark = look.theme == ThemeName::kDark, is_small = look.scale == 1.0;
  if (scene.is_without_data) return is_dark && is_small;
  return !scene.is_variant || is_dark == is_small;
}

GoldenPlaces panel_places() {
  GoldenPlaces places = usual_golden_places();
  places.goldens /= "panels";
  places.leftovers /= "panels";
  return places;
}

class GoldenPanels : public testing::TestWithParam<PanelLook> {};

TEST_P(GoldenPanels, LookAsTheyDid) {
  UiCamera camera;
  const GoldenPlaces places = panel_places();
  for (const PanelScene& scene : panel_scenes()) {
    if (!is_kept(scene, GetParam())) continue;
    const SeenScene seen = see(scene, GetParam(), camera);
    expect_golden(golden_name(scene, GetParam()), in_few_colours(seen.cut_out), places);
  }
}

INSTANTIATE_TEST_SUITE_P(Looks, GoldenPanels, testing::ValuesIn(panel_looks()));

/// Headers of widgets/panels that draw something which asks for actions.
std::set<std::string> panels_in_folder() {
  const std::regex draws(R"(Actions draw_\w+\(kit::Ui& ui)");
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(NADIR_PANELS_FOLDER)) {
    if (entry.path().extension() != ".h") continue;
    std::ifstream file(entry.path());
    const std::string text(std::istreambuf_iterator<char>(file), {});
    if (std::regex_search(text, draws)) found.insert(entry.path().stem().string());
  }
  return found;
}

TEST(PanelScenes, ShowEveryPanelWithSomethingInIt) {
  std::set<std::string> shown;
  for (const PanelScene& scene : panel_scenes()) {
    if (!scene.is_without_data) shown.insert(scene.panels.begin(), scene.panels.end());
  }
  shown.insert("empty_state");  // which never has
  const std::set<std::string> panels = panels_in_folder();
  ASSERT_GE(panels.size(), 20U);
  EXPECT_EQ(shown, panels) << "a panel without a scene, or a scene of no panel";
}

TEST(PanelScenes, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const PanelScene& scene : panel_scenes()) {
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    EXPECT_THAT(scene.name, testing::MatchesRegex("[a-z0-9-]+"));
  }
}

TEST(PanelGoldens, AreThoseOfTheScenesAndSmall) {
  std::set<std::string> wanted;
  for (const PanelScene& scene : panel_scenes()) {
    for (const PanelLook& look : panel_looks()) {
      if (is_kept(scene, look)) wanted.insert(golden_name(scene, look) + ".png");
    }
  }
  constexpr std::uintmax_t kMostBytes = 1'800'000;
  std::uintmax_t bytes = 0;
  std::set<std::string> left_over;
  const GoldenPlaces places = panel_places();
  std::filesystem::create_directories(places.goldens);
  for (const auto& entry : std::filesystem::directory_iterator(places.goldens)) {
    if (wanted.count(entry.path().filename().string()) == 1) {
      bytes += entry.file_size();
    } else if (places.rewrites) {
      std::filesystem::remove(entry.path());
    } else {
      left_over.insert(entry.path().filename().string());
    }
  }
  EXPECT_THAT(left_over, IsEmpty()) << "goldens that no scene has any more";
  EXPECT_LE(bytes, kMostBytes);
}

}  // namespace panel_golden_test
}  // namespace nadir
