// SPDX-License-Identifier: Apache-2.0
#include "app/cli/map_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace nadir::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string or_dash(const std::string& text) { return text.empty() ? "-" : text; }

Json json_of(const MapPlace& place) {
  return {{"name", place.name},
          {"east_m", place.point_in_enu_m.x()},
          {"north_m", place.point_in_enu_m.y()},
          {"latitude_deg", place.geodetic.latitude_deg},
          {"longitude_deg", place.geodetic.longitude_deg},
          {"utm", place.utm},
          {"mgrs", place.mgrs},
          {"is_on_map", place.is_on_map},
          {"class", class_info(place.class_id).name}};
}

std::string class_table_text(const MapSummary& summary) {
  const ClassStatistics& statistics = summary.statistics;
  std::string text =
      fmt::format("{:>3}  {:<15}{:>13}{:>10}{:>10}\n", "id", "class", "cells", "share", "alpha");
  for (int i = 0; i < kClassCount; ++i) {
    const auto id = static_cast<ClassId>(i);
    if (statistics.cells[id] == 0) continue;
    text +=
        fmt::format("{:>3}  {:<15}{:>13}{:>8.2f} %{:>10.4f}\n", i, class_info(id).name,
                    statistics.cells[id], 100.0 * statistics.share_of_all(id), summary.alpha[id]);
  }
  const std::int64_t rest = statistics.all_cells - statistics.classified_cells;
  const double share = statistics.all_cells > 0
                           ? static_cast<double>(rest) / static_cast<double>(statistics.all_cells)
                           : 0.0;
  text += fmt::format("{:>3}  {:<15}{:>13}{:>8.2f} %{:>10}\n", static_cast<int>(kUnclassified),
                      "unclassified", rest, 100.0 * share, "-");
  return text;
}

}  // namespace

std::string place_text(const MapPlace& place) {
  return fmt::format(
      "lat/lon      {}\nUTM          {}\nMGRS         {}\nenu          {:.3f} E {:.3f} N m\n"
      "class        {}\n",
      geodetic_text(place.geodetic), place.utm, place.mgrs, place.point_in_enu_m.x(),
      place.point_in_enu_m.y(),
      place.is_on_map ? std::string(class_info(place.class_id).name) : "outside the map");
}

std::string map_text(const MapSummary& summary, const std::optional<MapPlace>& asked) {
  const MapProvenance& provenance = summary.provenance;
  std::string text = fmt::format(
      "name         {}\nsource       {}\nlicence      {}\ndate         {}\n"
      "size         {} x {} cells, {:.2f} x {:.2f} m\nresolution   {:.6g} m per cell\n"
      "plane        transverse Mercator at {:.9f}, {:.9f}\n\n",
      or_dash(provenance.name), or_dash(provenance.source), or_dash(provenance.licence),
      or_dash(provenance.date), summary.width_cells, summary.height_cells, summary.width_m,
      summary.height_m, summary.metres_per_cell, summary.plane_origin.latitude_deg,
      summary.plane_origin.longitude_deg);
  for (const MapPlace& place : summary.places) {
    text += fmt::format("{:<18} {:<28} {:<28} {}\n", place.name, geodetic_text(place.geodetic),
                        place.utm, place.mgrs);
  }
  text += "\n" + class_table_text(summary);
  text += fmt::format(
      "alpha: weight of a class by {} (preset default; the thesis's presets use others), mean 1 "
      "over the classified cells\n",
      enum_name(summary.alpha_reading));
  if (asked) text += "\n" + place_text(*asked);
  return text;
}

std::string map_json(const std::string& path,
                     const MapSummary& summary,
                     const std::optional<MapPlace>& asked) {
  Json places = Json::array();
  for (const MapPlace& place : summary.places) places.push_back(json_of(place));
  Json classes = Json::array();
  for (int i = 0; i < kClassCount; ++i) {
    const auto id = static_cast<ClassId>(i);
    classes.push_back({{"id", i},
                       {"name", class_info(id).name},
                       {"cells", summary.statistics.cells[id]},
                       {"share_of_all", summary.statistics.share_of_all(id)},
                       {"share_of_classified", summary.statistics.share_of_classified(id)},
                       {"alpha", summary.alpha[id]}});
  }
  const Json json{{"map", path},
                  {"name", summary.provenance.name},
                  {"source", summary.provenance.source},
                  {"licence", summary.provenance.licence},
                  {"date", summary.provenance.date},
                  {"width_cells", summary.width_cells},
                  {"height_cells", summary.height_cells},
                  {"width_m", summary.width_m},
                  {"height_m", summary.height_m},
                  {"metres_per_cell", summary.metres_per_cell},
                  {"plane_latitude_deg", summary.plane_origin.latitude_deg},
                  {"plane_longitude_deg", summary.plane_origin.longitude_deg},
                  {"cells", summary.statistics.all_cells},
                  {"classified_cells", summary.statistics.classified_cells},
                  {"places", places},
                  {"classes", classes},
                  {"at", asked ? json_of(*asked) : Json(nullptr)}};
  // Names of files are bytes; what is no UTF-8 is replaced and not a reason to fail.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace nadir::cli
