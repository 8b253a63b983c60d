// SPDX-License-Identifier: Apache-2.0
#include "app/gui/gui_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <stdexcept>

#include "core/base/settings.h"
#include "core/base/staged_output.h"

namespace nadir {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLongestWaitS = 300.0;

Result<double> number_in(const std::string& word) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    return fail(ErrorCode::kInvalidOptions, "'{}' is not a number", word);
  }
  return value;
}

double since_s(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

Result<void> wait_for(ScriptStage& stage, std::optional<double> seconds) {
  const auto began = Clock::now();
  int frames_at_rest = 0;
  constexpr int kFramesToSettle = 3;  // one shows what came, one asks for what that needs
  while (seconds ? since_s(began) < *seconds : frames_at_rest < kFramesToSettle) {
    stage.screen.frame(stage.draw);
    frames_at_rest = stage.is_at_rest() ? frames_at_rest + 1 : 0;
    if (!seconds && since_s(began) > kLongestWaitS) {
      return fail(ErrorCode::kCancelled, "the window did not come to rest in {:.0f} s",
                  kLongestWaitS);
    }
  }
  return {};
}

Result<void> expect(const ScriptStage& stage, const ScriptLine& line) {
  const kit::Control* const control = stage.screen.find(line.words[1]);
  if (control == nullptr) {
    return fail(ErrorCode::kNotFound, "there is no control '{}'", line.words[1]);
  }
  if (line.words.size() > 2 && control->value != line.words[2]) {
    return fail(ErrorCode::kMalformed, "'{}' shows '{}' and not '{}'", line.words[1],
                control->value, line.words[2]);
  }
  return {};
}

Result<void> write_controls(const ScriptStage& stage, const std::string& file) {
  std::string lines;
  for (const kit::Control& control : stage.screen.controls()) {
    lines += fmt::format("{}\t{}\t{}\n", control.path, enum_name(control.kind), control.value);
  }
  return write_text_file(file, lines);
}

/// How many words a line of the script's own words has, its name counted; nothing for an action.
struct Form {
  std::string_view name;
  std::size_t least, most;
  std::string_view form;
};
constexpr std::array kForms = {
    Form{"click", 2, 2, "click PATH"},
    Form{"double-click", 2, 2, "double-click PATH"},
    Form{"right-click", 2, 2, "right-click PATH"},
    Form{"hover", 2, 2, "hover PATH"},
    Form{"drag", 4, 4, "drag PATH DX DY"},
    Form{"scroll", 3, 3, "scroll PATH NOTCHES"},
    Form{"type", 3, 3, "type PATH TEXT"},
    Form{"press", 2, 2, "press CHORD"},
    Form{"wait", 1, 2, "wait [SECONDS]"},
    Form{"expect", 2, 3, "expect PATH [VALUE]"},
    Form{"expect-not", 2, 2, "expect-not PATH"},
    Form{"expect-words", 2, 2, "expect-words TEXT"},
    Form{"controls", 2, 2, "controls FILE"},
    Form{"resize", 3, 3, "resize WIDTH HEIGHT"},
    Form{"screenshot", 2, 2, "screenshot FILE"},
};

const Form* form_of(const std::string& name) {
  for (const Form& form : kForms) {
    if (form.name == name) return &form;
  }
  return nullptr;
}

/// Gestures; the screen throws where there is no such control or it is disabled.
Result<void> use_hand(const ScriptLine& line, ScriptStage& stage) {
  const std::string& name = line.words[0];
  const std::string& path = line.words[1];
  if (name == "click") stage.screen.click(path, stage.draw);
  if (name == "double-click") stage.screen.double_click(path, stage.draw);
  if (name == "right-click") stage.screen.right_click(path, stage.draw);
  if (name == "hover") stage.screen.hover(path, stage.draw);
  if (name == "type") stage.screen.type(path, line.words[2], stage.draw);
  if (name == "press") stage.screen.press(path, stage.draw);
  if (name == "drag" || name == "scroll") {
    const auto first = number_in(line.words[2]);
    if (!first) return forward_error(first);
    if (name == "scroll") {
      stage.screen.scroll(path, *first, stage.draw);
      return {};
    }
    const auto second = number_in(line.words[3]);
    if (!second) return forward_error(second);
    stage.screen.drag(path, *first, *second, stage.draw);
  }
  return {};
}

Result<void> resize(const ScriptLine& line, ScriptStage& stage) {
  const auto width = number_in(line.words[1]);
  if (!width) return forward_error(width);
  const auto height = number_in(line.words[2]);
  if (!height) return forward_error(height);
  constexpr double kLeast = 200.0;
  constexpr double kMost = 8000.0;
  for (const double side : {*width, *height}) {
    if (!(side >= kLeast && side <= kMost)) {
      return fail(ErrorCode::kInvalidOptions, "{} is not in [{}, {}]", side, kLeast, kMost);
    }
  }
  stage.screen.input().size_px = {*width, *height};
  stage.screen.wait(2, stage.draw);
  return {};
}

Result<void> do_own(const ScriptLine& line, ScriptStage& stage) {
  const std::string& name = line.words[0];
  if (name == "wait") {
    if (line.words.size() == 1) return wait_for(stage, std::nullopt);
    const auto seconds = number_in(line.words[1]);
    if (!seconds) return forward_error(seconds);
    return wait_for(stage, std::min(*seconds, kLongestWaitS));
  }
  if (name == "expect") return expect(stage, line);
  if (name == "expect-not") {
    if (!stage.screen.has(line.words[1])) return {};
    return fail(ErrorCode::kMalformed, "there is a control '{}'", line.words[1]);
  }
  if (name == "expect-words") {
    if (stage.screen.shows(line.words[1])) return {};
    return fail(ErrorCode::kNotFound, "'{}' is nowhere on the screen", line.words[1]);
  }
  if (name == "controls") return write_controls(stage, line.words[1]);
  if (name == "resize") return resize(line, stage);
  if (name == "screenshot") return stage.photograph(line.words[1]);
  return use_hand(line, stage);
}

}  // namespace

