// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <type_traits>

#include "core/mcl/localiser_options.h"
#include "core/mcl/prior.h"
#include "core/topview/semantic_topview.h"

namespace nadir {
namespace presets_test {

/// A preset as its fields' names and values: numbers as they are, booleans as 0 and 1, choices by
/// name.
struct FieldValues {
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> choices;
};

FieldValues values_of(const LocaliserOptions& options) {
  FieldValues values;
  visit_fields(options, [&](const auto& value, const Field& field) {
    using T = std::decay_t<decltype(value)>;
    const std::string name(field.name);
    if constexpr (std::is_enum_v<T>) {
      values.choices[name] = std::string(enum_name(value));
    } else {
      values.numbers[name] = static_cast<double>(value);
    }
  });
  return values;
}

/// Rouben 2018, field by field. References are to the thesis: sections 3.5 and 4.2, algorithms 2
/// and 3, equations 3.5 and 3.6.
FieldValues thesis() {
  return {
      .numbers =
          {
              // Section 4.2, parameters used.
              {"particles", 10'000},       // N = 10,000
              {"rotation-noise", 0.1},     // sigma_rot1 = sigma_rot2 = 0.1 rad
              {"translation-noise", 0.3},  // sigma_trans = 0.3 m
              {"gamma0", 0.01},            // Algorithm 3, eta = gamma0 max w
              {"blur-position", 1.0},      // easy and medium: covariance diag(1, 1, 0.1)
              {"blur-yaw", std::sqrt(0.1)},
              {"min-update-interval", 1.0 / 0.72},  // 0.72 updates a second
              // Algorithm 2, which knows neither adaption nor hovering.
              {"adapt-particles", 0},
              {"global-particles", 10'000},      // step 1: the same N, uniformly over the overhead
              {"hover-below", 0},                // step 2 takes a direction from every step
              {"resample-below", 1},             // step 4: always
              {"estimate-after-resampling", 1},  // step 5, equations 3.7 to 3.13
              {"blur-interval", 0},              // step 6: once a step, however long it took
              // Equation 3.5: every cell counts, in full, in every frame.
              {"unknown-cost", 1},  // a cell on unclassified ground matches nothing
              {"max-cells", 0},
              {"full-evidence-area", 0},
              {"evidence-spacing", 0},
              {"min-effective", 0},
              // Fields that the choices below leave without effect; their values are the defaults.
              {"seed", 1},
              {"min-particles", 2'000},
              {"kld-error", 0.02},
              {"position-noise", 0.9},
              {"along-noise", 0.1},
              {"across-noise", 0.4},
              {"yaw-noise", 0.04},
              {"turn-noise", 0.05},
              {"truncation", 1.0},
              {"temperature", 0.01},
              {"standstill-evidence", 0.1},
          },
      .choices = {
          {"motion", "thesis"},           // Algorithm 2, step 2 (Thrun et al. 2005, table 5.6)
          {"match", "class"},             // equation 3.5: the indicator function
          {"alpha", "inverse-share"},     // the text of 3.5; equation 3.6 prints the share itself
          {"likelihood", "thesis"},       // Algorithm 3: 1 / exp(w / eta)
          {"resampling", "multinomial"},  // step 4: with replacement, in proportion to weight
      }};
}

void expect_equal(const LocaliserOptions& options, const FieldValues& expected) {
  const FieldValues found = values_of(options);
  EXPECT_EQ(found.choices, expected.choices);
  for (const auto& [name, value] : found.numbers) {
    const auto wanted = expected.numbers.find(name);
    ASSERT_NE(wanted, expected.numbers.end()) << name << " is new: say here what the thesis has";
    EXPECT_DOUBLE_EQ(value, wanted->second) << name;
  }
  EXPECT_EQ(found.numbers.size(), expected.numbers.size());
}

TEST(ThesisPresets, HoldEveryNumberOfTheThesis) {
  expect_equal(localiser_preset("thesis").value(), thesis());
}

TEST(ThesisPresets, HardIsTheSameWithTwiceTheBlurCovariance) {
  FieldValues hard = thesis();
  hard.numbers["blur-position"] = std::sqrt(2.0);  // section 4.2: diag(2, 2, 0.2)
  hard.numbers["blur-yaw"] = std::sqrt(0.2);
  expect_equal(localiser_preset("thesis-hard").value(), hard);
}

TEST(ThesisPresets, LiteralAlphaIsTheSameWithEquationThreeSixAsPrinted) {
  FieldValues literal = thesis();
  literal.choices["alpha"] = "share";
  expect_equal(localiser_preset("thesis-literal-alpha").value(), literal);
}

TEST(ThesisPresets, StartFromThePriorOfTheThesis) {
  const GaussianPrior prior;
  EXPECT_DOUBLE_EQ(prior.position_sigma_m * prior.position_sigma_m, 5.0);  // diag(5, 5, 0.25)
  EXPECT_DOUBLE_EQ(prior.yaw_sigma_rad * prior.yaw_sigma_rad, 0.25);
  EXPECT_EQ(prior.mean_in_enu.x_m, 0.0);
  EXPECT_EQ(prior.mean_in_enu.y_m, 0.0);
  EXPECT_EQ(prior.mean_in_enu.yaw_rad, 0.0);
}

TEST(ThesisPresets, CollapseWithTheTopviewOfSectionThreeFour) {
  const TopviewOptions topview;
  EXPECT_EQ(topview.min_votes, 1);            // beta = 1 in simulation
  EXPECT_EQ(topview.max_range_m, 20.0);       // section 4.2, depth range of easy and medium
  EXPECT_EQ(topview.lane_marking_vote, 1.0);  // weighted up in the real flight alone
  EXPECT_EQ(topview.curb_vote, 1.0);
}

}  // namespace presets_test
}  // namespace nadir
