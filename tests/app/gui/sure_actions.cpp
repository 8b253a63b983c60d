// SPDX-License-Identifier: Apache-2.0
#include "tests/app/gui/sure_actions.h"

#include <utility>

namespace nadir {

std::vector<SureAction> sure_actions(const std::string& run, const std::string& astray) {
  using Lines = std::vector<std::string>;
  const Lines a_run = {"open " + run, "play off", "loop"};
  Lines two_runs = {"open " + astray};
  two_runs.insert(two_runs.end(), a_run.begin(), a_run.end());  // which is the active one
  const auto after = [](Lines lines, const Lines& more) {
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
  };
  const Lines a_change = {"theme dark", "theme light"};
  return {
      {"open", {}, {"open " + run}},
      {"open-demo", {}, {"open-demo"}},
      {"close-run", a_run, {"close-run 1"}},
      {"save", {}, {"save"}},
      {"quit", {}, {"quit"}},
      {"seek", a_run, {"seek 1"}},
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
      {"dismiss", {}, {"dismiss"}},
      {"undo", a_change, {"undo"}},
      {"redo", after(a_change, {"undo"}), {"redo"}},
  };
}

}  // namespace nadir
