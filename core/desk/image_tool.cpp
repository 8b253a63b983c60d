// SPDX-License-Identifier: Apache-2.0
#include "core/desk/image_tool.h"

#include <utility>

#include "core/assist/grab_cut.h"
#include "core/assist/magic_wand.h"
#include "core/base/require.h"

namespace nadir {
namespace {

bool is_in_inner_half(const AssistWindow& window, const Eigen::Vector2d& at_in_enu_m) {
  const Eigen::Vector2d at = window.pixels_from_enu() * at_in_enu_m;
  return at.x() >= 0.25 * window.width() && at.x() < 0.75 * window.width() &&
         at.y() >= 0.25 * window.height() && at.y() < 0.75 * window.height();
}

/// Along the rows and columns of what is looked at.
Ring rectangle_in_window(const AssistWindow& window, const Ring& corners) {
  const Eigen::Vector2d from = window.pixels_from_enu() * corners.front();
  const Eigen::Vector2d to = window.pixels_from_enu() * corners.back();
  Ring ring{from, {to.x(), from.y()}, to, {from.x(), to.y()}};
  for (Eigen::Vector2d& corner : ring) corner = window.enu_from_pixels() * corner;
  return ring;
}

}  // namespace

Result<void> ImageTool::look(const OverheadTiles& image,
                             const Eigen::Vector2d& at_in_enu_m,
                             const AssistWindowOptions& options) {
  const bool sees_enough =
      window_ && looks_so_ == options && is_in_inner_half(*window_, at_in_enu_m);
  if (is_told() || sees_enough) return {};
  auto window = read_assist_window(image, at_in_enu_m, options);
  if (!window) return forward_error(window);
  look_away();
  window_ = std::move(*window);
  looks_so_ = options;
  return {};
}

Result<void> ImageTool::tell(const LabelTool& tool, const ImageStroke& stroke) {
  if (!window_) return fail(ErrorCode::kInvalidOptions, "there is no image to look at");
  if (stroke.path_in_enu_m.empty())
    return fail(ErrorCode::kInvalidOptions, "a stroke needs a place");
  std::vector<ImageStroke> strokes = strokes_;
  strokes.push_back(stroke);
  auto found = find(tool, strokes);
  if (!found) return forward_error(found);
  strokes_ = std::move(strokes);
  found_ = std::move(found->mask);
  borders_ = std::move(found->borders);
  return {};
}

Result<void> ImageTool::tell_again(const LabelTool& tool) {
  if (!is_told()) return {};
  auto found = find(tool, strokes_);
  if (!found) return forward_error(found);
  found_ = std::move(found->mask);
  borders_ = std::move(found->borders);
  return {};
}

void ImageTool::take_back(const LabelTool& tool) {
  NADIR_REQUIRE(is_told());
  strokes_.pop_back();
  // What could be found with more strokes may be nothing with fewer.
  if (!is_told() || !tell_again(tool)) clear();
}

void ImageTool::clear() {
  strokes_.clear();
  borders_.clear();
  found_ = {};
  line_begins_in_enu_m_.reset();
}

void ImageTool::look_away() {
  clear();
  window_.reset();
  superpixels_.reset();
  scissors_.reset();
}

Result<ImageTool::Found> ImageTool::find(const LabelTool& tool,
                                         const std::vector<ImageStroke>& strokes) {
  Result<PixelMask> mask;
  switch (tool.kind) {
    case ToolKind::kWand:
      mask = find_by_wand(tool.wand, strokes);
      break;
    case ToolKind::kSuperpixels:
      mask = find_superpixels_along(tool.superpixels, strokes);
      break;
    case ToolKind::kGrabCut:
      mask = find_by_cut(tool.grab_cut, strokes);
      break;
    default:
      return fail(ErrorCode::kInvalidOptions, "{} does not look at the image",
                  enum_name(tool.kind));
  }
  if (!mask) return forward_error(mask);
  auto borders = borders_in_enu(*window_, *mask);
  if (!borders) return forward_error(borders);
  return Found{std::move(*mask), std::move(*borders)};
}

Result<PixelMask> ImageTool::find_by_wand(const WandOptions& options,
                                          const std::vector<ImageStroke>& strokes) const {
  PixelMask all(window_->width(), window_->height());
  for (const ImageStroke& stroke : strokes) {
    const auto one = magic_wand(*window_, stroke.path_in_enu_m.front(), options);
    if (!one) return forward_error(one);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (one->values()[i] != 0) all.values()[i] = stroke.takes_away ? 0 : 1;
    }
  }
  return all;
}

