// SPDX-License-Identifier: Apache-2.0
#include "app/cli/misuse.h"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.h"
#include "tests/app/program.h"

namespace nadir {
namespace misuse_test {

/// Nothing on standard output, and one sentence by `command` that holds `complaint` and says where help is.
void expect_refused(const std::vector<std::string>& words,
                    const std::string& command,
                    const std::string& complaint,
                    int status) {
  const auto refused = run_program(words);
  EXPECT_EQ(refused.status, status) << complaint;
  EXPECT_EQ(refused.out, "");
  EXPECT_EQ(refused.err, command + ": " + complaint + "; see '" + command + " --help'\n");
}

void expect_misused(const std::vector<std::string>& words,
                    const std::string& command,
                    const std::string& complaint) {
  expect_refused(words, command, complaint, 2);
}

void expect_failed(const std::vector<std::string>& words,
                   const std::string& command,
                   const std::string& complaint) {
  expect_refused(words, command, complaint, 1);
}

TEST(Misuse, OfAnUnknownFlagIsToldWithTheNearestOne) {
  expect_misused({"localise", "f", "--mapp", "town"}, "nadir localise",
                 "--mapp: no such flag (did you mean --map?)");
  expect_misused({"localise", "f", "--map", "town", "--partikles=5"}, "nadir localise",
                 "--partikles: no such flag (did you mean --particles?)");
  expect_misused({"map", "info", "town", "--jsn"}, "nadir map info",
                 "--jsn: no such flag (did you mean --json?)");
  expect_misused({"localise", "-x"}, "nadir localise", "-x: no such flag");
  expect_misused({"-x"}, "nadir", "-x: no such flag");
}

TEST(Misuse, OfAnUnknownCommandIsToldWithTheNearestOne) {
  expect_misused({"localize"}, "nadir", "'localize' is not a command (did you mean localise?)");
  expect_misused({"map", "inf", "town"}, "nadir map",
                 "'inf' is not one of its commands (did you mean info?)");
}

TEST(Misuse, ByAMissingCommandNamesThoseThereAre) {
  expect_misused({"map"}, "nadir map", "a command is missing: info, import, export or check");
  expect_misused({"flight", "--json", "f"}, "nadir flight",
                 "--json: a flag stands after the command, which is info");
}

TEST(Misuse, ByMissingArgumentsNamesThemAll) {
  expect_misused({"localise", "--map", "town"}, "nadir localise", "FLIGHT is missing");
  expect_misused({"localise", "f"}, "nadir localise", "--map is missing");
  expect_misused({"localise"}, "nadir localise", "FLIGHT and --map are missing");
  expect_misused({"evaluate", "--json"}, "nadir evaluate", "RUN is missing");
}

TEST(Misuse, ByAMissingValueSaysWhatTheFlagTakes) {
  expect_misused({"localise", "f", "--map"}, "nadir localise",
                 "--map: its value is missing (--map MAP)");
  expect_misused({"localise", "f", "--prior", "--map", "town"}, "nadir localise",
                 "--prior: its value is missing (--prior E,N,YAW)");
}

// Whatever is wrong with a value, the status is the same.
TEST(WrongValue, ThatIsEmptyFailsAsAnyOther) {
  expect_failed({"localise", "f", "--map", ""}, "nadir localise", "--map: its value is empty");
  expect_failed({"localise", "f", "--map="}, "nadir localise", "--map: its value is empty");
  expect_failed({"localise", "", "--map", "town"}, "nadir localise", "FLIGHT: is empty");
  expect_failed({"localise", "f", "--map", "m", "--frames", ""}, "nadir localise",
                "--frames: its value is empty");
  expect_failed({"gui", "--size", ""}, "nadir gui", "--size: its value is empty");
  expect_failed({"gui", "--size", "big"}, "nadir gui",
                "--size: 'big' is neither WIDTH nor WIDTHxHEIGHT in pixels");
  // The first fault is told, with its own status.
  expect_misused({"localise", "f", "--mapp", ""}, "nadir localise",
                 "--mapp: no such flag (did you mean --map?)");
}

TEST(Misuse, ByTooManyWordsNamesTheFirst) {
  expect_misused({"localise", "f", "g", "h", "--map", "town"}, "nadir localise",
                 "'g' is one argument too many");
  expect_misused({"localise", "f", "--map", "a", "--map", "b"}, "nadir localise",
                 "--map: is given twice");
  expect_misused({"localise", "f", "--map", "town", "--json=yes"}, "nadir localise",
                 "--json: takes no value");
}

TEST(Misuse, ByFlagsThatDoNotGoTogetherNamesBoth) {
  expect_misused({"localise", "f", "--map", "m", "--global", "--prior", "1,2,3"}, "nadir localise",
                 "--prior and --global exclude each other");
  expect_misused({"evaluate", "r", "--csv", "--json"}, "nadir evaluate",
                 "--json and --csv exclude each other");
  expect_misused({"simulate", "m", "--out", "f", "--odometry", "o"}, "nadir simulate",
                 "--odometry: goes only with --truth");
}

TEST(WrongValue, FailsAndSaysWhatWouldBeRight) {
  expect_failed({"localise", "f", "--map", "m", "--frames", "abc"}, "nadir localise",
                "--frames: 'abc' is not a whole number from 1 on");
  expect_failed({"demo", "--threads", "1025"}, "nadir demo",
                "--threads: '1025' is not a whole number from 0 to 1024");
  expect_failed({"evaluate", "r", "--align", "se3"}, "nadir evaluate",
                "--align: 'se3' is not one of none, se2, sim2 (did you mean se2?)");
  expect_failed({"map", "import", "s", "--out", "o", "--inside", "3"}, "nadir map import",
                "--inside: '3' is not one of 0, 255");
  expect_failed({"simulate", "m", "--out", "f", "--level", "harsh"}, "nadir simulate",
                "--level: 'harsh' is not one of easy, medium, hard");
  expect_failed({"localise", "f", "--map", "m", "--adapt-particles", "maybe"}, "nadir localise",
                "--adapt-particles: 'maybe' is not true or false");
}

TEST(Misuse, IsForgivenWhereHelpIsAskedFor) {
  const auto help = run_program({"localise", "--mapp", "--help", "--frames", "abc"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.out, run_program({"localise", "-h"}).out);
  EXPECT_EQ(help.err, "");
}

TEST(CheckWords, TakesNegativeNumbersAndAnythingAfterTheMarkAsValues) {
  CLI::App app("", "nadir test");
  std::string place;
  std::vector<std::string> files;
  app.add_option("FILE", files)->required();
  app.add_option("--at", place);
  const std::vector<std::string> words = {"--at", "-33,18", "-", "--", "--odd-name"};
  EXPECT_EQ(cli::check_words(app, words).complaint, "");
  std::ostringstream out;
  ASSERT_EQ(cli::parse_arguments(app, words, out, out), std::nullopt) << out.str();
  EXPECT_EQ(place, "-33,18");
  EXPECT_THAT(files, testing::UnorderedElementsAre("-", "--odd-name"));
}

TEST(ValueChecks, AreEmptyWhereTheTextIsFine) {
  EXPECT_EQ(cli::is_whole_number(0, 8)("8"), "");
  EXPECT_EQ(cli::is_number()("-2.5e-3"), "");
  EXPECT_EQ(cli::is_one_of({"a", "b"})("b"), "");
  for (const char* bad : {"9", "-1", "1.0", "0x1", "", " 1", "99999999999999999999"}) {
    EXPECT_NE(cli::is_whole_number(0, 8)(bad), "") << bad;
  }
  for (const char* bad : {"nan", "inf", "", "1,5", "1m", "1e999"}) {
    EXPECT_NE(cli::is_number()(bad), "") << bad;
  }
}

TEST(BlameFile, MakesAWrongOptionAFaultOfTheFileAndLeavesOtherFaultsAlone) {
  EXPECT_EQ(cli::blame_file({ErrorCode::kInvalidOptions, "r.toml: x"}).code, ErrorCode::kMalformed);
  EXPECT_EQ(cli::blame_file({ErrorCode::kNotFound, "r.toml: x"}).code, ErrorCode::kNotFound);
}

}  // namespace misuse_test
}  // namespace nadir
