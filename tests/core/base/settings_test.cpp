// SPDX-License-Identifier: Apache-2.0
#include "core/base/settings.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace settings_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::string_view kRoute = R"(
name = "loop"
laps = 3
closed = true
heights_m = [2, 2.5, 3.0]
classes = ["Road", "Curb"]
strange = nan
far = [1.0, inf]
mixed = [1, "two"]

[route]
speed_mps = 4.0
word = "fast"

[[stop]]
at_s = 1.0
[[stop]]
at_s = 2.0
)";

Settings settings_of(std::string_view text) {
  auto settings = Settings::parse(text, "loop.toml");
  if (!settings) throw std::runtime_error(error_text(settings));
  return *settings;
}

TEST(Settings, GivesValuesOfEachType) {
  const Settings settings = settings_of(kRoute);
  EXPECT_EQ(settings.text("name").value(), "loop");
  EXPECT_EQ(settings.integer("laps").value(), 3);
  EXPECT_EQ(settings.boolean("closed").value(), true);
  EXPECT_EQ(settings.number("route.speed_mps").value(), 4.0);
  EXPECT_THAT(settings.numbers("heights_m").value(), ElementsAre(2.0, 2.5, 3.0));
  EXPECT_THAT(settings.texts("classes").value(), ElementsAre("Road", "Curb"));
}

TEST(Settings, AWholeNumberIsANumberToo) {
  EXPECT_EQ(settings_of("speed = 4").number("speed").value(), 4.0);
}

TEST(Settings, NamesTheFileAndTheKeyThatIsMissing) {
  const auto missing = settings_of(kRoute).number("route.height_m");
  EXPECT_EQ(error_code(missing), ErrorCode::kMalformed);
  EXPECT_EQ(error_text(missing), "loop.toml: route.height_m is missing");
  EXPECT_THAT(error_text(settings_of(kRoute).text("no.such.key")), HasSubstr("is missing"));
}

TEST(Settings, NamesTheKindThatAValueIsNot) {
  const Settings settings = settings_of(kRoute);
  EXPECT_THAT(error_text(settings.number("route.word")),
              StartsWith("loop.toml: route.word is not a number"));
  EXPECT_THAT(error_text(settings.integer("name")), HasSubstr("name is not a whole number"));
  EXPECT_THAT(error_text(settings.integer("route.speed_mps2")), HasSubstr("is missing"));
  EXPECT_THAT(error_text(settings.boolean("name")), HasSubstr("name is not true or false"));
  EXPECT_THAT(error_text(settings.text("laps")), HasSubstr("laps is not a text in quotes"));
  EXPECT_THAT(error_text(settings.numbers("mixed")), HasSubstr("mixed is not a list of numbers"));
  EXPECT_THAT(error_text(settings.numbers("laps")), HasSubstr("laps is not a list of numbers"));
  EXPECT_THAT(error_text(settings.texts("mixed")), HasSubstr("mixed is not a list of texts"));
  EXPECT_THAT(error_text(settings.table("laps")), HasSubstr("laps is not a table"));
  EXPECT_THAT(error_text(settings.tables("mixed")), HasSubstr("mixed is not a list of tables"));
  EXPECT_THAT(error_text(settings.tables("none")), HasSubstr("none is missing"));
}

TEST(Settings, AFractionIsNoWholeNumberAndATruthIsNoNumber) {
  EXPECT_FALSE(settings_of("laps = 2.5").integer("laps"));
  EXPECT_FALSE(settings_of("speed = true").number("speed"));
  EXPECT_FALSE(settings_of("laps = true").integer("laps"));
  EXPECT_FALSE(settings_of("laps = 1e73").integer("laps"));
  EXPECT_FALSE(settings_of("closed = 1").boolean("closed"));
  EXPECT_FALSE(settings_of("closed = \"true\"").boolean("closed"));
}

TEST(Settings, RefusesNumbersThatAreNotFinite) {
  EXPECT_THAT(error_text(settings_of(kRoute).number("strange")), HasSubstr("strange is nan"));
  EXPECT_THAT(error_text(settings_of(kRoute).numbers("far")), HasSubstr("far holds a number"));
}

TEST(Settings, AFallbackStandsInForWhatIsMissingNotForWhatIsWrong) {
  const Settings settings = settings_of(kRoute);
  EXPECT_EQ(settings.number_or("none", 7.5).value(), 7.5);
  EXPECT_EQ(settings.number_or("laps", 7.5).value(), 3.0);
  EXPECT_FALSE(settings.number_or("name", 7.5));
  EXPECT_EQ(settings.text_or("none", "x").value(), "x");
  EXPECT_FALSE(settings.text_or("laps", "x"));
}

TEST(Settings, NestedTablesSayWhereTheyAre) {
  const auto route = settings_of(kRoute).table("route");
  ASSERT_TRUE(route) << error_text(route);
  EXPECT_EQ(route->name(), "loop.toml: route");
  EXPECT_EQ(route->number("speed_mps").value(), 4.0);
  EXPECT_EQ(error_text(route->number("height_m")), "loop.toml: route: height_m is missing");
}

TEST(Settings, ListsOfTablesCountFromZero) {
  const auto stops = settings_of(kRoute).tables("stop");
  ASSERT_TRUE(stops) << error_text(stops);
  ASSERT_EQ(stops->size(), 2U);
  EXPECT_EQ(stops->at(1).number("at_s").value(), 2.0);
  EXPECT_EQ(error_text(stops->at(1).number("for_s")), "loop.toml: stop[1]: for_s is missing");
}

