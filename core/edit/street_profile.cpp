// SPDX-License-Identifier: Apache-2.0
#include "core/edit/street_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/base/settings.h"
#include "core/edit/edit_builder.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {
namespace {

constexpr double kMostStripM = 100.0;
constexpr std::size_t kMostDashes = 100'000;

/// A length of a strip within its range, or the fallback.
Result<double> strip_length(const Settings& table, const char* key, double fallback, double least) {
  auto value = table.number_or(key, fallback);
  if (!value) return value;
  if (*value >= least && *value <= kMostStripM) return value;
  return fail(ErrorCode::kMalformed, "{}: {} of {} is not in [{}, {}]", table.name(), key, *value,
              least, kMostStripM);
}

Result<void> add_strips(std::vector<ProfileStrip>& strips, const Settings& table) {
  auto known =
      table.refuse_unknown({"class", "width_m", "offset_m", "dash_m", "gap_m", "both_sides"});
  if (!known) return known;
  const auto name = table.text("class");
  if (!name) return forward_error(name);
  const auto id = class_from_name(*name);
  if (!id || !can_lie_in_overhead(*id)) {
    return fail(ErrorCode::kMalformed, "{}: {} is no class of an overhead", table.name(), *name);
  }
  ProfileStrip strip;
  strip.class_id = *id;
  const std::array<std::tuple<const char*, double*, double>, 4> lengths{
      std::tuple{"width_m", &strip.width_m, 0.001},
      std::tuple{"offset_m", &strip.offset_m, -kMostStripM},
      std::tuple{"dash_m", &strip.dash_m, 0.0}, std::tuple{"gap_m", &strip.gap_m, 0.0}};
  for (const auto& [key, value, least] : lengths) {
    const auto length = strip_length(table, key, 0.0, least);
    if (!length) return forward_error(length);
    *value = *length;
  }
  if ((strip.dash_m > 0.0) != (strip.gap_m > 0.0)) {
    return fail(ErrorCode::kMalformed, "{}: dash_m and gap_m go together", table.name());
  }
  if (strip.dash_m > 0.0 && std::min(strip.dash_m, strip.gap_m) < 0.01) {
    return fail(ErrorCode::kMalformed, "{}: dashes and gaps shorter than 0.01 m", table.name());
  }
  strips.push_back(strip);
  if (!table.has("both_sides")) return {};
  const auto both = table.boolean("both_sides");
  if (!both) return forward_error(both);
  if (!*both) return {};
  if (strip.offset_m == 0.0) {
    return fail(ErrorCode::kMalformed, "{}: both_sides needs an offset_m", table.name());
  }
  strip.offset_m = -strip.offset_m;
  strips.push_back(strip);
  return {};
}

Result<StreetProfile> profile_from(const Settings& settings) {
  if (const auto known = settings.refuse_unknown({"name", "strip"}); !known) {
    return forward_error(known);
  }
  auto name = settings.text("name");
  if (!name) return forward_error(name);
  const auto tables = settings.tables("strip");
  if (!tables) return forward_error(tables);
  StreetProfile profile{std::move(*name), {}};
  for (const Settings& table : *tables) {
    const auto added = add_strips(profile.strips, table);
    if (!added) return forward_error(added);
  }
  if (profile.strips.empty()) {
    return fail(ErrorCode::kMalformed, "{}: has no [[strip]]", settings.name());
  }
  return profile;
}

/// The dashes of a line, from its beginning.
Result<std::vector<Ring>> dashes(const Ring& line, double dash_m, double gap_m) {
  std::vector<Ring> made;
  Ring dash{line.front()};
  bool is_drawn = true;
  double rest_m = dash_m;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d along = line[i] - line[i - 1];
    const double length = along.norm();
    double done_m = 0.0;
    while (length - done_m > rest_m) {
      done_m += rest_m;
      const Eigen::Vector2d place = on_lattice(line[i - 1] + along * (done_m / length));
      if (is_drawn) {
        dash.push_back(place);
        made.push_back(std::move(dash));
        if (made.size() > kMostDashes) {
          return fail(ErrorCode::kInvalidOptions, "the line has more than {} dashes", kMostDashes);
        }
      }
      dash = {place};
      is_drawn = !is_drawn;
      rest_m = is_drawn ? dash_m : gap_m;
    }
    rest_m -= length - done_m;
    dash.push_back(line[i]);
  }
  // A last one that is hardly there is none.
  const bool is_there = is_drawn && dash_m - rest_m >= std::min(0.01, dash_m);
  if (is_there) made.push_back(std::move(dash));
  return made;
}

}  // namespace

Result<StreetProfile> StreetProfile::read(const std::filesystem::path& path) {
  const auto settings = Settings::read(path);
  if (!settings) return forward_error(settings);
  return profile_from(*settings);
}

Result<StreetProfile> StreetProfile::parse(std::string_view text, const std::string& file) {
  const auto settings = Settings::parse(text, file);
  if (!settings) return forward_error(settings);
  return profile_from(*settings);
}

Result<LabelEdit> draw_street(const LabelDocument& document,
                              const StreetProfile& profile,
                              const Ring& centre_line) {
  EditBuilder builder(document, fmt::format("Draw {}", profile.name));
  for (const ProfileStrip& strip : profile.strips) {
    const auto lines = beside(centre_line, strip.offset_m);
    if (!lines) return forward_error(lines, profile.name);
    if (lines->size() != 1) {
      return fail(ErrorCode::kInvalidOptions,
                  "{}: the line bends too sharply, or meets itself, for {} {:.2f} m beside it",
                  profile.name, class_info(strip.class_id).name, strip.offset_m);
    }
    auto pieces = strip.dash_m > 0.0 ? dashes(lines->front(), strip.dash_m, strip.gap_m) : lines;
    if (!pieces) return forward_error(pieces, profile.name);
    const std::int64_t order = builder.next_order(strip.class_id);
    for (Ring& piece : *pieces) {
      builder.add({.id = 0,
                   .kind = ObjectKind::kLine,
                   .class_id = strip.class_id,
                   .order = order,
                   .width_m = strip.width_m,
                   .rings = {std::move(piece)},
                   .note = {}});
    }
  }
  return builder.edit();
}

}  // namespace nadir
