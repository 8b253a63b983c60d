// SPDX-License-Identifier: Apache-2.0
#include "tests/app/gui/sure_actions.h"

#include <utility>

namespace nadir {

std::vector<SureAction> sure_actions(const std::string& run,
                                     const std::string& astray,
                                     const std::string& map) {
  using Lines = std::vector<std::string>;
  const Lines a_run = {"open " + run, "play off", "loop"};
  Lines two_runs = {"open " + astray};
  two_runs.insert(two_runs.end(), a_run.begin(), a_run.end());  // which is the active one
  const auto after = [](Lines lines, const Lines& more) {
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
  };
  const Lines a_change = {"theme dark", "theme light"};
  // Drawn on what is clear, from the beginning of the labels' history.
  const Lines labels = {"label " + map, "label-option tool select", "label-step 0",
                        "label-option snap false"};
  const std::string square = "draw-area building 20,20 30,20 30,30 20,30";
  const Lines an_area = after(labels, {square});
  const Lines a_begun_one =
      after(labels, {"label-option tool area", "point 20 20", "point 30 20", "point 30 30"});
  const Lines two_areas =
      after(an_area, {"draw-area building 28,20 40,20 40,30 28,30", "labels select-all"});
  return {
      {"open", {}, {"open " + run}},
      {"open-demo", {}, {"open-demo"}},
      {"close-run", a_run, {"close-run 1"}},
      {"save", {}, {"save"}},
      {"quit", {}, {"quit"}},
      {"seek", a_run, {"seek 1"}},
      {"moment", a_run, {"moment 1"}},
      {"step", a_run, {"step 1"}},
      {"go", a_run, {"go start"}},
      {"play", a_run, {"play on"}},
      {"speed", {}, {"speed 2"}},
      {"loop", a_run, {"loop 0.5 1.5"}},
      {"look", a_run, {"look 25 28 40"}},
      {"zoom", a_run, {"zoom 1.5"}},
      {"rotate", a_run, {"rotate 15"}},
      {"fit", a_run, {"fit flight"}},
      {"follow", a_run, {"follow on"}},
      {"up", a_run, {"up north"}},
      {"place", a_run, {"place 25 30"}},
      {"lay-at", a_run, {"lay-at truth"}},
      {"select-particle", after(a_run, {"seek 1"}), {"select-particle 5"}},
      {"measure", a_run, {"measure 25 30"}},
      {"tool", a_run, {"tool pan"}},
      {"layer", {}, {"layer labels on"}},
      {"layer-opacity", {}, {"layer-opacity labels 0.5"}},
      {"layer-colour", {}, {"layer-colour truth #12AB9F"}},
      {"layer-move", {}, {"layer-move truth 1"}},
      {"panel", {}, {"panel why on"}},
      {"splitter", {}, {"splitter left 300"}},
      {"map-only", {}, {"map-only off"}},
      {"split-view", two_runs, {"split-view on"}},
      {"save-layout", {}, {"save-layout sure"}},
      {"layout", {"save-layout sure"}, {"layout sure"}},
      {"theme", {}, {"theme light"}},
      {"scale", {}, {"scale 1"}},
      {"reduced-motion", {}, {"reduced-motion off"}},
      {"memory", {}, {"memory 64"}},
      {"strip", {}, {"strip nees on"}},
      {"strip-move", {}, {"strip-move nees 1"}},
      {"strip-height", {}, {"strip-height nees 60"}},
      {"show", {}, {"show none"}},
      {"run", a_run, {"run 1"}},
      {"show-run", a_run, {"show-run 1 on"}},
      {"divergence",
       {"paste-view \"version = 1\"", "open " + astray, "open " + run},
       {"divergence 1"}},
      {"option", {}, {"option seed 4"}},
      {"preset", {}, {"preset default"}},
      {"save-preset", {"preset default"}, {"save-preset sure.toml"}},
      {"rerun", after(a_run, {"preset run"}), {"rerun start"}},
      {"cancel", a_run, {"export-table sure.csv", "cancel"}},
      {"export", a_run, {"export sure.svg"}},
      {"export-table", a_run, {"export-table sure.csv"}},
      {"report", a_run, {"report sure-report"}},
      {"copy", {}, {"copy words"}},
      {"copy-view", {}, {"copy-view"}},
      {"paste-view", {}, {"paste-view \"version = 1\""}},
      {"bookmark", a_run, {"bookmark here"}},
      {"bookmark-note", after(a_run, {"bookmark here"}), {"bookmark-note 1 there"}},
      {"bookmark-remove", after(a_run, {"bookmark here"}), {"bookmark-remove 1"}},
      {"label", {}, {"label " + map}},
      {"close-labels", labels, {"close-labels"}},
      {"workspace", labels, {"workspace replay"}},
      {"label-tab", labels, {"label-tab history"}},
      {"borders", labels, {"borders on"}},
      {"label-opacity", labels, {"label-opacity labels 0.5"}},
      {"label-option", labels, {"label-option class curb"}},
      {"last-class", labels, {"last-class"}},
      {"point", labels, {"point 25 25"}},
      {"trace",
       after(an_area, {"label-option tool area", "label-option snap true", "point 20 20 0.5"}),
       {"trace 30 30 0.5 near"}},
      {"leg", labels, {"leg length 5"}},
      {"finish", a_begun_one, {"finish"}},
      {"cancel-tool", a_begun_one, {"cancel-tool"}},
      {"draw-area", labels, {square}},
      {"draw-line", labels, {"draw-line curb 0.5 20,20 30,20"}},
      {"draw-outline", labels, {"draw-outline building 0.3 20,20 30,20 30,30"}},
      {"draw-street", labels, {"draw-street \"residential street\" 10,25 40,25"}},
      {"cut-hole", an_area, {"cut-hole 0 22,22 24,22 24,24"}},
      {"stroke", labels, {"stroke curb 1 20,20 30,20"}},
      {"fill", labels, {"fill sidewalk 25 25"}},
      {"recode", an_area, {"recode building fence"}},
      {"select-labels", labels, {"select-labels"}},
      {"select-box", an_area, {"select-box 15 15 35 35"}},
      {"move-vertex", an_area, {"move-vertex 0 0 0 19 19"}},
      {"add-vertex", an_area, {"add-vertex 0 0 0 25 19"}},
      {"move-labels", an_area, {"move-labels 1 1"}},
      {"duplicate-labels", an_area, {"duplicate-labels 12 0"}},
      {"copy-beside", an_area, {"copy-beside 1"}},
      {"labels", two_areas, {"labels merge"}},
      {"set-label", an_area, {"set-label note here"}},
      {"join-borders", two_areas, {"join-borders 0.1"}},
      {"split-labels", an_area, {"split-labels 25,10 25,40"}},
      {"paste-labels",
       labels,
       {R"(paste-labels {"type":"FeatureCollection","frame":"enu","features":[{"type":"Feature","properties":)"
        R"({"kind":"area","class":"road","width_m":0,"note":""},"geometry":{"type":"Polygon","coordinates":)"
        R"([[[20,20],[30,20],[30,30]]]}}]})"}},
      {"label-step", an_area, {"label-step 0"}},
      {"export-labels", an_area, {"export-labels geojson sure-labels.geojson"}},
      {"import-labels",
       after(an_area, {"export-labels geojson sure-import.geojson"}),
       {"import-labels sure-import.geojson"}},
      {"save-labels-copy", an_area, {"save-labels-copy sure-copy.gpkg"}},
      {"dismiss", {}, {"dismiss"}},
      {"undo", a_change, {"undo"}},
      {"redo", after(a_change, {"undo"}), {"redo"}},
  };
}

}  // namespace nadir
