// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// What Nadir is, which one this is, and under which terms.
struct AboutModel {
  bool is_open = false;
  std::string version;
};

[[nodiscard]] AboutModel about_model(const Session& session);

/// Lies over the window where the model says so.
[[nodiscard]] Actions draw_about(kit::Ui& ui, const AboutModel& model);

}  // namespace nadir
