// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/topview_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "widgets/panels/empty_state.h"
#include "widgets/views/map_colours.h"

namespace nadir {
namespace {

const Picture& picture_shown(const SeenMoment& moment, TopviewPanelState::Shown shown) {
  switch (shown) {
    case TopviewPanelState::Shown::kAgreement:
      return moment.agreement_picture;
    case TopviewPanelState::Shown::kMapAtEstimate:
      return moment.estimate_picture;
    case TopviewPanelState::Shown::kMapAtTruth:
      return moment.truth_picture;
    case TopviewPanelState::Shown::kSeen:
      break;
  }
  return moment.seen_picture;
}

/// An arrow at the body, which looks up the page.
void draw_body(kit::Ui& ui, const SeenMoment& moment, const PageRect& where, Rgba colour) {
  const Raster<ClassId>& labels = moment.topview.labels;
  if (labels.empty()) return;
  const Eigen::Vector2d at(where.left + where.width * moment.topview.body_column / labels.width(),
                           where.top() - where.height * moment.topview.body_row / labels.height());
  const double size = ui.px(9.0);
  const std::array<Eigen::Vector2d, 5> arrow = {
      at + Eigen::Vector2d(0.0, size), at + Eigen::Vector2d(-0.6 * size, -0.7 * size),
      at + Eigen::Vector2d(0.0, -0.3 * size), at + Eigen::Vector2d(0.6 * size, -0.7 * size),
      at + Eigen::Vector2d(0.0, size)};
  ui.canvas().fill(std::span(arrow).first(4), colour);
  ui.canvas().stroke(arrow,
                     {with_opacity(casing_over_imagery(ui.theme(), colour), 0.8), ui.px(1.0)});
}

}  // namespace

Actions draw_topview_panel(kit::Ui& ui, const MomentModel& model, TopviewPanelState& state) {
  const auto scope = ui.scope("Topview");
  if (model.is_reading) return draw_empty_state(ui, reading_state(model.run_name));
  if (!model.has_step()) return draw_empty_state(ui, no_run_state("what was seen from above"));
  const SeenMoment& moment = state.seen.of(model.step, model.map, ui.theme_name());
  if (!moment.seen_picture) {
    ui.wrapped(moment.why_not.empty() ? "decoding…" : moment.why_not, kit::TextLook::kMuted);
    return {};
  }
  std::vector<std::string> titles = {"Seen"};
  if (moment.agreement_picture) titles.insert(titles.end(), {"Fit", "At estimate"});
  if (moment.truth_picture) titles.emplace_back("At truth");
  auto chosen = static_cast<std::size_t>(state.shown);
  if (chosen >= titles.size()) chosen = 0;
  if (titles.size() > 1) {
    const auto choice = ui.choice(
        "##Show", titles, chosen,
        {"What was seen, which of it fits the map, or what the map has in its place", ""});
    if (choice) {
      state.shown = static_cast<TopviewPanelState::Shown>(*choice);
      chosen = *choice;
    }
  }
  if (!moment.why_not.empty()) ui.wrapped(moment.why_not, kit::TextLook::kMuted);
  const Picture& picture = picture_shown(moment, static_cast<TopviewPanelState::Shown>(chosen));
  const kit::Rect room = ui.room();
  const auto input = draw_picture(ui, "Topview picture", picture, state.texture_of, state.zoom,
                                  {room.width, std::max(ui.px(80.0), room.height)});
  draw_body(ui, moment, input.where, run_colour_on_imagery(ui.theme(), model.colour));
  if (input.pixel) {
    const auto words = seen_cell_words(seen_cell(moment, *input.pixel));
    ui.mouse_tooltip(words);
  }
  return {};
}

}  // namespace nadir
