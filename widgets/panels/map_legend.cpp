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

/// Whether any step of a run lets this be said of it; of most runs the first one does.
template <typename Claim>
bool has_step(const RunDocument& run, const Claim& claim) {
  return std::any_of(run.steps.begin(), run.steps.end(), claim);
}

class LegendMaker {
 public:
  /// @param seen  Null: what any step of the runs has counts as there, and of classes those of the map.
  LegendMaker(const MapViewModel& model,
              const std::vector<int>& shown,
              const SeenClasses* seen,
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
    const auto lays_cells = [&model](const RunStep& step) {
      return step.topview_cells > 0 && pose_of(step, model.look.topview_at).has_value();
    };
    if (seen == nullptr) {
      has_particles_ =
          has_step(*leader.document, [](const RunStep& step) { return step.particle_count > 0; });
      has_topview_ = has_step(*leader.document, lays_cells);
    } else if (leader.is_active) {
      has_particles_ = decoded != nullptr && decoded->particles && !decoded->particles->empty();
      has_topview_ = decoded != nullptr && lays_topview(*decoded, model.look.topview_at);
    } else if (leader.step) {
      const RunStep& step = leader.document->steps[*leader.step];
      has_particles_ = step.particle_count > 0;
      has_topview_ = lays_cells(step);
    }
  }

  std::vector<LegendEntry> make(bool with_classes) {
    if (!runs_.empty()) {
      add_lines(*runs_.back());
      add_particles(*runs_.back());
    }
    add_agreement();
    add_costs();
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
    if (leader.is_active && seen_ != nullptr) {
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

  void add_costs() {
    if (!shows(Layer::kErrorSurface) || runs_.empty() || !runs_.back()->is_active) return;
    if (!model_.surface_costs && seen_ != nullptr) return;
    const CostRange costs =
        model_.surface_costs && seen_ != nullptr ? *model_.surface_costs : CostRange{0.0F, 1.0F};
    entries_.push_back({fmt::format("cost {:.2f} to {:.2f}", costs.most, costs.least), theme_.text,
                        LegendEntry::Kind::kRamp});
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
    for (ClassId id = 0; shows_seen && seen_ != nullptr && id < kClassCount; ++id) {
      is_there.at(id) = is_there.at(id) || seen_->is_seen.at(id);
    }
    for (ClassId id = 0; id < kClassCount; ++id) {
      if (!is_there.at(id) || class_colour(id).alpha == 0) continue;
      entries_.push_back(legible_entry(
          {std::string(class_info(id).name), class_colour(id), LegendEntry::Kind::kBar}, theme_));
    }
  }

  const MapViewModel& model_;
  const SeenClasses* seen_;
  const Theme& theme_;
  std::vector<const MapRun*> runs_;
  bool has_particles_ = false, has_topview_ = false;
  std::vector<LegendEntry> entries_;
};

}  // namespace

std::vector<LegendEntry> map_legend(const MapViewModel& model,
                                    const std::vector<int>& shown,
                                    const SeenClasses& seen,
                                    const Theme& theme,
                                    bool with_classes) {
  return LegendMaker(model, shown, &seen, theme).make(with_classes);
}

std::vector<LegendEntry> lasting_map_legend(const MapViewModel& model,
                                            const std::vector<int>& shown,
                                            const Theme& theme,
                                            bool with_classes) {
  return LegendMaker(model, shown, nullptr, theme).make(with_classes);
}

void SeenClasses::add(const std::string& of_run, const RunStep& step) {
  if (of_run != run) *this = {of_run, {}};
  if (!step.topview) return;
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (!step.topview->of_class(id).empty()) is_seen.at(id) = true;
  }
}

}  // namespace nadir
