// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/flight/flight_recording.h"
#include "core/map/overhead_map_file.h"
#include "core/run/run_file.h"
#include "core/session/run_document.h"

namespace nadir {

namespace detail {
class CacheWorker;
}  // namespace detail

/// What the camera saw at one frame of a flight. Parts that the flight does not have are empty.
struct CameraMoment {
  std::size_t frame = 0;  ///< Index in FlightDescription::frames.
  double clock_s = 0.0;   ///< The recording's clock.
  ColourRaster image;     ///< Any size.
  Raster<ClassId> labels;
  Raster<float>
      depth_m;  ///< Along the optical axis; what is not above 0 and finite means "no depth here".
};

/// Where somebody looks, and where they will look next.
struct Cursor {
  std::size_t index = 0;  ///< In RunDocument::steps.
  int direction = 1;      ///< 1: later steps come next, -1: earlier ones.
  bool is_playing = false;
  bool with_camera = true;  ///< Whether anything on the screen shows camera frames.
  friend bool operator==(const Cursor&, const Cursor&) = default;
};

/// Decodes the particles, topviews and camera frames of one run around a cursor, in a thread of its own.
///
/// request() never waits. The thread takes the step at the cursor first, then its camera frame, then what comes next: in
/// the direction of play many steps ahead and a few behind, at rest as many on either side. A newer request counts from
/// the item that is being decoded on, so one that scrubs sees each step it rests on after one item at most. What does not
/// fit into the budget is dropped, the least useful first: farthest away, where in play what is behind counts three times.
/// Calls come from one thread, the owner's; the results are shared and stay valid when they are dropped.
class StepCache {
 public:
  /// Opens its own connection to the run's file in the thread. @param document  Not null.
  /// @param flight  Null where there is none or where it is not open yet; its load() is called from the thread.
  explicit StepCache(std::shared_ptr<const RunDocument> document,
                     std::shared_ptr<const FlightRecording> flight = nullptr,
                     std::size_t budget_bytes = 192U << 20U);
  StepCache(StepCache&&) noexcept;
  StepCache& operator=(StepCache&&) noexcept;
  ~StepCache();

  /// The run as it has grown. What is decoded stays, unless another file has taken the run's name. @param document  Not null.
  void set_document(std::shared_ptr<const RunDocument> document);
  void set_flight(std::shared_ptr<const FlightRecording> flight);
  /// At least the items at the cursor are kept, however large they are.
  void set_budget_bytes(std::size_t bytes);

  /// Newest wins; the same request again costs nothing. An index past the end means the last step.
  void request(const Cursor& cursor);

  /// The step with its particles and topview where recorded; null where it is not decoded (yet).
  [[nodiscard]] std::shared_ptr<const RunStep> step(std::size_t index) const;
  /// The decoded step nearest to the index, to show until the right one is there; null where none is.
  /// @param reach  In steps, at most.
  [[nodiscard]] std::shared_ptr<const RunStep> nearest_step(std::size_t index,
                                                            std::size_t reach = 10) const;

  /// The camera frame of a step: the nearest in time of those with a picture, or else labels and depth, within a tenth of
  /// a second. Nothing where there is no flight or no such frame.
  [[nodiscard]] std::optional<std::size_t> frame_of(std::size_t index) const;
  /// Null where the step has no frame or where it is not decoded (yet).
  [[nodiscard]] std::shared_ptr<const CameraMoment> camera(std::size_t index) const;

  [[nodiscard]] std::size_t used_bytes() const;
  [[nodiscard]] std::size_t budget_bytes() const;
  /// Everything that the last request asks for and that fits is there, or has failed.
  [[nodiscard]] bool is_idle() const;
  /// Whether the step and the frame at the cursor are there, or have failed.
  [[nodiscard]] bool is_cursor_ready() const;
  /// For scripts and tests, which may wait. @returns is_idle().
  bool wait_until_idle(std::chrono::milliseconds most) const;

  /// Why items are missing, each reason once in the life of the cache. What failed is tried again when the run has grown.
  [[nodiscard]] std::vector<Error> take_errors();

 private:
  std::unique_ptr<detail::CacheWorker> worker_;
};

}  // namespace nadir
