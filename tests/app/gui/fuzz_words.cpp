// SPDX-License-Identifier: Apache-2.0
#include "tests/app/gui/fuzz_words.h"

#include <map>
#include <utility>

#include "core/desk/label_tool.h"
#include "core/run/run_options.h"

namespace nadir {
namespace {

using Words = std::vector<std::string>;

/// What makes sense where a form says this, and a little beyond.
const std::map<std::string_view, Words>& sensible_words() {
  static const std::map<std::string_view, Words> words = {
      {"SECONDS", {"0", "0.25", "1.5", "3", "7.75", "1000", "-1"}},
      {"FROM", {"0", "1", "2.5"}},
      {"TO", {"3", "4.5", "9", "0"}},
      {"COUNT", {"1", "-1", "10", "-10", "1000"}},
      {"PLACE", {EnumNames<Moment>::kNames.begin(), EnumNames<Moment>::kNames.end()}},
      {"FACTOR", {"0", "0.1", "0.5", "0.75", "1", "1.5", "2", "3", "20"}},
      {"EAST", {"0", "25.5", "40", "-300"}},
      {"NORTH", {"0", "28", "31.25", "900"}},
      {"METRES", {"0.1", "15", "60", "4000", "1000000"}},
      {"DEGREES", {"0", "15", "-90", "180", "721"}},
      {"INDEX", {"0", "7", "299", "300", "-1"}},
      {"SHARE", {"0", "0.35", "1", "1.0001"}},
      {"#RRGGBB", {"#12AB9f", "#000000", "#FFFFFF", "red"}},
      {"PLACES", {"1", "-1", "3", "-20"}},
      {"POINTS", {"16", "34", "60", "160", "240", "400", "900", "1200"}},
      {"MEGABYTES", {"16", "64", "256", "1024", "15"}},
      {"RUN", {"1", "1", "2", "2", "3", "4", "0"}},
      {"NUMBER", {"1", "2", "0"}},
      {"NOTICE", {"1", "2", "5", "12"}},
      {"JOB", {"1", "2", "3", "9"}},
      {"FIGURE", {"moment", "flight", "cdf", "labels", "error-surface", "no-such-figure"}},
      {"CLASS", {"road", "curb", "building", "terrain", "lane marking", "unclassified", "nothing"}},
      {"NEW-CLASS", {"road", "sidewalk", "unclassified"}},
      {"EAST,NORTH...", {"20,20", "30,20", "30,30.5", "20,30", "25.25,28", "45,21", "-300,900"}},
      {"OBJECT...", {"1", "2", "3", "7"}},
      {"OBJECT", {"1", "2", "3", "5"}},
      {"RING", {"0", "0", "1"}},
      {"CORNER", {"0", "1", "2", "3"}},
      {"REACH", {"0", "0.5", "2"}},
      {"WEST", {"0", "20", "28"}},
      {"SOUTH", {"0", "15", "28"}},
      {"WIDTH", {"0.2", "3.5", "12"}},
      {"THICKNESS", {"0.3", "1"}},
      {"RADIUS", {"0.25", "1.5", "6"}},
      {"PROFILE", {"residential street", "main road", "no-such-street"}},
      {"VALUE", {"1", "300", "0.5", "true", "off", "0", "-2", "1e-9", "systematic"}},
  };
  return words;
}

/// Where numbers end.
const Words kEdges = {"0",    "-0",    "1",     "-1",         "1e-300",      "1e300",
                      "1e9",  "-1e9",  "0.1",   "2147483647", "-2147483648", "4294967296",
                      "1e15", "-1e15", "1e-12", "0.5",        "99",          "1e308"};
const Words kNonsense = {"nan",  "inf", "-inf", "abc",   "",  "1e400", "99999999999999999999",
                         "1,5",  "--",  "\"",   "\\",    "#", "5 m",   "\xff\xfe",
                         "0x10", "+3",  ".",    "on off"};

/// As a line of words has it.
std::string quoted(const std::string& word) {
  const bool is_plain =
      !word.empty() && word.front() != '"' && word.find_first_of(" \t\r\n") == std::string::npos;
  if (is_plain) return word;
  std::string text = "\"";
  for (const char letter : word) {
    if (letter == '\n') {
      text += "\\n";
      continue;
    }
    if (letter == '"' || letter == '\\') text += '\\';
    text += letter;
  }
  return text + '"';
}

/// "{on|off|toggle}" as its words; of anything else nothing.
Words choices_of(std::string_view name) {
  Words words;
  if (name.empty() || name.front() != '{') return words;
  name = name.substr(1, name.size() - 2);
  while (true) {
    const std::size_t bar = name.find('|');
    words.emplace_back(name.substr(0, bar));
    if (bar == std::string_view::npos) return words;
    name.remove_prefix(bar + 1);
  }
}

template <typename Enum>
Words names_of() {
  return {EnumNames<Enum>::kNames.begin(), EnumNames<Enum>::kNames.end()};
}

}  // namespace

FuzzWords::FuzzWords(std::uint64_t seed, std::vector<std::string> paths)
    : random_(seed), paths_(std::move(paths)) {
  for (const OptionText& option : option_texts(RunOptions{})) options_.push_back(option.name);
  for (const OptionText& option : option_texts(LabelTool{})) tool_options_.push_back(option.name);
}

std::size_t FuzzWords::below(std::size_t count) {
  return static_cast<std::size_t>(random_() % count);
}

bool FuzzWords::chance(double share) { return between(0.0, 1.0) < share; }

double FuzzWords::between(double least, double most) {
  constexpr double kStep = 1.0 / 9007199254740992.0;  // 53 bits
  return least + (most - least) * static_cast<double>(random_() >> 11U) * kStep;
}

std::string FuzzWords::action() {
  const bool was_undone = std::exchange(last_, {}) == "undo";
  const ActionHelp& help = one_of(helps_);
  last_ = help.name;
  return was_undone && chance(0.5) ? "redo" : action_of(help);
}

std::string FuzzWords::action_of(const ActionHelp& help) {
  std::string line(help.name);
  std::string_view form = help.form.substr(help.name.size());
  bool takes_group = true;
  while (form.find_first_not_of(' ') != std::string_view::npos) {
    form.remove_prefix(form.find_first_not_of(' '));
    std::string_view name = form.substr(0, form.find(' '));
    form.remove_prefix(name.size());
    if (name.front() == '[') {
      name.remove_prefix(1);
      takes_group = chance(0.7);
    }
    if (name.back() == ']') name.remove_suffix(1);
    const bool takes_many = name.ends_with("...");
    const std::size_t count = takes_many ? 1 + below(5) : 1;
    for (std::size_t i = 0; takes_group && i < count; ++i) {
      line += " " + quoted(argument(help.name, name));
    }
  }
  if (chance(0.02)) line += " " + quoted(one_of(kNonsense));  // too much
  return line;
}

std::string FuzzWords::text() {
  static const Words kTexts = {"",
                               "a",
                               "12.5",
                               "-3",
                               "1e9",
                               "nan",
                               "loop",
                               "the",
                               "theme",
                               "seek 3",
                               "option seed 4",
                               "33.45, -83.9",
                               "25 30",
                               "17S KT 30567 05123",
                               "Ünïcödé ±µ m²",
                               "日本語",
                               "say \"so\" \\ again",
                               "#12AB9f",
                               "two\nlines",
                               "tab\tin it",
                               "\x01\x02",
                               "\xff\xfe",
                               "%s %d {}",
                               "version = 1\n",
                               "a.csv",
                               "b.toml",
                               "c.svg",
                               "no/such/folder/d.svg"};
  if (chance(0.05)) return std::string(300, 'x');
  if (chance(0.15)) return one_of(paths_);
  return one_of(kTexts);
}

std::string FuzzWords::file(std::string_view action) {
  static const Words kEndings = {".svg", ".png", ".pdf", ".mp4", ".csv", ".toml", ".txt", ""};
  std::string ending = one_of(kEndings);
  if (action == "export-table" && chance(0.6)) ending = ".csv";
  if (chance(0.1)) return "no/such/folder/made" + ending;
  return "made-" + std::to_string(files_++ % 20) + ending;
}

std::string FuzzWords::name_for(std::string_view action) {
  static const Words kLayouts = {"default",  "wide map",   "a",           "",
                                 "\xff\xfe", "two\nlines", "größer \"x\""};
  static const Words kPresets = {"default", "run", "thesis", "no-such-preset"};
  if (action == "layout" || action == "save-layout") return one_of(kLayouts);
  if (action == "preset") return chance(0.3) ? one_of(paths_) : one_of(kPresets);
  if (action == "option") return one_of(options_);
  if (action == "label-option") return one_of(tool_options_);
  if (action.starts_with("layer")) return one_of(names_of<Layer>());
  if (action.starts_with("panel")) return one_of(names_of<Panel>());
  return one_of(names_of<Strip>());
}

std::string FuzzWords::argument(std::string_view action, std::string_view name) {
  if (chance(0.06)) return one_of(kNonsense);
  if (const Words choices = choices_of(name); !choices.empty()) return one_of(choices);
  if (name == "NAME") return name_for(action);
  if (name == "PATH") return one_of(paths_);
  if (name == "FILE" || name == "FOLDER") return file(action);
  const auto sensible = sensible_words().find(name);
  if (sensible == sensible_words().end()) return text();
  const bool is_at_edge = name != "VALUE" && chance(0.15);  // of options: a run must stay small
  return is_at_edge ? one_of(kEdges) : one_of(sensible->second);
}

}  // namespace nadir
