// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>

#include "core/session/map_parts.h"
#include "widgets/panels/map_lines.h"
#include "widgets/panels/picture_area.h"
#include "widgets/views/agreement_view.h"

namespace nadir {
namespace {

LegendEntry entry_of(const std::string& name, const PathLook& look) {
  return {name, look.colour, look.is_dashed ? LegendEntry::Kind::kDashed : LegendEntry::Kind::kLine,
          look.casing};
}

bool knows(const RunDocument& run, PoseSource source) {
  switch (source) {
    case PoseSource::kTruth:
      return run.has_truth();
    case PoseSource::kOdometry:
      return run.has_odometry;
    case PoseSource::kEstimate:
      break;
  }
  return !run.steps.empty();
}

bool are_alike(Rgba one, Rgba other) {
  constexpr int kHardlyApart = 50;  // of 255, in every channel
  return std::max({std::abs(one.red - other.red), std::abs(one.green - other.green),
                   std::abs(one.blue - other.blue)}) < kHardlyApart;
}

/// Whether a step's topview lies on the map where the user wants it.
bool lays_topview(const RunStep& step, PoseSource at) {
  return step.topview && !step.topview->cells.empty() && pose_of(step, at).has_value();
}

class LegendMaker {
 public:
  LegendMaker(const MapViewModel& model, const std::vector<int>& shown, const Theme& theme)
      : model_(model), theme_(theme) {
    for (const MapRun& run : model.runs) {
      if (run.document && std::find(shown.begin(), shown.end(), run.number) != shown.end()) {
        runs_.push_back(&run);
      }
    }
    // What is decoded is of the active run; of another one beside it there is as much as its step says.
    const RunStep* const decoded = model.step.get();
    if (runs_.empty()) return;
    const MapRun& leader = *runs_.back();
    if (leader.is_active) {
      has_particles_ = decoded != nullptr && decoded->particles && !decoded->particles->empty();
      has_topview_ = decoded != nullptr && lays_topview(*decoded, model.look.topview_at);
    } else if (leader.step) {
      const RunStep& step = leader.document->steps[*leader.step];
      has_particles_ = step.particle_count > 0;
      has_topview_ = step.topview_cells > 0 && pose_of(step, model.look.topview_at).has_value();
    }
  }

  std::vector<LegendEntry> make(bool with_classes) {
    if (!runs_.empty()) {
      add_lines(*runs_.back());
      add_particles(*runs_.back());
    }
    add_agreement();
    if (shows(Layer::kErrorSurface) && model_.surface_costs && !runs_.empty() &&
        runs_.back()->is_active) {
      const CostRange& costs = *model_.surface_costs;
      entries_.push_back({fmt::format("cost {:.2f} to {:.2f}", costs.most, costs.least),
                          theme_.text, LegendEntry::Kind::kRamp});
    }
    if (with_classes) add_classes();
    return std::move(entries_);
  }

 private:
  [[nodiscard]] bool shows(Layer layer) const { return is_in_sight(model_.look, layer); }

  void add_lines(const MapRun& leader) {
    for (const auto& [layer, source, name] :
         {std::tuple(Layer::kTruth, PoseSource::kTruth, "truth"),
          std::tuple(Layer::kOdometry, PoseSource::kOdometry, "odometry")}) {
      if (!shows(layer) || !knows(*leader.document, source)) continue;
      entries_.push_back(entry_of(name, run_path_look(model_, leader, source, theme_)));
    }
    if (shows(Layer::kEstimate)) {
      for (auto run = runs_.rbegin(); run != runs_.rend(); ++run) {
        entries_.push_back(entry_of(runs_.size() == 1 ? "estimate" : (*run)->name,
                                    run_path_look(model_, **run, PoseSource::kEstimate, theme_)));
      }
    }
    if (shows(Layer::kEllipses)) {
      const PathLook look = run_path_look(model_, leader, PoseSource::kEstimate, theme_);
      entries_.push_back({"1, 2, 3 sigma", look.colour, LegendEntry::Kind::kRings, look.casing});
    }
  }

  void add_particles(const MapRun& leader) {
    if (!shows(Layer::kParticles) || !has_particles_) return;
    const Rgba casing = particle_casing(theme_, has_ground_picture(model_));
    bool have_weights = false;
    if (leader.is_active) {
      const std::vector<double>& weights = model_.step->particles->weight;
      have_weights = std::any_of(weights.begin(), weights.end(),
                                 [&](double weight) { return weight != weights.front(); });
    }
    // Of one name, so that the legend rests while resampling comes and goes.
    entries_.push_back({"particles", value_colour(ValueColours::kViridis, kEqualWeightShare),
                        have_weights ? LegendEntry::Kind::kParticles : LegendEntry::Kind::kParticle,
                        casing});
  }

  void add_agreement() {
    if (!shows(Layer::kDisagreement) || !has_topview_ || !model_.map) return;
    entries_.push_back({"agrees", theme_.agreement, LegendEntry::Kind::kBar});
    entries_.push_back({"disagrees", theme_.disagreement, LegendEntry::Kind::kStripedBar,
                        disagreement_stripe(theme_)});
    entries_.push_back(
        {"unknown to the map", theme_.line, LegendEntry::Kind::kOutlinedBar, theme_.muted});
  }

