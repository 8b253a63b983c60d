// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/prop_order.h"

#include <vtkProp.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <numeric>

namespace nadir {
namespace {

/// In their order.
std::vector<vtkProp*> props_of(vtkRenderer& renderer) {
  std::vector<vtkProp*> props;
  vtkCollectionSimpleIterator at = nullptr;
  vtkPropCollection* const all = renderer.GetViewProps();
  all->InitTraversal(at);
  while (vtkProp* const prop = all->GetNextProp(at)) props.push_back(prop);
  return props;
}

}  // namespace

bool PropOrder::is_below(int lower, int higher) const {
  const auto place = [this](int layer) {
    const auto found = std::find(order_.begin(), order_.end(), layer);
    return found == order_.end() ? std::ptrdiff_t{-1} : found - order_.begin();
  };
  const auto low = place(lower);
  const auto high = place(higher);
  return low == high ? lower < higher : low < high;
}

void PropOrder::add(vtkRenderer& renderer, vtkProp& prop, int layer) {
  const auto above = std::upper_bound(layers_.begin(), layers_.end(), layer,
                                      [this](int one, int other) { return is_below(one, other); });
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

void PropOrder::set_order(vtkRenderer& renderer, std::span<const int> from_below) {
  if (std::equal(order_.begin(), order_.end(), from_below.begin(), from_below.end())) return;
  order_.assign(from_below.begin(), from_below.end());
  const std::vector<vtkProp*> props = props_of(renderer);
  std::vector<std::size_t> places(props.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::stable_sort(places.begin(), places.end(), [this](std::size_t a, std::size_t b) {
    return is_below(layers_[a], layers_[b]);
  });
  // The collection alone is sorted: the renderer would give back what the graphics card holds of a prop that leaves it.
  const std::vector<vtkSmartPointer<vtkProp>> kept(props.begin(), props.end());
  const std::vector<int> layers = layers_;
  vtkPropCollection* const all = renderer.GetViewProps();
  all->RemoveAllItems();
  for (std::size_t i = 0; i < places.size(); ++i) {
    all->AddItem(props[places[i]]);
    layers_[i] = layers[places[i]];
  }
}

void PropOrder::show_only(vtkRenderer& renderer, std::span<const int> layers) {
  const std::vector<vtkProp*> props = props_of(renderer);
  for (std::size_t i = 0; i < props.size(); ++i) {
    const bool is_wanted = std::find(layers.begin(), layers.end(), layers_[i]) != layers.end();
    if (is_wanted || props[i]->GetVisibility() == 0) continue;
    props[i]->VisibilityOff();
    hidden_.push_back(props[i]);
  }
}

std::vector<PropStamp> PropOrder::stamps(vtkRenderer& renderer, std::span<const int> layers) const {
  const std::vector<vtkProp*> props = props_of(renderer);
  std::vector<PropStamp> stamps;
  for (std::size_t i = 0; i < props.size(); ++i) {
    const bool is_wanted =
        layers.empty() || std::find(layers.begin(), layers.end(), layers_[i]) != layers.end();
    if (!is_wanted) continue;
    stamps.push_back(
        {props[i], std::max<std::uint64_t>(props[i]->GetMTime(), props[i]->GetRedrawMTime())});
  }
  return stamps;
}

void PropOrder::show_all() {
  for (vtkProp* const prop : hidden_) prop->VisibilityOn();
  hidden_.clear();
}

}  // namespace nadir
