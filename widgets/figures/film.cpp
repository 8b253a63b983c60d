// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/film.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "core/base/staged_output.h"
#include "widgets/figures/figure_run.h"
#include "widgets/figures/film_encoder.h"

namespace nadir {
namespace {

/// A folder for the time of its life. OpenCV tells a film's container by its file's ending, so the staged name cannot be
/// written to directly.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "nadir-film-XXXXXX").string();
    if (!error && ::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Whether what was read again is what was written; on a full disk it is not.
Result<void> check_film(const EncodedFilm& found,
                        const EncodedFilm& written,
                        const std::filesystem::path& named,
                        const std::filesystem::path& folder) {
  if (found.frames != written.frames) {
    return fail(ErrorCode::kIo,
                "{}: only {} of {} frames could be written to the temporary folder {}; is it full?",
                named.string(), found.frames, written.frames, folder.string());
  }
  if (found.width != written.width || found.height != written.height) {
    return fail(ErrorCode::kIo, "{}: was written with {} x {} pixels and not {} x {}",
                named.string(), found.width, found.height, written.width, written.height);
  }
  return {};
}

}  // namespace

Result<FilmSummary> write_film(Figure& figure,
                               FigureContext& context,
                               const FilmOptions& options,
                               const std::filesystem::path& path,
                               const WorkContext& work) {
  const auto times = figure.times();
  if (!times) {
    return fail(ErrorCode::kUnsupported, "{}: this figure has no times, so it makes no film",
                path.string());
  }
  if (context.format().is_transparent) {
    return fail(ErrorCode::kInvalidOptions, "{}: a film has no transparency (--transparent)",
                path.string());
  }
  const double from_s = std::max(options.from_s, times->first_s);
  const double to_s = std::min(options.to_s, times->last_s);
  const double step_s = options.speed / options.fps;
  if (!(to_s >= from_s - kSameTimeS)) {
    return fail(ErrorCode::kInvalidOptions, "{}: no time between {:g} s and {:g} s", path.string(),
                options.from_s, options.to_s);
  }
  const double frames = std::floor((to_s - from_s + kSameTimeS) / step_s) + 1.0;
  if (!(frames <= kMostFilmFrames)) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: {:.0f} frames are more than {}; a lower --fps or a higher --speed makes fewer",
                path.string(), frames, kMostFilmFrames);
  }
  FilmSummary summary;
  summary.frames = static_cast<int>(frames);
  summary.length_s = summary.frames / options.fps;
  auto staged = StagedOutput::file(path);
  if (!staged) return forward_error(staged);
  const ScratchFolder scratch;
  if (scratch.path().empty()) {
    return fail(ErrorCode::kIo, "{}: there is no temporary folder to write it in", path.string());
  }
  const std::string file = (scratch.path() / "film.mp4").string();
  const EncodedFilm film{summary.frames, context.format().width / 2 * 2,
                         context.format().height / 2 * 2};
  auto encoder = load_film_encoder();
  if (!encoder) return forward_error(encoder, path.string());
  auto begun = (*encoder)->begin(file, options.fps, film.width, film.height);
  if (!begun) return forward_error(begun, path.string());
  for (int i = 0; i < summary.frames; ++i) {
    if (work.is_stopped()) return fail(ErrorCode::kCancelled, "{}: was stopped", path.string());
    figure.show_at(std::min(from_s + i * step_s, to_s));
    const auto pixels = draw_pixels(figure, context);
    if (!pixels) return forward_error(pixels);
    if (auto added = (*encoder)->add(*pixels); !added) return forward_error(added, path.string());
    work.report(static_cast<double>(i + 1) / summary.frames, "drawing the film");
  }
  const auto found = (*encoder)->finish();
  if (!found) return forward_error(found, path.string());
  if (auto whole = check_film(*found, film, path, scratch.path().parent_path()); !whole) {
    return forward_error(whole);
  }
  std::error_code error;
  std::filesystem::copy_file(file, staged->path(),
                             std::filesystem::copy_options::overwrite_existing, error);
  if (error) return fail(ErrorCode::kIo, "{}: {}", path.string(), error.message());
  if (auto committed = staged->commit(); !committed) return forward_error(committed);
  return summary;
}

}  // namespace nadir
