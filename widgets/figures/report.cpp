// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/hash.h"
#include "core/base/settings.h"
#include "core/base/staged_output.h"
#include "core/base/version.h"
#include "core/eval/report.h"
#include "widgets/canvas/printable.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIndexFile = "index.html";

Result<std::string> hash_of_file(const fs::path& path) {
  const auto bytes = read_text_file(path, std::numeric_limits<std::uintmax_t>::max());
  if (!bytes) return forward_error(bytes);
  return Hash().add(*bytes).text();
}

/// One figure of the report: what to draw and how its files are called.
struct Planned {
  FigureRecipe recipe;
  std::string file;  ///< Without ending.
  std::string caption;
  bool has_vectors = false;  ///< A chart, worth an SVG.
};

/// Seconds after the start of the largest position error, else of the end.
double worst_moment_s(const FigureRun& run) {
  double worst_s = run.elapsed_s(run.steps.back());
  double largest_m = -1.0;
  for (const RunStep& step : run.steps) {
    if (!step.truth_in_enu) continue;
    const double error_m =
        (step.estimate.moments.mean.translation_m() - step.truth_in_enu->translation_m()).norm();
    if (error_m > largest_m) {
      largest_m = error_m;
      worst_s = run.elapsed_s(step);
    }
  }
  return worst_s;
}

std::vector<Planned> plan(const ReportRequest& request, const std::vector<FigureRun>& runs) {
  std::vector<Planned> planned;
  const auto add = [&](std::string_view name, std::vector<std::string> files,
                       const std::string& tag, const std::string& words) -> Planned& {
    const auto kind = figure_kind(name);
    Planned figure;
    figure.recipe = {std::string(name), std::move(files), request.map, "", request.options};
    figure.file = std::string(name) + (tag.empty() ? "" : "-" + tag);
    figure.caption = words + (words.empty() ? "" : ": ") + std::string(kind->summary);
    figure.has_vectors = !kind->needs_map;
    planned.push_back(std::move(figure));
    return planned.back();
  };
  const std::vector<std::string>& all = request.runs;
  if (all.size() > 1) add("compare", all, "", "All runs");
  add("mse-bars", all, "", all.size() > 1 ? "All runs" : "");
  add("cdf", all, "", all.size() > 1 ? "All runs" : "");
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool is_alone = runs.size() == 1;
    // Two runs of one name in different folders must not share a file.
    const std::string tag = is_alone ? "" : fmt::format("{}-{}", i + 1, runs[i].name);
    const std::string words = is_alone ? "" : runs[i].name;
    for (const char* name : {"flight", "trajectories", "reconstruction", "consistency"}) {
      add(name, {all[i]}, tag, words);
    }
    const double worst_s = worst_moment_s(runs[i]);
    for (const char* name : {"moment", "error-surface"}) {
      Planned& figure = add(name, {all[i]}, tag, words);
      figure.recipe.options.time_s = worst_s;
      figure.caption += fmt::format(", {:.1f} s after the start{}", worst_s,
                                    runs[i].has_truth() ? ", where the error is largest" : "");
    }
  }
  for (const char* name : {"overhead-pair", "route", "labels"}) add(name, {all.front()}, "", "");
  return planned;
}

std::string page_head(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\">\n<title>{}</title>\n"
      "<style>\nbody {{ font: 15px/1.5 Inter, 'DejaVu Sans', sans-serif; margin: 2rem auto; "
      "max-width: 62rem; "
      "padding: 0 1rem; color: #1E2326; background: #FFFFFF }}\nh1 {{ font-size: 1.5rem }}\n"
      "figure {{ margin: 2rem 0; border-top: 1px solid #D9DDE0; padding-top: 1rem }}\n"
      "figcaption {{ color: #667078; margin-bottom: .5rem }}\nimg {{ width: 100%; height: auto }}\n"
      "pre {{ font: 13px/1.4 'JetBrains Mono', 'DejaVu Sans Mono', monospace; overflow-x: auto }}\n"
      "a {{ color: #0B6FB8 }}\n</style>\n</head>\n<body>\n<h1>{}</h1>\n",
      markup_text(title), markup_text(title));
}

std::string figure_html(const Planned& figure) {
  std::string text = fmt::format(
      "<figure id=\"{0}\">\n<figcaption>{1}{2}</figcaption>\n"
      "<a href=\"{0}.png\"><img src=\"{0}.png\" alt=\"{1}\"></a>\n</figure>\n",
      markup_text(figure.file), markup_text(figure.caption),
      figure.has_vectors ? fmt::format(" (<a href=\"{}.svg\">SVG</a>)", markup_text(figure.file))
                         : "");
  return text;
}

}  // namespace

