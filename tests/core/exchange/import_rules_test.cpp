// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/import_rules.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/base/settings.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace import_rules_test {

using testing::HasSubstr;

ImportRules rules_of(std::string_view text) {
  auto rules = ImportRules::parse(text, "r.toml");
  EXPECT_TRUE(rules) << error_text(rules);
  return *std::move(rules);
}

constexpr std::string_view kStreets = R"(
[[rule]]
where = { tunnel = "yes" }
kind = "nothing"
[[rule]]
where = { highway = ["footway", "path"], area = "yes" }
kind = "area"
class = "sidewalk"
[[rule]]
where = { highway = true }
kind = "line"
class = "road"
width_m = { tags = ["width", "est_width"], a_lane = 3.0, otherwise = 5.5 }
[[rule]]
where = { island = true }
kind = "area"
class = "sidewalk"
above = "road"
[[rule]]
where = { natural = "tree" }
kind = "spot"
class = "vegetation"
width_m = 4.0
)";

TEST(ImportRules, TheFirstThatFitsCounts) {
  const ImportRules rules = rules_of(kStreets);
  const auto path =
      rules.apply({{"highway", "path"}, {"area", "yes"}}, SourceForm::kClosedLine).value();
  EXPECT_EQ(path.kind, ImportKind::kArea);
  EXPECT_EQ(path.class_id, kSidewalk);
  EXPECT_EQ(path.width_m, 0.0);
  const auto lane = rules.apply({{"highway", "service"}}, SourceForm::kOpenLine).value();
  EXPECT_EQ(lane.kind, ImportKind::kLine);
  EXPECT_EQ(lane.class_id, kRoad);
  EXPECT_EQ(rules.apply({{"highway", "service"}, {"tunnel", "yes"}}, SourceForm::kOpenLine)->kind,
            ImportKind::kNothing);
  EXPECT_FALSE(rules.apply({{"building", "yes"}}, SourceForm::kClosedLine));
  EXPECT_EQ(rules.apply({{"island", "yes"}}, SourceForm::kArea)->above, ClassId{kRoad});
}

TEST(ImportRules, MakeOfAThingOnlyWhatItsFormCanBe) {
  const ImportRules rules = rules_of(kStreets);
  const ImportTags open_area{{"highway", "path"}, {"area", "yes"}};
  EXPECT_EQ(rules.apply(open_area, SourceForm::kOpenLine)->kind, ImportKind::kLine)
      << "an open ring is no area, so the next rule is asked";
  EXPECT_FALSE(rules.apply({{"highway", "stop"}}, SourceForm::kPlace));
  EXPECT_EQ(rules.apply({{"natural", "tree"}}, SourceForm::kPlace)->width_m, 4.0);
  EXPECT_FALSE(rules.apply({{"natural", "tree"}}, SourceForm::kOpenLine));
}

TEST(ImportRules, TakeAWidthFromTagsThenFromLanesThenTheUsualOne) {
  const ImportRules rules = rules_of(kStreets);
  const auto width = [&](ImportTags tags) {
    tags["highway"] = "residential";
    return rules.apply(tags, SourceForm::kOpenLine)->width_m;
  };
  EXPECT_EQ(width({}), 5.5);
  EXPECT_EQ(width({{"lanes", "2"}}), 6.0);
  EXPECT_EQ(width({{"lanes", "2"}, {"width", "7.5 m"}}), 7.5);
  EXPECT_EQ(width({{"width", "wide"}, {"est_width", "4"}}), 4.0);
  EXPECT_EQ(width({{"lanes", "many"}}), 5.5);
  EXPECT_EQ(width({{"lanes", "-3"}}), 5.5);
  EXPECT_EQ(width({{"lanes", "2000"}}), 5.5);
  EXPECT_EQ(width({{"width", "0"}}), 5.5);
}

TEST(ImportRules, ReadLengthsWithTheirUnits) {
  EXPECT_EQ(metres_from_tag("3"), 3.0);
  EXPECT_EQ(metres_from_tag(" 3.5 m "), 3.5);
  EXPECT_EQ(metres_from_tag("3,5"), 3.5);
  EXPECT_NEAR(metres_from_tag("350 cm").value(), 3.5, 1e-12);
  EXPECT_NEAR(metres_from_tag("12'").value(), 3.6576, 1e-12);
  EXPECT_NEAR(metres_from_tag("12'6\"").value(), 3.81, 1e-12);
  EXPECT_NEAR(metres_from_tag("8 ft").value(), 2.4384, 1e-12);
  EXPECT_NEAR(metres_from_tag("0.5 km").value(), 500.0, 1e-9);
  for (const char* none :
       {"", "m", "-3", "0", "nan", "inf", "1e3", "3;4", "3 yards", "12'x", "99999"}) {
    EXPECT_FALSE(metres_from_tag(none)) << none;
  }
}

TEST(ImportRules, MayTakeTheClassFromATag) {
  const ImportRules rules =
      rules_of("[[rule]]\nwhere={class=true}\nkind=\"area\"\nclass={tag=\"class\"}\n");
  EXPECT_EQ(rules.apply({{"class", "lane marking"}}, SourceForm::kArea)->class_id, kLaneMarking);
  EXPECT_EQ(rules.apply({{"class", "unclassified"}}, SourceForm::kArea)->class_id, kUnclassified);
  EXPECT_FALSE(rules.apply({{"class", "lava"}}, SourceForm::kArea));
  EXPECT_FALSE(rules.apply({{"class", "sky"}}, SourceForm::kArea));
}

