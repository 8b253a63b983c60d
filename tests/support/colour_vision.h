// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "widgets/canvas/canvas.h"

namespace nadir {

/// Shares of light, red, green, blue (IEC 61966-2-1).
[[nodiscard]] inline Eigen::Vector3d light_of(Rgba colour) {
  const auto linear = [](std::uint8_t channel) {
    const double value = channel / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return {linear(colour.red), linear(colour.green), linear(colour.blue)};
}

/// CIE XYZ under the white D65, of which Y is 1.
[[nodiscard]] inline Eigen::Vector3d xyz_of(const Eigen::Vector3d& light) {
  Eigen::Matrix3d from_srgb;
  from_srgb << 0.4124564, 0.3575761, 0.1804375,  //
      0.2126729, 0.7151522, 0.0721750,           //
      0.0193339, 0.1191920, 0.9503041;
  return from_srgb * light;
}

/// CIE L*, a*, b* under D65.
[[nodiscard]] inline Eigen::Vector3d lab_of(const Eigen::Vector3d& light) {
  const Eigen::Vector3d white = xyz_of({1.0, 1.0, 1.0});
  const auto f = [](double t) {
    constexpr double kDelta = 6.0 / 29.0;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
  };
  const Eigen::Array3d ratio = xyz_of(light).array() / white.array();
  return {116.0 * f(ratio[1]) - 16.0, 500.0 * (f(ratio[0]) - f(ratio[1])),
          200.0 * (f(ratio[1]) - f(ratio[2]))};
}

/// Contrast of two colours, 1 to 21 (WCAG 2.1, relative luminance).
[[nodiscard]] inline double contrast(Rgba a, Rgba b) {
  const double y_a = xyz_of(light_of(a)).y() + 0.05;
  const double y_b = xyz_of(light_of(b)).y() + 0.05;
  return std::max(y_a, y_b) / std::min(y_a, y_b);
}

enum class ColourVision { kUsual, kProtanopia, kDeuteranopia, kTritanopia };

/// Light as somebody sees it who lacks one kind of cones (Machado, Oliveira and Fernandes 2009, severity 1).
[[nodiscard]] inline Eigen::Vector3d seen_by(ColourVision vision, const Eigen::Vector3d& light) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  switch (vision) {
    case ColourVision::kProtanopia:
      matrix << 0.152286, 1.052583, -0.204868,  //
          0.114503, 0.786281, 0.099216,         //
          -0.003882, -0.048116, 1.051998;
      break;
    case ColourVision::kDeuteranopia:
      matrix << 0.367322, 0.860646, -0.227968,  //
          0.280085, 0.672501, 0.047413,         //
          -0.011820, 0.042940, 0.968881;
      break;
    case ColourVision::kTritanopia:
      matrix << 1.255528, -0.076749, -0.178779,  //
          -0.078411, 0.930809, 0.147602,         //
          0.004733, 0.691367, 0.303900;
      break;
    case ColourVision::kUsual:
      break;
  }
  return (matrix * light).cwiseMax(0.0).cwiseMin(1.0);
}

/// How different two colours look, CIEDE2000 (Sharma, Wu and Dalal 2005); about 1 is just noticeable side by side.
[[nodiscard]] inline double colour_distance(const Eigen::Vector3d& lab_a,
                                            const Eigen::Vector3d& lab_b) {
  constexpr double kPi = std::numbers::pi;
  const auto power7 = [](double value) { return std::pow(value, 7.0); };
  const double mean_chroma =
      (std::hypot(lab_a[1], lab_a[2]) + std::hypot(lab_b[1], lab_b[2])) / 2.0;
  const double g =
      0.5 * (1.0 - std::sqrt(power7(mean_chroma) / (power7(mean_chroma) + power7(25.0))));
  struct Polar {
    double chroma, hue;
  };
  const auto polar = [&](const Eigen::Vector3d& lab) {
    const double a = (1.0 + g) * lab[1];
    const double hue = a == 0.0 && lab[2] == 0.0 ? 0.0 : std::atan2(lab[2], a);
    return Polar{std::hypot(a, lab[2]), hue < 0.0 ? hue + 2.0 * kPi : hue};
  };
  const auto [chroma_a, hue_a] = polar(lab_a);
  const auto [chroma_b, hue_b] = polar(lab_b);
  const bool is_grey = chroma_a * chroma_b == 0.0;
  double hue_step = is_grey ? 0.0 : hue_b - hue_a;
  if (hue_step > kPi) hue_step -= 2.0 * kPi;
  if (hue_step < -kPi) hue_step += 2.0 * kPi;
  double hue = hue_a + hue_b;
  if (!is_grey) {
    if (std::abs(hue_a - hue_b) > kPi) hue += hue < 2.0 * kPi ? 2.0 * kPi : -2.0 * kPi;
    hue /= 2.0;
  }
  const double lightness = (lab_a[0] + lab_b[0]) / 2.0;
  const double chroma = (chroma_a + chroma_b) / 2.0;
  const auto cosine = [](double radians, double degrees) {
    return std::cos(radians + degrees * kPi / 180.0);
  };
  const double t = 1.0 - 0.17 * cosine(hue, -30.0) + 0.24 * cosine(2.0 * hue, 0.0) +
                   0.32 * cosine(3.0 * hue, 6.0) - 0.20 * cosine(4.0 * hue, -63.0);
  const double blueness = (hue * 180.0 / kPi - 275.0) / 25.0;
  const double turn = 60.0 * std::exp(-blueness * blueness) * kPi / 180.0;
  const double rotation =
      -2.0 * std::sqrt(power7(chroma) / (power7(chroma) + power7(25.0))) * std::sin(turn);
  const double off_middle = (lightness - 50.0) * (lightness - 50.0);
  const double l =
      (lab_b[0] - lab_a[0]) / (1.0 + 0.015 * off_middle / std::sqrt(20.0 + off_middle));
  const double c = (chroma_b - chroma_a) / (1.0 + 0.045 * chroma);
  const double h =
      2.0 * std::sqrt(chroma_a * chroma_b) * std::sin(hue_step / 2.0) / (1.0 + 0.015 * chroma * t);
  return std::sqrt(l * l + c * c + h * h + rotation * c * h);
}

/// The same of two colours of the screen as somebody sees them.
[[nodiscard]] inline double colour_distance(ColourVision vision, Rgba a, Rgba b) {
  return colour_distance(lab_of(seen_by(vision, light_of(a))),
                         lab_of(seen_by(vision, light_of(b))));
}

}  // namespace nadir
