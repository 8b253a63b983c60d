// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/require.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr double kRowHeight = 28.0;

/// Digits after the point of a text, as wide as they are: what a number lacks to its column's most.
int digits_after_point(const std::string& digits) {
  const std::size_t point = digits.find('.');
  if (point == std::string::npos) return 0;
  const std::size_t end = digits.find_first_not_of("0123456789", point + 1);
  return static_cast<int>((end == std::string::npos ? digits.size() : end) - point - 1);
}

}  // namespace

Scope Ui::table(const std::string& name,
                std::span<const Column> columns,
                const TableOptions& options) {
  NADIR_REQUIRE(!columns.empty());
  Frame& frame = *frame_;
  frame.is_same_line = false;
  ImGuiTableFlags flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings |
                          ImGuiTableFlags_NoBordersInBody | ImGuiTableFlags_PadOuterX;
  if (options.height > 0.0) flags |= ImGuiTableFlags_ScrollY;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(frame.d(options.is_dense ? 4 : 8), 0.0F));
  const bool is_open = ImGui::BeginTable(name.c_str(), static_cast<int>(columns.size()), flags,
                                         {0.0F, narrow(options.height)});
  ImGui::PopStyleVar();
  if (!is_open) return {};
  const ImGuiTable* const imgui_table = ImGui::GetCurrentTable();
  const ImRect outer = imgui_table->OuterRect;
  frame.is_last_hovered = false;
  frame.note(ControlKind::kTable, name, outer);
  for (const Column& column : columns) {
    ImGui::TableSetupColumn(
        column.title.c_str(),
        column.width > 0.0 ? ImGuiTableColumnFlags_WidthFixed : ImGuiTableColumnFlags_WidthStretch,
        column.width > 0.0 ? narrow(column.width) : 1.0F);
  }
  Frame::OpenTable open;
  open.columns = {columns.begin(), columns.end()};
  open.is_only_read = options.is_only_read;
  open.prefix_length = frame.prefix.size();
  frame.prefix += name + "/";
  frame.sorting.reset();
  frame.tables.push_back(std::move(open));
  if (options.has_header) {
    ImGui::TableSetupScrollFreeze(0, 1);
    frame.draw_table_header(options.is_sortable);
  }
  return {true, [&frame] {
            frame.end_row();
            frame.prefix.resize(frame.tables.back().prefix_length);
            frame.tables.pop_back();
            ImGui::EndTable();
          }};
}

void Ui::Frame::draw_table_header(bool is_sortable) {
  OpenTable& table = tables.back();
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, d(26));
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (!ImGui::TableSetColumnIndex(static_cast<int>(i))) continue;
    const Column& column = table.columns[i];
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImRect box(at, {at.x + room_width(), at.y + d(26)});
    const ImGuiID id = ImGui::GetCurrentWindow()->GetID(column.title.c_str());
    ImGui::ItemSize(box.GetSize());
    add_part(box, id);
    const Pressed pressed = is_sortable ? press(box, id) : Pressed{};
    if (!is_sortable) is_last_hovered = ImGui::IsItemHovered();
    write_in(box, shown(column.title), state.fonts->text,
             shade(pressed.is_hovered ? state.look.text : state.look.muted), column.align);
    note(ControlKind::kColumn, column.title, box);
    explain(column.hint);
    if (pressed.was_clicked) {
      ImGuiStorage* const storage = ImGui::GetStateStorage();
      const bool is_descending = !storage->GetBool(id, true);
      storage->SetBool(id, is_descending);
      sorting = Sorting{i, is_descending};
    }
  }
  const ImRect work = ImGui::GetCurrentTable()->WorkRect;
  const float bottom = ImGui::GetCurrentTable()->RowPosY1 + d(26);
  ImGui::GetCurrentTable()->InnerWindow->DrawList->AddLine(
      {work.Min.x, bottom - 0.5F}, {work.Max.x, bottom - 0.5F}, state.look.line);
}

void Ui::Frame::end_row() {
  OpenTable& table = tables.back();
  if (table.row_path.empty()) return;
  ImGui::PopID();
  table.row_path.clear();
  prefix.resize(table.table_prefix_length);
}

RowInput Ui::row(const std::string& name, bool is_selected) {
  Frame& frame = *frame_;
  NADIR_REQUIRE(!frame.tables.empty());
  frame.end_row();
  frame.is_same_line = false;
  Frame::OpenTable& table = frame.tables.back();
  ImGui::TableNextRow(ImGuiTableRowFlags_None, frame.d(kRowHeight));
  ImGui::TableSetColumnIndex(0);
  const ImGuiTable* const imgui_table = ImGui::GetCurrentTable();
  const float top = imgui_table->RowPosY1;
  const ImRect box({imgui_table->WorkRect.Min.x, top},
                   {imgui_table->WorkRect.Max.x, top + frame.d(kRowHeight)});
  const ImGuiID id = ImGui::GetCurrentWindow()->GetID(name.c_str());
  // Over all columns: neither clipped to the first nor drawn into its layer.
  ImGui::TablePushBackgroundChannel();
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  const ImRect clip = window->ClipRect;
  window->ClipRect = imgui_table->BgClipRect;
  frame.add_part(box, id);
  const RowInput input = frame.press_row(
      box, id,
      {.takes_press = !table.is_only_read, .group = imgui_table->ID, .is_selected = is_selected});
  Control& control = frame.note(ControlKind::kRow, name, box);
  control.is_selected = is_selected;
  window->ClipRect = clip;
  ImGui::TablePopBackgroundChannel();
  table.row_box = box;
  table.column = -1;
  table.row_path = name;
  table.table_prefix_length = frame.prefix.size();
  frame.prefix += name + "/";
  ImGui::PushID(name.c_str());
  return input;
}

