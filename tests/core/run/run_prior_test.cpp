// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_prior.h"

#include "core/run/localise_flight.h"
#include "tests/core/run/recorded_run.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace run_prior_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(PriorText, GivesTheSamePriorAgainToTheLastBit) {
  const GaussianPrior near{
      .mean_in_enu = {1.0 / 3.0, -1e-9, 2.5}, .position_sigma_m = 0.1, .yaw_sigma_rad = 1.0 / 7.0};
  const auto read = parse_prior_text(prior_text(Prior(near)));
  ASSERT_TRUE(read) << error_text(read);
  const auto& again = std::get<GaussianPrior>(read->value());
  EXPECT_EQ(again.mean_in_enu, near.mean_in_enu);
  EXPECT_EQ(again.position_sigma_m, near.position_sigma_m);
  EXPECT_EQ(again.yaw_sigma_rad, near.yaw_sigma_rad);
  const auto anywhere = parse_prior_text(prior_text(Prior(GlobalPrior{})));
  ASSERT_TRUE(anywhere && *anywhere);
  EXPECT_TRUE(std::holds_alternative<GlobalPrior>(**anywhere));
  const auto truth = parse_prior_text(prior_text(std::nullopt));
  ASSERT_TRUE(truth) << error_text(truth);
  EXPECT_FALSE(*truth);
}

TEST(PriorText, RefusesWhatIsNone) {
  for (const char* text :
       {"", "somewhere", "particles of step 3 of a.nadir", "1 m east, 2 m north, yaw 3 rad",
        "1 m east, 2 m north, yaw 3 rad; sigma 4 m, 5 rad and more",
        "1 m east, nan m north, yaw 3 rad; sigma 4 m, 5 rad",
        "1 m east, 2 m north, yaw 3 rad; sigma -4 m, 5 rad"}) {
    EXPECT_EQ(error_code(parse_prior_text(text)), ErrorCode::kMalformed) << text;
  }
}

class RecordedPrior : public testing::Test {
 protected:
  /// A run that began so, or that goes on from another.
  RunHeader record(const fs::path& path, const std::string& prior, const std::string& parent = {}) {
    RunHeader header = example_header();
    header.options[kPriorOption] = prior;
    header.parent_run = parent;
    if (!parent.empty()) header.started_at_s = 0.1;
    auto writer = RunWriter::create(path, header).value();
    EXPECT_TRUE(writer.write(example_step(0)));
    EXPECT_TRUE(writer.finish());
    return header;
  }
  [[nodiscard]] fs::path path(const char* name) const { return scratch_.path() / name; }

  ScratchFolder scratch_;
};

TEST_F(RecordedPrior, IsThatOfTheFirstOfRunsThatGoOnFromEachOther) {
  const RunHeader first = record(path("first.nadir"), "global");
  record(path("second.nadir"), "particles of step 3 of first.nadir", "first.nadir");
  const RunHeader third =
      record(path("third.nadir"), "particles of step 5 of second.nadir", "/elsewhere/second.nadir");
  for (const auto& [name, header] :
       {std::pair("first.nadir", &first), std::pair("third.nadir", &third)}) {
    const auto prior = recorded_prior(path(name), *header);
    ASSERT_TRUE(prior) << error_text(prior);
    ASSERT_TRUE(*prior) << name;
    EXPECT_TRUE(std::holds_alternative<GlobalPrior>(**prior)) << name;
  }
}

TEST_F(RecordedPrior, IsRefusedInWordsWhereNobodyKnowsIt) {
  const RunHeader orphan =
      record(path("orphan.nadir"), "particles of step 3 of gone.nadir", "gone.nadir");
  EXPECT_THAT(error_text(recorded_prior(path("orphan.nadir"), orphan)),
              HasSubstr("orphan.nadir: goes on from gone.nadir, which is not there"));
  const RunHeader circle =
      record(path("circle.nadir"), "particles of step 3 of circle.nadir", "circle.nadir");
  EXPECT_FALSE(recorded_prior(path("circle.nadir"), circle)) << "a run is not its own parent";
  RunHeader silent = example_header();
  EXPECT_THAT(error_text(recorded_prior("silent.nadir", silent)),
              HasSubstr("silent.nadir: does not say how its flight began"));
  RunHeader other = orphan;
  other.flight_hash = "another";
  other.parent_run = "orphan.nadir";
  EXPECT_THAT(error_text(recorded_prior(path("other.nadir"), other)),
              HasSubstr("of another flight now"));
}

}  // namespace run_prior_test
}  // namespace nadir
