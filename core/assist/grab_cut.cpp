// SPDX-License-Identifier: Apache-2.0
#include "core/assist/grab_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/label/cell_fill.h"

namespace nadir {
namespace {

/// Beyond it learning takes longer than a hand waits, and knows no more of the colours.
constexpr int kMostLearningSide = 160;
/// Pixels of the learning size on both sides of the cut that are decided again.
constexpr int kRedecided = 2;
constexpr std::uint64_t kSeed = 20041;

/// OpenCV draws from a generator of the thread; while this lives it begins where it always does.
class SameDraws {
 public:
  SameDraws() : before_(cv::theRNG()) { cv::theRNG() = cv::RNG(kSeed); }
  ~SameDraws() { cv::theRNG() = before_; }
  SameDraws(const SameDraws&) = delete;
  SameDraws& operator=(const SameDraws&) = delete;

 private:
  cv::RNG before_;
};

cv::Mat picture_of(const AssistWindow& window) {
  cv::Mat picture(window.height(), window.width(), CV_8UC3);
  for (int row = 0; row < window.height(); ++row) {
    for (int column = 0; column < window.width(); ++column) {
      const ImagePixel& pixel = window.pixels().at(column, row);
      picture.at<cv::Vec3b>(row, column) = {pixel.blue, pixel.green, pixel.red};
    }
  }
  return picture;
}

bool are_near(const std::vector<Ring>& rings) {
  for (const Ring& ring : rings) {
    for (const Eigen::Vector2d& place : ring) {
      if (!(place.cwiseAbs().maxCoeff() <= kMostObjectCoordinateM)) return false;
    }
  }
  return true;
}

Ring in_pixels(const AssistWindow& window, const Ring& in_enu_m) {
  Ring ring = in_enu_m;
  for (Eigen::Vector2d& place : ring) place = window.pixels_from_enu() * place;
  return ring;
}

void put_strokes(const AssistWindow& window,
                 const std::vector<Ring>& strokes,
                 double radius_px,
                 int value,
                 cv::Mat& marks) {
  const CellRect whole{0, 0, window.width(), window.height()};
  const TakeCells put = [&](std::int64_t row, std::int64_t from, std::int64_t to) {
    marks.row(static_cast<int>(row)).colRange(static_cast<int>(from), static_cast<int>(to)) = value;
  };
  for (const Ring& stroke : strokes) {
    if (stroke.empty()) continue;
    const Ring path = in_pixels(window, stroke);
    fill_stroke(path, false, radius_px, whole, put);
    for (const Eigen::Vector2d& end : {path.front(), path.back()}) {
      fill_stroke({end}, true, radius_px, whole, put);
    }
    fill_path(path, false, whole, put);  // So that the thinnest stroke marks something.
  }
}

/// What is certain of each pixel, and what is likely before anything was learnt.
cv::Mat marked(const AssistWindow& window, const GrabCutMarks& marks, double stroke_px) {
  cv::Mat known(window.height(), window.width(), CV_8U,
                cv::Scalar(marks.around.empty() ? cv::GC_PR_BGD : cv::GC_BGD));
  if (!marks.around.empty()) {
    const std::array<Ring, 1> around{in_pixels(window, marks.around)};
    fill_rings(
        around, {0, 0, window.width(), window.height()},
        [&](std::int64_t row, std::int64_t from, std::int64_t to) {
          known.row(static_cast<int>(row)).colRange(static_cast<int>(from), static_cast<int>(to)) =
              cv::GC_PR_FGD;
        });
  }
  put_strokes(window, marks.wanted, stroke_px, cv::GC_FGD, known);
  put_strokes(window, marks.unwanted, stroke_px, cv::GC_BGD, known);
  for (int row = 0; row < window.height(); ++row) {
    for (int column = 0; column < window.width(); ++column) {
      if (!window.is_seen(column, row)) known.at<std::uint8_t>(row, column) = cv::GC_BGD;
    }
  }
  return known;
}

/// The marks on fewer pixels: one is unwanted where all of its pixels are, and wanted where any is.
cv::Mat shrunk(const cv::Mat& known, const cv::Size& size) {
  struct Held {
    bool is_all_unwanted = true, is_wanted = false, may_be_wanted = false;
  };
  Raster<Held> held(size.width, size.height);
  for (int row = 0; row < known.rows; ++row) {
    for (int column = 0; column < known.cols; ++column) {
      const auto value = known.at<std::uint8_t>(row, column);
      Held& one = held.at(column * size.width / known.cols, row * size.height / known.rows);
      one.is_all_unwanted = one.is_all_unwanted && value == cv::GC_BGD;
      one.is_wanted = one.is_wanted || value == cv::GC_FGD;
      one.may_be_wanted = one.may_be_wanted || value == cv::GC_PR_FGD;
    }
  }
  cv::Mat small(size, CV_8U);
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      const Held& one = held.at(column, row);
      const int likely = one.may_be_wanted ? cv::GC_PR_FGD : cv::GC_PR_BGD;
      const int value = one.is_wanted ? cv::GC_FGD : one.is_all_unwanted ? cv::GC_BGD : likely;
      small.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(value);
    }
  }
  return small;
}

