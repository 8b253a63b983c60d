// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/session/session.h"

namespace nadir {

/// How the window is opened.
struct GuiRequest {
  std::vector<std::string> files;  ///< To be opened at once.
  std::string labels;              ///< To be labelled at once; empty: none.
  SessionPlaces places;
  std::filesystem::path program;   ///< Whose commands make figures; own_program().
  bool restores = true;            ///< Opens what was open last where no files are given.
  int width = 1280, height = 800;  ///< Pixels at scale 1.
  double scale = 0.0;              ///< Of the interface; 0: the preference, else the screen's.
  std::optional<std::filesystem::path> script;      ///< Driven by it, without a display.
  std::optional<std::filesystem::path> screenshot;  ///< Photographed at its end, without a display.
};

/// The window on the desktop, until it is closed. @errors kUnsupported: no display.
[[nodiscard]] Result<void> run_desktop_gui(const GuiRequest& request);

/// The same window without a display: opens the files, does what the script says, takes the picture, ends.
/// @param not_opened  Told why each of the request's files could not be opened, once the window has come to rest; script and
/// picture follow all the same.
/// @errors kUnsupported: no OpenGL; as the script's lines; kIo.
[[nodiscard]] Result<void> run_gui_unseen(const GuiRequest& request,
                                          const std::function<void(const Error&)>& not_opened);

}  // namespace nadir
