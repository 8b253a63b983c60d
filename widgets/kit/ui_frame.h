// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "widgets/kit/ui_state.h"

/// What kit's own sources share to draw a frame. With ui_state.h the only header of kit that knows Dear ImGui; included by no
/// panel.
namespace nadir::kit {

class UiCanvas;

[[nodiscard]] inline float narrow(double value) { return static_cast<float>(value); }
[[nodiscard]] inline ImVec2 im(const Eigen::Vector2d& point) {
  return {narrow(point.x()), narrow(point.y())};
}
[[nodiscard]] inline Rect rect_of(const ImRect& box) {
  return {box.Min.x, box.Min.y, box.GetWidth(), box.GetHeight()};
}
[[nodiscard]] inline ImRect box_of(const Rect& rect) {
  return {narrow(rect.left), narrow(rect.top), narrow(rect.right()), narrow(rect.bottom())};
}

/// A tooltip that the mouse asks for in this frame.
struct TooltipWish {
  std::string path;
  Hint hint;
  std::string because;             ///< Why the control is disabled.
  std::vector<std::string> lines;  ///< Of mouse_tooltip(), shown at once.
  std::optional<ImRect> beside;    ///< What it must not cover; none: it stands at the mouse.
  bool is_by_mouse = false;  ///< Its left end is where the mouse is, else where `beside` begins.
};

/// Where a control lies: the whole of it in `box`; `label` beside or above `field`.
struct Placed {
  ImGuiID id = 0;
  ImRect box, label, field;
  bool is_visible = false;
};

struct Pressed {
  bool was_clicked = false, is_hovered = false, is_held = false;
};

/// One frame's drawing; all members are kit's own.
struct Ui::Frame {
  explicit Frame(UiContext& the_context) : context(the_context), state(the_context.state()) {}
  ~Frame();

  UiContext& context;
  UiContext::State& state;
  std::vector<Control> controls;
  std::string prefix;  ///< Of paths: "Layers/particles/".
  std::vector<std::string> disabled_reasons;
  std::vector<double> label_widths;
  std::optional<TooltipWish> tooltip;
  float next_width = 0.0F;
  bool is_same_line = false;  ///< What is placed next follows on the current line.
  float line_height = 0.0F;   ///< Of what lies on the current line.

  // Walking with the keyboard (ui_focus.cpp).
  Stops drawn_stops;             ///< So far in this frame.
  int boxes = 0, box_depth = 0;  ///< Drawn so far; the one that is being drawn, 0: none.
  std::vector<ImRect> box_places;
  ImGuiWindow* lowest_box = nullptr;  ///< What darkens the window below the first box.
  int top_layer = 0;
  ImGuiID top_box = 0;
  ImGuiID focus_before = 0;        ///< Where the keyboard was when the frame began.
  bool is_noting_focused = false;  ///< Of what note() writes down next.
  struct Ring {
    ImGuiWindow* window = nullptr;
    ImRect box, clip;
    bool is_on_accent = false;
  };
  std::optional<Ring> ring;

  ImGuiID last_id = 0;
  bool is_last_hovered = false;
  ImRect last_box;

  /// Texts at the beginning of the line, which move down where something higher follows on it.
  struct LineText {
    ImDrawList* list = nullptr;
    int first_vertex = 0, end_vertex = 0;
    std::size_t control = 0;
    float top = 0.0F, height = 0.0F;
  };
  std::vector<LineText> line_texts;

  struct OpenTable {
    std::vector<Column> columns;
    bool is_only_read = false;
    int column = -1;       ///< Drawn last in this row.
    std::string row_path;  ///< Of the row whose cells are drawn.
    std::size_t prefix_length = 0, table_prefix_length = 0;
    ImRect row_box;
  };
  std::vector<OpenTable> tables;
  std::optional<Sorting> sorting;

  bool is_in_menu_bar = false, has_bar_menu = false;
  int menu_depth = 0;
  std::pair<ImGuiID, ImVec2> menu_by_key = {};  ///< Opened in this frame, and where; 0: none.

  Rect area;
  ImDrawList* area_list = nullptr;
  std::unique_ptr<UiCanvas> canvas;

  [[nodiscard]] float d(double design) const {
    return narrow(std::max(1.0, std::floor(design * state.scale + 0.5)));
  }
  [[nodiscard]] ImFont* font(TextLook look) const;
  [[nodiscard]] ImU32 colour(TextLook look) const;
  [[nodiscard]] bool is_disabled() const { return !disabled_reasons.empty(); }
  /// A colour of the look, paler within disabled().
  [[nodiscard]] ImU32 shade(ImU32 colour) const;

  /// What stands before "##".
  [[nodiscard]] static std::string shown(const std::string& label);
  /// Width of all that is left on this line.
  [[nodiscard]] float room_width() const;
  [[nodiscard]] ImVec2 text_size(const std::string& line, ImFont* font) const;

  /// Takes room at the current place.
  /// @param gap  Below it, where it begins a line.
  Placed place(const std::string& label, const ImVec2& size, float gap, bool is_text = false);
  /// Takes a row of the room's width (or the next width), with its label at the left or above.
  Placed place_labelled(const std::string& label, float height);
  /// Makes another box of this control its field: the part that takes the mouse.
  bool add_part(const ImRect& box, ImGuiID id);
  Pressed press(const Placed& placed, ImGuiButtonFlags flags = 0, const Stop& stop = {});
  Pressed press(const ImRect& box, ImGuiID id, ImGuiButtonFlags flags = 0, const Stop& stop = {});

