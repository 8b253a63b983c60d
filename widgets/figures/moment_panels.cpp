// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/moment_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>

#include "core/base/angle.h"
#include "core/flight/colour_image.h"
#include "core/mcl/map_patch.h"
#include "widgets/figures/flight_moments.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_on_map.h"
#include "widgets/views/agreement_view.h"
#include "widgets/views/raster_pictures.h"

namespace nadir {
namespace {

/// A picture with its caption, as large as it fits; a message in its place where there is none.
void draw_picture(Canvas& canvas,
                  const PageFormat& format,
                  PageRect panel,
                  const std::string& caption,
                  const std::optional<Raster<Rgba>>& picture) {
  if (!least_picture(format).fits_in(panel)) return;
  draw_caption(canvas, format, panel, caption);
  if (!picture) {
    draw_message(canvas, format, panel, "not known");
    return;
  }
  PageRect where = fitted(picture->width(), picture->height(), panel);
  where.bottom = panel.top() - where.height;  // right below its caption
  canvas.image(where, *picture);
  draw_frame(canvas, format, where);
}

using PatchCaptions = std::array<const char*, 4>;

/// In as many words as have room in so narrow a panel.
const PatchCaptions& captions_for(double width_px, const PageFormat& format) {
  static constexpr PatchCaptions kLong = {"(c) topview", "(d) agreement", "(e) map, estimate",
                                          "(f) map, truth"};
  static constexpr PatchCaptions kShort = {"(c) seen", "(d) fit", "(e) map", "(f) truth"};
  TextStyle style;
  style.size_px = 8.0 * format.px_per_pt();
  const bool fits = std::all_of(kLong.begin(), kLong.end(), [&](const char* caption) {
    return measure_text(caption, style).width <= width_px;
  });
  return fits ? kLong : kShort;
}

/// "62 %, 31 % and 2 more"
std::string masses_of(const std::vector<PoseMode>& modes) {
  constexpr std::size_t kMostNamed = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(modes.size(), kMostNamed); ++i) {
    text += fmt::format("{}{:.0f} %", i > 0 ? ", " : "", 100.0 * modes[i].mass);
  }
  if (modes.size() > kMostNamed) text += fmt::format(" and {} more", modes.size() - kMostNamed);
  return text;
}

}  // namespace

CameraPictures::CameraPictures(const FigureRun& run) {
  const auto path = find_flight_of(run);
  if (!path) {
    why_not_ = fmt::format("the flight {} is not there", run.reader->header().flight_path);
    return;
  }
  auto opened = open_flight(*path);
  if (opened) {
    flight_ = std::move(*opened);
  } else {
    why_not_ = opened.error().message;
  }
}

Result<const Raster<Rgba>*> CameraPictures::at(double time_s) {
  if (!flight_) return fail(ErrorCode::kNotFound, "no camera image: {}", why_not_);
  const auto has_image = [](const FlightFrame& frame) { return frame.image.has_value(); };
  const FlightDescription& flight = flight_->description();
  const FlightFrame* const nearest = nearest_frame(flight, time_s, has_image);
  if (nearest == nullptr) {
    return std::any_of(flight.frames.begin(), flight.frames.end(), has_image)
               ? fail(ErrorCode::kNotFound, "the flight holds no camera image of this moment")
               : fail(ErrorCode::kNotFound, "the flight holds no camera images");
  }
  if (shown_file_ != *nearest->image) {
    const auto read = read_colour_image(*nearest->image);
    if (!read) return forward_error(read);
    shown_ = colour_picture(*read);
    shown_file_ = *nearest->image;
  }
  return &shown_;
}

std::optional<MomentAgreement> moment_agreement(const RunStep& step, const OverheadMap& map) {
  if (!step.topview || step.topview->cells.empty()) return std::nullopt;
  if (unlike_cells(*step.topview, map)) return std::nullopt;
  MomentAgreement made{cell_agreement(*step.topview, map, step.estimate.moments.mean), {}};
  if (step.truth_in_enu) made.at_truth = cell_agreement(*step.topview, map, *step.truth_in_enu);
  return made;
}

