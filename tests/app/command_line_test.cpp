// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.h"

#include <gmock/gmock.h>

#include "app/cli/arguments.h"
#include "tests/app/program.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace command_line_test {

using testing::HasSubstr;

TEST(CommandLine, ListsEveryCommandInItsHelp) {
  const auto help = run_program({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const cli::Command& command : cli::commands()) {
    EXPECT_THAT(help.out, HasSubstr(std::string(command.summary)));
  }
}

TEST(CommandLine, HelpsWithEveryCommandOnStandardOutput) {
  for (const cli::Command& command : cli::commands()) {
    const auto help = run_program({std::string(command.name), "--help"});
    EXPECT_EQ(help.status, 0) << command.name;
    EXPECT_THAT(help.out, HasSubstr("Usage: nadir " + std::string(command.name)));
    EXPECT_EQ(help.err, "");
  }
}

TEST(CommandLine, NamesTheNearestCommandToAMisspeltOne) {
  const auto misspelt = run_program({"localize"});
  EXPECT_EQ(misspelt.status, 2);
  EXPECT_THAT(misspelt.err, HasSubstr("did you mean localise?"));
}

TEST(CommandLine, OpensTheWindowWithoutACommandAndSaysSoWhereThereIsNoDisplay) {
  const auto opened = run_program({});  // the test runs without a display
  EXPECT_EQ(opened.status, 1);
  EXPECT_THAT(opened.err, HasSubstr("no display"));
  EXPECT_THAT(opened.err, HasSubstr("nadir --help"));
}

TEST(CommandLine, TellsItsVersion) {
  EXPECT_THAT(run_program({"--version"}).out,
              testing::MatchesRegex("nadir [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(ParseList, TakesExactlySoManyFiniteNumbers) {
  EXPECT_THAT(cli::parse_list("--x", "1,-2.5,3e2", 3).value(),
              testing::ElementsAre(1.0, -2.5, 300.0));
  for (const char* bad :
       {"", "1,2", "1,2,3,4", "1,,3", "1,2,nan", "1,2,inf", "1,2,3x", " 1,2,3", "1,2,3,"}) {
    EXPECT_FALSE(cli::parse_list("--x", bad, 3).has_value()) << bad;
  }
}

TEST(FindBundled, FindsTheTownFromAnywhereButPrefersWhatIsThere) {
  EXPECT_TRUE(std::filesystem::exists(cli::find_bundled("maps/proving-ground") / "map.toml"));
  EXPECT_EQ(cli::find_bundled("no/such/map"), "no/such/map");
  const ScratchFolder scratch;
  EXPECT_EQ(cli::find_bundled(scratch.path()), scratch.path());
}

}  // namespace command_line_test
}  // namespace nadir
