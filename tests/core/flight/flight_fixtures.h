// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/flight/flight_recording.h"

namespace nadir::test {

/// An empty folder of the running test's own; gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::temp_directory_path() /
            fmt::format("nadir-{}-{}-{}", ::getpid(), test->test_suite_name(), test->name());
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes a file, making its folders.
  std::filesystem::path write(const std::filesystem::path& name, std::string_view content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string text_of(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

inline std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The whole message, or "" where there is no error: messages are part of what is promised.
template <typename T>
std::string message_of(const Result<T>& result) {
  return result ? std::string() : result.error().message;
}

/// 4 x 3 pixels. Labels are classes counted up from `first`; depth in metres is 0.5, 1.0, 1.5 ...
inline constexpr int kWidth = 4;
inline constexpr int kHeight = 3;
inline SemanticFrame small_frame(double time_s, int first = 0) {
  SemanticFrame frame{time_s, Raster<ClassId>(kWidth, kHeight), Raster<float>(kWidth, kHeight)};
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    const int id = (first + static_cast<int>(i)) % kClassCount;
    frame.labels.values()[i] = static_cast<ClassId>(id);
    frame.depth_m.values()[i] = 0.5F * static_cast<float>(i + 1);
  }
  frame.labels.at(kWidth - 1, kHeight - 1) = kUnclassified;
  return frame;
}

inline CameraModel small_camera() { return {kWidth, kHeight, 5.0, 5.25, 2.125, 1.375}; }

/// Straight ahead along x at 2 m/s, one pose every `period_s`.
inline Trajectory straight_path(double start_s, double period_s, int count) {
  std::vector<TimedPose> poses;
  for (int i = 0; i < count; ++i) {
    const double since_s = period_s * i;
    poses.push_back(
        {start_s + since_s, Rigid3{Eigen::Quaterniond::Identity(), {2.0 * since_s, 0.0, 1.5}}});
  }
  return Trajectory::create(std::move(poses), "straight path").value();
}

}  // namespace nadir::test
