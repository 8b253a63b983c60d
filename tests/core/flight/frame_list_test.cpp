// SPDX-License-Identifier: Apache-2.0
#include "core/flight/frame_list.h"

#include <gmock/gmock.h>

#include "core/base/random.h"
#include "tests/core/flight/flight_fixtures.h"

namespace nadir {
namespace frame_list_test {

using test::message_of;

TEST(FrameList, HasTimesFilesAndLines) {
  const auto files = parse_frame_list(
      "# time_s file\n\n1.5 labels/0.png\r\n2.25\tlabels/my file.png  \n1e1 c.png", "labels.txt");
  ASSERT_TRUE(files) << message_of(files);
  ASSERT_EQ(files->size(), 3U);
  EXPECT_EQ((*files)[0].time_s, 1.5);
  EXPECT_EQ((*files)[0].file, "labels/0.png");
  EXPECT_EQ((*files)[0].line, 3);
  EXPECT_EQ((*files)[1].time_s, 2.25);
  EXPECT_EQ((*files)[1].file, "labels/my file.png");
  EXPECT_EQ((*files)[2].time_s, 10.0);
}

TEST(FrameList, OfNothingIsEmpty) {
  EXPECT_TRUE(parse_frame_list("", "rgb.txt")->empty());
  EXPECT_TRUE(parse_frame_list("# only a comment", "rgb.txt")->empty());
}

TEST(FrameList, KeepsEveryDigitOfATimeSince1970) {
  const auto files = parse_frame_list("1403715529.2121429 a.png\n", "rgb.txt");
  EXPECT_EQ(files->front().time_s, 1403715529.2121429);
}

TEST(FrameList, RefusesTimesThatAreNoTimes) {
  for (const char* time : {"nan", "inf", "-inf", "abc", "1.5x", "0x10", "1e999", "--1"}) {
    const auto files = parse_frame_list(fmt::format("1 a.png\n{} b.png\n", time), "rgb.txt");
    ASSERT_FALSE(files) << time;
    EXPECT_EQ(files.error().code, ErrorCode::kMalformed);
    EXPECT_EQ(files.error().message,
              fmt::format("rgb.txt: line 2: '{}' is not a finite time in seconds", time));
  }
}

TEST(FrameList, RefusesTimesThatRepeatOrGoBackAndNamesBothLines) {
  EXPECT_EQ(message_of(parse_frame_list("1 a.png\n# x\n1 b.png\n", "depth.txt")),
            "depth.txt: line 3: time 1 s does not come after 1 s of line 1");
  EXPECT_EQ(message_of(parse_frame_list("1 a.png\n2 b.png\n1.5 c.png", "depth.txt")),
            "depth.txt: line 3: time 1.5 s does not come after 2 s of line 2");
}

TEST(FrameList, RefusesATimeWithoutAFile) {
  EXPECT_EQ(message_of(parse_frame_list("1 a.png\n2\n", "labels.txt")),
            "labels.txt: line 2: has a time but no file");
}

TEST(PathInside, TakesNamesThatEndUpInTheFolder) {
  const std::filesystem::path folder = "/flights/one";
  EXPECT_EQ(*path_inside(folder, "labels/0.png"), "/flights/one/labels/0.png");
  EXPECT_EQ(*path_inside(folder, "./labels/../depth/0.png"), "/flights/one/depth/0.png");
  EXPECT_EQ(*path_inside(folder, "../one/a.png"), "/flights/one/a.png");
  EXPECT_EQ(*path_inside(folder, "/flights/one/a.png"), "/flights/one/a.png");
  EXPECT_EQ(*path_inside(folder, "..a.png"), "/flights/one/..a.png");
}

TEST(PathInside, WorksForRelativeFoldersWithOrWithoutSlash) {
  EXPECT_EQ(*path_inside("flight", "a.png"), "flight/a.png");
  EXPECT_EQ(*path_inside("flight/", "a.png"), "flight/a.png");
  EXPECT_EQ(*path_inside(".", "a.png"), "./a.png");
  EXPECT_TRUE(path_inside("flight/", "../flight/a.png"));
}

TEST(PathInside, RefusesNamesThatLeaveTheFolder) {
  for (const char* folder : {"/flights/one", "/flights/one/"}) {
    for (const char* file : {"../a.png", "/etc/passwd", "labels/../../a.png",
                             "/flights/one-more/a.png", "/flights", ".", ".."}) {
      const auto path = path_inside(folder, file);
      ASSERT_FALSE(path) << file << " gave " << path->string();
      EXPECT_EQ(path.error().message, fmt::format("{} lies outside the flight's folder", file));
    }
  }
}

TEST(PathInside, RefusesControlCharacters) {
  const std::string hidden("../../etc/passwd\0/../../../a.png", 32);
  EXPECT_EQ(message_of(path_inside("/flights/one", hidden)),
            "the file name holds control characters");
}

std::vector<ListedFile> files_at(const std::vector<double>& times_s) {
  std::vector<ListedFile> files;
  for (const double time_s : times_s) files.push_back({time_s, "x", 0});
  return files;
}

TEST(NearestInTime, IsTheOneThatASearchThroughAllFinds) {
  std::vector<double> times_s;
  double time_s = 5.0;
  for (std::uint32_t i = 0; i < 200; ++i) {
    time_s += 0.01 + 1e-10 * random_words({7, 1, i, 0, 0})[0];
    times_s.push_back(time_s);
  }
  const auto files = files_at(times_s);
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const double asked_s = 4.0 + (time_s - 3.0) * (random_words({7, 2, i, 0, 0})[0] / 4294967296.0);
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < times_s.size(); ++k) {
      if (std::abs(times_s[k] - asked_s) < std::abs(times_s[nearest] - asked_s)) nearest = k;
    }
    const bool is_near = std::abs(times_s[nearest] - asked_s) <= 0.08;
    const auto found = nearest_in_time(files, asked_s, 0.08);
    ASSERT_EQ(found.has_value(), is_near) << asked_s;
    if (is_near) {
      EXPECT_EQ(*found, nearest) << asked_s;
    }
  }
}

TEST(NearestInTime, TakesTheEarlierOfTwoAndIncludesTheTolerance) {
  const auto files = files_at({1.0, 2.0, 4.0});
  EXPECT_EQ(nearest_in_time(files, 1.5, 1.0), 0U);
  EXPECT_EQ(nearest_in_time(files, 3.0, 1.0), 1U);
  EXPECT_EQ(nearest_in_time(files, 5.0, 1.0), 2U);
  EXPECT_EQ(nearest_in_time(files, 5.25, 1.0), std::nullopt);
  EXPECT_EQ(nearest_in_time(files, 0.5, 0.25), std::nullopt);
  EXPECT_EQ(nearest_in_time({}, 0.0, 1.0), std::nullopt);
}

TEST(AssociationTolerance, IsHalfAPeriodUpTo20Milliseconds) {
  EXPECT_EQ(association_tolerance_s({}), 0.02);
  EXPECT_EQ(association_tolerance_s(files_at({3.0})), 0.02);
  EXPECT_EQ(association_tolerance_s(files_at({0.0, 0.5, 1.0})), 0.02);
  EXPECT_NEAR(association_tolerance_s(files_at({0.0, 0.01, 0.02, 5.0})), 0.005, 1e-12);
}

}  // namespace frame_list_test
}  // namespace nadir
