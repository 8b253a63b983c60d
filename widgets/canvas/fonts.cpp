// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/fonts.h"

#include <fontconfig/fontconfig.h>
#include <strings.h>

#include <array>
#include <memory>

namespace nadir {
namespace {

struct FreePattern {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
using Pattern = std::unique_ptr<FcPattern, FreePattern>;

/// The family that fontconfig takes for another one, as Cairo asks it; empty where there is none.
std::string matched_family(const char* family) {
  const Pattern wanted(FcPatternCreate());
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
  FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult outcome = FcResultNoMatch;
  const Pattern match(FcFontMatch(nullptr, wanted.get(), &outcome));
  FcChar8* name = nullptr;
  if (!match || FcPatternGetString(match.get(), FC_FAMILY, 0, &name) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(name);
}

}  // namespace

const char* font_family(FontFace face) {
  return face == FontFace::kText ? "Inter" : "JetBrains Mono";
}

Result<std::vector<std::string>> check_fonts() {
  struct Wanted {
    FontFace face;
    const char* package;
  };
  constexpr std::array<Wanted, 2> kWanted = {
      {{FontFace::kText, "fonts-inter"}, {FontFace::kNumbers, "fonts-jetbrains-mono"}}};
  std::vector<std::string> sentences;
  for (const auto& [face, package] : kWanted) {
    const char* const family = font_family(face);
    const std::string matched = matched_family(family);
    if (matched.empty()) {
      return fail(ErrorCode::kUnsupported,
                  "fonts: none is installed, so no text can be drawn; install {} and {}",
                  kWanted[0].package, kWanted[1].package);
    }
    if (::strcasecmp(matched.c_str(), family) == 0) continue;
    sentences.push_back(fmt::format("font {} is not installed (package {}), so {} is drawn", family,
                                    package, matched));
  }
  return sentences;
}

}  // namespace nadir
