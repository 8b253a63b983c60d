// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/particle_view.h"

#include <limits>
#include <numbers>
#include <set>

#include "core/base/random.h"
#include "tests/widgets/views/map_page.h"
#include "widgets/views/theme.h"

namespace nadir {
namespace particle_view_test {

constexpr double kPi = std::numbers::pi;

ParticleSet set_of(const std::vector<Rigid2>& poses, const std::vector<double>& weights = {}) {
  ParticleSet particles;
  particles.resize(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    particles.set_pose(i, poses[i]);
    particles.weight[i] = weights.empty() ? 1.0 / static_cast<double>(poses.size()) : weights[i];
  }
  return particles;
}

/// Evenly spread over a square around (1000, 2000).
ParticleSet cloud(std::uint32_t count, double side_m) {
  std::vector<Rigid2> poses;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [u, v] = uniforms({.seed = 5, .particle = i});
    poses.push_back({1000.0 + side_m * (u - 0.5), 2000.0 + side_m * (v - 0.5), u});
  }
  return set_of(poses);
}

class Particles : public MapPage {
 protected:
  static constexpr int kSide = 200;

  Raster<Rgba> drawn(const MapSight& sight) { return draw(scene, sight); }
  static MapSight sight(double metres_per_px, double px_per_pt = 2.0) {
    return {{{1000.0, 2000.0}, metres_per_px}, kSide, kSide, px_per_pt};
  }
  /// Columns, rows and number of the pixels that are not clear.
  static std::vector<Eigen::Vector2i> inked(const Raster<Rgba>& page) {
    std::vector<Eigen::Vector2i> found;
    for (int row = 0; row < page.height(); ++row) {
      for (int column = 0; column < page.width(); ++column) {
        if (page.at(column, row).alpha > 0) found.emplace_back(column, row);
      }
    }
    return found;
  }

