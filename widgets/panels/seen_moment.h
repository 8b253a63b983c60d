// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/map/map_index.h"
#include "core/mcl/cell_agreement.h"
#include "core/run/run_file.h"
#include "core/session/step_cache.h"
#include "widgets/panels/picture.h"
#include "widgets/views/theme.h"

namespace nadir {

/// What was seen in a step beside what the map has there: pictures of one raster, whose row 0 is farthest ahead.
struct SeenMoment {
  std::shared_ptr<const RunStep> step;
  std::shared_ptr<const MapIndex> map;
  ThemeName theme = ThemeName::kDark;

  std::string why_not;  ///< In a few words, where there are no pictures; empty: there are.
  TopviewRaster topview;
  CellAgreement at_estimate;  ///< Empty without a map.
  std::optional<CellAgreement> at_truth;
  Raster<ClassId> map_at_estimate, map_at_truth;  ///< Empty where not known.
  Picture seen_picture, agreement_picture, estimate_picture, truth_picture;
};

/// Keeps the pictures of the last step that was decoded, so that nothing flickers until the next one is.
class SeenMomentCache {
 public:
  /// @param step  Null: not decoded yet, the last one stays. @param map  May be null.
  const SeenMoment& of(const std::shared_ptr<const RunStep>& step,
                       const std::shared_ptr<const MapIndex>& map,
                       ThemeName theme);

 private:
  SeenMoment last_;
};

/// What there is to say of one cell of the pictures: what was seen, and what the map has there.
struct SeenCell {
  ClassId seen = kUnclassified;
  std::optional<ClassId> at_estimate, at_truth;
  double ahead_m = 0.0, left_m = 0.0;  ///< Of the cell's centre from the body.
};
/// @param pixel  Column and row of the pictures.
[[nodiscard]] SeenCell seen_cell(const SeenMoment& moment, const Eigen::Vector2i& pixel);
/// Its lines for a tooltip: "saw road", "map at the estimate: sidewalk" ...
[[nodiscard]] std::vector<std::string> seen_cell_words(const SeenCell& cell);

/// How camera frames are shown.
enum class CameraKind { kImage, kLabels, kDepth, kConfidence };
/// What a kind shows: "image", "labels", "depth", "confidence".
[[nodiscard]] std::string_view camera_kind_name(CameraKind kind);
/// Whether a frame has what a kind shows. No flight format has a confidence yet.
[[nodiscard]] bool has_kind(const CameraMoment& camera, CameraKind kind);

/// Pictures of the last camera frame, made again when frame, kind or opacity change.
class CameraPictureCache {
 public:
  /// @param camera  Null: not decoded yet, the last picture stays. @param label_opacity  In [0, 1].
  const Picture& of(const std::shared_ptr<const CameraMoment>& camera,
                    CameraKind kind,
                    double label_opacity);
  void clear();

 private:
  std::shared_ptr<const CameraMoment> camera_;
  CameraKind kind_ = CameraKind::kImage;
  double label_opacity_ = -1.0;
  Picture picture_;
};

/// Each class in its colour; black where there is none.
[[nodiscard]] Raster<Rgba> label_picture(const Raster<ClassId>& labels);
/// The image with the labels over it, or the labels alone where there is no image; empty where there is neither.
[[nodiscard]] Raster<Rgba> camera_picture(const CameraMoment& camera, double label_opacity);
/// Near is light, far is dark, on a logarithmic scale from 0.5 to 100 m; clear where there is no depth.
[[nodiscard]] Raster<Rgba> depth_picture(const Raster<float>& depth_m);

}  // namespace nadir