TEST(ImportRules, MayTakeDrawingOrderAndNoteFromTags) {
  const ImportRules rules = rules_of(
      "[[rule]]\nwhere={class=true}\nkind=\"area\"\nclass={tag=\"class\"}\norder={tag=\"z\"}\n"
      "note={tag=\"text\"}\n");
  const auto drawn = [&](ImportTags tags) {
    tags["class"] = "road";
    return rules.apply(tags, SourceForm::kArea).value();
  };
  EXPECT_EQ(drawn({{"z", "-12"}, {"text", "by the river"}}).order, -12);
  EXPECT_EQ(drawn({{"text", "by the river"}}).note, "by the river");
  EXPECT_EQ(drawn({}).note, "") << "it says that there is none";
  for (const char* const none :
       {"", "high", "1.5", "99999999999999999999", "9223372036854775807"}) {
    EXPECT_FALSE(drawn({{"z", none}}).order) << none;
  }
  const ImportRules silent =
      rules_of("[[rule]]\nwhere={class=true}\nkind=\"area\"\nclass=\"road\"\n");
  EXPECT_FALSE(silent.apply({{"class", "x"}, {"note", "y"}}, SourceForm::kArea)->note);
}

TEST(ImportRules, NameWhatIsWrongWithThem) {
  const auto complaint = [](std::string_view text) {
    return error_text(ImportRules::parse(text, "r.toml"));
  };
  EXPECT_THAT(complaint(""), HasSubstr("r.toml: "));
  EXPECT_THAT(complaint("[[rule]]\nkind=\"area\"\nclass=\"road\"\n"), HasSubstr("where"));
  EXPECT_THAT(complaint("[[rule]]\nwhere={}\nkind=\"area\"\nclass=\"road\"\n"),
              HasSubstr("asks for no tag"));
  EXPECT_THAT(complaint("[[rule]]\nwhere={a=3}\nkind=\"area\"\nclass=\"road\"\n"),
              HasSubstr("neither a text, a list of texts nor true"));
  EXPECT_THAT(complaint("[[rule]]\nwhere={a=true}\nkind=\"blob\"\nclass=\"road\"\n"),
              HasSubstr("\"blob\" is not one of area, line, outline, spot, nothing"));
  EXPECT_THAT(complaint("[[rule]]\nwhere={a=true}\nkind=\"area\"\nclass=\"raod\"\n"),
              HasSubstr("did you mean road?"));
  EXPECT_THAT(complaint("[[rule]]\nwhere={a=true}\nkind=\"area\"\nclass=\"sky\"\n"),
              HasSubstr("no class that an overhead holds"));
  EXPECT_THAT(complaint("[[rule]]\nwhere={a=true}\nkind=\"line\"\nclass=\"road\"\n"),
              HasSubstr("width_m"));
  EXPECT_THAT(complaint("[[rule]]\nwhere={a=true}\nkind=\"line\"\nclass=\"road\"\nwidth_m=-1\n"),
              HasSubstr("width_m is -1, not in (0,"));
  EXPECT_THAT(complaint("[[rule]]\nwhere={a=true}\nkind=\"area\"\nclass=\"road\"\nwidth_m=1\n"),
              HasSubstr("an area has no width_m"));
  EXPECT_THAT(complaint("[[rule]]\nwhere={a=true}\nkind=\"area\"\nclass=\"road\"\norder=\"z\"\n"),
              HasSubstr("order"));
  EXPECT_THAT(complaint("[[rule]]\nwhere={a=true}\nkind=\"area\"\nclas=\"road\"\n"),
              HasSubstr("did you mean class?"));
}

/// What ships with the program.
TEST(ImportRules, OfTheProgramCanBeRead) {
  for (const char* name : {"osm.toml", "lanelet2.toml", "classes.toml"}) {
    const auto rules = ImportRules::read(std::string(NADIR_SOURCE_DIR "/resources/rules/") + name);
    EXPECT_TRUE(rules) << error_text(rules);
  }
}

TEST(ImportRules, OfTheProgramKnowStreetsHousesAndTunnels) {
  const auto osm = ImportRules::read(NADIR_SOURCE_DIR "/resources/rules/osm.toml").value();
  const auto street = osm.apply({{"highway", "residential"}}, SourceForm::kOpenLine).value();
  EXPECT_EQ(street.class_id, kRoad);
  EXPECT_EQ(street.width_m, 6.5);
  EXPECT_EQ(osm.apply({{"highway", "primary"}, {"lanes", "4"}}, SourceForm::kOpenLine)->width_m,
            14.0);
  const auto house = osm.apply({{"building", "house"}}, SourceForm::kClosedLine).value();
  EXPECT_EQ(house.kind, ImportKind::kOutline);
  EXPECT_EQ(house.class_id, kBuilding);
  EXPECT_EQ(osm.apply({{"highway", "trunk"}, {"tunnel", "yes"}}, SourceForm::kOpenLine)->kind,
            ImportKind::kNothing);
  EXPECT_FALSE(osm.apply({{"landuse", "residential"}}, SourceForm::kArea));
}

}  // namespace import_rules_test
}  // namespace nadir
