// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace nadir {

/// Where a random draw happens. The draw is a pure function of this, so neither threads nor order
/// can change it.
struct DrawId {
  std::uint64_t seed = 0;
  std::uint32_t stream = 0;  ///< What the draw is for: one constant of RandomStream a purpose.
  std::uint32_t step = 0;
  std::uint32_t particle = 0;
  std::uint32_t draw = 0;
};

/// Every purpose that draws random numbers has its own stream, so that no two purposes share
/// numbers.
enum RandomStream : std::uint32_t {
  kInitialPose = 1,
  kMotionNoise,
  kResampling,
  kBlur,
  kOdometryNoise,
  kDepthNoise,
  kLabelNoise,
  kWorldObjects,
  kAttitude,
  kTownDrawing,
};

/// Four independent, uniformly distributed words: Philox4x32-10 (Salmon, Moraes, Dror & Shaw, SC
/// 2011).
[[nodiscard]] std::array<std::uint32_t, 4> random_words(const DrawId& id);

/// Two independent uniform numbers in [0, 1), 53 bits each.
[[nodiscard]] std::array<double, 2> uniforms(const DrawId& id);

/// Two independent draws of N(0, 1) by Box and Muller; std::normal_distribution differs between
/// libraries.
[[nodiscard]] std::array<double, 2> standard_normals(const DrawId& id);

}  // namespace nadir
