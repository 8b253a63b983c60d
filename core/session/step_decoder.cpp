// SPDX-License-Identifier: Apache-2.0
#include "core/session/step_decoder.h"

#include <exception>
#include <utility>

#include "core/flight/colour_image.h"

namespace nadir::detail {
namespace {

/// Turns an exception of a library into an error. @param work  () -> Result<...>.
template <typename Work>
auto guarded(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::exception& error) {
    return fail(ErrorCode::kIo, "a moment could not be read: {}", error.what());
  }
}

Result<CameraMoment> camera_of(const FlightRecording& flight, std::size_t index) {
  const FlightFrame& frame = flight.description().frames.at(index);
  CameraMoment moment{index, frame.time_s, {}, {}, {}};
  if (frame.image) {
    auto image = read_colour_image(*frame.image);
    if (!image) return forward_error(image);
    moment.image = std::move(*image);
  }
  if (frame.labels && frame.depth) {
    auto pixels = flight.load(index);
    if (!pixels) return forward_error(pixels);
    moment.labels = std::move(pixels->labels);
    moment.depth_m = std::move(pixels->depth_m);
  }
  return moment;
}

}  // namespace

Result<std::shared_ptr<const RunStep>> StepDecoder::read(const RunDocument& document,
                                                         std::size_t run_number,
                                                         std::size_t index) {
  return guarded([&]() -> Result<std::shared_ptr<const RunStep>> {
    if (!reader_ || reader_run_number_ != run_number) {
      auto opened = RunReader::open(document.path);
      if (!opened) return forward_error(opened);
      reader_.reset();
      reader_.emplace(std::move(*opened));
      reader_run_number_ = run_number;
    }
    const RunStep& known = document.steps.at(index);
    auto step = reader_->step(known.step);
    if (!step) return forward_error(step);
    if (step->time_s != known.time_s ||
        !(step->estimate.moments.mean == known.estimate.moments.mean)) {
      return fail(ErrorCode::kMalformed, "{}: has changed since it was opened",
                  document.path.string());
    }
    return std::make_shared<const RunStep>(std::move(*step));
  });
}

Result<std::shared_ptr<const CameraMoment>> read_camera(const FlightRecording& flight,
                                                        std::size_t frame) {
  return guarded([&]() -> Result<std::shared_ptr<const CameraMoment>> {
    auto moment = camera_of(flight, frame);
    if (!moment) return forward_error(moment);
    return std::make_shared<const CameraMoment>(std::move(*moment));
  });
}

bool has_picture_or_cloud(const FlightFrame& frame) {
  return frame.image.has_value() || (frame.labels.has_value() && frame.depth.has_value());
}

std::size_t bytes_of(const RunStep& step) {
  std::size_t bytes = sizeof(RunStep) + step.estimate.modes.size() * sizeof(PoseMode);
  if (step.particles) bytes += step.particles->size() * 4 * sizeof(double);
  if (step.topview) bytes += step.topview->cells.size() * sizeof(TopviewCell);
  return bytes;
}

std::size_t bytes_of(const CameraMoment& moment) {
  return sizeof(CameraMoment) + moment.image.size() * sizeof(Colour) +
         moment.labels.size() * sizeof(ClassId) + moment.depth_m.size() * sizeof(float);
}

}  // namespace nadir::detail
