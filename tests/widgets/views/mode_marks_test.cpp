// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/mode_marks.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "tests/support/page_pixels.h"
#include "tests/widgets/views/drawn_chart.h"

namespace nadir {
namespace mode_marks_test {

using testing::ElementsAre;

constexpr PageRect kMap{20, 10, 300, 200};
constexpr Rgba kPlate{250, 250, 250, 217};
constexpr Rgba kArrow{86, 180, 233};

MapFrame frame() { return {kMap, {{100.0, 50.0}, 0.5}, 2.0}; }

ModeLook look() {
  ModeLook made;
  made.arrow = {kArrow, 1.0};
  made.plate = kPlate;
  return made;
}

PoseMode mode_at(double mass, double x_m, double y_m, double yaw_rad = 0.0) {
  return {mass, {{x_m, y_m, yaw_rad}, Eigen::Matrix3d::Identity()}};
}

RecordingCanvas drawn(const std::vector<PoseMode>& modes) {
  RecordingCanvas canvas;
  draw_modes(canvas, frame(), modes, look());
  return canvas;
}

std::vector<std::string> words_of(const RecordingCanvas& canvas) {
  std::vector<std::string> words;
  for (const auto& text : canvas.texts) words.push_back(text.line);
  return words;
}

Eigen::AlignedBox2d box_around(const std::vector<Eigen::Vector2d>& outline) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : outline) box.extend(point);
  return box;
}

TEST(MassText, IsWholePercentThatIsNeitherNoneNorAllByRounding) {
  EXPECT_EQ(mass_text(0.62), "62 %");
  EXPECT_EQ(mass_text(0.625), "62 %");
  EXPECT_EQ(mass_text(1.0), "100 %");
  EXPECT_EQ(mass_text(0.997), ">99 %");
  EXPECT_EQ(mass_text(0.994), "99 %");
  EXPECT_EQ(mass_text(0.004), "<1 %");
  EXPECT_EQ(mass_text(0.006), "1 %");
  EXPECT_EQ(mass_text(0.0), "0 %");
}

TEST(Modes, AreArrowsWhereTheyAreThatPointAlongTheirHeadings) {
  const std::vector<PoseMode> modes = {mode_at(0.6, 80, 60, 0.0),
                                       mode_at(0.4, 130, 40, std::numbers::pi / 2.0)};
  const RecordingCanvas canvas = drawn(modes);
  const auto arrows = canvas.fills_in(kArrow);
  ASSERT_EQ(arrows.size(), 2U);  // the heavier one is drawn last
  const std::array<PoseMode, 2> in_order = {modes[1], modes[0]};
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector2d at = frame().page(in_order.at(i).moments.mean.translation_m());
    EXPECT_TRUE(box_around(arrows[i].outline).contains(at));
    const double yaw_rad = in_order.at(i).moments.mean.yaw_rad;
    const Eigen::Vector2d tip = arrows[i].outline.front() - at;
    EXPECT_LT((tip - 13.0 * Eigen::Vector2d(std::cos(yaw_rad), std::sin(yaw_rad))).norm(), 1e-6);
    EXPECT_THAT(arrows[i].clips, ElementsAre(kMap));
  }
}

TEST(Modes, HaveTheirMassInWordsBesideThem) {
  const std::vector<PoseMode> modes = {mode_at(0.62, 80, 60), mode_at(0.38, 130, 40)};
  const RecordingCanvas canvas = drawn(modes);
  EXPECT_THAT(words_of(canvas), ElementsAre("38 %", "62 %"));
  const auto plates = mode_plates(frame(), modes, look());
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_TRUE(plates[i]);
    const Eigen::Vector2d at = frame().page(modes[i].moments.mean.translation_m());
    EXPECT_LT((plates[i]->centre() - at).norm(), 35.0);
    // Its letters lie on its plate.
    const auto& text = canvas.texts[1 - i];
    const Eigen::AlignedBox2d letters = text.box();
    EXPECT_GT(letters.min().x(), plates[i]->left);
    EXPECT_LT(letters.max().x(), plates[i]->right());
    EXPECT_LT(letters.max().y(), plates[i]->top());
  }
}

TEST(Modes, HavePlatesInsideOfTheMapThatHideNothing) {
  // At the corners, at the borders, crowded, and outside.
  std::vector<PoseMode> modes;
  for (const double x : {26.0, 100.0, 103.0, 109.0, 120.0, 174.0, 300.0}) {
    for (const double y : {1.0, 45.0, 52.0, 99.0}) {
      modes.push_back(mode_at(0.01 + 0.001 * static_cast<double>(modes.size()), x, y, x));
    }
  }
  const auto plates = mode_plates(frame(), modes, look());
  const double reach = 0.65 * 10.0 * 2.0;
  int drawn_plates = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (!plates[i]) continue;
    ++drawn_plates;
    EXPECT_GE(plates[i]->left, kMap.left);
    EXPECT_LE(plates[i]->right(), kMap.right());
    EXPECT_GE(plates[i]->bottom, kMap.bottom);
    EXPECT_LE(plates[i]->top(), kMap.top());
    for (std::size_t j = 0; j < modes.size(); ++j) {
      if (j != i && plates[j]) {
        EXPECT_TRUE(plates[i]->left >= plates[j]->right() ||
                    plates[j]->left >= plates[i]->right() ||
                    plates[i]->bottom >= plates[j]->top() || plates[j]->bottom >= plates[i]->top());
      }
      const Eigen::Vector2d at = frame().page(modes[j].moments.mean.translation_m());
      EXPECT_FALSE(holds({plates[i]->left - reach, plates[i]->bottom - reach,
                          plates[i]->width + 2.0 * reach, plates[i]->height + 2.0 * reach},
                         at));
    }
  }
  EXPECT_GE(drawn_plates, 8);
}

TEST(Modes, LoseTheWordsOfTheLighterOneWhereThereIsNoRoomForBoth) {
  // A map that holds one plate only.
  const PageRect small{0.0, 0.0, 80.0, 90.0};
  const MapFrame tight{small, {{0.0, 0.0}, 0.5}, 2.0};
  const std::vector<PoseMode> modes = {mode_at(0.3, 0.0, -5.0), mode_at(0.7, 0.0, -5.0)};
  const auto plates = mode_plates(tight, modes, look());
  EXPECT_FALSE(plates[0]);
  EXPECT_TRUE(plates[1]);
}

TEST(Modes, ThatAreNotFiniteArePassedOver) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const RecordingCanvas canvas =
      drawn({mode_at(0.5, kNaN, 50), mode_at(0.5, 100, 50, kNaN), mode_at(kNaN, 100, 50)});
  EXPECT_TRUE(canvas.fills.empty());
  EXPECT_TRUE(canvas.texts.empty());
  EXPECT_TRUE(drawn({}).fills.empty());
}

}  // namespace mode_marks_test
}  // namespace nadir
