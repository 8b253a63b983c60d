// SPDX-License-Identifier: Apache-2.0
#include "core/session/export_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/session/map_parts.h"
#include "core/session/map_upward.h"
#include "core/session/session.h"
#include "core/session/typed_path.h"

namespace nadir {
namespace {

using Form = ExportKind::Form;

constexpr std::array<ExportKind, 17> kExportKinds = {{
    {"moment", "This moment", "Map with the way so far, camera and topview", RunsOfFigure::kOne,
     true},
    {"film", "Film", "This moment's figure as time goes on", RunsOfFigure::kOne, true, false,
     Form::kFilm},
    {"flight", "Whole flight", "Ways with ellipses, and errors over time", RunsOfFigure::kOne, true,
     true},
    {"trajectories", "Ways", "Truth, odometry and estimate on the picture", RunsOfFigure::kAll,
     true},
    {"compare", "Comparison", "Several runs on the picture, errors over time", RunsOfFigure::kAll,
     true, true},
    {"cdf", "Distribution of errors", "How often position and orientation are how wrong",
     RunsOfFigure::kAll, false, true},
    {"mse-bars", "Mean squared errors", "Odometry against estimate, a bar for each run",
     RunsOfFigure::kAll, false, true},
    {"consistency", "Consistency", "Is the filter as sure as it may be", RunsOfFigure::kOne, false,
     true},
    {"timing", "Computing time", "Time of updates, particles, sample size", RunsOfFigure::kOne},
    {"error-surface", "Error surface", "Cost of every pose around the estimate", RunsOfFigure::kOne,
     true},
    {"scene", "3D scene", "What the camera saw, laid on the picture", RunsOfFigure::kOne, true},
    {"reconstruction", "Reconstruction", "All topviews, at odometry and at estimate",
     RunsOfFigure::kOne, true},
    {"overhead-pair", "Picture and labels", "The map's overhead picture beside its labels",
     RunsOfFigure::kNone, true},
    {"labels", "Labels", "The map's labels with the names of their classes", RunsOfFigure::kNone,
     true},
    {"route", "Route", "Numbered waypoints on the overhead picture", RunsOfFigure::kNone, true},
    {"table", "Table", "Every step of the run, one line each", RunsOfFigure::kOne, false, false,
     Form::kTable},
    {"report", "Report", "A folder with all figures and tables", RunsOfFigure::kAll, false, false,
     Form::kReport},
}};

/// Whether it shows one instant.
bool is_of_a_moment(std::string_view name) {
  return name == "moment" || name == "error-surface" || name == "scene";
}

std::string seconds_text(double time_s) { return fmt::format("{:.1f} s", time_s); }

std::size_t count_of_shown(const Session& session) {
  const auto& looks = session.view().runs;
  return static_cast<std::size_t>(
      std::count_if(looks.begin(), looks.end(), [](const RunLook& look) { return look.is_shown; }));
}

/// "loop", "loop and 2 more runs", or the map.
std::string subject_of(const ExportKind& kind, const Session& session) {
  const OpenRun* const run = session.active_run();
  const OpenMap* const map = session.map();
  if (kind.runs == RunsOfFigure::kNone || run == nullptr) {
    return map != nullptr ? map->provenance.name : "nothing";
  }
  const std::size_t more =
      count_of_shown(session) - std::min<std::size_t>(1, count_of_shown(session));
  if (kind.runs != RunsOfFigure::kAll || more == 0) return run->name;
  return fmt::format("{} and {} more {}", run->name, more, more == 1 ? "run" : "runs");
}

bool is_turned(const MapLook& look) {
  const MapUpward up = MapUpward::of(look);
  return up.up == MapUp::kHeading || std::abs(std::remainder(up.compass_deg, 360.0)) > 1e-6;
}

/// Whether layers lie in another order than at first, or some that can be seen have colours that a user chose.
bool is_stacked_by_hand(const MapLook& look) {
  const auto has_own_colour = [&look](Layer layer) {
    return !is_ground_layer(layer) && is_in_sight(look, layer) && look.layer(layer).colour;
  };
  return look.order != default_map_look().order ||
         std::any_of(look.order.begin(), look.order.end(), has_own_colour);
}

}  // namespace

std::span<const ExportKind> export_kinds() { return kExportKinds; }

const ExportKind* export_kind(std::string_view name) {
  const auto* const found =
      std::find_if(kExportKinds.begin(), kExportKinds.end(),
                   [name](const ExportKind& kind) { return kind.name == name; });
  return found == kExportKinds.end() ? nullptr : found;
}

std::span<const std::string_view> export_endings(Form form) {
  static constexpr std::array<std::string_view, 3> kOfFigures = {".png", ".svg", ".pdf"};
  static constexpr std::array<std::string_view, 1> kOfFilms = {".mp4"}, kOfTables = {".csv"};
  switch (form) {
    case Form::kFigure:
      return kOfFigures;
    case Form::kFilm:
      return kOfFilms;
    case Form::kTable:
      return kOfTables;
    case Form::kReport:
      break;
  }
  return {};
}

std::string why_no_export(const ExportKind& kind, const Session& session) {
  const OpenRun* const run = session.active_run();
  if (kind.runs != RunsOfFigure::kNone) {
    if (run == nullptr) return "open a run first";
    if (!run->document || run->document->steps.empty()) return "the run is still being read";
    if (kind.needs_truth && !run->document->has_truth()) return "this run has no truth";
    if (kind.name == "compare" && count_of_shown(session) < 2) return "show a second run first";
  }
  if (kind.needs_map && session.map() == nullptr) return "open a map first";
  return "";
}

std::string export_name(const ExportKind& kind, const Session& session) {
  const OpenRun* const run = session.active_run();
  const OpenMap* const map = session.map();
  const bool is_of_map = kind.runs == RunsOfFigure::kNone || run == nullptr;
  std::string name = is_of_map ? (map != nullptr ? map->provenance.name : "nadir") : run->name;
  name += "-" + std::string(kind.name);
  if (is_of_a_moment(kind.name)) name += fmt::format("-{:.1f}s", session.playback().time_s);
  return as_file_name(name);
}

std::vector<std::string> left_out_of_figure(const ExportKind& kind,
                                            const ViewState& view,
                                            const OpenRun* active) {
  std::vector<std::string> things;
  const MapLook& look = view.map;
  if (kind.name == "moment" || kind.form == ExportKind::Form::kFilm) {
    if (is_in_sight(look, Layer::kReconstruction)) things.emplace_back("the reconstruction");
    if (is_in_sight(look, Layer::kErrorSurface)) things.emplace_back("the error surface");
    std::size_t others = 0;
    for (std::size_t i = 0; i < view.runs.size(); ++i) {
      if (view.runs[i].is_shown && static_cast<int>(i) + 1 != view.active_run) ++others;
    }
    if (others > 0) things.push_back(fmt::format("{} other run{}", others, others == 1 ? "" : "s"));
    if (active != nullptr && !active->bookmarks.empty()) things.emplace_back("bookmarks");
    if (!look.measured_in_enu_m.empty()) things.emplace_back("what is measured");
  } else if (kind.needs_map && kind.form == ExportKind::Form::kFigure && kind.name != "scene") {
    if (is_turned(look)) things.emplace_back("the turn of the map");
    if (is_stacked_by_hand(look)) things.emplace_back("the order and colours of the layers");
  }
  return things;
}

std::string left_out_words(const ExportKind& kind, const ViewState& view, const OpenRun* active) {
  const std::vector<std::string> things = left_out_of_figure(kind, view, active);
  std::string words;
  for (std::size_t i = 0; i < things.size(); ++i) {
    const bool is_last = i + 1 == things.size();
    words += (i == 0 ? "" : is_last ? " and " : ", ") + things[i];
  }
  return words;
}

std::string left_out_sentence(const ExportKind& kind, const Session& session) {
  const std::string words = left_out_words(kind, session.view(), session.active_run());
  return words.empty() ? words : "Not in it: " + words + ".";
}

std::string export_sentence(const ExportKind& kind,
                            const Session& session,
                            const std::string& file,
                            const std::optional<int>& width_px) {
  const std::string of = subject_of(kind, session);
  const Playback& playback = session.playback();
  if (kind.form == Form::kTable) return fmt::format("Writes every step of {} into {}.", of, file);
  if (kind.form == Form::kReport) {
    return fmt::format(
        "Draws all figures of {} and writes them with their tables into the folder {}.", of, file);
  }
  const std::string size = width_px ? fmt::format(", {} pixels wide,", *width_px) : "";
  if (kind.form == Form::kFilm) {
    const std::string range =
        playback.loop_from_s && playback.loop_to_s
            ? fmt::format("from {} to {}", seconds_text(*playback.loop_from_s),
                          seconds_text(*playback.loop_to_s))
            : "from start to end";
    return fmt::format("Films {} {}{} at {:g} times the speed of the flight, into {}.", of, range,
                       size, playback.speed, file);
  }
  const std::string when =
      is_of_a_moment(kind.name) ? " at " + seconds_text(playback.time_s) : std::string();
  return fmt::format("Draws figure ‘{}’ of {}{}{} into {}.", kind.name, of, when, size, file);
}

Action export_action(const ExportKind& kind,
                     const std::string& file,
                     const std::optional<int>& width_px) {
  if (kind.form == Form::kTable) return actions::ExportTable{file};
  if (kind.form == Form::kReport) return actions::WriteReport{file};
  const bool is_film = kind.form == Form::kFilm;
  return actions::ExportFigure{file, std::string(is_film ? "moment" : kind.name), width_px};
}

}  // namespace nadir
