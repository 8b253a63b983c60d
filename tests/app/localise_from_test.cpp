// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/base/staged_output.h"
#include "core/run/run_file.h"
#include "tests/app/short_flight.h"

namespace nadir {
namespace localise_from_test {

using testing::AllOf;
using testing::HasSubstr;

/// A run of the short flight, of other options than the default.
class LocaliseFrom : public ShortFlight {
 protected:
  static void SetUpTestSuite() {
    ShortFlight::SetUpTestSuite();
    const auto made = run_program(localise(
        {"--out", path("run.nadir"), "--particles", "900", "--seed", "5", "--preset", "thesis"}));
    ASSERT_EQ(made.status, 0) << made.err;
  }
  static RunReader open(const std::string& name) { return RunReader::open(path(name)).value(); }
};

TEST_F(LocaliseFrom, SaysThatTheMapIsNotTheOneOfTheRun) {
  OverheadMap map = street_map(0.2);
  map.name = "crossing";
  map.labels.at(3, 3) = map.labels.at(3, 3) == kRoad ? kCurb : kRoad;
  ASSERT_TRUE(write_overhead_map(map, {.name = "crossing"}, std::nullopt, path("changed-map")));
  const auto on = [](const std::string& name) {
    return run_program({"localise", path("flight"), "--map", path(name), "--from",
                        path("run.nadir") + "@5", "--frames", "2"});
  };
  EXPECT_THAT(on("changed-map").err, HasSubstr("was made on other cells than those of "));
  EXPECT_THAT(on("map").err, testing::Not(HasSubstr("was made on other cells")));
}

TEST_F(LocaliseFrom, GoesOnFromARunWithItsStepsAndItsOptions) {
  const auto made =
      run_program(localise({"--from", path("run.nadir") + "@5", "--out", path("on.nadir"),
                            "--trajectory", path("on.txt"), "--json"}));
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("goes on from step "));
  const RunReader before = open("run.nadir");
  const RunReader on = open("on.nadir");
  EXPECT_TRUE(on.is_complete());
  EXPECT_EQ(on.step_count(), before.step_count());
  EXPECT_EQ(on.header().parent_run, path("run.nadir"));
  EXPECT_EQ(on.header().preset, "thesis");
  for (const char* option : {"particles", "seed", "likelihood", "blur-position"}) {
    EXPECT_EQ(on.header().options.at(option), before.header().options.at(option));
  }
  const auto steps = on.steps().value();
  const auto steps_before = before.steps().value();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].step, steps_before[i].step);
    EXPECT_EQ(steps[i].time_s, steps_before[i].time_s);
    if (steps[i].time_s > *on.header().started_at_s) break;
    EXPECT_EQ(steps[i].estimate.moments.mean, steps_before[i].estimate.moments.mean);
    EXPECT_EQ(on.step(steps[i].step)->particles, before.step(steps[i].step)->particles);
  }
  // Evaluation and trajectory are of the whole.
  EXPECT_EQ(run_program({"evaluate", path("on.nadir"), "--json"}).out, made.out);
  const std::string trajectory = read_text_file(path("on.txt")).value();
  std::size_t poses = 0;
  for (std::size_t at = 0; at < trajectory.size(); at = trajectory.find('\n', at) + 1) {
    if (trajectory[at] != '#') ++poses;
  }
  EXPECT_EQ(poses, steps.size());
}

TEST_F(LocaliseFrom, LetsFlagsPresetsAndRecipesWin) {
  const std::string from = path("run.nadir") + "@5";
  const auto flag = run_program(localise({"--from", from, "--particles", "700", "--frames", "20",
                                          "--quiet", "--out", path("flag.nadir")}));
  ASSERT_EQ(flag.status, 0) << flag.err;
  EXPECT_EQ(open("flag.nadir").header().options.at("particles"), "700");
  EXPECT_EQ(open("flag.nadir").header().options.at("likelihood"), "thesis");
  ASSERT_EQ(run_program(localise({"--from", from, "--preset", "default", "--frames", "3", "--quiet",
                                  "--out", path("preset.nadir")}))
                .status,
            0);
  EXPECT_EQ(open("preset.nadir").header().preset, "default");
  EXPECT_EQ(open("preset.nadir").header().options.at("particles"), "10000");
  const auto own = open("preset.nadir").steps().value();
  const double started_at_s = *open("preset.nadir").header().started_at_s;
  EXPECT_EQ(std::count_if(own.begin(), own.end(),
                          [&](const RunStep& step) { return step.time_s > started_at_s; }),
            3);
}

