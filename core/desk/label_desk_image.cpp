// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "core/desk/label_desk.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {

Result<void> LabelDesk::look_at_image(const OverheadTiles& image,
                                      const Eigen::Vector2d& hand_in_enu_m) {
  const bool cuts = tool_.kind == ToolKind::kScissors;
  if (!cuts && !finds_on_image(tool_.kind)) return {};
  // A line along edges needs its beginning in sight.
  const bool has_begun = cuts && !points_.empty();
  const Eigen::Vector2d at = has_begun ? points_.all().back().in_enu_m : hand_in_enu_m;
  if (auto looked = image_tool_.look(image, at, tool_.assist); !looked) return looked;
  return has_begun ? image_tool_.begin_line(at, tool_.scissors) : Result<void>();
}

Result<void> LabelDesk::tell_image(const ImageStroke& stroke) {
  if (!finds_on_image(tool_.kind)) {
    return fail(ErrorCode::kInvalidOptions, "{} takes no strokes on the image",
                enum_name(tool_.kind));
  }
  return image_tool_.tell(tool_, stroke);
}

Result<void> LabelDesk::add_scissored(const Eigen::Vector2d& hand_in_enu_m, double reach_m) {
  ToolPoint point = aim(hand_in_enu_m, reach_m);
  if (!point.snap && !point.closes) {
    point.in_enu_m = on_lattice(image_tool_.snapped(point.in_enu_m, tool_.scissors));
  }
  if (points_.empty()) {
    if (auto begun = image_tool_.begin_line(point.in_enu_m, tool_.scissors); !begun) return begun;
    points_.add(point);
    return {};
  }
  const Eigen::Vector2d from = points_.all().back().in_enu_m;
  if (from == point.in_enu_m) return {};
  if (auto begun = image_tool_.begin_line(from, tool_.scissors); !begun) return begun;
  const auto line = image_tool_.line(from, point.in_enu_m);
  if (!line) return forward_error(line);
  const ToolPoints before = points_;
  for (std::size_t i = 1; i + 1 < line->size(); ++i) {
    const Eigen::Vector2d place = on_lattice((*line)[i]);
    if (place != points_.all().back().in_enu_m) points_.add({place, std::nullopt, false});
  }
  if (!point.closes) {
    points_.add(point);
    return {};
  }
  auto finished = finish();
  if (!finished) points_ = before;
  return finished;
}

Ring LabelDesk::coming_line(const ToolPoint& next) const {
  const auto line = image_tool_.line(points_.all().back().in_enu_m, next.in_enu_m);
  // Without sight of both ends: straight on.
  if (!line || line->size() <= 2) return {};
  return {line->begin() + 1, line->end() - 1};
}

Result<void> LabelDesk::finish_found() {
  auto done = take(image_tool_.edit(sheet_.now(), tool_),
                   tool_.found_as == FoundAs::kAreas ? Chooses::kWhatWasMade : Chooses::kAsBefore);
  if (done) image_tool_.clear();
  return done;
}

}  // namespace nadir
