// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/ui_canvas.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/require.h"
#include "widgets/canvas/page_lines.h"
#include "widgets/canvas/printable.h"
#include "widgets/kit/ui_look.h"

namespace nadir::kit {
namespace {

/// More rectangles than this are a texture.
constexpr std::size_t kMostRuns = 512;

bool is_convex(std::span<const ImVec2> corners) {
  float sign = 0.0F;
  double turned = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ImVec2& a = corners[i];
    const ImVec2& b = corners[(i + 1) % corners.size()];
    const ImVec2& c = corners[(i + 2) % corners.size()];
    const ImVec2 first(b.x - a.x, b.y - a.y);
    const ImVec2 second(c.x - b.x, c.y - b.y);
    const float cross = first.x * second.y - first.y * second.x;
    turned += std::atan2(cross, first.x * second.x + first.y * second.y);
    if (std::abs(cross) < 1e-4F) continue;
    if (sign * cross < 0.0F) return false;
    sign = cross;
  }
  return std::abs(std::abs(turned) - 2.0 * std::numbers::pi) < 0.1;  // once around
}

/// Equal neighbours of a row.
struct Run {
  int row = 0, begin = 0, end = 0;
  Rgba colour;
};

std::vector<Run> runs_of(const Raster<Rgba>& pixels) {
  std::vector<Run> runs;
  for (int row = 0; row < pixels.height() && runs.size() <= kMostRuns; ++row) {
    for (int begin = 0; begin < pixels.width();) {
      int end = begin + 1;
      while (end < pixels.width() && pixels.at(end, row) == pixels.at(begin, row)) ++end;
      if (pixels.at(begin, row).alpha > 0)
        runs.push_back(Run{row, begin, end, pixels.at(begin, row)});
      begin = end;
    }
  }
  return runs;
}

}  // namespace

/// The clip of a canvas, for as long as something is drawn.
class UiCanvas::Clipped {
 public:
  explicit Clipped(const UiCanvas& canvas) : list_(canvas.list_) {
    const Rect& clip = canvas.clips_.back();
    list_.PushClipRect({static_cast<float>(clip.left), static_cast<float>(clip.top)},
                       {static_cast<float>(clip.right()), static_cast<float>(clip.bottom())}, true);
  }
  ~Clipped() { list_.PopClipRect(); }
  Clipped(const Clipped&) = delete;
  Clipped& operator=(const Clipped&) = delete;

 private:
  ImDrawList& list_;
};

UiCanvas::UiCanvas(ImDrawList& list, const Rect& area, const FontSet& fonts, UiPictures& pictures)
    : list_(list), area_(area), fonts_(fonts), pictures_(pictures), clips_{area} {}

Eigen::Vector2f UiCanvas::in_window(const Eigen::Vector2d& point) const {
  return {static_cast<float>(area_.left + point.x()),
          static_cast<float>(area_.bottom() - point.y())};
}

Rect UiCanvas::in_window(const PageRect& rect) const {
  return {area_.left + rect.left, area_.bottom() - rect.top(), rect.width, rect.height};
}

void UiCanvas::push_clip(const PageRect& inside) {
  const Rect wanted = in_window(inside);
  const Rect& outer = clips_.back();
  const double left = std::max(wanted.left, outer.left);
  const double top = std::max(wanted.top, outer.top);
  clips_.push_back({left, top, std::max(0.0, std::min(wanted.right(), outer.right()) - left),
                    std::max(0.0, std::min(wanted.bottom(), outer.bottom()) - top)});
}

void UiCanvas::pop_clip() {
  NADIR_REQUIRE(clips_.size() > 1);
  clips_.pop_back();
}

void UiCanvas::stroke_piece(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) {
  std::vector<ImVec2> line;
  line.reserve(points.size());
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2f at = in_window(point);
    if (line.empty() || std::abs(line.back().x - at.x()) + std::abs(line.back().y - at.y()) > 0.01F)
      line.push_back({at.x(), at.y()});
  }
  if (line.size() < 2) return;
  const ImU32 colour = packed(style.colour);
  const auto width = static_cast<float>(style.width_px);
  const bool is_closed =
      line.size() > 3 &&
      std::abs(line.front().x - line.back().x) + std::abs(line.front().y - line.back().y) < 0.02F;
  if (is_closed) line.pop_back();
  list_.AddPolyline(line.data(), static_cast<int>(line.size()), colour,
                    is_closed ? ImDrawFlags_Closed : ImDrawFlags_None, width);
  // Dear ImGui cuts sharp corners of wide lines off; a disc makes them round. One that shines through would show twice.
  if (width < 2.5F || style.colour.alpha < 255) return;
  for (std::size_t i = is_closed ? 0 : 1; i + (is_closed ? 0 : 1) < line.size(); ++i) {
    const ImVec2& before = line[(i + line.size() - 1) % line.size()];
    const ImVec2& after = line[(i + 1) % line.size()];
    const ImVec2 in(line[i].x - before.x, line[i].y - before.y);
    const ImVec2 out(after.x - line[i].x, after.y - line[i].y);
    const float along = in.x * out.x + in.y * out.y;
    const float across = std::abs(in.x * out.y - in.y * out.x);
    if (across > 0.5F * std::abs(along) || along < 0.0F)
      list_.AddCircleFilled(line[i], width / 2.0F, colour);
  }
}

