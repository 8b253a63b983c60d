// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/panels/picture_area.h"
#include "widgets/views/mode_marks.h"

namespace nadir {
namespace {

constexpr double kFaint = 0.5;    ///< Of what lies ahead of now.
constexpr double kPosePt = 13.0;  ///< Length of an arrowhead.
constexpr double kPlate = 0.85;
constexpr double kOuterSigmas = 0.85;  ///< Opacity of the second and third ellipse.

const std::vector<Eigen::Vector2d>& points_of(const RunPaths& paths, PoseSource source) {
  switch (source) {
    case PoseSource::kTruth:
      return paths.truth;
    case PoseSource::kOdometry:
      return paths.odometry;
    case PoseSource::kEstimate:
      break;
  }
  return paths.estimate;
}

/// What lies ahead of now faintly, what lies behind in full.
void draw_trail(Canvas& canvas,
                const MapFrame& frame,
                std::span<const Eigen::Vector2d> points,
                std::optional<std::size_t> now,
                const PathLook& look) {
  if (points.empty()) return;
  const std::size_t split = now ? std::min(*now, points.size() - 1) : 0;
  PathLook faint = look;
  faint.colour = faded(look.colour, kFaint);
  faint.casing = faded(look.casing, 0.8 * kFaint);
  faint.width_pt = 0.75 * look.width_pt;
  faint.is_dashed = false;
  faint.casing_pt = 0.4;
  stroke_paths(canvas, screen_paths(points.subspan(split), frame.camera, frame.where), faint,
               frame.px_per_pt);
  if (!now) return;
  stroke_paths(canvas, screen_paths(points.first(split + 1), frame.camera, frame.where), look,
               frame.px_per_pt);
}

class MapLines {
 public:
  explicit MapLines(const MapDrawing& drawing)
      : canvas_(drawing.canvas),
        frame_(drawing.frame),
        model_(drawing.model),
        paths_(drawing.paths),
        theme_(drawing.theme) {
    for (const MapRun& run : model_.runs) {
      const bool is_shown =
          std::find(drawing.shown.begin(), drawing.shown.end(), run.number) != drawing.shown.end();
      if (run.document && is_shown) runs_.push_back(&run);
    }
  }

  void draw_layer(Layer layer) {
    switch (layer) {
      case Layer::kOdometry:
        return draw_paths(PoseSource::kOdometry);
      case Layer::kTruth:
        return draw_paths(PoseSource::kTruth);
      case Layer::kEstimate:
        return draw_paths(PoseSource::kEstimate);
      case Layer::kEllipses:
        return draw_all_ellipses();
      case Layer::kModes:
        return draw_active_modes();
      default:
        return;  // the graticule, the ground, and the legend, which lies above all
    }
  }
  void draw_marks() {
    draw_poses();
    draw_bookmarks();
  }

 private:
  /// Truth and odometry belong to the flight: they are drawn once, of the active run or the first one shown.
  [[nodiscard]] const MapRun* leader() const { return runs_.empty() ? nullptr : runs_.back(); }

  void draw_paths(PoseSource source) {
    for (const MapRun* run : runs_) {
      if (source != PoseSource::kEstimate && run != leader()) continue;
      draw_trail(canvas_, frame_, points_of(paths_.of(run->document), source), run->step,
                 run_path_look(model_, *run, source, theme_));
    }
  }

  void draw_all_ellipses() {
    static constexpr std::array<double, 3> kSigmas = {3.0, 2.0, 1.0};
    static constexpr std::array<double, 2> kFewSigmas = {3.0, 1.0};
    for (const MapRun* run : runs_) {
      if (!run->step) continue;
      const PoseMoments& moments = run->document->steps[*run->step].estimate.moments;
      PathLook look = run_path_look(model_, *run, PoseSource::kEstimate, theme_);
      const LayerLook& layer = model_.look.layer(Layer::kEllipses);
      const auto own = layer.colour ? colour_from_hex(*layer.colour) : std::nullopt;
      if (own && run->is_active) look.colour = *own;
      look.colour = faded(look.colour, layer.opacity);
      look.casing = faded(look.casing, layer.opacity);
      look.is_dashed = false;
      look.width_pt = 1.2;
      look.casing_pt = 0.8;
      draw_ellipses(
          canvas_, frame_, moments.mean.translation_m(), moments.covariance.topLeftCorner<2, 2>(),
          run->is_active ? std::span<const double>(kSigmas) : kFewSigmas, look, kOuterSigmas);
    }
  }