const std::vector<std::string>& script_words() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    all.reserve(kForms.size());
    for (const Form& form : kForms) all.emplace_back(form.name);
    return all;
  }();
  return names;
}

Result<std::vector<ScriptLine>> parse_gui_script(std::string_view text, const std::string& name) {
  std::vector<ScriptLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view whole = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ScriptLine line{number, {}, {}};
    std::string word;
    bool is_quoted = false;
    bool is_word = false;
    std::size_t used = 0;
    for (; used < whole.size(); ++used) {
      const char c = whole[used];
      const bool is_blank = c == ' ' || c == '\t' || c == '\r';
      if (c == '#' && !is_quoted && !is_word) break;
      if (c == '\\' && is_quoted && used + 1 < whole.size()) {
        word += whole[++used];
      } else if (c == '"') {
        is_quoted = !is_quoted;
        is_word = true;
      } else if (is_blank && !is_quoted) {
        if (is_word) line.words.push_back(std::exchange(word, {}));
        is_word = false;
      } else {
        word += c;
        is_word = true;
      }
    }
    if (is_quoted) {
      return fail(ErrorCode::kMalformed, "{}:{}: a quote is not closed", name, number);
    }
    if (is_word) line.words.push_back(std::move(word));
    if (line.words.empty()) continue;
    constexpr std::string_view kBlanks = " \t\r";
    const std::string_view kept = whole.substr(0, used);
    const std::size_t first = kept.find_first_not_of(kBlanks);
    line.text = kept.substr(first, kept.find_last_not_of(kBlanks) - first + 1);
    lines.push_back(std::move(line));
  }
  return lines;
}

Result<void> run_script_line(const ScriptLine& line, ScriptStage& stage) {
  const Form* const form = form_of(line.words[0]);
  if (form == nullptr) {
    std::vector<std::string> known = script_words();
    const std::vector<ActionHelp> helps = action_helps();
    known.reserve(known.size() + helps.size());
    for (const ActionHelp& help : helps) known.emplace_back(help.name);
    if (std::find(known.begin(), known.end(), line.words[0]) == known.end()) {
      const std::string nearest = nearest_word(line.words[0], known);
      return fail(ErrorCode::kInvalidOptions, "{}: no such action{}", line.words[0],
                  nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest));
    }
    const auto action = parse_action(line.text);
    if (!action) return forward_error(action);
    auto done = stage.session.apply(*action);
    stage.screen.wait(1, stage.draw);
    return done;
  }
  if (line.words.size() < form->least || line.words.size() > form->most) {
    return fail(ErrorCode::kInvalidOptions, "the form is: {}", form->form);
  }
  try {
    return do_own(line, stage);
  } catch (const std::logic_error& error) {
    return fail(ErrorCode::kNotFound, "{}", error.what());
  }
}

Result<void> run_gui_script(std::string_view text, const std::string& name, ScriptStage& stage) {
  const auto lines = parse_gui_script(text, name);
  if (!lines) return forward_error(lines);
  for (const ScriptLine& line : *lines) {
    if (auto done = run_script_line(line, stage); !done) {
      return forward_error(done, fmt::format("{}:{}", name, line.number));
    }
  }
  return {};
}

}  // namespace nadir
