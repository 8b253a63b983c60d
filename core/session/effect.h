// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace nadir {

// What only the window's shell can do: Session asks for it, the shell does it. Those with a job's number report back with
// Session::report_effect() and Session::finish_effect(). All paths are absolute.

struct DrawFigureEffect {
  int job = 0;
  std::string recipe;  ///< Text as parse_figure_recipe() of widgets/figures takes it.
  std::string file;
};
struct WriteReportEffect {
  int job = 0;
  std::vector<std::string> runs;
  std::string map;  ///< Empty: each run's own.
  std::string folder;
};
/// Its `made` is the run that came of it.
struct MakeDemoEffect {
  int job = 0;
  std::string folder;
};
struct SetClipboardEffect {
  std::string text;
};
struct QuitEffect {};

using Effect = std::
    variant<DrawFigureEffect, WriteReportEffect, MakeDemoEffect, SetClipboardEffect, QuitEffect>;

}  // namespace nadir
