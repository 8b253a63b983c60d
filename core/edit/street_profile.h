// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/label/label_document.h"

namespace nadir {

/// One strip along a street.
struct ProfileStrip {
  ClassId class_id = kRoad;
  double offset_m =
      0.0;  ///< Of its middle, to the left of the street's centre line; negative: to the right.
  double width_m = 0.0;
  double dash_m = 0.0, gap_m = 0.0;  ///< Of a dashed marking; both 0: unbroken.
  friend bool operator==(const ProfileStrip&, const ProfileStrip&) = default;
};

/// What a street looks like across: one centre line becomes road, curbs, sidewalks and lane markings.
struct StreetProfile {
  std::string name;
  std::vector<ProfileStrip> strips;

  /// A TOML file: `name`, and a table [[strip]] for each strip with `class`, `width_m`, `offset_m` (0 where it is missing),
  /// `dash_m` and `gap_m`; with `both_sides = true` there is a second one to the right. resources/profiles has some.
  /// @errors kNotFound, kIo, kMalformed: "lane.toml: strip 2: width_m is not in (0, 100]".
  [[nodiscard]] static Result<StreetProfile> read(const std::filesystem::path& path);
  /// @param file  Stands for it in messages.
  [[nodiscard]] static Result<StreetProfile> parse(std::string_view text, const std::string& file);
};

/// Draws all strips along a centre line as one step: parallels whose inner corners do not cross, dashes measured along each of
/// them from the line's beginning. A line that ends where it began is a ring, and its strips are.
/// @errors kInvalidOptions: the line bends more sharply than the profile is wide, or meets itself; those of check_object().
[[nodiscard]] Result<LabelEdit> draw_street(const LabelDocument& document,
                                            const StreetProfile& profile,
                                            const Ring& centre_line);

}  // namespace nadir
