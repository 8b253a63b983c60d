// SPDX-License-Identifier: Apache-2.0
#include "core/base/field.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/support/error_text.h"

namespace nadir {

enum class Colour { kRed, kGreen };

template <>
struct EnumNames<Colour> {
  static constexpr std::array<std::string_view, 2> kNames = {"red", "green"};
};

namespace field_test {

using testing::HasSubstr;

struct DrawnOptions {
  std::uint64_t seed = 1;
  int particle_count = 5000;
  double heading_noise_deg_per_m = 0.1;
  double offset_m = 0.0;
  bool is_levelled = true;
  Colour colour = Colour::kGreen;
  std::uint16_t port = 80;  ///< Its range is wider than its type.
};

template <class Options, class Visitor>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.seed, Field{"seed", "", "Root of every random draw", 0});
  visit(options.particle_count, Field{"particle-count", "", "Particles", 1, 1e6});
  visit(options.heading_noise_deg_per_m, Field{"heading-noise", "deg/m", "Spread", 0, 90});
  visit(options.offset_m, Field{"offset", "m", "Any number"});
  visit(options.is_levelled, Field{"levelled", "", "Roll and pitch are taken out"});
  visit(options.colour, Field{"colour", "", "Of the trail"});
  visit(options.port, Field{"port", "", "Number without a maximum", 0});
}

std::string set_error(std::string_view name, std::string_view text) {
  DrawnOptions options;
  return error_text(set_option(options, name, text));
}

TEST(Validate, DefaultsAreValid) { EXPECT_TRUE(validate(DrawnOptions{})); }

TEST(Validate, NamesTheOptionItsValueAndItsRange) {
  DrawnOptions options;
  options.particle_count = 0;
  EXPECT_EQ(error_code(validate(options)), ErrorCode::kInvalidOptions);
  EXPECT_EQ(error_text(validate(options)), "--particle-count: 0 is not in [1, 1000000]");
}

TEST(Validate, RefusesNanAndInfinityEvenWhereAnyNumberWillDo) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    DrawnOptions options;
    options.heading_noise_deg_per_m = bad;
    EXPECT_THAT(error_text(validate(options)), HasSubstr("--heading-noise: "));
    options = {};
    options.offset_m = bad;
    EXPECT_THAT(error_text(validate(options)), HasSubstr("is not in any number"));
  }
}

TEST(Validate, ReportsTheFirstOfTwoFaults) {
  DrawnOptions options;
  options.particle_count = 1'000'000'000;
  options.heading_noise_deg_per_m = -1.0;
  EXPECT_THAT(error_text(validate(options)), HasSubstr("--particle-count: 1000000000"));
}

TEST(SetOption, ReadsEveryKindOfValue) {
  DrawnOptions options;
  EXPECT_TRUE(set_option(options, "seed", "18446744073709551615"));
  EXPECT_TRUE(set_option(options, "particle-count", "10000"));
  EXPECT_TRUE(set_option(options, "heading-noise", "2.5e-1"));
  EXPECT_TRUE(set_option(options, "offset", "-3"));
  EXPECT_TRUE(set_option(options, "levelled", "no"));
  EXPECT_TRUE(set_option(options, "colour", "red"));
  EXPECT_EQ(options.seed, 18446744073709551615ULL);
  EXPECT_EQ(options.particle_count, 10000);
  EXPECT_EQ(options.heading_noise_deg_per_m, 0.25);
  EXPECT_EQ(options.offset_m, -3.0);
  EXPECT_FALSE(options.is_levelled);
  EXPECT_EQ(options.colour, Colour::kRed);
}

TEST(SetOption, RefusesWholeNumbersOutOfRange) {
  EXPECT_EQ(set_error("particle-count", "0"), "--particle-count: 0 is not in [1, 1000000]");
  EXPECT_THAT(set_error("particle-count", "1000000000"), HasSubstr("is not in [1, 1000000]"));
  for (const char* const text :
       {"-5", "1.5", "1e3", "", " 7", "7 ", "99999999999999999999", "ten"}) {
    EXPECT_THAT(set_error("particle-count", text),
                HasSubstr("is not a whole number in [1, 1000000]"))
        << text;
  }
}

TEST(SetOption, RefusesANumberThatItsTypeCannotHold) {
  EXPECT_THAT(set_error("port", "65536"), HasSubstr("--port: 65536 is not in [0, 65535]"));
  DrawnOptions options;
  EXPECT_TRUE(set_option(options, "port", "65535"));
  EXPECT_EQ(options.port, 65535);
}

