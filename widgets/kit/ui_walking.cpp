// SPDX-License-Identifier: Apache-2.0
// Where Tab and arrows go among the controls of a frame.
#include <algorithm>

#include "widgets/kit/ui_focus.h"

namespace nadir::kit {

bool went_down(Key key, bool with_repeats) {
  return ImGui::IsKeyPressed(static_cast<int>(key), with_repeats);
}

bool stands_for_group(const Stops& stops, const PlacedStop& stop) {
  if (stop.group == 0) return true;
  const PlacedStop* first = nullptr;
  for (const PlacedStop& one : stops) {
    if (one.group != stop.group) continue;
    if (one.is_selected) return one.id == stop.id;
    if (first == nullptr) first = &one;
  }
  return first != nullptr && first->id == stop.id;
}

std::size_t place_of(const Stops& stops, ImGuiID id) {
  const auto found = std::find_if(stops.begin(), stops.end(),
                                  [id](const PlacedStop& stop) { return stop.id == id; });
  return static_cast<std::size_t>(found - stops.begin());
}

const PlacedStop* next_stop(const Stops& stops, const Focus& focus, bool is_back) {
  const std::size_t count = stops.size();
  if (count == 0) return nullptr;
  const std::size_t here = place_of(stops, focus.id);
  const bool is_there = here < count;
  const ImGuiID group = is_there ? stops[here].group : 0;
  // What had the keyboard may be gone: then on with what stands in its place.
  std::size_t at = is_there ? here : std::min(focus.place, count - 1);
  if (!is_there && is_back) at = (at + count - 1) % count;
  for (std::size_t i = is_there ? 1 : 0; i <= count; ++i) {
    const std::size_t steps = i % count;
    const PlacedStop& stop = stops[is_back ? (at + count - steps) % count : (at + steps) % count];
    if (group != 0 && stop.group == group) continue;
    if (stands_for_group(stops, stop)) return &stop;
  }
  return nullptr;
}

const PlacedStop* next_region(const Stops& stops, const Focus& focus, bool is_back) {
  std::vector<ImGuiID> regions;
  for (const PlacedStop& stop : stops) {
    const bool is_known = std::find(regions.begin(), regions.end(), stop.region) != regions.end();
    if (!is_known && !stop.is_handle) regions.push_back(stop.region);
  }
  if (regions.empty()) return nullptr;
  const std::size_t here = place_of(stops, focus.id), count = regions.size();
  std::size_t wanted = is_back ? count - 1 : 0;
  if (here < stops.size()) {
    const auto at = std::find(regions.begin(), regions.end(), stops[here].region);
    const auto place = static_cast<std::size_t>(at - regions.begin());
    if (place < count) wanted = (place + (is_back ? count - 1 : 1)) % count;
  }
  const auto found = std::find_if(stops.begin(), stops.end(), [&](const PlacedStop& stop) {
    return stop.region == regions[wanted] && stands_for_group(stops, stop);
  });
  return found == stops.end() ? nullptr : &*found;
}

const PlacedStop* end_of_group(const Stops& stops, ImGuiID group, bool is_last) {
  const PlacedStop* end = nullptr;
  for (const PlacedStop& stop : stops) {
    if (stop.group == group && (is_last || end == nullptr)) end = &stop;
  }
  return end;
}

const PlacedStop* next_in_group(const Stops& stops, const PlacedStop& here) {
  const bool is_first = went_down(Key::kHome, false), is_last = went_down(Key::kEnd, false);
  int by = 0;
  if (goes_sideways(here.arrows))
    by += (went_down(Key::kRight, true) ? 1 : 0) - (went_down(Key::kLeft, true) ? 1 : 0);
  if (goes_up_and_down(here.arrows))
    by += (went_down(Key::kDown, true) ? 1 : 0) - (went_down(Key::kUp, true) ? 1 : 0);
  if (is_first || is_last) return end_of_group(stops, here.group, is_last);
  if (by == 0) return nullptr;
  std::vector<const PlacedStop*> group;
  std::ptrdiff_t at = 0;
  for (const PlacedStop& stop : stops) {
    if (stop.group != here.group) continue;
    if (stop.id == here.id) at = static_cast<std::ptrdiff_t>(group.size());
    group.push_back(&stop);
  }
  const auto last = static_cast<std::ptrdiff_t>(group.size()) - 1;
  return group[static_cast<std::size_t>(std::clamp(at + by, std::ptrdiff_t{0}, last))];
}

}  // namespace nadir::kit
