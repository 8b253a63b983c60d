// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/moment_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace nadir {
namespace {

using kit::Icon;
using kit::TextLook;

/// In the order of MomentKind.
constexpr std::array<MomentKindLook, 6> kKindLooks = {{
    {"largest error", "The estimate was far from the truth", Icon::kChart, TextLook::kBad},
    {"high NEES",
     "The error was more than the filter's covariance makes likely: NEES of the step above 16.3, "
     "the "
     "99.9 % chi-square bound for 3 degrees of freedom",
     Icon::kWarning, TextLook::kBad},
    {"low agreement", "What was seen fits the map less than usual in this run", Icon::kLayers,
     TextLook::kWarning},
    {"lost", "The estimate was good and is no more", Icon::kError, TextLook::kBad},
    {"found", "The estimate is good again, or for the first time", Icon::kCheck, TextLook::kGood},
    {"missing data", "No step for a while, or nothing was seen", Icon::kClock, TextLook::kWarning},
}};

}  // namespace

const MomentKindLook& moment_kind_look(MomentKind kind) {
  return kKindLooks.at(static_cast<std::size_t>(kind));
}

MomentMark moment_mark(MomentKind kind) {
  switch (moment_kind_look(kind).look) {
    case TextLook::kGood:
      return MomentMark::kDisc;
    case TextLook::kWarning:
      return MomentMark::kHollowDiamond;
    default:
      return MomentMark::kFilledDiamond;
  }
}

Rgba moment_colour(MomentKind kind, const Theme& theme) {
  switch (moment_kind_look(kind).look) {
    case TextLook::kGood:
      return theme.good;
    case TextLook::kWarning:
      return theme.warning;
    default:
      return theme.bad;
  }
}

void draw_moment_mark(Canvas& canvas,
                      const Eigen::Vector2d& at,
                      double half_px,
                      MomentKind kind,
                      const Theme& theme) {
  const Rgba colour = moment_colour(kind, theme);
  const MomentMark mark = moment_mark(kind);
  if (mark == MomentMark::kDisc) {
    constexpr int kCorners = 12;
    std::array<Eigen::Vector2d, kCorners> disc;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kCorners;
      disc.at(static_cast<std::size_t>(i)) =
          at + 0.85 * half_px * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    canvas.fill(disc, colour);
    return;
  }
  const auto diamond = [&at](double half) {
    return std::array<Eigen::Vector2d, 4>{
        at - Eigen::Vector2d(half, 0.0), at - Eigen::Vector2d(0.0, half),
        at + Eigen::Vector2d(half, 0.0), at + Eigen::Vector2d(0.0, half)};
  };
  canvas.fill(diamond(half_px), colour);
  if (mark == MomentMark::kHollowDiamond) canvas.fill(diamond(0.5 * half_px), theme.window);
}

std::vector<std::string> mark_key_lines() {
  const auto names = [](MomentMark mark) {
    std::string all;
    for (std::size_t i = 0; i < kKindLooks.size(); ++i) {
      if (moment_mark(static_cast<MomentKind>(i)) != mark) continue;
      all += (all.empty() ? "" : ", ") + std::string(kKindLooks.at(i).name);
    }
    return all;
  };
  return {"Marks on the timeline",
          "full red diamond: " + names(MomentMark::kFilledDiamond),
          "hollow amber diamond: " + names(MomentMark::kHollowDiamond),
          "green disc: " + names(MomentMark::kDisc),
          "blue flag: your bookmark",
          "click one to go there"};
}

std::vector<std::size_t> by_severity(std::span<const WorstMoment> moments) {
  std::vector<std::size_t> order(moments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return moments[a].severity > moments[b].severity;
  });
  return order;
}

std::string severity_words(double severity) {
  return fmt::format("severity {:.{}f}: so many times the limit of its kind", severity,
                     severity < 9.95 ? 1 : 0);
}

}  // namespace nadir
