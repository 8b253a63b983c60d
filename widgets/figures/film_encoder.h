// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "widgets/canvas/canvas.h"

namespace nadir {

/// What a film that was written holds, as found by reading it again.
struct EncodedFilm {
  int frames = 0, width = 0, height = 0;
};

/// Writes pictures as a film. It is made by a library of its own, which is loaded with the first film: what encodes films
/// drags a hundred further libraries along, and every start of the program would pay for them.
class FilmEncoder {
 public:
  FilmEncoder() = default;
  FilmEncoder(const FilmEncoder&) = delete;
  FilmEncoder& operator=(const FilmEncoder&) = delete;
  virtual ~FilmEncoder() = default;

  /// @param file    Ends in .mp4, which chooses the container.
  /// @param width   Of the frames in pixels, even, as the height.
  /// @errors kUnsupported: no encoder for such pictures, without the file's name.
  [[nodiscard]] virtual Result<void> begin(const std::string& file,
                                           double fps,
                                           int width,
                                           int height) = 0;
  /// @param picture  At least as large as the frames; what lies beyond them to the right and below is left out.
  [[nodiscard]] virtual Result<void> add(const Raster<Rgba>& picture) = 0;
  /// Closes the file and reads it again: encoders write on without a word where the disk is full.
  [[nodiscard]] virtual Result<EncodedFilm> finish() = 0;
};

/// @param library  Found where the program expects its own libraries: lib/nadir beside bin/, or lib of the build.
/// @errors kUnsupported: it is not there or is no such library; one sentence that names it.
[[nodiscard]] Result<std::unique_ptr<FilmEncoder>> load_film_encoder(
    const std::string& library = "libnadir_film.so");

}  // namespace nadir
