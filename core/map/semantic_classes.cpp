// SPDX-License-Identifier: Apache-2.0
#include "core/map/semantic_classes.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "core/base/require.h"
#include "core/map/class_table.h"

namespace nadir {
namespace {

using ClassTable = std::array<ClassInfo, kClassCount>;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

/// Cuts `text` at the first `separator` and returns what stood before it.
std::string_view take_until(std::string_view& text, char separator) {
  const std::size_t at = text.find(separator);
  const std::string_view head = text.substr(0, at);
  text = at == std::string_view::npos ? std::string_view() : text.substr(at + 1);
  return head;
}

std::uint8_t byte_from(std::string_view text) {
  std::uint8_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  NADIR_REQUIRE(error == std::errc() && end == text.data() + text.size());
  return value;
}

/// The table is part of the program, so a fault in it is a bug and not bad input.
ClassTable parse_class_table(std::string_view csv) {
  ClassTable table;
  while (!csv.empty()) {
    std::string_view line = trimmed(take_until(csv, '\n'));
    if (line.empty() || line.front() == '#') continue;
    const std::uint8_t id = byte_from(trimmed(take_until(line, ',')));
    NADIR_REQUIRE(id < kClassCount);
    ClassInfo& info = table.at(id);
    NADIR_REQUIRE(info.name.empty());
    info.name = trimmed(take_until(line, ','));
    info.colour.red = byte_from(trimmed(take_until(line, ',')));
    info.colour.green = byte_from(trimmed(take_until(line, ',')));
    info.colour.blue = byte_from(trimmed(line));
  }
  for (const ClassInfo& info : table) NADIR_REQUIRE(!info.name.empty());
  return table;
}

/// What lies lower comes first.
constexpr std::array<ClassId, kClassCount> kDrawingOrder{
    kSky,         kTerrain,      kVegetation,  kSidewalk, kRoad, kBuilding,
    kCurb,        kLaneMarking,  kRailing,     kFence,    kCar,  kPedestrian,
    kTrafficSign, kTrafficLight, kStreetLight, kPole};

const ClassTable& class_table() {
  static const ClassTable table = parse_class_table(detail::kClassTableCsv);
  return table;
}

}  // namespace

const ClassInfo& class_info(ClassId id) {
  static constexpr ClassInfo kNoClass{"unclassified", {}};
  return id < kClassCount ? class_table()[id] : kNoClass;
}

int drawing_level(ClassId id) {
  const auto* const found = std::find(kDrawingOrder.begin(), kDrawingOrder.end(), id);
  return static_cast<int>(found - kDrawingOrder.begin());
}

std::string plain_class_name(std::string_view name) {
  std::string letters;
  for (const char letter : name) {
    if (letter == ' ' || letter == '-' || letter == '_') continue;
    const bool is_capital = letter >= 'A' && letter <= 'Z';
    letters += is_capital ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  if (letters.size() > 1 && letters.back() == 's') letters.pop_back();
  return letters;
}

std::optional<ClassId> class_from_name(std::string_view name) {
  const std::string wanted = plain_class_name(name);
  for (int id = 0; id < kClassCount; ++id) {
    const auto candidate = static_cast<ClassId>(id);
    if (plain_class_name(class_info(candidate).name) == wanted) return candidate;
  }
  if (wanted == plain_class_name("unclassified") || wanted == "void") return kUnclassified;
  return std::nullopt;
}

}  // namespace nadir
