// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/stream_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/eval/series.h"
#include "widgets/panels/time_axis.h"

namespace nadir {
namespace {

/// @param gaps  As time_gaps(): indices that begin a new span.
StreamBar bar_of(std::string name,
                 const std::vector<double>& times,
                 const std::vector<std::size_t>& gaps) {
  StreamBar bar{std::move(name), times.size(), {}};
  if (times.empty()) return bar;
  double period_s = 0.0;
  if (times.size() > 1) {
    std::vector<double> periods;
    for (std::size_t i = 1; i < times.size(); ++i) periods.push_back(times[i] - times[i - 1]);
    period_s = lower_median(std::move(periods));
  }
  std::size_t begin = 0;
  for (std::size_t g = 0; g <= gaps.size(); ++g) {
    const std::size_t end = g < gaps.size() ? gaps[g] : times.size();
    const double next_s = end < times.size() ? times[end] : times.back() + period_s;
    bar.spans.push_back({times[begin], std::min(times[end - 1] + period_s, next_s)});
    begin = end;
  }
  return bar;
}

StreamBar bar_of(std::string name, const std::vector<double>& times) {
  return bar_of(std::move(name), times, time_gaps(times));
}

void add_flight(std::vector<StreamBar>& bars,
                const FlightDescription& flight,
                double start_clock_s) {
  std::vector<double> image, depth, labels;
  for (const FlightFrame& frame : flight.frames) {
    const double moment_s = frame.time_s - start_clock_s;
    if (frame.image) image.push_back(moment_s);
    if (frame.depth) depth.push_back(moment_s);
    if (frame.labels) labels.push_back(moment_s);
  }
  bars.push_back(bar_of("image", image));
  bars.push_back(bar_of("depth", depth));
  bars.push_back(bar_of("labels", labels));
}

}  // namespace

bool StreamBar::is_there(double moment_s) const {
  return std::any_of(spans.begin(), spans.end(), [moment_s](const TimeSpan& span) {
    return span.from_s <= moment_s && moment_s <= span.to_s;
  });
}

std::optional<TimeSpan> StreamBar::longest_gap() const {
  std::optional<TimeSpan> longest;
  for (std::size_t i = 1; i < spans.size(); ++i) {
    const TimeSpan gap{spans[i - 1].to_s, spans[i].from_s};
    if (!longest || gap.to_s - gap.from_s > longest->to_s - longest->from_s) longest = gap;
  }
  return longest;
}

std::vector<StreamBar> stream_bars(const TimelineModel& model) {
  std::vector<StreamBar> bars;
  const TimelineRun* const active = model.active();
  if (active == nullptr) return bars;
  const RunDocument& run = *active->document;
  if (model.flight != nullptr) add_flight(bars, model.flight->description(), run.start_clock_s);
  bars.push_back(bar_of("truth", run.errors.time_s, run.error_gaps));
  std::vector<double> seen;
  for (std::size_t i = 0; i < run.steps.size(); ++i) {
    if (run.steps[i].topview_cells > 0) seen.push_back(run.time_s[i]);
  }
  bars.push_back(bar_of("topview", seen));
  bars.push_back(bar_of("steps", run.time_s, run.gaps));
  return bars;
}

std::string stream_words(const StreamBar& stream) {
  if (stream.samples == 0) return stream.name + ": missing";
  std::string words = fmt::format("{}: {} {}", stream.name, stream.samples,
                                  stream.samples == 1 ? "sample" : "samples");
  const auto gap = stream.longest_gap();
  if (!gap) return words + ", no gaps";
  return words + fmt::format(", {} {}, the longest {:.1f} s at {}", stream.spans.size() - 1,
                             stream.spans.size() == 2 ? "gap" : "gaps", gap->to_s - gap->from_s,
                             clock_text(gap->from_s));
}

}  // namespace nadir
