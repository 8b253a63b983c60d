// SPDX-License-Identifier: Apache-2.0
#include "tests/support/golden_image.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/decoded_picture.h"
#include "tests/support/small_png.h"

namespace nadir {
namespace {

constexpr std::array<const char*, 3> kLeftovers = {"actual", "expected", "difference"};

double luma_on_white(Rgba pixel) {
  const double luma = 0.299 * pixel.red + 0.587 * pixel.green + 0.114 * pixel.blue;
  return 255.0 + (luma - 255.0) * pixel.alpha / 255.0;
}

double opacity(Rgba pixel) { return pixel.alpha; }

cv::Mat plane_of(const Raster<Rgba>& image, double (*value)(Rgba)) {
  cv::Mat plane(image.height(), image.width(), CV_64F);
  for (int row = 0; row < image.height(); ++row) {
    std::transform(image.row(row).begin(), image.row(row).end(), plane.ptr<double>(row), value);
  }
  return plane;
}

cv::Mat windowed_mean(const cv::Mat& plane) {
  cv::Mat mean;
  cv::GaussianBlur(plane, mean, cv::Size(11, 11), 1.5, 1.5, cv::BORDER_REFLECT_101);
  return mean;
}

/// Equation 13 of the paper, averaged as by its equation 17. Written so that exchanging the images changes no bit.
double mean_structural_similarity(const cv::Mat& a, const cv::Mat& b) {
  constexpr double kC1 = (0.01 * 255.0) * (0.01 * 255.0);
  constexpr double kC2 = (0.03 * 255.0) * (0.03 * 255.0);
  const cv::Mat mean_a = windowed_mean(a);
  const cv::Mat mean_b = windowed_mean(b);
  const cv::Mat square_a = windowed_mean(a.mul(a));
  const cv::Mat square_b = windowed_mean(b.mul(b));
  const cv::Mat product = windowed_mean(a.mul(b));
  double sum = 0.0;
  for (int row = 0; row < a.rows; ++row) {
    for (int column = 0; column < a.cols; ++column) {
      const double ma = mean_a.at<double>(row, column);
      const double mb = mean_b.at<double>(row, column);
      const double variance_a = square_a.at<double>(row, column) - ma * ma;
      const double variance_b = square_b.at<double>(row, column) - mb * mb;
      const double covariance = product.at<double>(row, column) - ma * mb;
      sum += (2.0 * (ma * mb) + kC1) * (2.0 * covariance + kC2) /
             ((ma * ma + mb * mb + kC1) * (variance_a + variance_b + kC2));
    }
  }
  return sum / static_cast<double>(a.total());
}

std::optional<Raster<Rgba>> read_png(const std::filesystem::path& path) {
  const cv::Mat image = cv::imread(path.string(), cv::IMREAD_UNCHANGED);
  if (image.type() != CV_8UC3 && image.type() != CV_8UC4) return std::nullopt;  // or empty
  return pixels_of_decoded(image);
}

bool write_png(const std::filesystem::path& path, const Raster<Rgba>& pixels) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  std::ofstream file(path, std::ios::binary);
  file << small_png(pixels);
  file.close();
  return !file.fail();
}

std::filesystem::path leftover(const GoldenPlaces& places,
                               const std::string& name,
                               std::string_view what) {
  return places.leftovers / fmt::format("{}-{}.png", name, what);
}

void remove_leftovers(const GoldenPlaces& places, const std::string& name) {
  std::error_code error;
  for (const char* what : kLeftovers) {
    std::filesystem::remove(leftover(places, name, what), error);
  }
}

/// Writes the pictures of a failure; the lines of its message that name them.
std::string leave(const GoldenPlaces& places,
                  const std::string& name,
                  const std::vector<std::pair<std::string_view, Raster<Rgba>>>& pictures) {
  remove_leftovers(places, name);
  std::string lines;
  for (const auto& [what, pixels] : pictures) {
    const std::filesystem::path path = leftover(places, name, what);
    const bool is_written = write_png(path, pixels);
    lines += fmt::format("\n  {}{}", path.string(), is_written ? "" : " (cannot be written)");
  }
  return lines;
}

std::string size_of(const Raster<Rgba>& image) {
  return fmt::format("{} x {}", image.width(), image.height());
}

/// What is wrong, as one sentence; empty where the picture passes.
std::string fault_of(const Raster<Rgba>& actual, const Raster<Rgba>& golden) {
  if (actual == golden) return {};
  if (actual.width() != golden.width() || actual.height() != golden.height()) {
    return fmt::format("{} pixels, and its golden has {}", size_of(actual), size_of(golden));
  }
  const double distance = structural_distance(actual, golden);
  if (distance <= kGoldenTolerance) return {};
  return fmt::format("a structural distance of {:.4f} from its golden, and {} is allowed", distance,
                     kGoldenTolerance);
}

constexpr const char* kHowToRewrite =
    "NADIR_UPDATE_GOLDEN=1 takes what is drawn as the golden: look at it before";

}  // namespace