  /// Moves the keyboard's focus as the keys say, before anything is drawn.
  void begin_focus();
  void move_focus();
  void go_to_end();
  [[nodiscard]] bool ends_by_escape();
  void walk_by_tab(const Stops& stops, const Modifiers& held);
  [[nodiscard]] bool walk_through_menus();
  void arrive_at(const PlacedStop& stop);
  /// What cannot be pressed just now but can have the keyboard: an input that is typed into.
  void add_stop(const ImRect& box, ImGuiID id, const Stop& stop);
  /// It has its frame and its keys.
  [[nodiscard]] bool has_focus(ImGuiID id) const;
  [[nodiscard]] bool has_arrived(ImGuiID id) const;
  [[nodiscard]] bool is_pressed_by_key(ImGuiID id) const;
  /// Of arrows that a control takes itself: right and up count 1, left and down -1.
  [[nodiscard]] int arrow_steps(ImGuiID id, Arrows arrows) const;
  /// The chord is none of the window's in this frame.
  [[nodiscard]] bool takes_key(const Chord& chord) const;
  /// Draws the frame around what has the keyboard and keeps what was drawn for the next frame.
  void end_focus();
  void change_layer();
  /// Has a list that draws only what is in sight draw the end that the keyboard goes to.
  void draw_end(ImGuiListClipper& clipper, std::size_t count) const;
  void draw_label(const Placed& placed, const std::string& label, bool is_marked = false);

  /// Writes a control down; the returned one may be completed until the next.
  Control& note(ControlKind kind, const std::string& label, const ImRect& box);
  /// Tooltip of the control noted last; also why it is disabled. What merely repeats the control's label is left out, unless
  /// the label `was_cut`.
  void explain(const Hint& hint, bool was_cut = false);
  void wish_tooltip(const Control& control, const Hint& hint);
  void show_tooltip();
  /// What stands right under a control and says what is wrong with it, drawn last: the control's tooltip keeps clear of it.
  void keep_tooltip_clear_of(TextLook look);

  void write(const ImVec2& at, const std::string& line, ImFont* font, ImU32 colour) const;
  /// Vertically in the middle of the box; cut with "…" where it is wider. @returns whether all of it was drawn.
  bool write_in(const ImRect& box,
                const std::string& line,
                ImFont* font,
                ImU32 colour,
                Align align = Align::kLeft) const;
  void write_icon(const ImRect& box, Icon icon, ImU32 colour) const;
  void fill(const ImRect& box, ImU32 colour, double radius = 4.0) const;
  void frame(const ImRect& box, ImU32 colour, double radius = 4.0) const;

  [[nodiscard]] Draft* draft(ImGuiID id);
  Draft& begin_draft(ImGuiID id);
  void end_draft();

  [[nodiscard]] std::optional<Draft> take_abandoned(ImGuiID id);
  /// Dear ImGui's input for the draft of this control, which takes the keyboard at first. @returns whether it has it still.
  bool type_draft(
      const ImRect& box, ImGuiID id, const std::string& label, ImFont* the_font, int flags);
  TextEdit edit_text(const ImRect& box,
                     ImGuiID id,
                     const std::string& label,
                     const std::string& text,
                     const TextOptions& options);
  TextEdit edit_lines(const ImRect& box, const std::string& label, const std::string& text);

  Edit<double> finish_number(ImGuiID id, double value, Edit<double> edit, bool is_done);
  [[nodiscard]] bool reset_clicked(const Placed& placed) const;
  [[nodiscard]] bool is_label_hovered(const Placed& placed) const;
  [[nodiscard]] std::optional<double> number_by_keys(ImGuiID id,
                                                     double value,
                                                     const NumberOptions& options) const;
  /// Of what type_draft() has just drawn.
  void put_caret_at_end(ImGuiID id) const;
  Edit<double> drag_track(const ImRect& box,
                          ImGuiID id,
                          double value,
                          const NumberOptions& options);
  Edit<double> edit_number(const ImRect& box,
                           ImGuiID id,
                           const std::string& label,
                           double value,
                           const NumberOptions& options);
  Edit<double> type_number(const ImRect& box,
                           ImGuiID id,
                           const std::string& label,
                           double value,
                           const NumberOptions& options);

  RowInput press_row(const ImRect& box, ImGuiID id, Stop stop);
  [[nodiscard]] bool right_clicked() const;
  void draw_table_header(bool is_sortable);
  void end_row();
  ImRect next_cell();
  void text_cell(const std::string& words,
                 ImFont* the_font,
                 ImU32 the_colour,
                 bool is_number,
                 Icon icon = Icon::kNone);
  Scope open_popup(ImGuiID id, const std::string& name);
  std::optional<NoticeWish::Kind> draw_notice(Ui& ui,
                                              const Notice& notice,
                                              Icon icon,
                                              ImU32 the_colour);

  Edit<Rgba> draw_picker(Ui& ui, Rgba the_colour);
  void follow_press(const ImRect& box, ImGuiID id, AreaInput& input);

  Scope push_scope(const std::string& name, bool with_imgui_id);
  Edit<double> drag_splitter(const std::string& name,
                             const ImRect& box,
                             Axis axis,
                             double size,
                             double least,
                             double most,
                             bool grows_backwards);
  void shift_line_texts(float height);
  Placed place_text(const std::string& line, ImFont* the_font, float most_width);
  void keep_line_text(const Placed& placed, int first_vertex);
};

}  // namespace nadir::kit
