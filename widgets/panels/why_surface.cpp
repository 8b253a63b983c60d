// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/why_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/angle.h"
#include "widgets/panels/map_geometry.h"
#include "widgets/panels/moment_panel.h"
#include "widgets/panels/surface_picture.h"
#include "widgets/views/map_colours.h"

namespace nadir {
namespace {

constexpr double kRim = 0.75;  ///< Opacity of what lies around lines on a ramp of colours.

Rgba rim_of(const Theme& theme, Rgba line) {
  return with_opacity(casing_over_imagery(theme, line), kRim);
}

void mark_cross(
    Canvas& canvas, const Eigen::Vector2d& at, double arm, Rgba colour, Rgba rim, double width) {
  const std::array<Eigen::Vector2d, 2> along = {at - Eigen::Vector2d(arm, arm),
                                                at + Eigen::Vector2d(arm, arm)};
  const std::array<Eigen::Vector2d, 2> across = {at - Eigen::Vector2d(arm, -arm),
                                                 at + Eigen::Vector2d(arm, -arm)};
  for (const auto& [ink, extra] : {std::pair(rim, 2.0), std::pair(colour, 0.0)}) {
    canvas.stroke(along, {ink, width + extra});
    canvas.stroke(across, {ink, width + extra});
  }
}

void mark_ring(
    Canvas& canvas, const Eigen::Vector2d& at, double radius, Rgba colour, Rgba rim, double width) {
  std::vector<Eigen::Vector2d> ring;
  constexpr int kCorners = 24;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    ring.emplace_back(at + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  canvas.stroke(ring, {rim, width + 2.0});
  canvas.stroke(ring, {colour, width});
}

void draw_plane(kit::Ui& ui, const WhyModel& model, double side, WhyState& state, Actions& asked) {
  const MomentAnswer& answer = *model.answer;
  const MomentSurface& surface = *answer.surface;
  const auto& values = state.shows_best_turn ? surface.best_turn : surface.plane;
  if (state.pictured.get() != &answer || state.pictured_best_turn != state.shows_best_turn) {
    const auto& particles = answer.step->particles;
    state.surface = {std::make_shared<const Raster<Rgba>>(
                         surface_picture(surface, values, particles ? &*particles : nullptr)),
                     false};
    state.pictured_best_turn = state.shows_best_turn;
  }
  const auto input = draw_picture(ui, "Surface", state.surface, state.texture_of, {side, side});
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const GridPlace middle = surface.place_of(surface.volume.centre_in_enu);
  const Rgba run_colour = run_colour_on_imagery(theme, model.colour);
  mark_ring(canvas, surface_point(surface, middle, input.where), ui.px(6.0), run_colour,
            rim_of(theme, run_colour), ui.px(2.0));
  if (surface.truth && surface.is_truth_inside) {
    mark_cross(canvas, surface_point(surface, *surface.truth, input.where), ui.px(5.0),
               theme.truth_on_imagery, rim_of(theme, theme.truth_on_imagery), ui.px(2.0));
  }
  if (!input.area.is_hovered) return;
  const GridPlace place = surface_place(surface, middle_of_pixel(input.area.mouse), input.where);
  const ErrorSurfaceGrid& grid = surface.volume.grid;
  const int x = static_cast<int>(std::lround(place.x));
  const int y = static_cast<int>(std::lround(place.y));
  if (x < 0 || y < 0 || x >= grid.count_x || y >= grid.count_y) return;
  const float cost = values[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.count_x) +
                            static_cast<std::size_t>(x)];
  const Eigen::Vector2d away((x - middle.x) * grid.step_m, (y - middle.y) * grid.step_m);
  const std::vector<std::string> words = {
      fmt::format("mean cost {:.4f}, lower is better", cost),
      fmt::format("{} m {}, {} m {} of the estimate", metres_text(std::abs(away.x()), 1),
                  away.x() < 0.0 ? "west" : "east", metres_text(std::abs(away.y()), 1),
                  away.y() < 0.0 ? "south" : "north"),
      fmt::format("the picture is {} m across", metres_text(grid.count_x * grid.step_m, 0)),
      "light: low cost; ring: estimate; cross: truth", "click to show this place on the map"};
  ui.mouse_tooltip(words);
  if (input.area.clicked == kit::MouseButton::kLeft) {
    const Eigen::Vector2d at = surface.volume.centre_in_enu.translation_m() + away;
    asked.emplace_back(actions::LookAt{at.x(), at.y(), {}});
  }
}

/// The cost along the heading at the estimate's place: a picture of one row with the curve over it.
void draw_turn(kit::Ui& ui, const WhyModel& model) {
  const MomentSurface& surface = *model.answer->surface;
  const double width = std::min(ui.room().width, ui.px(340.0));
  const auto input = ui.area("Turn", {width, ui.px(56.0)}, kit::Wheel::kScrolls);
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const PageRect page = input.page();
  const CostRange range = cost_range(surface.turn);
  const auto count = static_cast<double>(surface.turn.size());
  std::vector<Eigen::Vector2d> curve;
  for (std::size_t i = 0; i < surface.turn.size(); ++i) {
    const double goodness = range.goodness(surface.turn[i]);
    // Compass-wise: a turn to the left lies at the left.
    const double left = page.width * (count - 1.0 - static_cast<double>(i)) / count;
    canvas.fill(corners_of({left, 0.0, page.width / count + 0.5, page.height}),
                value_colour(ValueColours::kViridis, goodness));
    curve.emplace_back(left + page.width / count / 2.0, page.height * (0.12 + 0.76 * goodness));
  }
  canvas.stroke(curve, {rim_of(theme, light_on_imagery(theme)), ui.px(3.0)});
  canvas.stroke(curve, {light_on_imagery(theme), ui.px(1.5)});
  const auto mark = [&](double yaw_place, Rgba colour) {
    const double x = page.width * (count - 0.5 - yaw_place) / count;
    if (!(x >= 0.0 && x <= page.width)) return;
    const std::array<Eigen::Vector2d, 2> line = {Eigen::Vector2d(x, 0.0),
                                                 Eigen::Vector2d(x, page.height)};
    canvas.stroke(line, {rim_of(theme, colour), ui.px(3.0)});
    canvas.stroke(line, {colour, ui.px(1.5)});
  };
  if (surface.truth) mark(surface.truth->yaw, theme.truth_on_imagery);
  mark(surface.place_of(surface.volume.centre_in_enu).yaw,
       run_colour_on_imagery(theme, model.colour));
  outline(canvas, page, theme.line);
  if (!input.is_hovered) return;
  const double place = count - 0.5 - middle_of_pixel(input.mouse).x() / page.width * count;
  const auto i = static_cast<std::size_t>(
      std::clamp(std::lround(place), 0L, static_cast<long>(surface.turn.size()) - 1));
  const double turn_deg =
      Angle::radians((static_cast<double>(i) - (count - 1.0) / 2.0) * surface.volume.grid.step_rad)
          .degrees();
  const std::vector<std::string> words = {
      fmt::format("mean cost {:.4f}", surface.turn[i]),
      fmt::format("{:.0f}° to the {} of the estimate's heading", std::abs(turn_deg),
                  turn_deg < 0.0 ? "right" : "left")};
  ui.mouse_tooltip(words);
}

/// Says what there is in place of a surface; true where there is none.
bool draw_no_surface(kit::Ui& ui, const WhyModel& model) {
  const MomentAnswer& answer = *model.answer;
  if (answer.surface) return false;
  const bool waits = model.is_playing && !answer.has_tried_surface;
  ui.wrapped(!answer.error.empty() ? answer.error
                                   : (waits ? "Pause to see the error surface." : "Computing…"),
             kit::TextLook::kMuted);
  return true;
}

/// One picture of what was seen, to be chosen among those that there are.
void draw_patch_choice(kit::Ui& ui, const WhyModel& model, double side, WhyState& state) {
  const MomentAnswer& answer = *model.answer;
  const SeenMoment& seen = state.seen.of(answer.step, answer.map, ui.theme_name());
  struct Patch {
    const char* name;
    const Picture* picture;
  };
  const std::array<Patch, 4> all = {{{"fits the map", &seen.agreement_picture},
                                     {"seen", &seen.seen_picture},
                                     {"map at estimate", &seen.estimate_picture},
                                     {"map at truth", &seen.truth_picture}}};
  std::vector<std::string> names;
  std::vector<std::size_t> patches;
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!*all.at(i).picture) continue;
    if (i == state.shown_patch) chosen = names.size();
    names.emplace_back(all.at(i).name);
    patches.push_back(i);
  }
  if (patches.empty()) {
    ui.wrapped(seen.why_not.empty() ? "decoding…" : seen.why_not, kit::TextLook::kMuted);
    return;
  }
  ui.next_width(side);
  const auto asked = ui.combo("##Patch", names, chosen,
                              {"What was seen from above, ahead is up: whether it fits the map at "
                               "the estimate, its classes, or those of the map there",
                               ""});
  if (asked) state.shown_patch = patches[*asked];
  const Patch& patch = all.at(patches[asked.value_or(chosen)]);
  draw_seen_picture(ui, "Patch", *patch.picture, seen, state.texture_of, {side, side});
}

}  // namespace

