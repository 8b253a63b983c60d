// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/film.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <optional>
#include <string>

#include "core/base/staged_output.h"
#include "widgets/figures/figure_run.h"

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

bool open_writer(cv::VideoWriter& writer, const std::string& file, double fps, cv::Size size) {
  for (const int codec :
       {cv::VideoWriter::fourcc('a', 'v', 'c', '1'), cv::VideoWriter::fourcc('m', 'p', '4', 'v')}) {
    if (writer.open(file, cv::CAP_FFMPEG, codec, fps, size)) return true;
  }
  return false;
}

/// OpenCV writes on without a word where the disk is full, so what is there is read again.
Result<void> check_film(const std::string& file,
                        const std::filesystem::path& named,
                        int frames,
                        cv::Size size) {
  const cv::VideoCapture film(file, cv::CAP_FFMPEG);
  const int found = film.isOpened() ? static_cast<int>(film.get(cv::CAP_PROP_FRAME_COUNT)) : 0;
  if (found != frames) {
    return fail(ErrorCode::kIo,
                "{}: only {} of {} frames could be written to the temporary folder {}; is it full?",
                named.string(), found, frames,
                std::filesystem::path(file).parent_path().parent_path().string());
  }
  const cv::Size written(static_cast<int>(film.get(cv::CAP_PROP_FRAME_WIDTH)),
                         static_cast<int>(film.get(cv::CAP_PROP_FRAME_HEIGHT)));
  if (written != size) {
    return fail(ErrorCode::kIo, "{}: was written with {} x {} pixels and not {} x {}",
                named.string(), written.width, written.height, size.width, size.height);
  }
  return {};
}

cv::Mat frame_of(Raster<Rgba>& pixels, cv::Size size) {
  const cv::Mat rgba(pixels.height(), pixels.width(), CV_8UC4, pixels.data());
  cv::Mat bgr;
  cv::cvtColor(rgba(cv::Rect({0, 0}, size)), bgr, cv::COLOR_RGBA2BGR);
  return bgr;
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
  const cv::Size size(context.format().width / 2 * 2, context.format().height / 2 * 2);
  try {
    cv::VideoWriter writer;
    if (size.width < 2 || size.height < 2 || !open_writer(writer, file, options.fps, size)) {
      return fail(ErrorCode::kUnsupported, "{}: this OpenCV cannot write MP4 of {} x {} pixels",
                  path.string(), size.width, size.height);
    }
    for (int i = 0; i < summary.frames; ++i) {
      if (work.is_stopped()) return fail(ErrorCode::kCancelled, "{}: was stopped", path.string());
      figure.show_at(std::min(from_s + i * step_s, to_s));
      auto pixels = draw_pixels(figure, context);
      if (!pixels) return forward_error(pixels);
      writer.write(frame_of(*pixels, size));
      work.report(static_cast<double>(i + 1) / summary.frames, "drawing the film");
    }
    writer.release();
    if (auto whole = check_film(file, path, summary.frames, size); !whole) {
      return forward_error(whole);
    }
  } catch (const cv::Exception& error) {
    return fail(ErrorCode::kIo, "{}: {}", path.string(), error.err);
  }
  std::error_code error;
  std::filesystem::copy_file(file, staged->path(),
                             std::filesystem::copy_options::overwrite_existing, error);
  if (error) return fail(ErrorCode::kIo, "{}: {}", path.string(), error.message());
  if (auto committed = staged->commit(); !committed) return forward_error(committed);
  return summary;
}

}  // namespace nadir
