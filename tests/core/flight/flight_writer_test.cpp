// SPDX-License-Identifier: Apache-2.0
#include "core/flight/flight_writer.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <limits>

#include "core/base/random.h"
#include "core/flight/colour_image.h"
#include "tests/core/flight/flight_fixtures.h"

namespace nadir {
namespace flight_writer_test {

namespace fs = std::filesystem;
using test::message_of;
using test::small_camera;
using test::small_frame;
using test::straight_path;
using testing::HasSubstr;

FlightDescription small_description() {
  FlightDescription flight;
  flight.name = "written";
  flight.camera = small_camera();
  flight.body_from_camera = {forward_body_from_camera(), {0.1, 0.2, -0.3}};
  flight.altitude_m = 2.5;
  flight.truth_origin = Geodetic{33.450112, -83.901223};
  return flight;
}

class FlightWriterTest : public testing::Test {
 protected:
  [[nodiscard]] fs::path target() const { return folder_.path() / "flight"; }
  [[nodiscard]] Result<FlightWriter> create(const FlightDescription& flight) const {
    return FlightWriter::create(target(), flight, "made by a test", "a test");
  }
  /// Names in the parent folder: nothing half-written may stay there.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      found.push_back(entry.path().filename().string());
    }
    return found;
  }

  test::TemporaryFolder folder_;
};

TEST_F(FlightWriterTest, WhatIsWrittenIsReadBack) {
  auto writer = create(small_description());
  ASSERT_TRUE(writer) << message_of(writer);
  // Times whose decimal text is long: they must come back to the last bit, or streams no longer
  // meet.
  const std::vector<double> times_s{0.1, 0.1 + 1.0 / 3.0, 1.0 / 0.7, 2.0};
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const auto encoded = encode_frame(small_frame(times_s[i], static_cast<int>(i)));
    ASSERT_TRUE(encoded) << message_of(encoded);
    ASSERT_TRUE(writer->write(*encoded));
  }
  const Trajectory truth = straight_path(0.0, 1.0 / 7.0, 20);
  const Trajectory odometry = straight_path(0.05, 0.1, 30);
  const auto finished = writer->finish(odometry, truth);
  ASSERT_TRUE(finished) << message_of(finished);
  EXPECT_THAT(names(), testing::ElementsAre("flight"));

  const auto flight = open_flight(target());
  ASSERT_TRUE(flight) << message_of(flight);
  const FlightDescription& d = (*flight)->description();
  EXPECT_EQ(d.name, "written");
  EXPECT_EQ(d.altitude_m, 2.5);
  EXPECT_EQ(d.camera->focal_y_px, small_camera().focal_y_px);
  EXPECT_EQ(d.camera->centre_x_px, small_camera().centre_x_px);
  EXPECT_EQ(d.camera->centre_y_px, small_camera().centre_y_px);
  EXPECT_EQ(d.body_from_camera.translation_m, Eigen::Vector3d(0.1, 0.2, -0.3));
  EXPECT_EQ(d.truth_origin->longitude_deg, -83.901223);
  ASSERT_EQ(d.frames.size(), times_s.size());
  ASSERT_EQ(d.odometry->size(), odometry.size());
  ASSERT_EQ(d.truth->size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_EQ(d.truth->poses()[i].time_s, truth.poses()[i].time_s);
    EXPECT_EQ(d.truth->poses()[i].pose.translation_m, truth.poses()[i].pose.translation_m);
  }
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const auto frame = (*flight)->load(i);
    ASSERT_TRUE(frame) << message_of(frame);
    const SemanticFrame written = small_frame(times_s[i], static_cast<int>(i));
    EXPECT_EQ(frame->time_s, written.time_s);
    EXPECT_EQ(frame->labels, written.labels);
    EXPECT_EQ(frame->depth_m, written.depth_m);  // Half metres are whole millimetres.
  }
}

