// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/moment_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/time_axis.h"

namespace nadir {
namespace {

void draw_facts(kit::Ui& ui, const MomentModel& model) {
  const auto scope = ui.scope("Facts");
  for (const MomentFact& fact : moment_facts(*model.document, *model.index)) {
    ui.read_out(fact.label, fact.digits, fact.unit, fact.hint, fact.look);
  }
}

/// A picture with its caption above it; the cell under the mouse is said in a tooltip.
void draw_patch(kit::Ui& ui,
                const std::string& caption,
                const Picture& picture,
                const SeenMoment& moment,
                const TextureOf& texture_of,
                double width) {
  ui.text(caption, kit::TextLook::kMuted);
  draw_seen_picture(ui, caption + " picture", picture, moment, texture_of, {width, 0.0});
}

void draw_patches(kit::Ui& ui, const SeenMoment& moment, const TextureOf& texture_of) {
  if (!moment.seen_picture) {
    ui.text(moment.why_not.empty() ? "decoding…" : moment.why_not, kit::TextLook::kMuted);
    return;
  }
  if (!moment.why_not.empty()) ui.wrapped(moment.why_not, kit::TextLook::kMuted);
  const double width = std::floor((ui.room().width - ui.px(8.0)) / 2.0);
  struct Patch {
    const char* caption;
    const Picture* picture;
  };
  const std::array<Patch, 4> patches = {{{"seen", &moment.seen_picture},
                                         {"fits the map", &moment.agreement_picture},
                                         {"map at the estimate", &moment.estimate_picture},
                                         {"map at the truth", &moment.truth_picture}}};
  for (std::size_t i = 0; i < patches.size(); i += 2) {
    if (!*patches[i].picture && !*patches[i + 1].picture) continue;
    const auto pair = ui.columns(fmt::format("patches {}", i), {1.0, 1.0});
    for (std::size_t k = i; k < i + 2; ++k) {
      if (k > i) ui.next_column();
      if (*patches[k].picture) {
        draw_patch(ui, patches[k].caption, *patches[k].picture, moment, texture_of, width);
      }
    }
  }
}

bool is_asked(const CellAgreement::Count& count) { return count.share().has_value(); }

}  // namespace

void draw_seen_picture(kit::Ui& ui,
                       const std::string& name,
                       const Picture& picture,
                       const SeenMoment& moment,
                       const TextureOf& texture_of,
                       const Eigen::Vector2d& size) {
  const auto input = draw_picture(ui, name, picture, texture_of, size);
  if (!input.pixel) return;
  const auto words = seen_cell_words(seen_cell(moment, *input.pixel));
  ui.mouse_tooltip(words);
}

void draw_agreement_table(kit::Ui& ui, const SeenMoment& moment, Rgba estimate_colour) {
  if (moment.at_estimate.of_cell.empty()) {
    ui.text(!moment.map ? "open a map to compare with" : "nothing to compare",
            kit::TextLook::kMuted);
    return;
  }
  std::vector<kit::Column> columns = {{"class", kit::Align::kLeft, 0.0, 0, {}},
                                      {"estimate",
                                       kit::Align::kLeft,
                                       ui.px(104.0),
                                       0,
                                       {"Share of cells on known ground whose class the map has "
                                        "there, with the topview laid at the "
                                        "estimate; more is better",
                                        ""}}};
  if (moment.at_truth) {
    columns.push_back({"truth",
                       kit::Align::kLeft,
                       ui.px(104.0),
                       0,
                       {"The same with the topview laid at the truth; more is better", ""}});
  }
  const Theme& theme = ui.theme();
  const auto bar = [&](const CellAgreement::Count& count, Rgba colour) {
    if (const auto share = count.share()) {
      ui.bar_cell(*share, colour, fmt::format("{:.0f} %", 100.0 * *share));
    } else {
      ui.cell("–", kit::TextLook::kMuted);  // none on known ground, which is not 0 %
    }
  };
  const auto table = ui.table("Agreement", columns, {.is_only_read = true});
  if (!table) return;
  const auto draw_row = [&](const std::string& name, const CellAgreement::Count& estimate,
                            const std::optional<CellAgreement::Count>& truth) {
    ui.row(name);
    ui.cell(name);
    bar(estimate, estimate_colour);
    if (truth) bar(*truth, theme.muted);
  };
  for (ClassId id = 0; id < kClassCount; ++id) {
    const CellAgreement::Count& estimate = moment.at_estimate.of_class.at(id);
    std::optional<CellAgreement::Count> truth;
    if (moment.at_truth) truth = moment.at_truth->of_class.at(id);
    if (!is_asked(estimate) && !(truth && is_asked(*truth))) continue;
    draw_row(std::string(class_info(id).name), estimate, truth);
  }
  std::optional<CellAgreement::Count> truth;
  if (moment.at_truth) truth = moment.at_truth->total();
  draw_row("all", moment.at_estimate.total(), truth);
}

Actions draw_moment_panel(kit::Ui& ui, const MomentModel& model, MomentPanelState& state) {
  const auto scope = ui.scope("Moment");
  if (model.is_reading) return draw_empty_state(ui, reading_state(model.run_name));
  if (!model.has_step()) {
    return draw_empty_state(ui, no_run_state("errors, spread, camera and topview of each moment"));
  }
  ui.heading(clock_text(model.document->time_s[*model.index]));
  ui.hint({fmt::format("Step {} of {} of {}", *model.index + 1, model.document->steps.size(),
                       model.run_name),
           ""});
  draw_facts(ui, model);
  if (const auto camera = ui.section("Camera")) {
    draw_camera_view(ui, model, state.camera, state.texture_of, false);
  }
  const SeenMoment& seen = state.seen.of(model.step, model.map, ui.theme_name());
  if (const auto topview = ui.section("Topview and map")) {
    draw_patches(ui, seen, state.texture_of);
  }
  if (const auto agreement = ui.section("Agreement by class")) {
    draw_agreement_table(ui, seen, run_colour(ui.theme(), model.colour));
  }
  return {};
}

}  // namespace nadir