TEST_F(LocaliseFrom, GivesTheSameOnOneAndOnTwoThreads) {
  const auto json_on = [](const char* threads) {
    return run_program(
        localise({"--from", path("run.nadir") + "@5", "--json", "--threads", threads}));
  };
  const auto one = json_on("1");
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_EQ(one.out, json_on("2").out);
}

TEST_F(LocaliseFrom, GoesOnFromARunThatWentOn) {
  ASSERT_EQ(run_program(localise({"--from", path("run.nadir") + "@5", "--frames", "8", "--quiet",
                                  "--out", path("first.nadir")}))
                .status,
            0);
  const auto again = run_program(
      localise({"--from", path("first.nadir") + "@6", "--quiet", "--out", path("second.nadir")}));
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(open("second.nadir").step_count(), open("run.nadir").step_count());
  EXPECT_EQ(open("second.nadir").header().parent_run, path("first.nadir"));
}

TEST_F(LocaliseFrom, RefusesMomentsThatAreNone) {
  const auto refused = [](const std::string& from, const std::string& fault, int status = 1) {
    expect_refused(localise({"--from", from, "--out", path("refused.nadir"), "--quiet"}), fault,
                   status);
  };
  const std::string run = path("run.nadir");
  refused(run, "is not a run file and a time in seconds, RUN@SECONDS", 2);
  refused(run + "@", "is not a run file and a time", 2);
  refused(run + "@now", "is not a run file and a time", 2);
  refused("@5", "is not a run file and a time", 2);
  refused(run + "@1e6", "--from: " + run + ": holds 0 to ");
  refused(run + "@-1", "and -1 s to go on from is not among them");
  refused(path("none.nadir") + "@5", "--from: " + path("none.nadir"));
  ASSERT_EQ(run_program(localise({"--no-particles", "--frames", "9", "--out", path("bare.nadir")}))
                .status,
            0);
  refused(path("bare.nadir") + "@0.5", "holds no particles of step");
}

TEST_F(LocaliseFrom, RefusesAPriorBesideItAndTheRunAsItsOutput) {
  const std::string from = path("run.nadir") + "@5";
  EXPECT_EQ(run_program(localise({"--from", from, "--global"})).status, 2);
  EXPECT_EQ(run_program(localise({"--from", from, "--prior", "8,28,0"})).status, 2);
  const auto onto = run_program(localise({"--from", from, "--out", path("run.nadir")}));
  EXPECT_EQ(onto.status, 2);
  EXPECT_THAT(onto.err, HasSubstr("--out: " + path("run.nadir") + " is the run of --from"));
  const auto over = run_program(localise({"--from", from, "--trajectory", path("run.nadir")}));
  EXPECT_THAT(over.err, HasSubstr("--trajectory: " + path("run.nadir") + " is the run of --from"));
  EXPECT_TRUE(open("run.nadir").is_complete());
}

TEST_F(LocaliseFrom, RefusesAnotherFlight) {
  ASSERT_EQ(
      run_program({"simulate", path("map"), "--route", path("route.toml"), "--out", path("other"),
                   "--image-width", "64", "--image-height", "48", "--seed", "9"})
          .status,
      0);
  expect_refused({"localise", path("other"), "--map", path("map"), "--from",
                  path("run.nadir") + "@5", "--out", path("refused.nadir"), "--quiet"},
                 "is not the flight that " + path("run.nadir") + " was made on");
}

TEST_F(LocaliseFrom, IsExplainedInTheHelp) {
  EXPECT_THAT(run_program({"localise", "--help"}).out,
              AllOf(HasSubstr("--from RUN@SECONDS"), HasSubstr("Go on from a recorded run"),
                    HasSubstr("--from run.nadir@30")));
}

}  // namespace localise_from_test
}  // namespace nadir
