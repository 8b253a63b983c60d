// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "widgets/kit/control.h"
#include "widgets/kit/ui_parts.h"
#include "widgets/views/theme.h"

namespace nadir::kit {

class UiContext;

/// What panels draw with, for one frame (UiContext::begin_frame). Things follow each other downwards unless same_line() says
/// otherwise; every control is noted with its path, the scopes it lies in and its label joined by '/'. Labels are unique
/// within their scope. A label such as "Open…##second" shows and is found as all before "##" only if that is not empty, and its
/// path has all of it.
///
/// Values go in and come out: nothing is kept here but what the user is doing at this moment (and which sections are open).
/// All lengths are pixels of the window; px() makes them from those of the design.
class Ui {
 public:
  explicit Ui(UiContext& context);
  ~Ui();
  Ui(const Ui&) = delete;
  Ui& operator=(const Ui&) = delete;

  // ---- Scopes and look ----
  /// Everything drawn until it is closed has `name/` in its path. Draws nothing, always true.
  Scope scope(const std::string& name);
  /// While `is_disabled`, controls are pale, do nothing, and their tooltip says why. Always true.
  Scope disabled(bool is_disabled, const std::string& because);
  [[nodiscard]] const Theme& theme() const;
  [[nodiscard]] ThemeName theme_name() const;
  /// Pixels of the window for a length of the design (which is drawn for scale 1).
  [[nodiscard]] double px(double design_length) const;
  [[nodiscard]] double scale() const;
  [[nodiscard]] bool is_motion_reduced() const;
  /// The whole window.
  [[nodiscard]] Rect screen() const;

  // ---- Places (ui_layout.cpp) ----
  /// What is left for content here, from the place of the next control to the region's, column's or scroll area's end.
  [[nodiscard]] Rect room() const;
  /// A part of the window with content of its own, at a place that the caller computes. Regions do not overlap, but for those
  /// that are `is_above`. Pushes `name` as scope.
  Scope region(const std::string& name, const Rect& rect, const RegionStyle& style = {});
  /// A part of the region that scrolls. @param height  <= 0: what is left, less that. Pushes no scope.
  Scope scroll_area(const std::string& name, double height = 0.0);
  /// Draws only those of many rows of the same height that can be seen.
  void clipped_rows(std::size_t count,
                    double row_height,
                    const std::function<void(std::size_t)>& draw_row);
  /// A row of cells beside each other, widths by weight; begin with the first, then next_column(). Pushes no scope.
  Scope columns(const std::string& name, const std::vector<double>& weights);
  void next_column();
  void same_line(double gap = -1.0);  ///< < 0: 8 of the design.
  void space(double height = -1.0);   ///< < 0: 8 of the design.
  /// A thin line across.
  void line();
  /// On the current line, so far right that what follows and is so wide ends at the right edge.
  void right_align(double width);
  /// Width of the labels left of sliders, combos and inputs; 0: none, the label stands above. < 0: nearly half, the default.
  Scope label_width(double width);
  /// Width of what is drawn next (inputs, combos, buttons); 0: their own.
  void next_width(double width);
  /// A handle between two things beside (kHorizontal: it moves left and right) or above each other.
  /// @param rect  Of the handle in the window. @param size  What it changes; grows to the right or down, unless
  /// `grows_backwards` (what is sized lies right of or under the handle).
  Edit<double> splitter(const std::string& name,
                        const Rect& rect,
                        Axis axis,
                        double size,
                        double least,
                        double most,
                        bool grows_backwards = false);
  /// The same inside a region, across it, at the current place, 8 high: moves up and down.
  Edit<double> splitter(const std::string& name, double size, double least, double most);
  /// A panel above everything, darkening the rest: palette, sheets. Pushes `name` as scope.
  Overlay overlay(const std::string& name, const OverlayStyle& style = {});

  // ---- Words (ui_text.cpp) ----
  void text(const std::string& line, TextLook look = TextLook::kNormal);
  void wrapped(const std::string& words, TextLook look = TextLook::kNormal);
  /// Cut with "…" where there is no more room (before `reserve`); its tooltip then has all of it.
  void cut_text(const std::string& line, TextLook look = TextLook::kNormal, double reserve = 0.0);
  void heading(const std::string& line);
  /// A number that was formatted by the caller, with its unit in muted text.
  void number(const std::string& digits,
              const std::string& unit = {},
              TextLook look = TextLook::kNumber);
  /// A read-out: label in muted text at the left, number or words at the right. `value` is its text as a Control.
  void read_out(const std::string& label,
                const std::string& digits,
                const std::string& unit = {},
                const Hint& hint = {},
                TextLook look = TextLook::kNumber);
  void icon(Icon icon, TextLook look = TextLook::kMuted);
  /// A dot or short line in the colour of a run, before its name.
  void colour_dot(Rgba colour);
  /// What an empty panel says: icon, sentence, and the one button that fills it. True when that is clicked. @param button
  /// Empty: none.
  bool empty_state(Icon icon,
                   const std::string& sentence,
                   const std::string& button = {},
                   const std::string& shortcut = {});
  /// Width that a line of text takes.
  [[nodiscard]] double text_width(const std::string& line, TextLook look = TextLook::kNormal) const;
  /// Adds a tooltip to the control (or text) drawn last.
  void hint(const Hint& hint);

