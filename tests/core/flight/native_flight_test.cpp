// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/flight/flight_recording.h"
#include "core/flight/flight_writer.h"
#include "core/flight/frame_image.h"
#include "tests/core/flight/flight_fixtures.h"

namespace nadir {
namespace native_flight_test {

namespace fs = std::filesystem;
using test::message_of;
using test::small_camera;
using test::small_frame;
using test::straight_path;
using test::text_of;
using testing::EndsWith;
using testing::HasSubstr;

constexpr const char* kSettings =
    "[flight]\nformat_version = 1\nname = \"small\"\naltitude_m = 1.5\n"
    "[camera]\nwidth = 4\nheight = 3\nfocal_x_px = 5\nfocal_y_px = 5\n"
    "centre_x_px = 1.5\ncentre_y_px = 1\ndepth_units_per_m = 500\n";

/// A flight put together by hand, as a converter would; each test spoils one thing.
class NativeFlight : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("flight.toml", kSettings);
    folder_.write("labels.txt", "# time_s file\n1.00 labels/a.png\n1.10 labels/b.png\n");
    folder_.write("depth.txt", "1.011 depth/a.png\n1.09 depth/b.png\n");
    folder_.write("rgb.txt", "1.0 a.jpg\n1.05 between.jpg\n1.10 b.jpg\n");
    folder_.write("odometry.txt", "0.9 0 0 0 0 0 0 1\n1.2 1 0 0 0 0 0 1\n");
    folder_.write("truth.txt", "0.9 5 5 0 0 0 0 1\n1.2 6 5 0 0 0 0 1\n");
    for (const char* name : {"a.jpg", "between.jpg", "b.jpg"}) folder_.write(name, "not read");
    for (const char* name : {"a", "b"}) {
      const SemanticFrame frame = small_frame(0.0, *name == 'a' ? 0 : 5);
      folder_.write(fmt::format("labels/{}.png", name), text_of(*encode_label_png(frame.labels)));
      folder_.write(fmt::format("depth/{}.png", name), text_of(*encode_depth_png(frame.depth_m)));
    }
  }

  [[nodiscard]] Result<std::unique_ptr<FlightRecording>> open() const {
    return open_flight(folder_.path());
  }
  /// Opens the spoilt flight, which must fail; the folder's name is cut from the message.
  [[nodiscard]] std::string fault() const {
    std::string message = message_of(open());
    const std::string prefix = folder_.path().string() + "/";
    if (message.starts_with(prefix)) message.erase(0, prefix.size());
    return message;
  }

  test::TemporaryFolder folder_;
};

TEST_F(NativeFlight, DescribesItsStreams) {
  const auto flight = open();
  ASSERT_TRUE(flight) << message_of(flight);
  const FlightDescription& d = (*flight)->description();
  EXPECT_EQ(d.name, "small");
  EXPECT_EQ(d.format, "nadir flight");
  EXPECT_EQ(d.path, folder_.path());
  EXPECT_EQ(d.altitude_m, 1.5);
  ASSERT_TRUE(d.camera);
  EXPECT_EQ(d.camera->centre_x_px, 2.0);
  EXPECT_EQ(d.camera->centre_y_px, 1.5);
  ASSERT_EQ(d.frames.size(), 2U);
  EXPECT_EQ(d.frames[0].time_s, 1.0);
  EXPECT_EQ(d.frames[0].labels, folder_.path() / "labels/a.png");
  EXPECT_EQ(d.frames[0].depth, folder_.path() / "depth/a.png");
  EXPECT_EQ(d.frames[0].image, folder_.path() / "a.jpg");
  EXPECT_EQ(d.frames[1].image, folder_.path() / "b.jpg");
  ASSERT_TRUE(d.odometry && d.truth);
  EXPECT_EQ(d.odometry->size(), 2U);
  EXPECT_EQ(d.truth->poses()[1].pose.translation_m, Eigen::Vector3d(6, 5, 0));
  EXPECT_FALSE(d.truth_origin);
}

