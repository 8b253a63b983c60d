// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/option_effects.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "core/mcl/localiser.h"
#include "tests/support/error_text.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace option_effects_test {

using ::testing::IsEmpty;

using Values = std::map<std::string, std::string>;

Values values_of(const LocaliserOptions& options, const std::string& prior) {
  Values values;
  for (const OptionText& option : option_texts(options)) values[option.name] = option.value;
  values["prior"] = prior;
  return values;
}

LocaliserOptions set(LocaliserOptions options, const std::string& name, const std::string& value) {
  const auto done = set_option(options, name, value);
  EXPECT_TRUE(done) << name << " " << error_text(done);
  return options;
}

/// A short flight in a circle that sees perfectly, over ground with holes that nobody has labelled.
class ShortFlight {
 public:
  ShortFlight() {
    OverheadMap map = patchwork_map(240, 240, 0.25);
    for (int row = 0; row < 240; ++row) {
      for (int column = 0; column < 240; ++column) {
        if ((row / 6 + column / 6) % 5 == 0) map.labels.at(column, row) = kUnclassified;
      }
    }
    index_ = index_of(std::move(map));
    for (int step = 0; step < kSteps; ++step)
      seen_.push_back(perfect_topview(index_->map(), truth(step), 7.0));
  }

  /// All that comes of it, to the last bit.
  [[nodiscard]] std::vector<double> outcome(const LocaliserOptions& options, bool is_global) const {
    const Prior prior =
        is_global ? Prior(GlobalPrior{}) : Prior(GaussianPrior{.mean_in_enu = truth(0)});
    auto localiser = Localiser::create(index_, options, prior).value();
    std::vector<double> all;
    for (int step = 0; step < kSteps; ++step) {
      OdometryStep odometry;
      if (step > 0) odometry = {truth(step - 1).inverse() * truth(step), 0.25};
      const auto update = localiser.update(odometry, seen_[static_cast<std::size_t>(step)]);
      const Rigid2& mean = update.estimate.moments.mean;
      all.insert(all.end(), {mean.x_m, mean.y_m, mean.yaw_rad, update.effective_sample_size});
    }
    const ParticleSet& particles = localiser.particles();
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const Rigid2 pose = particles.pose(i);
      all.insert(all.end(), {pose.x_m, pose.y_m, pose.yaw_rad, particles.weight[i]});
    }
    return all;
  }

 private:
  static constexpr int kSteps = 4;
  static Rigid2 truth(int step) {
    const double angle = 0.05 * step;
    return {30.0 + 20.0 * std::cos(angle), 30.0 + 20.0 * std::sin(angle), wrap_rad(angle + 1.5708)};
  }
  std::shared_ptr<const MapIndex> index_;
  std::vector<SemanticTopview> seen_;
};

/// Few particles, and every option at a value where it counts if it can.
LocaliserOptions lively(LocaliserOptions options) {
  options.particle_count = 300;
  options.global_particle_count = 300;
  options.min_particle_count = 5;
  options.kld_error = 1.0;
  options.resample_below_fraction = 1.0;
  options.gamma0 = 0.5;  // more than one particle survives
  if (options.evidence_spacing_m > 0.0) options.evidence_spacing_m = 3.0;  // a step is 1 m
  return options;
}

/// Another value of each option, far enough from that of lively().
const std::map<std::string, std::vector<std::string>>& other_values() {
  static const std::map<std::string, std::vector<std::string>> values = {
      {"seed", {"2"}},
      {"particles", {"40"}},
      {"min-particles", {"290"}},
      {"global-particles", {"280"}},
      {"adapt-particles", {"true", "false"}},
      {"kld-error", {"0.5"}},
      {"motion", {"thesis", "scaled"}},
      {"rotation-noise", {"0.2"}},
      {"translation-noise", {"0.6"}},
      {"position-noise", {"0.5"}},
      {"along-noise", {"0.3"}},
      {"across-noise", {"0.2"}},
      {"yaw-noise", {"0.1"}},
      {"turn-noise", {"0.2"}},
      {"hover-below", {"5"}},
      {"match", {"class", "distance"}},
      {"truncation", {"0.5"}},
      {"alpha", {"share", "inverse-share"}},
      {"unknown-cost", {"0.2"}},
      {"likelihood", {"thesis", "tempered"}},
      {"gamma0", {"0.05"}},
      {"temperature", {"0.05"}},
      {"min-effective", {"0.9"}},
      {"full-evidence-area", {"1000"}},
      {"evidence-spacing", {"7"}},
      {"standstill-evidence", {"0.9"}},
      {"max-cells", {"5"}},
      {"resampling", {"multinomial", "systematic"}},
      {"resample-below", {"0"}},
      {"estimate-after-resampling", {"true", "false"}},
      {"blur-position", {"0.4"}},
      {"blur-yaw", {"0.2"}},
      {"blur-interval", {"0.6"}},
  };
  return values;
}