GoldenPlaces usual_golden_places() {
  const char* const update =
      std::getenv("NADIR_UPDATE_GOLDEN");  // NOLINT(concurrency-mt-unsafe): tests set no variables
  return {NADIR_GOLDEN_FOLDER, NADIR_GOLDEN_LEFTOVERS,
          update != nullptr && std::string_view(update) == "1"};
}

double structural_distance(const Raster<Rgba>& a, const Raster<Rgba>& b) {
  NADIR_REQUIRE(a.width() == b.width() && a.height() == b.height() && !a.empty());
  double least = 1.0;
  for (const auto value : {luma_on_white, opacity}) {
    least = std::min(least, mean_structural_similarity(plane_of(a, value), plane_of(b, value)));
  }
  return (1.0 - least) / 2.0;
}

Raster<Rgba> amplified_difference(const Raster<Rgba>& a, const Raster<Rgba>& b) {
  constexpr int kGain = 8;
  const auto amplified = [](int one, int other, int more) {
    return static_cast<std::uint8_t>(std::min(255, kGain * (std::abs(one - other) + more)));
  };
  Raster<Rgba> shown(std::max(a.width(), b.width()), std::max(a.height(), b.height()));
  for (int row = 0; row < shown.height(); ++row) {
    for (int column = 0; column < shown.width(); ++column) {
      Rgba& out = shown.at(column, row);
      if (!a.contains(column, row) || !b.contains(column, row)) {
        out = {255, 255, 255};
        continue;
      }
      const Rgba one = a.at(column, row);
      const Rgba other = b.at(column, row);
      const int more = std::abs(one.alpha - other.alpha);
      out = {amplified(one.red, other.red, more), amplified(one.green, other.green, more),
             amplified(one.blue, other.blue, more)};
    }
  }
  return shown;
}

void expect_golden(const std::string& name, const Raster<Rgba>& actual) {
  expect_golden(name, actual, usual_golden_places());
}

void expect_golden(const std::string& name,
                   const Raster<Rgba>& actual,
                   const GoldenPlaces& places) {
  NADIR_REQUIRE(!actual.empty());
  const std::filesystem::path path = places.goldens / (name + ".png");
  std::error_code error;
  const bool exists = std::filesystem::exists(path, error);
  const std::optional<Raster<Rgba>> golden = exists ? read_png(path) : std::nullopt;
  if (places.rewrites) {
    remove_leftovers(places, name);
    if (golden != actual && !write_png(path, actual)) {
      ADD_FAILURE() << path.string() << ": cannot be written";
    }
    return;
  }
  if (!golden) {
    ADD_FAILURE() << path.string() << ": "
                  << (exists ? "is no picture that can be read" : "there is no such golden") << "; "
                  << kHowToRewrite << leave(places, name, {{"actual", actual}});
    return;
  }
  const std::string fault = fault_of(actual, *golden);
  if (fault.empty()) {
    remove_leftovers(places, name);
    return;
  }
  const Raster<Rgba> difference = amplified_difference(actual, *golden);
  ADD_FAILURE() << name << ": has " << fault << "; " << kHowToRewrite
                << leave(places, name,
                         {{"actual", actual}, {"expected", *golden}, {"difference", difference}});
}

}  // namespace nadir