TEST_F(FlightWriterTest, ColourIsReadBackWhereAFrameHasIt) {
  const ColourRaster image(24, 16, Colour{200, 40, 90});
  auto writer = create(small_description());
  ASSERT_TRUE(writer) << message_of(writer);
  ASSERT_TRUE(writer->write(*encode_frame(small_frame(1.0))));
  ASSERT_TRUE(writer->write(*encode_frame(small_frame(1.5), image)));
  ASSERT_TRUE(writer->write(*encode_frame(small_frame(2.0), image)));
  ASSERT_TRUE(writer->finish({}, {}));
  const auto flight = open_flight(target());
  ASSERT_TRUE(flight) << message_of(flight);
  const auto& frames = (*flight)->description().frames;
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_FALSE(frames[0].image);
  ASSERT_TRUE(frames[1].image && frames[2].image);
  EXPECT_EQ(frames[2].image->filename(), "000002.jpg");
  const auto colours = read_colour_image(*frames[1].image);
  ASSERT_TRUE(colours) << message_of(colours);
  EXPECT_EQ(colours->width(), 24);
  EXPECT_NEAR(colours->at(12, 8).red, 200, 3);
  EXPECT_NEAR(colours->at(12, 8).blue, 90, 3);
}

TEST_F(FlightWriterTest, AFlightWithoutColourIsWholeAndHasNoTraceOfIt) {
  auto writer = create(small_description());
  ASSERT_TRUE(writer->write(*encode_frame(small_frame(1.0))));
  ASSERT_TRUE(writer->finish({}, {}));
  EXPECT_FALSE(fs::exists(target() / "rgb"));
  EXPECT_FALSE(fs::exists(target() / "rgb.txt"));
  const auto flight = open_flight(target());
  ASSERT_TRUE(flight) << message_of(flight);
  EXPECT_FALSE((*flight)->description().frames[0].image);
  EXPECT_TRUE((*flight)->load(0));
}

TEST_F(FlightWriterTest, ReplacesAFlightWithColourByOneWithout) {
  for (const bool has_colour : {true, false}) {
    auto writer = create(small_description());
    ASSERT_TRUE(writer) << message_of(writer);
    std::optional<ColourRaster> image;
    if (has_colour) image = ColourRaster(8, 8);
    ASSERT_TRUE(writer->write(*encode_frame(small_frame(1.0), image)));
    ASSERT_TRUE(writer->finish({}, {}));
    EXPECT_EQ(fs::exists(target() / "rgb" / "000000.jpg"), has_colour);
  }
}

TEST_F(FlightWriterTest, RefusesAnImageThatIsNone) {
  auto writer = create(small_description());
  EncodedFrame frame = *encode_frame(small_frame(1.0));
  frame.image_jpeg = frame.labels_png;
  EXPECT_THAT(message_of(writer->write(frame)), HasSubstr("flight/rgb/000000.jpg: is no JPEG"));
  EXPECT_EQ(message_of(encode_frame(small_frame(1.0), ColourRaster())),
            "frame at 1 s: its image has no pixels");
}

TEST_F(FlightWriterTest, TheSameFlightHasTheSameBytes) {
  std::vector<std::string> contents;
  for (int run = 0; run < 2; ++run) {
    auto writer = create(small_description());
    ASSERT_TRUE(writer->write(*encode_frame(small_frame(1.0))));
    ASSERT_TRUE(writer->finish(straight_path(0.0, 0.1, 5), {}));
    for (const char* name : {"flight.toml", "labels.txt", "depth/000000.png", "odometry.txt"}) {
      contents.push_back(test::content_of(target() / name));
      EXPECT_FALSE(contents.back().empty()) << name;
    }
  }
  EXPECT_TRUE(std::equal(contents.begin(), contents.begin() + 4, contents.begin() + 4));
}

TEST_F(FlightWriterTest, NothingStaysWhereAFlightIsNotFinished) {
  {
    auto writer = create(small_description());
    ASSERT_TRUE(writer->write(*encode_frame(small_frame(1.0))));
    EXPECT_FALSE(fs::exists(target()));
  }
  EXPECT_THAT(names(), testing::IsEmpty());
}

