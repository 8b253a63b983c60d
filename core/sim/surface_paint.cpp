// SPDX-License-Identifier: Apache-2.0
#include "core/sim/surface_paint.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "core/base/random.h"

namespace nadir {
namespace {

/// One of some paints, told by a length that differs from thing to thing.
template <std::size_t kCount>
Paint one_of(const std::array<Colour, kCount>& paints, double length) {
  const auto words = random_words({.seed = std::bit_cast<std::uint64_t>(length)});
  return paint_of(paints[words[0] % kCount]);
}

constexpr std::array<Colour, 6> kWalls{{{203, 190, 168},
                                        {176, 122, 98},
                                        {222, 218, 208},
                                        {188, 178, 166},
                                        {208, 184, 140},
                                        {150, 152, 154}}};
constexpr std::array<Colour, 6> kCars{{{232, 233, 234},
                                       {168, 172, 178},
                                       {52, 54, 58},
                                       {112, 118, 126},
                                       {158, 34, 32},
                                       {38, 70, 130}}};
constexpr std::array<Colour, 5> kShirts{
    {{190, 60, 50}, {60, 90, 150}, {222, 200, 90}, {90, 140, 95}, {225, 225, 220}}};
constexpr Colour kTrouser{60, 62, 78}, kSkin{214, 172, 144}, kGlass{46, 54, 62}, kTrunk{96, 78, 60},
    kLeaves{86, 112, 52}, kMetal{132, 136, 138}, kFencePaint{148, 124, 98}, kLamp{238, 232, 206};

}  // namespace

float light(const Eigen::Vector3d& normal_in_enu) {
  const Eigen::Vector3d to_sun(0.425, -0.483, 0.766);
  constexpr double kSky = 0.54;
  constexpr double kSun = 0.6;
  return static_cast<float>(kSky + kSun * std::max(0.0, normal_in_enu.dot(to_sun)));
}

Paint paint_of_class(ClassId label, double height_m) {
  switch (label) {
    case kBuilding:
      return one_of(kWalls, height_m);
    case kFence:
      return paint_of(kFencePaint);
    case kRailing:
    case kPole:
    case kTrafficLight:
    case kTrafficSign:
      return paint_of(kMetal);
    case kStreetLight:
      return paint_of(kLamp);
    case kVegetation:
      return paint_of(kLeaves);
    default:
      return paint_of(class_info(label).colour);
  }
}

Paint paint_of_solid(const Solid& solid, const Eigen::Vector3d& point_in_enu_m) {
  const Eigen::Vector3d& half = solid.half_size_m;
  const double up_m = point_in_enu_m.z() - solid.centre_in_enu_m.z() + half.z();
  const double top_m = 2.0 * half.z();
  switch (solid.label) {
    case kCar: {
      const bool is_cabin = half.x() < 1.6;  // The body is longer; its lowest part is in shadow.
      return is_cabin || up_m < 0.12 ? paint_of(kGlass) : one_of(kCars, half.x());
    }
    case kPedestrian:
      if (up_m > top_m - 0.28) return paint_of(kSkin);
      return up_m > 0.48 * top_m ? one_of(kShirts, half.z()) : paint_of(kTrouser);
    case kVegetation:
      return paint_of(solid.shape == Solid::Shape::kEllipsoid ? kLeaves : kTrunk);
    default:
      return paint_of_class(solid.label, half.z());
  }
}

}  // namespace nadir
