// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "core/exchange/import_rules.h"
#include "core/exchange/source_features.h"
#include "tests/fuzz/fuzz_check.h"

namespace {

using nadir::fuzz_check;
using nadir::fuzz_check_error;

constexpr const char* kName = "fuzzed.osm";

/// Rules of which some fit anything.
const nadir::ImportRules& some_rules() {
  static const nadir::ImportRules rules =
      nadir::ImportRules::parse(
          "[[rule]]\nwhere = { highway = true }\nkind = \"line\"\nclass = \"road\"\n"
          "width_m = { tags = [\"width\"], a_lane = 3.0, otherwise = 5.0 }\n"
          "[[rule]]\nwhere = { class = true }\nkind = \"area\"\nclass = { tag = \"class\" }\n",
          "rules")
          .value();
  return rules;
}

void check_feature(const nadir::SourceFeature& feature) {
  fuzz_check(!feature.rings.empty(), "a feature has a ring");
  const bool is_ring =
      feature.form == nadir::SourceForm::kArea || feature.form == nadir::SourceForm::kClosedLine;
  for (const nadir::Ring& ring : feature.rings) {
    fuzz_check(!ring.empty(), "a ring has a place");
    fuzz_check(feature.form == nadir::SourceForm::kPlace || ring.size() >= 2, "a line has two");
    for (const auto& place : ring) {
      fuzz_check(place.allFinite() && place.cwiseAbs().maxCoeff() <= 180.0, "on the Earth");
    }
    fuzz_check(!is_ring || ring.size() < 2 || ring.front() != ring.back(),
               "a ring does not repeat its first place");
  }
  const auto drawn = some_rules().apply(feature.tags, feature.form);
  if (drawn && drawn->kind == nadir::ImportKind::kLine) {
    fuzz_check(drawn->width_m > 0.0 && drawn->width_m <= nadir::kMostObjectWidthM, "a width");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = nadir::text_of(data, size);
  const auto features = nadir::parse_osm_features(text, kName);
  fuzz_check_error(features, kName);
  if (features) {
    for (const auto& layer : features->layers) {
      for (const auto& feature : layer.features) check_feature(feature);
    }
  }
  const auto rules = nadir::ImportRules::parse(text, kName);
  fuzz_check_error(rules, kName);
  if (rules) {
    (void)rules->apply({{"highway", "residential"}, {"width", "3 m"}},
                       nadir::SourceForm::kOpenLine);
  }
  const auto metres = nadir::metres_from_tag(text);
  fuzz_check(!metres || (*metres > 0.0 && *metres <= nadir::kMostObjectWidthM), "a length");
  return 0;
}
