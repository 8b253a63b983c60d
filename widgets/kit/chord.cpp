// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/chord.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace nadir::kit {
namespace {

struct NamedKey {
  std::string_view name;
  Key key;
};

constexpr std::array<NamedKey, 19> kNamedKeys = {{{"Space", Key::kSpace},
                                                  {"Escape", Key::kEscape},
                                                  {"Enter", Key::kEnter},
                                                  {"Tab", Key::kTab},
                                                  {"Backspace", Key::kBackspace},
                                                  {"Insert", Key::kInsert},
                                                  {"Delete", Key::kDelete},
                                                  {"Right", Key::kRight},
                                                  {"Left", Key::kLeft},
                                                  {"Down", Key::kDown},
                                                  {"Up", Key::kUp},
                                                  {"Page Up", Key::kPageUp},
                                                  {"Page Down", Key::kPageDown},
                                                  {"Home", Key::kHome},
                                                  {"End", Key::kEnd},
                                                  {"Esc", Key::kEscape},
                                                  {"Del", Key::kDelete},
                                                  {"PageUp", Key::kPageUp},
                                                  {"PageDown", Key::kPageDown}}};

bool equal_in_any_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

/// Takes "Ctrl+" and its like off the front.
bool take(std::string_view& text, std::string_view word) {
  if (text.size() <= word.size() + 1 || text[word.size()] != '+' ||
      !equal_in_any_case(text.substr(0, word.size()), word))
    return false;
  text.remove_prefix(word.size() + 1);
  return true;
}

std::optional<Key> function_key(std::string_view name) {
  if (name.size() < 2 || name.size() > 3 || (name[0] != 'F' && name[0] != 'f')) return std::nullopt;
  int number = 0;
  for (const char digit : name.substr(1)) {
    if (digit < '0' || digit > '9') return std::nullopt;
    number = 10 * number + (digit - '0');
  }
  if (number < 1 || number > 12) return std::nullopt;
  return static_cast<Key>(static_cast<int>(Key::kF1) + number - 1);
}

}  // namespace

std::optional<Chord> parse_chord(std::string_view text) {
  Chord chord;
  for (bool took = true; took;) {
    took = false;
    if (take(text, "Ctrl")) took = chord.modifiers.ctrl = true;
    if (take(text, "Shift")) took = chord.modifiers.shift = true;
    if (take(text, "Alt")) took = chord.modifiers.alt = true;
    if (take(text, "Super")) took = chord.modifiers.super = true;
  }
  for (const auto& [name, key] : kNamedKeys) {
    if (!equal_in_any_case(text, name)) continue;
    chord.key = key;
    return chord;
  }
  if (const auto key = function_key(text)) {
    chord.key = *key;
    return chord;
  }
  if (text.size() != 1) return std::nullopt;
  const auto sign = static_cast<unsigned char>(text[0]);
  if (std::isalnum(sign) != 0 && sign < 128) {
    chord.key = static_cast<Key>(std::toupper(sign));
    return chord;
  }
  if (sign <= 32 || sign >= 127) return std::nullopt;
  chord.character = text[0];
  return chord;
}

std::string chord_text(const Chord& chord) {
  std::string text;
  if (chord.modifiers.ctrl) text += "Ctrl+";
  if (chord.modifiers.shift) text += "Shift+";
  if (chord.modifiers.alt) text += "Alt+";
  if (chord.modifiers.super) text += "Super+";
  if (chord.character != 0) return text + chord.character;
  for (const auto& [name, key] : kNamedKeys) {
    if (key == chord.key) return text + std::string(name);
  }
  if (chord.key >= Key::kF1 && chord.key <= Key::kF12)
    return text + "F" +
           std::to_string(static_cast<int>(chord.key) - static_cast<int>(Key::kF1) + 1);
  const auto code = static_cast<int>(chord.key);
  return code > 32 && code < 127 ? text + static_cast<char>(code) : std::string();
}

}  // namespace nadir::kit
