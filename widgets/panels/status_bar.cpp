// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/status_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/panels/panel_text.h"
#include "widgets/views/theme.h"

namespace nadir {
namespace {

constexpr double kGap = 20.0, kBarWidth = 72.0, kBarHeight = 4.0, kButtonSide = 28.0,
                 kMargin = 12.0, kTextHeight = 20.0;

/// A read-out of the bar, left out as a whole where there is no room.
struct StatusItem {
  std::string text;
  std::string hint;
};

[[nodiscard]] std::vector<StatusItem> place_items(const PlaceReadOut& place) {
  std::vector<StatusItem> items;
  items.push_back({fmt::format("E {:.2f}  N {:.2f}", place.east_m, place.north_m),
                   "Metres east and north of the map's origin"});
  if (!place.geodetic.empty()) items.push_back({place.geodetic, "Latitude and longitude, WGS 84"});
  if (!place.mgrs.empty()) items.push_back({place.mgrs, "Military grid reference, to a metre"});
  if (!place.utm.empty()) items.push_back({place.utm, "UTM zone, easting and northing in metres"});
  return items;
}

void draw_place(kit::Ui& ui, const PlaceReadOut& place, double room) {
  if (place.class_colour) ui.colour_dot(*place.class_colour);
  if (place.class_colour) ui.same_line(ui.px(6.0));
  ui.text(place.class_name);
  ui.hint({.text = "Class of the map under the pointer", .shortcut = {}});
  // Wide enough for the longest name of a class, so that numbers do not jump.
  double used = std::max(ui.px(132.0), ui.text_width(place.class_name) + ui.px(18.0));
  const double start =
      ui.px(132.0) - ui.text_width(place.class_name) - (place.class_colour ? ui.px(18.0) : 0.0);
  double gap = std::max(ui.px(kGap), start);
  for (const StatusItem& item : place_items(place)) {
    const double width = ui.text_width(item.text, kit::TextLook::kNumber);
    if (used + gap + width > room) return;
    ui.same_line(gap);
    ui.text(item.text, kit::TextLook::kNumber);
    ui.hint({.text = item.hint, .shortcut = {}});
    used += gap + width;
    gap = ui.px(kGap);
  }
}

[[nodiscard]] std::string job_words(const std::vector<JobStatus>& jobs) {
  const JobStatus& newest = jobs.back();
  std::string words = shortened(newest.title, 32);
  if (newest.left_s) words += " · " + left_text(*newest.left_s);
  if (jobs.size() > 1) words += fmt::format(" · {} more", jobs.size() - 1);
  return words;
}

[[nodiscard]] std::string percent_text(double fraction) {
  return fmt::format("{:3.0f} %", std::floor(100.0 * std::clamp(fraction, 0.0, 1.0)));
}

[[nodiscard]] std::string job_hint(const std::vector<JobStatus>& jobs) {
  std::string words;
  for (auto job = jobs.rbegin(); job != jobs.rend(); ++job) {
    words +=
        fmt::format("{}{}: {:.0f} %", words.empty() ? "" : "; ", job->title, 100.0 * job->fraction);
    if (!job->activity.empty()) words += fmt::format(", {}", job->activity);
  }
  return words;
}

/// Title, bar, share and a button that stops the newest job; as wide as job_width().
[[nodiscard]] bool draw_job(kit::Ui& ui, const std::vector<JobStatus>& jobs, double gap) {
  const JobStatus& newest = jobs.back();
  ui.same_line(gap);
  ui.text(job_words(jobs));
  ui.hint({.text = job_hint(jobs)});
  ui.same_line();
  const double side = ui.px(kButtonSide);
  (void)ui.area("Progress", {ui.px(kBarWidth), side});
  const auto bar = [&](double share, Rgba colour) {
    const double low = (side - ui.px(kBarHeight)) / 2.0, high = low + ui.px(kBarHeight);
    const double right = std::clamp(share, 0.0, 1.0) * ui.px(kBarWidth);
    const std::array<Eigen::Vector2d, 4> outline = {
        {{0.0, low}, {right, low}, {right, high}, {0.0, high}}};
    ui.canvas().fill(outline, colour);
  };
  bar(1.0, ui.theme().line);
  bar(newest.fraction, ui.theme().accent);
  ui.same_line();
  ui.text(percent_text(newest.fraction), kit::TextLook::kNumber);
  ui.same_line();
  return ui.icon_button("Cancel", kit::Icon::kClose, {.text = "Stop " + newest.title});
}

[[nodiscard]] double job_width(const kit::Ui& ui, const std::vector<JobStatus>& jobs, double gap) {
  if (jobs.empty()) return 0.0;
  return gap + ui.text_width(job_words(jobs)) + ui.px(kBarWidth) +
         ui.text_width(percent_text(0.0), kit::TextLook::kNumber) + ui.px(kButtonSide + 3.0 * 8.0);
}

}  // namespace

PlaceReadOut place_read_out(const OverheadMap& map, const Eigen::Vector2d& point_in_enu_m) {
  PlaceReadOut place;
  place.east_m = point_in_enu_m.x();
  place.north_m = point_in_enu_m.y();
  if (map.contains(point_in_enu_m)) {
    const ClassId id = map.class_at(point_in_enu_m);
    place.class_name = class_info(id).name;
    if (id != kUnclassified) place.class_colour = class_colour(id);
  } else {
    place.class_name = "outside of the map";
  }
  const Geodetic position = map.plane.geodetic_from_enu(point_in_enu_m);
  place.geodetic = geodetic_text(position);
  place.utm = utm_text(position);
  place.mgrs = mgrs_text(position);
  return place;
}

StatusBarModel status_bar_model(const Session& session,
                                const std::optional<Eigen::Vector2d>& cursor_in_enu_m) {
  StatusBarModel model;
  const OpenMap* const map = session.map();
  if (map == nullptr) {
    model.hint = "Nothing is open";
  } else if (!map->index) {
    model.hint = "The map is being read";
  } else if (cursor_in_enu_m) {
    model.place = place_read_out(map->index->map(), *cursor_in_enu_m);
  } else {
    model.hint = "Point at the map to read class and coordinates";
  }
  const OpenRun* const run = session.active_run();
  model.is_recording = run != nullptr && run->is_live;
  model.memory_used_bytes = session.memory_used_bytes();
  model.memory_megabytes = session.memory_budget_megabytes();
  model.jobs = session.jobs();
  return model;
}

Actions draw_status_bar(kit::Ui& ui, const StatusBarModel& model) {
  const auto scope = ui.scope("Status");
  Actions asked;
  const std::string saved = model.is_recording ? "recording" : "saved";
  const std::string memory = memory_text(model.memory_used_bytes);
  const double gap = ui.px(kGap);
  const double words = ui.text_width(saved) + gap + ui.text_width(memory, kit::TextLook::kNumber);
  const double job = job_width(ui, model.jobs, gap);
  const double margin = ui.px(kMargin);
  const kit::Rect bar = ui.room();
  const double height = ui.px(model.jobs.empty() ? kTextHeight : kButtonSide);
  const double bar_height = std::min(bar.height, ui.px(kStatusBarHeight));
  if (bar_height > height) ui.space((bar_height - height) / 2.0);
  ui.right_align(bar.width - margin);
  const double room = bar.width - 2.0 * margin - words - job - gap;
  if (model.place) {
    draw_place(ui, *model.place, room);
  } else {
    ui.cut_text(model.hint, kit::TextLook::kMuted, words + job + gap + margin);
  }
  ui.same_line();
  ui.right_align(words + job + margin);
  ui.text(saved, model.is_recording ? kit::TextLook::kAccent : kit::TextLook::kMuted);
  ui.hint({.text = model.is_recording ? "The run is being written, step by step"
                                      : "Everything is kept as you work; there is nothing to save",
           .shortcut = {}});
  ui.same_line(gap);
  ui.text(memory, kit::TextLook::kMutedNumber);
  ui.hint({.text = fmt::format("Memory for what is decoded of runs and flights, of at most {} MB",
                               model.memory_megabytes),
           .shortcut = {}});
  if (!model.jobs.empty() && draw_job(ui, model.jobs, gap)) {
    asked.emplace_back(actions::CancelJob{model.jobs.back().number});
  }
  return asked;
}

}  // namespace nadir