void draw_surface_and_patch(kit::Ui& ui, const WhyModel& model, WhyState& state, Actions& asked) {
  const auto no_labels = ui.label_width(0.0);
  const double side = std::floor(std::min((ui.room().width - ui.px(12.0)) / 2.0, ui.px(150.0)));
  {
    const auto pair = ui.columns("pictures", {1.0, 1.0});
    if (!draw_no_surface(ui, model)) {
      const std::array<std::string, 2> kinds = {"this heading", "best heading"};
      ui.next_width(side);
      const auto kind =
          ui.combo("##Cut", kinds, state.shows_best_turn ? 1 : 0,
                   {"Error surface: mean cost of each place with the estimate's "
                    "heading, or with the best of all headings there. Light: low cost; "
                    "ring: estimate; cross: truth; white dots: particles",
                    ""});
      if (kind) state.shows_best_turn = *kind == 1;
      draw_plane(ui, model, side, state, asked);
      state.pictured = model.answer;
    }
    ui.next_column();
    draw_patch_choice(ui, model, side, state);
  }
}

void draw_surface_cuts(kit::Ui& ui, const WhyModel& model) {
  if (draw_no_surface(ui, model)) return;
  const MomentSurface& surface = *model.answer->surface;
  draw_turn(ui, model);
  const double turn_deg = Angle::radians(std::floor((surface.volume.grid.count_yaw - 1) / 2.0) *
                                         surface.volume.grid.step_rad)
                              .degrees();
  ui.cut_text(fmt::format("turned up to {:.0f}° left and right; high: low cost", turn_deg),
              kit::TextLook::kMuted);
  ui.read_out("cost at the estimate", fmt::format("{:.4f}", surface.cost_at_estimate));
  if (surface.cost_at_truth)
    ui.read_out("cost at the truth", fmt::format("{:.4f}", *surface.cost_at_truth));
  const double away_m =
      (surface.least_in_enu.translation_m() - surface.volume.centre_in_enu.translation_m()).norm();
  ui.read_out(
      "least cost around",
      fmt::format("{:.4f}, {} m away", surface.least_cost, metres_text(away_m, 1)), "",
      {"The best of all places and headings of the surface, and how far from the estimate", ""});
}

}  // namespace nadir
