// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/figure_run.h"

#include <gmock/gmock.h>

#include "core/run/run_options.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/figures/run_lines.h"
#include "widgets/figures/timed_figure.h"

namespace nadir {
namespace figure_run_test {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

class OpenedRun : public ::testing::Test {
 protected:
  FigureRun open(const std::string& name,
                 const RunFaults& faults,
                 const FigureOptions& chosen = {}) {
    const auto path = scratch_.path() / name;
    if (!std::filesystem::exists(path)) write_drive(path, scratch_.path() / "map", 10, faults);
    auto run = open_figure_run(path, chosen);
    if (!run) throw std::runtime_error(run.error().message);
    return *run;
  }

  ScratchFolder scratch_;
};

TEST_F(OpenedRun, SaysInItsFootWhetherItWasStoppedBeforeItsEnd) {
  const FigureRun whole = open("whole.nadir", {});
  EXPECT_TRUE(whole.evaluation.is_complete);
  EXPECT_THAT(foot_of(whole), Not(HasSubstr("stopped")));
  const FigureRun killed = open("killed.nadir", {.is_finished = false});
  EXPECT_FALSE(killed.evaluation.is_complete);
  EXPECT_THAT(foot_of(killed), HasSubstr(" · stopped before its end · "));
  EXPECT_THAT(foot_of(killed), HasSubstr("10 matched pairs"));
  EXPECT_THAT(foot_of(killed),
              HasSubstr(fmt::format("position RMSE {:.2f} m",
                                    killed.evaluation.estimate->position_m.root_mean_square)));
}

TEST(MadeWords, TellWhatWasSetBesideThePreset) {
  RunHeader header;
  header.preset = "default";
  header.seed = 7;
  for (const OptionText& option : option_texts(*run_preset("default"))) {
    header.options[option.name] = option.value;
  }
  EXPECT_EQ(made_words(header, 100.0), "preset default, seed 7");
  header.options["temperature"] = "0.05";
  header.options["translation-noise"] = "9";  // no effect while motion = scaled
  EXPECT_EQ(made_words(header, 100.0), "preset default with temperature 0.05, seed 7");
  header.parent_run = "flights/run.nadir";
  header.started_at_s = 166.5;
  EXPECT_EQ(made_words(header, 100.0),
            "preset default with temperature 0.05, seed 7, gone on from run.nadir after 66.5 s");
  for (const char* const name : {"particles", "min-particles", "max-cells", "min-votes"}) {
    header.options[name] = "17";
  }
  EXPECT_THAT(made_words(header, 100.0), HasSubstr(" and 1 more, seed 7"));
  header.preset = "of-another-version";
  EXPECT_THAT(made_words(header, 100.0), HasSubstr("preset of-another-version, seed 7"));
}

TEST_F(OpenedRun, IsSaidToBeStoppedAlsoWhereTheFootNamesOnlyTheFirstRuns) {
  std::vector<FigureRun> runs(6, open("whole.nadir", {}));
  EXPECT_THAT(foot_of_all(runs), Not(HasSubstr("stopped")));
  runs[5] = open("killed.nadir", {.is_finished = false});
  EXPECT_THAT(foot_of_all(runs), HasSubstr(" | and 2 more | killed: stopped before its end"));
}

/// Times of day in seconds since 1970, as recorders write them: a tenth of a second apart, each rounded by itself.
FigureRun run_by_day(int steps) {
  FigureRun run;
  for (int i = 0; i < steps; ++i) {
    RunStep step;
    step.time_s = static_cast<double>(1'700'000'000'300'001 + 100'000LL * i) / 1e6;
    run.steps.push_back(step);
  }
  run.start_s = run.steps.front().time_s;
  return run;
}

TEST(FigureRun, FindsEachStepAtItsTimeAlsoByTimesOfDay) {
  const FigureRun run = run_by_day(2000);
  for (int i = 0; i < 2000; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_EQ(run.index_at(0.1 * i), at);
    EXPECT_EQ(run.index_at(run.elapsed_s(run.steps[at])), at);
    EXPECT_EQ(run.index_at(0.1 * i + 0.09), at);
  }
  EXPECT_EQ(run.index_at(-5.0), 0U);
  EXPECT_EQ(run.index_at(1e9), 1999U);
}

TEST_F(OpenedRun, KeepsTheStepsAtBothEndsOfATimeByDay) {
  FigureOptions part;
  for (const double offset_s : {0.0, 0.1, 0.2, 0.3, 0.4, 0.123456}) {
    const std::string name = std::to_string(offset_s) + ".nadir";
    part.from_s = 1.0;
    part.to_s = 2.5;
    const FigureRun run = open(name, {.first_time_s = 1.7e9 + offset_s}, part);
    EXPECT_THAT(run.steps, SizeIs(4)) << name;
    part.from_s = 1.0 + 2.4e-7;  // a step of a double further
    part.to_s = 2.5 - 2.4e-7;
    EXPECT_THAT(open(name, {}, part).steps, SizeIs(4)) << name;
  }
}

/// Shows what figures with times are told.
class Timed : public TimedFigure {
 public:
  explicit Timed(FigureInputs inputs) : TimedFigure(std::move(inputs)) {}
  Result<void> draw(Canvas& /*canvas*/, FigureContext& /*context*/) override { return {}; }
  using TimedFigure::index;
  using TimedFigure::is_moment_in_runs;
};

TEST(TimedFigure, MarksTheMomentOfTheLastFrameThoughItsTimeIsRounded) {
  FigureInputs inputs;
  inputs.runs = {run_by_day(148)};
  Timed figure(std::move(inputs));
  const double last_s = figure.times()->last_s;
  for (const double time_s : {0.0, last_s, last_s + 2.4e-7, 147 * 0.1, -2.4e-7}) {
    figure.show_at(time_s);
    EXPECT_TRUE(figure.is_moment_in_runs()) << time_s - last_s;
  }
  figure.show_at(last_s + 2.4e-7);
  EXPECT_EQ(figure.index(), 147U);
  for (const double time_s : {last_s + 1e-3, -1e-3, 1e9}) {
    figure.show_at(time_s);
    EXPECT_FALSE(figure.is_moment_in_runs()) << time_s;
  }
}

}  // namespace figure_run_test
}  // namespace nadir