TEST_F(NativeFlight, LoadsLabelsAndDepthInTheFlightsUnits) {
  const auto flight = open();
  ASSERT_TRUE(flight) << message_of(flight);
  const auto frame = (*flight)->load(1);
  ASSERT_TRUE(frame) << message_of(frame);
  EXPECT_EQ(frame->time_s, 1.1);
  EXPECT_EQ(frame->labels, small_frame(0.0, 5).labels);
  // Encoded as millimetres, declared as 500 units a metre: everything is twice as far.
  for (std::size_t i = 0; i < frame->depth_m.size(); ++i) {
    EXPECT_EQ(frame->depth_m.values()[i], static_cast<float>(i + 1));
  }
}

TEST_F(NativeFlight, AnyFrameCanBeLoadedAnyNumberOfTimes) {
  const auto flight = open();
  ASSERT_TRUE(flight);
  const auto first = (*flight)->load(0);
  EXPECT_TRUE((*flight)->load(1));
  const auto again = (*flight)->load(0);
  ASSERT_TRUE(first && again);
  EXPECT_EQ(first->labels, again->labels);
  EXPECT_EQ(first->depth_m, again->depth_m);
  EXPECT_THROW((void)(*flight)->load(2), std::logic_error);
}

TEST_F(NativeFlight, CanBeOpenedByItsTomlFile) {
  EXPECT_TRUE(open_flight(folder_.path() / "flight.toml"));
}

TEST_F(NativeFlight, IsNamedAfterItsFolderWhereItHasNoName) {
  folder_.write("flight.toml", "[flight]\nformat_version = 1\n");
  for (const auto& path : {folder_.path(), folder_.path() / "", folder_.path() / "."}) {
    const auto flight = open_flight(path);
    ASSERT_TRUE(flight) << message_of(flight);
    EXPECT_EQ((*flight)->description().name, folder_.path().filename().string());
  }
}

TEST_F(NativeFlight, ADepthImageThatIsTooFarInTimeBelongsToNoFrame) {
  folder_.write("depth.txt", "1.021 depth/a.png\n1.09 depth/b.png\n");
  const auto flight = open();
  ASSERT_TRUE(flight) << message_of(flight);
  EXPECT_FALSE((*flight)->description().frames[0].depth);
  EXPECT_TRUE((*flight)->description().frames[1].depth);
  const auto frame = (*flight)->load(0);
  ASSERT_TRUE(frame) << message_of(frame);
  EXPECT_THAT(frame->depth_m.values(), testing::Each(0.0F));
  EXPECT_EQ(frame->depth_m.width(), test::kWidth);
}

TEST_F(NativeFlight, StreamsMayBeMissing) {
  for (const char* name : {"rgb.txt", "odometry.txt", "truth.txt"})
    fs::remove(folder_.path() / name);
  const auto flight = open();
  ASSERT_TRUE(flight) << message_of(flight);
  EXPECT_FALSE((*flight)->description().odometry);
  EXPECT_FALSE((*flight)->description().truth);
  EXPECT_FALSE((*flight)->description().frames[0].image);
  EXPECT_TRUE((*flight)->load(0));
}

TEST_F(NativeFlight, WithoutLabelsHasTheTimesOfItsImagesAndNothingToLocaliseWith) {
  fs::remove(folder_.path() / "labels.txt");
  const auto flight = open();
  ASSERT_TRUE(flight) << message_of(flight);
  ASSERT_EQ((*flight)->description().frames.size(), 3U);
  EXPECT_EQ((*flight)->description().frames[1].time_s, 1.05);
  const auto frame = (*flight)->load(0);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::kUnsupported);
  EXPECT_THAT(frame.error().message,
              EndsWith("has images but no label images, so there is nothing to localise with"));
}

TEST_F(NativeFlight, WithoutDepthOrCameraSaysWhatIsMissing) {
  fs::remove(folder_.path() / "depth.txt");
  EXPECT_THAT(message_of((*open())->load(0)), HasSubstr("has label images but no depth"));
  SetUp();
  folder_.write("flight.toml", "[flight]\nformat_version = 1\n");
  const auto frame = (*open())->load(0);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::kUnsupported);
  EXPECT_THAT(frame.error().message, HasSubstr("flight.toml has no [camera]"));
}

TEST_F(NativeFlight, WithTrajectoriesAloneHasNoFrames) {
  for (const char* name : {"rgb.txt", "depth.txt", "labels.txt"}) fs::remove(folder_.path() / name);
  const auto flight = open();
  ASSERT_TRUE(flight) << message_of(flight);
  EXPECT_TRUE((*flight)->description().frames.empty());
  EXPECT_EQ((*flight)->description().odometry->size(), 2U);
}

