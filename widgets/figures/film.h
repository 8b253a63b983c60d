// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "widgets/figures/page.h"

namespace nadir {

struct FilmOptions {
  double fps = 25.0;                ///< Frames per second of film.
  double speed = 1.0;               ///< Flight seconds per second of film.
  double from_s = 0.0, to_s = 1e9;  ///< Cut to the figure's own times.
};

/// More than an hour at 25 a second; who asks for more has mistaken a unit.
inline constexpr int kMostFilmFrames = 100'000;

struct FilmSummary {
  int frames = 0;
  double length_s = 0.0;
};

/// Draws a figure that has times as an MP4 (H.264, else MPEG-4; 4:2:0, so sides are made even by cutting a pixel). Written
/// aside, read again and renamed, so that a film that is there is whole.
/// @errors kUnsupported: a figure without times, no encoder; kInvalidOptions: not a single frame or more than
/// kMostFilmFrames; kCancelled; kIo, a full disk among it; as Figure::draw.
[[nodiscard]] Result<FilmSummary> write_film(Figure& figure,
                                             FigureContext& context,
                                             const FilmOptions& options,
                                             const std::filesystem::path& path,
                                             const WorkContext& work);

}  // namespace nadir