  // ---- Buttons and choices (ui_buttons.cpp); true or a value only in the frame of the click ----
  /// One that has no room behind others on its line begins the next.
  bool button(const std::string& label,
              ButtonLook look = ButtonLook::kNormal,
              const Hint& hint = {},
              Icon icon = Icon::kNone);
  /// Its label is `name`; the tooltip must have a text. @param is_on  Drawn as switched on.
  bool icon_button(const std::string& name,
                   Icon icon,
                   const Hint& hint,
                   bool is_on = false,
                   ButtonLook look = ButtonLook::kQuiet);
  /// A word to click at in the running text.
  bool link(const std::string& label, const Hint& hint = {});
  std::optional<bool> checkbox(const std::string& label, bool is_on, const Hint& hint = {});
  /// An eye that is open or not. Its label is `name`, which does not show.
  std::optional<bool> eye(const std::string& name, bool is_on, const Hint& hint = {});
  /// Beside each other, one of them chosen. Paths are "label/item". An empty label (before "##") shows none.
  std::optional<std::size_t> choice(const std::string& label,
                                    std::span<const std::string> items,
                                    std::size_t chosen,
                                    const Hint& hint = {});
  /// Radio buttons under each other. Paths as above.
  std::optional<std::size_t> radio(const std::string& label,
                                   std::span<const std::string> items,
                                   std::size_t chosen);
  /// A list that opens. Paths of the items, while it is open, are "label/item".
  std::optional<std::size_t> combo(const std::string& label,
                                   std::span<const std::string> items,
                                   std::size_t chosen,
                                   const Hint& hint = {});
  /// Tabs across, in several rows where they do not fit into one; draws no content. Paths are "name/tab".
  std::optional<std::size_t> tabs(const std::string& name,
                                  std::span<const std::string> titles,
                                  std::size_t chosen);
  /// Tools under each other, as many as fit into `height`; the others are in a menu below them ("More"). Paths are those of
  /// the tools' names. Gives the place of the tool that was clicked.
  std::optional<std::size_t> tool_column(std::span<const Tool> tools, double height);
  /// How much of `height` it takes.
  [[nodiscard]] double tool_column_height(std::span<const Tool> tools, double height) const;
  /// The workspaces' rail: an icon with a word under it.
  bool rail_button(const std::string& name, Icon icon, const Hint& hint, bool is_chosen);
  /// A swatch; a click opens a picker with sliders and hexadecimal digits. Paths of those begin with "label/".
  Edit<Rgba> colour(const std::string& label, Rgba colour, const Hint& hint = {});

  // ---- Numbers and inputs (ui_numbers.cpp, ui_inputs.cpp) ----
  /// Track and number field. The track's path is the label's, the field's is "label/value".
  Edit<double> slider(const std::string& label, double value, const NumberOptions& options);
  /// A field that is dragged sideways; typed into after Ctrl and click, double click or Enter; stepped by the arrow keys once it was
  /// clicked.
  Edit<double> number_input(const std::string& label, double value, const NumberOptions& options);
  /// A track alone, without label and number, as wide as the room or next_width(): opacity in a row. The name is its path.
  Edit<double> small_slider(const std::string& name, double value, const NumberOptions& options);
  TextEdit text_input(const std::string& label,
                      const std::string& text,
                      const TextOptions& options = {});
  /// With a magnifying glass in it, and a button ("name/Clear") that empties it. `value` is live; it commits as it changes.
  TextEdit search_input(const std::string& name,
                        const std::string& text,
                        const TextOptions& options = {});
  /// @param share  0 to 1; NaN where nobody knows. @param words  "12 s left". Returns whether Cancel ("name/Cancel") was clicked.
  bool progress(const std::string& name,
                double share,
                const std::string& words,
                bool can_cancel = true);
  /// A grip that moves its row up and down a list; draw it first in the row. `value` is the place the row wants.
  Edit<std::size_t> grip(const std::string& name,
                         std::size_t place,
                         std::size_t count,
                         double row_height);

  // ---- Lists and tables (ui_rows.cpp, ui_tables.cpp) ----
  /// A row across that can be chosen, 28 high. Controls may follow with same_line() and right_align(): they lie on it.
  RowInput list_row(const std::string& name, const ListRow& row = {});
  /// A part that folds at a click on its heading. Pushes `label` as scope.
  Scope section(const std::string& label,
                bool is_open_at_first = true,
                const std::string& detail = {});
  /// `if (const auto table = ui.table(…)) for (…) { ui.row(…); ui.cell(…); … }`. Pushes `name` as scope.
  Scope table(const std::string& name,
              std::span<const Column> columns,
              const TableOptions& options = {});
  /// Rows of which only those in sight are drawn: call row() and the cells in `draw_row`.
  void clipped_table_rows(std::size_t count, const std::function<void(std::size_t)>& draw_row);
  /// Begins the next row. Its path is "table/name"; those of cells "table/name/title of the column".
  RowInput row(const std::string& name, bool is_selected = false);
  void cell(const std::string& text, TextLook look = TextLook::kNormal);
  /// The same after an icon; words of all rows begin below each other.
  void icon_cell(Icon icon, const std::string& text, TextLook look = TextLook::kNormal);
  void number_cell(const std::string& digits, TextLook look = TextLook::kNumber);
  /// A bar from the cell's left with its number. @param share  0 to 1; NaN gives an empty cell.
  void bar_cell(double share, Rgba colour, const std::string& digits);
  /// Begins a cell that the caller fills with controls; they have the row's path as scope until the next cell or row.
  void control_cell();
  /// The column and direction that a sortable table was clicked for; in the frame of the click.
  struct Sorting {
    std::size_t column = 0;
    bool is_descending = false;
  };
  [[nodiscard]] std::optional<Sorting> sorting() const;
  /// Scrolls a table of a height of its own so that a row can be seen, for those who go through it by keys.
  void keep_row_in_sight(std::size_t row);

