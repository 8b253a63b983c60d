// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/map/semantic_classes.h"
#include "core/session/label_view.h"
#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// What stands at the left while labels are drawn: tools, what they draw with, and the classes.
struct LabelToolsModel {
  LabelView view;
  std::string name;           ///< Of what is labelled.
  std::string why_read_only;  ///< Empty: it can be drawn on.
  bool is_open = false;       ///< False: it is still being opened.
  bool is_on_disk = false;
  double metres_per_cell = 0.1;
  std::vector<std::string> profiles;  ///< Names of street profiles.
  struct ClassShare {
    double area_m2 = 0.0;
    double share = 0.0;  ///< Of all cells that are counted, 0 to 1.
  };
  std::array<ClassShare, kClassCount + 1> classes;  ///< The last: without class.
  bool is_counted = false;                          ///< False: counting goes on.
};
[[nodiscard]] LabelToolsModel label_tools_model(const Session& session);

/// In a scroll area of the left column.
[[nodiscard]] Actions draw_label_tools(kit::Ui& ui, const LabelToolsModel& model);

}  // namespace nadir
