// SPDX-License-Identifier: Apache-2.0
#include "tests/support/golden_image.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest-spi.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "core/base/random.h"
#include "tests/support/page_pixels.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/small_png.h"

namespace nadir {
namespace golden_image_test {

constexpr Rgba kOrange{230, 159, 0};
constexpr Rgba kSky{86, 180, 233};

/// A page such as figures are: white paper, a frame, a coloured curve, rows of short strokes where text would be.
Raster<Rgba> drawn_page(int shift = 0, Rgba curve = kOrange) {
  Raster<Rgba> page(160, 100, kWhite);
  for (int column = 20; column < 150; ++column) {
    page.at(column, 10 + shift) = page.at(column, 80 + shift) = kBlack;
    const int crest = 45 + static_cast<int>(std::lround(20.0 * std::sin(0.08 * column)));
    for (int row = crest; row < 78; ++row) page.at(column, row + shift) = curve;
  }
  for (int column = 20; column < 150; column += 3) {
    for (int row = 86; row < 94; ++row) page.at(column + row % 2, row + shift) = kBlack;
  }
  return page;
}

Raster<Rgba> noise(int width, int height, std::uint64_t seed) {
  Raster<Rgba> image(width, height);
  DrawId id{.seed = seed};
  for (Rgba& pixel : image.values()) {
    const auto words = random_words(id);
    ++id.draw;
    const auto byte = [&words](std::size_t i) {
      return static_cast<std::uint8_t>(words[i] >> 24U);
    };
    pixel = {byte(0), byte(1), byte(2)};
  }
  return image;
}

double grey(const Raster<Rgba>& image, int column, int row) {
  const Rgba pixel = image.at(column, row);
  return 0.299 * pixel.red + 0.587 * pixel.green + 0.114 * pixel.blue;
}

int mirrored(int index, int count) {
  if (index < 0) return -index;
  return index < count ? index : 2 * (count - 1) - index;
}

/// The paper's formulas word by word: weights that sum to 1, weighted means, deviations from them.
double structural_distance_by_the_book(const Raster<Rgba>& a, const Raster<Rgba>& b) {
  double sum = 0.0;
  for (int row = 0; row < a.height(); ++row) {
    for (int column = 0; column < a.width(); ++column) {
      double total = 0.0;
      double mean_a = 0.0;
      double mean_b = 0.0;
      const auto in_window = [&](auto&& use) {
        for (int dy = -5; dy <= 5; ++dy) {
          for (int dx = -5; dx <= 5; ++dx) {
            const int x = mirrored(column + dx, a.width());
            const int y = mirrored(row + dy, a.height());
            use(std::exp(-(dx * dx + dy * dy) / (2.0 * 1.5 * 1.5)), grey(a, x, y), grey(b, x, y));
          }
        }
      };
      in_window([&](double weight, double value_a, double value_b) {
        total += weight;
        mean_a += weight * value_a;
        mean_b += weight * value_b;
      });
      mean_a /= total;
      mean_b /= total;
      double variance_a = 0.0;
      double variance_b = 0.0;
      double covariance = 0.0;
      in_window([&](double weight, double value_a, double value_b) {
        variance_a += weight / total * (value_a - mean_a) * (value_a - mean_a);
        variance_b += weight / total * (value_b - mean_b) * (value_b - mean_b);
        covariance += weight / total * (value_a - mean_a) * (value_b - mean_b);
      });
      const double c1 = std::pow(0.01 * 255.0, 2);
      const double c2 = std::pow(0.03 * 255.0, 2);
      sum += (2.0 * mean_a * mean_b + c1) * (2.0 * covariance + c2) /
             ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
    }
  }
  return (1.0 - sum / static_cast<double>(a.size())) / 2.0;
}

TEST(StructuralDistance, IsThatOfThePaper) {
  const Raster<Rgba> a = noise(23, 17, 1);
  const Raster<Rgba> b = noise(23, 17, 2);
  EXPECT_NEAR(structural_distance(a, b), structural_distance_by_the_book(a, b), 1e-9);
  Raster<Rgba> near = a;
  for (int column = 0; column < 12; ++column) near.at(column, 8) = kRed;
  EXPECT_NEAR(structural_distance(a, near), structural_distance_by_the_book(a, near), 1e-9);
}

TEST(StructuralDistance, OfPlainPagesIsTheirDifferenceInBrightness) {
  const Raster<Rgba> dark(40, 30, Rgba{50, 50, 50});
  const Raster<Rgba> light(40, 30, Rgba{100, 100, 100});
  const double c1 = 0.01 * 255.0 * 0.01 * 255.0;
  const double similarity = (2.0 * 50.0 * 100.0 + c1) / (50.0 * 50.0 + 100.0 * 100.0 + c1);
  EXPECT_NEAR(structural_distance(dark, light), (1.0 - similarity) / 2.0, 1e-9);
}

TEST(StructuralDistance, IsZeroForEqualPixelsHoweverSmallTheImage) {
  EXPECT_EQ(structural_distance(drawn_page(), drawn_page()), 0.0);
  EXPECT_EQ(structural_distance(noise(64, 48, 3), noise(64, 48, 3)), 0.0);
  EXPECT_EQ(structural_distance(noise(1, 1, 3), noise(1, 1, 3)), 0.0);
  EXPECT_EQ(structural_distance(noise(5, 2, 3), noise(5, 2, 3)), 0.0);
}

TEST(StructuralDistance, IsSymmetricToTheBitAndAtMostOne) {
  Raster<Rgba> negative = drawn_page();
  for (Rgba& pixel : negative.values()) {
    pixel = {static_cast<std::uint8_t>(255 - pixel.red),
             static_cast<std::uint8_t>(255 - pixel.green),
             static_cast<std::uint8_t>(255 - pixel.blue)};
  }
  for (const Raster<Rgba>& other :
       {drawn_page(1), drawn_page(0, kSky), noise(160, 100, 4), negative}) {
    const double there = structural_distance(drawn_page(), other);
    EXPECT_EQ(there, structural_distance(other, drawn_page()));
    EXPECT_GT(there, 0.0);
    EXPECT_LE(there, 1.0);
  }
}

TEST(StructuralDistance, PassesNoiseOfALevelAndNoMoreThanThat) {
  Raster<Rgba> noisy = drawn_page();
  const Raster<Rgba> draws = noise(160, 100, 5);
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    const auto stirred = [](std::uint8_t level, std::uint8_t draw) {
      return static_cast<std::uint8_t>(std::clamp(level + draw % 3 - 1, 0, 255));
    };
    Rgba& pixel = noisy.values()[i];
    const Rgba draw = draws.values()[i];
    pixel = {stirred(pixel.red, draw.red), stirred(pixel.green, draw.green),
             stirred(pixel.blue, draw.blue)};
  }
  ASSERT_NE(noisy, drawn_page());
  EXPECT_LT(structural_distance(drawn_page(), noisy), kGoldenTolerance);
  EXPECT_GT(structural_distance(drawn_page(), drawn_page(1)), kGoldenTolerance);
  EXPECT_GT(structural_distance(drawn_page(), drawn_page(3)), kGoldenTolerance);
  EXPECT_GT(structural_distance(drawn_page(), drawn_page(0, kBlue)), kGoldenTolerance);
  EXPECT_GT(structural_distance(drawn_page(), Raster<Rgba>(160, 100, kWhite)), kGoldenTolerance);
}

TEST(StructuralDistance, SeesAPageThatLostItsPaper) {
  Raster<Rgba> clear = drawn_page();
  for (Rgba& pixel : clear.values()) {
    if (pixel == kWhite) pixel = {255, 255, 255, 0};  // looks the same on white
  }
  EXPECT_GT(structural_distance(drawn_page(), clear), kGoldenTolerance);
}

TEST(AmplifiedDifference, IsEightTimesTheDifferenceAndWhiteBeyondTheSmallerImage) {
  Raster<Rgba> a(2, 1, Rgba{10, 20, 30});
  Raster<Rgba> b(2, 2, Rgba{10, 20, 30});
  b.at(1, 0) = {13, 10, 200};
  EXPECT_EQ(amplified_difference(a, b).values(),
            (std::vector<Rgba>{kBlack, {24, 80, 255}, kWhite, kWhite}));
  EXPECT_EQ(amplified_difference(a, b), amplified_difference(b, a));
  b = a;
  b.at(0, 0).alpha = 250;
  EXPECT_EQ(amplified_difference(a, b).at(0, 0), (Rgba{40, 40, 40}));
}

class GoldenImage : public ::testing::Test {
 protected:
  [[nodiscard]] GoldenPlaces places(bool rewrites = false) const {
    return {scratch_.path() / "golden", scratch_.path() / "left", rewrites};
  }
  void keep(const Raster<Rgba>& golden) const { expect_golden("page", golden, places(true)); }
  [[nodiscard]] std::string bytes_left(const std::string& what) const {
    return bytes_of(places().leftovers / ("page-" + what + ".png"));
  }
  [[nodiscard]] static std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  ScratchFolder scratch_;
};

TEST_F(GoldenImage, IsMadeByRewritingAndThenPasses) {
  keep(drawn_page());
  EXPECT_EQ(bytes_of(places().goldens / "page.png"), small_png(drawn_page()));
  expect_golden("page", drawn_page(), places());
  keep(drawn_page(2));
  expect_golden("page", drawn_page(2), places());
  EXPECT_FALSE(std::filesystem::exists(places().leftovers));
}

TEST_F(GoldenImage, KeepsATransparentPaper) {
  Raster<Rgba> page = drawn_page();
  page.at(3, 4) = {200, 100, 50, 128};
  page.at(5, 6) = {0, 0, 0, 0};
  keep(page);
  expect_golden("page", page, places());
  Raster<Rgba> clear = page;
  for (Rgba& pixel : clear.values()) pixel.alpha = 0;
  EXPECT_NONFATAL_FAILURE(expect_golden("page", clear, places()), "structural distance");
}

TEST_F(GoldenImage, ThatDiffersLeavesItsPicturesAndNamesThemWithTheDistance) {
  keep(drawn_page());
  EXPECT_NONFATAL_FAILURE(expect_golden("page", drawn_page(3), places()),
                          fmt::format("page: has a structural distance of {:.4f} from its golden, "
                                      "and 0.02 is allowed",
                                      structural_distance(drawn_page(), drawn_page(3))));
  EXPECT_EQ(bytes_left("actual"), small_png(drawn_page(3)));
  EXPECT_EQ(bytes_left("expected"), small_png(drawn_page()));
  EXPECT_EQ(bytes_left("difference"), small_png(amplified_difference(drawn_page(), drawn_page(3))));
  for (const char* what : {"actual", "expected", "difference"}) {
    EXPECT_NONFATAL_FAILURE(expect_golden("page", drawn_page(3), places()),
                            (places().leftovers / fmt::format("page-{}.png", what)).string());
  }
}

TEST_F(GoldenImage, ThatPassesAgainRemovesWhatItsFailureLeft) {
  keep(drawn_page());
  EXPECT_NONFATAL_FAILURE(expect_golden("page", drawn_page(3), places()), "page: has");
  expect_golden("page", drawn_page(), places());
  EXPECT_TRUE(std::filesystem::is_empty(places().leftovers));
}

TEST_F(GoldenImage, OfAnotherSizeFails) {
  keep(drawn_page());
  EXPECT_NONFATAL_FAILURE(
      expect_golden("page", Raster<Rgba>(161, 100, kWhite), places()),
      "page: has 161 x 100 pixels, and its golden has 160 x 100; NADIR_UPDATE_GOLDEN=1 takes");
  EXPECT_FALSE(bytes_left("difference").empty());
}

TEST_F(GoldenImage, ThatIsMissingOrBrokenFailsAndSaysHowToMakeIt) {
  EXPECT_NONFATAL_FAILURE(expect_golden("page", drawn_page(), places()),
                          "page.png: there is no such golden; NADIR_UPDATE_GOLDEN=1 takes");
  EXPECT_EQ(bytes_left("actual"), small_png(drawn_page()));
  EXPECT_FALSE(std::filesystem::exists(places().leftovers / "page-expected.png"));
  EXPECT_FALSE(std::filesystem::exists(places().goldens));  // a failure makes none
  scratch_.file("golden/page.png", "no picture");
  EXPECT_NONFATAL_FAILURE(expect_golden("page", drawn_page(), places()),
                          "page.png: is no picture that can be read; NADIR_UPDATE_GOLDEN=1");
  keep(drawn_page());
  expect_golden("page", drawn_page(), places());
}

TEST_F(GoldenImage, ThatCannotBeWrittenIsAFailure) {
  scratch_.file("golden", "a file where the folder should be");
  EXPECT_NONFATAL_FAILURE(keep(drawn_page()), "page.png: cannot be written");
}

TEST_F(GoldenImage, LeavesTheGoldenAsItIsWhereThePixelsAreWithinTheTolerance) {
  keep(drawn_page());
  Raster<Rgba> near = drawn_page();
  near.at(5, 5) = {254, 255, 255};
  expect_golden("page", near, places());
  EXPECT_EQ(bytes_of(places().goldens / "page.png"), small_png(drawn_page()));
}

}  // namespace golden_image_test
}  // namespace nadir
