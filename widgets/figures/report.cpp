// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/report.h"

#include <array>
#include <optional>

#include "core/base/staged_output.h"
#include "core/eval/report.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/report_page.h"
#include "widgets/figures/run_lines.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIndexFile = "index.html";

/// Draws the figures of a report one after another with one OpenGL context.
class ReportPainter {
 public:
  ReportPainter(FigureSources& sources, fs::path folder, const WorkContext& work)
      : sources_(sources), folder_(std::move(folder)), work_(work) {}

  /// The bytes of each file by its ending. @errors as make_figure and Figure::draw.
  Result<std::vector<std::pair<std::string, std::string>>> draw(const PlannedFigure& planned) {
    const auto kind = figure_kind(planned.recipe.figure);
    if (!kind) return forward_error(kind);
    const auto figure = make_figure(planned.recipe, sources_, work_);
    if (!figure) return forward_error(figure);
    const auto facts = facts_of_recipe(planned.recipe, sources_, work_);
    if (!facts) return forward_error(facts);
    context_.set_format(page_format(planned.recipe.options, kind->aspect));
    std::vector<std::pair<std::string, std::string>> files;
    for (const auto& [file, ending] :
         {std::pair(PageFile::kPng, ".png"), std::pair(PageFile::kSvg, ".svg")}) {
      if (file == PageFile::kSvg && !planned.has_vectors) continue;
      auto bytes = draw_file(**figure, context_, file, *facts);
      if (!bytes) return forward_error(bytes);
      files.emplace_back(ending, std::move(*bytes));
    }
    return files;
  }

  /// Why this machine draws no maps, where a figure failed for that.
  [[nodiscard]] std::optional<std::string> no_graphics(const Error& fault) {
    if (fault.code != ErrorCode::kUnsupported) return std::nullopt;
    const auto renderer = context_.renderer();
    if (renderer) return std::nullopt;
    return renderer.error().message;
  }

  [[nodiscard]] Result<void> write(
      const PlannedFigure& planned,
      std::span<const std::pair<std::string, std::string>> files) const {
    for (const auto& [ending, bytes] : files) {
      auto written = write_text_file(folder_ / (planned.file + ending), bytes);
      if (!written) return written;
    }
    return {};
  }

 private:
  FigureSources& sources_;
  fs::path folder_;
  const WorkContext& work_;
  FigureContext context_{PageFormat{}};
};

Result<std::vector<FigureRun>> open_all(const ReportRequest& request,
                                        FigureSources& sources,
                                        const WorkContext& work) {
  std::vector<FigureRun> runs;
  for (const std::string& path : request.runs) {
    if (work.is_stopped()) return fail(ErrorCode::kCancelled, "the report was stopped");
    work.report(0.0, "reading " + path);
    auto run = sources.run(path, request.options);
    if (!run) return forward_error(run);
    runs.push_back(std::move(*run));
  }
  name_apart(runs);
  return runs;
}

}  // namespace

Result<ReportSummary> write_report(const ReportRequest& request,
                                   const fs::path& folder,
                                   const WorkContext& work) {
  auto staged = StagedOutput::folder(folder, kIndexFile);
  if (!staged) return forward_error(staged);
  FigureSources sources;
  const auto runs = open_all(request, sources, work);
  if (!runs) return forward_error(runs);
  ReportPlan plan = plan_report(request, *runs);
  ReportSummary summary;
  summary.left_out = std::move(plan.left_out);
  ReportPainter painter(sources, staged->path(), work);
  std::string blind, reason;  // figures that need OpenGL, and why there is none
  std::vector<PlannedFigure> drawn;
  for (std::size_t i = 0; i < plan.figures.size(); ++i) {
    const PlannedFigure& planned = plan.figures[i];
    if (work.is_stopped()) return fail(ErrorCode::kCancelled, "the report was stopped");
    work.report(static_cast<double>(i) / static_cast<double>(plan.figures.size()),
                "drawing " + planned.file);
    const auto files = painter.draw(planned);
    if (!files && files.error().code == ErrorCode::kCancelled) return forward_error(files);
    if (!files) {
      if (const auto why = painter.no_graphics(files.error())) {
        blind += (blind.empty() ? "" : ", ") + planned.file;
        reason = *why;
        continue;
      }
      summary.left_out.push_back(planned.file + ": " + files.error().message);
      continue;
    }
    if (auto written = painter.write(planned, *files); !written) return forward_error(written);
    drawn.push_back(planned);
  }
  summary.figures = static_cast<int>(drawn.size());
  std::vector<std::string> missing = summary.left_out;
  if (!blind.empty()) {
    summary.without_graphics = "no OpenGL for " + blind + ": " + reason;
    missing.push_back(summary.without_graphics);
  }
  std::vector<RunEvaluation> evaluations;
  for (const FigureRun& run : *runs) evaluations.push_back(run.evaluation);
  const std::string page = report_page({*runs, drawn, missing, request.options.theme});
  for (const auto& [name, text] :
       {std::pair<const char*, std::string>(kIndexFile, page),
        std::pair<const char*, std::string>("table.txt", report_as_text(evaluations))}) {
    if (auto written = write_text_file(staged->path() / name, text); !written) {
      return forward_error(written);
    }
  }
  if (auto committed = staged->commit(); !committed) {
    return forward_error(committed);
  }
  return summary;
}

}  // namespace nadir
