// SPDX-License-Identifier: Apache-2.0
#include "core/edit/box_tree.h"

#include <gmock/gmock.h>

#include "core/base/random.h"
#include "core/edit/near_places.h"

namespace nadir {
namespace box_tree_test {

using testing::IsEmpty;

PlaneBounds random_box(std::uint32_t number, double most_m) {
  const auto [x, y] = uniforms({31, 0, number, 0, 0});
  const auto [width, height] = uniforms({31, 0, number, 1, 0});
  PlaneBounds box;
  // On whole metres, so that edges of boxes meet too.
  box.include(Eigen::Vector2d(std::floor(50.0 * x), std::floor(50.0 * y)));
  box.include(box.low + Eigen::Vector2d(std::floor(most_m * width), std::floor(most_m * height)));
  return box;
}

TEST(BoxTree, FindsWhatALookAtAllFinds) {
  for (const std::uint32_t count : {0U, 1U, 7U, 8U, 9U, 40U, 129U, 1000U}) {
    std::vector<PlaneBounds> boxes;
    for (std::uint32_t i = 0; i < count; ++i) boxes.push_back(random_box(i, i % 10 == 0 ? 40 : 3));
    if (count > 8) boxes[3] = PlaneBounds();
    const BoxTree tree(boxes);
    for (std::uint32_t i = 0; i < 200; ++i) {
      const PlaneBounds asked = random_box(5000 + i, 8);
      std::vector<std::size_t> expected;
      for (std::size_t j = 0; j < boxes.size(); ++j) {
        const bool meets = !boxes[j].is_empty &&
                           (boxes[j].low.array() <= asked.high.array()).all() &&
                           (asked.low.array() <= boxes[j].high.array()).all();
        if (meets) expected.push_back(j);
      }
      std::vector<std::size_t> found;
      tree.visit(asked, [&](std::size_t number) { found.push_back(number); });
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected) << count << " boxes, question " << i;
    }
    std::vector<std::size_t> found;
    tree.visit({}, [&](std::size_t number) { found.push_back(number); });
    EXPECT_THAT(found, IsEmpty());
  }
}

TEST(NearPlaces, OfEquallyNearOnesTakesTheFirstByItsPlace) {
  const double step = kLatticeM;
  const NearPlaces places({{step, 0.0}, {-step, 0.0}, {5.0, 5.0}, {5.0, 5.0 + step}});
  EXPECT_EQ(places.nearest({0.0, 0.0}), Eigen::Vector2d(-step, 0.0));
  EXPECT_EQ(places.nearest({0.5 * step, 0.0}), Eigen::Vector2d(step, 0.0));
  EXPECT_EQ(places.first_near({0.5 * step, 0.0}), Eigen::Vector2d(-step, 0.0));
  EXPECT_EQ(places.first_near({5.0, 5.0 + step}), Eigen::Vector2d(5.0, 5.0));
  EXPECT_FALSE(places.nearest({0.0, 4.0 * step}));
  EXPECT_FALSE(NearPlaces({}).nearest({0.0, 0.0}));
}

}  // namespace box_tree_test
}  // namespace nadir