TEST(SetOption, RefusesNumbersThatAreNone) {
  EXPECT_THAT(set_error("heading-noise", "nan"), HasSubstr("is not in [0, 90]"));
  EXPECT_THAT(set_error("heading-noise", "inf"), HasSubstr("is not in [0, 90]"));
  EXPECT_THAT(set_error("heading-noise", "90.1"),
              HasSubstr("--heading-noise: 90.1 is not in [0, 90]"));
  EXPECT_THAT(set_error("heading-noise", "1,5"), HasSubstr("'1,5' is not a number"));
  EXPECT_THAT(set_error("heading-noise", ""), HasSubstr("'' is not a number"));
  EXPECT_THAT(set_error("levelled", "maybe"), HasSubstr("'maybe' is not true or false"));
  EXPECT_THAT(set_error("colour", "blue"), HasSubstr("'blue' is not one of red, green"));
}

TEST(SetOption, LeavesTheOptionAloneOnFailure) {
  DrawnOptions options;
  EXPECT_FALSE(set_option(options, "particle-count", "0"));
  EXPECT_EQ(options.particle_count, 5000);
}

TEST(SetOption, NamesTheNearestOptionOfAMisspeltOne) {
  EXPECT_EQ(set_error("particel-count", "5"),
            "particel-count: no such option (did you mean particle-count?)");
  EXPECT_EQ(set_error("zzzzzzzzzzzzzzzzzzzzzzzzzzz", "5"),
            "zzzzzzzzzzzzzzzzzzzzzzzzzzz: no such option");
}

TEST(OptionTexts, TellEverythingInTheOrderOfTheList) {
  const auto texts = option_texts(DrawnOptions{});
  ASSERT_EQ(texts.size(), 7U);
  EXPECT_EQ(texts[1].name, "particle-count");
  EXPECT_EQ(texts[1].value, "5000");
  EXPECT_EQ(texts[1].range, "[1, 1000000]");
  EXPECT_EQ(texts[2].unit, "deg/m");
  EXPECT_EQ(texts[2].value, "0.1");
  EXPECT_EQ(texts[3].range, "any number");
  EXPECT_EQ(texts[4].value, "true");
  EXPECT_EQ(texts[5].value, "green");
  EXPECT_EQ(texts[5].range, "red, green");
}

TEST(OptionTexts, ReadBackAsTheSameOptions) {
  DrawnOptions options;
  options.heading_noise_deg_per_m = 0.1 + 0.2;
  options.seed = 12345678901234567890ULL;
  DrawnOptions read;
  for (const OptionText& text : option_texts(options)) {
    EXPECT_TRUE(set_option(read, text.name, text.value)) << text.name;
  }
  EXPECT_EQ(read.heading_noise_deg_per_m, options.heading_noise_deg_per_m);
  EXPECT_EQ(read.seed, options.seed);
}

TEST(EnumName, IsTheNameInTheList) { EXPECT_EQ(enum_name(Colour::kGreen), "green"); }

/// A value with a text of its own: "3:4".
struct Share {
  int part = 1, whole = 2;
  static constexpr std::string_view kForm = "PART:WHOLE";
  static Result<Share> from_text(std::string_view text) {
    if (text.size() != 3 || text[1] != ':') {
      return fail(ErrorCode::kInvalidOptions, "'{}' is no share", text);
    }
    return Share{text[0] - '0', text[2] - '0'};
  }
  [[nodiscard]] std::string text() const { return fmt::format("{}:{}", part, whole); }
  [[nodiscard]] Result<void> check() const {
    if (part <= whole) return {};
    return fail(ErrorCode::kInvalidOptions, "{} is more than all", text());
  }
};

struct SharedOptions {
  Share share;
  bool is_even = false;
};

template <class Options, class Visitor>
requires std::same_as<std::remove_const_t<Options>, SharedOptions>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.share, Field{"share", "", "Of the cake"});
  visit(options.is_even, Field{"even", "", "In equal parts"});
}

TEST(OwnText, IsReadCheckedAndWritten) {
  SharedOptions options;
  ASSERT_TRUE(set_option(options, "share", "3:4"));
  EXPECT_EQ(option_texts(options)[0].value, "3:4");
  EXPECT_EQ(option_texts(options)[0].range, "PART:WHOLE");
  EXPECT_EQ(option_texts(options)[0].kind, OptionKind::kOwnText);
  EXPECT_EQ(option_texts(options)[1].kind, OptionKind::kBoolean);
  EXPECT_EQ(error_text(set_option(options, "share", "half")), "--share: 'half' is no share");
  EXPECT_EQ(error_text(set_option(options, "share", "5:4")), "--share: 5:4 is more than all");
  EXPECT_EQ(options.share.text(), "3:4");  // as before
  options.share = {9, 8};
  EXPECT_EQ(error_text(validate(options)), "--share: 9:8 is more than all");
}

}  // namespace field_test
}  // namespace nadir