Result<std::string> carried_recipe(const FigureRecipe& recipe) {
  std::string text =
      fmt::format("# Drawn by Nadir {}; 'nadir figure --recreate FILE' draws it again.\n{}",
                  kVersion, recipe_text(recipe));
  if (recipe.runs.empty()) return text;
  text += "\n# FNV-1a of each run as it was drawn.\n[inputs]\n";
  for (const std::string& run : recipe.runs) {
    const auto hash = hash_of_file(run);
    if (!hash) return forward_error(hash);
    text += toml_quoted(run) + " = " + toml_quoted(*hash) + "\n";
  }
  return text;
}

Result<std::string> draw_recipe(const FigureRecipe& recipe, PageFile kind) {
  const auto figure_known = figure_kind(recipe.figure);
  if (!figure_known) return forward_error(figure_known);
  auto figure = make_figure(recipe);
  if (!figure) return forward_error(figure);
  const auto text = carried_recipe(recipe);
  if (!text) return forward_error(text);
  FigureContext context(page_format(recipe.options, figure_known->aspect));
  return draw_file(**figure, context, kind,
                   {"Nadir: " + std::string(figure_known->summary), *text});
}

Result<ReportSummary> write_report(const ReportRequest& request,
                                   const fs::path& folder,
                                   const WorkContext& work) {
  std::vector<FigureRun> runs;
  std::vector<RunEvaluation> evaluations;
  for (const std::string& path : request.runs) {
    auto run = open_figure_run(path, request.options);
    if (!run) return forward_error(run);
    evaluations.push_back(run->evaluation);
    runs.push_back(std::move(*run));
  }
  ReportRequest placed = request;
  if (placed.map.empty()) {
    const auto map = find_map_of(runs.front());
    if (!map) return forward_error(map);
    placed.map = map->string();
  }
  auto staged = StagedOutput::folder(folder, kIndexFile);
  if (!staged) return forward_error(staged);
  const std::vector<Planned> planned = plan(placed, runs);
  ReportSummary summary;
  std::string page =
      page_head("Nadir report: " + runs.front().reader.header().flight +
                (runs.size() > 1 ? fmt::format(" and {} more", runs.size() - 1) : ""));
  const std::string table = report_as_text(evaluations);
  page += "<pre>" + markup_text(table) + "</pre>\n";
  for (std::size_t i = 0; i < planned.size(); ++i) {
    if (work.is_stopped()) return fail(ErrorCode::kCancelled, "the report was stopped");
    work.report(static_cast<double>(i) / static_cast<double>(planned.size()),
                "drawing " + planned[i].file);
    bool is_drawn = true;
    for (const PageFile kind : {PageFile::kPng, PageFile::kSvg}) {
      if (kind == PageFile::kSvg && !planned[i].has_vectors) continue;
      const auto bytes = draw_recipe(planned[i].recipe, kind);
      if (!bytes) {
        summary.left_out.push_back(planned[i].file + ": " + bytes.error().message);
        is_drawn = false;
        break;
      }
      const fs::path file =
          staged->path() / (planned[i].file + (kind == PageFile::kPng ? ".png" : ".svg"));
      if (auto written = write_text_file(file, *bytes); !written) return forward_error(written);
    }
    if (!is_drawn) continue;
    page += figure_html(planned[i]);
    ++summary.figures;
  }
  if (!summary.left_out.empty()) {
    page += "<h2>Left out</h2>\n<ul>\n";
    for (const std::string& words : summary.left_out)
      page += "<li>" + markup_text(words) + "</li>\n";
    page += "</ul>\n";
  }
  page += fmt::format(
      "<p>Drawn by Nadir {}. Every figure carries the recipe that draws it again "
      "(<code>nadir figure --recreate FILE</code>).</p>\n</body>\n</html>\n",
      kVersion);
  for (const auto& [name, text] : std::array<std::pair<const char*, const std::string*>, 2>{
           {{kIndexFile, &page}, {"table.txt", &table}}}) {
    if (auto written = write_text_file(staged->path() / name, *text); !written) {
      return forward_error(written);
    }
  }
  if (auto committed = staged->commit(); !committed) return forward_error(committed);
  return summary;
}

}  // namespace nadir
