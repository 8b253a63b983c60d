// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/strip_gutter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "widgets/panels/run_labels.h"
#include "widgets/panels/timeline_parts.h"

namespace nadir {
namespace {

/// How many of the values fit beside each other, with room for "+2" where not all do.
std::size_t fitting_values(const std::vector<GutterValues::Value>& values,
                           const GutterRoom& room,
                           bool is_small) {
  const double swatch = values.size() > 1 ? room.swatch : 0.0;
  const auto width_until = [&](std::size_t count) {
    double width = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      width += (i > 0 ? room.gap : 0.0) + swatch + room.width_of(values[i].text, is_small);
    }
    if (count == values.size()) return width;
    return width + room.gap + room.width_of(fmt::format("+{}", values.size() - count), is_small);
  };
  std::size_t count = values.size();
  while (count > 1 && width_until(count) > room.width) --count;
  return count == 1 && width_until(1) > room.width && values.size() == 1 ? 0 : count;
}

}  // namespace

GutterValues gutter_values(Strip strip,
                           std::span<const TimelineRun> runs,
                           double moment_s,
                           const GutterRoom& room) {
  GutterValues made;
  for (const auto& [is_short, is_small] :
       {std::pair(false, false), std::pair(true, false), std::pair(true, true)}) {
    made.values.clear();
    made.is_small = is_small;
    for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
      made.values.push_back(
          {is_short ? short_strip_value(strip, *run, moment_s) : strip_value(strip, *run, moment_s),
           run->colour});
    }
    if (fitting_values(made.values, room, is_small) == made.values.size()) return made;
  }
  const std::size_t count = std::max<std::size_t>(1, fitting_values(made.values, room, true));
  if (made.values.size() <= count) return made;
  made.left_out = made.values.size() - count;
  made.values.resize(count);
  return made;
}

namespace detail {
namespace {

constexpr double kTextSize = 13.0, kSmallSize = 11.0, kTwoLines = 34.0;  // of the design
constexpr double kSwatchWidth = 4.0, kSwatchHeight = 10.0, kSwatchGap = 4.0, kValueGap = 9.0;
constexpr double kBeforeAxis = 14.0;  ///< Read-outs stay clear of the numbers of the axis.

TextStyle words_style(const kit::Ui& ui, FontFace face, double size, Rgba colour) {
  TextStyle style;
  style.face = face;
  style.size_px = ui.px(size);
  style.colour = colour;
  return style;
}

/// What the streams' strip says at the cursor.
std::string missing_words(const std::vector<StreamBar>& streams, double moment_s) {
  std::string missing;
  for (const StreamBar& stream : streams) {
    if (!stream.is_there(moment_s)) missing += (missing.empty() ? "no " : ", ") + stream.name;
  }
  return missing.empty() && !streams.empty() ? "all there" : missing;
}

/// Values from the left, each after a mark in its run's colour where there are several.
void draw_gutter_values(const TimelineFrame& frame,
                        Canvas& canvas,
                        Strip strip,
                        double left,
                        double right,
                        double baseline) {
  kit::Ui& ui = frame.ui;
  const auto style_of = [&ui](bool is_small) {
    return words_style(ui, FontFace::kNumbers, is_small ? kSmallSize : kTextSize, ui.theme().text);
  };
  GutterRoom room;
  room.width = right - left;
  room.swatch = ui.px(kSwatchWidth + kSwatchGap);
  room.gap = ui.px(kValueGap);
  room.width_of = [&](const std::string& text, bool is_small) {
    return measure_text(text, style_of(is_small)).width;
  };
  const GutterValues shown = gutter_values(strip, frame.model.runs, frame.model.time_s, room);
  const TextStyle style = style_of(shown.is_small);
  double x = left;
  for (const GutterValues::Value& value : shown.values) {
    if (frame.model.runs.size() > 1) {
      const double width = ui.px(kSwatchWidth), top = baseline + ui.px(kSwatchHeight);
      const std::array<Eigen::Vector2d, 4> swatch = {
          Eigen::Vector2d{x, baseline}, {x + width, baseline}, {x + width, top}, {x, top}};
      canvas.fill(swatch, frame.colour_of(value.colour));
      x += room.swatch;
    }
    canvas.text({std::floor(x), baseline}, value.text, style);
    x += measure_text(value.text, style).width + room.gap;
  }
  if (shown.left_out > 0) {
    TextStyle muted = style;
    muted.colour = ui.theme().muted;
    canvas.text({std::floor(x), baseline}, fmt::format("+{}", shown.left_out), muted);
  }
}

}  // namespace

void draw_gutter(const TimelineFrame& frame,
                 Canvas& canvas,
                 const kit::AreaInput& area,
                 Strip strip,
                 const StripPlot& plot) {
  kit::Ui& ui = frame.ui;
  const Theme& theme = ui.theme();
  const StripInfo& info = strip_info(strip);
  const double height = area.rect.height;
  const bool has_two_lines = height >= ui.px(kTwoLines);
  const bool has_ends = has_two_lines && strip != Strip::kStreams;
  const double left = ui.px(4.0);
  const double right = frame.axis.left_px - area.rect.left - ui.px(8.0);
  TextStyle small = words_style(ui, FontFace::kNumbers, kSmallSize, theme.muted);
  small.align = TextAlign::kRight;
  const std::string high = fmt::format("{:g}", plot.high), low = fmt::format("{:g}", plot.low);
  const auto before = [&](const std::string& end) {
    return has_ends ? right - measure_text(end, small).width - ui.px(kBeforeAxis) : right;
  };
  canvas.push_clip({0.0, 0.0, right + ui.px(2.0), height});
  const double name_y =
      std::floor(has_two_lines ? height / 2.0 + ui.px(4.0) : height / 2.0 - ui.px(5.0));
  const TextStyle name_style = words_style(ui, FontFace::kText, kTextSize, theme.text);
  const TextStyle unit_style = words_style(ui, FontFace::kText, kTextSize, theme.muted);
  const std::string unit(has_two_lines ? info.unit : "");
  const double unit_width = unit.empty() ? 0.0 : ui.px(6.0) + measure_text(unit, unit_style).width;
  const std::string name =
      fitted_name(std::string(info.name), before(high) - left - unit_width,
                  [&](const std::string& line) { return measure_text(line, name_style).width; });
  canvas.text({left, name_y}, name, name_style);
  if (!unit.empty()) {
    const double x = left + measure_text(name, name_style).width + ui.px(6.0);
    canvas.text({std::floor(x), name_y}, unit, unit_style);
  }
  const double value_y = std::floor(height / 2.0 - ui.px(14.0));
  if (has_two_lines && strip == Strip::kStreams) {
    const std::string words = missing_words(*frame.state.streams, frame.model.time_s);
    const Rgba colour = words == "all there" ? theme.muted : theme.warning;
    canvas.text({left, value_y}, words, words_style(ui, FontFace::kText, kTextSize, colour));
  }
  if (has_ends) {
    draw_gutter_values(frame, canvas, strip, left, before(low), value_y);
    canvas.text({right, std::floor(height - ui.px(11.0))}, high, small);
    canvas.text({right, std::floor(ui.px(3.0))}, low, small);
  }
  canvas.pop_clip();
}

}  // namespace detail
}  // namespace nadir
