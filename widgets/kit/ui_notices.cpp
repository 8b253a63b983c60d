// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "widgets/canvas/printable.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr double kNoticeWidth = 400.0, kLeastNoticeWidth = 220.0;  // of the design

struct NoticeLook {
  Icon icon = Icon::kInfo;
  ImU32 colour = 0;
};

NoticeLook look_of(Level level, const Look& colours) {
  switch (level) {
    case Level::kGood:
      return {Icon::kCheck, colours.good};
    case Level::kWarning:
      return {Icon::kWarning, colours.warning};
    case Level::kBad:
      return {Icon::kError, colours.bad};
    case Level::kInfo:
      break;
  }
  return {Icon::kInfo, colours.accent};
}

/// Left end and width of notices: beside the boxes that lie over the window, where there is room for words.
std::pair<float, float> beside_boxes(const Ui::Frame& frame, const Rect& inside) {
  const float margin = frame.d(12), right = narrow(inside.right()) - margin;
  const float usual = std::min(narrow(inside.width) - 2.0F * margin, frame.d(kNoticeWidth));
  float width = usual;
  for (const ImRect& box : frame.box_places) width = std::min(width, right - box.Max.x - margin);
  if (width < frame.d(kLeastNoticeWidth)) width = usual;
  return {right - width, width};
}

/// Whether a notice, as high as it was in the last frame, lies over a box.
bool is_over_a_box(const Ui::Frame& frame, const std::string& window, float left, float bottom) {
  const ImGuiWindow* const before = ImGui::FindWindowByName(window.c_str());
  const ImVec2 size =
      before == nullptr ? ImVec2(frame.d(kNoticeWidth), frame.d(kNoticeWidth)) : before->Size;
  const ImRect wanted({left, bottom - size.y}, {left + size.x, bottom});
  return std::any_of(frame.box_places.begin(), frame.box_places.end(),
                     [&wanted](const ImRect& box) { return box.Overlaps(wanted); });
}

}  // namespace

std::optional<NoticeWish> Ui::notices(std::span<const Notice> notices, const Rect& inside) {
  Frame& frame = *frame_;
  std::optional<NoticeWish> wish;
  const auto [left, width] = beside_boxes(frame, inside);
  float bottom = narrow(inside.bottom()) - frame.d(12);
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                                      ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoScrollbar;
  const std::string before = std::exchange(frame.prefix, "Notices/");
  for (std::size_t i = notices.size(); i-- > 0;) {
    const Notice& notice = notices[i];
    const NoticeLook look = look_of(notice.level, frame.state.look);
    const std::string window_name = "notice/" + notice.id;
    // Where there is no room beside a box, what it has to say lies below it until it is closed.
    const bool is_below = is_over_a_box(frame, window_name, left, bottom);
    ImGui::SetNextWindowPos({left, bottom}, ImGuiCond_Always, {0.0F, 1.0F});
    ImGui::SetNextWindowSizeConstraints(
        {width, 1.0F}, {width, std::max(1.0F, narrow(inside.height) - 2.0F * frame.d(12))});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(frame.d(12), frame.d(8)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, frame.d(4));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, frame.state.look.raised);
    ImGui::Begin(window_name.c_str(), nullptr, kFlags);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
    if (is_below) {
      ImGui::BringWindowToDisplayBehind(ImGui::GetCurrentWindow(), frame.lowest_box);
    } else if (ImGui::GetCurrentContext()->OpenPopupStack.Size == 0)
      ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    const ImGuiWindow* const window = ImGui::GetCurrentWindow();
    const ImRect box = window->Rect();
    frame.fill({box.Min, {box.Min.x + frame.d(3), box.Max.y}}, look.colour, 2.0);
    frame.is_last_hovered = ImGui::IsWindowHovered();
    frame.note(ControlKind::kNotice, notice.id, box).value = notice.text;
    frame.controls.back().label = notice.text;
    {
      const Scope scope = frame.push_scope(notice.id, true);
      if (const auto asked = frame.draw_notice(*this, notice, look.icon, look.colour))
        wish = NoticeWish{notice.id, *asked};
    }
    bottom -= window->Size.y + frame.d(8);
    ImGui::End();
  }
  frame.prefix = before;
  return wish;
}

std::optional<NoticeWish::Kind> Ui::Frame::draw_notice(Ui& ui,
                                                       const Notice& notice,
                                                       Icon icon,
                                                       ImU32 the_colour) {
  std::optional<NoticeWish::Kind> asked;
  const Placed mark = place("mark", {d(20), d(28)}, 0.0F, true);
  write_icon(mark.box, icon, the_colour);
  ui.same_line();
  const float wrap_at = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - d(32);
  const float top = ImGui::GetCursorScreenPos().y;
  const float words_left = ImGui::GetCursorScreenPos().x;
  is_same_line = false;
  ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, top + d(5)});
  ImGui::PushTextWrapPos(wrap_at);
  ImGui::TextUnformatted(printable(notice.text).c_str());
  ImGui::PopTextWrapPos();
  const bool has_buttons = !notice.details.empty() || (!notice.action.empty() && !notice.is_brief);
  const ImVec2 after(
      words_left - (notice.details.empty() ? 0.0F : d(12)),
      std::max(ImGui::GetCursorScreenPos().y + (has_buttons ? d(8) : 0.0F), top + d(28)));
  if (notice.is_brief && !notice.action.empty()) {
    ImGui::SetCursorScreenPos(
        {words_left + text_size(notice.text, state.fonts->text).x + d(12), top});
    if (ui.button(notice.action)) asked = NoticeWish::Kind::kAction;
  }
  ImGui::SetCursorScreenPos(
      {ImGui::GetWindowPos().x + ImGui::GetWindowSize().x - d(8) - d(28), top});
  if (ui.icon_button("Dismiss", Icon::kClose, {"Dismiss", ""})) asked = NoticeWish::Kind::kDismiss;
  ImGui::SetCursorScreenPos(after);
  bool is_open = false;
  if (!notice.details.empty()) {
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("is open");
    is_open = storage->GetBool(id, false);
    if (ui.button(is_open ? "Hide details##Details" : "Details", ButtonLook::kQuiet))
      storage->SetBool(id, !is_open);
    controls.back().path = prefix + "Details";
    controls.back().value = is_open ? "open" : "closed";
    ui.same_line();
    if (ui.button("Copy", ButtonLook::kQuiet, {"Copy the notice with its details", ""}))
      asked = NoticeWish::Kind::kCopy;
  }
  if (!notice.action.empty() && !notice.is_brief) {
    if (!notice.details.empty()) ui.same_line();
    if (ui.button(notice.action)) asked = NoticeWish::Kind::kAction;
  }
  if (is_open) ImGui::SetCursorScreenPos({words_left, ImGui::GetCursorScreenPos().y});
  if (is_open) ui.wrapped(notice.details, TextLook::kMuted);
  return asked;
}

}  // namespace nadir::kit
