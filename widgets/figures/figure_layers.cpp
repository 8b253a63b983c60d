// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figure_layers.h"

#include <algorithm>

#include "core/base/settings.h"

namespace nadir {
namespace {

constexpr auto& kLayerNames = EnumNames<FigureLayer>::kNames;

Result<FigureLayer> layer_named(std::string_view name) {
  const auto found = std::find(kLayerNames.begin(), kLayerNames.end(), name);
  if (found != kLayerNames.end()) return static_cast<FigureLayer>(found - kLayerNames.begin());
  const std::string nearest = nearest_word(name, {kLayerNames.begin(), kLayerNames.end()});
  return fail(ErrorCode::kInvalidOptions, "'{}' is no layer{}", name,
              nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest));
}

}  // namespace

Result<FigureLayers> FigureLayers::from_text(std::string_view text) {
  FigureLayers layers;
  if (text == "all") return layers;
  const bool takes_away = text.starts_with('-');
  if (!takes_away) layers.shown_.reset();
  if (text == "none") return layers;
  while (true) {
    const std::size_t comma = text.find(',');
    std::string_view word = text.substr(0, comma);
    if (word.starts_with('-') != takes_away) {
      return fail(ErrorCode::kInvalidOptions, "'{}': either all names have a minus or none has",
                  word);
    }
    if (takes_away) word.remove_prefix(1);
    const auto layer = layer_named(word);
    if (!layer) return forward_error(layer);
    layers.set(*layer, !takes_away);
    if (comma == std::string_view::npos) return layers;
    text.remove_prefix(comma + 1);
  }
}

std::string FigureLayers::text() const {
  if (shown_.all()) return "all";
  std::string text;
  for (std::size_t i = 0; i < kLayerNames.size(); ++i) {
    if (!shown_[i]) continue;
    text += (text.empty() ? "" : ",") + std::string(kLayerNames.at(i));
  }
  return text.empty() ? "none" : text;
}

}  // namespace nadir
