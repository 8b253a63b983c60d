// SPDX-License-Identifier: Apache-2.0
#include "app/cli/help_page.h"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>
#include <set>

#include "app/cli/arguments.h"
#include "tests/app/program.h"

namespace nadir {
namespace help_page_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::vector<std::vector<std::string>> every_command() {
  return {{},         {"demo"},           {"simulate"},      {"localise"},      {"evaluate"},
          {"map"},    {"map", "info"},    {"map", "import"}, {"map", "export"}, {"map", "check"},
          {"flight"}, {"flight", "info"}, {"figure"},        {"report"},        {"gui"},
          {"label"}};
}

std::string help_of(std::vector<std::string> command) {
  command.emplace_back("--help");
  const auto help = run_program(command);
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  return help.out;
}

TEST(HelpPage, FitsATerminalOf80Columns) {
  for (const auto& command : every_command()) {
    std::istringstream page(help_of(command));
    for (std::string line; std::getline(page, line);) {
      EXPECT_LE(line.size(), cli::kHelpWidth) << line;
      EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    }
  }
}

TEST(HelpPage, IsTestedForEveryCommandThereIs) {
  std::set<std::string> named;
  for (const auto& command : cli::commands()) named.insert(std::string(command.name));
  for (const auto& command : every_command()) {
    if (!command.empty()) named.erase(command.front());
  }
  EXPECT_TRUE(named.empty()) << *named.begin() << " is missing in every_command()";
}

TEST(HelpPage, SaysWhatTheExitStatusMeans) {
  EXPECT_THAT(help_of({}),
              AllOf(HasSubstr("0  done"), HasSubstr("1  failed: something about files"),
                    HasSubstr("2  misused: an unknown flag or command")));
}

TEST(HelpPage, ShowsChoicesBooleansUnitsRangesAndDefaultsInOneWay) {
  const std::string simulate = help_of({"simulate"});
  EXPECT_THAT(
      simulate,
      AllOf(HasSubstr("--level {easy|medium|hard}\n"), HasSubstr("--label-noise {true|false}\n"),
            HasSubstr("[px], 16 to 4096, default 640"), HasSubstr("draw, 0 or more, default 1")));
  EXPECT_THAT(help_of({"localise"}),
              AllOf(HasSubstr("--preset {default|thesis|thesis-literal-alpha|thesis-hard}\n"),
                    HasSubstr("--threads NUMBER "), HasSubstr("1 or more\n")));
  for (const auto& command : every_command()) {
    EXPECT_THAT(help_of(command), Not(AnyOf(HasSubstr("inf)"), HasSubstr("[0, "), HasSubstr("INT"),
                                            HasSubstr("Excludes"))));
  }
}

TEST(HelpPage, ShowsInTheUsageLineWhatMustBeGiven) {
  EXPECT_THAT(help_of({"localise"}), HasSubstr("Usage: nadir localise FLIGHT --map MAP [FLAGS]\n"));
  EXPECT_THAT(help_of({"evaluate"}), HasSubstr("Usage: nadir evaluate RUN... [FLAGS]\n"));
  EXPECT_THAT(help_of({"map"}), HasSubstr("Usage: nadir map COMMAND [ARGUMENTS]\n"));
  EXPECT_THAT(help_of({"map", "export"}),
              HasSubstr("Usage: nadir map export LABELS --out PATH [FLAGS]\n"));
}

TEST(HelpPage, BreaksLinesBetweenWordsBelowTheFirst) {
  CLI::App app("Does it", "nadir do");
  std::string value;
  CLI::Option* one = app.add_option("--one", value,
                                    "Some words that need more than the one line "
                                    "of eighty columns which there is")
                         ->type_name("FILE");
  app.add_option("--two-with-a-very-long-name", value, "Short")->type_name("FILE")->needs(one);
  app.footer("The end");
  EXPECT_EQ(cli::help_page(app),
            "Does it\n\n"
            "Usage: nadir do [FLAGS]\n\n"
            "Flags:\n"
            "  -h, --help              Print this page\n"
            "  --one FILE              Some words that need more than the one line of eighty\n"
            "                          columns which there is\n"
            "  --two-with-a-very-long-name FILE\n"
            "                          Short; only with --one\n\n"
            "The end\n");
}

}  // namespace help_page_test
}  // namespace nadir
