// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/desk/image_tool.h"
#include "core/desk/label_selection.h"
#include "core/desk/label_sheet.h"
#include "core/desk/tool_points.h"
#include "core/edit/edit_objects.h"
#include "core/edit/edit_vertices.h"
#include "core/edit/street_profile.h"

namespace nadir {

/// A corner that was picked, and where it was.
struct PickedVertex {
  VertexRef at;
  Eigen::Vector2d in_enu_m = Eigen::Vector2d::Zero();
};

/// What lies at a place.
struct UnderPlace {
  bool is_on_grid = false;
  ClassId class_id = kUnclassified;  ///< As the raster shows it.
  std::optional<ObjectId> object;    ///< The top-most whose border or inside it is.
  PaintValue paint = kNoPaint;
};

/// Everything that a labelling window and its scripts do, without a window: a sheet, the tool at work, and what is selected.
/// Each finished gesture is one method and one step of the history, on disk when it returns. On errors, one sentence each,
/// nothing has changed, and a tool keeps its places. One thread.
class LabelDesk {
 public:
  /// @param named  A map package, a labelling document or an overhead image. @errors as LabelSheet::open().
  [[nodiscard]] static Result<LabelDesk> open(const std::filesystem::path& named,
                                              const std::string& author,
                                              const LabelOpening& how = {});

  [[nodiscard]] const LabelSheet& sheet() const { return sheet_; }
  [[nodiscard]] Result<std::vector<std::string>> poll();  ///< As LabelSheet::poll().
  bool count_more(int most_tiles) { return sheet_.count_more(most_tiles); }
  [[nodiscard]] Result<void> flush() { return sheet_.flush(); }
  [[nodiscard]] UnderPlace under(const Eigen::Vector2d& point_in_enu_m) const;

  // Undo. While a tool has places these take back the last of them, and give it again.
  [[nodiscard]] std::optional<std::string> undo_title() const;
  [[nodiscard]] std::optional<std::string> redo_title() const;
  [[nodiscard]] Result<void> undo();
  [[nodiscard]] Result<void> redo();
  [[nodiscard]] Result<void> go_to(std::int64_t step);

  // The tool at work (label_desk_tool.cpp).
  [[nodiscard]] const LabelTool& tool() const { return tool_; }
  /// Another kind drops the places that the last one got. @errors kInvalidOptions: as validate().
  [[nodiscard]] Result<void> set_tool(const LabelTool& tool);
  void set_profiles(std::vector<StreetProfile> profiles) { profiles_ = std::move(profiles); }
  [[nodiscard]] const std::vector<StreetProfile>& profiles() const { return profiles_; }
  [[nodiscard]] const ToolPoints& points() const { return points_; }
  void type_leg(const TypedLeg& leg) { points_.type(leg); }
  /// Where the next place would come, and what to. @param reach_m  A few pixels, by the zoom.
  [[nodiscard]] ToolPoint aim(const Eigen::Vector2d& hand_in_enu_m, double reach_m) const;
  /// What finishing would draw with the hand as last place, for the eye only; numbers are 0, and what has width 0 is a guide.
  [[nodiscard]] std::vector<LabelObject> coming(const Eigen::Vector2d& hand_in_enu_m,
                                                double reach_m) const;
  /// The next place, or what the tool does at a place: selects, picks, fills. The last one of a tool that takes so many, and
  /// the first one again of a ring, finish it.
  [[nodiscard]] Result<void> add_point(const Eigen::Vector2d& hand_in_enu_m,
                                       double reach_m,
                                       SelectHow how = SelectHow::kInstead);
  /// Along a border from the last place, which lies on it, to one under the hand. @errors kInvalidOptions: no border there.
  [[nodiscard]] Result<void> add_traced(const Eigen::Vector2d& hand_in_enu_m,
                                        double reach_m,
                                        bool takes_other_way,
                                        double beside_m = 0.0);
  [[nodiscard]] Result<void> finish();
  /// Drops the places, or else the selection, or else goes back to selecting. @returns whether there was anything.
  bool cancel();

  // Tools that look at the image (label_desk_image.cpp), which the caller has opened on the sheet's plane.
  /// To be called with the hand's place before such a tool is used, and as it moves; reads only where it must. Does nothing for
  /// other tools. @errors as ImageTool::look().
  [[nodiscard]] Result<void> look_at_image(const OverheadTiles& image,
                                           const Eigen::Vector2d& hand_in_enu_m);
  void look_away() { image_tool_.look_away(); }  ///< For another image.
  /// Of wand, superpixels and GrabCut: one stroke more. finish() makes the edit of what they have found.
  [[nodiscard]] Result<void> tell_image(const ImageStroke& stroke);
  [[nodiscard]] const ImageTool& image_tool() const { return image_tool_; }

  // What is selected (label_desk_select.cpp).
  [[nodiscard]] const LabelSelection& selection() const { return selection_; }
  [[nodiscard]] const std::vector<PickedVertex>& picked() const { return picked_; }
  /// @errors kInvalidOptions: there is no such object.
  [[nodiscard]] Result<void> select(std::span<const ObjectId> objects, SelectHow how);
  /// The top-most; again at the same place the one below it. Nothing there empties the selection unless it is added to.
  void select_at(const Eigen::Vector2d& point_in_enu_m, double reach_m, SelectHow how);
  void select_within(const PlaneBounds& box, SelectHow how);
  void select_all();
  void pick_at(const Eigen::Vector2d& point_in_enu_m, double reach_m, SelectHow how);
  void pick_within(const PlaneBounds& box, SelectHow how);  ///< Corners of what is selected.

