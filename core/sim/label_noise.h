// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/flight/flight_recording.h"
#include "core/geo/rigid3.h"
#include "core/sim/smooth_noise.h"
#include "core/topview/camera_model.h"

namespace nadir {

/// How a segmentation network errs on one class.
struct ClassErrors {
  struct Confusion {
    ClassId taken_for = kUnclassified;
    double share = 0.0;  ///< Of the errors inside the class; the shares of a class sum to 1.
  };
  double accuracy = 1.0;  ///< cPA, thesis equation 4.1: share of the class's pixels that are right.
  double border_loss = 0.0;  ///< Share that wobbly borders alone cost in views of streets.
  std::array<Confusion, 3> confusions;
};

/// The published network (thesis 4.1) as a table: accuracies consistent with its class IoUs over
/// five data sets (road 86.8 to 90.2, sidewalk 41 to 72, building 69 to 91, vegetation 50 to 83,
/// car 59 to 80, pole 17 to 33, lane marking 22 to 38) and with its mean accuracy over the sixteen
/// classes (47.8 to 56.9; here 0.54). Thin classes lose most at their borders. `id` below
/// kClassCount.
[[nodiscard]] const ClassErrors& class_errors(ClassId id);

/// Makes true labels look like those of a real segmentation network. Two causes, neither
/// independent from pixel to pixel:
///
/// 1. Borders wobble and erode: a pixel takes the label a few pixels away, by a smooth displacement
/// field on the image. Thin
///    and far things suffer most, as they do in a network.
/// 2. Classes are confused in blobs: a pixel is wrong where a smooth random field is below its
/// quantile for the class. Half
///    of the field is attached to the place in the world that the pixel shows, so that an error
///    persists from frame to frame and no filter can average it away; half to the image, anew in
///    every frame. A second field decides the class.
class LabelNoise {
 public:
  /// The tables are made here, once a flight.
  explicit LabelNoise(std::uint64_t seed);

  /// Labels as a network would give them for true labels and depths. `frame.depth_m` should reach
  /// as far as the labels do; pixels without depth take both halves of the field from the image.
  /// The same seed, number and frame give the same labels on any number of threads.
  [[nodiscard]] Raster<ClassId> apply(const SemanticFrame& frame,
                                      const CameraModel& camera,
                                      const Rigid3& enu_from_camera,
                                      std::uint32_t frame_number) const;

 private:
  std::uint64_t seed_;
  SmoothNoise noise_;
  std::array<double, kClassCount>
      threshold_{};  ///< A pixel of the class is wrong where the field is below.
};

}  // namespace nadir