void UiCanvas::stroke(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) {
  if (style.colour.alpha == 0 || !(style.width_px > 0.0)) return;
  const Clipped clipped(*this);
  for (const LinePiece& piece :
       line_inside(points, surroundings_of_page(area_.width, area_.height))) {
    if (style.dashes_px.empty()) {
      stroke_piece(piece.points, style);
      continue;
    }
    for (const auto& dash : dashed(piece.points, style.dashes_px, piece.begin))
      stroke_piece(dash, style);
  }
}

void UiCanvas::fill(std::span<const Eigen::Vector2d> outline, Rgba colour) {
  if (colour.alpha == 0) return;
  const std::vector<Eigen::Vector2d> inside =
      area_inside(outline, surroundings_of_page(area_.width, area_.height));
  if (inside.size() < 3) return;
  const Clipped clipped(*this);
  std::vector<ImVec2> corners;
  for (const Eigen::Vector2d& point : inside) {
    const Eigen::Vector2f at = in_window(point);
    if (corners.empty() ||
        std::abs(corners.back().x - at.x()) + std::abs(corners.back().y - at.y()) > 0.01F)
      corners.push_back({at.x(), at.y()});
  }
  if (corners.size() > 3 && std::abs(corners.front().x - corners.back().x) +
                                    std::abs(corners.front().y - corners.back().y) <
                                0.02F)
    corners.pop_back();
  const ImU32 ink = packed(colour);
  if (corners.size() < 3) return;
  if (is_convex(corners)) {
    list_.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), ink);
    return;
  }
  const std::vector<Eigen::Vector2d> triangles = triangles_inside(inside);
  const ImVec2 white = list_._Data->TexUvWhitePixel;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    list_.PrimReserve(3, 3);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Eigen::Vector2f at = in_window(triangles[i + corner]);
      list_.PrimVtx({at.x(), at.y()}, white, ink);
    }
  }
}

void UiCanvas::text(const Eigen::Vector2d& point, const std::string& line, const TextStyle& style) {
  if (style.colour.alpha == 0 || !point.allFinite() || !(style.size_px > 0.0)) return;
  const Clipped clipped(*this);
  const std::string words = printable(line);
  ImFont* const font = fonts_.for_style(style);
  const auto enlarged = static_cast<float>(style.size_px / fonts_.em_px(font));
  const double width =
      font->CalcTextSizeA(font->FontSize * enlarged, FLT_MAX, 0.0F, words.c_str()).x;
  const double back = style.align == TextAlign::kLeft    ? 0.0
                      : style.align == TextAlign::kRight ? width
                                                         : width / 2.0;
  Eigen::Vector2f origin = in_window(point);
  const bool is_level = style.rotation_deg == 0.0;
  if (is_level) {  // sharper
    if (style.align == TextAlign::kLeft) origin.x() = std::round(origin.x());
    origin.y() = std::round(origin.y());
  }
  const double angle = -style.rotation_deg * std::numbers::pi / 180.0;
  const Eigen::Vector2f along(static_cast<float>(std::cos(angle)),
                              static_cast<float>(std::sin(angle)));
  const Eigen::Vector2f down(-along.y(), along.x());
  const auto place = [&](float x, float y) {
    const Eigen::Vector2f at = origin + x * along + y * down;
    return ImVec2(at.x(), at.y());
  };
  const ImU32 ink = packed(style.colour);
  auto pen = static_cast<float>(-back);
  const char* const end = words.c_str() + words.size();
  for (const char* letter = words.c_str(); letter < end;) {
    unsigned code = 0;
    letter += std::max(1, ImTextCharFromUtf8(&code, letter, end));
    const ImFontGlyph* const glyph = font->FindGlyph(static_cast<ImWchar>(code));
    if (glyph == nullptr) continue;
    if (glyph->Visible != 0) {
      const float left = pen + glyph->X0 * enlarged;
      const float right = pen + glyph->X1 * enlarged;
      const float top = (glyph->Y0 - font->Ascent) * enlarged;
      const float bottom = (glyph->Y1 - font->Ascent) * enlarged;
      list_.PrimReserve(6, 4);
      list_.PrimQuadUV(place(left, top), place(right, top), place(right, bottom),
                       place(left, bottom), {glyph->U0, glyph->V0}, {glyph->U1, glyph->V0},
                       {glyph->U1, glyph->V1}, {glyph->U0, glyph->V1}, ink);
    }
    pen += glyph->AdvanceX * enlarged;
  }
}

void UiCanvas::image(const PageRect& where, const Raster<Rgba>& pixels) {
  if (pixels.empty() || !(where.width > 0.0) || !(where.height > 0.0)) return;
  const Clipped clipped(*this);
  const Rect rect = in_window(where);
  const std::vector<Run> runs = runs_of(pixels);
  if (runs.size() > kMostRuns) {
    list_.AddImage(pictures_.add(pixels),
                   {static_cast<float>(rect.left), static_cast<float>(rect.top)},
                   {static_cast<float>(rect.right()), static_cast<float>(rect.bottom())});
    return;
  }
  const double across = rect.width / pixels.width();
  const double down = rect.height / pixels.height();
  for (const Run& run : runs) {
    const ImVec2 upper_left(static_cast<float>(rect.left + across * run.begin),
                            static_cast<float>(rect.top + down * run.row));
    const ImVec2 lower_right(static_cast<float>(rect.left + across * run.end),
                             static_cast<float>(rect.top + down * (run.row + 1)));
    list_.PrimReserve(6, 4);
    list_.PrimRect(upper_left, lower_right, packed(run.colour));
  }
}

}  // namespace nadir::kit
