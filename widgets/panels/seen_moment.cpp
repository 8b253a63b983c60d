// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/seen_moment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mcl/map_patch.h"
#include "widgets/panels/map_geometry.h"
#include "widgets/views/agreement_view.h"
#include "widgets/views/raster_pictures.h"

namespace nadir {
namespace {

Picture picture_of(Raster<Rgba> pixels, bool is_smooth = false) {
  return {std::make_shared<const Raster<Rgba>>(std::move(pixels)), is_smooth};
}

SeenMoment make_seen(const std::shared_ptr<const RunStep>& step,
                     const std::shared_ptr<const MapIndex>& map,
                     ThemeName theme_name) {
  SeenMoment made;
  made.step = step;
  made.map = map;
  made.theme = theme_name;
  if (!step->topview) {
    made.why_not = "the run holds no topviews";
    return made;
  }
  if (step->topview->cells.empty()) {
    made.why_not = "nothing was seen in this step";
    return made;
  }
  made.topview = topview_raster(*step->topview);
  made.seen_picture = picture_of(class_picture(made.topview.labels));
  if (!map) return made;
  const double seen_m = step->topview->metres_per_cell;
  const double map_m = map->map().metres_per_cell;
  if (std::abs(seen_m - map_m) > 1e-6 * map_m) {
    made.why_not =
        fmt::format("the topview has cells of {:g} m, this map of {:g} m", seen_m, map_m);
    return made;
  }
  const Rigid2& estimate = step->estimate.moments.mean;
  made.at_estimate = cell_agreement(*step->topview, map->map(), estimate);
  made.agreement_picture = picture_of(
      agreement_picture(*step->topview, made.at_estimate, made.topview, theme(theme_name)));
  made.map_at_estimate = map_patch(map->map(), estimate, made.topview);
  made.estimate_picture = picture_of(class_picture(made.map_at_estimate));
  if (step->truth_in_enu) {
    made.at_truth = cell_agreement(*step->topview, map->map(), *step->truth_in_enu);
    made.map_at_truth = map_patch(map->map(), *step->truth_in_enu, made.topview);
    made.truth_picture = picture_of(class_picture(made.map_at_truth));
  }
  return made;
}

std::uint8_t mixed_channel(std::uint8_t below, std::uint8_t above, double share) {
  return static_cast<std::uint8_t>(std::lround(below + (above - below) * share));
}

}  // namespace

const SeenMoment& SeenMomentCache::of(const std::shared_ptr<const RunStep>& step,
                                      const std::shared_ptr<const MapIndex>& map,
                                      ThemeName theme) {
  if (!step) return last_;
  if (step != last_.step || map != last_.map || theme != last_.theme) {
    last_ = make_seen(step, map, theme);
  }
  return last_;
}

SeenCell seen_cell(const SeenMoment& moment, const Eigen::Vector2i& pixel) {
  SeenCell cell;
  const auto class_in = [&](const Raster<ClassId>& raster) -> std::optional<ClassId> {
    if (!raster.contains(pixel.x(), pixel.y())) return std::nullopt;
    return raster.at(pixel.x(), pixel.y());
  };
  cell.seen = class_in(moment.topview.labels).value_or(kUnclassified);
  cell.at_estimate = class_in(moment.map_at_estimate);
  cell.at_truth = class_in(moment.map_at_truth);
  const double metres_per_cell =
      moment.step && moment.step->topview ? moment.step->topview->metres_per_cell : 0.0;
  cell.ahead_m = (moment.topview.body_row - pixel.y() - 0.5) * metres_per_cell;
  cell.left_m = (moment.topview.body_column - pixel.x() - 0.5) * metres_per_cell;
  return cell;
}

std::vector<std::string> seen_cell_words(const SeenCell& cell) {
  const auto name = [](ClassId id) { return std::string(class_info(id).name); };
  std::vector<std::string> words;
  words.push_back(cell.seen == kUnclassified ? "nothing was seen here" : "saw " + name(cell.seen));
  if (cell.at_estimate) words.push_back("map at the estimate: " + name(*cell.at_estimate));
  if (cell.at_truth) words.push_back("map at the truth: " + name(*cell.at_truth));
  words.push_back(fmt::format("{} m {}, {} m to the {}", metres_text(std::abs(cell.ahead_m), 1),
                              cell.ahead_m < 0.0 ? "behind" : "ahead",
                              metres_text(std::abs(cell.left_m), 1),
                              cell.left_m < 0.0 ? "right" : "left"));
  return words;
}

std::string_view camera_kind_name(CameraKind kind) {
  constexpr std::array<std::string_view, 4> kNames = {"image", "labels", "depth", "confidence"};
  return kNames.at(static_cast<std::size_t>(kind));
}

bool has_kind(const CameraMoment& camera, CameraKind kind) {
  switch (kind) {
    case CameraKind::kImage:
      return !camera.image.empty();
    case CameraKind::kLabels:
      return !camera.labels.empty();
    case CameraKind::kDepth:
      return !camera.depth_m.empty();
    case CameraKind::kConfidence:
      break;
  }
  return false;
}

Raster<Rgba> label_picture(const Raster<ClassId>& labels) {
  Raster<Rgba> picture = class_picture(labels);
  for (Rgba& pixel : picture.values()) {
    if (pixel.alpha == 0) pixel = {0, 0, 0};
  }
  return picture;
}

Raster<Rgba> camera_picture(const CameraMoment& camera, double label_opacity) {
  const Raster<ClassId>& labels = camera.labels;
  if (camera.image.empty()) return label_picture(labels);
  Raster<Rgba> picture = colour_picture(camera.image);
  if (labels.empty() || !(label_opacity > 0.0)) return picture;
  const double share = std::min(label_opacity, 1.0);
  for (int row = 0; row < picture.height(); ++row) {
    const int label_row = row * labels.height() / picture.height();
    for (int column = 0; column < picture.width(); ++column) {
      const Rgba label =
          class_colour(labels.at(column * labels.width() / picture.width(), label_row));
      if (label.alpha == 0) continue;
      Rgba& pixel = picture.at(column, row);
      pixel.red = mixed_channel(pixel.red, label.red, share);
      pixel.green = mixed_channel(pixel.green, label.green, share);
      pixel.blue = mixed_channel(pixel.blue, label.blue, share);
    }
  }
  return picture;
}

Raster<Rgba> depth_picture(const Raster<float>& depth_m) {
  constexpr double kNearM = 0.5, kFarM = 100.0;
  Raster<Rgba> picture(depth_m.width(), depth_m.height(), {0, 0, 0, 0});
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    const double depth = depth_m.values()[i];
    if (!(depth > 0.0) || !std::isfinite(depth)) continue;
    const double share = 1.0 - std::log(depth / kNearM) / std::log(kFarM / kNearM);
    picture.values()[i] = value_colour(ValueColours::kViridis, share);
  }
  return picture;
}

const Picture& CameraPictureCache::of(const std::shared_ptr<const CameraMoment>& camera,
                                      CameraKind kind,
                                      double label_opacity) {
  const auto& shown = camera ? camera : camera_;
  if (!shown) return picture_;
  if (shown == camera_ && kind == kind_ && label_opacity == label_opacity_) return picture_;
  switch (kind) {
    case CameraKind::kImage:
      picture_ = picture_of(camera_picture(*shown, label_opacity), true);
      break;
    case CameraKind::kLabels:
      picture_ = picture_of(label_picture(shown->labels));
      break;
    case CameraKind::kDepth:
      picture_ = picture_of(depth_picture(shown->depth_m));
      break;
    case CameraKind::kConfidence:
      picture_ = {};
      break;
  }
  camera_ = shown;
  kind_ = kind;
  label_opacity_ = label_opacity;
  return picture_;
}

void CameraPictureCache::clear() { *this = CameraPictureCache(); }

}  // namespace nadir
