// SPDX-License-Identifier: Apache-2.0
#include "core/session/place_text.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace nadir {
namespace place_text_test {

using testing::HasSubstr;

ProjectPlane georgia() { return ProjectPlane::create({32.4, -83.7}).value(); }

/// How far a text's place lies from a point of the plane; -1 where it is none.
double miss_m(const std::string& text, const Eigen::Vector2d& point_in_enu_m) {
  const auto place = parse_place_text(text, georgia());
  EXPECT_TRUE(place) << text << ": " << error_text(place);
  return place ? (*place - point_in_enu_m).norm() : -1.0;
}

TEST(PlaceText, IsMetresOfThePlane) {
  for (const char* text :
       {"12.5 -30", "  12.5   -30 ", "E 12.5 N -30", "e12.5 n-30", "+12.5 -30"}) {
    EXPECT_EQ(miss_m(text, {12.5, -30.0}), 0.0) << text;
  }
}

TEST(PlaceText, IsDegreesWithACommaOrLettersBehind) {
  const Eigen::Vector2d there = georgia().enu_from_geodetic({32.4012, -83.7034});
  for (const char* text : {"32.4012, -83.7034", "32.4012,-83.7034", "32.4012 N 83.7034 W",
                           "32.4012N, 83.7034W", "32.4012° N, 83.7034° W", "83.7034 W 32.4012 N",
                           "N 32.4012, W 83.7034", "32.4012, 276.2966"}) {
    EXPECT_LT(miss_m(text, there), 1e-6) << text;
  }
}

TEST(PlaceText, IsWhatNadirItselfShows) {
  for (const Geodetic place : {Geodetic{32.4012, -83.7034}, Geodetic{32.39, -83.69}}) {
    const Eigen::Vector2d there = georgia().enu_from_geodetic(place);
    EXPECT_LT(miss_m(geodetic_text(place), there), 0.2);
    EXPECT_LT(miss_m(utm_text(place), there), 0.1);
    EXPECT_LT(miss_m(mgrs_text(place), there), 0.8) << "the middle of a square metre";
    EXPECT_LT(miss_m(mgrs_text(place, 2), there), 750.0) << "a square kilometre";
  }
}

TEST(PlaceText, TakesTheLetterSForABandOrForTheSouthWhicheverIsNear) {
  const Geodetic in_south{-33.9, 18.4};  // zone 34, band H
  const auto cape = ProjectPlane::create(in_south).value();
  const std::string band = utm_text(in_south);  // "34H 261... E 6246... N"
  const std::string south = "34S" + band.substr(3);
  const auto by_band = parse_place_text(band, cape);
  const auto by_hemisphere = parse_place_text(south, cape);
  ASSERT_TRUE(by_band && by_hemisphere) << error_text(by_band) << error_text(by_hemisphere);
  EXPECT_LT(by_band->norm(), 0.2);
  EXPECT_LT(by_hemisphere->norm(), 0.2);
}

TEST(PlaceText, TakesUtmAndMgrsInAnyWriting) {
  const Geodetic place{32.4, -83.7};
  const std::string mgrs = mgrs_text(place, 4);
  std::string tight = mgrs, small = mgrs;
  std::erase(tight, ' ');
  for (char& letter : small) letter = static_cast<char>(std::tolower(letter));
  EXPECT_LT(miss_m(tight, {0.0, 0.0}), 10.0);
  EXPECT_LT(miss_m(small, {0.0, 0.0}), 10.0);
  std::string utm = utm_text(place);
  std::erase(utm, 'E');
  std::erase(utm, 'N');
  EXPECT_LT(miss_m(utm, {0.0, 0.0}), 0.1) << utm;
}

TEST(PlaceText, RefusesWhatIsNoPlace) {
  for (const char* text : {"", "here", "12", "1 2 3", "1,2,3", ",", "1 x", "17S", "17S KT",
                           "99Z 1 2", "17S QQ 12345", "nan 1", "inf, 2", "12 N 13 N", "95, 10"}) {
    const auto place = parse_place_text(text, georgia());
    EXPECT_FALSE(place) << text;
    EXPECT_THAT(error_text(place), HasSubstr(std::string("'") + text + "'"));
  }
}

TEST(PlaceText, RefusesWhatIsFarFromTheMap) {
  EXPECT_THAT(error_text(parse_place_text("48.99, 8.39", georgia())),
              HasSubstr("km from this map"));
  EXPECT_THAT(error_text(parse_place_text("2000000 0", georgia())), HasSubstr("2000 km"));
}

}  // namespace place_text_test
}  // namespace nadir
