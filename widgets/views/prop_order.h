// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

class vtkProp;
class vtkRenderer;

namespace nadir {

/// A prop, and when it was changed last: neither is ever the same for another state of the same prop.
struct PropStamp {
  const vtkProp* prop = nullptr;
  std::uint64_t changed = 0;  ///< By VTK's clock.
  friend bool operator==(const PropStamp&, const PropStamp&) = default;
};

/// Keeps a renderer's props in the order of their layers, which is the order that they are drawn in: by their numbers, or as
/// set_order() says.
class PropOrder {
 public:
  /// Puts a prop above what lies in lower layers and in its own, below the higher ones, whenever those were added.
  void add(vtkRenderer& renderer, vtkProp& prop, int layer);
  void remove(vtkRenderer& renderer, vtkProp& prop);
  /// From now on layers lie in this order. @param from_below  Layers that it does not name lie below all that it does, by
  /// their numbers.
  void set_order(vtkRenderer& renderer, std::span<const int> from_below);
  /// Hides what is visible of other layers, until show_all(). Nothing may be added or removed in between.
  void show_only(vtkRenderer& renderer, std::span<const int> layers);
  void show_all();
  /// Of the props in some layers, in their order. @param layers  Empty: all.
  [[nodiscard]] std::vector<PropStamp> stamps(vtkRenderer& renderer,
                                              std::span<const int> layers) const;
  [[nodiscard]] bool holds_above(int layer) const {
    return !layers_.empty() && is_below(layer, layers_.back());
  }

 private:
  [[nodiscard]] bool is_below(int lower, int higher) const;

  std::vector<int> layers_;         ///< Of the renderer's props, in their order.
  std::vector<int> order_;          ///< From below; empty: by their numbers.
  std::vector<vtkProp*> hidden_{};  ///< By show_only().
};

}  // namespace nadir