  MapScene scene{{990.0, 2010.0}};
};

TEST_F(Particles, LieWhereTheyAreNotMirrored) {
  ParticleView view(scene);
  ParticleLook look;
  look.size_pt = 2.0;
  look.heading_pt = 0.0;
  // 20 m east, and 30 m north.
  view.show(set_of({{1020.0, 2000.0, 0.0}, {1000.0, 2030.0, 0.0}}), look);
  const Raster<Rgba> page = drawn(sight(0.5));
  EXPECT_EQ(page.at(100 + 40, 100).alpha, 255);
  EXPECT_EQ(page.at(100, 100 - 60).alpha, 255);
  EXPECT_EQ(page.at(100 - 40, 100).alpha, 0);
  EXPECT_EQ(page.at(100, 100 + 60).alpha, 0);
  EXPECT_EQ(view.drawn_count(), 2U);
}

TEST_F(Particles, HaveDotsAsLargeInPointsOnPagesOfAnySize) {
  for (const double px_per_pt : {1.33, 2.8, 5.6}) {
    ParticleView view(scene);
    ParticleLook look;
    look.size_pt = 3.0;
    look.heading_pt = 0.0;
    view.show(set_of({{1000.0, 2000.0, 0.0}}), look);
    const double area = static_cast<double>(inked(drawn(sight(0.5, px_per_pt))).size());
    EXPECT_NEAR(std::sqrt(area), 3.0 * px_per_pt, 1.0) << px_per_pt;
  }
}

TEST_F(Particles, PointTicksAlongTheirHeadingsOfALengthOnPaper) {
  for (const double yaw_rad : {0.0, kPi / 2.0, kPi, -3.0 * kPi / 4.0}) {
    for (const double px_per_pt : {2.0, 5.0}) {
      ParticleView view(scene);
      ParticleLook look;
      look.heading_pt = 10.0;
      view.show(set_of({{1000.0, 2000.0, yaw_rad}}), look);
      const Raster<Rgba> page = drawn(sight(0.5, px_per_pt));
      EXPECT_TRUE(view.has_heading_ticks());
      double farthest = 0.0;
      Eigen::Vector2d tip(0.0, 0.0);
      for (const Eigen::Vector2i& pixel : inked(page)) {
        const Eigen::Vector2d offset(pixel.x() + 0.5 - 100.0, 100.0 - pixel.y() - 0.5);
        if (offset.norm() > farthest) tip = offset;
        farthest = std::max(farthest, offset.norm());
      }
      EXPECT_NEAR(farthest, 10.0 * px_per_pt, 2.0 + 0.5 * px_per_pt);
      EXPECT_NEAR(std::remainder(std::atan2(tip.y(), tip.x()) - yaw_rad, 2.0 * kPi), 0.0, 0.15);
    }
  }
}

TEST_F(Particles, HaveTicksOnlyWhereTheyLieApartOnThePage) {
  ParticleView view(scene);
  view.show(cloud(1500, 100.0));
  const auto has_ticks_at = [&](double metres_per_px, double px_per_pt = 2.0) {
    scene.look(sight(metres_per_px, px_per_pt));
    return view.has_heading_ticks();
  };
  EXPECT_FALSE(
      has_ticks_at(0.5));  // 1,500 in 200 pixels: five in a square of twelve, as a tick is long
  EXPECT_TRUE(has_ticks_at(0.1));   // five times nearer: one in five such squares
  EXPECT_FALSE(has_ticks_at(0.5));  // and back
  // The same ground on a page twice as large looks alike.
  scene.look({{{1000.0, 2000.0}, 0.05}, 2.0 * kSide, 2.0 * kSide, 4.0});
  EXPECT_TRUE(view.has_heading_ticks());
  // Copies, as resampling makes them, take no room of their own.
  std::vector<Rigid2> copies(900, Rigid2{1000.0, 2000.0, 0.5});
  copies.resize(1000, Rigid2{1030.0, 2000.0, 0.5});
  view.show(set_of(copies));
  EXPECT_TRUE(has_ticks_at(0.5));
  ParticleLook without;
  without.heading_pt = 0.0;
  view.show(cloud(1500, 100.0), without);
  EXPECT_FALSE(has_ticks_at(0.1));
}

TEST_F(Particles, AreCountedOnlyWhereTheyAreInSight) {
  ParticleView view(scene);
  view.show(cloud(4000, 200.0));
  scene.look(sight(2.0));
  EXPECT_EQ(view.drawn_count(), 4000U);
  scene.look(sight(0.5));  // 100 m of 200 each way, and a little beside
  EXPECT_NEAR(static_cast<double>(view.drawn_count()), 4000.0 * 1.14 * 1.14 / 4.0, 150.0);
  MapSight elsewhere = sight(0.5);
  elsewhere.camera.centre_in_enu_m.x() += 1e6;
  scene.look(elsewhere);
  EXPECT_EQ(view.drawn_count(), 0U);
  EXPECT_FALSE(view.has_heading_ticks());
}

TEST_F(Particles, AreInSightAlsoOnATurnedPage) {
  ParticleView view(scene);
  // On the diagonal, outside of a page that lies straight but inside of one that is turned by 45 degrees.
  view.show(set_of({{1000.0 + 65.0, 2000.0, 0.0}}));
  scene.look({{{1000.0, 2000.0}, 1.0}, 100.0, 100.0, 1.0});
  EXPECT_EQ(view.drawn_count(), 0U);
  scene.look({{{1000.0, 2000.0}, 1.0, kPi / 4.0}, 100.0, 100.0, 1.0});
  EXPECT_EQ(view.drawn_count(), 1U);
}

TEST_F(Particles, OfAMillionAreDrawnTwentyThousandWithTheHeaviest) {
  ParticleView view(scene);
  ParticleSet million = cloud(1'000'000, 100.0);
  million.weight[777'777] = 0.5;
  million.set_pose(777'777, {1010.0, 2010.0, 0.0});
  view.show(million);
  const Raster<Rgba> page = drawn(sight(0.5));
  EXPECT_LE(view.drawn_count(), 20'000U);
  EXPECT_GE(view.drawn_count(), 10'000U);
  // It lies on top.
  const Rgba seen = page.at(100 + 20, 100 - 20);
  const Rgba heavy = value_colour(ValueColours::kViridis, 1.0);
  EXPECT_LT(std::abs(seen.red - heavy.red), 130);
  EXPECT_GT(seen.green, 80);
  // Nearer, those in sight are chosen from all.
  scene.look(sight(0.05));
  EXPECT_GE(view.drawn_count(), 7'000U);
}

TEST_F(Particles, ThatAreChosenStayTheSameWhileTheMapIsMoved) {
  ParticleSet particles = cloud(50'000, 80.0);
  ParticleLook look;
  look.most_drawn = 500;
  look.heading_pt = 0.0;
  look.size_pt = 0.5;
  ParticleView view(scene);
  view.show(particles, look);
  const Raster<Rgba> before = drawn(sight(0.5));
  MapSight moved = sight(0.5);
  moved.camera.centre_in_enu_m.x() += 5.0;  // ten pixels
  const Raster<Rgba> after = drawn(moved);
  int wrong = 0;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 10; column < kSide; ++column) {
      wrong += (before.at(column, row).alpha > 0) != (after.at(column - 10, row).alpha > 0) ? 1 : 0;
    }
  }
  EXPECT_LE(wrong, 4);
}

TEST_F(Particles, ShowTheirWeightByColour) {
  ParticleView view(scene);
  ParticleLook look;
  look.size_pt = 3.0;
  look.heading_pt = 0.0;
  view.show(
      set_of({{980.0, 2000.0, 0.0}, {1000.0, 2000.0, 0.0}, {1020.0, 2000.0, 0.0}}, {0.1, 0.3, 0.6}),
      look);
  const Raster<Rgba> page = drawn(sight(0.5));
  for (const auto& [column, share] :
       std::vector<std::pair<int, double>>{{60, 1.0 / 6.0}, {100, 0.5}, {140, 1.0}}) {
    EXPECT_LE(difference(page.at(column, 100), value_colour(ValueColours::kViridis, share)), 2);
  }
}

TEST_F(Particles, OfOneWeightHaveTheColourThatLegendsShow) {
  ParticleView view(scene);
  ParticleLook look;
  look.size_pt = 3.0;
  look.heading_pt = 0.0;
  const Rgba expected = value_colour(ValueColours::kViridis, ParticleLook::kEqualShare);
  for (const double weight : {0.5, 0.0}) {
    view.show(set_of({{980.0, 2000.0, 0.0}, {1020.0, 2000.0, 0.0}}, {weight, weight}), look);
    const Raster<Rgba> page = drawn(sight(0.5));
    EXPECT_LE(difference(page.at(60, 100), expected), 2) << weight;
    EXPECT_LE(difference(page.at(140, 100), expected), 2) << weight;
  }
}

TEST_F(Particles, WithoutAWeightAreLeftOut) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const auto weight : {ParticleLook::Weight::kColour, ParticleLook::Weight::kSize}) {
    ParticleView view(scene);
    ParticleLook look;
    look.weight = weight;
    look.size_pt = 3.0;
    look.heading_pt = 0.0;
    view.show(set_of({{960.0, 2000.0, 0.0},
                      {980.0, 2000.0, 0.0},
                      {1000.0, 2000.0, 0.0},
                      {1020.0, 2000.0, 0.0}},
                     {0.5, kNaN, kInfinity, 1.0}),
              look);
    const Raster<Rgba> page = drawn(sight(0.5));
    EXPECT_EQ(view.drawn_count(), 2U);
    EXPECT_EQ(page.at(60, 100).alpha, 0);
    EXPECT_EQ(page.at(100, 100).alpha, 0);
    EXPECT_GT(page.at(20, 100).alpha, 0);
    if (weight == ParticleLook::Weight::kSize) continue;
    EXPECT_LE(difference(page.at(20, 100), value_colour(ValueColours::kViridis, 0.5)), 2);
    EXPECT_LE(difference(page.at(140, 100), value_colour(ValueColours::kViridis, 1.0)), 2);
  }
}

TEST_F(Particles, ShowTheirWeightByAreaWhereAsked) {
  ParticleView view(scene);
  ParticleLook look;
  look.weight = ParticleLook::Weight::kSize;
  look.size_pt = 4.0;
  look.heading_pt = 0.0;
  look.colour = {200, 30, 40};
  view.show(set_of({{960.0, 2000.0, 0.0}, {1000.0, 2000.0, 0.0}, {1040.0, 2000.0, 0.0}},
                   {0.01, 0.25, 1.0}),
            look);
  const Raster<Rgba> page = drawn(sight(0.5));
  std::array<double, 3> area{};
  for (const Eigen::Vector2i& pixel : inked(page)) {
    ++area.at(static_cast<std::size_t>(pixel.x() / 67));
    EXPECT_LE(difference(page.at(pixel.x(), pixel.y()), look.colour), 1);
  }
  EXPECT_LT(area[0], area[1]);
  EXPECT_LT(area[1], area[2]);
  EXPECT_NEAR(area[2], std::pow(2.5 * 4.0 * 2.0, 2.0), 25.0);
  EXPECT_NEAR(area[1] / area[2], 0.36, 0.1);  // the third of five sizes
}

TEST_F(Particles, LetTheGroundThroughWhereTheyAreDense) {
  ParticleView view(scene);
  ParticleLook look;
  look.heading_pt = 0.0;
  const auto most_opaque = [&](const ParticleSet& particles) {
    view.show(particles, look);
    int most = 0;
    const Raster<Rgba> page = drawn(sight(0.5));
    for (const Rgba pixel : page.values()) most = std::max<int>(most, pixel.alpha);
    return most;
  };
  EXPECT_EQ(most_opaque(cloud(10, 90.0)), 255);
  EXPECT_LT(most_opaque(cloud(3000, 90.0)), 255);
}

TEST_F(Particles, ThatAreNotFiniteAreLeftOut) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ParticleView view(scene);
  view.show(set_of({{kNaN, 2000.0, 0.0},
                    {1000.0, kInfinity, 0.0},
                    {1000.0, 2000.0, kNaN},
                    {1e300, -1e300, 0.0},
                    {1000.0, 2000.0, 0.0}}));
  scene.look(sight(0.5));
  EXPECT_EQ(view.drawn_count(), 1U);
  view.show({});
  EXPECT_EQ(view.drawn_count(), 0U);
}

TEST_F(Particles, AreHiddenAndGoneWithTheirView) {
  const Raster<Rgba> empty(kSide, kSide, kNothing);
  {
    ParticleView view(scene);
    view.show(cloud(10, 50.0));
    EXPECT_NE(drawn(sight(0.5)), empty);
    view.set_visible(false);
    EXPECT_EQ(drawn(sight(0.5)), empty);
    view.set_visible(true);
    EXPECT_NE(drawn(sight(0.5)), empty);
  }
  EXPECT_EQ(drawn(sight(0.7)), empty);
}

TEST_F(Particles, LookTheSameOnASmallAndALargePage) {
  ParticleView view(scene);
  view.show(cloud(150, 100.0));
  const auto share_inked = [&](const MapSight& seen) {
    const Raster<Rgba> page = drawn(seen);
    return static_cast<double>(inked(page).size()) / static_cast<double>(page.size());
  };
  const double small_share = share_inked(sight(0.5, 2.0));
  const double large_share = share_inked({{{1000.0, 2000.0}, 0.25}, 2.0 * kSide, 2.0 * kSide, 4.0});
  EXPECT_NEAR(large_share / small_share, 1.0, 0.15);
}

TEST_F(Particles, HaveACasingAroundThemOnlyWhereOneIsAskedFor) {
  ParticleView view(scene);
  ParticleLook look;
  look.size_pt = 3.0;
  look.heading_pt = 10.0;
  look.tick_width_pt = 1.0;
  const ParticleSet one = set_of({{1000.0, 2000.0, 0.0}});
  view.show(one, look);
  const std::size_t plain = inked(drawn(sight(0.5))).size();
  look.casing = {0, 0, 0, 255};
  look.casing_pt = 1.0;
  view.set_look(look);
  const Raster<Rgba> cased = drawn(sight(0.5));
  EXPECT_GT(inked(cased).size(), plain);
  // The dot of 6 px keeps its colour; 2 px around it are the casing's.
  EXPECT_EQ(cased.at(100, 100), value_colour(ValueColours::kViridis, kEqualWeightShare));
  EXPECT_LT(int{cased.at(96, 100).green}, 10);
  EXPECT_EQ(cased.at(96, 100).alpha, 255);
  EXPECT_EQ(cased.at(93, 100).alpha, 0);
  EXPECT_EQ(cased.at(118, 100), value_colour(ValueColours::kViridis, kEqualWeightShare))
      << "the tick is cased too, and lies on it";
  EXPECT_GT(int{cased.at(115, 98).alpha}, 100);
  look.casing.alpha = 0;
  view.set_look(look);
  EXPECT_EQ(inked(drawn(sight(0.5))).size(), plain);
}

TEST_F(Particles, HaveALightCasingWhereTheyAreDark) {
  ParticleView view(scene);
  ParticleLook look;
  look.size_pt = 3.0;
  look.heading_pt = 0.0;
  look.casing = {0, 0, 0, 255};
  look.casing_of_dark = {255, 255, 255, 255};
  look.casing_pt = 1.0;
  view.show(set_of({{990.0, 2000.0, 0.0}, {1010.0, 2000.0, 0.0}}, {0.1, 0.9}), look);
  const Raster<Rgba> page = drawn(sight(0.5));
  EXPECT_GT(int{page.at(80, 96).green}, 245) << "the light one lies left";
  EXPECT_LT(int{page.at(120, 96).green}, 10);
}

TEST_F(Particles, CanBeMadeFaintAllTogether) {
  ParticleView view(scene);
  ParticleLook look;
  look.size_pt = 4.0;
  look.casing = {0, 0, 0, 255};
  view.show(set_of({{1000.0, 2000.0, 0.0}}), look);
  EXPECT_EQ(drawn(sight(0.5)).at(100, 100).alpha, 255);
  look.opacity = 0.0;
  view.set_look(look);
  EXPECT_TRUE(inked(drawn(sight(0.5))).empty());
}

}  // namespace particle_view_test
}  // namespace nadir
