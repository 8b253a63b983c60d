// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/import_rules.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/base/settings.h"

namespace nadir {
namespace {

Result<ClassId> class_named(const Settings& table, const std::string& key) {
  const auto text = table.text(key);
  if (!text) return forward_error(text);
  const auto id = class_from_name(*text);
  if (id && (*id == kUnclassified || can_lie_in_overhead(*id))) return *id;
  std::vector<std::string> known{"unclassified"};
  for (int i = 0; i < kClassCount; ++i) {
    if (can_lie_in_overhead(static_cast<ClassId>(i))) {
      known.emplace_back(class_info(static_cast<ClassId>(i)).name);
    }
  }
  const std::string nearest = nearest_word(*text, known);
  return fail(ErrorCode::kMalformed, "{}: {}: \"{}\" is no class that an overhead holds{}",
              table.name(), key, *text,
              nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest));
}

Result<ImportKind> kind_from(const Settings& table) {
  const auto text = table.text("kind");
  if (!text) return forward_error(text);
  const auto& names = EnumNames<ImportKind>::kNames;
  const auto* const found = std::find(names.begin(), names.end(), *text);
  if (found != names.end()) return static_cast<ImportKind>(found - names.begin());
  return fail(ErrorCode::kMalformed,
              "{}: kind: \"{}\" is not one of area, line, outline, spot, nothing", table.name(),
              *text);
}

Result<double> sound_width(const Settings& table, const std::string& key) {
  const auto width = table.number(key);
  if (!width) return forward_error(width);
  if (*width > 0.0 && *width <= kMostObjectWidthM) return *width;
  return fail(ErrorCode::kMalformed, "{}: {} is {}, not in (0, {:.0f}] m", table.name(), key,
              *width, kMostObjectWidthM);
}

/// Of `key = { tag = "name" }` the name.
Result<std::string> tag_named(const Settings& table, const std::string& key) {
  const auto of_tag = table.table(key);
  if (!of_tag) return forward_error(of_tag);
  if (const auto known = of_tag->refuse_unknown({"tag"}); !known) return forward_error(known);
  return of_tag->text("tag");
}

/// A drawing order that an object can have.
std::optional<std::int64_t> order_from(const std::string& text) {
  constexpr std::int64_t kMostLevel = 127;
  std::int64_t order = 0;
  const char* const end = text.data() + text.size();
  const auto [read_to, error] = std::from_chars(text.data(), end, order);
  if (error != std::errc() || read_to != end) return std::nullopt;
  if (std::abs(level_of_order(order)) > kMostLevel) return std::nullopt;
  return order;
}

const std::string* tag_of(const ImportTags& tags, const std::string& key) {
  const auto found = tags.find(key);
  return found == tags.end() ? nullptr : &found->second;
}

}  // namespace

Result<ImportRules> ImportRules::read(const std::filesystem::path& path) {
  const auto settings = Settings::read(path);
  if (!settings) return forward_error(settings);
  return from_settings(*settings);
}

Result<ImportRules> ImportRules::parse(std::string_view text, const std::string& name) {
  const auto settings = Settings::parse(text, name);
  if (!settings) return forward_error(settings);
  return from_settings(*settings);
}

Result<ImportRules> ImportRules::from_settings(const Settings& settings) {
  if (const auto known = settings.refuse_unknown({"rule"}); !known) return forward_error(known);
  const auto tables = settings.tables("rule");
  if (!tables) return forward_error(tables);
  if (tables->empty()) return fail(ErrorCode::kMalformed, "{}: has no rule", settings.name());
  ImportRules rules;
  for (const Settings& table : *tables) {
    auto rule = rule_from(table);
    if (!rule) return forward_error(rule);
    rules.rules_.push_back(std::move(*rule));
  }
  return rules;
}

Result<ImportRules::Rule> ImportRules::rule_from(const Settings& table) {
  if (const auto known =
          table.refuse_unknown({"where", "kind", "class", "width_m", "above", "order", "note"});
      !known) {
    return forward_error(known);
  }
  Rule rule;
  auto where = where_from(table);
  if (!where) return forward_error(where);
  rule.where = std::move(*where);
  const auto kind = kind_from(table);
  if (!kind) return forward_error(kind);
  rule.kind = *kind;
  if (rule.kind == ImportKind::kNothing) return rule;
  if (table.table("class")) {
    const auto tag = tag_named(table, "class");
    if (!tag) return forward_error(tag);
    rule.class_tag = *tag;
  } else {
    const auto id = class_named(table, "class");
    if (!id) return forward_error(id);
    rule.class_id = *id;
  }
  const auto width = width_from(table, rule.kind);
  if (!width) return forward_error(width);
  rule.width = *width;
  if (table.has("above")) {
    const auto above = class_named(table, "above");
    if (!above) return forward_error(above);
    rule.above = *above;
  }
  for (const auto& [key, into] :
       {std::pair("order", &rule.order_tag), std::pair("note", &rule.note_tag)}) {
    if (!table.has(key)) continue;
    auto tag = tag_named(table, key);
    if (!tag) return forward_error(tag);
    *into = std::move(*tag);
  }
  return rule;
}

