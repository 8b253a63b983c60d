// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/command.h"
#include "core/flight/flight_writer.h"
#include "tests/core/flight/flight_fixtures.h"

namespace nadir::cli {
namespace flight_command_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Outcome {
  int status = 0;
  std::string out, err;
};

Outcome run(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const int status = run_flight(arguments, out, err);
  return {status, out.str(), err.str()};
}

std::string write_flight(const test::TemporaryFolder& folder) {
  FlightDescription description;
  description.name = "small";
  description.camera = test::small_camera();
  description.body_from_camera.rotation = forward_body_from_camera();
  const auto path = folder.path() / "flight";
  auto writer = FlightWriter::create(path, description, "made by a test");
  EXPECT_TRUE(writer);
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(writer->write(*encode_frame(test::small_frame(1.0 + 0.5 * i))));
  }
  EXPECT_TRUE(writer->finish(test::straight_path(0.0, 0.1, 21), {}));
  return path.string();
}

TEST(FlightInfo, PrintsATableOfStreams) {
  const test::TemporaryFolder folder;
  const Outcome outcome = run({"info", write_flight(folder)});
  EXPECT_EQ(outcome.status, kDone);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(outcome.out, HasSubstr("small (nadir flight)"));
  EXPECT_THAT(outcome.out,
              HasSubstr("labels           5           1.000           3.000      2.00       0.00"));
  EXPECT_THAT(outcome.out, HasSubstr("times     sane"));
  EXPECT_THAT(outcome.out, HasSubstr("notice    odometry ends 1.0 s before the labels"));
}

TEST(FlightInfo, QuietLeavesOutTheNotices) {
  const test::TemporaryFolder folder;
  const Outcome outcome = run({"info", "--quiet", write_flight(folder)});
  EXPECT_EQ(outcome.status, kDone);
  EXPECT_THAT(outcome.out, Not(HasSubstr("notice")));
}

TEST(FlightInfo, JsonIsOneObjectWithUnitsInItsKeys) {
  const test::TemporaryFolder folder;
  const std::string path = write_flight(folder);
  const Outcome outcome = run({"info", path, "--json"});
  EXPECT_EQ(outcome.status, kDone);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["flight"], path);
  EXPECT_EQ(json["frames"], 5);
  EXPECT_EQ(json["camera"]["width_px"], 4);
  EXPECT_EQ(json["streams"].size(), 3U);
  EXPECT_EQ(json["streams"][1]["name"], "labels");
  EXPECT_NEAR(json["streams"][1]["rate_hz"].get<double>(), 2.0, 1e-9);
  EXPECT_TRUE(json["streams"][1]["source"].is_null()) << "images come from many files";
  EXPECT_EQ(json["streams"][2]["source"], "odometry.txt");
  EXPECT_NEAR(json["odometry_length_m"].get<double>(), 4.0, 1e-9);
  EXPECT_TRUE(json["truth_length_m"].is_null());
  EXPECT_TRUE(json["truth_origin"].is_null());
  EXPECT_EQ(json["are_times_sane"], true);
}

TEST(FlightInfo, AFaultIsOneSentenceAndStatus1) {
  const Outcome outcome = run({"info", "/no/such/flight", "--json"});
  EXPECT_EQ(outcome.status, kFailed);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_EQ(outcome.err, "nadir: /no/such/flight: does not exist\n");
}

TEST(FlightInfo, MisuseIsStatus2AndHelpIs0) {
  EXPECT_EQ(run({}).status, kMisused);
  EXPECT_EQ(run({"info"}).status, kMisused);
  EXPECT_EQ(run({"info", "a", "b"}).status, kMisused);
  EXPECT_EQ(run({"fly"}).status, kMisused);
  EXPECT_THAT(run({"info"}).err, Not(IsEmpty()));
  EXPECT_THAT(run({"info"}).out, IsEmpty());
  const Outcome help = run({"info", "--help"});
  EXPECT_EQ(help.status, kDone);
  EXPECT_THAT(help.out, HasSubstr("--json"));
  EXPECT_EQ(run({"--help"}).status, kDone);
}

}  // namespace flight_command_test
}  // namespace nadir::cli
