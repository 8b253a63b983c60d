// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/assist/scissors.h"
#include "core/assist/superpixels.h"
#include "core/desk/label_tool.h"
#include "core/label/label_document.h"

namespace nadir {

/// What a hand has told a tool that looks at the image: a place, or a way that it was dragged along.
struct ImageStroke {
  Ring path_in_enu_m;
  bool takes_away = false;  ///< What is there is not wanted.
};

/// Wand, superpixels, GrabCut and scissors at work: what they look at, what they were told, what they have found. What was
/// found is always that of all strokes together, so that a stroke that is taken back leaves nothing. Commits nothing.
class ImageTool {
 public:
  /// Looks at an image around a place. While something has been told it keeps looking where it does; else it looks anew where
  /// the place is not in the inner half of the window, or was asked to look in another way. @errors as read_assist_window().
  [[nodiscard]] Result<void> look(const OverheadTiles& image,
                                  const Eigen::Vector2d& at_in_enu_m,
                                  const AssistWindowOptions& options);
  [[nodiscard]] const std::optional<AssistWindow>& window() const { return window_; }

  /// One stroke more. Wand: what hangs together with its first place. Superpixels: all along it. GrabCut: the first one goes
  /// from corner to opposite corner of a rectangle, further ones lie on what is wanted, or not.
  /// @errors kInvalidOptions: nothing is looked at; those of the tool. Then it is as before.
  [[nodiscard]] Result<void> tell(const LabelTool& tool, const ImageStroke& stroke);
  /// Finds again what was told, after the tool's fields have changed. @errors as tell().
  [[nodiscard]] Result<void> tell_again(const LabelTool& tool);
  [[nodiscard]] bool is_told() const { return !strokes_.empty(); }
  /// The last stroke. @pre is_told().
  void take_back(const LabelTool& tool);
  /// Forgets what it was told, and where the scissors began.
  void clear();
  /// Forgets the image too.
  void look_away();

  /// Around what was found, in enu, metres; inside is what an odd number of them surrounds.
  [[nodiscard]] const std::vector<Ring>& borders() const { return borders_; }
  /// Paints or draws what was found, as the tool says. @errors as cells_of() and draw_cells(); kInvalidOptions: none was.
  [[nodiscard]] Result<LabelEdit> edit(const LabelDocument& document, const LabelTool& tool) const;

  /// Fixes the beginning of the scissors' line; quick where it is already there. @errors as Scissors.
  [[nodiscard]] Result<void> begin_line(const Eigen::Vector2d& from_in_enu_m,
                                        const ScissorsOptions& options);
  /// From there along edges. @errors kInvalidOptions: no line was begun there; as Scissors.
  [[nodiscard]] Result<Ring> line(const Eigen::Vector2d& from_in_enu_m,
                                  const Eigen::Vector2d& to_in_enu_m) const;
  /// On an edge nearby, as Scissors; the place itself where nothing is looked at.
  [[nodiscard]] Eigen::Vector2d snapped(const Eigen::Vector2d& point_in_enu_m,
                                        const ScissorsOptions& options);

 private:
  struct Found {
    PixelMask mask;
    std::vector<Ring> borders;
  };
  [[nodiscard]] Result<Found> find(const LabelTool& tool, const std::vector<ImageStroke>& strokes);
  [[nodiscard]] Result<PixelMask> find_by_wand(const WandOptions& options,
                                               const std::vector<ImageStroke>& strokes) const;
  [[nodiscard]] Result<PixelMask> find_superpixels_along(const SuperpixelOptions& options,
                                                         const std::vector<ImageStroke>& strokes);
  [[nodiscard]] Result<PixelMask> find_by_cut(const GrabCutOptions& options,
                                              const std::vector<ImageStroke>& strokes) const;
  [[nodiscard]] Result<void> make_scissors(const ScissorsOptions& options);

  std::optional<AssistWindow> window_;
  AssistWindowOptions looks_so_;
  std::vector<ImageStroke> strokes_;
  PixelMask found_;
  std::vector<Ring> borders_;
  std::optional<Superpixels> superpixels_;  ///< Of the window, by superpixels_so_.
  SuperpixelOptions superpixels_so_;
  std::optional<Scissors> scissors_;  ///< Of the window, by scissors_so_.
  ScissorsOptions scissors_so_;
  std::optional<Eigen::Vector2d> line_begins_in_enu_m_;
};

}  // namespace nadir