struct Case {
  std::string name;
  LocaliserOptions options;
  bool is_global = false;
};

std::vector<Case> cases() {
  const LocaliserOptions usual = lively({});
  const LocaliserOptions thesis = lively(localiser_preset("thesis").value());
  return {{"default", usual},
          {"thesis", thesis},
          {"global start", usual, true},
          {"never resampled", set(usual, "resample-below", "0")},
          {"fixed count", set(usual, "adapt-particles", "false")},
          {"evidence in full", set(usual, "evidence-spacing", "0")},
          {"blurred places", set(usual, "blur-position", "0.3")},
          {"blurred headings", set(usual, "blur-yaw", "0.1")},
          {"class match", set(usual, "match", "class")},
          {"thesis likelihood", set(usual, "likelihood", "thesis")}};
}

/// The truth of all rules: an option changes what the filter does exactly where they say so.
TEST(OptionEffects, AreThoseOfTheFilter) {
  const ShortFlight flight;
  for (const Case& one : cases()) {
    const auto before = flight.outcome(one.options, one.is_global);
    const Values values = values_of(one.options, one.is_global ? "global" : "truth");
    for (const OptionText& option : option_texts(one.options)) {
      if (option.name == "min-update-interval") continue;  // chooses frames before the filter
      const auto found = other_values().find(option.name);
      ASSERT_NE(found, other_values().end()) << "no other value of " << option.name;
      for (const std::string& value : found->second) {
        if (value == option.value) continue;
        const auto after = flight.outcome(set(one.options, option.name, value), one.is_global);
        const std::string why = why_no_effect(option.name, values);
        EXPECT_EQ(before == after, !why.empty())
            << one.name << ": " << option.name << " from " << option.value << " to " << value
            << (why.empty() ? "" : ", said to have no effect while ") << why;
      }
    }
  }
}

TEST(OptionEffects, AreOfOptionsAndValuesThatThereAre) {
  std::map<std::string, OptionText> options;
  for (const OptionText& option : option_texts(LocaliserOptions{})) options[option.name] = option;
  for (const EffectRule& rule : effect_rules()) {
    EXPECT_TRUE(options.contains(std::string(rule.option))) << rule.option;
    EXPECT_FALSE(rule.needs[0].option.empty()) << rule.option;
    for (const EffectCondition& needed : rule.needs) {
      if (needed.option.empty() || needed.option == "prior") continue;
      ASSERT_TRUE(options.contains(std::string(needed.option))) << needed.option;
      EXPECT_NE(needed.option, rule.option);
      const std::string value = needed.value == kAboveZero ? "1" : std::string(needed.value);
      LocaliserOptions some;
      EXPECT_TRUE(set_option(some, needed.option, value)) << needed.option << " " << value;
    }
  }
}

TEST(OptionEffects, SayWhatIsInTheWay) {
  Values values = values_of({}, "truth of the first frame");
  EXPECT_EQ(why_no_effect("translation-noise", values), "motion = scaled");
  EXPECT_EQ(why_no_effect("along-noise", values), "");
  EXPECT_EQ(why_no_effect("blur-interval", values), "blur-position = 0 and blur-yaw = 0");
  EXPECT_EQ(why_no_effect("global-particles", values), "the start is known");
  values["prior"] = std::string(kGoesOnPrior) + " 200 of loop.nadir";
  EXPECT_EQ(why_no_effect("global-particles", values), "the run goes on with recorded particles");
  EXPECT_EQ(why_no_effect("particles", values), "");
  values["blur-yaw"] = "0.1";
  EXPECT_EQ(why_no_effect("blur-interval", values), "");
  values["adapt-particles"] = "false";
  EXPECT_EQ(why_no_effect("kld-error", values), "adapt-particles is off");
}

TEST(OptionEffects, WhatHasNoEffectItselfLendsNone) {
  Values values = values_of({}, "global");
  values["resample-below"] = "0";
  EXPECT_EQ(why_no_effect("kld-error", values), "resample-below = 0");
  values["likelihood"] = "thesis";
  values["evidence-spacing"] = "0";
  EXPECT_EQ(why_no_effect("standstill-evidence", values), "likelihood = thesis");
  values["likelihood"] = "tempered";
  EXPECT_EQ(why_no_effect("standstill-evidence", values), "evidence-spacing = 0");
}

TEST(OptionEffects, AreNotDeniedWhereNobodyKnows) {
  for (const EffectRule& rule : effect_rules())
    EXPECT_THAT(why_no_effect(rule.option, {}), IsEmpty());
  EXPECT_EQ(why_no_effect("adapt-particles", {{"resample-below", "a half"}}), "");
  EXPECT_EQ(why_no_effect("of-tomorrow", {{"motion", "scaled"}}), "");
}

}  // namespace option_effects_test
}  // namespace nadir
