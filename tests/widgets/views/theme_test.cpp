// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/theme.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/support/colour_vision.h"
#include "tests/support/page_pixels.h"

namespace nadir {
namespace theme_test {

constexpr std::array kThemes = {ThemeName::kLight, ThemeName::kDark};
constexpr std::array kVisions = {ColourVision::kUsual, ColourVision::kProtanopia,
                                 ColourVision::kDeuteranopia, ColourVision::kTritanopia};

struct Named {
  const char* name;
  Rgba colour;
};

/// Lines that are drawn over paper in one chart, and what they are drawn on.
std::vector<Named> lines_on_paper(ThemeName name) {
  const Theme& colours = theme(name);
  return {{"truth", colours.truth},         {"odometry", colours.odometry},
          {"estimate", colours.estimate},   {"second run", colours.second_run},
          {"third run", colours.third_run}, {"fourth run", colours.fourth_run}};
}

std::vector<Named> lines_on_imagery(ThemeName name) {
  const Theme& colours = theme(name);
  return {{"truth", colours.truth_on_imagery},       {"odometry", colours.odometry_on_imagery},
          {"estimate", colours.estimate_on_imagery}, {"second run", colours.second_run},
          {"third run", colours.third_run},          {"fourth run", colours.fourth_run}};
}

// Sharma, Wu and Dalal 2005, table 1: pairs that wrong implementations get wrong.
TEST(ColourDistance, IsThePublishedOne) {
  struct Pair {
    Eigen::Vector3d a, b;
    double distance;
  };
  const std::vector<Pair> pairs = {
      {{50.0, 2.6772, -79.7751}, {50.0, 0.0, -82.7485}, 2.0425},
      {{50.0, 3.1571, -77.2803}, {50.0, 0.0, -82.7485}, 2.8615},
      {{50.0, 0.0, 0.0}, {50.0, -1.0, 2.0}, 2.3669},
      {{50.0, 2.5, 0.0}, {73.0, 25.0, -18.0}, 27.1492},
      {{50.0, 2.5, 0.0}, {58.0, 24.0, 15.0}, 19.4535},
      {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
      {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
      {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
      {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};
  for (const Pair& pair : pairs) {
    EXPECT_NEAR(colour_distance(pair.a, pair.b), pair.distance, 1e-4);
    EXPECT_NEAR(colour_distance(pair.b, pair.a), pair.distance, 1e-4);
  }
}

TEST(ColourVision, OfAnyKindLeavesGreyAlone) {
  for (const ColourVision vision : kVisions) {
    for (const double share : {0.0, 0.2, 0.5, 1.0}) {
      const Eigen::Vector3d grey = Eigen::Vector3d::Constant(share);
      EXPECT_LT((seen_by(vision, grey) - grey).norm(), 1e-5);
    }
  }
  // And the two that are known for it do mix up what they do.
  const Rgba red{200, 60, 40};
  const Rgba green{110, 110, 30};
  EXPECT_LT(colour_distance(ColourVision::kProtanopia, red, green),
            0.5 * colour_distance(ColourVision::kUsual, red, green));
}

TEST(Contrast, IsThatOfBlackOnWhiteAtMost) {
  EXPECT_NEAR(contrast(kBlack, kWhite), 21.0, 1e-4);
  EXPECT_NEAR(contrast(kWhite, kBlack), 21.0, 1e-4);
  EXPECT_EQ(contrast(kRed, kRed), 1.0);
  EXPECT_NEAR(contrast({0x76, 0x76, 0x76}, kWhite), 4.54, 0.005);
}

TEST(Theme, HasTextThatCanBeRead) {
  for (const ThemeName name : kThemes) {
    const Theme& colours = theme(name);
    for (const Rgba ground : {colours.page, colours.window}) {
      EXPECT_GE(contrast(colours.text, ground), 4.5);
      EXPECT_GE(contrast(colours.muted, ground), 3.0);
      EXPECT_GE(contrast(colours.bad, ground), 3.0);
      EXPECT_GE(contrast(colours.warning, ground), 3.0);
      EXPECT_GE(contrast(colours.good, ground), 3.0);
      EXPECT_GE(contrast(colours.accent, ground), 3.0);
    }
  }
}

TEST(Theme, HasTextThatCanBeReadOnAPlateOverAnyPicture) {
  for (const ThemeName name : kThemes) {
    const Theme& colours = theme(name);
    for (const Rgba below : {kBlack, kWhite, Rgba{120, 190, 100}}) {
      // Plates have the page's colour at 85 %.
      const auto mixed = [](int above, int under) {
        return static_cast<std::uint8_t>(std::lround(0.85 * above + 0.15 * under));
      };
      const Rgba plate{mixed(colours.page.red, below.red), mixed(colours.page.green, below.green),
                       mixed(colours.page.blue, below.blue)};
      EXPECT_GE(contrast(colours.text, plate), 4.5);
    }
  }
}

/// Ten times what is just noticeable side by side: the lines are thin and their legend is elsewhere, for which colours
/// must differ several times as much as for large neighbouring areas (Stone, Szafir and Setlur 2014).
constexpr double kFarEnough = 10.0;

TEST(Theme, HasLinesThatEveryEyeTellsApart) {
  for (const ThemeName name : kThemes) {
    for (const auto& lines : {lines_on_paper(name), lines_on_imagery(name)}) {
      for (const ColourVision vision : kVisions) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
          for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GE(colour_distance(vision, lines[i].colour, lines[j].colour), kFarEnough)
                << lines[i].name << " and " << lines[j].name << ", theme " << static_cast<int>(name)
                << ", vision " << static_cast<int>(vision);
          }
        }
      }
    }
  }
}

TEST(Theme, HasLinesThatEveryEyeSeesOnPaperAndOnTheirCasing) {
  for (const ThemeName name : kThemes) {
    for (const ColourVision vision : kVisions) {
      for (const auto& [line, colour] : lines_on_paper(name)) {
        EXPECT_GE(colour_distance(vision, colour, theme(name).page), 2.0 * kFarEnough) << line;
      }
      for (const auto& [line, colour] : lines_on_imagery(name)) {
        EXPECT_GE(colour_distance(vision, colour, theme(name).casing_on_imagery), 2.0 * kFarEnough)
            << line;
      }
    }
  }
}

TEST(Theme, HasAgreementThatEveryEyeTellsFromDisagreement) {
  for (const ThemeName name : kThemes) {
    for (const ColourVision vision : kVisions) {
      EXPECT_GE(colour_distance(vision, theme(name).agreement, theme(name).disagreement),
                kFarEnough);
    }
  }
}

TEST(Theme, HasTheColoursOfTheTable) {
  EXPECT_EQ(theme(ThemeName::kLight).page, kWhite);
  EXPECT_EQ(theme(ThemeName::kDark).page, (Rgba{0x1B, 0x1F, 0x23}));
  EXPECT_EQ(theme(ThemeName::kLight).truth, kBlack);
  EXPECT_EQ(theme(ThemeName::kDark).truth, kWhite);
  EXPECT_EQ(theme(ThemeName::kLight).estimate, (Rgba{0x00, 0x72, 0xB2}));
  EXPECT_EQ(theme(ThemeName::kDark).estimate, (Rgba{0x56, 0xB4, 0xE9}));
  EXPECT_EQ(theme(ThemeName::kLight).casing_on_imagery, (Rgba{0x14, 0x17, 0x1A}));
  EXPECT_EQ(theme(ThemeName::kDark).line, (Rgba{0x2E, 0x35, 0x3B}));
}

TEST(RunLook, DiffersForEightRunsOnPaperAndOverImagery) {
  for (const ThemeName name : kThemes) {
    for (const auto colour_of : {run_colour, run_colour_on_imagery}) {
      for (std::size_t a = 0; a < 8; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          EXPECT_TRUE(is_run_dashed(a) != is_run_dashed(b) ||
                      difference(colour_of(theme(name), a), colour_of(theme(name), b)) > 60)
              << a << " and " << b;
        }
      }
      EXPECT_EQ(colour_of(theme(name), 8), colour_of(theme(name), 0));
    }
  }
  EXPECT_EQ(is_run_dashed(8), is_run_dashed(0));
}

TEST(RunLook, IsTheSameOnPaperAndOverImagery) {
  for (const ThemeName name : kThemes) {
    const Theme& colours = theme(name);
    EXPECT_EQ(run_colour(colours, 0), colours.estimate);
    EXPECT_EQ(run_colour_on_imagery(colours, 0), colours.estimate_on_imagery);
    for (std::size_t run = 0; run < 8; ++run) {
      EXPECT_EQ(run_colour(colours, run), run_colour_on_imagery(colours, run)) << run;
    }
  }
}

TEST(RunLook, IsDashedFromTheFifthRunOn) {
  EXPECT_FALSE(is_run_dashed(0));
  EXPECT_FALSE(is_run_dashed(3));
  EXPECT_TRUE(is_run_dashed(4));
  EXPECT_TRUE(is_run_dashed(7));
}

TEST(WithOpacity, ChangesNothingElseAndClamps) {
  EXPECT_EQ(with_opacity({1, 2, 3, 77}, 0.5), (Rgba{1, 2, 3, 128}));
  EXPECT_EQ(with_opacity({1, 2, 3}, 0.0).alpha, 0);
  EXPECT_EQ(with_opacity({1, 2, 3}, -1.0).alpha, 0);
  EXPECT_EQ(with_opacity({1, 2, 3}, 7.0).alpha, 255);
}

TEST(ClassColour, IsOpaqueForClassesAndNothingForTheUnclassified) {
  EXPECT_EQ(class_colour(kRoad), (Rgba{128, 64, 128}));
  EXPECT_EQ(class_colour(kLaneMarking), (Rgba{250, 225, 60}));
  for (int id = 0; id < 256; ++id) {
    EXPECT_EQ(class_colour(static_cast<ClassId>(id)).alpha, id < kClassCount ? 255 : 0) << id;
  }
}

TEST(ValueColour, RisesInLightnessForEveryEye) {
  for (const ValueColours colours : {ValueColours::kViridis, ValueColours::kCividis}) {
    for (const ColourVision vision : kVisions) {
      double lightest = -1.0;
      double eight_before = -1.0;
      for (int i = 0; i < 256; ++i) {
        const double lightness =
            lab_of(seen_by(vision, light_of(value_colour(colours, i / 255.0))))[0];
        // Between neighbours eight bits may round it down by a hair.
        EXPECT_GT(lightness, lightest - 0.5) << i;
        if (i % 8 == 0) {
          EXPECT_GT(lightness, eight_before + 0.5) << i;
          eight_before = lightness;
        }
        lightest = std::max(lightest, lightness);
      }
      EXPECT_GT(lightest, 85.0);
    }
  }
}

TEST(ValueColour, IsClampedAndNothingForNoNumber) {
  for (const ValueColours colours : {ValueColours::kViridis, ValueColours::kCividis}) {
    EXPECT_EQ(value_colour(colours, -3.0), value_colour(colours, 0.0));
    EXPECT_EQ(value_colour(colours, 3.0), value_colour(colours, 1.0));
    EXPECT_EQ(value_colour(colours, std::numeric_limits<double>::infinity()),
              value_colour(colours, 1.0));
    EXPECT_EQ(value_colour(colours, std::numeric_limits<double>::quiet_NaN()), kNothing);
    EXPECT_EQ(value_colour(colours, 0.5).alpha, 255);
  }
  EXPECT_LE(difference(value_colour(ValueColours::kViridis, 0.0), {68, 1, 84}), 2);
  EXPECT_LE(difference(value_colour(ValueColours::kViridis, 1.0), {253, 231, 37}), 2);
}

}  // namespace theme_test
}  // namespace nadir