  /// Of the map where there is one, so that the legend rests while topviews change.
  void add_classes() {
    // Labels lie in the place of a picture that there is not.
    const bool shows_labels =
        model_.map && (shows(Layer::kLabels) || (!model_.has_picture && shows(Layer::kPicture)));
    const bool shows_seen = (has_topview_ && shows(Layer::kTopview)) ||
                            (!runs_.empty() && shows(Layer::kReconstruction));
    if (!shows_labels && !shows_seen) return;
    std::array<bool, kClassCount> is_there{};
    if (model_.map) {
      for (ClassId id = 0; id < kClassCount; ++id) {
        is_there.at(id) = model_.map->statistics().cells.at(id) > 0;
      }
    } else if (model_.step && model_.step->topview) {
      for (ClassId id = 0; id < kClassCount; ++id) {
        is_there.at(id) = !model_.step->topview->of_class(id).empty();
      }
    }
    for (ClassId id = 0; id < kClassCount; ++id) {
      if (!is_there.at(id) || class_colour(id).alpha == 0) continue;
      // What is as dark or as light as the plate has an outline.
      const bool is_hard_to_see = are_alike(class_colour(id), theme_.page);
      entries_.push_back(
          {std::string(class_info(id).name), class_colour(id),
           is_hard_to_see ? LegendEntry::Kind::kOutlinedBar : LegendEntry::Kind::kBar,
           is_hard_to_see ? theme_.muted : Rgba{0, 0, 0, 0}});
    }
  }

  const MapViewModel& model_;
  const Theme& theme_;
  std::vector<const MapRun*> runs_;
  bool has_particles_ = false, has_topview_ = false;
  std::vector<LegendEntry> entries_;
};

/// How wide the longest row is where rows are broken at a width.
double widest_row(const std::vector<LegendEntry>& entries, double most, double px) {
  TextStyle style;
  style.size_px = 8.5 * px;
  double widest = 0.0;
  double row = 0.0;
  for (const LegendEntry& entry : entries) {
    const double width = 20.0 * px + measure_text(entry.name, style).width;
    if (row > 0.0 && row + 12.0 * px + width > most) row = 0.0;
    row += (row > 0.0 ? 12.0 * px : 0.0) + width;
    widest = std::max(widest, row);
  }
  return widest;
}

/// What of a legend has room on a map: all of it, narrow if it can be, beside the scale bar, wider where it would be high;
/// else as many entries as there is room for, and how many there are more. No entries: not even the first one has room.
struct LegendFit {
  std::vector<LegendEntry> entries;
  double width = 0.0, height = 0.0;
};

LegendFit fit_legend(const std::vector<LegendEntry>& entries,
                     const PageRect& map,
                     double padding,
                     double px) {
  constexpr double kWished = 0.28, kCut = 0.34, kMost = 0.45;  // of the map's height
  constexpr double kMostWidth = 0.72;
  LegendFit fit{entries, 0.0, 0.0};
  for (std::size_t left_out = 0; !fit.entries.empty(); ++left_out) {
    if (left_out > 0) {
      if (left_out > 1) fit.entries.pop_back();  // how many they were
      if (fit.entries.empty()) break;
      fit.entries.pop_back();
      if (fit.entries.empty()) break;
      fit.entries.push_back(
          {fmt::format("and {} more", left_out), {0, 0, 0, 0}, LegendEntry::Kind::kBar});
    }
    for (const double share : {0.5, 0.6, 0.7}) {
      fit.width = widest_row(fit.entries, share * map.width - 2.0 * padding, px);
      fit.height = legend_height(fit.width + px, fit.entries, px);
      if (fit.height <= kWished * map.height) break;
    }
    // What is cut short is no reason to cover more of the map.
    const double most = left_out == 0 ? kMost : kCut;
    if (fit.height <= most * map.height && fit.width + 2.0 * padding <= kMostWidth * map.width) {
      return fit;
    }
  }
  return {};
}

}  // namespace

std::vector<LegendEntry> map_legend(const MapViewModel& model,
                                    const std::vector<int>& shown,
                                    const Theme& theme,
                                    bool with_classes) {
  return LegendMaker(model, shown, theme).make(with_classes);
}

PageRect draw_map_legend(Canvas& canvas,
                         const MapFrame& frame,
                         const std::vector<LegendEntry>& entries,
                         const Theme& theme) {
  const double px = frame.px_per_pt;
  const PageRect& map = frame.where;
  const double padding = 5.0 * px;
  const LegendFit fit = fit_legend(entries, map, padding, px);
  if (fit.entries.empty()) return {};
  const PageRect plate{map.right() - fit.width - 2.0 * padding - 4.0 * px, map.bottom + 4.0 * px,
                       fit.width + 2.0 * padding, fit.height + 2.0 * padding};
  canvas.fill(corners_of(plate), with_opacity(theme.page, 0.85));
  draw_legend(canvas, {plate.left + padding, plate.bottom + padding, fit.width + px, fit.height},
              fit.entries, theme, px);
  return plate;
}

}  // namespace nadir
