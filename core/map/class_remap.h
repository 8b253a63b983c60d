// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/map/semantic_classes.h"

namespace nadir {

class Settings;

/// How the classes of a foreign map or network become ours. Files are TOML:
///
///     unknown = "unclassified"      # for whatever is not listed; this is the default
///     [classes]                     # by the source's names; case, '-', '_', ' ' and a plural s do
///     not matter "Guard Rail" = "railing" [ids]                         # by the source's numbers,
///     0 to 255 3 = "building"
class ClassRemap {
 public:
  /// @errors kNotFound, kMalformed: a target that is no class (names the nearest), an id out of
  /// range, an empty remap.
  [[nodiscard]] static Result<ClassRemap> read(const std::filesystem::path& path);
  /// `name` stands for the file in messages.
  [[nodiscard]] static Result<ClassRemap> parse(std::string_view text, const std::string& name);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Class of whatever is not listed.
  [[nodiscard]] ClassId unknown() const { return unknown_; }
  /// Nothing where the remap does not list it.
  [[nodiscard]] std::optional<ClassId> find_id(int source_id) const;
  [[nodiscard]] std::optional<ClassId> find_name(std::string_view source_name) const;

  /// The same remap for a source whose id i is called source_names[i]; ids listed in [ids] keep
  /// what is said there.
  [[nodiscard]] ClassRemap with_names(std::span<const std::string> source_names) const;
  /// Source ids to classes, unlisted ones to unknown().
  [[nodiscard]] Raster<ClassId> apply(Raster<std::uint8_t> source) const;

 private:
  [[nodiscard]] static Result<ClassRemap> from_settings(const Settings& settings);
  explicit ClassRemap(std::string name) : name_(std::move(name)) {}

  std::string name_;
  ClassId unknown_ = kUnclassified;
  std::map<int, ClassId> by_id_;
  std::map<std::string, ClassId> by_plain_name_;
};

}  // namespace nadir
