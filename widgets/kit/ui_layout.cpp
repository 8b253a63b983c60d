// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {

Rect Ui::room() const {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 left = ImGui::GetContentRegionAvail();
  return {at.x, at.y, std::max(0.0F, left.x), std::max(0.0F, left.y)};
}

void Ui::Frame::draw_end(ImGuiListClipper& clipper, std::size_t count) const {
  if (state.focus.frames_to_end == 0 || count == 0) return;
  const int row = state.focus.to_end < 0 ? 0 : static_cast<int>(count) - 1;
  clipper.ForceDisplayRangeByIndices(row, row + 1);
}

void Ui::clipped_rows(std::size_t count,
                      double row_height,
                      const std::function<void(std::size_t)>& draw_row) {
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(count), narrow(row_height));
  frame_->draw_end(clipper, count);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(static_cast<std::size_t>(i));
  }
  clipper.End();
}

Scope Ui::columns(const std::string& name, const std::vector<double>& weights) {
  const Frame& frame = *frame_;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(frame.d(6), 0.0F));
  const bool is_open =
      ImGui::BeginTable(name.c_str(), static_cast<int>(weights.size()),
                        ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoPadOuterX);
  ImGui::PopStyleVar();
  if (!is_open) return {};
  for (const double weight : weights)
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, narrow(weight));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  return {true, [] { ImGui::EndTable(); }};
}

void Ui::next_column() {
  frame_->is_same_line = false;
  ImGui::TableNextColumn();
}

void Ui::same_line(double gap) {
  frame_->is_same_line = true;
  ImGui::SameLine(0.0F, gap < 0.0 ? frame_->d(8) : narrow(gap));
}

void Ui::space(double height) {
  frame_->is_same_line = false;
  const float taken = height < 0.0 ? frame_->d(8) : narrow(height);
  ImGui::ItemSize({0.0F, taken});
}

void Ui::line() {
  Frame& frame = *frame_;
  frame.is_same_line = false;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float y = std::floor(at.y + frame.d(4));
  frame.fill({{at.x, y}, {at.x + frame.room_width(), y + 1.0F}}, frame.state.look.line, 0.0);
  ImGui::ItemSize({0.0F, 2.0F * frame.d(4) + 1.0F});
}

/// After same_line(), or at the beginning of a line.
void Ui::right_align(double width) {
  const ImGuiWindow* const window = ImGui::GetCurrentWindow();
  if (!frame_->is_same_line) {  // a line begins here: nothing of another one lies on it
    frame_->line_height = 0.0F;
    frame_->line_texts.clear();
  }
  frame_->is_same_line = true;
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const float wanted = right - narrow(width);
  ImGui::SetCursorScreenPos({std::max(wanted, window->Pos.x), ImGui::GetCursorScreenPos().y});
}

Scope Ui::label_width(double width) {
  Frame& frame = *frame_;
  frame.label_widths.push_back(width);
  return {true, [&frame] { frame.label_widths.pop_back(); }};
}

void Ui::next_width(double width) { frame_->next_width = narrow(width); }

}  // namespace nadir::kit
