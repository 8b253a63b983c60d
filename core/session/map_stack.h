// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/session/view_state.h"

namespace nadir {

/// A layer that a map shows, and how.
struct StackedLayer {
  Layer layer = Layer::kPicture;
  double opacity = 1.0;               ///< In [0, 1].
  std::optional<std::string> colour;  ///< "#RRGGBB"; nothing: the theme's.
  friend bool operator==(const StackedLayer&, const StackedLayer&) = default;
};

/// The layers that a map shows, from the ground up: an option whose text is "picture,topview:0.8,truth#FF8800" (opacity
/// and colour only where they are not all and the theme's; lines have colours to choose), "none", or "own" where who draws
/// the map chooses them. The legend is no layer of it.
struct MapStack {
  std::optional<std::vector<StackedLayer>> layers = {};  ///< Each once; nothing: "own".

  static constexpr std::string_view kForm = "NAME[:OPACITY][#RRGGBB][,...]";

  /// What a look has in sight. Ellipses and modes of an estimate that is hidden have its colour and opacity, as they are
  /// seen.
  [[nodiscard]] static MapStack of(const MapLook& look);
  /// @errors kInvalidOptions: "'partikles' is no layer of a map (did you mean particles?)", "'2' is no opacity in [0, 1]",
  /// "'#12' is no colour: write #RRGGBB", "picture is no line and takes no colour", "topview is named twice".
  [[nodiscard]] static Result<MapStack> from_text(std::string_view text);
  [[nodiscard]] std::string text() const;
  [[nodiscard]] Result<void> check() const { return {}; }

  [[nodiscard]] bool is_own() const { return !layers.has_value(); }
  /// False where nobody has chosen.
  [[nodiscard]] bool has(Layer layer) const;
  /// The look with these layers in sight and the others hidden, each of which lies above the one that it lies above by
  /// default. An estimate that is hidden gives ellipses and modes nothing. As it is where nobody has chosen.
  [[nodiscard]] MapLook laid_on(MapLook look) const;
  friend bool operator==(const MapStack&, const MapStack&) = default;
};

}  // namespace nadir
