// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "app/gui/flight_scene.h"
#include "app/gui/ground_picture.h"
#include "app/gui/label_ground.h"
#include "app/gui/picture_textures.h"
#include "app/gui/undo_pace.h"
#include "app/gui/window_arrangement.h"
#include "core/session/ground_reconstruction.h"
#include "core/session/session.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/bookmark_overlay.h"
#include "widgets/panels/bookmarks_panel.h"
#include "widgets/panels/camera_panel.h"
#include "widgets/panels/command_palette.h"
#include "widgets/panels/export_box.h"
#include "widgets/panels/file_box.h"
#include "widgets/panels/label_side_panel.h"
#include "widgets/panels/label_tools_panel.h"
#include "widgets/panels/layers_panel.h"
#include "widgets/panels/log_panel.h"
#include "widgets/panels/map_view.h"
#include "widgets/panels/moment_inquiry.h"
#include "widgets/panels/moment_panel.h"
#include "widgets/panels/notices.h"
#include "widgets/panels/place_overlay.h"
#include "widgets/panels/preferences_panel.h"
#include "widgets/panels/runs_panel.h"
#include "widgets/panels/scene_panel.h"
#include "widgets/panels/settings_panel.h"
#include "widgets/panels/shortcut_sheet.h"
#include "widgets/panels/timeline.h"
#include "widgets/panels/topview_panel.h"
#include "widgets/panels/why_panel.h"

namespace nadir {

/// Everything in the window: arranges the panels, hands what they ask for to the session, and draws the grounds that lie
/// below the map's lines. The OpenGL context of the window must be current in frame() and when this goes.
class GuiWindow {
 public:
  explicit GuiWindow(Session& session);
  ~GuiWindow();
  GuiWindow(const GuiWindow&) = delete;
  GuiWindow& operator=(const GuiWindow&) = delete;

  /// Draws one frame and applies what was asked for in it. @param elapsed_s  Since the last one.
  void frame(kit::Ui& ui, double elapsed_s);
  /// Whether the very next frame would show more without anybody doing anything: tiles come in.
  [[nodiscard]] bool wants_more() const { return wants_more_; }
  /// Whether something is being computed that will be shown.
  [[nodiscard]] bool is_working() const;

 private:
  [[nodiscard]] bool is_empty() const;
  [[nodiscard]] WindowPlaces arrange(const kit::Ui& ui);
  void note_front(const Actions& asked);
  void draw_columns(kit::Ui& ui, const WindowPlaces& places, Actions& asked);
  void draw_left(kit::Ui& ui, Actions& asked);
  void draw_right(kit::Ui& ui, Actions& asked);
  void draw_middle(kit::Ui& ui, Actions& asked);
  // window_labels.cpp
  [[nodiscard]] bool draws_labels() const;
  void draw_label_columns(kit::Ui& ui, const WindowPlaces& places, Actions& asked);
  [[nodiscard]] kit::TextureId draw_label_ground(const MapGround& wanted, const kit::Ui& ui);

  void draw_splitters(kit::Ui& ui, const WindowPlaces& places, Actions& asked);
  void draw_overlays(kit::Ui& ui, Actions& asked);
  void follow_map();
  /// The error surface of this moment; null while it is not there.
  [[nodiscard]] std::shared_ptr<const MomentSurface> surface_now() const;
  [[nodiscard]] GroundPicture& ground_of(const MapGround& wanted);
  [[nodiscard]] kit::TextureId draw_ground(const MapGround& wanted, const kit::Ui& ui);
  [[nodiscard]] kit::TextureId draw_scene(const SceneWish& wanted, const kit::Ui& ui);
  /// Lets go of grounds and pictures that this frame does not show.
  void forget_unseen();
  /// Of pictures and tiles, in main memory and as textures.
  [[nodiscard]] std::size_t drawn_bytes() const;
  void complain_once(const Error& error);

  /// The ground of one pane of the map.
  struct PaneGround {
    std::unique_ptr<GroundPicture> picture;
    int run = 0;            ///< Number of the run that lies on it.
    bool is_drawn = false;  ///< In this frame.
  };

  Session& session_;
  PictureTextures textures_;
  MomentInquiry inquiry_;
  GroundReconstruction reconstruction_;
  std::filesystem::path map_path_;             ///< That grounds and scene are of.
  std::shared_ptr<const MapIndex> map_index_;  ///< Of it, when they were made last.
  bool can_map_be_drawn_ = true;               ///< False: it could not be opened, once.
  std::shared_ptr<TileBudget> tiles_ = std::make_shared<TileBudget>();
  std::array<PaneGround, 2> grounds_;  ///< Of the map, and of the second one of a split view.
  std::unique_ptr<LabelGround> label_ground_;
  std::filesystem::path labelled_path_;  ///< That it is of.
  std::unique_ptr<FlightScene> scene_;
  std::set<std::string> complaints_;  ///< About the map that is open.
  bool wants_more_ = false;
  UndoPace undo_pace_;
  WindowSide front_ = WindowSide::kRight;  ///< Column whose panel was asked for last.
  Panel shown_left_ = Panel::kLayers, shown_right_ = Panel::kMoment;
  // What the panels keep from frame to frame.
  PaletteState palette_;
  FileBoxState file_box_;
  ExportState export_;
  FolderReader box_folder_, export_folder_;  ///< What those two look into.
  ShortcutSheetState shortcuts_;
  PreferencesState preferences_;
  PlaceState place_;
  BookmarkNoteState bookmark_note_;
  NoticesState notices_;
  MapViewState map_;
  TimelineState timeline_;
  LabelSideState label_side_;
  LayersState layers_;
  RunsState runs_;
  BookmarksState bookmarks_;
  LogState log_;
  MomentPanelState moment_;
  WhyState why_;
  SettingsState settings_;
  CameraPanelState camera_;
  TopviewPanelState topview_;
  SceneState scene_state_;
};

}  // namespace nadir
