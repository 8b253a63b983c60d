// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/flight/flight_recording.h"
#include "core/map/map_index.h"
#include "core/map/overhead_map_file.h"
#include "core/session/bookmarks.h"
#include "core/session/run_document.h"
#include "core/session/step_cache.h"
#include "core/session/worst_moments.h"

namespace nadir {

/// A run that is open, or on its way.
struct OpenRun {
  std::string name;  ///< For people; differs between open runs.
  std::filesystem::path path;
  std::shared_ptr<const RunDocument> document;  ///< Nothing while it is being read.
  std::shared_ptr<StepCache> cache;             ///< Likewise.
  std::vector<WorstMoment> moments;
  std::vector<Bookmark> bookmarks;
  bool is_live = false;  ///< Being written by this program now, or its end is still to be read.
};

/// The map that is open, or on its way.
struct OpenMap {
  std::filesystem::path path;
  MapProvenance provenance;
  std::shared_ptr<const MapIndex> index;  ///< Nothing while it is being read.
  std::string hash;                       ///< content_hash() of it; empty while it is being read.
};

/// Playback: not undone, but kept from one start to the next.
struct Playback {
  double time_s = 0.0;  ///< After the active run's first step.
  bool is_playing = false;
  double speed = 1.0;
  std::optional<double> loop_from_s, loop_to_s;  ///< Both or none.
  friend bool operator==(const Playback&, const Playback&) = default;
};

inline constexpr double kLeastSpeed = 0.1, kMostSpeed = 20.0;

}  // namespace nadir
