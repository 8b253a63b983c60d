// SPDX-License-Identifier: Apache-2.0
#include "core/session/map_stack.h"

#include <algorithm>
#include <charconv>

#include "core/base/settings.h"
#include "core/session/map_parts.h"

namespace nadir {
namespace {

constexpr std::string_view kOwnWord = "own", kNoneWord = "none";

Result<Layer> stackable_layer(std::string_view name) {
  const auto& names = EnumNames<Layer>::kNames;
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(Layer::kLegend);  // the last one
  const auto found = std::find(names.begin(), end, name);
  if (found != end) return static_cast<Layer>(found - names.begin());
  const std::string nearest = nearest_word(name, {names.begin(), end});
  return fail(ErrorCode::kInvalidOptions, "'{}' is no layer of a map{}", name,
              nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest));
}

/// "topview:0.8#FF8800".
Result<StackedLayer> stacked_layer(std::string_view word) {
  StackedLayer made;
  const std::size_t hash = word.find('#');
  if (hash != std::string_view::npos) {
    made.colour = std::string(word.substr(hash));
    if (!is_colour_text(*made.colour)) {
      return fail(ErrorCode::kInvalidOptions, "'{}' is no colour: write #RRGGBB", *made.colour);
    }
    word = word.substr(0, hash);
  }
  const std::size_t colon = word.find(':');
  if (colon != std::string_view::npos) {
    const std::string_view number = word.substr(colon + 1);
    const char* const end = number.data() + number.size();
    const auto [rest, error] = std::from_chars(number.data(), end, made.opacity);
    const bool is_number = !number.empty() && error == std::errc() && rest == end;
    if (!is_number || !(made.opacity >= 0.0 && made.opacity <= 1.0)) {
      return fail(ErrorCode::kInvalidOptions, "'{}' is no opacity in [0, 1]", number);
    }
    word = word.substr(0, colon);
  }
  const auto layer = stackable_layer(word);
  if (!layer) return forward_error(layer);
  made.layer = *layer;
  if (made.colour && is_ground_layer(made.layer)) {
    return fail(ErrorCode::kInvalidOptions, "{} is no line and takes no colour", word);
  }
  return made;
}

/// As a layer is seen: ellipses and modes are drawn as the estimate that they are of, hidden or not.
StackedLayer seen_layer(const MapLook& look, Layer layer) {
  const LayerLook& own = look.layer(layer);
  StackedLayer seen{layer, own.opacity, own.colour};
  if (is_ground_layer(layer)) seen.colour.reset();
  const bool is_of_estimate = layer == Layer::kEllipses || layer == Layer::kModes;
  if (is_of_estimate && !own.colour && !is_in_sight(look, Layer::kEstimate)) {
    seen.colour = look.layer(Layer::kEstimate).colour;
    seen.opacity *= look.layer(Layer::kEstimate).opacity;
  }
  return seen;
}

}  // namespace

MapStack MapStack::of(const MapLook& look) {
  MapStack made;
  made.layers.emplace();
  for (const Layer layer : look.order) {
    if (layer == Layer::kLegend || !is_in_sight(look, layer)) continue;
    StackedLayer seen = seen_layer(look, layer);
    if (seen.opacity > 0.0) made.layers->push_back(std::move(seen));
  }
  return made;
}

Result<MapStack> MapStack::from_text(std::string_view text) {
  MapStack made;
  if (text == kOwnWord) return made;
  made.layers.emplace();
  if (text == kNoneWord) return made;
  while (true) {
    const std::size_t comma = text.find(',');
    auto layer = stacked_layer(text.substr(0, comma));
    if (!layer) return forward_error(layer);
    if (made.has(layer->layer)) {
      return fail(ErrorCode::kInvalidOptions, "{} is named twice", enum_name(layer->layer));
    }
    made.layers->push_back(std::move(*layer));
    if (comma == std::string_view::npos) return made;
    text.remove_prefix(comma + 1);
  }
}

std::string MapStack::text() const {
  if (!layers) return std::string(kOwnWord);
  std::string made;
  for (const StackedLayer& layer : *layers) {
    made += (made.empty() ? "" : ",") + std::string(enum_name(layer.layer));
    if (layer.opacity != 1.0) made += fmt::format(":{}", layer.opacity);
    made += layer.colour.value_or("");
  }
  return made.empty() ? std::string(kNoneWord) : made;
}

bool MapStack::has(Layer layer) const {
  return layers && std::any_of(layers->begin(), layers->end(),
                               [layer](const StackedLayer& one) { return one.layer == layer; });
}

MapLook MapStack::laid_on(MapLook look) const {
  if (!layers) return look;
  look.order.clear();
  for (const StackedLayer& one : *layers) {
    look.layer(one.layer) = {true, one.opacity, one.colour};
    look.order.push_back(one.layer);
  }
  for (std::size_t i = 0; i < kLayerCount; ++i) {
    const auto layer = static_cast<Layer>(i);
    if (has(layer)) continue;
    if (layer == Layer::kLegend) {  // on top of all, shown or not as it was
      look.order.push_back(layer);
      continue;
    }
    look.layer(layer).is_visible = false;
    if (layer == Layer::kEstimate) look.layer(layer) = {false, 1.0, std::nullopt};
    const auto below =
        i == 0 ? look.order.end()
               : std::find(look.order.begin(), look.order.end(), static_cast<Layer>(i - 1));
    look.order.insert(below == look.order.end() ? look.order.begin() : below + 1, layer);
  }
  return look;
}

}  // namespace nadir