/// A few colours of what is marked so, evenly over its pixels.
std::vector<cv::Vec3f> samples_of(const cv::Mat& lab, const cv::Mat& known, int value) {
  constexpr std::size_t kMostSamples = 64;
  std::vector<cv::Vec3f> all;
  for (int row = 0; row < lab.rows; ++row) {
    for (int column = 0; column < lab.cols; ++column) {
      if (known.at<std::uint8_t>(row, column) == value)
        all.push_back(lab.at<cv::Vec3f>(row, column));
    }
  }
  if (all.size() <= kMostSamples) return all;
  std::vector<cv::Vec3f> some;
  some.reserve(kMostSamples);
  for (std::size_t i = 0; i < kMostSamples; ++i) some.push_back(all[i * all.size() / kMostSamples]);
  return some;
}

double nearest(const std::vector<cv::Vec3f>& samples, const cv::Vec3f& colour) {
  double least = std::numeric_limits<double>::max();
  for (const cv::Vec3f& sample : samples)
    least = std::min(least, cv::norm(sample - colour, cv::NORM_L2SQR));
  return least;
}

/// Where both sides have strokes, whatever is not certain begins on the side whose stroke has the nearer colour.
void guess_by_colour(const cv::Mat& picture, cv::Mat& known) {
  cv::Mat lab;
  picture.convertTo(lab, CV_32F, 1.0 / 255.0);
  cv::cvtColor(lab, lab, cv::COLOR_BGR2Lab);
  const auto wanted = samples_of(lab, known, cv::GC_FGD);
  const auto unwanted = samples_of(lab, known, cv::GC_BGD);
  if (wanted.empty() || unwanted.empty()) return;
  for (int row = 0; row < lab.rows; ++row) {
    for (int column = 0; column < lab.cols; ++column) {
      auto& value = known.at<std::uint8_t>(row, column);
      if (value == cv::GC_FGD || value == cv::GC_BGD) continue;
      const auto& colour = lab.at<cv::Vec3f>(row, column);
      value = nearest(wanted, colour) < nearest(unwanted, colour) ? cv::GC_PR_FGD : cv::GC_PR_BGD;
    }
  }
}

/// Both kinds of pixels must be there for colours to be learnt.
Result<void> has_both(const cv::Mat& known) {
  const int wanted = cv::countNonZero(known & 1);
  if (wanted == 0) {
    return fail(ErrorCode::kInvalidOptions, "the marks leave nothing that could be wanted");
  }
  if (wanted == known.rows * known.cols) {
    return fail(ErrorCode::kInvalidOptions, "the marks leave nothing that could be unwanted");
  }
  return {};
}

/// Certain but for what is near to the cut; strokes stay what they are.
cv::Mat redecided(const cv::Mat& cut, const cv::Mat& known, int reach) {
  cv::Mat wanted;
  cv::resize(cut & 1, wanted, known.size(), 0.0, 0.0, cv::INTER_NEAREST);
  const cv::Mat kernel = cv::getStructuringElement(cv::MORPH_RECT, {2 * reach + 1, 2 * reach + 1});
  cv::Mat inner, outer;
  cv::erode(wanted, inner, kernel);
  cv::dilate(wanted, outer, kernel);
  cv::Mat again(known.size(), CV_8U, cv::Scalar(cv::GC_BGD));
  again.setTo(cv::GC_PR_BGD, outer);
  again.setTo(cv::GC_PR_FGD, wanted);
  again.setTo(cv::GC_FGD, inner);
  again.setTo(cv::GC_FGD, known == cv::GC_FGD);
  again.setTo(cv::GC_BGD, known == cv::GC_BGD);
  return again;
}

Result<PixelMask> cut_out(const AssistWindow& window,
                          const GrabCutMarks& marks,
                          const GrabCutOptions& options,
                          const WorkContext& context) {
  const cv::Mat picture = picture_of(window);
  cv::Mat known = marked(window, marks, options.stroke_px);
  const double scale =
      std::min(1.0, static_cast<double>(kMostLearningSide) / std::max(picture.cols, picture.rows));
  const cv::Size size(std::max(1, static_cast<int>(picture.cols * scale)),
                      std::max(1, static_cast<int>(picture.rows * scale)));
  cv::Mat small, wanted_colours, unwanted_colours;
  cv::resize(picture, small, size, 0.0, 0.0, cv::INTER_AREA);
  cv::Mat cut = shrunk(known, size);
  if (marks.around.empty()) guess_by_colour(small, cut);
  if (const auto both = has_both(cut); !both) return forward_error(both);
  const SameDraws same;
  for (int i = 0; i < options.iterations; ++i) {
    if (context.is_stopped()) return fail(ErrorCode::kCancelled, "cutting out was cancelled");
    cv::grabCut(small, cut, {}, unwanted_colours, wanted_colours, 1,
                i == 0 ? cv::GC_INIT_WITH_MASK : cv::GC_EVAL);
    if (cv::countNonZero(cut & 1) == 0) break;  // Nothing to learn from.
  }
  if (context.is_stopped()) return fail(ErrorCode::kCancelled, "cutting out was cancelled");
  if (size != picture.size()) {
    const auto reach = static_cast<int>(std::ceil(kRedecided / scale));
    cut = redecided(cut, known, reach);
    const bool is_open = cv::countNonZero((cut == cv::GC_PR_BGD) | (cut == cv::GC_PR_FGD)) > 0;
    if (is_open) {
      cv::grabCut(picture, cut, {}, unwanted_colours, wanted_colours, 1, cv::GC_EVAL_FREEZE_MODEL);
    }
  }
  PixelMask mask(window.width(), window.height());
  for (int row = 0; row < mask.height(); ++row) {
    for (int column = 0; column < mask.width(); ++column) {
      mask.at(column, row) = cut.at<std::uint8_t>(row, column) & 1U;
    }
  }
  return mask;
}

}  // namespace

Result<PixelMask> grab_cut(const AssistWindow& window,
                           const GrabCutMarks& marks,
                           const GrabCutOptions& options,
                           const WorkContext& context) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  if (!are_near({marks.around}) || !are_near(marks.wanted) || !are_near(marks.unwanted)) {
    return fail(ErrorCode::kInvalidOptions,
                "a place of the marks is not within {:.0f} km of the map",
                kMostObjectCoordinateM / 1000.0);
  }
  try {
    return cut_out(window, marks, options, context);
  } catch (const cv::Exception& error) {
    return fail(ErrorCode::kInvalidOptions, "nothing can be cut out here ({})", error.err);
  }
}

}  // namespace nadir
