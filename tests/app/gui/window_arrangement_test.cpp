// SPDX-License-Identifier: Apache-2.0
#include "app/gui/window_arrangement.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace nadir {
namespace window_arrangement_test {

WindowWishes usual(double width, double height, double scale) {
  WindowWishes wishes;
  wishes.width_px = width;
  wishes.height_px = height;
  wishes.scale = scale;
  wishes.has_left = wishes.has_right = wishes.has_timeline = wishes.has_status = true;
  wishes.left_pt = 320.0;
  wishes.right_pt = 380.0;
  wishes.timeline_pt = 216.0;
  return wishes;
}

std::vector<std::pair<std::string, kit::Rect>> shown(const WindowPlaces& places) {
  const std::array<std::pair<std::string, kit::Rect>, 9> all = {
      {{"menu", places.menu},
       {"rail", places.rail},
       {"left", places.left},
       {"left strip", places.left_strip},
       {"map", places.map},
       {"right", places.right},
       {"right strip", places.right_strip},
       {"timeline", places.timeline},
       {"status", places.status}}};
  std::vector<std::pair<std::string, kit::Rect>> found;
  for (const auto& [name, rect] : all) {
    if (rect.width > 0.0 && rect.height > 0.0) found.emplace_back(name, rect);
  }
  return found;
}

bool overlap(const kit::Rect& a, const kit::Rect& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

TEST(WindowArrangement, GivesAllTheirWishWhereThereIsRoom) {
  const WindowPlaces places = arrange_window(usual(1280.0, 800.0, 1.0));
  EXPECT_EQ(places.left.width, 320.0);
  EXPECT_EQ(places.right.width, 380.0);
  EXPECT_EQ(places.timeline.height, 216.0);
  EXPECT_EQ(places.map.width, 1280.0 - 64.0 - 320.0 - 380.0);
  EXPECT_EQ(places.left_strip.width + places.right_strip.width, 0.0);
}

TEST(WindowArrangement, FillsAnyWindowWithoutOverlap) {
  for (const double scale : {0.75, 1.0, 1.25, 1.5, 2.0, 3.0}) {
    for (const double width : {320.0, 640.0, 960.0, 1024.0, 1280.0, 1920.0, 3840.0}) {
      for (const double height : {200.0, 400.0, 600.0, 700.0, 800.0, 1080.0, 2160.0}) {
        const WindowPlaces places = arrange_window(usual(width, height, scale));
        const auto rects = shown(places);
        double area = 0.0;
        for (std::size_t i = 0; i < rects.size(); ++i) {
          const kit::Rect& rect = rects[i].second;
          area += rect.width * rect.height;
          EXPECT_GE(rect.left, 0.0) << rects[i].first;
          EXPECT_GE(rect.top, 0.0) << rects[i].first;
          EXPECT_LE(rect.right(), width) << rects[i].first << " at " << width << " " << scale;
          EXPECT_LE(rect.bottom(), height) << rects[i].first << " at " << height << " " << scale;
          for (std::size_t k = 0; k < i; ++k) {
            EXPECT_FALSE(overlap(rect, rects[k].second))
                << rects[i].first << " and " << rects[k].first << " at " << width << " x " << height
                << " scale " << scale;
          }
        }
        EXPECT_NEAR(area, width * height, 1.0) << width << " x " << height << " scale " << scale;
      }
    }
  }
}

TEST(WindowArrangement, LiesOnWholePixels) {
  for (const auto& [name, rect] : shown(arrange_window(usual(1283.0, 797.0, 1.37)))) {
    for (const double length : {rect.left, rect.top, rect.width, rect.height}) {
      EXPECT_EQ(length, std::floor(length)) << name;
    }
  }
}

TEST(WindowArrangement, KeepsBothColumnsUsefulAtAScaleOfOneAndAHalf) {
  const WindowPlaces places = arrange_window(usual(1280.0, 800.0, 1.5));
  EXPECT_GE(places.left.width, 200.0 * 1.5);
  EXPECT_GE(places.right.width, 244.0 * 1.5);
  EXPECT_GE(places.map.width, 300.0 * 1.5);
  EXPECT_GE(places.map.height, 270.0 * 1.5);
}

TEST(WindowArrangement, MakesAStripOfTheColumnBehindWhereThereIsNoRoomForBoth) {
  WindowWishes wishes = usual(1280.0, 800.0, 2.0);
  const WindowPlaces right = arrange_window(wishes);
  EXPECT_EQ(right.left.width, 0.0);
  EXPECT_EQ(right.left_strip.width, kColumnStrip * 2.0);
  EXPECT_GE(right.right.width, 2.0 * 230.0);
  EXPECT_GE(right.map.width, 2.0 * 280.0);
  wishes.front = WindowSide::kLeft;
  const WindowPlaces left = arrange_window(wishes);
  EXPECT_EQ(left.right.width, 0.0);
  EXPECT_GT(left.right_strip.width, 0.0);
  EXPECT_GE(left.left.width, 2.0 * 200.0);
  EXPECT_EQ(left.right_strip.right(), 1280.0);
}

TEST(WindowArrangement, ShowsTheMapFirstInAVerySmallWindow) {
  const WindowPlaces places = arrange_window(usual(360.0, 300.0, 1.0));
  EXPECT_EQ(places.left.width + places.right.width, 0.0);
  EXPECT_GE(places.map.width, 160.0);
  EXPECT_GE(places.map.height, 120.0);
}

TEST(WindowArrangement, LeavesTheTransportWhereStripsOfTheTimelineHaveNoRoom) {
  const WindowPlaces low = arrange_window(usual(1280.0, 300.0, 1.0));
  EXPECT_GT(low.timeline.height, 50.0);
  EXPECT_LT(low.timeline.height, 100.0);
  EXPECT_GE(low.map.height, 120.0);
  EXPECT_EQ(arrange_window(usual(1280.0, 200.0, 1.0)).timeline.height, 0.0);
}

TEST(WindowArrangement, GivesWayStepByStep) {
  double left = 1e9, right = 1e9, timeline = 1e9;
  for (double width = 1600.0; width >= 800.0; width -= 8.0) {
    const WindowPlaces places = arrange_window(usual(width, 800.0, 1.0));
    if (places.left.width <= 0.0 || places.right.width <= 0.0) break;
    EXPECT_LE(places.left.width, left);
    EXPECT_LE(places.right.width, right);
    EXPECT_LE(left < 1e9 ? left - places.left.width : 0.0, 9.0) << "without a jump at " << width;
    left = places.left.width;
    right = places.right.width;
  }
  for (double height = 1200.0; height >= 420.0; height -= 8.0) {
    const WindowPlaces places = arrange_window(usual(1280.0, height, 1.0));
    EXPECT_LE(places.timeline.height, timeline);
    timeline = places.timeline.height;
  }
}

TEST(WindowArrangement, HasOnlyWhatIsWished) {
  WindowWishes wishes = usual(1280.0, 800.0, 1.0);
  wishes.has_frame = wishes.has_left = wishes.has_right = wishes.has_timeline = false;
  wishes.has_status = false;
  const WindowPlaces alone = arrange_window(wishes);
  EXPECT_EQ(alone.map, (kit::Rect{0.0, 0.0, 1280.0, 800.0}));
  EXPECT_EQ(shown(alone).size(), 1U);
  wishes.has_right = true;
  const WindowPlaces with_right = arrange_window(wishes);
  EXPECT_EQ(with_right.map.width, 900.0);
  EXPECT_EQ(with_right.right.left, 900.0);
}

TEST(WindowArrangement, LetsAColumnGrowAsFarAsTheMapStaysUseful) {
  for (const double width : {900.0, 1024.0, 1280.0, 1920.0}) {
    const WindowPlaces places = arrange_window(usual(width, 800.0, 1.0));
    EXPECT_GE(places.most_left_px, places.left.width);
    EXPECT_GE(places.most_right_px, places.right.width);
    WindowWishes wider = usual(width, 800.0, 1.0);
    wider.left_pt = places.most_left_px;
    wider.right_pt = places.right.width;
    EXPECT_NEAR(arrange_window(wider).left.width, places.most_left_px, 1.0)
        << "what the splitter allows is what comes of it, at " << width;
  }
}

TEST(WindowArrangement, LetsTheTimelineGrowAsFarAsTheMapStaysUseful) {
  for (const double height : {500.0, 600.0, 800.0, 1200.0}) {
    WindowWishes wishes = usual(1280.0, height, 1.0);
    wishes.timeline_pt = arrange_window(wishes).most_timeline_px;
    EXPECT_NEAR(arrange_window(wishes).timeline.height, wishes.timeline_pt, 1.0) << height;
  }
}

TEST(WindowArrangement, KeepsAColumnThatWasMadeNarrowerThanIsUseful) {
  WindowWishes wishes = usual(1280.0, 800.0, 1.0);
  wishes.left_pt = kLeastColumn;
  EXPECT_EQ(arrange_window(wishes).left.width, kLeastColumn);
}

}  // namespace window_arrangement_test
}  // namespace nadir
