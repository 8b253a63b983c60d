// SPDX-License-Identifier: Apache-2.0
#include "core/session/place_text.h"

#include <GeographicLib/MGRS.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace nadir {
namespace {

constexpr double kFarthestM = 1e6;
constexpr const char* kPlaceForms =
    "EAST NORTH in metres, LAT, LON in degrees, UTM or MGRS: '12.5 -30', '32.4, -83.7', '17S "
    "230567 "
    "3705123', '17S KT 30567 05123'";

/// The words of a text in capitals, split at blanks; commas stand alone, degree signs are left out.
std::vector<std::string> place_words(std::string_view text) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto letter = static_cast<unsigned char>(text[i]);
    if (letter == 0xC2U && i + 1 < text.size() && text[i + 1] == '\xB0') {  // degree sign
      ++i;
      continue;
    }
    if (std::isspace(letter) != 0) {
      words.emplace_back();
    } else if (letter == ',') {
      words.emplace_back(",");
      words.emplace_back();
    } else {
      words.back() += static_cast<char>(std::toupper(letter));
    }
  }
  std::erase(words, "");
  return words;
}

std::optional<double> place_number(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [at, error] = std::from_chars(word.data(), end, value);
  if (word.empty() || error != std::errc() || at != end || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

/// A number with a letter of the compass before or behind it, in one word or two.
struct Coordinate {
  double value = 0.0;
  char before = ' ', behind = ' ';
};

bool is_compass(std::string_view word) {
  return word.size() == 1 && std::string_view("NESW").find(word.front()) != std::string_view::npos;
}

/// "83.7W" and "E123" as two words.
std::vector<std::string> with_letters_apart(const std::vector<std::string>& words) {
  std::vector<std::string> apart;
  for (const std::string& word : words) {
    if (word.size() > 1 && is_compass(word.substr(0, 1)) && place_number(word.substr(1))) {
      apart.push_back(word.substr(0, 1));
      apart.push_back(word.substr(1));
    } else if (word.size() > 1 && is_compass(word.substr(word.size() - 1)) &&
               place_number(word.substr(0, word.size() - 1))) {
      apart.push_back(word.substr(0, word.size() - 1));
      apart.push_back(word.substr(word.size() - 1));
    } else {
      apart.push_back(word);
    }
  }
  return apart;
}

/// Two numbers with their letters; nothing where there is anything else.
std::optional<std::vector<Coordinate>> coordinates_of(const std::vector<std::string>& words,
                                                      bool& has_comma) {
  std::vector<Coordinate> found;
  char before = ' ';
  const bool are_letters_first = !words.empty() && is_compass(words.front());
  for (const std::string& word : words) {
    if (word == ",") {
      if (found.size() != 1) return std::nullopt;
      has_comma = true;
    } else if (is_compass(word)) {
      if (are_letters_first) {
        before = word.front();
      } else if (found.empty() || found.back().behind != ' ') {
        return std::nullopt;
      } else {
        found.back().behind = word.front();
      }
    } else if (const auto value = place_number(word)) {
      found.push_back({*value, std::exchange(before, ' '), ' '});
    } else {
      return std::nullopt;
    }
  }
  if (found.size() != 2) return std::nullopt;
  return found;
}

std::optional<Geodetic> degrees_of(const Coordinate& first, const Coordinate& second) {
  const auto letter_of = [](const Coordinate& one) {
    return one.before != ' ' ? one.before : one.behind;
  };
  const auto signed_value = [](double value, char letter) {
    return letter == 'S' || letter == 'W' ? -value : value;
  };
  char a = letter_of(first), b = letter_of(second);
  const bool is_longitude_first = a == 'E' || a == 'W';
  const Coordinate& north = is_longitude_first ? second : first;
  const Coordinate& east = is_longitude_first ? first : second;
  if (is_longitude_first) std::swap(a, b);
  if ((a != ' ' && a != 'N' && a != 'S') || (b != ' ' && b != 'E' && b != 'W')) {
    return std::nullopt;
  }
  const Geodetic place{signed_value(north.value, a), signed_value(east.value, b)};
  if (!(std::abs(place.latitude_deg) <= 90.0) || !(std::abs(place.longitude_deg) <= 360.0)) {
    return std::nullopt;
  }
  return place;
}

/// "17S" as zone and letter.
std::optional<std::pair<int, char>> zone_of(const std::string& word) {
  if (word.size() < 2 || word.size() > 3) return std::nullopt;
  int zone = 0;
  const char* const end = word.data() + word.size() - 1;
  const auto [at, error] = std::from_chars(word.data(), end, zone);
  if (error != std::errc() || at != end || zone < 1 || zone > 60) return std::nullopt;
  if (std::isalpha(static_cast<unsigned char>(*end)) == 0) return std::nullopt;
  return std::pair(zone, *end);
}

std::optional<Geodetic> utm_place(int zone, bool is_north, double east_m, double north_m) {
  try {
    Geodetic place;
    GeographicLib::UTMUPS::Reverse(zone, is_north, east_m, north_m, place.latitude_deg,
                                   place.longitude_deg);
    return place;
  } catch (const GeographicLib::GeographicErr&) {
    return std::nullopt;
  }
}

std::optional<Geodetic> mgrs_place(const std::string& text) {
  try {
    int zone = 0, digits = 0;
    bool is_north = true;
    double east_m = 0.0, north_m = 0.0;
    GeographicLib::MGRS::Reverse(text, zone, is_north, east_m, north_m, digits);
    if (digits < 1) return std::nullopt;  // a hundred kilometres are no place
    Geodetic place;
    GeographicLib::UTMUPS::Reverse(zone, is_north, east_m, north_m, place.latitude_deg,
                                   place.longitude_deg);
    return place;
  } catch (const GeographicLib::GeographicErr&) {
    return std::nullopt;
  }
}

}  // namespace

Result<Eigen::Vector2d> parse_place_text(std::string_view text, const ProjectPlane& plane) {
  const auto near = [&](const Eigen::Vector2d& point) -> Result<Eigen::Vector2d> {
    if (!(point.norm() <= kFarthestM)) {
      return fail(ErrorCode::kInvalidOptions, "'{}' is {:.0f} km from this map", text,
                  point.norm() / 1000.0);
    }
    return point;
  };
  const auto placed = [&](const std::optional<Geodetic>& place) -> Result<Eigen::Vector2d> {
    if (!place) return fail(ErrorCode::kInvalidOptions, "'{}' is no place on Earth", text);
    return near(plane.enu_from_geodetic(*place));
  };

  const std::vector<std::string> words = place_words(text);
  const auto zone = words.empty() ? std::nullopt : zone_of(words.front());
  bool has_comma = false;
  if (zone) {
    const auto numbers =
        coordinates_of(with_letters_apart({words.begin() + 1, words.end()}), has_comma);
    if (numbers) {
      const double east_m = numbers->at(0).value, north_m = numbers->at(1).value;
      const auto by_band = utm_place(zone->first, zone->second >= 'N', east_m, north_m);
      if (zone->second != 'S') return placed(by_band);
      const auto in_south = utm_place(zone->first, false, east_m, north_m);
      if (!by_band || !in_south) return placed(by_band ? by_band : in_south);
      const Eigen::Vector2d a = plane.enu_from_geodetic(*by_band);
      const Eigen::Vector2d b = plane.enu_from_geodetic(*in_south);
      return near(a.norm() <= b.norm() ? a : b);
    }
  }
  if (!words.empty() && std::isdigit(static_cast<unsigned char>(words.front().front())) != 0) {
    std::string joined;
    for (const std::string& word : words) joined += word;
    const bool has_letters = joined.find_first_of("ABCDEFGHJKLMNPQRSTUVWXYZ") != std::string::npos;
    if (const auto place = has_letters ? mgrs_place(joined) : std::nullopt) return placed(place);
  }
  const auto numbers = coordinates_of(with_letters_apart(words), has_comma);
  if (!numbers) {
    return fail(ErrorCode::kInvalidOptions, "'{}' is no place: write {}", text, kPlaceForms);
  }
  const Coordinate &first = numbers->at(0), &second = numbers->at(1);
  const bool has_letters_behind = first.behind != ' ' || second.behind != ' ';
  const bool is_plane = first.before == 'E' && second.before == 'N';
  if (!is_plane && (has_comma || has_letters_behind || first.before != ' ')) {
    return placed(degrees_of(first, second));
  }
  return near({first.value, second.value});
}

}  // namespace nadir