TEST_F(FlightWriterTest, AbsentAndEmptyTrajectoriesAreLeftOut) {
  auto writer = create(small_description());
  ASSERT_TRUE(writer->finish({}, Trajectory()));
  EXPECT_FALSE(fs::exists(target() / "odometry.txt"));
  EXPECT_FALSE(fs::exists(target() / "truth.txt"));
  EXPECT_TRUE(open_flight(target()));
}

TEST_F(FlightWriterTest, ProvenanceIsInTheFile) {
  ASSERT_TRUE(create(small_description())->finish({}, {}));
  EXPECT_THAT(test::content_of(target() / "flight.toml"),
              HasSubstr("provenance = \"made by a test\""));
}

TEST_F(FlightWriterTest, AnOlderFlightIsReplacedAndOtherFoldersAreLeftAlone) {
  ASSERT_TRUE(create(small_description())->finish({}, {}));
  folder_.write("flight/labels/000099.png", "of a longer flight");
  ASSERT_TRUE(create(small_description())->finish({}, {}));
  EXPECT_FALSE(fs::exists(target() / "labels" / "000099.png"));

  folder_.write("flight/notes.txt", "precious");
  const auto over_notes = FlightWriter::create(target(), small_description(), "");
  ASSERT_FALSE(over_notes);
  EXPECT_THAT(over_notes.error().message, HasSubstr("holds notes.txt"));
  EXPECT_TRUE(fs::exists(target() / "notes.txt"));

  folder_.write("thesis/chapter.txt", "precious");
  const auto writer = FlightWriter::create(folder_.path() / "thesis", small_description(), "");
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().code, ErrorCode::kIo);
  EXPECT_TRUE(fs::exists(folder_.path() / "thesis/chapter.txt"));
}

/// A camera's recording in the native format, as a converter puts it together: every name in it is
/// one that the writer uses, too.
std::string recording(const test::TemporaryFolder& folder, std::string_view generator_line = {}) {
  folder.write("flight/rgb/000000.jpg", "what can never be seen again");
  folder.write("flight/rgb.txt", "1.0 rgb/000000.jpg\n");
  std::string text = fmt::format("[flight]\nformat_version = 1\n{}", generator_line);
  folder.write("flight/flight.toml", text);
  return text;
}

TEST_F(FlightWriterTest, ARecordingIsNeverReplaced) {
  const std::string text = recording(folder_);
  const auto writer = create(small_description());
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().code, ErrorCode::kIo);
  EXPECT_EQ(writer.error().message,
            target().string() +
                ": holds a flight that may be a recording, so it is left alone; name a new folder");
  // Nor by a recorder, which has no generator either.
  EXPECT_THAT(message_of(FlightWriter::create(target(), small_description(), "recorded")),
              HasSubstr("may be a recording"));
  EXPECT_EQ(test::content_of(target() / "flight.toml"), text);
  EXPECT_EQ(test::content_of(target() / "rgb/000000.jpg"), "what can never be seen again");
  EXPECT_THAT(names(), testing::ElementsAre("flight"));
}

TEST_F(FlightWriterTest, AnotherProgramsFlightAndOneThatCannotBeReadAreLeftAlone) {
  recording(folder_, "generator = \"another test\"\n");
  EXPECT_THAT(message_of(create(small_description())),
              HasSubstr("flight: holds a flight that was made by another test, so it is left"));
  recording(folder_, "generator = \"a test\"\nwings = 2\n");
  EXPECT_THAT(message_of(create(small_description())),
              AllOf(HasSubstr("flight: is left alone; name a new folder ("), HasSubstr("wings")));
  EXPECT_TRUE(fs::exists(target() / "rgb/000000.jpg"));
  recording(folder_, "generator = \"a test\"\n");
  EXPECT_TRUE(create(small_description()));
}

TEST_F(FlightWriterTest, ARecordingThatArrivesWhileTheFlightIsWrittenStays) {
  {
    auto writer = create(small_description());
    ASSERT_TRUE(writer->write(*encode_frame(small_frame(1.0))));
    recording(folder_);
    const auto finished = writer->finish({}, {});
    ASSERT_FALSE(finished);
    EXPECT_EQ(finished.error().code, ErrorCode::kIo);
    EXPECT_THAT(finished.error().message, HasSubstr("may be a recording, so it is left alone"));
  }
  EXPECT_EQ(test::content_of(target() / "rgb/000000.jpg"), "what can never be seen again");
  EXPECT_THAT(names(), testing::ElementsAre("flight"));
}

