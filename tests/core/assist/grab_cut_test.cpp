// SPDX-License-Identifier: Apache-2.0
#include "core/assist/grab_cut.h"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>
#include <thread>

#include "tests/core/assist/drawn_windows.h"

namespace nadir {
namespace grab_cut_test {

using testing::HasSubstr;

Ring places(const AssistWindow& window, const std::vector<std::pair<double, double>>& in_pixels) {
  Ring ring;
  for (const auto& [x, y] : in_pixels) {
    ring.push_back(window.enu_from_pixels() * Eigen::Vector2d(x, y));
  }
  return ring;
}
Ring rectangle(const AssistWindow& window, double left, double top, double right, double bottom) {
  return places(window, {{left, top}, {right, top}, {right, bottom}, {left, bottom}});
}

PixelMask cut(const AssistWindow& window,
              const GrabCutMarks& marks,
              const GrabCutOptions& options = {}) {
  auto found = grab_cut(window, marks, options);
  if (!found) throw std::runtime_error(error_text(found));
  return std::move(*found);
}

constexpr int kWidth = 240;
constexpr int kHeight = 200;

AssistWindow window_with(const Inside& inside, double sigma = 18.0) {
  return window_of(noisy(drawn_picture(kWidth, kHeight, inside, 4), sigma), turned_place());
}
PixelMask truth(const Inside& inside) { return pixels_inside(kWidth, kHeight, inside); }

TEST(GrabCut, FindsANoisyDiscInARectangle) {
  const Inside inside = disc(110.0, 95.0, 52.0);
  const AssistWindow window = window_with(inside);
  const PixelMask found = cut(window, {.around = rectangle(window, 40.0, 30.0, 190.0, 170.0)});
  EXPECT_GT(overlap(found, truth(inside)), 0.97);
}

TEST(GrabCut, FindsItAsWellByStrokesAlone) {
  const Inside inside = disc(110.0, 95.0, 52.0);
  const AssistWindow window = window_with(inside);
  const PixelMask found =
      cut(window, {.wanted = {places(window, {{90.0, 90.0}, {130.0, 100.0}})},
                   .unwanted = {places(window, {{10.0, 10.0}, {200.0, 20.0}, {220.0, 180.0}})}});
  EXPECT_GT(overlap(found, truth(inside)), 0.97);
}

TEST(GrabCut, IsRefinedByMoreStrokes) {
  const Inside one = disc(70.0, 95.0, 38.0);
  const Inside other = disc(175.0, 95.0, 30.0);
  const AssistWindow window =
      window_with([&](const Eigen::Vector2d& at) { return one(at) || other(at); });
  GrabCutMarks marks{.around = rectangle(window, 15.0, 30.0, 225.0, 165.0)};
  const PixelMask both = cut(window, marks);
  EXPECT_GT(overlap(both, truth([&](const Eigen::Vector2d& at) { return one(at) || other(at); })),
            0.95);
  marks.unwanted.push_back(places(window, {{155.0, 80.0}, {195.0, 110.0}, {160.0, 110.0}}));
  marks.wanted.push_back(places(window, {{50.0, 80.0}, {90.0, 110.0}}));
  const PixelMask first = cut(window, marks);
  // What is marked stays marked, whatever its colour.
  EXPECT_EQ(first.at(155, 80), 0);
  EXPECT_EQ(first.at(60, 87), 1);
  EXPECT_GT(overlap(first, truth(one)), overlap(both, truth(one)));
  // Taking the strokes back takes their effect back.
  marks.unwanted.clear();
  marks.wanted.clear();
  EXPECT_EQ(cut(window, marks), both);
}

TEST(GrabCut, StaysWithinTheRing) {
  // Its border runs close to one disc and leaves out another of the same colour.
  const Inside one = disc(70.0, 95.0, 38.0);
  const Inside other = disc(175.0, 95.0, 12.0);
  const AssistWindow window =
      window_with([&](const Eigen::Vector2d& at) { return one(at) || other(at); });
  const PixelMask found = cut(window, {.around = rectangle(window, 25.0, 50.0, 115.0, 140.0)});
  EXPECT_GT(overlap(found, truth(one)), 0.95);
  for (int row = 0; row < kHeight; ++row) EXPECT_EQ(found.at(116, row), 0);
}

TEST(GrabCut, IsTheSameOnAnyNumberOfThreadsAndWhateverWasDrawnBefore) {
  const AssistWindow window = window_with(disc(110.0, 95.0, 52.0), 40.0);
  const GrabCutMarks marks{.around = rectangle(window, 40.0, 30.0, 190.0, 170.0)};
  const int before = cv::getNumThreads();
  cv::setNumThreads(1);
  const PixelMask alone = cut(window, marks);
  cv::setNumThreads(4);
  cv::theRNG().state = 99;
  EXPECT_EQ(cut(window, marks), alone);
  EXPECT_EQ(cv::theRNG().state, 99U);  // Nor does it change what others draw.
  PixelMask elsewhere;
  std::thread([&] { elsewhere = cut(window, marks); }).join();
  EXPECT_EQ(elsewhere, alone);
  cv::setNumThreads(before);
}

TEST(GrabCut, LeavesOutWhatWasNotSeen) {
  ImageRaster pixels = drawn_picture(kWidth, kHeight, disc(110.0, 95.0, 52.0), 4);
  for (int row = 80; row < 100; ++row) {
    for (int column = 90; column < 110; ++column) pixels.at(column, row).alpha = 0;
  }
  const AssistWindow window = window_of(noisy(pixels, 10.0), turned_place());
  const PixelMask found = cut(window, {.around = rectangle(window, 40.0, 30.0, 190.0, 170.0),
                                       .wanted = {places(window, {{80.0, 90.0}, {140.0, 90.0}})}});
  for (int row = 80; row < 100; ++row) {
    for (int column = 90; column < 110; ++column) EXPECT_EQ(found.at(column, row), 0);
  }
  EXPECT_EQ(found.at(130, 90), 1);
}

TEST(GrabCut, OfOneColourOrOnePixelEndsSomehow) {
  const AssistWindow plain = window_of(ImageRaster(60, 50, kGrass), plain_place());
  const PixelMask found = cut(plain, {.around = rectangle(plain, 10.0, 10.0, 40.0, 40.0),
                                      .wanted = {places(plain, {{20.5, 20.5}})}});
  EXPECT_EQ(found.at(20, 20), 1);
  EXPECT_EQ(found.at(5, 5), 0);
  const AssistWindow one = window_of(ImageRaster(1, 1, kGrass), plain_place());
  EXPECT_EQ(error_text(grab_cut(one, {.wanted = {places(one, {{0.5, 0.5}})}})),
            "the marks leave nothing that could be unwanted");
}

TEST(GrabCut, NeedsBothSides) {
  const AssistWindow window = window_with(disc(110.0, 95.0, 52.0));
  EXPECT_EQ(error_text(grab_cut(window, {})), "the marks leave nothing that could be wanted");
  EXPECT_EQ(error_text(grab_cut(window, {.around = rectangle(window, 300.0, 0.0, 400.0, 90.0)})),
            "the marks leave nothing that could be wanted");
  EXPECT_EQ(error_text(grab_cut(window, {.around = rectangle(window, -9.0, -9.0, 900.0, 900.0)})),
            "the marks leave nothing that could be unwanted");
  EXPECT_THAT(error_text(grab_cut(window, {.wanted = {{{std::nan(""), 0.0}}}})),
              HasSubstr("not within 1000 km"));
  EXPECT_THAT(error_text(grab_cut(window, {}, {.iterations = 0})),
              HasSubstr("--grab-cut-iterations"));
}

TEST(GrabCut, CanBeStopped) {
  const AssistWindow window = window_with(disc(110.0, 95.0, 52.0));
  std::stop_source source;
  source.request_stop();
  WorkContext context;
  context.stop = source.get_token();
  const auto stopped =
      grab_cut(window, {.around = rectangle(window, 40.0, 30.0, 190.0, 170.0)}, {}, context);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(error_code(stopped), ErrorCode::kCancelled);
}

}  // namespace grab_cut_test
}  // namespace nadir
