// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/flight/flight_recording.h"
#include "core/map/map_index.h"
#include "core/run/localise_flight.h"

namespace nadir {

/// A flight as if nobody knew one class: its pixels are unclassified.
/// @param flight  Not null.
[[nodiscard]] std::shared_ptr<const FlightRecording> flight_without_class(
    std::shared_ptr<const FlightRecording> flight, ClassId id);

/// A map as if nobody knew one class: its cells are unclassified.
[[nodiscard]] std::shared_ptr<const MapIndex> map_without_class(const OverheadMap& map, ClassId id);

/// Which flight to localise without each class.
struct ImportanceTask {
  std::shared_ptr<const FlightRecording> flight;  ///< Not null.
  std::shared_ptr<const MapIndex> map;            ///< Not null.
  RunOptions options;
  std::optional<Prior>
      prior;  ///< Without one, the truth of the first frame. None where it resumes.
  std::optional<ResumePoint> resume_after;  ///< Begin with recorded particles instead.
  std::optional<double> to_s;  ///< Last moment, as FlightFrame::time_s; without, the flight's end.
  std::vector<std::uint64_t> seeds = {1, 2, 3, 4, 5};
  std::vector<ClassId> classes;  ///< Empty: all that the map holds.
};

/// Mean of values of several seeds, and how sure it is.
struct SeedMean {
  double mean = 0.0;
  /// Of the mean, from the spread between seeds: s / sqrt(n). Nothing for a single one.
  std::optional<double> standard_error;
  /// Whether it differs from 0 by more than chance lets it 95 times in 100 (Student's t, two-sided).
  [[nodiscard]] bool is_more_than_chance() const;
  int seeds = 0;
};
[[nodiscard]] SeedMean mean_over_seeds(const std::vector<double>& values);

/// How the flight went.
struct LocalisedQuality {
  SeedMean error_m;  ///< Mean distance to the truth. 0 seeds where no truth is known.
  SeedMean
      sigma_m;  ///< What the filter thinks of it: square root of the covariance's trace in the plane, mean over the steps.
  SeedMean lost_share;  ///< Of the steps, more than kLostM from the truth.
};
inline constexpr double kLostM = 5.0;

/// What leaving a class out does.
struct ClassImportance {
  ClassId id = 0;
  double weight = 0.0;  ///< alpha_k on the map with all classes.
  double share = 0.0;   ///< Of the map's classified cells.
  LocalisedQuality without;
  /// Without minus with, seed by seed, so that what a seed does to both cancels; above 0: the class helps.
  SeedMean error_change_m, sigma_change_m;
};

struct ImportanceTable {
  LocalisedQuality with_all;
  std::vector<ClassImportance> classes;  ///< Those that are done, in the order asked for.
};

/// Localises the flight with all classes and then without each, from map and from what is seen alike, once a seed.
///
/// O((classes + 1) x seeds) runs of the filter, one after the other; each uses all threads. The same numbers on any number of them.
/// A class without which the map has fewer than two left cannot be left out: it is passed over.
/// @param publish  Called with all classes that are done; may be empty.
/// @errors kInvalidOptions: no seeds, no frames until `to_s`; as localise_flight; kCancelled.
[[nodiscard]] Result<ImportanceTable> class_importance(
    const ImportanceTask& task,
    const WorkContext& context = {},
    const std::function<void(const ImportanceTable&)>& publish = {});

}  // namespace nadir
