// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

class vtkProp;
class vtkRenderer;

namespace nadir {

/// Keeps a renderer's props in the order of their layers, which is the order that they are drawn in.
class PropOrder {
 public:
  /// Puts a prop above what lies in lower layers and in its own, below the higher ones, whenever those were added.
  void add(vtkRenderer& renderer, vtkProp& prop, int layer);
  void remove(vtkRenderer& renderer, vtkProp& prop);
  [[nodiscard]] bool holds_above(int layer) const {
    return !layers_.empty() && layers_.back() > layer;
  }

 private:
  std::vector<int> layers_;  ///< Of the renderer's props, in their order.
};

}  // namespace nadir