Result<PixelMask> ImageTool::find_superpixels_along(const SuperpixelOptions& options,
                                                    const std::vector<ImageStroke>& strokes) {
  if (!superpixels_ || !(superpixels_so_ == options)) {
    auto made = find_superpixels(*window_, options);
    if (!made) return forward_error(made);
    superpixels_ = std::move(*made);
    superpixels_so_ = options;
  }
  std::set<SuperpixelId> chosen;
  for (const ImageStroke& stroke : strokes) {
    const Ring& path = stroke.path_in_enu_m;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Eigen::Vector2d& from = i == 0 ? path[0] : path[i - 1];
      for (const SuperpixelId id : superpixels_along(*superpixels_, *window_, from, path[i])) {
        if (stroke.takes_away) {
          chosen.erase(id);
        } else {
          chosen.insert(id);
        }
      }
    }
  }
  return mask_of(*superpixels_, chosen);
}

Result<PixelMask> ImageTool::find_by_cut(const GrabCutOptions& options,
                                         const std::vector<ImageStroke>& strokes) const {
  GrabCutMarks marks;
  marks.around = rectangle_in_window(*window_, strokes.front().path_in_enu_m);
  for (std::size_t i = 1; i < strokes.size(); ++i) {
    std::vector<Ring>& kind = strokes[i].takes_away ? marks.unwanted : marks.wanted;
    kind.push_back(strokes[i].path_in_enu_m);
  }
  return nadir::grab_cut(*window_, marks, options);
}

Result<LabelEdit> ImageTool::edit(const LabelDocument& document, const LabelTool& tool) const {
  if (!window_ || !is_told()) return fail(ErrorCode::kInvalidOptions, "nothing was found yet");
  const auto cells = cells_of(*window_, found_, document.grid());
  if (!cells) return forward_error(cells);
  const ClassId class_id = tool.class_id.id;
  const std::string_view name = class_info(class_id).name;
  if (tool.found_as == FoundAs::kAreas) {
    return draw_cells(document, *cells, class_id, tool.found, fmt::format("Draw {}", name));
  }
  return paint_cells(document, *cells, paint_value(tool), fmt::format("Paint {}", name));
}

Result<void> ImageTool::make_scissors(const ScissorsOptions& options) {
  if (!window_) return fail(ErrorCode::kInvalidOptions, "there is no image to look at");
  if (scissors_ && scissors_so_ == options) return {};
  auto made = Scissors::create(*window_, options);
  if (!made) return forward_error(made);
  scissors_ = std::move(*made);
  scissors_so_ = options;
  line_begins_in_enu_m_.reset();
  return {};
}

Result<void> ImageTool::begin_line(const Eigen::Vector2d& from_in_enu_m,
                                   const ScissorsOptions& options) {
  if (auto made = make_scissors(options); !made) return made;
  if (line_begins_in_enu_m_ == from_in_enu_m) return {};
  if (auto begun = scissors_->begin_at(from_in_enu_m); !begun) return begun;
  line_begins_in_enu_m_ = from_in_enu_m;
  return {};
}

Result<Ring> ImageTool::line(const Eigen::Vector2d& from_in_enu_m,
                             const Eigen::Vector2d& to_in_enu_m) const {
  if (!scissors_ || line_begins_in_enu_m_ != from_in_enu_m) {
    return fail(ErrorCode::kInvalidOptions, "no line begins there");
  }
  return scissors_->line_to(to_in_enu_m);
}

Eigen::Vector2d ImageTool::snapped(const Eigen::Vector2d& point_in_enu_m,
                                   const ScissorsOptions& options) {
  if (!make_scissors(options)) return point_in_enu_m;
  return scissors_->snapped(point_in_enu_m);
}

}  // namespace nadir
