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
  double labels_opacity = 1.0, picture_opacity = 1.0;
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

/// "1,234 m²", "3.2 ha".
[[nodiscard]] std::string area_text(double area_m2);
/// The colour of a class as the map has it; of what has none a neutral grey.
[[nodiscard]] Rgba class_colour(ClassId id);

}  // namespace nadir
