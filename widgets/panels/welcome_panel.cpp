// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/welcome_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/session/commands.h"
#include "widgets/panels/panel_text.h"
#include "widgets/panels/shortcut_hint.h"
#include "widgets/panels/work_card.h"

namespace nadir {
namespace {

constexpr double kWidth = 760.0, kRow = 28.0;

/// One of the choices: what it is for, over the button.
void draw_choice_words(kit::Ui& ui,
                       kit::Icon icon,
                       const std::string& title,
                       const std::string& words) {
  ui.icon(icon, kit::TextLook::kAccent);
  ui.same_line();
  ui.heading(title);
  ui.wrapped(words, kit::TextLook::kMuted);
  ui.space();
}

[[nodiscard]] kit::Hint open_hint(const std::string& text) {
  kit::Hint hint{.text = text};
  for (const Command& command : session_commands()) {
    if (command.text == "open") hint.shortcut = command.shortcut;
  }
  return hint;
}

/// What to do with a flight that has no map yet.
[[nodiscard]] Actions draw_lone_flight(kit::Ui& ui, const WelcomeModel::LoneFlight& flight) {
  const auto scope = ui.scope("Flight");
  Actions asked;
  ui.icon(kit::Icon::kPlane, kit::TextLook::kAccent);
  ui.same_line();
  ui.heading(shortened(flight.name, 60));
  if (flight.facts.empty()) {
    ui.text("The flight is being read.", kit::TextLook::kMuted);
    return asked;
  }
  ui.text(flight.facts, kit::TextLook::kMuted);
  if (!flight.why_not.empty()) ui.wrapped(flight.why_not, kit::TextLook::kWarning);
  ui.wrapped(flight.why_not.empty() ? "To localise it, open the map that it was flown over."
                                    : "It can be looked at on a map, but not localised.");
  ui.space();
  bool is_first = true;
  for (const std::string& map : flight.maps) {
    const bool is_clicked =
        ui.button(label_of("Open map " + shortened(name_of(map), 24), map),
                  is_first ? kit::ButtonLook::kPrimary : kit::ButtonLook::kNormal, {.text = map},
                  kit::Icon::kMap);
    if (is_clicked) asked.emplace_back(actions::OpenFile{map});
    is_first = false;
    ui.same_line();
  }
  if (ui.button(is_first ? "Open a map…" : "Another map…", kit::ButtonLook::kNormal,
                open_hint("Look for the map's folder"), kit::Icon::kFolder)) {
    asked.emplace_back(actions::ShowOverlay{Overlay::kOpen});
  }
  return asked;
}

[[nodiscard]] std::string facts_of(const FlightDescription& flight) {
  const std::size_t count = flight.frames.size();
  if (count == 0) return flight.format + ", no pictures";
  const double length_s = flight.frames.back().time_s - flight.frames.front().time_s;
  return fmt::format("{}, {} {} in {:.0f} s", flight.format, count,
                     count == 1 ? "picture" : "pictures", length_s);
}

[[nodiscard]] std::string why_never_localised(const FlightDescription& flight) {
  const bool has_labels =
      std::any_of(flight.frames.begin(), flight.frames.end(),
                  [](const FlightFrame& frame) { return frame.labels.has_value(); });
  if (!has_labels) return "It has no label images, which localising takes.";
  if (!flight.odometry) return "It has no odometry, which localising takes.";
  return flight.camera ? "" : "It has no camera calibration, which localising takes.";
}

[[nodiscard]] Actions draw_demo_choice(kit::Ui& ui, const WelcomeModel& model) {
  draw_choice_words(
      ui, kit::Icon::kPlane, "See how it works",
      "A flight over a small town, made and localised on this computer in about a minute.");
  const auto pale = ui.disabled(!model.busy.empty(), model.busy);
  if (ui.button("Open the demo", kit::ButtonLook::kPrimary,
                {.text = "Make the demo flight, localise it and open the run", .shortcut = {}},
                kit::Icon::kPlay)) {
    return {actions::OpenDemo{}};
  }
  return {};
}

[[nodiscard]] Actions draw_choices(kit::Ui& ui, const WelcomeModel& model) {
  Actions asked;
  const auto columns = ui.columns("Choices", {1.0, 1.0, 1.0});
  // What has been chosen stands where it was offered.
  asked = model.work ? draw_work(ui, *model.work) : draw_demo_choice(ui, model);
  ui.next_column();
  draw_choice_words(ui, kit::Icon::kFolderOpen, "Look at a flight of yours",
                    "A recorded run, a map, a flight recording, a figure or its recipe.");
  if (ui.button("Open files…", kit::ButtonLook::kNormal,
                open_hint("Open a run, a map, a flight, a recipe or a figure"),
                kit::Icon::kFolder)) {
    asked.emplace_back(actions::ShowOverlay{Overlay::kOpen});
  }
  ui.next_column();
  draw_choice_words(ui, kit::Icon::kDownload, "Or drop files here",
                    "Drag them from a file manager onto this window, as many as you like. A figure "
                    "that Nadir has "
                    "drawn opens at its moment.");
  return asked;
}

[[nodiscard]] Actions draw_recent_files(kit::Ui& ui, const WelcomeModel& model) {
  Actions asked;
  ui.heading("Recent");
  if (model.recents.empty()) {
    ui.text("What you open is listed here.", kit::TextLook::kMuted);
    return asked;
  }
  const auto scope = ui.scope("Recent");
  const auto scroll = ui.scroll_area("Recent files");
  ui.clipped_rows(model.recents.size(), ui.px(kRow), [&](std::size_t i) {
    const std::string& path = model.recents[i];
    const kit::ListRow look{.detail = shortened(folder_of(path, model.home), 56),
                            .icon = kit::Icon::kFile,
                            .hint = {.text = path, .shortcut = {}}};
    if (ui.list_row(label_of(shortened(name_of(path), 40), path), look)) {
      asked.emplace_back(actions::OpenFile{path});
    }
  });
  return asked;
}

}  // namespace

WelcomeModel welcome_model(const Session& session) {
  WelcomeModel model;
  model.recents.assign(session.recents().begin(), session.recents().end());
  model.home = home_folder();
  for (const Notice& notice : session.notices()) {
    if (notice.remedy && std::holds_alternative<actions::OpenFile>(*notice.remedy)) {
      model.offer =
          WelcomeModel::Offer{notice.text, notice.remedy_title, *notice.remedy, notice.number};
    }
  }
  for (const JobStatus& job : session.jobs()) {
    model.busy = job.title;
    if (job.will_be_shown) model.work = job;
  }
  const std::string& path = session.view().flight_path;
  if (!path.empty() && session.active_run() == nullptr) {
    WelcomeModel::LoneFlight alone;
    alone.name = name_of(path);
    if (const auto flight = session.flight()) {
      if (!flight->description().name.empty()) alone.name = flight->description().name;
      alone.facts = facts_of(flight->description());
      alone.why_not = why_never_localised(flight->description());
      alone.maps.assign(session.maps_for_flight().begin(), session.maps_for_flight().end());
    }
    model.flight = std::move(alone);
  }
  return model;
}

Actions draw_welcome(kit::Ui& ui, const WelcomeModel& model) {
  const auto scope = ui.scope("Welcome");
  Actions asked;
  const kit::Rect room = ui.room();
  const double width = std::min(ui.px(kWidth), room.width);
  const double aside = (room.width - width) / 2.0;
  const auto page = ui.columns("Page", {std::max(aside, 1.0), width, std::max(aside, 1.0)});
  ui.next_column();
  ui.space(std::clamp(room.height * 0.12, 0.0, ui.px(96.0)));
  const auto append = [&](const Actions& more) {
    asked.insert(asked.end(), more.begin(), more.end());
  };
  if (model.flight) {
    append(draw_lone_flight(ui, *model.flight));
    ui.space(ui.px(24.0));
    ui.line();
    ui.space();
  }
  ui.heading("Nadir");
  ui.wrapped(
      "Replay a flight on its map, see where localising it went wrong and why, and try again with "
      "other settings.");
  ui.space(ui.px(24.0));
  append(draw_choices(ui, model));
  ui.space(ui.px(24.0));
  if (model.offer) {
    ui.line();
    ui.space();
    ui.wrapped(model.offer->text);
    ui.space();
    if (ui.button(model.offer->button, kit::ButtonLook::kNormal, {}, kit::Icon::kRepeat)) {
      asked.push_back(model.offer->action);
      asked.emplace_back(actions::DismissNotice{model.offer->notice});
    }
    ui.space();
  }
  ui.line();
  ui.space();
  append(draw_recent_files(ui, model));
  return asked;
}

}  // namespace nadir
