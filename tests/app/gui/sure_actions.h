// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nadir {

/// How an action comes about for certain, whatever was done before and however fast the machine is, in the words of a script.
struct SureAction {
  std::string_view name;
  std::vector<std::string> before;  ///< After each of these everything is waited for.
  /// One after another without a frame between, so that no work can end meanwhile. The last is the action.
  std::vector<std::string> then;
};

/// All actions, in the order of the variant.
/// @param run    A run with its flight and its map.
/// @param map    A map package of its own, to be labelled.
/// @param astray One of the same flight that parts from it.
[[nodiscard]] std::vector<SureAction> sure_actions(const std::string& run,
                                                   const std::string& astray,
                                                   const std::string& map);

}  // namespace nadir