TEST_F(FlightWriterTest, AFolderWhoseParentIsMissingIsRefused) {
  const auto writer =
      FlightWriter::create(folder_.path() / "no" / "flight", small_description(), "");
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().code, ErrorCode::kIo);
}

TEST_F(FlightWriterTest, AnImpossibleCameraIsRefusedBeforeAnythingIsWritten) {
  FlightDescription flight = small_description();
  flight.camera->focal_x_px = -1.0;
  EXPECT_FALSE(create(flight));
  flight = small_description();
  flight.altitude_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(create(flight));
  EXPECT_THAT(names(), testing::IsEmpty());
}

TEST_F(FlightWriterTest, FramesMustComeInOrderOfTime) {
  auto writer = create(small_description());
  ASSERT_TRUE(writer->write(*encode_frame(small_frame(1.0))));
  EXPECT_EQ(message_of(writer->write(*encode_frame(small_frame(1.0)))),
            target().string() + ": frame 1 at 1 s does not come after 1 s");
  EXPECT_FALSE(writer->write(*encode_frame(small_frame(0.5))));
  EXPECT_TRUE(writer->write(*encode_frame(small_frame(1.5))));
}

TEST_F(FlightWriterTest, FramesMustHaveTheCamerasSize) {
  FlightDescription flight = small_description();
  flight.camera->width = 8;
  auto writer = create(flight);
  EXPECT_THAT(message_of(writer->write(*encode_frame(small_frame(1.0)))),
              HasSubstr("labels/000000.png: is 4 x 3 pixels, but the camera has 8 x 3"));
}

/// Files can grow to `bytes` only while this lives: what a full disk looks like to a program.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(FlightWriterTest, ADiskThatFillsUpIsReportedAndLeavesNothing) {
  FlightDescription description = small_description();
  description.camera = CameraModel::from_horizontal_view(160, 120, 1.0);
  SemanticFrame frame{1.0, Raster<ClassId>(160, 120), Raster<float>(160, 120)};
  for (std::uint32_t i = 0; i < frame.labels.size(); ++i) {
    frame.labels.values()[i] = static_cast<ClassId>(random_words({1, 0, i, 0, 0})[0] % kClassCount);
  }
  const auto encoded = encode_frame(frame);
  ASSERT_TRUE(encoded) << message_of(encoded);
  ASSERT_GT(encoded->labels_png.size(), 2000U);
  {
    auto writer = create(description);
    ASSERT_TRUE(writer) << message_of(writer);
    const FileSizeLimit limit(1000);
    const auto written = writer->write(*encoded);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::kIo);
    EXPECT_THAT(written.error().message,
                HasSubstr("flight/labels/000000.png: cannot be written: "));
  }
  {
    auto writer = create(description);
    ASSERT_TRUE(writer->write(*encoded));
    const FileSizeLimit limit(100);
    const auto finished = writer->finish(straight_path(0.0, 0.1, 50), {});
    ASSERT_FALSE(finished);
    EXPECT_EQ(finished.error().code, ErrorCode::kIo);
  }
  EXPECT_THAT(names(), testing::IsEmpty());
}

TEST(EncodeFrame, RefusesWhatCouldNotBeReadBack) {
  SemanticFrame frame = small_frame(3.2);
  frame.labels.at(1, 1) = 16;
  EXPECT_EQ(message_of(encode_frame(frame)),
            "frame at 3.2 s: its labels have id 16, which is no class");
  frame = small_frame(3.2);
  frame.depth_m = Raster<float>(5, 3);
  EXPECT_EQ(message_of(encode_frame(frame)),
            "frame at 3.2 s: its labels are 4 x 3 pixels and its depth 5 x 3");
  EXPECT_EQ(message_of(encode_frame({3.2, {}, {}})), "frame at 3.2 s: it has no labels");
  EXPECT_FALSE(encode_frame(small_frame(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace flight_writer_test
}  // namespace nadir
