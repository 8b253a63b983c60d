// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/flight/flight_recording.h"
#include "core/map/overhead_map_file.h"

namespace nadir {

/// A frame as its files will hold it. Encoding is a pure function, so that many frames can be
/// encoded at once.
struct EncodedFrame {
  double time_s = 0.0;
  std::vector<std::uint8_t> labels_png;  ///< 8 bit, class ids.
  std::vector<std::uint8_t>
      depth_png;  ///< 16 bit, millimetres, 0 = none; beyond 65.535 m counts as none.
  std::vector<std::uint8_t> image_jpeg = {};  ///< What the camera saw; may be empty.
};
/// @param image  What the camera saw, where that is known, in any size.
/// @errors kMalformed: a time that is not finite, no labels, another size of depth, ids that are no
/// class, an image without pixels; kIo: an encoder gave up.
[[nodiscard]] Result<EncodedFrame> encode_frame(
    const SemanticFrame& frame, const std::optional<ColourRaster>& image = std::nullopt);

/// Writes a native flight folder (core/flight/README.md). Nothing stands under the flight's own
/// name before finish().
class FlightWriter {
 public:
  /// Name, camera, body_from_camera, altitude and truth origin are taken from `description`; its
  /// frames and trajectories are not. `provenance` is one sentence for flight.toml.
  ///
  /// A flight that stands there already is replaced only by the `generator` that its flight.toml
  /// names: what a program made up it can make again, but a recording is never replaced, and a
  /// recorder, whose generator is empty, replaces nothing.
  /// @errors kIo: the folder cannot be made, or holds something else or another's flight.
  [[nodiscard]] static Result<FlightWriter> create(const std::filesystem::path& folder,
                                                   const FlightDescription& description,
                                                   const std::string& provenance,
                                                   const std::string& generator = {});
  FlightWriter(FlightWriter&&) noexcept;
  ~FlightWriter();

  /// Frames must come in order of time. Those without an image are left out of rgb.txt; a flight
  /// without any has no rgb.txt. @errors kMalformed (order, sizes, no PNG or JPEG), kIo (disk
  /// full).
  [[nodiscard]] Result<void> write(const EncodedFrame& frame);
  /// Writes lists, trajectories and flight.toml, and gives the folder its name. @errors kIo: as
  /// above, also where something else has come to stand there meanwhile.
  [[nodiscard]] Result<void> finish(const std::optional<Trajectory>& odometry,
                                    const std::optional<Trajectory>& truth);

 private:
  struct Implementation;
  explicit FlightWriter(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir
