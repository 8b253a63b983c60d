// SPDX-License-Identifier: Apache-2.0
// The library that encodes films; nothing else of Nadir links OpenCV's videoio.
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "widgets/figures/film_encoder.h"

namespace nadir {
namespace {

class OpenCvEncoder final : public FilmEncoder {
 public:
  Result<void> begin(const std::string& file, double fps, int width, int height) override {
    file_ = file;
    size_ = cv::Size(width, height);
    const bool is_picture = width >= 2 && height >= 2;
    try {
      for (const int codec : {cv::VideoWriter::fourcc('a', 'v', 'c', '1'),
                              cv::VideoWriter::fourcc('m', 'p', '4', 'v')}) {
        if (is_picture && writer_.open(file_, cv::CAP_FFMPEG, codec, fps, size_)) return {};
      }
    } catch (const cv::Exception& error) {
      return fail(ErrorCode::kUnsupported, "{}", error.err);
    }
    return fail(ErrorCode::kUnsupported, "this OpenCV cannot write MP4 of {} x {} pixels", width,
                height);
  }

  Result<void> add(const Raster<Rgba>& picture) override {
    try {
      // A Mat never writes what it is only read from.
      const cv::Mat rgba(
          picture.height(), picture.width(), CV_8UC4,
          const_cast<Rgba*>(picture.data()));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
      cv::cvtColor(rgba(cv::Rect({0, 0}, size_)), bgr_, cv::COLOR_RGBA2BGR);
      writer_.write(bgr_);
    } catch (const cv::Exception& error) {
      return fail(ErrorCode::kIo, "{}", error.err);
    }
    return {};
  }

  Result<EncodedFilm> finish() override {
    try {
      writer_.release();
      const cv::VideoCapture film(file_, cv::CAP_FFMPEG);
      if (!film.isOpened()) return EncodedFilm{};
      const auto number = [&film](int property) { return static_cast<int>(film.get(property)); };
      return EncodedFilm{number(cv::CAP_PROP_FRAME_COUNT), number(cv::CAP_PROP_FRAME_WIDTH),
                         number(cv::CAP_PROP_FRAME_HEIGHT)};
    } catch (const cv::Exception& error) {
      return fail(ErrorCode::kIo, "{}", error.err);
    }
  }

 private:
  std::string file_;
  cv::Size size_;
  cv::Mat bgr_;
  cv::VideoWriter writer_;
};

}  // namespace
}  // namespace nadir

/// What load_film_encoder() calls; the encoder is the caller's.
extern "C" nadir::FilmEncoder* nadir_make_film_encoder() { return new nadir::OpenCvEncoder; }
