// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/prop_order.h"

#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace nadir {

void PropOrder::add(vtkRenderer& renderer, vtkProp& prop, int layer) {
  const auto above = std::upper_bound(layers_.begin(), layers_.end(), layer);
  const auto below = static_cast<int>(above - layers_.begin());
  layers_.insert(above, layer);
  // The renderer must take the prop in itself; only then it is moved down to its place.
  renderer.AddViewProp(&prop);
  vtkPropCollection* const props = renderer.GetViewProps();
  if (below + 1 == props->GetNumberOfItems()) return;
  const vtkSmartPointer<vtkProp> kept = &prop;
  props->RemoveItem(&prop);
  props->InsertItem(below - 1, &prop);  // after the item of that number
}

void PropOrder::remove(vtkRenderer& renderer, vtkProp& prop) {
  const int place = renderer.GetViewProps()->IsItemPresent(&prop);  // from 1; 0 where it is not
  if (place == 0) return;
  layers_.erase(layers_.begin() + (place - 1));
  renderer.RemoveViewProp(&prop);
}

}  // namespace nadir