void draw_patches(Canvas& canvas,
                  const PageFormat& format,
                  const PageRect& panel,
                  const RunStep& step,
                  const OverheadMap& map,
                  const std::optional<MomentAgreement>& agreement) {
  if (!agreement) {
    const auto unlike = step.topview ? unlike_cells(*step.topview, map) : std::nullopt;
    draw_message(
        canvas, format, panel,
        !step.topview ? "the run holds no topviews" : unlike.value_or("the topview has no cells"));
    return;
  }
  const TopviewRaster seen = topview_raster(*step.topview);
  const auto patch_at = [&](Source source) -> std::optional<Raster<Rgba>> {
    const auto pose = pose_of(step, source);
    if (!pose) return std::nullopt;
    return class_picture(map_patch(map, *pose, seen));
  };
  const auto parts =
      fitting_columns(panel, {1.0, 1.0, 1.0, 1.0}, 6.0 * format.px_per_pt(), least_picture(format));
  const PatchCaptions& captions = captions_for(parts[0].width, format);
  draw_picture(canvas, format, parts[0], captions[0], class_picture(seen.labels));
  draw_picture(canvas, format, parts[1], captions[1],
               agreement_picture(*step.topview, agreement->at_estimate, seen, format.colours()));
  draw_picture(canvas, format, parts[2], captions[2], patch_at(Source::kEstimate));
  draw_picture(canvas, format, parts[3], captions[3], patch_at(Source::kTruth));
}

std::optional<ChartSpec> agreement_bars(const MomentAgreement& agreement,
                                        const Theme& theme,
                                        Rgba estimate) {
  BarsSpec bars;
  bars.series.push_back({"at estimate", {}, estimate});
  if (agreement.at_truth) bars.series.push_back({"at truth", {}, theme.muted});
  const auto percent = [](const CellAgreement& cells, ClassId id) {
    const auto share = cells.of_class.at(id).share();
    return share ? 100.0 * *share : std::nan("");
  };
  const auto is_known = [](const CellAgreement& cells, ClassId id) {
    return cells.of_class.at(id).share().has_value();
  };
  for (ClassId id = 0; id < kClassCount; ++id) {
    const bool known_at_truth = agreement.at_truth && is_known(*agreement.at_truth, id);
    if (!is_known(agreement.at_estimate, id) && !known_at_truth) continue;
    bars.groups.emplace_back(class_info(id).name);
    bars.series[0].heights.push_back(percent(agreement.at_estimate, id));
    if (agreement.at_truth) bars.series[1].heights.push_back(percent(*agreement.at_truth, id));
  }
  if (bars.groups.empty()) return std::nullopt;
  ChartSpec spec;
  spec.y = {"agreeing [%]", 0.0, 100.0};
  spec.bars = std::move(bars);
  return spec;
}

std::vector<LegendEntry> patch_legend(const RunStep& step,
                                      const OverheadMap& map,
                                      const Theme& theme) {
  if (!step.topview || step.topview->cells.empty()) return {};
  const TopviewRaster seen = topview_raster(*step.topview);
  std::bitset<256> present;
  const auto add = [&present](const Raster<ClassId>& labels) {
    for (const ClassId id : labels.values()) present.set(id);
  };
  add(seen.labels);
  const bool has_patches = !unlike_cells(*step.topview, map).has_value();
  for (const Source source : {Source::kEstimate, Source::kTruth}) {
    const auto pose = pose_of(step, source);
    if (pose && has_patches) add(map_patch(map, *pose, seen));
  }
  std::vector<LegendEntry> entries;
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (!present.test(id)) continue;
    entries.push_back(legible_entry(
        {std::string(class_info(id).name), class_colour(id), LegendEntry::Kind::kBar}, theme));
  }
  return entries;
}

std::string belief_words(const RunStep& step) {
  const PoseMoments& moments = step.estimate.moments;
  std::string text;
  if (step.truth_in_enu && is_finite(moments.mean)) {
    text += fmt::format(", {:.2f} m from the truth",
                        (moments.mean.translation_m() - step.truth_in_enu->translation_m()).norm());
  }
  const double spread_m = std::sqrt(moments.covariance(0, 0) + moments.covariance(1, 1));
  const double spread_deg = Angle::radians(std::sqrt(moments.covariance(2, 2))).degrees();
  if (std::isfinite(spread_m) && std::isfinite(spread_deg)) {
    text += fmt::format(" · spread of the particles {:.2f} m and {:.1f} deg (standard deviations)",
                        spread_m, spread_deg);
  }
  const std::vector<PoseMode>& modes = step.estimate.modes;
  if (modes.size() == 1) text += " · 1 mode";
  if (modes.size() > 1) {
    text += fmt::format(" · {} modes with {} of the mass", modes.size(), masses_of(modes));
  }
  const double size = step.effective_sample_size;
  return text + (std::isfinite(size)
                     ? fmt::format(" · effective sample size {:.0f} of {} particles", size,
                                   step.particle_count)
                     : fmt::format(" · {} particles", step.particle_count));
}

}  // namespace nadir
