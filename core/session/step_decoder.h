// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "core/base/result.h"
#include "core/session/step_cache.h"

namespace nadir::detail {

/// Reads whole steps of a run. For one thread.
class StepDecoder {
 public:
  /// One step as it is in the file, opened once as long as the run's number stays the same.
  /// @param run_number  Another one for another file, even one of the same name.
  /// @errors as RunReader; kMalformed: "R.nadir: has changed since it was opened", where the file's step is another one
  /// than the document's; kIo for an exception of a library.
  [[nodiscard]] Result<std::shared_ptr<const RunStep>> read(const RunDocument& document,
                                                            std::size_t run_number,
                                                            std::size_t index);

 private:
  std::optional<RunReader> reader_;
  std::size_t reader_run_number_ = 0;
};

/// All that a flight has of a frame. @errors as read_colour_image and FlightRecording::load; kIo for an exception.
[[nodiscard]] Result<std::shared_ptr<const CameraMoment>> read_camera(const FlightRecording& flight,
                                                                      std::size_t frame);

/// Whether there is anything to show of a frame.
[[nodiscard]] bool has_picture_or_cloud(const FlightFrame& frame);

/// What they take in memory.
[[nodiscard]] std::size_t bytes_of(const RunStep& step);
[[nodiscard]] std::size_t bytes_of(const CameraMoment& moment);

}  // namespace nadir::detail
