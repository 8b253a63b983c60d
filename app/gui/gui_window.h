// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "app/gui/flight_scene.h"
#include "app/gui/ground_picture.h"
#include "app/gui/picture_textures.h"
#include "core/session/ground_reconstruction.h"
#include "core/session/session.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/bookmark_overlay.h"
#include "widgets/panels/bookmarks_panel.h"
#include "widgets/panels/camera_panel.h"
#include "widgets/panels/command_palette.h"
#include "widgets/panels/layers_panel.h"
#include "widgets/panels/log_panel.h"
#include "widgets/panels/map_view.h"
#include "widgets/panels/moment_inquiry.h"
#include "widgets/panels/moment_panel.h"
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

  /// Draws one frame and applies what was asked for in it.
  void frame(kit::Ui& ui);
  /// Whether another frame would show more without anybody doing anything: tiles, computations.
  [[nodiscard]] bool wants_more() const;

 private:
  struct Places;
  [[nodiscard]] Places arrange(const kit::Ui& ui) const;
  void draw_columns(kit::Ui& ui, const Places& places, Actions& asked);
  void draw_left(kit::Ui& ui, Actions& asked);
  void draw_right(kit::Ui& ui, Actions& asked);
  void draw_middle(kit::Ui& ui, Actions& asked);
  void draw_splitters(kit::Ui& ui, const Places& places, Actions& asked);
  void draw_overlays(kit::Ui& ui, Actions& asked);
  void follow_map();
  [[nodiscard]] kit::TextureId draw_ground(const MapGround& wanted, const kit::Ui& ui);
  [[nodiscard]] kit::TextureId draw_scene(const SceneWish& wanted, const kit::Ui& ui);
  void complain_once(const Error& error);

  Session& session_;
  PictureTextures textures_;
  MomentInquiry inquiry_;
  GroundReconstruction reconstruction_;
  std::filesystem::path map_path_;                         ///< That grounds and scene are of.
  std::map<int, std::unique_ptr<GroundPicture>> grounds_;  ///< By the number of their run.
  std::unique_ptr<FlightScene> scene_;
  std::string last_complaint_;
  bool wants_more_ = false;
  // What the panels keep from frame to frame.
  PaletteState palette_;
  ShortcutSheetState shortcuts_;
  PreferencesState preferences_;
  PlaceState place_;
  BookmarkNoteState bookmark_note_;
  MapViewState map_;
  TimelineState timeline_;
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
