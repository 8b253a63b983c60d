// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/panels/label_tools_panel.h"

namespace nadir {

/// Of the tool at work: only those that it looks at.
[[nodiscard]] Actions draw_tool_options(kit::Ui& ui, const LabelToolsModel& model);

}  // namespace nadir