Result<std::vector<ImportRules::Wanted>> ImportRules::where_from(const Settings& table) {
  const auto where = table.table("where");
  if (!where) return forward_error(where);
  std::vector<Wanted> wanted;
  for (const std::string& tag : where->keys()) {
    // Names of tags may hold a point, which Settings would take for one of its own.
    if (tag.find('.') != std::string::npos) {
      return fail(ErrorCode::kMalformed, "{}: {} cannot be asked for, for it has a point in it",
                  where->name(), toml_quoted(tag));
    }
    Wanted one{tag, {}};
    if (const auto text = where->text(tag)) {
      one.values = {*text};
    } else if (const auto texts = where->texts(tag); texts && !texts->empty()) {
      one.values = *texts;
    } else if (const auto any = where->boolean(tag); !any || !*any) {
      return fail(ErrorCode::kMalformed, "{}: {} is neither a text, a list of texts nor true",
                  where->name(), toml_quoted(tag));
    }
    wanted.push_back(std::move(one));
  }
  if (wanted.empty()) return fail(ErrorCode::kMalformed, "{}: asks for no tag", where->name());
  return wanted;
}

Result<ImportRules::Width> ImportRules::width_from(const Settings& table, ImportKind kind) {
  Width width;
  if (kind == ImportKind::kArea) {
    if (!table.has("width_m")) return width;
    return fail(ErrorCode::kMalformed, "{}: an area has no width_m", table.name());
  }
  const auto parts = table.table("width_m");
  if (!parts) {
    const auto number = sound_width(table, "width_m");
    if (!number) return forward_error(number);
    width.otherwise_m = *number;
    return width;
  }
  if (const auto known = parts->refuse_unknown({"tags", "a_lane", "otherwise"}); !known) {
    return forward_error(known);
  }
  if (parts->has("tags")) {
    auto tags = parts->texts("tags");
    if (!tags) return forward_error(tags);
    width.tags = std::move(*tags);
  }
  if (parts->has("a_lane")) {
    const auto a_lane = sound_width(*parts, "a_lane");
    if (!a_lane) return forward_error(a_lane);
    width.a_lane_m = *a_lane;
  }
  const auto otherwise = sound_width(*parts, "otherwise");
  if (!otherwise) return forward_error(otherwise);
  width.otherwise_m = *otherwise;
  return width;
}

bool ImportRules::fits(const Rule& rule, const ImportTags& tags, SourceForm form) {
  switch (rule.kind) {
    case ImportKind::kArea:
    case ImportKind::kOutline:
      if (form == SourceForm::kPlace || form == SourceForm::kOpenLine) return false;
      break;
    case ImportKind::kLine:
      if (form == SourceForm::kPlace) return false;
      break;
    case ImportKind::kSpot:
      if (form != SourceForm::kPlace) return false;
      break;
    case ImportKind::kNothing:
      break;
  }
  return std::all_of(rule.where.begin(), rule.where.end(), [&](const Wanted& wanted) {
    const std::string* const value = tag_of(tags, wanted.tag);
    return value != nullptr &&
           (wanted.values.empty() ||
            std::find(wanted.values.begin(), wanted.values.end(), *value) != wanted.values.end());
  });
}

double ImportRules::width_of(const Width& width, const ImportTags& tags) {
  for (const std::string& tag : width.tags) {
    const std::string* const value = tag_of(tags, tag);
    if (value == nullptr) continue;
    if (const auto metres = metres_from_tag(*value)) return *metres;
  }
  const std::string* const lanes = width.a_lane_m ? tag_of(tags, "lanes") : nullptr;
  if (lanes != nullptr) {
    constexpr double kMostLanes = 20.0;
    double count = 0.0;
    const char* const end = lanes->data() + lanes->size();
    const auto [read_to, error] =
        std::from_chars(lanes->data(), end, count, std::chars_format::fixed);
    if (error == std::errc() && read_to == end && count >= 1.0 && count <= kMostLanes) {
      return std::min(count * *width.a_lane_m, kMostObjectWidthM);
    }
  }
  return width.otherwise_m;
}

std::optional<ImportRules::Drawn> ImportRules::apply(const ImportTags& tags,
                                                     SourceForm form) const {
  for (const Rule& rule : rules_) {
    if (!fits(rule, tags, form)) continue;
    if (rule.kind == ImportKind::kNothing) return Drawn{.kind = rule.kind, .above = {}};
    ClassId id = rule.class_id;
    if (!rule.class_tag.empty()) {
      const std::string* const name = tag_of(tags, rule.class_tag);
      const auto named = name != nullptr ? class_from_name(*name) : std::nullopt;
      if (!named || (*named != kUnclassified && !can_lie_in_overhead(*named))) continue;
      id = *named;
    }
    const double width_m = rule.kind == ImportKind::kArea ? 0.0 : width_of(rule.width, tags);
    Drawn drawn{rule.kind, id, width_m, rule.above};
    if (!rule.order_tag.empty()) {
      if (const std::string* const order = tag_of(tags, rule.order_tag)) {
        drawn.order = order_from(*order);
      }
    }
    if (!rule.note_tag.empty()) {
      const std::string* const note = tag_of(tags, rule.note_tag);
      drawn.note = note != nullptr ? *note : std::string();
    }
    return drawn;
  }
  return std::nullopt;
}

}  // namespace nadir
