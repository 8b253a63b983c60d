// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/welcome_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "widgets/panels/panel_text.h"
#include "widgets/panels/shortcut_hint.h"

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

[[nodiscard]] Actions draw_choices(kit::Ui& ui, const WelcomeModel& model, PaletteState& palette) {
  Actions asked;
  const auto columns = ui.columns("Choices", {1.0, 1.0, 1.0});
  draw_choice_words(
      ui, kit::Icon::kPlane, "See how it works",
      "A flight over a small town, made and localised on this computer in a few seconds.");
  {
    const auto pale = ui.disabled(!model.busy.empty(), model.busy);
    if (ui.button("Open the demo", kit::ButtonLook::kPrimary,
                  {.text = "Make the demo flight, localise it and open the run", .shortcut = {}},
                  kit::Icon::kPlay)) {
      asked.emplace_back(actions::OpenDemo{});
    }
  }
  ui.next_column();
  draw_choice_words(
      ui, kit::Icon::kFolderOpen, "Look at a flight of yours",
      "A recorded run, a map, a flight recording, a figure or its recipe, by its path.");
  const std::string shortcut = [] {
    for (const Command& command : session_commands()) {
      if (command.text == "open") return std::string(command.shortcut);
    }
    return std::string();
  }();
  if (ui.button("Open files…", kit::ButtonLook::kNormal,
                {.text = "Open a run, a map, a flight, a recipe or a figure", .shortcut = shortcut},
                kit::Icon::kFolder)) {
    palette.begun = "open";
    palette.arguments.clear();
    asked.emplace_back(actions::ShowOverlay{Overlay::kPalette});
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
  for (const JobStatus& job : session.jobs()) model.busy = job.title;
  return model;
}

Actions draw_welcome(kit::Ui& ui, const WelcomeModel& model, PaletteState& palette) {
  const auto scope = ui.scope("Welcome");
  Actions asked;
  const kit::Rect room = ui.room();
  const double width = std::min(ui.px(kWidth), room.width);
  const double aside = (room.width - width) / 2.0;
  const auto page = ui.columns("Page", {std::max(aside, 1.0), width, std::max(aside, 1.0)});
  ui.next_column();
  ui.space(std::clamp(room.height * 0.12, 0.0, ui.px(96.0)));
  ui.heading("Nadir");
  ui.wrapped(
      "Replay a flight on its map, see where localising it went wrong and why, and try again with "
      "other settings.");
  ui.space(ui.px(24.0));
  const auto append = [&](const Actions& more) {
    asked.insert(asked.end(), more.begin(), more.end());
  };
  append(draw_choices(ui, model, palette));
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