  // Whole gestures (label_desk_gestures.cpp), which tools and scripts end in. What is drawn is selected.
  [[nodiscard]] Result<void> draw(const DrawnWith& with, Ring places);
  [[nodiscard]] Result<void> draw_street(const StreetProfile& profile, const Ring& centre_line);
  [[nodiscard]] Result<void> cut_hole(ObjectId object, Ring hole);
  [[nodiscard]] Result<void> stroke(const Ring& path, double radius_m, PaintValue value);
  [[nodiscard]] Result<void> fill(const Eigen::Vector2d& at_in_enu_m, PaintValue value);
  [[nodiscard]] Result<void> recode(ClassId from, ClassId to, const std::optional<Ring>& within);
  [[nodiscard]] Result<void> move_vertex(const VertexRef& vertex, const Eigen::Vector2d& to);
  [[nodiscard]] Result<void> add_vertex(const VertexRef& before, const Eigen::Vector2d& at);
  [[nodiscard]] Result<void> move_picked(const Eigen::Vector2d& by_m);
  [[nodiscard]] Result<void> remove_picked();
  [[nodiscard]] Result<void> paint_to_objects();
  /// Sets what the document knows beside what is drawn: images, offsets, marks. Empty text removes it.
  [[nodiscard]] Result<void> set_value(const std::string& key,
                                       const std::string& text,
                                       const std::string& title);
  /// Any other edit, as imports and checks make them. @errors as LabelSheet::commit().
  [[nodiscard]] Result<void> commit(const LabelEdit& edit);

  // Commands on what is selected (label_desk_commands.cpp). @errors kInvalidOptions where nothing is.
  [[nodiscard]] Result<void> move_selected(const Eigen::Vector2d& by_m);
  [[nodiscard]] Result<void> delete_selected();
  [[nodiscard]] Result<void> duplicate_selected(const Eigen::Vector2d& by_m);
  /// Of the first one that is selected: a parallel to the left, or around an area; negative: to the right, or inside.
  [[nodiscard]] Result<void> copy_beside(double by_m);
  [[nodiscard]] Result<std::string> copy() const;  ///< GeoJSON in enu, for the clipboard.
  [[nodiscard]] Result<void> paste(std::string_view text, const Eigen::Vector2d& by_m);
  [[nodiscard]] Result<void> set_class(ClassId id);
  [[nodiscard]] Result<void> set_width(double width_m);  ///< Of lines and outlines.
  [[nodiscard]] Result<void> set_note(const std::string& note);
  [[nodiscard]] Result<void> reorder(OrderMove move);
  [[nodiscard]] Result<void> smooth();
  [[nodiscard]] Result<void> simplify();       ///< By the tool's distance.
  [[nodiscard]] Result<void> orthogonalise();  ///< By the tool's angle.
  [[nodiscard]] Result<void> join_borders(double reach_m);
  [[nodiscard]] Result<void> merge();
  [[nodiscard]] Result<void> subtract();  ///< All others from the one that was selected first.
  [[nodiscard]] Result<void> clip(ClipSide side);
  /// Without selection: all areas that the line crosses.
  [[nodiscard]] Result<void> split(const Ring& line);
  [[nodiscard]] Result<void> objects_to_paint();

  /// What a place that is dragged would snap to; what is selected does not snap to itself.
  [[nodiscard]] std::optional<Snap> snap_dragged(const Eigen::Vector2d& point_in_enu_m,
                                                 double reach_m) const;
  /// What a drag would leave, for the eye only; empty where it cannot be.
  [[nodiscard]] std::vector<LabelObject> coming_move(const Eigen::Vector2d& by_m) const;
  [[nodiscard]] std::vector<LabelObject> coming_picked(const Eigen::Vector2d& by_m) const;
  [[nodiscard]] std::vector<LabelObject> coming_vertex(const VertexRef& vertex,
                                                       const Eigen::Vector2d& to) const;

 private:
  explicit LabelDesk(LabelSheet sheet) : sheet_(std::move(sheet)) {}
  enum class Chooses { kWhatWasMade, kAsBefore };
  [[nodiscard]] Result<void> take(const Result<LabelEdit>& edit, Chooses chooses);
  [[nodiscard]] Result<void> take_picked_along(const Result<LabelEdit>& edit);
  [[nodiscard]] Result<void> needs_selection() const;
  void follow_document();
  [[nodiscard]] SharedBorders shared() const;
  [[nodiscard]] Result<void> finish_ring(const Ring& places);
  [[nodiscard]] Result<const StreetProfile*> profile() const;
  [[nodiscard]] Result<void> add_scissored(const Eigen::Vector2d& hand_in_enu_m, double reach_m);
  [[nodiscard]] Ring coming_line(const ToolPoint& next) const;
  [[nodiscard]] Result<void> finish_found();
  [[nodiscard]] std::optional<ObjectId> object_for_hole(const Ring& hole) const;

  LabelSheet sheet_;
  LabelTool tool_;
  ToolPoints points_;
  ImageTool image_tool_;
  std::vector<StreetProfile> profiles_;
  LabelSelection selection_;
  std::vector<PickedVertex> picked_;
};

}  // namespace nadir
