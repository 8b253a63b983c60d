// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <ostream>
#include <set>

#include "tests/support/golden_image.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/figures/figures.h"

namespace nadir {
namespace golden_test {

constexpr double kEnd = 1e9;

/// A figure of the made-up street, kept as tests/golden/FIGURE-THEME.png.
struct FigureGolden {
  const char* figure;
  ThemeName theme;
  int width_px;
  double time_s;              ///< Moment shown, after the first step.
  bool shows_picture = true;  ///< Of the overhead; else its labels, a smaller file.
};

// A line adds a golden: NADIR_UPDATE_GOLDEN=1 draws it.
constexpr FigureGolden kGoldens[] = {
    {"overhead-pair", ThemeName::kLight, 480, kEnd},
    {"route", ThemeName::kLight, 320, kEnd},
    {"flight", ThemeName::kLight, 480, kEnd, false},
    {"mse-bars", ThemeName::kLight, 400, kEnd},
    {"cdf", ThemeName::kLight, 480, kEnd},
    {"trajectories", ThemeName::kLight, 400, kEnd, false},
    {"labels", ThemeName::kLight, 400, kEnd},
    {"reconstruction", ThemeName::kLight, 480, 12.0, false},
    {"consistency", ThemeName::kLight, 480, kEnd},
    {"timing", ThemeName::kLight, 400, kEnd},
    {"moment", ThemeName::kLight, 480, 7.5, false},
    {"scene", ThemeName::kLight, 480, 7.5, false},
    {"error-surface", ThemeName::kLight, 480, 7.5, false},
    {"compare", ThemeName::kLight, 480, kEnd, false},
    {"flight", ThemeName::kDark, 480, kEnd, false},
    {"cdf", ThemeName::kDark, 480, kEnd},
};

std::string name_of(const FigureGolden& golden) {
  return std::string(golden.figure) + (golden.theme == ThemeName::kLight ? "-light" : "-dark");
}

/// For GoogleTest's messages.
void PrintTo(const FigureGolden& golden, std::ostream* out) { *out << name_of(golden); }

class GoldenFigures : public ::testing::TestWithParam<FigureGolden> {
 protected:
  /// Of the street: a drive, another one that is shorter and runs beside it, a route, as much of them as the figure takes.
  FigureRecipe recipe() const {
    FigureRecipe made;
    made.figure = GetParam().figure;
    made.map = (scratch_.path() / "map").string();
    write_street(made.map);
    const std::string drive = (scratch_.path() / "drive.nadir").string();
    const std::string shorter = (scratch_.path() / "shorter.nadir").string();
    write_drive(drive, made.map);
    write_drive(shorter, made.map, 20, {.shift_m = 4.0});
    const auto kind = figure_kind(made.figure);
    if (kind && kind->most_runs > 0) made.runs.push_back(drive);
    if (kind && kind->most_runs > 1) made.runs.push_back(shorter);
    made.route = scratch_
                     .file("route.toml",
                           "name = \"street\"\n[[waypoint]]\neast_m = 10\nnorth_m = 20\n"
                           "[[waypoint]]\neast_m = 50\nnorth_m = 22\n")
                     .string();
    made.options.theme = GetParam().theme;
    made.options.size.width = GetParam().width_px;
    made.options.time_s = GetParam().time_s;
    made.options.layers.set(FigureLayer::kPicture, GetParam().shows_picture);
    return made;
  }

 private:
  ScratchFolder scratch_;
};

TEST_P(GoldenFigures, LookAsTheyDid) {
  const FigureRecipe asked = recipe();
  const auto figure = make_figure(asked);
  ASSERT_TRUE(figure.has_value()) << figure.error().message;
  FigureContext context(page_format(asked.options, figure_kind(asked.figure)->aspect));
  const auto pixels = draw_pixels(**figure, context);
  ASSERT_TRUE(pixels.has_value()) << pixels.error().message;
  expect_golden(name_of(GetParam()), *pixels);
}

std::string test_name_of(const ::testing::TestParamInfo<FigureGolden>& golden) {
  std::string name = name_of(golden.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Street, GoldenFigures, ::testing::ValuesIn(kGoldens), test_name_of);

TEST(GoldenTable, HoldsEveryFigureInTheLightThemeAndEachNameOnce) {
  std::set<std::string> names;
  for (const FigureGolden& golden : kGoldens) {
    EXPECT_TRUE(figure_kind(golden.figure).has_value()) << golden.figure;
    EXPECT_TRUE(names.insert(name_of(golden)).second) << name_of(golden);
  }
  for (const FigureKind& kind : figure_kinds()) {
    EXPECT_EQ(names.count(std::string(kind.name) + "-light"), 1U) << kind.name;
  }
}

}  // namespace golden_test
}  // namespace nadir
