// SPDX-License-Identifier: Apache-2.0
#include "core/flight/flight_settings.h"

#include <gmock/gmock.h>

#include "tests/core/flight/flight_fixtures.h"

namespace nadir {
namespace flight_settings_test {

using test::message_of;
using testing::HasSubstr;

constexpr const char* kFlight = "[flight]\nformat_version = 1\nname = \"loop\"\n";
constexpr const char* kCamera =
    "[camera]\nwidth = 640\nheight = 480\nfocal_x_px = 554.5\nfocal_y_px = 555\n"
    "centre_x_px = 319.5\ncentre_y_px = 239.25\n";

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(FlightSettings, HaveDefaultsForAllThatMayBeLeftOut) {
  const auto flight = parse_flight_settings("[flight]\nformat_version = 1\n", "flight.toml");
  ASSERT_TRUE(flight) << message_of(flight);
  EXPECT_EQ(flight->name, "");
  EXPECT_EQ(flight->generator, "");
  EXPECT_EQ(flight->altitude_m, 0.0);
  EXPECT_FALSE(flight->camera);
  EXPECT_FALSE(flight->truth_origin);
  EXPECT_EQ(flight->depth_units_per_m, 1000.0);
}

TEST(FlightSettings, PixelCentresMoveByHalfAPixelFromFileToCameraModel) {
  const auto flight = parse_flight_settings(std::string(kFlight) + kCamera, "flight.toml");
  ASSERT_TRUE(flight) << message_of(flight);
  ASSERT_TRUE(flight->camera);
  // A camera that looks through the middle of its image: (w - 1) / 2 in the file, w / 2 in the
  // program.
  EXPECT_EQ(flight->camera->centre_x_px, 320.0);
  EXPECT_EQ(flight->camera->centre_y_px, 239.75);
  EXPECT_EQ(flight->camera->focal_x_px, 554.5);
  EXPECT_EQ(flight->camera->focal_y_px, 555.0);
  EXPECT_EQ(flight->camera->width, 640);
  EXPECT_EQ(flight->camera->height, 480);
}

TEST(FlightSettings, CameraLooksStraightAheadUnlessItIsSaidHowItIsMounted) {
  const auto flight = parse_flight_settings(std::string(kFlight) + kCamera, "flight.toml");
  const Eigen::Vector3d ahead = flight->body_from_camera * Eigen::Vector3d::UnitZ();
  EXPECT_LT((ahead - Eigen::Vector3d::UnitX()).norm(), 1e-12);
}

TEST(FlightSettings, TheReadmesExampleOfAMountLooksStraightAhead) {
  const auto flight =
      parse_flight_settings(std::string(kFlight) + kCamera +
                                "[camera.body_from_camera]\ntranslation_m = [0.1, 0, -0.02]\n"
                                "quaternion_xyzw = [-0.5, 0.5, -0.5, 0.5]\n",
                            "flight.toml");
  ASSERT_TRUE(flight) << message_of(flight);
  const Eigen::Quaterniond& rotation = flight->body_from_camera.rotation;
  EXPECT_LT((rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((rotation * Eigen::Vector3d::UnitX() + Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_EQ(flight->body_from_camera.translation_m, Eigen::Vector3d(0.1, 0.0, -0.02));
}

TEST(FlightSettings, AreReadBackAsWritten) {
  FlightSettings flight;
  flight.name = "a \"quoted\" name \\ with\nlines";
  flight.provenance = "made up";
  flight.generator = "a \"program\"";
  flight.altitude_m = 0.1 + 0.2;
  flight.camera = CameraModel{641, 479, 1.0 / 3.0, 1e3 / 7.0, 320.123456789, 239.5};
  flight.body_from_camera = {
      Eigen::Quaterniond(Eigen::AngleAxisd(1.2345, Eigen::Vector3d(1, 2, 3).normalized())),
      {1.0 / 3.0, -2e-9, 1e5}};
  flight.depth_units_per_m = 1000.0;
  flight.truth_origin = Geodetic{48.987721123456, -8.387722123456};
  const auto again = parse_flight_settings(flight_settings_text(flight), "flight.toml");
  ASSERT_TRUE(again) << message_of(again);
  EXPECT_EQ(again->name, flight.name);
  EXPECT_EQ(again->provenance, flight.provenance);
  EXPECT_EQ(again->generator, flight.generator);
  EXPECT_EQ(again->altitude_m, flight.altitude_m);
  EXPECT_EQ(again->camera->width, 641);
  EXPECT_EQ(again->camera->focal_x_px, flight.camera->focal_x_px);
  EXPECT_EQ(again->camera->focal_y_px, flight.camera->focal_y_px);
  EXPECT_NEAR(again->camera->centre_x_px, flight.camera->centre_x_px, 1e-12);
  EXPECT_EQ(again->camera->centre_y_px, flight.camera->centre_y_px);
  EXPECT_EQ(again->body_from_camera.translation_m, flight.body_from_camera.translation_m);
  EXPECT_LT(again->body_from_camera.rotation.angularDistance(flight.body_from_camera.rotation),
            1e-12);
  EXPECT_EQ(again->truth_origin->latitude_deg, flight.truth_origin->latitude_deg);
  EXPECT_EQ(again->truth_origin->longitude_deg, flight.truth_origin->longitude_deg);
}

TEST(FlightSettings, RefuseANewerVersionAndSaySo) {
  const auto flight = parse_flight_settings("[flight]\nformat_version = 2\nwings = 2\n", "f.toml");
  ASSERT_FALSE(flight);
  EXPECT_EQ(flight.error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(flight.error().message, "f.toml: has format_version 2, but this program reads up to 1");
}

TEST(FlightSettings, RefuseAMissingOrImpossibleVersion) {
  EXPECT_EQ(message_of(parse_flight_settings("", "f.toml")),
            "f.toml: flight.format_version is missing");
  EXPECT_EQ(message_of(parse_flight_settings("[flight]\nformat_version = 0\n", "f.toml")),
            "f.toml: format_version 0 has never existed");
}

TEST(FlightSettings, RefuseAMisspeltKeyAndNameTheNearest) {
  const std::string text = std::string(kFlight) + kCamera;
  EXPECT_THAT(message_of(parse_flight_settings(replaced(text, "focal_x_px", "focal_x"), "f.toml")),
              HasSubstr("focal_x is no known key (did you mean focal_x_px?)"));
  EXPECT_THAT(message_of(parse_flight_settings(text + "depth_unit_per_m = 5000\n", "f.toml")),
              HasSubstr("(did you mean depth_units_per_m?)"));
  EXPECT_THAT(message_of(parse_flight_settings(text + "[cameras]\n", "f.toml")),
              HasSubstr("cameras is no known key (did you mean camera?)"));
}

TEST(FlightSettings, RefuseEachFaultWithItsName) {
  const std::string text = std::string(kFlight) + kCamera;
  const auto fault = [&](std::string_view from, std::string_view to) {
    return message_of(parse_flight_settings(replaced(text, from, to), "f.toml"));
  };
  EXPECT_EQ(fault("width = 640\n", ""), "f.toml: camera.width is missing");
  EXPECT_THAT(fault("width = 640", "width = 640.5"),
              HasSubstr("camera.width is not a whole number"));
  EXPECT_THAT(fault("width = 640", "width = -1"), HasSubstr("camera.width is -1"));
  EXPECT_THAT(fault("width = 640", "width = 99999999999"),
              HasSubstr("camera.width is 99999999999"));
  EXPECT_THAT(fault("width = 640", "width = 20000"), HasSubstr("f.toml: camera: size 20000 x 480"));
  EXPECT_THAT(fault("554.5", "nan"), HasSubstr("camera.focal_x_px is nan"));
  EXPECT_THAT(fault("554.5", "0"), HasSubstr("f.toml: camera: focal lengths 0 and 555"));
  EXPECT_THAT(fault("554.5", "\"wide\""), HasSubstr("camera.focal_x_px is not a number"));
  EXPECT_THAT(fault("[camera]", "[camera]\ndepth_units_per_m = 0"), HasSubstr("not positive"));
  EXPECT_THAT(fault("[camera]", "camera = 3\n[x]"), HasSubstr("no known key"));
  EXPECT_THAT(fault("[flight]", "[flight"), HasSubstr("f.toml: line 1"));
}

TEST(FlightSettings, RefuseAMountThatIsNoMotion) {
  const std::string text = std::string(kFlight) + kCamera + "[camera.body_from_camera]\n";
  const auto fault = [&](const char* translation, const char* quaternion) {
    return message_of(parse_flight_settings(
        fmt::format("{}translation_m = {}\nquaternion_xyzw = {}\n", text, translation, quaternion),
        "f.toml"));
  };
  EXPECT_EQ(fault("[0, 0, 0]", "[0, 0, 0, 1]"), "");
  EXPECT_THAT(fault("[0, 0]", "[0, 0, 0, 1]"), HasSubstr("needs three numbers of translation_m"));
  EXPECT_THAT(fault("[0, 0, 0]", "[0, 0, 0, 0]"), HasSubstr("has length 0, not 1"));
  EXPECT_THAT(fault("[0, 0, 0]", "[1, 0, 0, 1]"), HasSubstr("has length 1.41421, not 1"));
  EXPECT_THAT(fault("[0, 0, inf]", "[0, 0, 0, 1]"), HasSubstr("not finite"));
}

TEST(FlightSettings, RefuseAnOriginThatIsNowhere) {
  const std::string text = std::string(kFlight) + "[truth]\norigin_longitude_deg = 8\n";
  EXPECT_EQ(message_of(parse_flight_settings(text, "f.toml")),
            "f.toml: truth.origin_latitude_deg is missing");
  EXPECT_THAT(message_of(parse_flight_settings(text + "origin_latitude_deg = 91\n", "f.toml")),
              HasSubstr("f.toml: truth"));
}

}  // namespace flight_settings_test
}  // namespace nadir
