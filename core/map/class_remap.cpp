// SPDX-License-Identifier: Apache-2.0
#include "core/map/class_remap.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "core/base/settings.h"

namespace nadir {
namespace {

Result<ClassId> target_class(const Settings& table, const std::string& key) {
  const auto text = table.text(key);
  if (!text) return forward_error(text);
  if (const auto id = class_from_name(*text)) return *id;
  std::vector<std::string> known{"unclassified"};
  for (int id = 0; id < kClassCount; ++id) {
    known.emplace_back(class_info(static_cast<ClassId>(id)).name);
  }
  const std::string nearest = nearest_word(*text, known);
  return fail(ErrorCode::kMalformed, "{}: {} becomes \"{}\", which is no class{}", table.name(),
              toml_quoted(key), *text,
              nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest));
}

/// A whole number in [0, 255], or nothing.
std::optional<int> byte_from(const std::string& text) {
  int value = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last || value < 0 || value > 255) return std::nullopt;
  return value;
}

}  // namespace

Result<ClassRemap> ClassRemap::read(const std::filesystem::path& path) {
  const auto settings = Settings::read(path);
  if (!settings) return forward_error(settings);
  return from_settings(*settings);
}

Result<ClassRemap> ClassRemap::parse(std::string_view text, const std::string& name) {
  const auto settings = Settings::parse(text, name);
  if (!settings) return forward_error(settings);
  return from_settings(*settings);
}

Result<ClassRemap> ClassRemap::from_settings(const Settings& settings) {
  ClassRemap remap(settings.name());
  if (const auto known = settings.refuse_unknown({"unknown", "classes", "ids"}); !known) {
    return forward_error(known);
  }
  if (settings.has("unknown")) {
    const auto unknown = target_class(settings, "unknown");
    if (!unknown) return forward_error(unknown);
    remap.unknown_ = *unknown;
  }
  if (settings.has("classes")) {
    const auto classes = settings.table("classes");
    if (!classes) return forward_error(classes);
    for (const std::string& key : classes->keys()) {
      const auto target = target_class(*classes, key);
      if (!target) return forward_error(target);
      remap.by_plain_name_[plain_class_name(key)] = *target;
    }
  }
  if (settings.has("ids")) {
    const auto ids = settings.table("ids");
    if (!ids) return forward_error(ids);
    for (const std::string& key : ids->keys()) {
      const std::optional<int> id = byte_from(key);
      if (!id) {
        return fail(ErrorCode::kMalformed, "{}: {} is no id from 0 to 255", ids->name(),
                    toml_quoted(key));
      }
      const auto target = target_class(*ids, key);
      if (!target) return forward_error(target);
      remap.by_id_[*id] = *target;
    }
  }
  if (remap.by_id_.empty() && remap.by_plain_name_.empty()) {
    return fail(ErrorCode::kMalformed, "{}: lists no class", settings.name());
  }
  return remap;
}

std::optional<ClassId> ClassRemap::find_id(int source_id) const {
  const auto found = by_id_.find(source_id);
  return found == by_id_.end() ? std::nullopt : std::optional<ClassId>(found->second);
}

std::optional<ClassId> ClassRemap::find_name(std::string_view source_name) const {
  const auto found = by_plain_name_.find(plain_class_name(source_name));
  return found == by_plain_name_.end() ? std::nullopt : std::optional<ClassId>(found->second);
}

ClassRemap ClassRemap::with_names(std::span<const std::string> source_names) const {
  ClassRemap remap = *this;
  for (std::size_t i = 0; i < source_names.size() && i < 256; ++i) {
    if (const auto target = find_name(source_names[i])) {
      remap.by_id_.emplace(static_cast<int>(i), *target);
    }
  }
  return remap;
}

Raster<ClassId> ClassRemap::apply(Raster<std::uint8_t> source) const {
  std::array<ClassId, 256> table{};
  for (std::size_t id = 0; id < table.size(); ++id) {
    table[id] = find_id(static_cast<int>(id)).value_or(unknown_);
  }
  for (std::uint8_t& value : source.values()) value = table[value];
  return source;
}

}  // namespace nadir
