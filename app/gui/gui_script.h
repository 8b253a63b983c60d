// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/session/session.h"
#include "widgets/kit/headless_ui.h"

namespace nadir {

/// What a script drives.
struct ScriptStage {
  Session& session;
  kit::HeadlessUi& screen;
  std::function<void(kit::Ui&)> draw;  ///< One frame of the whole window.
  std::function<bool()> is_at_rest;    ///< Nothing is being read, drawn finer or computed.
  std::function<Result<void>(const std::filesystem::path&)>
      photograph;  ///< The last frame, as PNG.
};

/// A line of a script, with its number for messages. Words are separated by blanks; "double quotes" hold one together.
struct ScriptLine {
  int number = 1;
  std::string text;                ///< Without comment and blanks at its ends; never empty.
  std::vector<std::string> words;  ///< At least one.
};

/// Everything after a # that begins a word is a comment. @param name  Stands for the file in messages.
/// @errors kMalformed: a quote that is not closed, naming the line.
[[nodiscard]] Result<std::vector<ScriptLine>> parse_gui_script(std::string_view text,
                                                               const std::string& name);

/// Does one line: any action by its words ("seek 12.5"), or one of
///   click PATH, double-click PATH, right-click PATH, hover PATH, drag PATH DX DY, scroll PATH NOTCHES, type PATH TEXT,
///   press CHORD              what a hand does to a control, which is named by its path
///   wait [SECONDS]           until nothing moves any more, or so long
///   expect PATH [VALUE]      fails where there is no such control, or it does not show the value
///   expect-not PATH          fails where there is
///   expect-words TEXT        fails where the text is nowhere on the screen
///   controls FILE            writes the path, kind and value of every control
///   resize WIDTH HEIGHT
///   screenshot FILE
/// @errors what failed, in one sentence, without the line's number.
[[nodiscard]] Result<void> run_script_line(const ScriptLine& line, ScriptStage& stage);

/// All lines, until one fails. @errors as above, with file and line before: "tour.txt:12: ...".
[[nodiscard]] Result<void> run_gui_script(std::string_view text,
                                          const std::string& name,
                                          ScriptStage& stage);

/// The names of what a script can do beside actions, for help and for errors.
[[nodiscard]] const std::vector<std::string>& script_words();

}  // namespace nadir