ImRect Ui::Frame::next_cell() {
  NADIR_REQUIRE(!tables.empty());
  OpenTable& table = tables.back();
  ++table.column;
  NADIR_REQUIRE(table.column < static_cast<int>(table.columns.size()));
  ImGui::TableSetColumnIndex(table.column);
  is_same_line = false;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  return {at, {at.x + room_width(), at.y + d(kRowHeight)}};
}

void Ui::Frame::text_cell(
    const std::string& words, ImFont* the_font, ImU32 the_colour, bool is_number, Icon icon) {
  const ImRect box = next_cell();
  const Column& column = tables.back().columns[static_cast<std::size_t>(tables.back().column)];
  ImGui::ItemSize(box.GetSize());
  ImGui::ItemAdd(box, 0);
  is_last_hovered = ImGui::IsItemHovered();
  ImRect inside = box;
  if (icon != Icon::kNone) {
    write_icon({inside.Min, {inside.Min.x + d(18), inside.Max.y}}, icon, shade(the_colour));
    inside.Min.x += d(26);
  }
  if (column.align == Align::kDecimal && is_number) {
    const int lacking = column.decimals - digits_after_point(words);
    const bool lacks_point = words.find('.') == std::string::npos && column.decimals > 0;
    inside.Max.x -= text_size("0", state.fonts->numbers).x *
                    static_cast<float>(std::max(0, lacking) + (lacks_point ? 1 : 0));
  }
  const bool is_whole = write_in(inside, words, the_font, shade(the_colour), column.align);
  note(ControlKind::kCell, column.title, box).value = words;
  if (!is_whole) explain({words, ""}, true);
}

void Ui::cell(const std::string& text, TextLook look) {
  frame_->text_cell(text, frame_->font(look), frame_->colour(look), false);
}

void Ui::icon_cell(Icon icon, const std::string& text, TextLook look) {
  frame_->text_cell(text, frame_->font(look), frame_->colour(look), false, icon);
}

void Ui::number_cell(const std::string& digits, TextLook look) {
  Frame& frame = *frame_;
  frame.text_cell(digits, frame.state.fonts->numbers, frame.colour(look), true);
}

void Ui::bar_cell(double share, Rgba colour, const std::string& digits) {
  Frame& frame = *frame_;
  if (std::isnan(share)) return cell("");
  const ImRect box = frame.next_cell();
  const Column& column =
      frame.tables.back().columns[static_cast<std::size_t>(frame.tables.back().column)];
  ImGui::ItemSize(box.GetSize());
  ImGui::ItemAdd(box, 0);
  frame.is_last_hovered = ImGui::IsItemHovered();
  const float number = frame.text_size("100 %", frame.state.fonts->numbers).x + frame.d(6);
  ImRect track = box;
  track.Max.x = std::max(track.Min.x + 1.0F, track.Max.x - number);
  track.Expand({0.0F, -frame.d(11)});
  frame.fill(track, frame.shade(frame.state.look.faint), 2.0);
  ImRect done = track;
  done.Max.x = track.Min.x + track.GetWidth() * narrow(std::clamp(share, 0.0, 1.0));
  if (done.GetWidth() >= 0.5F) frame.fill(done, frame.shade(packed(colour)), 2.0);
  frame.write_in({{box.Max.x - number, box.Min.y}, box.Max}, digits, frame.state.fonts->numbers,
                 frame.shade(frame.state.look.text), Align::kRight);
  frame.note(ControlKind::kCell, column.title, box).value = digits;
}

void Ui::control_cell() { frame_->next_cell(); }

void Ui::clipped_table_rows(std::size_t count, const std::function<void(std::size_t)>& draw_row) {
  Frame& frame = *frame_;
  frame.end_row();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(count), frame.d(kRowHeight));
  frame.draw_end(clipper, count);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(static_cast<std::size_t>(i));
    frame.end_row();
  }
  clipper.End();
}

std::optional<Ui::Sorting> Ui::sorting() const { return frame_->sorting; }

void Ui::keep_row_in_sight(std::size_t row) {
  const Frame& frame = *frame_;
  ImGuiWindow* const window = ImGui::GetCurrentWindow();
  const float height = frame.d(kRowHeight);
  const float top = narrow(static_cast<double>(row)) * height;  // below a header that stays
  const float room = window->InnerRect.GetHeight() - frame.d(26);
  if (top < window->Scroll.y) ImGui::SetScrollY(top);
  if (top + height > window->Scroll.y + room) ImGui::SetScrollY(top + height - room);
}

}  // namespace nadir::kit
