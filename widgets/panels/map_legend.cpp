// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// Whether a step's topview lies on the map where the user wants it.
bool lays_topview(const RunStep& step, PoseSource at) {
  return step.topview && !step.topview->cells.empty() && pose_of(step, at).has_value();
}

class LegendMaker {
 public:
  LegendMaker(const MapViewModel& model,
              const std::vector<int>& shown,
              const SeenClasses& seen,
              const Theme& theme)
      : model_(model), seen_(seen), theme_(theme) {
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

  /// Of the map, and those that topviews have shown up to now: the legend rests while topviews change, and only grows.
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
    }
    for (ClassId id = 0; shows_seen && id < kClassCount; ++id) {
      is_there.at(id) = is_there.at(id) || seen_.is_seen.at(id);
    }
    for (ClassId id = 0; id < kClassCount; ++id) {
      if (!is_there.at(id) || class_colour(id).alpha == 0) continue;
      entries_.push_back(legible_entry(
          {std::string(class_info(id).name), class_colour(id), LegendEntry::Kind::kBar}, theme_));
    }
  }

  const MapViewModel& model_;
  const SeenClasses& seen_;
  const Theme& theme_;
  std::vector<const MapRun*> runs_;
  bool has_particles_ = false, has_topview_ = false;
  std::vector<LegendEntry> entries_;
};

/// Rows of a legend, as draw_legend() breaks them.
struct LegendRows {
  double widest = 0.0;
  std::size_t count = 0;
};
LegendRows rows_within(const std::vector<double>& widths, double most, double px) {
  const double between = 12.0 * px;
  LegendRows rows;
  double row = 0.0;
  for (const double width : widths) {
    if (row > 0.0 && row + between + width > most) row = 0.0;
    if (row == 0.0) ++rows.count;
    row += (row > 0.0 ? between : 0.0) + width;
    rows.widest = std::max(rows.widest, row);
  }
  return rows;
}

double entry_width(const std::string& name, double px) {
  TextStyle style;
  style.size_px = kLegendTextPt * px;
  return 20.0 * px + measure_text(name, style).width;
}

std::string words_for_more(std::size_t left_out) { return fmt::format("and {} more", left_out); }

/// All of it, narrow if it can be, beside the scale bar, wider where it would be high; else as many entries as there is room
/// for, and how many there are more. No entries: not even the first one has room.
void fit_legend(LegendFit& fit, double padding) {
  constexpr double kWished = 0.28, kCut = 0.34, kMost = 0.45;  // of the map's height
  constexpr double kMostWidth = 0.72;
  const double px = fit.px_per_pt;
  std::vector<double> all;
  for (const std::string& name : fit.names) all.push_back(entry_width(name, px));
  for (fit.count = all.size(); fit.count > 0; --fit.count) {
    const std::size_t left_out = all.size() - fit.count;
    std::vector<double> widths(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(fit.count));
    if (left_out > 0) widths.push_back(entry_width(words_for_more(left_out), px));
    for (const double share : {0.5, 0.6, 0.7}) {
      fit.width = rows_within(widths, share * fit.map_width - 2.0 * padding, px).widest;
      fit.height = 13.0 * px * static_cast<double>(rows_within(widths, fit.width + px, px).count);
      if (fit.height <= kWished * fit.map_height) break;
    }
    // What is cut short is no reason to cover more of the map.
    const double most = left_out == 0 ? kMost : kCut;
    if (fit.height <= most * fit.map_height &&
        fit.width + 2.0 * padding <= kMostWidth * fit.map_width)
      return;
  }
}

/// Keeps what is of the same names on a map of the same size.
void renew_fit(LegendFit& fit,
               const std::vector<LegendEntry>& entries,
               const MapFrame& frame,
               double padding) {
  const bool is_same =
      fit.map_width == frame.where.width && fit.map_height == frame.where.height &&
      fit.px_per_pt == frame.px_per_pt &&
      std::equal(
          entries.begin(), entries.end(), fit.names.begin(), fit.names.end(),
          [](const LegendEntry& entry, const std::string& name) { return entry.name == name; });
  if (is_same) return;
  fit = {};
  for (const LegendEntry& entry : entries) fit.names.push_back(entry.name);
  fit.map_width = frame.where.width;
  fit.map_height = frame.where.height;
  fit.px_per_pt = frame.px_per_pt;
  fit_legend(fit, padding);
}

}  // namespace

std::vector<LegendEntry> map_legend(const MapViewModel& model,
                                    const std::vector<int>& shown,
                                    const SeenClasses& seen,
                                    const Theme& theme,
                                    bool with_classes) {
  return LegendMaker(model, shown, seen, theme).make(with_classes);
}

void SeenClasses::add(const std::string& of_run, const RunStep& step) {
  if (of_run != run) *this = {of_run, {}};
  if (!step.topview) return;
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (!step.topview->of_class(id).empty()) is_seen.at(id) = true;
  }
}

PageRect draw_map_legend(Canvas& canvas,
                         const MapFrame& frame,
                         const std::vector<LegendEntry>& entries,
                         const Theme& theme,
                         LegendFit& fit) {
  const double px = frame.px_per_pt;
  const PageRect& map = frame.where;
  const double padding = 5.0 * px;
  renew_fit(fit, entries, frame, padding);
  if (fit.count == 0) return {};
  std::vector<LegendEntry> shown(entries.begin(),
                                 entries.begin() + static_cast<std::ptrdiff_t>(fit.count));
  if (fit.count < entries.size()) {
    shown.push_back(
        {words_for_more(entries.size() - fit.count), {0, 0, 0, 0}, LegendEntry::Kind::kBar});
  }
  const PageRect plate{map.right() - fit.width - 2.0 * padding - 4.0 * px, map.bottom + 4.0 * px,
                       fit.width + 2.0 * padding, fit.height + 2.0 * padding};
  canvas.fill(corners_of(plate), with_opacity(theme.page, 0.85));
  draw_legend(canvas, {plate.left + padding, plate.bottom + padding, fit.width + px, fit.height},
              shown, theme, px);
  return plate;
}

}  // namespace nadir
