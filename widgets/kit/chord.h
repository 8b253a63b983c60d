// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace nadir::kit {

/// Keys of the keyboard, named after what is printed on them in the United States. The values are those of GLFW and, for
/// what can be printed, of ASCII.
enum class Key : std::uint16_t {
  kNone = 0,
  kSpace = 32,
  kApostrophe = 39,
  kComma = 44,
  kMinus = 45,
  kPeriod = 46,
  kSlash = 47,
  k0 = 48,
  k1,
  k2,
  k3,
  k4,
  k5,
  k6,
  k7,
  k8,
  k9,
  kSemicolon = 59,
  kEqual = 61,
  kA = 65,
  kB,
  kC,
  kD,
  kE,
  kF,
  kG,
  kH,
  kI,
  kJ,
  kK,
  kL,
  kM,
  kN,
  kO,
  kP,
  kQ,
  kR,
  kS,
  kT,
  kU,
  kV,
  kW,
  kX,
  kY,
  kZ,
  kLeftBracket = 91,
  kBackslash = 92,
  kRightBracket = 93,
  kGraveAccent = 96,
  kEscape = 256,
  kEnter,
  kTab,
  kBackspace,
  kInsert,
  kDelete,
  kRight,
  kLeft,
  kDown,
  kUp,
  kPageUp,
  kPageDown,
  kHome,
  kEnd,
  kF1 = 290,
  kF2,
  kF3,
  kF4,
  kF5,
  kF6,
  kF7,
  kF8,
  kF9,
  kF10,
  kF11,
  kF12,
  kPadDecimal = 330,
  kPadDivide,
  kPadMultiply,
  kPadSubtract,
  kPadAdd,
  kPadEnter,
};

struct Modifiers {
  bool ctrl = false, shift = false, alt = false, super = false;
  friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

/// What is pressed at once: "Ctrl+Shift+P", "F5", "[". A sign that keyboards have in different places ("?", "[", "+") counts
/// by the character that it types, whatever was held down for it; letters, digits and named keys count by their key.
struct Chord {
  Key key = Key::kNone;
  char character = 0;  ///< In place of a key.
  Modifiers modifiers = {};
  friend bool operator==(const Chord&, const Chord&) = default;
};

/// Reads "Ctrl+Shift+P", "Space", "Left", "Page Up", "F5", "?", "Ctrl++", in any case; empty where it is none.
[[nodiscard]] std::optional<Chord> parse_chord(std::string_view text);

/// As menus and tooltips write it; parse_chord() reads it back.
[[nodiscard]] std::string chord_text(const Chord& chord);

}  // namespace nadir::kit