  /// A single mode is where the estimate is.
  void draw_active_modes() {
    const MapRun* const run = leader();
    if (run == nullptr || !run->step) return;
    const std::vector<PoseMode>& modes = run->document->steps[*run->step].estimate.modes;
    if (modes.size() < 2) return;
    ModeLook look;
    look.arrow = run_path_look(model_, *run, PoseSource::kEstimate, theme_);
    const LayerLook& layer = model_.look.layer(Layer::kModes);
    if (const auto own = layer.colour ? colour_from_hex(*layer.colour) : std::nullopt) {
      look.arrow.colour = *own;
    }
    look.arrow.colour = faded(look.arrow.colour, layer.opacity);
    look.arrow.casing = faded(look.arrow.casing, layer.opacity);
    look.words.colour = faded(theme_.text, layer.opacity);
    look.words.face = FontFace::kNumbers;
    look.words_pt = 8.0;
    look.plate = with_opacity(theme_.page, kPlate * layer.opacity);
    draw_modes(canvas_, frame_, modes, look);
  }

  void draw_poses() {
    for (const MapRun* run : runs_) {
      if (!run->step) continue;
      const RunStep& step = run->document->steps[*run->step];
      for (const PoseSource source :
           {PoseSource::kOdometry, PoseSource::kTruth, PoseSource::kEstimate}) {
        const bool is_of_flight = source != PoseSource::kEstimate;
        if ((is_of_flight && run != leader()) ||
            !model_.look.layer(layer_of_source(source)).is_visible) {
          continue;
        }
        const auto pose = pose_of(step, source);
        if (!pose) continue;
        PathLook look = run_path_look(model_, *run, source, theme_);
        look.casing_pt = 0.9;
        draw_pose(canvas_, frame_, *pose, source == PoseSource::kEstimate ? kPosePt : 0.8 * kPosePt,
                  look);
      }
    }
  }

  /// A small diamond on the estimate's way.
  void draw_bookmarks() {
    const double half = 4.5 * frame_.px_per_pt;
    for (const MapRun* run : runs_) {
      for (const Eigen::Vector2d& place : run->bookmarks_in_enu_m) {
        if (!place.allFinite()) continue;
        const Eigen::Vector2d at = frame_.page(place);
        const std::array<Eigen::Vector2d, 4> diamond = {
            at + Eigen::Vector2d(half, 0.0), at + Eigen::Vector2d(0.0, half),
            at - Eigen::Vector2d(half, 0.0), at - Eigen::Vector2d(0.0, half)};
        canvas_.fill(diamond, theme_.accent);
        const std::array<Eigen::Vector2d, 6> rim = {diamond[0], diamond[1], diamond[2],
                                                    diamond[3], diamond[0], diamond[1]};
        canvas_.stroke(rim, {with_opacity(theme_.page, 0.95), 1.2 * frame_.px_per_pt});
      }
    }
  }

  Canvas& canvas_;
  const MapFrame& frame_;
  const MapViewModel& model_;
  RunPathsCache& paths_;
  const Theme& theme_;
  std::vector<const MapRun*> runs_;
};

}  // namespace

void draw_map_layer(const MapDrawing& drawing, Layer layer) {
  if (layer == Layer::kGraticule) return draw_map_grid(drawing, false);
  MapLines(drawing).draw_layer(layer);
}

void draw_map_poses(const MapDrawing& drawing) { MapLines(drawing).draw_marks(); }

}  // namespace nadir