TEST_F(NativeFlight, NamesAListedFileThatIsNotThere) {
  fs::remove(folder_.path() / "labels/b.png");
  const auto flight = open();
  ASSERT_FALSE(flight);
  EXPECT_EQ(flight.error().code, ErrorCode::kNotFound);
  EXPECT_EQ(fault(), "labels.txt: line 3: labels/b.png does not exist");
}

TEST_F(NativeFlight, RefusesFilesOutsideItsFolder) {
  folder_.write("labels.txt", "1.0 /etc/passwd\n");
  EXPECT_EQ(fault(), "labels.txt: line 1: /etc/passwd lies outside the flight's folder");
  folder_.write("labels.txt", "1.0 labels/a.png\n1.1 ../../x.png\n");
  EXPECT_EQ(fault(), "labels.txt: line 2: ../../x.png lies outside the flight's folder");
}

TEST_F(NativeFlight, TakesAbsoluteNamesInsideItsFolder) {
  const auto absolute = fs::absolute(folder_.path() / "labels/a.png").string();
  folder_.write("labels.txt", "1.0 " + absolute + "\n");
  EXPECT_TRUE((*open())->load(0));
}

TEST_F(NativeFlight, RefusesTimesThatRepeatOrAreNotFinite) {
  folder_.write("depth.txt", "1.0 depth/a.png\n1.0 depth/b.png\n");
  EXPECT_EQ(fault(), "depth.txt: line 2: time 1 s does not come after 1 s of line 1");
  SetUp();
  folder_.write("rgb.txt", "nan a.jpg\n");
  EXPECT_EQ(fault(), "rgb.txt: line 1: 'nan' is not a finite time in seconds");
}

TEST_F(NativeFlight, RefusesPosesThatAreNotFinite) {
  folder_.write("odometry.txt", "0.9 0 0 0 0 0 0 1\n1.2 nan 0 0 0 0 0 1\n");
  EXPECT_THAT(fault(), HasSubstr("odometry.txt: line 2"));
  SetUp();
  folder_.write("truth.txt", "0.9 0 0 0 0 0 0 1\n0.9 0 0 0 0 0 0 1\n");
  EXPECT_THAT(fault(), HasSubstr("truth.txt: line 2"));
}

TEST_F(NativeFlight, RefusesAnEmptyTrajectory) {
  folder_.write("odometry.txt", "# nothing\n");
  EXPECT_THAT(fault(), HasSubstr("odometry.txt: holds no poses"));
}

TEST_F(NativeFlight, OpensWithADamagedImageAndFailsWhenThatFrameIsLoaded) {
  const auto whole = test::content_of(folder_.path() / "labels/b.png");
  folder_.write("labels/b.png", whole.substr(0, whole.size() / 2));
  const auto flight = open();
  ASSERT_TRUE(flight) << message_of(flight);
  EXPECT_TRUE((*flight)->load(0));
  const auto frame = (*flight)->load(1);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::kMalformed);
  EXPECT_EQ(frame.error().message,
            fmt::format("{}: is cut off after {} bytes", (folder_.path() / "labels/b.png").string(),
                        whole.size() / 2));
}

TEST_F(NativeFlight, RefusesImagesOfAnotherSizeThanTheCamera) {
  folder_.write("depth/a.png", text_of(*encode_depth_png(Raster<float>(5, 3, 1.0F))));
  EXPECT_THAT(message_of((*open())->load(0)),
              HasSubstr("depth/a.png: is 5 x 3 pixels, but the camera has 4 x 3"));
}

TEST_F(NativeFlight, FilesThatVanishAfterOpeningAreNotFound) {
  const auto flight = open();
  fs::remove(folder_.path() / "depth/a.png");
  const auto frame = (*flight)->load(0);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::kNotFound);
}

TEST_F(NativeFlight, ABrokenTomlFileIsNamed) {
  folder_.write("flight.toml", "[flight\n");
  EXPECT_THAT(fault(), HasSubstr("flight.toml: line 1"));
}

}  // namespace native_flight_test
}  // namespace nadir
