// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/status_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/panels/panel_text.h"
#include "widgets/panels/run_labels.h"
#include "widgets/views/theme.h"

namespace nadir {
namespace {

constexpr double kGap = 20.0, kBarWidth = 72.0, kBarHeight = 4.0, kButtonSide = 28.0,
                 kMargin = 12.0, kTextHeight = 20.0, kWarningGap = 6.0, kWarningIcon = 20.0;

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

/// What became of what is open, in a few words.
struct KeptWords {
  std::string text, hint;
  kit::TextLook look = kit::TextLook::kMuted;
};
[[nodiscard]] KeptWords kept_words(const StatusBarModel& model) {
  if (!model.saving_fault.empty()) {
    return {"not saved: try again",
            (model.keeps_session ? "What is open cannot be kept for the next start: "
                                 : "Preferences cannot be kept: ") +
                model.saving_fault,
            kit::TextLook::kWarning};
  }
  if (model.is_recording) {
    return {"recording", "The run is being written, step by step", kit::TextLook::kAccent};
  }
  if (!model.incomplete.empty()) {
    return {"incomplete run", model.incomplete, kit::TextLook::kWarning};
  }
  if (!model.keeps_session) {
    return {"not kept",
            "What is open now is not kept: the next start shows what was open before this window. "
            "Preferences, bookmarks and runs are written as you work"};
  }
  return {"saved", "Session and preferences are written as you work; there is nothing to save"};
}

[[nodiscard]] double kept_width(const kit::Ui& ui, const StatusBarModel& model) {
  const double icon = model.saving_fault.empty() ? 0.0 : ui.px(kWarningIcon + kWarningGap);
  return ui.text_width(kept_words(model).text) + icon;
}

void draw_kept(kit::Ui& ui, const StatusBarModel& model, Actions& asked) {
  const KeptWords words = kept_words(model);
  if (model.saving_fault.empty()) {
    ui.text(words.text, words.look);
    ui.hint({.text = words.hint});
    return;
  }
  ui.icon(kit::Icon::kWarning, words.look);
  ui.same_line(ui.px(kWarningGap));
  if (ui.link(words.text, {.text = words.hint})) asked.emplace_back(actions::SaveNow{});
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

/// The read-outs that a plane alone gives; the class is said by the caller.
PlaceReadOut place_on(const ProjectPlane& plane, const Eigen::Vector2d& point_in_enu_m) {
  PlaceReadOut place;
  place.east_m = point_in_enu_m.x();
  place.north_m = point_in_enu_m.y();
  const Geodetic position = plane.geodetic_from_enu(point_in_enu_m);
  place.geodetic = geodetic_text(position);
  place.utm = utm_text(position);
  place.mgrs = mgrs_text(position);
  return place;
}

/// Without a map there are the places of the run.
void say_run_without_map(const OpenRun& run,
                         const std::optional<Eigen::Vector2d>& cursor_in_enu_m,
                         StatusBarModel& model) {
  model.hint = fmt::format("{} is open, but no map: open one to see the ground", run.name);
  if (!run.document || !cursor_in_enu_m) return;
  const RunHeader& header = run.document->header;
  const auto plane = ProjectPlane::create({header.plane_latitude_deg, header.plane_longitude_deg});
  if (!plane) return;
  model.place = place_on(*plane, *cursor_in_enu_m);
  model.place->class_name = "no map is open";
}

}  // namespace

PlaceReadOut place_read_out(const OverheadMap& map, const Eigen::Vector2d& point_in_enu_m) {
  PlaceReadOut place = place_on(map.plane, point_in_enu_m);
  if (map.contains(point_in_enu_m)) {
    const ClassId id = map.class_at(point_in_enu_m);
    place.class_name = class_info(id).name;
    if (id != kUnclassified) place.class_colour = class_colour(id);
  } else {
    place.class_name = "outside of the map";
  }
  return place;
}

StatusBarModel status_bar_model(const Session& session,
                                const std::optional<Eigen::Vector2d>& cursor_in_enu_m) {
  StatusBarModel model;
  const OpenMap* const map = session.map();
  if (map == nullptr) {
    model.hint = session.view().flight_path.empty() ? "Nothing is open"
                                                    : "A flight is open, but not its map";
    if (const OpenRun* const open = session.active_run()) {
      say_run_without_map(*open, cursor_in_enu_m, model);
    }
  } else if (!map->index) {
    model.hint = "The map is being read";
  } else if (cursor_in_enu_m) {
    model.place = place_read_out(map->index->map(), *cursor_in_enu_m);
  } else {
    model.hint = "Point at the map to read class and coordinates";
  }
  const OpenRun* const run = session.active_run();
  model.is_recording = run != nullptr && run->is_live;
  if (run != nullptr && run->document && is_incomplete(*run->document, run->is_live)) {
    model.incomplete = run->name + " is incomplete: " + incomplete_words(*run->document);
  }
  model.memory_used_bytes = session.memory_used_bytes();
  model.memory_megabytes = session.memory_budget_megabytes();
  model.saving_fault = session.saving_fault();
  model.keeps_session = session.keeps_session();
  model.jobs = session.jobs();
  return model;
}

Actions draw_status_bar(kit::Ui& ui, const StatusBarModel& model) {
  const auto scope = ui.scope("Status");
  Actions asked;
  const std::string memory = memory_text(model.memory_used_bytes + model.drawn_bytes);
  const double gap = ui.px(kGap);
  const double words = kept_width(ui, model) + gap + ui.text_width(memory, kit::TextLook::kNumber);
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
  draw_kept(ui, model, asked);
  ui.same_line(gap);
  ui.text(memory, kit::TextLook::kMutedNumber);
  ui.hint({.text = fmt::format("Memory: {} for what is decoded of runs and flights, of at most "
                               "{} MB; {} for the map's tiles and other pictures",
                               memory_text(model.memory_used_bytes), model.memory_megabytes,
                               memory_text(model.drawn_bytes)),
           .shortcut = {}});
  if (!model.jobs.empty() && draw_job(ui, model.jobs, gap)) {
    asked.emplace_back(actions::CancelJob{model.jobs.back().number});
  }
  return asked;
}

}  // namespace nadir
