// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "widgets/panels/command_palette.h"

namespace nadir {
namespace {

[[nodiscard]] std::string_view first_word(std::string_view text) {
  return text.substr(0, text.find(' '));
}

/// The arguments of a form that a begun command lacks: of "layer NAME {on|off}" and "layer roads", the last.
[[nodiscard]] std::string missing_form(const std::string& begun) {
  const auto help = help_of(begun);
  if (!help) return {};
  std::string_view form = help->form;
  const auto words = 1 + std::count(begun.begin(), begun.end(), ' ');
  for (std::ptrdiff_t i = 0; i < words; ++i) {
    const std::size_t end = form.find(' ');
    form = end == std::string_view::npos ? std::string_view() : form.substr(end + 1);
  }
  return std::string(form);
}

/// "{light|dark}" by its words; none for any other form.
[[nodiscard]] std::vector<std::string> words_of(std::string_view form) {
  std::vector<std::string> words;
  if (form.size() < 3 || form.front() != '{' || form.back() != '}') return words;
  form = form.substr(1, form.size() - 2);
  if (form.find_first_of("{} ") != std::string_view::npos) return words;
  while (true) {
    const std::size_t end = form.find('|');
    words.emplace_back(form.substr(0, end));
    if (end == std::string_view::npos) return words;
    form.remove_prefix(end + 1);
  }
}

/// What asks for a command's arguments: of files the boxes, of all else the palette.
[[nodiscard]] Overlay overlay_of(std::string_view begun) {
  if (begun == "open") return Overlay::kOpen;
  if (begun == "save-preset") return Overlay::kSaveRecipe;
  const bool is_export = begun == "export" || begun == "export-table" || begun == "report";
  return is_export ? Overlay::kExport : Overlay::kPalette;
}

[[nodiscard]] std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : text) {
    if (c == '"' || c == '\\') inside += '\\';
    inside += c;
  }
  return fmt::format("\"{}\"", inside);
}

}  // namespace

std::optional<ActionHelp> help_of(std::string_view text) {
  const std::string_view name = first_word(text);
  for (const ActionHelp& help : action_helps()) {
    if (help.name == name) return help;
  }
  return {};
}

Actions begin_command(const Command& command, PaletteState& palette) {
  if (command.is_whole) {
    if (auto action = parse_action(command.text)) return {std::move(*action)};
    return {};
  }
  const Overlay overlay = overlay_of(command.text);
  const bool is_told_all = overlay == Overlay::kOpen || overlay == Overlay::kSaveRecipe;
  palette.begun = is_told_all ? std::string_view() : command.text;
  palette.arguments.clear();
  return {actions::ShowOverlay{overlay}};
}

Result<Action> finish_command(const std::string& begun, const std::string& arguments) {
  const std::size_t start = arguments.find_first_not_of(' ');
  if (start == std::string::npos) return parse_action(begun);
  const std::string plain = arguments.substr(start, arguments.find_last_not_of(' ') - start + 1);
  auto parsed = parse_action(fmt::format("{} {}", begun, plain));
  const bool is_one_argument = missing_form(begun).find(' ') == std::string::npos;
  if (!parsed && is_one_argument && plain.find(' ') != std::string::npos && plain.front() != '"') {
    if (auto as_one = parse_action(fmt::format("{} {}", begun, quoted(plain)))) return as_one;
  }
  return parsed;
}

std::vector<std::string> offered_arguments(const std::string& begun,
                                           const CommandPaletteModel& model) {
  if (begun == "open") return model.recents;
  if (begun == "layout") return model.layout_names;
  return words_of(missing_form(begun));
}

}  // namespace nadir
