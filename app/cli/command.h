// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <span>
#include <string>
#include <string_view>

namespace nadir::cli {

inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;   ///< By a file, by what is in it, or by a value that cannot be.
inline constexpr int kMisused = 2;  ///< The words of the command line are not those that there are.

/// One command of the program. Results go to `out`, words to `err`.
struct Command {
  std::string_view name;
  std::string_view summary;
  int (*run)(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);
};

int run_demo(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);
int run_simulate(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);
int run_localise(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);
int run_evaluate(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);
int run_figure(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);
int run_report(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);
int run_map(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);
int run_flight(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);
int run_gui(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);
/// The same with labels of a map or image in front.
int run_label(std::span<const std::string> arguments, std::ostream& out, std::ostream& err);

}  // namespace nadir::cli
