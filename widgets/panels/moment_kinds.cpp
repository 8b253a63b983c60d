// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/moment_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/session/moment_explanation.h"

namespace nadir {
namespace {

using kit::Icon;
using kit::TextLook;

/// In the order of MomentKind.
constexpr std::array<MomentKindLook, 6> kKindLooks = {{
    {"largest error", "Errors are larger than usual in this run, and here the largest",
     Icon::kChart, TextLook::kBad},
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

TextLook moment_look(const WorstMoment& moment) {
  const TextLook of_kind = moment_kind_look(moment.kind).look;
  return of_kind == TextLook::kBad && moment.is_near_truth ? TextLook::kWarning : of_kind;
}

MomentMark moment_mark(const WorstMoment& moment) {
  switch (moment_look(moment)) {
    case TextLook::kGood:
      return MomentMark::kDisc;
    case TextLook::kWarning:
      return MomentMark::kHollowDiamond;
    default:
      return MomentMark::kFilledDiamond;
  }
}

Rgba mark_colour(MomentMark mark, const Theme& theme) {
  switch (mark) {
    case MomentMark::kDisc:
      return theme.good;
    case MomentMark::kHollowDiamond:
      return theme.warning;
    case MomentMark::kFilledDiamond:
      break;
  }
  return theme.bad;
}

void draw_moment_mark(Canvas& canvas,
                      const Eigen::Vector2d& at,
                      double half_px,
                      MomentMark mark,
                      const Theme& theme) {
  const Rgba colour = mark_colour(mark, theme);
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

std::string moment_words(const WorstMoment& moment) {
  if (moment.kind == MomentKind::kLargestError) {
    return "largest error of this stretch: " + moment.words;
  }
  const std::string_view name = moment_kind_look(moment.kind).name;
  // "lost: 5.3 m off" says it itself.
  if (moment.words.starts_with(name)) return moment.words;
  return fmt::format("{}: {}", name, moment.words);
}

std::vector<std::string> mark_key_lines() {
  const auto names = [](TextLook look) {
    std::string all;
    for (const MomentKindLook& kind : kKindLooks) {
      if (kind.look == look) all += (all.empty() ? "" : ", ") + std::string(kind.name);
    }
    return all;
  };
  const ExplanationRules near;
  return {"Marks on the timeline",
          "full red diamond, wrong: " + names(TextLook::kBad),
          "hollow amber diamond, doubtful: " + names(TextLook::kWarning),
          fmt::format("    or one of the above within {:g} m and {:g}° of the truth", near.near_m,
                      near.near_deg),
          "green disc: " + names(TextLook::kGood),
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

std::string severity_words(const WorstMoment& moment) {
  const double severity = moment.severity;
  if (moment.kind == MomentKind::kFound) return "";
  if (severity < 0.95) return "the largest of this run, and small";
  if (severity < 1.05) return "just worth a look";
  return fmt::format("{:.{}f} times what is worth a look", severity, severity < 9.95 ? 1 : 0);
}

}  // namespace nadir