TEST(Settings, KeysAreSortedAndOfThisTableAlone) {
  EXPECT_THAT(settings_of("b = 1\na = 2\n[c]\nd = 3").keys(), ElementsAre("a", "b", "c"));
  EXPECT_TRUE(settings_of("[c]\nd = 3").has("c.d"));
  EXPECT_FALSE(settings_of("[c]\nd = 3").has("c.e"));
}

TEST(Settings, ScalarsReadAsOnACommandLine) {
  const Settings settings = settings_of("a = 0.5\nb = true\nc = \"default\"\nd = 7\ne = [1]");
  EXPECT_EQ(settings.scalar_as_text("a").value(), "0.5");
  EXPECT_EQ(settings.scalar_as_text("b").value(), "true");
  EXPECT_EQ(settings.scalar_as_text("c").value(), "default");
  EXPECT_EQ(settings.scalar_as_text("d").value(), "7");
  EXPECT_THAT(error_text(settings.scalar_as_text("e")), HasSubstr("e is not a single value"));
  EXPECT_THAT(error_text(settings.scalar_as_text("f")), HasSubstr("f is missing"));
}

TEST(Settings, ASlipOfThePenHasLineAndColumn) {
  const auto broken = Settings::parse("a = 1\nb = = 2\n", "loop.toml");
  EXPECT_EQ(error_code(broken), ErrorCode::kMalformed);
  EXPECT_THAT(error_text(broken), StartsWith("loop.toml: line 2, column 5: "));
  EXPECT_THAT(error_text(Settings::parse("a = 1\na = 2\n", "x")), HasSubstr("line 2"));
  EXPECT_FALSE(Settings::parse("a = \"\xFF\xFE\"", "x"));
}

TEST(Settings, DeepNestingIsRefusedAndDoesNotOverflowTheStack) {
  EXPECT_FALSE(Settings::parse("a = " + std::string(100'000, '['), "deep.toml"));
}

TEST(Settings, ReadsFilesAndNamesThoseThatAreMissing) {
  const ScratchFolder folder;
  const auto path = folder.file("map.toml", "name = \"town\"\r\n");
  const auto read = Settings::read(path);
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(read->text("name").value(), "town");
  EXPECT_EQ(read->name(), path.string());
  EXPECT_EQ(error_code(Settings::read(folder.path() / "none.toml")), ErrorCode::kNotFound);
  EXPECT_EQ(error_code(Settings::read(folder.path())), ErrorCode::kIo);
}

TEST(TomlQuoted, ReadsBackAsTheSameText) {
  std::string every_letter = "plain \"quoted\" back\\slash \n\t\r \x01 \x7F ";
  every_letter +=
      "Stra\xC3\x9F"
      "e";
  for (const std::string& text : {std::string(), std::string("a\0b", 3), every_letter}) {
    const auto read = Settings::parse("x = " + toml_quoted(text), "quoted");
    ASSERT_TRUE(read) << error_text(read);
    EXPECT_EQ(read->text("x").value(), text);
  }
}

TEST(TomlQuoted, KeepsBytesThatAreNoUtf8ThoughTomlIs) {
  std::string every_byte;
  for (int byte = 0; byte < 256; ++byte) every_byte += static_cast<char>(byte);
  for (const std::string& bytes : {std::string("/runs/caf\xE9.nadir"), every_byte}) {
    const std::string quoted = toml_quoted(bytes);
    const auto read = Settings::parse("x = " + quoted + "\nlist = [" + quoted + "]\n", "quoted");
    ASSERT_TRUE(read) << error_text(read);
    EXPECT_EQ(read->text("x").value(), bytes);
    EXPECT_EQ(read->text_or("x", "").value(), bytes);
    EXPECT_EQ(read->scalar_as_text("x").value(), bytes);
    EXPECT_THAT(read->texts("list").value(), ElementsAre(bytes));
  }
  EXPECT_EQ(toml_quoted("caf\xE9"), "\"caf\\uFFFFE9\"") << "which an editor can show";
}

TEST(Settings, RefusesKeysThatNobodyKnowsAndNamesTheNearest) {
  const auto settings = Settings::parse("speed = 1\n[part]\nsizee = 2\nqqqqqqqq = 3\n", "a.toml");
  ASSERT_TRUE(settings);
  EXPECT_TRUE(settings->refuse_unknown({"speed", "part"}));
  const auto refused = settings->table("part")->refuse_unknown({"size", "qqqqqqqq"});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kMalformed);
  EXPECT_EQ(refused.error().message, "a.toml: part: sizee is no known key (did you mean size?)");
  EXPECT_EQ(settings->table("part")->refuse_unknown({"sizee"}).error().message,
            "a.toml: part: qqqqqqqq is no known key");
}

TEST(NearestWord, FindsTheWordThatWasMeant) {
  const std::vector<std::string> known = {"localise", "evaluate", "simulate", "map"};
  EXPECT_EQ(nearest_word("localize", known), "localise");
  EXPECT_EQ(nearest_word("evalute", known), "evaluate");
  EXPECT_EQ(nearest_word("simulate", known), "simulate");
  EXPECT_EQ(nearest_word("mpa", known), "map");
  EXPECT_EQ(nearest_word("focal_x", {"focal_y_px", "focal_x_px"}), "focal_x_px");
}

TEST(NearestWord, IsSilentWhereNoneIsNear) {
  EXPECT_EQ(nearest_word("zzzzzzzz", {"localise", "evaluate"}), "");
  EXPECT_EQ(nearest_word("word", {}), "");
  EXPECT_EQ(nearest_word("out", {"route", "runs"}), "");
  EXPECT_EQ(nearest_word("classes", {"closed"}), "");
}

}  // namespace settings_test
}  // namespace nadir
