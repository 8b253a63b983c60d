// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bitset>
#include <string>
#include <string_view>

#include "core/base/field.h"

namespace nadir {

/// What can be left out of the maps of figures.
enum class FigureLayer {
  kPicture,    ///< The overhead's picture, else its labels are the ground.
  kTruth,      ///< Trajectory and pose.
  kOdometry,   ///< The same of the input.
  kEstimate,   ///< The same of the estimate.
  kEllipses,   ///< Of the estimate's covariance.
  kModes,      ///< Every mode's ellipse and mass, else the heaviest mode's.
  kParticles,  ///< Where they were recorded.
  kTopview     ///< Laid at the estimate, where it was recorded.
};

template <>
struct EnumNames<FigureLayer> {
  static constexpr std::array<std::string_view, 8> kNames = {
      "picture", "truth", "odometry", "estimate", "ellipses", "modes", "particles", "topview"};
};

/// A set of layers: an option whose text is "all", "none", names with commas between them ("picture,truth"), or, with a
/// minus before each, all but those ("-particles,-modes").
class FigureLayers {
 public:
  static constexpr std::string_view kForm = "NAME[,NAME...]";

  /// @errors kInvalidOptions: "'partikles' is no layer (did you mean particles?)".
  [[nodiscard]] static Result<FigureLayers> from_text(std::string_view text);
  /// "all", "none", or the names in their order.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] Result<void> check() const { return {}; }

  [[nodiscard]] bool has(FigureLayer layer) const {
    return shown_[static_cast<std::size_t>(layer)];
  }
  void set(FigureLayer layer, bool is_shown) { shown_[static_cast<std::size_t>(layer)] = is_shown; }
  friend bool operator==(const FigureLayers&, const FigureLayers&) = default;

 private:
  std::bitset<EnumNames<FigureLayer>::kNames.size()> shown_ = ~0ULL;
};

}  // namespace nadir
