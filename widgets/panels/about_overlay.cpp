// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/about_overlay.h"

#include <fmt/format.h>

#include "core/base/version.h"

namespace nadir {

AboutModel about_model(const Session& session) {
  return {session.overlay() == Overlay::kAbout, std::string(kVersion)};
}

Actions draw_about(kit::Ui& ui, const AboutModel& model) {
  if (!model.is_open) return {};
  const auto overlay = ui.overlay("About Nadir", {.width = ui.px(480.0)});
  if (!overlay) return {};
  ui.heading("Nadir");
  ui.wrapped(
      "Nadir localises a drone or a car that has no GPS: what its camera sees, labelled by class "
      "and seen from above, "
      "is compared with a labelled overhead picture by a particle filter. This window shows what "
      "the filter knew, and "
      "why it went wrong where it did.");
  ui.space();
  ui.read_out("Version", model.version);
  ui.read_out("Licence", "Apache 2.0", {}, {}, kit::TextLook::kNormal);
  ui.space();
  const std::string words = fmt::format("Nadir {}", model.version);
  Actions asked;
  if (ui.button("Copy version", kit::ButtonLook::kNormal,
                {.text = "For reports of faults", .shortcut = {}}, kit::Icon::kCopy)) {
    asked.emplace_back(actions::Copy{words});
  }
  ui.same_line();
  ui.right_align(ui.px(96.0));
  ui.next_width(ui.px(96.0));
  const bool is_done =
      ui.button("Close", kit::ButtonLook::kPrimary, {.text = "Close", .shortcut = "Escape"});
  if (is_done || overlay.wants_close()) asked.emplace_back(actions::ShowOverlay{Overlay::kNone});
  return asked;
}

}  // namespace nadir
