// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/base/result.h"
#include "core/geo/project_plane.h"
#include "core/map/overhead_map_file.h"
#include "maps/draw/painting.h"

namespace nadir::town {
namespace {

/// Open ground in Georgia, south of Perry. The town is made up; nothing but its anchor is real.
constexpr Geodetic kAnchor{32.4000, -83.7000};

cv::Mat as_image(const Raster<Colour>& colours) {
  cv::Mat image(colours.height(), colours.width(), CV_8UC3);
  for (int row = 0; row < colours.height(); ++row) {
    for (int column = 0; column < colours.width(); ++column) {
      const Colour& colour = colours.at(column, row);
      image.at<cv::Vec3b>(row, column) = {colour.blue, colour.green, colour.red};
    }
  }
  return image;
}

/// Picture and labels side by side, small enough for a README.
Result<void> write_overview(const Raster<Colour>& picture,
                            const Raster<ClassId>& labels,
                            const std::filesystem::path& path) {
  constexpr int kWidth = 400;
  Raster<Colour> label_colours(labels.width(), labels.height());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    label_colours.values()[i] = class_info(labels.values()[i]).colour;
  }
  const cv::Size size(kWidth, kWidth * labels.height() / labels.width());
  cv::Mat left, right, both;
  cv::resize(as_image(picture), left, size, 0, 0, cv::INTER_AREA);
  // Five bits a channel compress to half the size, and nobody sees it at this scale.
  left = (left & cv::Scalar::all(0xF8)) + cv::Scalar::all(4);
  cv::resize(as_image(label_colours), right, size, 0, 0, cv::INTER_NEAREST);
  cv::hconcat(left, right, both);
  if (!cv::imwrite(path.string(), both, {cv::IMWRITE_PNG_COMPRESSION, 9})) {
    return fail(ErrorCode::kIo, "{}: cannot be written", path.string());
  }
  return {};
}

Result<void> draw(const std::filesystem::path& package) {
  const auto plane = ProjectPlane::create(kAnchor);
  if (!plane) return forward_error(plane);
  const TownLayout town = proving_ground_layout();
  const Ground ground = draw_ground(town);
  const OverheadMap map{"proving ground",
                        *plane,
                        town.metres_per_cell,
                        {-town.width_m / 2.0, town.height_m / 2.0},
                        draw_labels(ground)};
  const MapProvenance provenance{map.name,
                                 "A made training town, drawn by maps/draw in the spirit of a real "
                                 "training site; no such place exists, it is only "
                                 "anchored at open ground in Georgia, USA",
                                 "CC0-1.0", "2026-11-22"};
  const Raster<Colour> picture = draw_picture(town, ground);
  if (auto written = write_overhead_map(map, provenance, picture, package); !written) {
    return written;
  }
  return write_overview(picture, map.labels, package / "overview.png");
}

}  // namespace
}  // namespace nadir::town

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr,
               "draw_proving_ground PACKAGE: draws the proving ground into a map package\n");
    return 2;
  }
  try {
    const auto drawn = nadir::town::draw(argv[1]);
    if (drawn) return 0;
    fmt::print(stderr, "{}\n", drawn.error().message);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", argv[1], error.what());
  }
  return 1;
}