  // ---- Menus and notices (ui_menus.cpp) ----
  /// Menus beside each other, at the current place of a region; other controls may follow with same_line(). Pushes no scope.
  Scope menu_bar();
  /// Of a menu bar, or within another menu. Pushes its label as scope while it is open.
  Scope menu(const std::string& label);
  bool menu_item(const std::string& label, const MenuItem& item = {});
  void menu_line();
  /// A menu that a click of the right button on the control drawn last opens (not at the end of a drag), or Shift+F10 while that
  /// has the keyboard. Pushes `name` as scope.
  Scope context_menu(const std::string& name);
  /// The control drawn last opens it as well: another part of the same row. Call it before context_menu(), in the same scope.
  void opens_context_menu(const std::string& name);
  /// A menu that a button opens. Pushes `name` as scope.
  Scope button_menu(const std::string& name, Icon icon, const Hint& hint);
  /// Above each other in the lower right corner of `inside`; the newest is the last. They stay until dismissed, and cover nothing of
  /// an overlay that was drawn before: they are narrower beside it, or lie below it. Paths:
  /// "Notices/ID", "Notices/ID/Dismiss", "/Details", "/Copy" and "/" with the title of the action.
  std::optional<NoticeWish> notices(std::span<const Notice> notices, const Rect& inside);

  // ---- Free areas (ui_areas.cpp) ----
  /// A part to draw on, with the mouse's doings in it. @param size  0: what is left.
  AreaInput area(const std::string& name,
                 const Eigen::Vector2d& size = Eigen::Vector2d::Zero(),
                 Wheel wheel = Wheel::kOwn);
  /// Draws on the area made last, clipped to it. Valid until the next area, or the end of the frame.
  [[nodiscard]] Canvas& canvas();
  /// Fills the area made last, or a part of its page, with a texture of OpenGL. @param is_bottom_row_first  As OpenGL renders.
  void image(TextureId texture, bool is_bottom_row_first = true);
  void image(TextureId texture, const PageRect& where, bool is_bottom_row_first = true);
  /// A tooltip at the mouse, whatever lies under it: a chart's or map's read-out. The first line is its heading.
  void mouse_tooltip(std::span<const std::string> lines);

  // ---- Keys ----
  /// The chord went down in this frame (or repeats). False while it belongs to something else: letters while a text is
  /// typed, arrows while a number has them, Escape while a menu is open, Space and Enter while a control has the keyboard.
  ///
  /// Shift+Tab (in boxes and menus also Tab) gives the keyboard to a control, which then has a frame; Tab and Shift+Tab go on,
  /// Ctrl+Tab to the next region, arrows among choices, tabs, rows and menus. Space and Enter press it, arrows change it,
  /// Delete resets it, Shift+F10 opens its menu. Escape, or the mouse, gives the keyboard back to the window.
  [[nodiscard]] bool is_pressed(const Chord& chord, bool with_repeats = false) const;
  /// The same of its text, "Ctrl+P"; false for what is no chord.
  [[nodiscard]] bool is_pressed(std::string_view chord, bool with_repeats = false) const;
  /// Text is being typed: keys are characters.
  [[nodiscard]] bool wants_text() const;
  /// The mouse is over something of ours that is not an area, or holds something.
  [[nodiscard]] bool wants_mouse() const;
  /// What the user copied last, here or in another program.
  [[nodiscard]] std::string clipboard() const;
  /// Paths of the sections that are not as they are at first, for they were clicked at; rising. To be kept from one start to
  /// the next, and given back before anything is drawn.
  [[nodiscard]] std::vector<std::string> turned_sections() const;
  void set_turned_sections(std::span<const std::string> paths);
  /// A button of the mouse is down, or a text is being typed: what changes belongs to one doing.
  [[nodiscard]] bool is_holding() const;
  [[nodiscard]] Modifiers modifiers() const;

  /// All controls of this frame so far.
  [[nodiscard]] const std::vector<Control>& controls() const;

  /// Kit's own sources work on this; not for panels.
  struct Frame;
  [[nodiscard]] Frame& frame() { return *frame_; }

 private:
  std::unique_ptr<Frame> frame_;
};

}  // namespace nadir::kit
