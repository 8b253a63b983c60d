// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/field.h"
#include "core/base/result.h"
#include "core/label/label_object.h"

namespace nadir {

class Settings;

/// What a source says about a thing: "highway" -> "residential".
using ImportTags = std::map<std::string, std::string>;

/// What a thing of a source looks like.
enum class SourceForm { kPlace, kOpenLine, kClosedLine, kArea };

/// What a rule makes of it.
enum class ImportKind {
  kArea,
  kLine,
  kOutline,
  kSpot,     ///< A round area about a place: a tree, a pole.
  kNothing,  ///< Left out although a later rule would take it: a tunnel.
};
template <>
struct EnumNames<ImportKind> {
  static constexpr std::array<std::string_view, 5> kNames = {"area", "line", "outline", "spot",
                                                             "nothing"};
};

/// How tags become objects: a TOML file of rules, of which the first that fits counts. core/exchange/README.md describes it,
/// resources/rules has examples.
class ImportRules {
 public:
  /// @errors kNotFound; kMalformed, naming rule and key: "osm.toml: rule 3: kind: ...".
  [[nodiscard]] static Result<ImportRules> read(const std::filesystem::path& path);
  /// `name` stands for the file in messages.
  [[nodiscard]] static Result<ImportRules> parse(std::string_view text, const std::string& name);

  struct Drawn {
    ImportKind kind = ImportKind::kArea;
    ClassId class_id = kUnclassified;
    double width_m = 0.0;  ///< Of a line or spot, or the thickness of an outline.
    /// Drawn on top of this class and not in the level of its own.
    std::optional<ClassId> above;
    /// What the thing itself says of its drawing order, as LabelObject has it; of a level that there can be.
    std::optional<std::int64_t> order = {};
    /// What it says about itself, which may be nothing; where nobody asks for that it gets the name that the source has for it.
    std::optional<std::string> note = {};
  };
  /// Nothing where no rule fits. A rule fits where all of its tags do and its kind can be made of the form: areas and
  /// outlines of what is closed, lines of anything but a place, spots of places.
  [[nodiscard]] std::optional<Drawn> apply(const ImportTags& tags, SourceForm form) const;

 private:
  struct Wanted {
    std::string tag;
    std::vector<std::string> values;  ///< Empty: any.
  };
  struct Width {
    std::vector<std::string> tags;   ///< Asked first, one after the other.
    std::optional<double> a_lane_m;  ///< Then by the number of lanes.
    double otherwise_m = 0.0;
  };
  struct Rule {
    std::vector<Wanted> where;
    ImportKind kind = ImportKind::kArea;
    ClassId class_id = kUnclassified;
    std::string class_tag;  ///< Where not empty: the tag that says the class.
    Width width;
    std::optional<ClassId> above;
    std::string order_tag, note_tag;  ///< Empty: nobody asks.
  };
  ImportRules() = default;
  [[nodiscard]] static Result<ImportRules> from_settings(const Settings& settings);
  [[nodiscard]] static Result<Rule> rule_from(const Settings& table);
  [[nodiscard]] static Result<std::vector<Wanted>> where_from(const Settings& table);
  [[nodiscard]] static Result<Width> width_from(const Settings& table, ImportKind kind);
  [[nodiscard]] static bool fits(const Rule& rule, const ImportTags& tags, SourceForm form);
  [[nodiscard]] static double width_of(const Width& width, const ImportTags& tags);

  std::vector<Rule> rules_;
};

/// A length as tags have it, in metres: "3", "3.5 m", "3,5", "350 cm", "12'", "12'6\"", "8 ft", "0.1 mi". Nothing where it
/// is none or not in (0, kMostObjectWidthM].
[[nodiscard]] std::optional<double> metres_from_tag(std::string_view text);

}  // namespace nadir
