// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/work_card.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

constexpr double kWorkCardWidth = 420.0, kWorkCardHeight = 144.0, kWorkCardPadding = 16.0;
constexpr double kPercentWidth = 56.0;  ///< Of a bar, right of its words.

/// "making the demo" as a heading has it.
[[nodiscard]] std::string heading_of_work(const JobStatus& job) {
  std::string words = shortened(job.title, 44);
  if (!words.empty()) {
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  }
  return words;
}

/// "rendering frames · 12 s left".
[[nodiscard]] std::string words_of_work(const JobStatus& job) {
  std::string words = job.activity.empty() ? "beginning" : shortened(job.activity, 40);
  if (job.left_s) words += " · " + left_text(*job.left_s);
  return words;
}

}  // namespace

Actions draw_work(kit::Ui& ui, const JobStatus& job) {
  const auto scope = ui.scope("Work");
  ui.heading(heading_of_work(job));
  const std::string words = words_of_work(job);
  const bool fits = ui.text_width(words) + ui.px(kPercentWidth) <= ui.room().width;
  (void)ui.progress("##Progress", job.fraction, fits ? words : std::string(), false);
  if (!fits) ui.wrapped(words, kit::TextLook::kMuted);
  ui.space();
  if (ui.button("Cancel", kit::ButtonLook::kNormal, {.text = "Stop " + job.title})) {
    return {actions::CancelJob{job.number}};
  }
  return {};
}

Actions draw_work_card(kit::Ui& ui, const JobStatus& job, const kit::Rect& inside) {
  const double width =
      std::min(ui.px(kWorkCardWidth), inside.width - ui.px(2.0 * kWorkCardPadding));
  const double height = ui.px(kWorkCardHeight);
  if (width < ui.px(kWorkCardWidth) / 2.0 || height > inside.height) return {};
  const kit::Rect place{std::floor(inside.left + (inside.width - width) / 2.0),
                        std::floor(inside.top + (inside.height - height) / 2.0), width, height};
  const auto region = ui.region("Card", place,
                                {.surface = kit::Surface::kPlate,
                                 .padding = ui.px(kWorkCardPadding),
                                 .has_border = true,
                                 .is_above = true});
  return draw_work(ui, job);
}

}  // namespace nadir
