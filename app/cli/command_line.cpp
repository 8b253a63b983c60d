// SPDX-License-Identifier: Apache-2.0
#include "app/cli/command_line.h"

#include <array>
#include <csignal>
#include <exception>
#include <vector>

#include "app/cli/arguments.h"
#include "core/base/settings.h"
#include "core/base/version.h"

namespace nadir::cli {
namespace {

constexpr std::array kCommands = {
    Command{"gui", "Open the window: replay runs, see why, run again, compare", run_gui},
    Command{"demo", "Localise a made-up flight on the bundled town and print the errors", run_demo},
    Command{"simulate", "Make a flight with known truth on a labelled overhead", run_simulate},
    Command{"localise", "Localise a flight on a labelled overhead", run_localise},
    Command{"evaluate", "Print the errors of recorded runs", run_evaluate},
    Command{"figure", "Draw a figure of recorded runs or of a map, without a display", run_figure},
    Command{"report", "Draw every figure of recorded runs with an index page", run_report},
    Command{"label", "Draw labels on a map or an overhead image", run_label},
    Command{"map", "Show, import, export and check labelled overheads", run_map},
    Command{"flight", "Show what a recorded flight holds", run_flight},
};

void print_help(std::ostream& out) {
  out << "Nadir " << kVersion
      << ": localises a low-flying robot on a labelled overhead image\n\n"
         "Usage: nadir COMMAND [ARGUMENTS]\n\nCommands:\n";
  for (const Command& command : kCommands) {
    out << "  " << command.name << std::string(12 - command.name.size(), ' ') << command.summary
        << "\n";
  }
  out << "\n'nadir COMMAND --help' explains a command. 'nadir' alone opens the window;\n"
         "without a display start with 'nadir demo --out demo'.\n"
         "'nadir --version' tells the version.\n"
         "\nResults go to standard output, words to standard error. Exit status:\n"
         "  0  done\n"
         "  1  failed: something about files, what is in them, or a value that is empty or\n"
         "     out of its range\n"
         "  2  misused: an unknown flag or command, a missing argument, flags that exclude\n"
         "     each other\n";
}

int refuse_unknown(const std::string& word, std::ostream& err) {
  std::vector<std::string> names;
  names.reserve(kCommands.size());
  for (const Command& command : kCommands) names.emplace_back(command.name);
  const std::string nearest = nearest_word(word, names);
  const std::string hint = nearest.empty() ? "" : " (did you mean " + nearest + "?)";
  if (word.rfind('-', 0) == 0) return report_misuse(err, "nadir", word + ": no such flag" + hint);
  return report_misuse(err, "nadir", "'" + word + "' is not a command" + hint);
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

int run_command_line(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away is a failed write, not a death
  if (arguments.empty()) return run_gui({}, out, err);
  if (arguments[0] == "--help" || arguments[0] == "-h") {
    print_help(out);
    return kDone;
  }
  if (arguments[0] == "--version") {
    out << "nadir " << kVersion << "\n";
    return kDone;
  }
  for (const Command& command : kCommands) {
    if (command.name != arguments[0]) continue;
    try {
      const int status = command.run(arguments.subspan(1), out, err);
      out.flush();
      if (status == kDone && !out) {
        err << "nadir: the results could not be written to standard output\n";
        return kFailed;
      }
      return status;
    } catch (const std::exception& error) {
      err << "nadir " << command.name << ": internal error: " << error.what() << "\n";
      return kFailed;
    }
  }
  return refuse_unknown(arguments[0], err);
}

}  // namespace nadir::cli
